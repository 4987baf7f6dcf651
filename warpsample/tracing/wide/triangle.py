"""Which triangle a ray meets, and where: decided in float64, from the ray and the triangle alone."""

import warp as wp

from warpsample.tracing.wide.layout import CHUNK, CHUNK_FLOATS, DIRECTION, WIDTH
from warpsample.tracing.wide.prepare import Ray

_ROW = wp.constant(wp.uint64(WIDTH * 4))
_LEAF_FLOATS = 9 * WIDTH
_SECOND = wp.constant(wp.int32(3 * WIDTH))
_THIRD = wp.constant(wp.int32(6 * WIDTH))
_ZERO = wp.constant(wp.float64(0.0))


@wp.func
def _inside(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64) -> wp.bool:
    """Whether 0 is in a triangle of the plane or on its edge."""
    u = cx * by - cy * bx
    v = ax * cy - ay * cx
    w = bx * ay - by * ax
    return (u >= _ZERO and v >= _ZERO and w >= _ZERO) or (u <= _ZERO and v <= _ZERO and w <= _ZERO)


@wp.func
def triangle_distance(
    leaf: wp.uint64, k: wp.int32, sure: wp.int32, ray: Ray, column: wp.uint64, reach: wp.float32
) -> wp.float32:
    """From a ray's origin to a triangle of a leaf; -1 where the ray does not meet it within reach.

    A function of the float32 ray and triangle alone, whichever leaf it is in: what is tested before may only spare it, as
    `sure` does, which is not 0 if the ray is known to meet it. As `triangles_near`, in float64, where the differences of
    coordinates are exact: on which side of an edge a ray passes is told by the ray and the edge, not by how far away the
    edge ends. Rounding is monotonic: the sign of a difference of two rounded products is that of their difference, or 0. The
    two triangles at an edge compute it from the same numbers, and 0 counts as inside of both: a ray at an edge meets at
    least one.
    """
    first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    lane = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    d_first = wp.float64(lane[DIRECTION + wp.int32(ray.first / _ROW) * CHUNK])
    d_second = wp.float64(lane[DIRECTION + wp.int32(ray.second / _ROW) * CHUNK])
    d_along = wp.float64(lane[DIRECTION + wp.int32(ray.along / _ROW) * CHUNK])
    ox = wp.float64(ray.origin_first)
    oy = wp.float64(ray.origin_second)
    oz = wp.float64(ray.origin_along)
    ax = wp.float64(first[k])
    ay = wp.float64(second[k])
    az = wp.float64(along[k])
    bx = wp.float64(first[_SECOND + k])
    by = wp.float64(second[_SECOND + k])
    bz = wp.float64(along[_SECOND + k])
    cx = wp.float64(first[_THIRD + k])
    cy = wp.float64(second[_THIRD + k])
    cz = wp.float64(along[_THIRD + k])
    nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay)
    ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az)
    nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    height = nx * (ax - ox) + ny * (ay - oy) + nz * (az - oz)
    slope = nx * d_first + ny * d_second + nz * d_along  # 0 where the triangle is seen from its edge
    met = wp.float32(-1.0)
    inside = sure != 0
    if not inside and height * slope > _ZERO:
        inside = _inside(
            (ax - ox) * d_along - (az - oz) * d_first,
            (ay - oy) * d_along - (az - oz) * d_second,
            (bx - ox) * d_along - (bz - oz) * d_first,
            (by - oy) * d_along - (bz - oz) * d_second,
            (cx - ox) * d_along - (cz - oz) * d_first,
            (cy - oy) * d_along - (cz - oz) * d_second,
        )
    if inside and height * slope > _ZERO:
        distance = wp.float32(height / slope)
        if distance > 0.0 and distance < reach:
            met = distance
    return met
