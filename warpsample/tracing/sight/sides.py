"""Tests of many rays from one origin against a tree leaf's triangles, by planes through the origin and triangle sides.

Let corners a and b be relative to the origin. A ray with direction d passes inside the side from a to b where
d . (a x (b - a)) > 0, if the triangle is oriented so that the origin is behind it. Then the ray also goes towards the
triangle's plane, so that no division is needed.

An opened leaf has rows of sixteen float32, one lane per triangle. Nine rows hold x, y, z of three inward normals. Three rows
hold limits on the products with d: the one above which a ray is certainly inside, the one above which it may be inside, and
the one below which it may be inside all sides from the other face of the triangle.
"""

import warp as wp

from warpsample.maths.numerics import fma, greater, lesser, negative
from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, DIRECTION
from warpsample.tracing.sight.point import SIDES_FLOATS
from warpsample.tracing.wide.lanes import lanes_with
from warpsample.tracing.wide.layout import WIDTH, size_of

_CORNER_FLOATS = 9 * WIDTH
_SURE, _OUTSIDE, _BEHIND = (row * WIDTH for row in (9, 10, 11))
_MARGIN = wp.constant(wp.float32(16.0 * 2.0**-24))
_LEAST_EDGE = wp.constant(wp.float32(2.0**-22))
_NEVER = wp.constant(wp.float32(2.0**60))
_NEARER = wp.constant(wp.float32(1.0 - 2.0**-20))
_MAYBE = wp.constant(wp.int32(-(2**31)))
_SURELY = wp.constant(wp.int32(2**30))


@wp.func
def _cross(a: wp.vec3, b: wp.vec3) -> wp.vec3:
    """Return the cross product a x b, with one product and one fma per component."""
    return wp.vec3(
        fma(a[1], b[2], negative(a[2] * b[1])),
        fma(a[2], b[0], negative(a[0] * b[2])),
        fma(a[0], b[1], negative(a[1] * b[0])),
    )


@wp.func
def open_leaf(leaf: wp.uint64, o: wp.vec3, reach: wp.float32, sides: wp.uint64):
    """Compute the planes through the origin o and each side of a tree leaf's triangles, to test many rays from o.

    `sides` is the address to which the inward normals of the planes, and limits for rays, are written.
    """
    # Let u = 2^-24, and A and E the greatest sums of absolute components of corners and of sides. A component of a normal is
    # rounded by 4 u of its two products, and a product with d by 3 u more: 7 u A E in all. The difference b - a, instead of
    # b, makes the error relative to the side. The margin is 16 u A E; `is_between_edges` in float64 rounds by 2 u A 2^-22 at
    # most. The sign of n . a, with n = (b - a) x (c - a), is the side of the plane on which the origin is. It is uncertain
    # within 11 u A E E: the triangle is then seen edge-on, and rays may pass it on either side. If a corner is beyond the
    # reach, no ray counts as a certain hit.
    rows = wp.array(ptr=sides, shape=(SIDES_FLOATS,), dtype=wp.float32)
    given = wp.array(ptr=leaf, shape=(_CORNER_FLOATS,), dtype=wp.float32)
    # A copy of the leaf: stores to `rows` may alias the leaf, which would prevent vectorisation.
    local = wp.zeros(shape=(_CORNER_FLOATS,), dtype=wp.float32)
    corners = wp.array(ptr=local.ptr, shape=(_CORNER_FLOATS,), dtype=wp.float32)
    i = wp.int32(0)
    while i < _CORNER_FLOATS:
        corners[i] = given[i]
        i += 1
    k = wp.int32(0)
    while k < WIDTH:
        first = wp.vec3(corners[k], corners[WIDTH + k], corners[2 * WIDTH + k])
        second = wp.vec3(corners[3 * WIDTH + k], corners[4 * WIDTH + k], corners[5 * WIDTH + k])
        third = wp.vec3(corners[6 * WIDTH + k], corners[7 * WIDTH + k], corners[8 * WIDTH + k])
        a = first - o
        b = second - o
        c = third - o
        e = second - first
        f = third - second
        g = first - third
        p = _cross(a, e)
        q = _cross(b, f)
        r = _cross(c, g)
        n = _cross(g, e)
        height = fma(n[0], a[0], fma(n[1], a[1], n[2] * a[2]))
        far = greater(greater(size_of(a), size_of(b)), size_of(c))
        edge = greater(greater(greater(size_of(e), size_of(f)), size_of(g)), _LEAST_EDGE)
        margin = _MARGIN * far * edge
        turn = wp.where(height < 0.0, -1.0, 1.0)
        rows[k] = turn * p[0]
        rows[WIDTH + k] = turn * p[1]
        rows[2 * WIDTH + k] = turn * p[2]
        rows[3 * WIDTH + k] = turn * q[0]
        rows[4 * WIDTH + k] = turn * q[1]
        rows[5 * WIDTH + k] = turn * q[2]
        rows[6 * WIDTH + k] = turn * r[0]
        rows[7 * WIDTH + k] = turn * r[1]
        rows[8 * WIDTH + k] = turn * r[2]
        from_edge = wp.abs(height) <= margin * edge
        within = far < reach * _NEARER
        rows[_SURE + k] = wp.where(from_edge, _NEVER, wp.where(within, margin, _NEVER))
        rows[_OUTSIDE + k] = negative(margin)
        rows[_BEHIND + k] = wp.where(from_edge, margin, -_NEVER)
        k += 1


