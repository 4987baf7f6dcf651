"""Stretching of microfacet normals along x and y, which turns an isotropic distribution into an anisotropic one."""

import warp as wp

from warpsample.maths.angles import quotient_of_squares
from warpsample.maths.numerics import fma


@wp.func
def mean_and_stretch(alpha: wp.float32, alpha_y: wp.float32) -> wp.vec3:
    """Split two roughnesses into their geometric mean and a stretch: (mean, alpha / mean, alpha_y / mean).

    For equal roughnesses from 1e-6 to 1 the mean is the roughness and both quotients are 1, exactly: the square root of a
    rounded square is the number itself. Formulas with these quotients do not cancel, unlike those with tan and the azimuth.
    """
    mean = wp.sqrt(alpha * alpha_y)
    return wp.vec3(mean, alpha / mean, alpha_y / mean)


@wp.func
def contracted_tan_squared(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32) -> wp.float64:
    """Return tan^2 of the angle between w, after undoing the anisotropic stretch, and +z; at most 1e37.

    float64 keeps the digits of an exponential of it. For equal roughnesses it is `tan_squared`, bit for bit.
    """
    x, y, z = wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2])
    ratio = wp.float64(alpha_y) / wp.float64(alpha)
    return quotient_of_squares(x * x * ratio + y * y / ratio, z)


@wp.func
def stretched(w: wp.vec3, m: wp.vec3) -> wp.vec3:
    """Return w with x multiplied by m[1] and y by m[2], the stretch factors of an anisotropic distribution."""
    return wp.vec3(w[0] * m[1], w[1] * m[2], w[2])


@wp.func
def contracted(w: wp.vec3, m: wp.vec3) -> wp.vec3:
    """Undo `stretched`: return w with x divided by m[1] and y by m[2], the stretch factors of a distribution."""
    return wp.vec3(w[0] / m[1], w[1] / m[2], w[2])


@wp.func
def stretched_to_unit(w: wp.vec3, m: wp.vec3) -> wp.vec3:
    """Stretch a unit vector w along x and y and normalise it; return w bit for bit if both roughnesses are equal."""
    v = stretched(w, m)
    equal = m[1] == m[2]
    inverse = wp.where(equal, 1.0, 1.0 / wp.sqrt(fma(v[0], v[0], fma(v[1], v[1], v[2] * v[2]))))
    x = v[0] * inverse
    y = v[1] * inverse
    z = v[2] * inverse
    # As `polish`.
    half_error = wp.where(equal, 0.0, 0.5 * fma(-x, x, fma(-y, y, fma(-z, z, 1.0))))
    return wp.vec3(fma(x, half_error, x), fma(y, half_error, y), fma(z, half_error, z))
