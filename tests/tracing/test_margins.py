"""Margins: what is tested before the decision in float64 may spare work, never an answer; nor may it spare too little."""

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.estimate.cells import cells_of
from warpsample.estimate.job import aim
from warpsample.estimate.skipping.beams import boxes_in, triangles_in
from warpsample.estimate.skipping.frontier import HORIZON_MARGIN, triangles_above, visible
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.decision import triangle_distance
from warpsample.tracing.wide.intersect import boxes_met, triangles_near
from warpsample.tracing.wide.layout import BEAM_FLOATS, CHUNK, CHUNK_FLOATS, LEAF_BYTES, NODE_BYTES, WIDTH
from warpsample.tracing.wide.prepare import prepare_wide, ray_in

N = 4096
NODE_FLOATS, LEAF_FLOATS = NODE_BYTES // 4, LEAF_BYTES // 4
LOW = float(HORIZON_MARGIN)


@wp.kernel(enable_backward=False, module="unique")
def _boxes_met(nodes: wp.array2d[wp.float32], chunks: wp.array2d[wp.float32], reach: wp.float32, masks: wp.array[wp.int32]):
    i = wp.tid()
    chunk = chunks.ptr + wp.uint64(i) * wp.uint64(4 * CHUNK_FLOATS)
    prepare_wide(chunk, 16)
    mask, _ = boxes_met(nodes.ptr + wp.uint64(i) * wp.uint64(NODE_BYTES), ray_in(chunk), reach, 0)
    masks[i] = mask


@wp.kernel(enable_backward=False, module="unique")
def _triangles(
    leaves: wp.array2d[wp.float32],
    chunks: wp.array2d[wp.float32],
    sizes: wp.array2d[wp.float32],
    near: wp.array2d[wp.int32],
    distances: wp.array2d[wp.float32],
):
    i = wp.tid()
    chunk = chunks.ptr + wp.uint64(i) * wp.uint64(4 * CHUNK_FLOATS)
    leaf = leaves.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES)
    prepare_wide(chunk, 16)
    ray = ray_in(chunk)
    masks = triangles_near(leaf, ray, sizes[i, 1], sizes[i, 0])
    near[i, 0] = masks & 0xFFFF
    near[i, 1] = masks >> WIDTH
    for k in range(WIDTH):
        distances[i, k] = triangle_distance(leaf, k, 0, ray, chunk, sizes[i, 1])


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
    padding = wp.static(PADDING) * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))
    seen, around = visible(nodes.ptr + wp.uint64(i) * wp.uint64(NODE_BYTES), o, n, limit + padding, reach)
    masks[i, 0] = seen
    masks[i, 1] = triangles_above(leaves.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES), n, limit)
    masks[i, 2] = around


@wp.kernel(enable_backward=False, module="unique")
def _in_beam(
    nodes: wp.array2d[wp.float32],
    leaves: wp.array2d[wp.float32],
    beams: wp.array2d[wp.float32],
    origins: wp.array[wp.vec3],
    normals: wp.array[wp.vec3],
    low: wp.float32,
    masks: wp.array2d[wp.int32],
):
    i = wp.tid()
    beam = wp.zeros(shape=(BEAM_FLOATS,), dtype=wp.float32)
    aim(beams.ptr + wp.uint64(i) * wp.uint64(12 * WIDTH), normals[i], origins[i], low, beam.ptr)
    masks[i, 0] = boxes_in(nodes.ptr + wp.uint64(i) * wp.uint64(NODE_BYTES), beam.ptr)
    masks[i, 1] = triangles_in(leaves.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES), beam.ptr)


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


def beside(rng, ways):
    """(N, 16, 3) float64 unit vectors across the rays."""
    across = np.cross(rng.normal(size=(N, WIDTH, 3)), ways[:, None].astype(np.float64))
    return across / np.linalg.norm(across, axis=2, keepdims=True)


