"""Light at the smooth interface of two transparent media: Fresnel's share, refraction, and the choice between both parts."""

import warp as wp

from warpsample.distributions.scattering.reflection import half_vector
from warpsample.maths.numerics import GRID, ONE, TWO, ZERO, fma, polish, root, root_double, uniform_from_bits
from warpsample.sequences.hashing import finalise

_QUARTER = wp.constant(wp.float64(0.25))
_TINY = wp.constant(wp.float64(1e-30))
_GRID = wp.constant(wp.float32(GRID))
_SPREAD = wp.constant(wp.uint32(0x9E3779B9))


@wp.func
def fresnel_dielectric(cosine: wp.float32, eta: wp.float32) -> wp.float32:
    """Return the share of unpolarised light that the interface of two transparent media reflects, from 0 to 1.

    `cosine` is that of the angle between the normal and the light, from 0 to 1. `eta` is the index of refraction of the far
    side over that of the light's own side. The share is 1 for total reflection. No term cancels for eta close to 1.
    """
    excess = (eta - 1.0) * (eta + 1.0)
    square = fma(cosine, cosine, excess)
    g = root(wp.max(square, 0.0))
    per_sum = 1.0 / (cosine + g)
    per_other = 1.0 / fma(eta * eta, cosine, g)
    across = excess * per_sum * per_sum
    along = excess * fma(cosine * cosine, fma(eta, eta, 1.0), -1.0) * per_other * per_other
    return wp.where(square > 0.0, 0.5 * fma(across, across, along * along), 1.0)


@wp.func
def transmitted_share(c: wp.float64, g: wp.float64, square: wp.float64) -> wp.float64:
    """Return 1 - F for cosines c in front and g / eta behind the interface, with the `square` of eta; nothing cancels."""
    near = ONE / (c + g)
    far = ONE / (square * c + g)
    return TWO * c * g * (near * near + square * far * far)


@wp.func
def normal_to_refraction(m: wp.vec3, view: wp.vec3, eta: wp.float32) -> wp.vec3:
    """Return the direction in which the interface with the normal m refracts the view; zero for total reflection.

    By Snell's law it is ((c - g) / eta) m - v / eta for the view v, with c = v.m and g^2 = eta^2 - 1 + c^2. `eta` is the
    index of refraction of the far side over that of the view's own side; m points to the view's side.
    """
    cosine = fma(m[0], view[0], fma(m[1], view[1], m[2] * view[2]))
    excess = (eta - 1.0) * (eta + 1.0)
    square = fma(cosine, cosine, excess)
    inverse = wp.where(square > 0.0, 1.0 / eta, 0.0)
    along = -excess / (cosine + root(wp.max(square, 0.0))) * inverse
    x = fma(along, m[0], -inverse * view[0])
    y = fma(along, m[1], -inverse * view[1])
    z = fma(along, m[2], -inverse * view[2])
    return polish(wp.vec3(x, y, z))


@wp.func
def _refracting(w: wp.vec3, view: wp.vec3, eta: wp.float32) -> wp.vec4d:
    """Return (x, y, z, L): the normal along v + eta w on the side of v, and L = abs(v + eta w), in float64."""
    index = wp.float64(eta)
    x = wp.float64(view[0]) + index * wp.float64(w[0])
    y = wp.float64(view[1]) + index * wp.float64(w[1])
    z = wp.float64(view[2]) + index * wp.float64(w[2])
    length = root_double(x * x + y * y + z * z)
    inverse = wp.where(eta > 1.0, -ONE, ONE) / length
    return wp.vec4d(x * inverse, y * inverse, z * inverse, length)


@wp.func
def refraction_to_normal(w: wp.vec3, view: wp.vec3, eta: wp.float32) -> wp.vec3:
    """Return the unit normal, on the side of the view v, along v + eta w, which refracts the view to the direction w."""
    t = _refracting(w, view, eta)
    return wp.vec3(wp.float32(t[0]), wp.float32(t[1]), wp.float32(t[2]))


@wp.func
def reflection_of(w: wp.vec3, view: wp.vec3, eta: wp.float32):
    """Return (m, m.v, factor) for the normal m that reflects the view v to w; the factor is 0 where w = -v.

    The density of the reflected w is that of m, divided by m.v, times the factor F / 4. The cosine is float64, because F has
    an infinite derivative at the rim of total reflection.
    """
    h = half_vector(w, view)
    x = wp.float64(view[0]) + wp.float64(w[0])
    y = wp.float64(view[1]) + wp.float64(w[1])
    z = wp.float64(view[2]) + wp.float64(w[2])
    index = wp.float64(eta)
    square = _QUARTER * (x * x + y * y + z * z)
    c = wp.max(root_double(square), _TINY)
    g = root_double(wp.max(square + (index - ONE) * (index + ONE), ZERO))
    share = ONE - transmitted_share(c, g, index * index)
    return wp.vec3(h[0], h[1], h[2]), h[3], wp.where(h[3] > 0.0, wp.float32(_QUARTER * share), 0.0)


@wp.func
def refraction_of(w: wp.vec3, view: wp.vec3, eta: wp.float32):
    """Return (m, m.v, factor) for the normal m that refracts the view v to w; the factor is 0 where none does.

    The density of the refracted w is that of m, divided by m.v, times the factor m.v (1 - F) abs(w.m) eta^2 / L^2.
    """
    t = _refracting(w, view, eta)
    cosine = wp.float64(view[0]) * t[0] + wp.float64(view[1]) * t[1] + wp.float64(view[2]) * t[2]
    behind = wp.float64(w[0]) * t[0] + wp.float64(w[1]) * t[1] + wp.float64(w[2]) * t[2]
    square = wp.float64(eta) * wp.float64(eta)
    g = -wp.float64(eta) * behind
    c = wp.max(cosine, ZERO)
    factor = c * transmitted_share(c, g, square) * -behind * square / (t[3] * t[3])
    refracts = wp.where(cosine > ZERO, 1, 0) & wp.where(behind < ZERO, 1, 0)
    m = wp.vec3(wp.float32(t[0]), wp.float32(t[1]), wp.float32(t[2]))
    return m, wp.float32(c), wp.where(refracts != 0, wp.float32(factor), 0.0)


@wp.func
def normal_per_refraction(w: wp.vec3, view: wp.vec3, eta: wp.float32) -> wp.float32:
    """Return the Jacobian of refraction: solid angle of normals per solid angle of directions w, abs(w.m) eta^2 / L^2.

    L = abs(v + eta w) for the view v. The density of w is that of the normal times 1 - F times this number.
    """
    t = _refracting(w, view, eta)
    behind = wp.float64(w[0]) * t[0] + wp.float64(w[1]) * t[1] + wp.float64(w[2]) * t[2]
    square = wp.float64(eta) * wp.float64(eta)
    return wp.float32(wp.max(-behind, ZERO) * square / (t[3] * t[3]))


@wp.func
def third_uniform(u: wp.vec2) -> wp.float32:
    """Return a third uniform number in [0, 1): a hash of the 48 bits of a point u of the unit square."""
    first = wp.uint32(wp.int32(u[0] * _GRID))
    second = wp.uint32(wp.int32(u[1] * _GRID))
    return uniform_from_bits(finalise(finalise(first) + second * _SPREAD))
