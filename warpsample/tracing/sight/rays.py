"""Rays of one point: a group of rays is prepared together, then traced one by one or all at once."""

import warp as wp

from warpsample.directions.variates import LANES
from warpsample.host.locks import once
from warpsample.maths.memory import float_at
from warpsample.tracing.placement import in_double, is_far_off
from warpsample.tracing.queries import REACH, Accelerator, Glass, column_of, direction_of
from warpsample.tracing.sight.leaves import any_in_leaf, nearest_in_leaf
from warpsample.tracing.sight.packets import NO_RAYS, blocked_rays, ray_set
from warpsample.tracing.sight.point import LOCAL_LEAF, ShadingPoint, move_ray_near
from warpsample.tracing.wide.layout import face_in
from warpsample.tracing.wide.prepare import prepare_wide, ray_in
from warpsample.tracing.wide.query import wide_query
from warpsample.tracing.wide.through import next_crossing, path_transmittance


@wp.func
def whole_vectors(length: wp.int32) -> wp.int32:
    """Round a number of rays up to whole SIMD vectors, since loops need all directions of their last vector."""
    return (length + LANES - 1) / LANES * LANES


@wp.func
def move_rays_near(point: ShadingPoint, length: wp.int32):
    """Move the origins of `length` rays close to the mesh, if their point is far from the mesh."""
    if is_far_off(point.position):
        for k in range(length):
            move_ray_near(point, k, in_double(direction_of(point.chunk, k)))


@once
def prepare_rays(prepare: wp.Function = prepare_wide) -> wp.Function:
    """Build a Warp function that prepares `length` rays of a point for a tracer.

    Its arguments are (tree, point, local, rays).
    """

    @wp.func
    def prepare_chunk(tree: Accelerator, point: ShadingPoint, local: wp.int32, length: wp.int32):
        prepare(point.chunk, whole_vectors(length))

    return prepare_chunk


@once
def first_hit(any_hit: bool, query: wp.Function | None = None, wide: bool = True) -> wp.Function:
    """Build a Warp function that returns (distance, face) of the nearest hit of the k-th prepared ray.

    Its arguments are (tree, point, local, k). Without a hit or without reach the result is (inf, -1); with any_hit a hit
    gives (0, some face).

    Args:
        any_hit: whether any hit is enough.
        query: query of the tracer, by default that of the wide tree.
        wide: whether the point has a local leaf. Its triangles in the mask `local` are then tested first.
    """
    query = query or wide_query(any_hit, several=True)

    @wp.func
    def hit(tree: Accelerator, point: ShadingPoint, local: wp.int32, k: wp.int32):
        column = column_of(point.chunk, k)
        reach = float_at(column, REACH)
        distance = wp.float32(wp.INF)
        face = wp.int32(-1)
        if reach > 0.0:
            if wp.static(wide):
                if local != 0:
                    leaf = point.opened + LOCAL_LEAF
                    if wp.static(any_hit):
                        lane = any_in_leaf(leaf, local, column, reach)
                        if lane >= 0:
                            distance = 0.0
                            face = face_in(leaf, lane)
                    else:
                        met, lane = nearest_in_leaf(leaf, local, column, reach)
                        if lane >= 0:
                            distance = met
                            reach = met
                            face = face_in(leaf, lane)
            if tree.starts > 0 and (wp.static(not any_hit) or not (distance < wp.INF)):
                met, other, _nodes, _leaves = query(tree, column, reach, point.scratch)
                if wp.static(any_hit):  # not the distance, so that the compiler drops its computation
                    met = wp.where(other >= 0, 0.0, wp.float32(wp.INF))
                distance = wp.min(distance, met)
                face = wp.where(other >= 0, other, face)
        return distance, face

    return hit


@wp.func
def glass_transmittance_to(glass: Glass, point: ShadingPoint, k: wp.int32, distance: wp.float32) -> wp.float32:
    """Return the transmittance of the translucent faces along a prepared ray, up to a distance."""
    column = column_of(point.chunk, k)
    reach = wp.min(float_at(column, REACH), distance)
    share = wp.float32(1.0)
    if reach > 0.0:
        share = path_transmittance(glass, ray_in(column), reach, point.scratch)
    return share


@wp.func
def next_glass_crossing(
    glass: Glass, point: ShadingPoint, k: wp.int32, before: wp.float32, after: wp.float32, after_face: wp.int32
):
    """Return (distance, face) of a prepared ray's next crossing of a translucent face, behind a given crossing.

    The result is (inf, -1) without a crossing before the distance `before`. The given crossing is that of `after_face` at
    distance `after`.
    """
    column = column_of(point.chunk, k)
    reach = wp.min(float_at(column, REACH), before)
    near = wp.float32(wp.INF)
    face = wp.int32(-1)
    if reach > 0.0:
        near, face = next_crossing(glass.tree, ray_in(column), reach, after, after_face, point.scratch)
    return near, face


@wp.func
def glass_transmittance(glass: Glass, point: ShadingPoint, k: wp.int32) -> wp.float32:
    """Return the transmittance of the translucent faces along a whole prepared ray."""
    return glass_transmittance_to(glass, point, k, wp.float32(wp.INF))


@once
def rays_blocked(query: wp.Function | None = None, wide: bool = True) -> wp.Function:
    """Build a Warp function that returns the set of prepared rays that hit anything.

    Its arguments are (tree, point, local, rays, length); the set `rays` holds the rays to test. The set holds some of the
    first `length` rays of a chunk. With the wide tree they are traced together.

    Args:
        query: any-hit query of another tracer, which traces the rays one by one.
        wide: whether to use the wide tree.
    """
    if wide:
        return blocked_rays
    hit = first_hit(any_hit=True, query=query, wide=wide)

    @wp.func
    def blocked(tree: Accelerator, point: ShadingPoint, local: wp.int32, rays: wp.uint64, length: wp.int32):
        met = NO_RAYS
        for k in range(length):
            if (rays & ray_set(k)) != NO_RAYS:
                distance, _face = hit(tree, point, local, k)
                if distance < wp.INF:
                    met = met | ray_set(k)
        return met

    return blocked