@pytest.mark.parametrize("along_axes", [False, True])
def test_a_ray_meets_the_boxes_of_all_places_on_it_and_none_far_beside_it(along_axes):
    rng, origins, ways = rays_into_the_scene(1, along_axes)
    places, there, t = places_on(rng, origins, ways)
    found = bits(
        launch(_boxes_met, N, [nodes(places, places), chunks(origins, ways), np.inf], wp.zeros(N, wp.int32, device="cpu"))[0]
    )
    assert found[there].all()
    aside = places + 4.0 * PADDING * beside(rng, ways)  # a padded box reaches no farther than sqrt(3) of its padding
    found = bits(
        launch(_boxes_met, N, [nodes(aside, aside), chunks(origins, ways), np.inf], wp.zeros(N, wp.int32, device="cpu"))[0]
    )
    assert not found[there].any()
    reach = 1.0
    found = bits(
        launch(_boxes_met, N, [nodes(places, places), chunks(origins, ways), reach], wp.zeros(N, wp.int32, device="cpu"))[0]
    )
    assert found[there & (t < reach)].all()
    # Along the ray, a padded box begins as far before its middle as the padding over the largest component, at least 0.57.
    assert found[there & (t > reach + 4.0 * PADDING)].sum() == 0


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


@pytest.mark.parametrize("hit", [True, False])
def test_triangles_are_met_as_in_long_double_and_seldom_looked_at_in_vain(hit):
    rng, origins, ways = rays_into_the_scene(2)
    places, _, t = places_on(rng, origins, ways, furthest=3.0)
    t[:, 2::5] = 10.0 ** rng.uniform(-9.0, -5.0, t[:, 2::5].shape) * rng.choice([-1.0, 1.0], t[:, 2::5].shape)  # at 0
    places = origins[:, None].astype(np.float64) + t[..., None] * ways[:, None]
    size = 10.0 ** rng.uniform(-4.0, 0.0, (N, 1)) * rng.uniform(0.1, 1.0, (N, WIDTH))
    triangles = triangles_about(rng, places, ways, size, hit)
    edge = np.ptp(triangles, axis=2).max(axis=(1, 2))
    far = np.abs(triangles - origins[:, None, None]).max(axis=(1, 2, 3))
    reach = np.where(rng.uniform(size=N) < 0.5, 2.0**60, far * rng.uniform(0.2, 1.0, N))
    reach[::3] = (t[:, 0] * (1.0 + 10.0 ** rng.uniform(-9.0, -5.0, N) * rng.choice([-1.0, 1.0], N)))[::3]  # that of a place
    inputs = [leaves(triangles), chunks(origins, ways), on_cpu(np.stack([edge, reach], axis=1))]
    outputs = wp.zeros((N, 2), wp.int32, device="cpu"), wp.zeros((N, WIDTH), wp.float32, device="cpu")
    near, distances = launch(_triangles, N, inputs, *outputs)
    near, known = bits(near[:, 0]), bits(near[:, 1])
    assert near[distances > 0.0].all()
    assert (distances[known] > 0.0).all()
    right, clear = meets(origins, ways, triangles)
    right = np.where(right < reach[:, None].astype(np.float32), right, np.nan)
    sure = (clear > 1e-8) & ~(np.abs(right / reach[:, None] - 1.0) <= 1e-6)
    assert np.array_equal(np.isfinite(right)[sure], (distances > 0.0)[sure])
    both = np.isfinite(right) & (distances > 0.0) & sure
    # float32 of what float64 makes of corners as far as an edge, all but seen from the edge where clear is small.
    error = 2.0**-23 * right[both] + 2.0**-48 * np.broadcast_to(edge[:, None], right.shape)[both] / clear[both]
    assert (np.abs(distances - right)[both] <= error).all()
    if hit:
        assert both.mean() >= 0.2
        assert known.sum() >= 0.1 * (distances > 0.0).sum()
    else:  # the margin is 2^-18 of far / edge: of those not flat that are large, up to a thousandth
        large = np.ptp(triangles, axis=2).max(axis=2) >= 0.03 * far[:, None]
        large[:, 1::3] = False
        assert large.mean() >= 0.1
        assert near[large].mean() <= 0.02


