"""Margins: what comes before the decision in float64 saves work without changing an answer, and saves enough of it."""

import numpy as np
import pytest
import warp as wp
from margin_cases import (
    N,
    bits,
    chunks,
    launch,
    leaves,
    meets,
    nodes,
    on_cpu,
    places_on,
    rays_into_the_scene,
    sideways,
    triangles_about,
)

from warpsample.tracing.queries import CHUNK_FLOATS, direction_of, vector_in
from warpsample.tracing.sight.point import SIDES_FLOATS
from warpsample.tracing.sight.sides import open_leaf, rays_passing, triangles_passed
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.candidates import boxes_hit, triangles_near
from warpsample.tracing.wide.layout import LEAF_BYTES, NODE_BYTES, WIDTH
from warpsample.tracing.wide.prepare import Ray, prepare_wide, ray_in
from warpsample.tracing.wide.triangle import is_between_edges, plane_distance


@wp.kernel(enable_backward=False, module="unique")
def _boxes_met(nodes: wp.array2d[wp.float32], chunks: wp.array2d[wp.float32], reach: wp.float32, masks: wp.array[wp.int32]):
    i = wp.tid()
    chunk = chunks.ptr + wp.uint64(i) * wp.uint64(4 * CHUNK_FLOATS)
    prepare_wide(chunk, 16)
    mask, _ = boxes_hit(nodes.ptr + wp.uint64(i) * wp.uint64(NODE_BYTES), ray_in(chunk), reach, 0)
    masks[i] = mask


@wp.func
def _hit_distance(leaf: wp.uint64, k: wp.int32, ray: Ray, reach: wp.float32) -> wp.float32:
    """Return the distance of a triangle that a ray hits, decided in float64; -1 without a hit."""
    distance = plane_distance(leaf, k, ray)
    return wp.where(distance > 0.0 and distance < reach and is_between_edges(leaf, k, ray), distance, -1.0)


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
        distances[i, k] = _hit_distance(leaf, k, ray, sizes[i, 1])


@wp.kernel(enable_backward=False, module="unique")
def _sides(
    leaves: wp.array2d[wp.float32],
    chunks: wp.array2d[wp.float32],
    sizes: wp.array2d[wp.float32],
    near: wp.array2d[wp.int32],
    distances: wp.array2d[wp.float32],
):
    """What `_triangles` does, as packets do: with the triangles in lanes, and one by one with the rays in lanes."""
    i = wp.tid()
    chunk = chunks.ptr + wp.uint64(i) * wp.uint64(4 * CHUNK_FLOATS)
    leaf = leaves.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES)
    prepare_wide(chunk, 16)
    ray = ray_in(chunk)
    sides = wp.zeros(shape=(SIDES_FLOATS,), dtype=wp.float32)
    open_leaf(leaf, vector_in(chunk, 0), sizes[i, 1], sides.ptr)
    masks = triangles_passed(sides.ptr, direction_of(chunk, 0))
    others = wp.int32(0)
    for k in range(WIDTH):
        distances[i, k] = _hit_distance(leaf, k, ray, sizes[i, 1])
        lanes = rays_passing(sides.ptr, k, chunk)
        others = others | ((lanes & 1) << k) | (((lanes >> WIDTH) & 1) << (WIDTH + k))
    near[i, 0] = masks & 0xFFFF
    near[i, 1] = wp.where(others == masks, masks >> WIDTH, -1)


ROUTES = {"alone": _triangles, "together": _sides}
each_route = pytest.mark.parametrize("route", ROUTES)


@pytest.mark.parametrize("along_axes", [False, True])
def test_a_ray_meets_the_boxes_of_all_places_on_it_and_none_far_beside_it(along_axes):
    rng, origins, ways = rays_into_the_scene(1, along_axes)
    places, there, t = places_on(rng, origins, ways)
    found = bits(
        launch(_boxes_met, N, [nodes(places, places), chunks(origins, ways), np.inf], wp.zeros(N, wp.int32, device="cpu"))[0]
    )
    assert found[there].all()
    aside = places + 4.0 * PADDING * sideways(rng, ways)  # a padded box reaches no farther than sqrt(3) of its padding
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


@each_route
@pytest.mark.parametrize("hit", [True, False])
def test_triangles_are_met_as_in_long_double_and_seldom_looked_at_in_vain(route, hit):
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
    near, distances = launch(ROUTES[route], N, inputs, *outputs)
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


@each_route
@pytest.mark.parametrize("collapsed", [False, True])
def test_what_is_small_and_beside_the_ray_is_not_taken_for_met(route, collapsed):
    """The ray is in the planes of these triangles, or they are points: their edge functions are nothing but rounding."""
    rng, origins, ways = rays_into_the_scene(4)
    places = rng.uniform(-1.0, 1.0, (N, WIDTH, 3))
    back = origins[:, None] - places
    across = back - (back * ways[:, None]).sum(axis=2, keepdims=True) * ways[:, None]
    across /= np.linalg.norm(across, axis=2, keepdims=True)
    size = 10.0 ** rng.uniform(-8.0, -1.0, (N, 1, 1)) * (not collapsed)
    triangles = np.stack([places, places + size * across, places + size * ways[:, None]], axis=2).astype(np.float32)
    edge = np.ptp(triangles, axis=2).max(axis=(1, 2))
    inputs = [leaves(triangles), chunks(origins, ways), on_cpu(np.stack([edge, np.full(N, 2.0**60)], axis=1))]
    outputs = wp.zeros((N, 2), wp.int32, device="cpu"), wp.zeros((N, WIDTH), wp.float32, device="cpu")
    near, distances = launch(ROUTES[route], N, inputs, *outputs)
    near, known = bits(near[:, 0]), bits(near[:, 1])
    assert near[distances > 0.0].all()
    assert (distances[known] > 0.0).all()
