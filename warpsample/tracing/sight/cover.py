"""Whether one triangle covers a shaft: then all its rays meet something, and none needs to be cast."""

import warp as wp

from warpsample.maths.numerics import lesser
from warpsample.tracing.sight.shafts import corner_of
from warpsample.tracing.wide.layout import WIDTH, corner, size_of

_FLAT = wp.constant(wp.float32(2.0**-40))  # times the cubed distance: float64 tells a height by 2^-50 of it


@wp.func
def _least(e: wp.vec3, p: wp.vec3, q: wp.vec3, r: wp.vec3, s: wp.vec3, sign: wp.float32) -> wp.float32:
    """How far the corners are on the inner side of a plane through the point and an edge, at least."""
    return lesser(
        lesser(sign * wp.dot(e, p), sign * wp.dot(e, q)),
        lesser(sign * wp.dot(e, r), sign * wp.dot(e, s)),
    )


@wp.func
def covering(leaf: wp.uint64, vectors: wp.uint64, o: wp.vec3, margin: wp.float32) -> wp.int32:
    """Mask of the triangles of a leaf that each ray of a shaft from o meets, whatever is rounded.

    The corners' directions, and so all between them, are sums of those of the triangle's corners with positive weights.
    The margin is of an angle, by which the shaft must be within the triangle: at least 2^-20, for a corner's rounding by
    2^-24 of its distance, and 16 of 2^-24 of products and sums, and what the rays' directions are rounded by.
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
        inside = wp.where(_least(e, p, q, r, s, sign) > margin * to_a * to_b, 1, 0)
        inside = inside & wp.where(_least(f, p, q, r, s, sign) > margin * to_b * to_c, 1, 0)
        inside = inside & wp.where(_least(g, p, q, r, s, sign) > margin * to_c * to_a, 1, 0)
        flat = margin * to_a * to_b * to_c + _FLAT * far * far * far
        mask = mask | ((inside & wp.where(sign * volume > flat, 1, 0)) << k)
        k += 1
    return mask