def lobes(seed, flat):
    """Origins and normals; with `flat` the scene is a slab, and origins are far above it too."""
    rng = np.random.default_rng(seed)
    origins = rng.uniform(-1.0, 1.0, (N, 3)) * ([1.0, 1.0, 5.0] if flat else 1.0)
    return rng, origins.astype(np.float32), unit(rng.normal(size=(N, 3)))


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
def test_a_beam_holds_what_its_rays_meet_and_not_what_is_clearly_beside_it(count):
    """Rays at the cell's middle, edges and corners, as the polar map sends them, against boxes and triangles on them."""
    cells = cells_of(count)
    rng, origins, normals = lobes(5, False)
    sector, band = rng.integers(0, cells.sectors, N), rng.integers(0, cells.bands, N)
    share = rng.choice([0.0, 0.5, 1.0 - 2.0**-22], (N, 2)) * [1.0, 1.0]
    last = 1.0 - 2.0**-24
    u = np.minimum(np.stack([(band + share[:, 0]) / cells.bands, (sector + share[:, 1]) / cells.sectors], axis=1), last)
    about = ws.CosineHemisphere("polar")
    local = about.sample(u.astype(np.float32)).astype(np.float64)
    frame = frames(normals)
    ways = unit((local[:, :, None] * frame).sum(axis=1))
    beams = on_cpu(cells.beams[sector, band + 1].reshape(N, -1))
    places, there, t = places_on(rng, origins, ways, furthest=3.0)
    size = t * rng.uniform(1e-3, 1.0, (N, WIDTH))
    triangles = triangles_about(rng, places, ways, size, hit=True)
    hits, clear = meets(origins, ways, triangles)
    there &= (np.abs(triangles) <= 1.0).all(axis=(2, 3)) & (t > 1e-5)
    low = LOW * 3.0**0.5
    inputs = [nodes(places, places), leaves(triangles), beams, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low]
    masks = bits(launch(_in_beam, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
    assert masks[:, 0][there].all()
    met = there & np.isfinite(hits) & (clear > 1e-6)
    assert met.mean() >= 0.05
    assert masks[:, 1][met].all()
    # Beside the beam, by ten times its margins: across an edge of its sector, or under the horizon.
    n = normals[:, None].astype(np.float64)
    under = places - n * ((places - origins[:, None]) * n).sum(axis=2, keepdims=True) - 10.0 * low * n
    tiny = (under[:, :, None] + 1e-9 * rng.normal(size=(N, WIDTH, 3, 3))).astype(np.float32)
    inputs = [nodes(under, under), leaves(tiny), beams, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low]
    masks = bits(launch(_in_beam, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
    inside = (np.abs(under) <= 1.0).all(axis=2)
    assert not masks[:, 0][inside].any()
    assert not masks[:, 1][inside].any()
    if cells.sectors >= 4:
        turn = (sector + 0.5) / cells.sectors + 0.5  # opposite
        opposite = np.stack([np.cos(2.0 * np.pi * turn), np.sin(2.0 * np.pi * turn), np.full(N, 0.5)], axis=1)
        other = unit((opposite[:, :, None] * frame).sum(axis=1))
        places, there, t = places_on(rng, origins, other, furthest=3.0)
        there &= t > 2.0**-12  # the margin for boxes, of 2^-16, is an angle there
        tiny = (places[:, :, None] + 1e-9 * rng.normal(size=(N, WIDTH, 3, 3))).astype(np.float32)
        inputs = [nodes(places, places), leaves(tiny), beams, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), low]
        masks = bits(launch(_in_beam, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
        assert not masks[:, 0][there].any()
        assert not masks[:, 1][there].any()


def test_a_beam_holds_the_sheet_that_its_lowest_rays_meet():
    """Large triangles along the horizon, above the origin by less than their corners are rounded."""
    cells = cells_of(448)
    rng, origins, normals = lobes(6, False)
    origins *= 0.25
    sector = rng.integers(0, cells.sectors, N)
    u = np.stack([np.full(N, 1.0 - 2.0**-23), (sector + 0.5) / cells.sectors], axis=1)
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
    beams = on_cpu(cells.beams[sector, cells.bands].reshape(N, -1))
    inputs = [nodes(places, places), leaves(triangles), beams, on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), LOW]
    masks = bits(launch(_in_beam, N, inputs, wp.zeros((N, 2), wp.int32, device="cpu"))[0])
    assert masks[:, 1][met].all()


def frames(normals):
    """(N, 3, 3) float64 rows x, y, z of the frame about each normal (Duff2017)."""
    x, y, z = np.moveaxis(normals.astype(np.float64), 1, 0)
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    first = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=1)
    second = np.stack([b, sign + y * y * a, -y], axis=1)
    return np.stack([first, second, normals], axis=1)
