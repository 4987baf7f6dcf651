"""What rays cross, by brute force: in float64 where that is sure, else in exact fractions, with ties moved aside."""

from fractions import Fraction

import numpy as np

from warpsample.radiation.sun.direct_sun import _unit
from warpsample.tracing.scene import scene_of

_SURE = 1e-13  # of products of coordinates up to 4, some roundings of 1e-16 each
_PAIRS = 1 << 20  # of rays and faces that are looked at together


def _moved_aside(a, b):
    """The exact side of a line from a to b on which 0 is, after an infinitesimal step along x and a smaller one along y."""
    cross = a[0] * b[1] - a[1] * b[0]
    first = next((term for term in (cross, a[1] - b[1], b[0] - a[0]) if term != 0), 0)
    return (first > 0) - (first < 0)


def _exactly(corners, o, d, axes):
    """The exact sides of a triangle's edges."""
    x, y, z = axes
    seen = []
    for corner in corners:
        v = [Fraction(float(p)) - Fraction(float(q)) for p, q in zip(corner, o, strict=True)]
        w = [Fraction(float(p)) for p in d]
        seen.append((v[x] * w[z] - v[z] * w[x], v[y] * w[z] - v[z] * w[y]))
    return [_moved_aside(seen[i], seen[(i + 1) % 3]) for i in range(3)]


def in_scene(mesh, origins, directions):
    """Float32 origins and unit directions as the tracer has them."""
    scene = scene_of(mesh)
    return ((np.asarray(origins, np.float64) - scene.centre) * scene.scale).astype(np.float32), _unit(
        np.ascontiguousarray(directions)
    )


def crossings(mesh, origins, directions):
    """(rays, faces, distances) of all hits, by ray and then by face, and how many edges took fractions to decide."""
    o, d = in_scene(mesh, origins, directions)
    step = max(1, _PAIRS // len(mesh.faces))
    found = [_block(mesh, o[i : i + step], d[i : i + step], i) for i in range(0, len(o), step)]
    rays, faces, distances = (np.concatenate([part[k] for part in found]) for k in range(3))
    return rays, faces, distances, sum(part[3] for part in found)


def _block(mesh, o, d, first):
    scene = scene_of(mesh)
    corners = scene.vertices[mesh.faces].astype(np.float64)
    along = np.where(np.abs(d[:, 2]) > np.maximum(*np.abs(d[:, :2]).T), 2, np.where(np.abs(d[:, 1]) > np.abs(d[:, 0]), 1, 0))
    axes = np.stack([(along + 1) % 3, (along + 2) % 3, along], axis=1)
    ways, starts = (np.take_along_axis(array.astype(np.float64), axes, axis=1) for array in (d, o))
    seen = np.stack([corners[:, :, axes[:, k]] for k in range(3)], axis=-1) - starts  # (F, 3, R, 3)
    flat = seen[..., :2] * ways[:, 2:] - seen[..., 2:] * ways[:, :2]
    after = np.roll(flat, -1, axis=1)
    cross = flat[..., 0] * after[..., 1] - flat[..., 1] * after[..., 0]
    sides = np.sign(cross)
    unsure = np.abs(cross) < _SURE
    possible = ((sides >= 0) | unsure).all(axis=1) | ((sides <= 0) | unsure).all(axis=1)
    exact = 0
    for face, ray in np.argwhere(possible & unsure.any(axis=1)):
        exact += 1
        sides[face, :, ray] = _exactly(scene.vertices[mesh.faces[face]], o[ray], d[ray], axes[ray])
    inside = (np.abs(sides.sum(axis=1)) == 3).T
    rays, faces = np.nonzero(inside)
    a, b, c = (corners[faces, k] for k in range(3))
    normal = np.cross(b - a, c - a)
    with np.errstate(all="ignore"):
        t = ((normal * (a - o[rays])).sum(axis=1) / (normal * d[rays].astype(np.float64)).sum(axis=1)).astype(np.float32)
    ahead = (t > 0.0) & (t < np.inf)
    return first + rays[ahead], faces[ahead], t[ahead] / scene.scale, exact
