"""Test whether one triangle blocks a whole pyramid of directions (shaft), so that no ray in it needs to be cast."""

import warp as wp

from warpsample.maths.numerics import lesser
from warpsample.tracing.sight.shafts import corner_of
from warpsample.tracing.wide.layout import WIDTH, corner, size_of

_FLAT = wp.constant(wp.float32(2.0**-40))  # relative to the cubed distance; float64 resolves a height to 2^-50 of it


@wp.func
def _compute_least_dot(e: wp.vec3, p: wp.vec3, q: wp.vec3, r: wp.vec3, s: wp.vec3, sign: wp.float32) -> wp.float32:
    """Return the smallest dot product of a shaft's four corner directions p, q, r, s with sign * e.

    The vector e is normal to a plane through the point and an edge of the triangle.
    """
    return lesser(
        lesser(sign * wp.dot(e, p), sign * wp.dot(e, q)),
        lesser(sign * wp.dot(e, r), sign * wp.dot(e, s)),
    )


@wp.func
def covering_triangles(leaf: wp.uint64, vectors: wp.uint64, o: wp.vec3, margin: wp.float32) -> wp.int32:
    """Return a mask of a leaf's triangles that block a whole shaft (pyramid of directions) from o.

    All rays of the shaft hit each of these triangles, despite rounding. The directions of the corners, and so all directions
    between them, are sums of the directions of the triangle's corners with positive weights. `margin` is the angle in
    radians by which the shaft must be inside the triangle. It must be at least 2^-20 plus the rounding error of the rays'
    directions. The 2^-20 cover the rounding of a corner by 2^-24 of its distance, and of products and sums by 16 times
    2^-24.
    """
    p = corner_of(vectors, 0)
    q = corner_of(vectors, 1)
    r = corner_of(vectors, 2)
    s = corner_of(vectors, 3)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        a = corner(leaf, 0, k, o)
        b = corner(leaf, 3, k, o)
        c = corner(leaf, 6, k, o)
        e = wp.cross(a, b)
        f = wp.cross(b, c)
        g = wp.cross(c, a)
        volume = wp.dot(a, f)
        sign = wp.where(volume < 0.0, -1.0, 1.0)
        to_a = size_of(a)
        to_b = size_of(b)
        to_c = size_of(c)
        far = to_a + to_b + to_c
        inside = wp.where(_compute_least_dot(e, p, q, r, s, sign) > margin * to_a * to_b, 1, 0)
        inside = inside & wp.where(_compute_least_dot(f, p, q, r, s, sign) > margin * to_b * to_c, 1, 0)
        inside = inside & wp.where(_compute_least_dot(g, p, q, r, s, sign) > margin * to_c * to_a, 1, 0)
        flat = margin * to_a * to_b * to_c + _FLAT * far * far * far
        mask = mask | ((inside & wp.where(sign * volume > flat, 1, 0)) << k)
        k += 1
    return mask
