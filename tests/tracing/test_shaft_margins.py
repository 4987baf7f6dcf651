"""Margins of skipping: what is above a point's horizon, in its reach or in a shaft is never passed over, and little else."""

import numpy as np
import pytest
import warp as wp
from margin_cases import N, bits, launch, leaves, meets, nodes, on_cpu, places_on, triangles_about, unit

import warpsample as ws
from warpsample.estimate.strata import strata_of
from warpsample.tracing.sight.frontier import limit_of_boxes, triangles_above, visible_children
from warpsample.tracing.sight.point import HORIZON_MARGIN, SHAFT_FLOATS, ShadingPoint
from warpsample.tracing.sight.shafts import VECTORS_BYTES, aim_about, boxes_in, triangles_in
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.layout import LEAF_BYTES, NODE_BYTES, WIDTH

LOW = float(HORIZON_MARGIN)


@wp.kernel(enable_backward=False, module="unique")
def _above(
    nodes: wp.array2d[wp.float32],
    leaves: wp.array2d[wp.float32],
    origins: wp.array[wp.vec3],
    normals: wp.array[wp.vec3],
    low: wp.float32,
    reach: wp.float32,
    masks: wp.array2d[wp.int32],
):
    i = wp.tid()
    o = origins[i]
    n = normals[i]
    limit = wp.dot(n, o) - low
    seen, around = visible_children(nodes.ptr + wp.uint64(i) * wp.uint64(NODE_BYTES), o, n, limit_of_boxes(limit, n), reach)
    masks[i, 0] = seen
    masks[i, 1] = triangles_above(leaves.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES), n, limit)
    masks[i, 2] = around


@wp.kernel(enable_backward=False, module="unique")
def _in_shaft(
    nodes: wp.array2d[wp.float32],
    leaves: wp.array2d[wp.float32],
    vectors: wp.array2d[wp.float32],
    origins: wp.array[wp.vec3],
    normals: wp.array[wp.vec3],
    low: wp.float32,
    masks: wp.array2d[wp.int32],
):
    i = wp.tid()
    shaft = wp.zeros(shape=(SHAFT_FLOATS,), dtype=wp.float32)
    point = ShadingPoint()
    point.n = normals[i]
    point.o = origins[i]
    point.low = low
    point.shaft = shaft.ptr
    aim_about(vectors.ptr + wp.uint64(i) * VECTORS_BYTES, point)
    masks[i, 0] = boxes_in(nodes.ptr + wp.uint64(i) * wp.uint64(NODE_BYTES), shaft.ptr)
    masks[i, 1] = triangles_in(leaves.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES), shaft.ptr)


def lobes(seed, flat):
    """Origins and normals; with `flat` the scene is a slab, and some origins are far above it."""
    rng = np.random.default_rng(seed)
    origins = rng.uniform(-1.0, 1.0, (N, 3)) * ([1.0, 1.0, 5.0] if flat else 1.0)
    return rng, origins.astype(np.float32), unit(rng.normal(size=(N, 3)))


def frames(normals):
    """(N, 3, 3) float64 rows x, y, z of the frame about each normal (Duff2017)."""
    x, y, z = np.moveaxis(normals.astype(np.float64), 1, 0)
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    first = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=1)
    second = np.stack([b, sign + y * y * a, -y], axis=1)
    return np.stack([first, second, normals], axis=1)


def at_heights(rng, origins, normals, height):
    """(N, 16, 3, 3) float32 triangles within 1 of 0 whose highest corner is at about that height over the horizon."""
    corners = rng.uniform(-1.0, 1.0, (N, WIDTH, 3, 3))
    n = normals[:, None, None].astype(np.float64)
    above = ((corners - origins[:, None, None]) * n).sum(axis=3, keepdims=True)
    below = np.array([0.0, 0.3, 1.0])[None, None, :, None] * rng.uniform(0.0, 0.1, (N, WIDTH, 1, 1))
    return (corners + (height - below - above) * n).astype(np.float32)


def true_heights(triangles, origins, normals):
    o, n = (a[:, None, None].astype(np.float64) for a in (origins, normals))
    return ((triangles - o) * n).sum(axis=3).max(axis=2)


@pytest.mark.parametrize("flat", [False, True])
def test_what_rises_above_the_horizon_is_seen_and_what_is_clearly_below_is_not(flat):
    rng, origins, normals = lobes(3, flat)
    largest = np.maximum(1.0, np.abs(origins)).max()
    low = LOW * 3.0**0.5 * largest
    for height, expected in ((2.0**-24, True), (low / 64.0, True), (-4.0 * low, False)):
        triangles = at_heights(rng, origins, normals, height)
        inside = (np.abs(triangles) <= 1.0).all(axis=(2, 3))
        points = triangles[:, :, 0].astype(np.float64)  # the highest corner
        boxes = nodes(points, points)
        inputs = [boxes, leaves(triangles), on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low, np.inf]
        masks = bits(launch(_above, N, inputs, wp.zeros((N, 3), wp.int32, device="cpu"))[0])
        heights = true_heights(triangles, origins, normals)
        sure = inside & ((heights >= 0.0) if expected else (heights <= -3.0 * low))
        assert sure.mean() >= 0.05
        assert (masks[:, 0] == expected)[sure].all()
        assert (masks[:, 1] == expected)[sure].all()


