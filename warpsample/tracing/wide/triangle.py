"""Which triangle a ray meets, and where: decided in float64, from the ray and the triangle alone."""

import warp as wp

from warpsample.maths.memory import float_at
from warpsample.maths.numerics import ZERO, fma_double
from warpsample.tracing.wide.layout import WIDTH
from warpsample.tracing.wide.prepare import Ray

_LEAF_FLOATS = 9 * WIDTH
_SECOND = wp.constant(wp.int32(3 * WIDTH))
_THIRD = wp.constant(wp.int32(6 * WIDTH))


@wp.func
def _inside(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64) -> wp.bool:
    """Whether 0 is in a triangle of the plane or on its edge."""
    u = cx * by - cy * bx
    v = ax * cy - ay * cx
    w = bx * ay - by * ax
    return (u >= ZERO and v >= ZERO and w >= ZERO) or (u <= ZERO and v <= ZERO and w <= ZERO)


@wp.func
def _side(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64) -> wp.int32:
    """On which side of the line from a to b in the plane 0 is, 1 or -1: the exact sign of a x b; 0 only if a is b.

    Where that is 0 it is the sign for 0 moved by an infinitesimal step along the first axis, and one infinitely smaller
    along the second. From b to a it is the opposite.
    """
    p = ax * by
    q = ay * bx
    if p == q:  # the products are rounded; what was lost decides
        p = fma_double(ax, by, -p)
        q = fma_double(ay, bx, -q)
    if p == q:
        p = ay
        q = by
    if p == q:
        p = bx
        q = ax
    return wp.where(p > q, 1, wp.where(p < q, -1, 0))


@wp.func
def _inside_once(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64) -> wp.bool:
    """Whether 0 is in a triangle of the plane; of those that share an edge or a corner at 0, in one on either side of it."""
    side = _side(ax, ay, bx, by)
    return side != 0 and side == _side(bx, by, cx, cy) and side == _side(cx, cy, ax, ay)


@wp.func
def _direction(ray: Ray, row: wp.uint64) -> wp.float64:
    """A ray's direction along an axis, which is told by the offset of its row in a leaf."""
    return wp.float64(float_at(ray.direction + row * ray.rows_of_leaf, 0))


@wp.func
def plane_distance(leaf: wp.uint64, k: wp.int32, ray: Ray) -> wp.float32:
    """From a ray's origin to the plane of a triangle of a leaf; inf or NaN where the ray is parallel to it."""
    first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)
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
    x = ax - wp.float64(ray.origin_first)
    y = ay - wp.float64(ray.origin_second)
    z = az - wp.float64(ray.origin_along)
    slope = nx * _direction(ray, ray.first) + ny * _direction(ray, ray.second) + nz * _direction(ray, ray.along)
    return wp.float32((nx * x + ny * y + nz * z) / slope)


def _between(inside: wp.Function) -> wp.Function:
    """A function (leaf, k, ray) -> whether the ray's line passes between the edges of a triangle, by a test of 0 in a plane.

    A function of the float32 ray and triangle alone, whichever leaf it is in. As `triangles_near`, in float64, where the
    differences of coordinates are exact: on which side of an edge a ray passes is told by the ray and the edge, not by how
    far away the edge ends. Rounding is monotonic: the sign of a difference of two rounded products is that of their
    difference, or 0. The two triangles at an edge compute it from the same numbers.
    """

    @wp.func
    def between(leaf: wp.uint64, k: wp.int32, ray: Ray) -> wp.bool:
        first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)
        second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)
        along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)
        d_first = _direction(ray, ray.first)
        d_second = _direction(ray, ray.second)
        d_along = _direction(ray, ray.along)
        ox = wp.float64(ray.origin_first)
        oy = wp.float64(ray.origin_second)
        oz = wp.float64(ray.origin_along)
        az = wp.float64(along[k]) - oz
        bz = wp.float64(along[_SECOND + k]) - oz
        cz = wp.float64(along[_THIRD + k]) - oz
        return inside(
            (wp.float64(first[k]) - ox) * d_along - az * d_first,
            (wp.float64(second[k]) - oy) * d_along - az * d_second,
            (wp.float64(first[_SECOND + k]) - ox) * d_along - bz * d_first,
            (wp.float64(second[_SECOND + k]) - oy) * d_along - bz * d_second,
            (wp.float64(first[_THIRD + k]) - ox) * d_along - cz * d_first,
            (wp.float64(second[_THIRD + k]) - oy) * d_along - cz * d_second,
        )

    return between


between_edges: wp.Function = _between(_inside)
"""Or meets one of them: 0 counts as inside of both triangles at an edge, so that a ray there meets at least one."""

crosses: wp.Function = _between(_inside_once)
"""A ray at an edge or a corner crosses the surface as one just beside it does: once, or at a silhouette twice or never."""
