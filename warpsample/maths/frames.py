"""Orthonormal frame about a normal, and the change between local and world coordinates; local +z is the normal."""

import warp as wp

from warpsample.maths.numerics import fma, polish, scaled_to_unit

_LEAST_SINE_SQUARED = wp.constant(wp.float32(1e-6))


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
    """Rotate a direction from the local coordinates of a frame to world coordinates."""
    return wp.vec3(
        fma(frame[0, 0], w[0], fma(frame[0, 1], w[1], frame[0, 2] * w[2])),
        fma(frame[1, 0], w[0], fma(frame[1, 1], w[1], frame[1, 2] * w[2])),
        fma(frame[2, 0], w[0], fma(frame[2, 1], w[1], frame[2, 2] * w[2])),
    )


@wp.func
def to_local(frame: wp.mat33, w: wp.vec3) -> wp.vec3:
    """Rotate a direction from world coordinates to the local coordinates of a frame."""
    return to_world(wp.transpose(frame), w)


@wp.func
def frame_along(n: wp.vec3, tangent: wp.vec4):
    """Return the frame with columns (x, y, n) about a unit normal n, with x along a tangent; and 1, or 0 without a tangent.

    x is the part of `tangent` perpendicular to n, and y is n cross x, times the sign of the fourth number, as in glTF. A
    second projection keeps x perpendicular to 1e-7, however small the angle of tangent and normal. Where the sine of the
    angle is below 1e-3, or the tangent or its sign is 0 or NaN, the frame is `frame_about(n)`.
    """
    unit = scaled_to_unit(wp.vec3(tangent[0], tangent[1], tangent[2]))
    along = fma(unit[0], n[0], fma(unit[1], n[1], unit[2] * n[2]))
    x0 = fma(-along, n[0], unit[0])
    x1 = fma(-along, n[1], unit[1])
    x2 = fma(-along, n[2], unit[2])
    square = fma(x0, x0, fma(x1, x1, x2 * x2))
    # Masks instead of `and`, whose branches would prevent vectorisation.
    has_sign = wp.where(wp.abs(tangent[3]) > 0.0, 1, 0)
    mask = wp.where(wp.abs(unit[3]) < 0.1, has_sign, 0) & wp.where(square > _LEAST_SINE_SQUARED, 1, 0)
    usable = mask != 0
    inverse = 1.0 / wp.sqrt(wp.where(usable, square, 1.0))
    x0 = x0 * inverse
    x1 = x1 * inverse
    x2 = x2 * inverse
    rest = fma(x0, n[0], fma(x1, n[1], x2 * n[2]))
    x = polish(wp.vec3(fma(-rest, n[0], x0), fma(-rest, n[1], x1), fma(-rest, n[2], x2)))
    sign = wp.copysign(1.0, tangent[3])
    y0 = sign * fma(n[1], x[2], -(n[2] * x[1]))
    y1 = sign * fma(n[2], x[0], -(n[0] * x[2]))
    y2 = sign * fma(n[0], x[1], -(n[1] * x[0]))
    other = frame_about(n)
    frame = wp.mat33(
        wp.where(usable, x[0], other[0, 0]), wp.where(usable, y0, other[0, 1]), n[0],
        wp.where(usable, x[1], other[1, 0]), wp.where(usable, y1, other[1, 1]), n[1],
        wp.where(usable, x[2], other[2, 0]), wp.where(usable, y2, other[2, 1]), n[2],
    )  # fmt: skip
    return frame, mask