def test_what_is_out_of_reach_is_not_seen_and_what_is_around_is_known():
    rng, origins, normals = lobes(4, False)
    ways = rng.normal(size=(N, WIDTH, 3))
    ways *= np.copysign(1.0, (ways * normals[:, None]).sum(axis=2, keepdims=True))
    ways /= np.linalg.norm(ways, axis=2, keepdims=True)
    triangles = np.zeros((N, WIDTH, 3, 3))
    for distance, seen, around in ((0.25, True, False), (0.5 + 4.0 * PADDING, False, False), (0.5 * PADDING, True, True)):
        places = origins[:, None] + distance * ways
        inputs = [nodes(places, places), leaves(triangles), on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), LOW, 0.5]
        masks = bits(launch(_above, N, inputs, wp.zeros((N, 3), wp.int32, device="cpu"))[0])
        if distance != 0.25 or seen:
            assert (masks[:, 0] == seen).all()
        assert (masks[:, 2] == around).all()


@pytest.mark.parametrize("count", [64, 256, 448, 4096, 16384])
def test_a_shaft_holds_what_its_rays_meet_and_not_what_is_clearly_beside_it(count):
    """Rays in the middle, on the edges and at the corners of a stratum meet boxes and triangles that are put on them."""
    strata = strata_of(count)
    rng, origins, normals = lobes(5, False)
    sector, band = rng.integers(0, strata.sectors, N), rng.integers(0, strata.bands, N)
    share = rng.choice([0.0, 0.5, 1.0 - 2.0**-22], (N, 2)) * [1.0, 1.0]
    last = 1.0 - 2.0**-24
    u = np.minimum(np.stack([(band + share[:, 0]) / strata.bands, (sector + share[:, 1]) / strata.sectors], axis=1), last)
    about = ws.CosineHemisphere("polar")
    local = about.sample(u.astype(np.float32)).astype(np.float64)
    frame = frames(normals)
    ways = unit((local[:, :, None] * frame).sum(axis=1))
    shafts = on_cpu(strata.shafts[sector, band + 1].reshape(N, -1))
    places, there, t = places_on(rng, origins, ways, furthest=3.0)
    size = t * rng.uniform(1e-3, 1.0, (N, WIDTH))
    triangles = triangles_about(rng, places, ways, size, hit=True)
    hits, clear = meets(origins, ways, triangles)
    there &= (np.abs(triangles) <= 1.0).all(axis=(2, 3)) & (t > 1e-5)
    low = LOW * 3.0**0.5
    inputs = [nodes(places, places), leaves(triangles), shafts, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low]
    masks = bits(launch(_in_shaft, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
    assert masks[:, 0][there].all()
    met = there & np.isfinite(hits) & (clear > 1e-6)
    assert met.mean() >= 0.05
    assert masks[:, 1][met].all()
    # Beside the shaft, by ten times its margins: across an edge of its sector, or under the horizon.
    n = normals[:, None].astype(np.float64)
    under = places - n * ((places - origins[:, None]) * n).sum(axis=2, keepdims=True) - 10.0 * low * n
    tiny = (under[:, :, None] + 1e-9 * rng.normal(size=(N, WIDTH, 3, 3))).astype(np.float32)
    inputs = [nodes(under, under), leaves(tiny), shafts, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low]
    masks = bits(launch(_in_shaft, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
    inside = (np.abs(under) <= 1.0).all(axis=2)
    assert not masks[:, 0][inside].any()
    assert not masks[:, 1][inside].any()
    if strata.sectors >= 4:
        turn = (sector + 0.5) / strata.sectors + 0.5  # opposite
        opposite = np.stack([np.cos(2.0 * np.pi * turn), np.sin(2.0 * np.pi * turn), np.full(N, 0.5)], axis=1)
        other = unit((opposite[:, :, None] * frame).sum(axis=1))
        places, there, t = places_on(rng, origins, other, furthest=3.0)
        there &= t > 2.0**-12  # the margin for boxes, of 2^-16, is an angle there
        tiny = (places[:, :, None] + 1e-9 * rng.normal(size=(N, WIDTH, 3, 3))).astype(np.float32)
        inputs = [nodes(places, places), leaves(tiny), shafts, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low]
        masks = bits(launch(_in_shaft, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
        assert not masks[:, 0][there].any()
        assert not masks[:, 1][there].any()


def test_a_shaft_holds_the_sheet_that_its_lowest_rays_meet():
    """Large triangles lie along the horizon, above the origin by less than the rounding of their corners."""
    strata = strata_of(448)
    rng, origins, normals = lobes(6, False)
    origins *= 0.25
    sector = rng.integers(0, strata.sectors, N)
    u = np.stack([np.full(N, 1.0 - 2.0**-23), (sector + 0.5) / strata.sectors], axis=1)
    frame = frames(normals)
    local = ws.CosineHemisphere("polar").sample(u.astype(np.float32)).astype(np.float64)
    ways = unit((local[:, :, None] * frame).sum(axis=1))
    places = origins[:, None] + 2.0**-13 * rng.uniform(0.01, 1.0, (N, WIDTH, 1)) * ways[:, None].astype(np.float64)
    turns = 2.0 * np.pi * (rng.uniform(size=(N, WIDTH, 1)) + np.arange(3) / 3.0)
    across = np.cos(turns)[..., None] * frame[:, None, None, 0] + np.sin(turns)[..., None] * frame[:, None, None, 1]
    triangles = (places[:, :, None] + 0.5 * across).astype(np.float32)
    hits, clear = meets(origins, ways, triangles)
    met = np.isfinite(hits) & (clear > 1e-6)
    assert met.mean() >= 0.3
    shafts = on_cpu(strata.shafts[sector, strata.bands].reshape(N, -1))
    inputs = [nodes(places, places), leaves(triangles), shafts, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), LOW]
    masks = bits(launch(_in_shaft, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
    assert masks[:, 1][met].all()