@wp.func
def _classify_ray(
    d: wp.vec3, p: wp.vec3, q: wp.vec3, r: wp.vec3, sure: wp.float32, outside: wp.float32, behind: wp.float32
) -> wp.int32:
    """Return flags for a ray and a triangle: bit 31 is set if the ray may hit it, bit 30 if it certainly does.

    A ray hits the triangle if it passes between the three sides.
    """
    u = fma(p[0], d[0], fma(p[1], d[1], p[2] * d[2]))
    v = fma(q[0], d[0], fma(q[1], d[1], q[2] * d[2]))
    w = fma(r[0], d[0], fma(r[1], d[1], r[2] * d[2]))
    least = lesser(lesser(u, v), w)
    most = greater(greater(u, v), w)
    may = wp.where(least >= outside, _MAYBE, 0) | wp.where(most <= behind, _MAYBE, 0)
    return may | wp.where(least > sure, _SURELY, 0)


@wp.func
def triangles_passed(sides: wp.uint64, d: wp.vec3) -> wp.int32:
    """Return a mask of a tree leaf's triangles: bits 0 to 15 for possible hits of a ray, bits 16 to 31 for certain hits."""
    rows = wp.array(ptr=sides, shape=(SIDES_FLOATS,), dtype=wp.float32)
    met = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    k = wp.int32(0)
    while k < WIDTH:
        p = wp.vec3(rows[k], rows[WIDTH + k], rows[2 * WIDTH + k])
        q = wp.vec3(rows[3 * WIDTH + k], rows[4 * WIDTH + k], rows[5 * WIDTH + k])
        r = wp.vec3(rows[6 * WIDTH + k], rows[7 * WIDTH + k], rows[8 * WIDTH + k])
        met[k] = _classify_ray(d, p, q, r, rows[_SURE + k], rows[_OUTSIDE + k], rows[_BEHIND + k])
        k += 1
    return lanes_with(met.ptr, 31) | (lanes_with(met.ptr, 30) << WIDTH)


@wp.func
def rays_passing(sides: wp.uint64, t: wp.int32, column: wp.uint64) -> wp.int32:
    """Return a mask of sixteen rays: bits 0 to 15 for possible hits of the t-th triangle, bits 16 to 31 for certain hits.

    The rays are those of a chunk from the column at `column` on.
    """
    rows = wp.array(ptr=sides, shape=(SIDES_FLOATS,), dtype=wp.float32)
    rays = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    p = wp.vec3(rows[t], rows[WIDTH + t], rows[2 * WIDTH + t])
    q = wp.vec3(rows[3 * WIDTH + t], rows[4 * WIDTH + t], rows[5 * WIDTH + t])
    r = wp.vec3(rows[6 * WIDTH + t], rows[7 * WIDTH + t], rows[8 * WIDTH + t])
    sure = rows[_SURE + t]
    outside = rows[_OUTSIDE + t]
    behind = rows[_BEHIND + t]
    met = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    k = wp.int32(0)
    while k < WIDTH:
        d = wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k])
        met[k] = _classify_ray(d, p, q, r, sure, outside, behind)
        k += 1
    return lanes_with(met.ptr, 31) | (lanes_with(met.ptr, 30) << WIDTH)
