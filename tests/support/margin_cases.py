"""Rays, boxes and triangles about each other, as the tracer's queries take them: what the tests of margins share."""

import numpy as np
import warp as wp

from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.layout import LEAF_BYTES, NODE_BYTES, WIDTH

N = 4096
NODE_FLOATS, LEAF_FLOATS = NODE_BYTES // 4, LEAF_BYTES // 4


def launch(kernel, count, inputs, *outputs):
    wp.launch(kernel, dim=count, inputs=inputs, outputs=list(outputs), device="cpu")
    return [array.numpy() for array in outputs]


def bits(masks):
    return (masks[..., None] >> np.arange(WIDTH)) & 1 != 0


def on_cpu(array, dtype=wp.float32):
    return wp.array(np.ascontiguousarray(array, np.float32), dtype=dtype, device="cpu")


def unit(vectors):
    return (vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)).astype(np.float32)


def chunks(origins, directions):
    rows = np.zeros((len(origins), CHUNK_FLOATS), np.float32)
    rows[:, 0 : 3 * CHUNK : CHUNK] = origins
    rows[:, 3 * CHUNK : 6 * CHUNK : CHUNK] = directions
    rows[:, 5 * CHUNK + 1 : 5 * CHUNK + 16] = 1.0  # the other lanes that are prepared
    return on_cpu(rows)


def nodes(lower, upper):
    """(N, 16, 3) boxes, padded as `boxes.fill` does, all of them used."""
    rows = np.zeros((len(lower), 8, WIDTH), np.float32)
    rows[:, :3] = np.swapaxes(lower.astype(np.float32) - np.float32(PADDING), 1, 2)
    rows[:, 3:6] = np.swapaxes(upper.astype(np.float32) + np.float32(PADDING), 1, 2)
    rows[:, 6] = np.full(WIDTH, -1, np.int32).view(np.float32)
    return on_cpu(rows.reshape(len(lower), NODE_FLOATS))


def leaves(triangles):
    """(N, 16, 3, 3) float32 corners."""
    rows = np.zeros((len(triangles), 10, WIDTH), np.float32)
    rows[:, :9] = np.swapaxes(triangles.reshape(len(triangles), WIDTH, 9), 1, 2)
    rows[:, 9] = np.arange(WIDTH, dtype=np.int32).view(np.float32)
    return on_cpu(rows.reshape(len(triangles), LEAF_FLOATS))


def rays_into_the_scene(seed, along_axes=False):
    """Origins within 6 of 0 and directions to places within 1 of it, float32."""
    rng = np.random.default_rng(seed)
    origins = rng.uniform(-1.0, 1.0, (N, 3)) * rng.choice([0.01, 1.0, 6.0], (N, 1))
    ways = rng.uniform(-1.0, 1.0, (N, 3)) - origins
    if along_axes:  # nearly
        ways *= 10.0 ** rng.uniform(-9.0, 0.0, (N, 3))
    return rng, origins.astype(np.float32), unit(ways)


def places_on(rng, origins, ways, furthest=7.0):
    """(N, 16, 3) float64 places on the rays within 1 of 0, as far as there are; and which are."""
    t = furthest * 10.0 ** rng.uniform(-6.0, 0.0, (N, WIDTH, 1))
    places = origins[:, None].astype(np.float64) + t * ways[:, None]
    return places, (np.abs(places) <= 1.0).all(axis=2), t[..., 0]


def sideways(rng, ways):
    """Return (N, 16, 3) float64 unit vectors perpendicular to the rays."""
    across = np.cross(rng.normal(size=(N, WIDTH, 3)), ways[:, None].astype(np.float64))
    return across / np.linalg.norm(across, axis=2, keepdims=True)


def triangles_about(rng, places, ways, size, hit):
    """(N, 16, 3, 3) float32 triangles with each place well inside, on an edge or at a corner, or outside; every third flat.

    Flat is: nearly seen from the edge.
    """
    weights = rng.dirichlet([1.0, 1.0, 1.0], (N, WIDTH))
    weights[:, ::3, 0] = 0.0
    weights[:, ::6, 1] = 0.0
    weights /= weights.sum(axis=2, keepdims=True)
    if not hit:
        weights[..., 0] = -(10.0 ** rng.uniform(-2.0, 0.0, (N, WIDTH)))
        weights[..., 2] = 1.0 - weights[..., 0] - weights[..., 1]
    corners = size[..., None, None] * rng.normal(size=(N, WIDTH, 3, 3))
    along = (corners * ways[:, None, None]).sum(axis=3, keepdims=True) * ways[:, None, None]
    corners[:, 1::3] = (along + 1e-4 * (corners - along))[:, 1::3]
    middle = (weights[..., None] * corners).sum(axis=2, keepdims=True)
    return (places[:, :, None] + corners - middle).astype(np.float32)


def meets(origins, ways, triangles):
    """(distance or NaN, how clearly it is inside, not seen from the edge and no sliver) in long double."""
    o, d = (a[:, None].astype(np.longdouble) for a in (origins, ways))
    a, b, c = (triangles[:, :, k].astype(np.longdouble) - o for k in range(3))
    turns = np.stack([(np.cross(p, q) * d).sum(axis=2) for p, q in ((c, b), (a, c), (b, a))])
    n = np.cross(b - a, c - a)
    with np.errstate(all="ignore"):
        t = (n * a).sum(axis=2) / (n * d).sum(axis=2)
        clear = np.abs(turns).min(axis=0) / np.abs(turns).max(axis=0)
        clear *= np.abs((n * d).sum(axis=2)) / (np.abs(b - a).max(axis=2) * np.abs(c - a).max(axis=2))
    inside = (turns >= 0).all(axis=0) | (turns <= 0).all(axis=0)
    return np.where(inside & (t > 0), t, np.nan), clear
