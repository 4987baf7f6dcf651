"""Orthonormal frame about a normal, and the change between local and world coordinates; local +z is the normal."""

import warp as wp

from warpsample.maths.numerics import fma


@wp.func
def frame_about(n: wp.vec3) -> wp.mat33:
    """Return the right-handed frame with columns (tangent, bitangent, n) for a unit normal n.

    The frame is orthonormal to 1.6e-7 for every n. Duff2017, listing 3: the sign of n.z, -0.0 included, keeps the divisor
    at least 1 in magnitude, while Frisvad2012 is wrong by up to 0.3 near -z. The frame jumps where n.z changes sign; the
    gradient there is that of the side of the sign.
    """
    sign = wp.copysign(1.0, n[2])
    a = -1.0 / (sign + n[2])
    xa = n[0] * a
    xya = n[1] * xa
    return wp.mat33(
        fma(sign * n[0], xa, 1.0), xya, n[0],
        sign * xya, fma(n[1], n[1] * a, sign), n[1],
        -sign * n[0], -n[1], n[2],
    )  # fmt: skip


@wp.func
def to_world(frame: wp.mat33, w: wp.vec3) -> wp.vec3:
    """Return a local direction in world coordinates."""
    return wp.vec3(
        fma(frame[0, 0], w[0], fma(frame[0, 1], w[1], frame[0, 2] * w[2])),
        fma(frame[1, 0], w[0], fma(frame[1, 1], w[1], frame[1, 2] * w[2])),
        fma(frame[2, 0], w[0], fma(frame[2, 1], w[1], frame[2, 2] * w[2])),
    )


@wp.func
def to_local(frame: wp.mat33, w: wp.vec3) -> wp.vec3:
    """Return a world direction in the coordinates of the frame."""
    return to_world(wp.transpose(frame), w)
