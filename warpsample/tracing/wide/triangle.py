"""Intersection of a ray with a triangle in float64; the result depends on the ray and the triangle alone."""

import warp as wp

from warpsample.maths.memory import float_at
from warpsample.maths.numerics import ZERO, fma_double
from warpsample.tracing.wide.layout import WIDTH
from warpsample.tracing.wide.prepare import Ray

_LEAF_FLOATS = 9 * WIDTH
_SECOND = wp.constant(wp.int32(3 * WIDTH))
_THIRD = wp.constant(wp.int32(6 * WIDTH))


@wp.func
def _is_inside(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64) -> wp.bool:
    """Return whether the origin (0, 0) is inside the plane triangle with corners a, b and c, or on its edge."""
    u = cx * by - cy * bx
    v = ax * cy - ay * cx
    w = bx * ay - by * ax
    return (u >= ZERO and v >= ZERO and w >= ZERO) or (u <= ZERO and v <= ZERO and w <= ZERO)


@wp.func
def _find_side_of_line(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64) -> wp.int32:
    """Return 1 or -1 for the side of the line from a to b on which the origin lies: the exact sign of a x b.

    Where a x b is 0, the point counts as moved by an infinitesimal step along the first axis and an infinitely smaller one
    along the second. The line from b to a gives the opposite sign. The result is 0 only if a equals b.
    """
    p = ax * by
    q = ay * bx
    if p == q:  # the products are rounded: their rounding errors decide
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
def _is_inside_once(
    ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64
) -> wp.bool:
    """Return whether the origin (0, 0) is inside a plane triangle, with shared edges and corners counted once.

    On an edge or a corner the point counts as moved by the step of `_find_side_of_line`. So exactly one of the triangles
    around the point contains it.
    """
    side = _find_side_of_line(ax, ay, bx, by)
    return side != 0 and side == _find_side_of_line(bx, by, cx, cy) and side == _find_side_of_line(cx, cy, ax, ay)


@wp.func
def _direction(ray: Ray, row: wp.uint64) -> wp.float64:
    """Return the component of a ray's direction along an axis.

    `row` is the byte offset of the axis' row in a leaf.
    """
    return wp.float64(float_at(ray.direction + row * ray.rows_of_leaf, 0))


@wp.func
def plane_distance(leaf: wp.uint64, k: wp.int32, ray: Ray) -> wp.float32:
    """Return the distance along a ray to the plane of the k-th triangle of a leaf.

    It is inf or NaN where the ray is parallel to the plane.
    """
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


def _build_edge_test(inside: wp.Function) -> wp.Function:
    """Build a Warp function (leaf, k, ray) -> bool that tests whether the line of a ray passes through a triangle.

    The result depends on the float32 ray and triangle alone, whichever leaf holds the triangle. As in `triangles_near`, the
    triangle is sheared onto the ray, but in float64, where differences of coordinates are exact. So the ray and an edge
    alone determine the side on which the ray passes, not the distance to the edge's ends. Rounding is monotonic: the sign of
    a difference of two rounded products is the sign of the exact difference, or 0. The two triangles at an edge compute the
    sign from the same numbers.

    Args:
        inside: function (ax, ay, bx, by, cx, cy) -> bool: whether the point (0, 0) is in a triangle of the plane.
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


is_between_edges: wp.Function = _build_edge_test(_is_inside)
"""Test (leaf, k, ray) -> bool that includes the edges: a ray at a shared edge hits both triangles, so at least one."""

is_crossed: wp.Function = _build_edge_test(_is_inside_once)
"""Test (leaf, k, ray) -> bool that counts a crossing at an edge or a corner like that of a ray just beside the edge.

Such a ray crosses the surface once, or at a silhouette twice or never.
"""
