"""Beams about suns, from a point: whether one triangle darkens all of one, and a beam as `meets` takes it."""

import warp as wp

from warpsample.maths.numerics import greater, lesser
from warpsample.tracing.wide.corners import corner, size_of
from warpsample.tracing.wide.layout import CORNERS, PLANES, WIDTH

_BEAM_LOCAL = 3 * WIDTH
_MARGIN = wp.constant(wp.float32(2.0**-19))
"""Of what is compared, for both: a direction is rounded by at most 2^-20.4, a corner by 2^-24 of its distance, and products
and sums by 16 of 2^-24."""
_FLAT = wp.constant(wp.float32(2.0**-40))  # times the cubed distance: float64 tells a height by 2^-50 of it


@wp.func
def corner_of(beam: wp.uint64, i: wp.int32) -> wp.vec3:
    """The direction of a beam's i-th corner."""
    rows = wp.array(ptr=beam, shape=(_BEAM_LOCAL,), dtype=wp.float32)
    k = PLANES + i
    return wp.vec3(rows[k], rows[WIDTH + k], rows[2 * WIDTH + k])


@wp.func
def highest(beam: wp.uint64, n: wp.vec3) -> wp.float32:
    """The greatest cosine of a beam's corners to a unit vector: none of its directions has a greater one above 0."""
    most = wp.float32(-1.0)
    for i in range(CORNERS):
        most = greater(most, wp.dot(corner_of(beam, i), n))
    return most


@wp.func
def _least(e: wp.vec3, p: wp.vec3, q: wp.vec3, r: wp.vec3, s: wp.vec3, sign: wp.float32) -> wp.float32:
    """How far the corners are on the inner side of a plane through the point and an edge, at least."""
    return lesser(
        lesser(sign * wp.dot(e, p), sign * wp.dot(e, q)),
        lesser(sign * wp.dot(e, r), sign * wp.dot(e, s)),
    )


@wp.func
def covering(leaf: wp.uint64, beam: wp.uint64, o: wp.vec3) -> wp.int32:
    """Mask of the triangles of a leaf that each ray of a beam from o meets, whatever is rounded.

    The corners' directions, and so all between them, are sums of those of the triangle's corners with positive weights.
    """
    p = corner_of(beam, 0)
    q = corner_of(beam, 1)
    r = corner_of(beam, 2)
    s = corner_of(beam, 3)
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
        inside = wp.where(_least(e, p, q, r, s, sign) > _MARGIN * to_a * to_b, 1, 0)
        inside = inside & wp.where(_least(f, p, q, r, s, sign) > _MARGIN * to_b * to_c, 1, 0)
        inside = inside & wp.where(_least(g, p, q, r, s, sign) > _MARGIN * to_c * to_a, 1, 0)
        flat = _MARGIN * to_a * to_b * to_c + _FLAT * far * far * far
        mask = mask | ((inside & wp.where(sign * volume > flat, 1, 0)) << k)
        k += 1
    return mask
