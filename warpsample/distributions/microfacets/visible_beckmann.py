"""Distribution of visible Beckmann normals: each microfacet is weighted by the area that it shows to the viewer."""

from typing import ClassVar

import warp as wp

from warpsample.distributions.microfacets.visible_ggx import VisibleNormals, blurred_facing
from warpsample.distributions.record import Cases, Maps
from warpsample.maths.anisotropy import contracted, mean_and_stretch, stretched, stretched_to_unit
from warpsample.maths.error_function import erfc_double, erfc_inverse_roughly
from warpsample.maths.exponentials import exp_double, logarithm
from warpsample.maths.numerics import GRID, HALF, INV_PI_DOUBLE, ONE, TWO, ZERO, clamp_uniform, root_double

_ROOT_PI = wp.constant(wp.float64(1.7724538509055160))
_HALF_INV_ROOT_PI = wp.constant(wp.float64(0.28209479177387814))
_HALF_CELL = wp.constant(wp.float64(0.5 / GRID))
_STEEPEST = wp.constant(wp.float64(6.0))  # largest slope in units of alpha that a variate below 1 can give
_FROM_ABOVE = wp.constant(wp.float64(1e12))
_SIXTH = wp.constant(wp.float64(1.0 / 6.0))
# Constants of the first approximation in `slope_along_view`, found by trial: two steps suffice for all views and variates.
_MOVED = wp.constant(wp.float64(0.45))
_BENT = wp.constant(wp.float64(0.6))
_TINY = wp.constant(wp.float64(1e-12))


@wp.func
def slope_view(alpha: wp.float32, view: wp.vec3) -> wp.vec4d:
    """Return numbers that describe the view relative to the roughness: (cot v / alpha, alpha sin v, cos phi, sin phi).

    Normals with a slope below -a along the view, in units of alpha, face away. A view along +z has no azimuth; the gradient
    with respect to the view's x and y is 0 there.
    """
    x = wp.float64(view[0])
    y = wp.float64(view[1])
    across = root_double(x * x + y * y)
    if across < _TINY:
        return wp.vec4d(wp.float64(view[2]) / (wp.float64(alpha) * _TINY), wp.float64(alpha) * _TINY, ONE, ZERO)
    return wp.vec4d(wp.float64(view[2]) / (wp.float64(alpha) * across), wp.float64(alpha) * across, x / across, y / across)


@wp.func
def visible_share_above(x: wp.float64, a: wp.float64) -> wp.float64:
    """Integrate (a + s) e^(-s^2) / sqrt(pi) over s from x to infinity: the visible area of slopes above x."""
    tail = erfc_double(x)
    return HALF * a * tail[0] + _HALF_INV_ROOT_PI * tail[1]


@wp.func
def _refine_slope(x: wp.float64, target: wp.float64, a: wp.float64) -> wp.float64:
    """Refine a slope x towards visible_share_above(x, a) = target by one fourth-order step of Householder's method."""
    tail = erfc_double(x)
    s = a + x
    excess = HALF * a * tail[0] + _HALF_INV_ROOT_PI * tail[1] - target
    q = excess * _ROOT_PI / (s * s * tail[1])  # Newton's step divided by s
    bend = ONE - TWO * x * s  # s p' / p for the density p(x) = s e^(-x^2)
    curl = bend * bend - ONE - TWO * s * s  # s^2 p'' / p
    return x + s * q * (ONE + HALF * q * bend) / (ONE + q * (bend + _SIXTH * q * curl))


@wp.func
def slope_along_view(rest: wp.float64, a: wp.float64) -> wp.float64:
    """Return the slope along the view, in units of alpha, above which the fraction `rest` of the visible area lies.

    Two Householder steps refine the largest of three approximations: the quantile of a normal distribution, shifted for the
    weight a + s (views from above); the quantile of a Rayleigh distribution (grazing views); and a square-root series (the
    lowest visible slopes). The approximation is wrong by at most a third of a + s, the result by 1e-8 of a + s. Float32 is
    precise enough for roots and logarithms. There are no branches, so that loops vectorise.
    """
    lowest = wp.min(a, _STEEPEST)
    all = visible_share_above(-lowest, a)
    normal = wp.float64(erfc_inverse_roughly(rest * erfc_double(-lowest)[0]))
    rayleigh = wp.float64(wp.sqrt(-logarithm(wp.float32(rest)))) - a
    per_share = TWO * _ROOT_PI * all * exp_double(lowest * lowest)[1]
    rise = wp.float64(wp.sqrt(wp.float32((ONE - rest) * per_share)))
    above = a + normal
    normal += _MOVED * above / (above * above + ONE)
    x = wp.max(wp.max(normal, rayleigh), rise / (ONE + _BENT * lowest * rise) - lowest)
    return _refine_slope(_refine_slope(x, rest * all, a), rest * all, a)


@wp.func_grad(slope_along_view)
def _adj_slope_along_view(rest: wp.float64, a: wp.float64, adj_ret: wp.float64):
    # Derivative of the equation visible_share_above(x, a) = rest * visible_share_above(low, a), not of the iteration.
    x = slope_along_view(rest, a)
    low = -wp.min(a, _STEEPEST)
    per_share = adj_ret * _ROOT_PI * wp.exp(x * x) / wp.max(a + x, _TINY)
    wp.adjoint[rest] -= per_share * visible_share_above(low, a)
    wp.adjoint[a] += per_share * HALF * (erfc_double(x)[0] - rest * erfc_double(low)[0])


@wp.func
def gaussian_slope(v: wp.float32) -> wp.float64:
    """Return the quantile of the density e^(-s^2) / sqrt(pi) at the probability v + 2^-25.

    v is a multiple of 2^-24, and v + 2^-25 the middle of the cell that v represents.
    """
    rest = ONE - wp.float64(v) - _HALF_CELL
    return _refine_slope(wp.float64(erfc_inverse_roughly(TWO * rest)), rest * _FROM_ABOVE, _FROM_ABOVE)


@wp.func_grad(gaussian_slope)
def _adj_gaussian_slope(v: wp.float32, adj_ret: wp.float64):
    y = gaussian_slope(v)
    wp.adjoint[v] += wp.float32(adj_ret * _ROOT_PI * wp.exp(y * y))


@wp.func
def square_to_visible_beckmann(u: wp.vec2, alpha: wp.float32, view: wp.vec3) -> wp.vec3:
    """Map a point of the unit square to a Beckmann normal about +z that is visible from the direction `view`.

    u[0] gives the slope along the view, u[1] the slope across the view, both in units of alpha.
    """
    v = slope_view(alpha, view)
    along = slope_along_view(ONE - wp.float64(u[0]) - _HALF_CELL, v[0]) * wp.float64(alpha)
    aside = gaussian_slope(u[1]) * wp.float64(alpha)
    inverse = ONE / wp.sqrt(ONE + along * along + aside * aside)
    return wp.vec3(
        wp.float32((along * v[2] - aside * v[3]) * inverse),
        wp.float32((along * v[3] + aside * v[2]) * inverse),
        wp.float32(inverse),
    )


@wp.func
def square_to_visible_beckmann_pdf(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the visible Beckmann normal m = w, per steradian; 0 where m faces away or is below the surface.

    The density is (v.m) D(m) / area for the view v. The visible area is that of slopes above -a, times alpha sin v. The
    horizon of the view, v.m = 0, is blurred as in `square_to_visible_ggx_pdf`.
    """
    x = wp.float64(w[0])
    y = wp.float64(w[1])
    square = wp.float64(alpha) * wp.float64(alpha)
    return _density(w, x * x + y * y, square, slope_view(alpha, view), blurred_facing(w, view))


@wp.func
def visible_beckmann_per_cosine(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the visible Beckmann normal m = w, divided by v.m for the view v; 0 below the surface."""
    x = wp.float64(w[0])
    y = wp.float64(w[1])
    square = wp.float64(alpha) * wp.float64(alpha)
    return _density(w, x * x + y * y, square, slope_view(alpha, view), 1.0)


@wp.func
def _density(w: wp.vec3, across: wp.float64, square: wp.float64, v: wp.vec4d, facing: wp.float32) -> wp.float32:
    """Return the density of a visible Beckmann normal w with the squared slope `across` / w.z^2.

    v is the view by `slope_view`, and `facing` the cosine of normal and view.
    """
    z = wp.max(wp.float64(w[2]), _TINY)
    area = v[1] * visible_share_above(-v[0], v[0])
    cosine_squared = z * z
    spread = exp_double(-across / (cosine_squared * square))[1]
    normals = spread * INV_PI_DOUBLE / (square * cosine_squared * cosine_squared)
    return wp.where(facing > 0.0 and w[2] > 0.0, wp.float32(wp.float64(facing) * normals / area), 0.0)


@wp.func
def visible_beckmann_to_square(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_visible_beckmann` maps to the direction w.

    u[0] is the fraction of the visible area with smaller slopes along the view, u[1] of the slopes across the view.
    """
    v = slope_view(alpha, view)
    per_z = ONE / (wp.float64(alpha) * wp.max(wp.float64(w[2]), _TINY))
    along = (wp.float64(w[0]) * v[2] + wp.float64(w[1]) * v[3]) * per_z
    aside = (wp.float64(w[1]) * v[2] - wp.float64(w[0]) * v[3]) * per_z
    rest = visible_share_above(along, v[0]) / visible_share_above(-wp.min(v[0], _STEEPEST), v[0])
    return wp.vec2(
        clamp_uniform(wp.float32(ONE - rest - _HALF_CELL)),
        clamp_uniform(wp.float32(HALF * erfc_double(-aside)[0] - _HALF_CELL)),
    )


@wp.func
def square_to_anisotropic_visible_beckmann(u: wp.vec2, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.vec3:
    """Map a point of the unit square to a visible Beckmann normal about +z, of roughness alpha along x and alpha_y along y.

    The isotropic map for the mean roughness and the stretched view gives a normal, which is stretched (Heitz2014).
    """
    m = mean_and_stretch(alpha, alpha_y)
    return stretched_to_unit(square_to_visible_beckmann(u, m[0], stretched(view, m)), m)


@wp.func
def square_to_anisotropic_visible_beckmann_pdf(
    w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3
) -> wp.float32:
    """Return the density of the anisotropic visible Beckmann normal m = w, per steradian.

    It is that of `square_to_visible_beckmann_pdf` with the D of the two roughnesses, and sqrt((alpha v.x)^2 +
    (alpha_y v.y)^2) in place of alpha sin v. It is 0 where m faces away or is below the surface.
    """
    x, y = wp.float64(w[0]), wp.float64(w[1])
    ratio = wp.float64(alpha_y) / wp.float64(alpha)
    across = x * x * ratio + y * y / ratio
    m = mean_and_stretch(alpha, alpha_y)
    square = wp.float64(alpha) * wp.float64(alpha_y)
    return _density(w, across, square, slope_view(m[0], stretched(view, m)), blurred_facing(w, view))


@wp.func
def anisotropic_visible_beckmann_per_cosine(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the anisotropic visible Beckmann normal m = w, divided by v.m for the view v."""
    x, y = wp.float64(w[0]), wp.float64(w[1])
    ratio = wp.float64(alpha_y) / wp.float64(alpha)
    m = mean_and_stretch(alpha, alpha_y)
    square = wp.float64(alpha) * wp.float64(alpha_y)
    return _density(w, x * x * ratio + y * y / ratio, square, slope_view(m[0], stretched(view, m)), 1.0)


@wp.func
def anisotropic_visible_beckmann_to_square(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_anisotropic_visible_beckmann` maps to the direction w."""
    m = mean_and_stretch(alpha, alpha_y)
    return visible_beckmann_to_square(contracted(w, m), m[0], stretched(view, m))


class VisibleBeckmann(VisibleNormals):
    """Distribution of Beckmann normals m visible from a direction v, with density D(m) max(0, v·m) / σ(v) per steradian.

    σ(v) is the projected area of the visible surface.

    Attributes:
        alpha: roughness, from 1e-6 to 1. With `alpha_y`, the roughness along the x axis of the frame.
        view: direction v to the viewer in the local frame, at or above the surface, of any length; stored as a unit vector.
        alpha_y: roughness along the y axis of the frame, from 1e-6 to 1. Default: that along x.
    """

    name = "visible_beckmann"
    density = "D(m)max(0,v·m)/σ(v), σ=(v_z(1+erf a)+ρe^(−a²)/√π)/2, ρ=√(α_x²v_x²+α_y²v_y²), a=v_z/ρ"
    source = "HeitzDEon2014, section 5; Walter2007, equation 25"
    limits = "the density is blurred by rounding at the horizon of the view, v·m = 0"
    # Views from above, from the side and from the horizon; then brushed surfaces.
    case_values: ClassVar[Cases] = (
        (0.5, (0.0, 0.0, 1.0)),
        (0.3, (0.6, -0.64, 0.48)),
        (1.0, (1.0, 0.0, 0.0)),
        (1e-6, (1.0, 0.0, 0.0)),
        (0.3, (0.6, -0.64, 0.48), 0.1),
        (0.01, (0.6, 0.0, 0.8), 0.5),
    )
    isotropic: ClassVar[Maps] = Maps(
        square_to_visible_beckmann,
        square_to_visible_beckmann_pdf,
        visible_beckmann_to_square,
        per_cosine=visible_beckmann_per_cosine,
    )
    anisotropic: ClassVar[Maps] = Maps(
        square_to_anisotropic_visible_beckmann,
        square_to_anisotropic_visible_beckmann_pdf,
        anisotropic_visible_beckmann_to_square,
        per_cosine=anisotropic_visible_beckmann_per_cosine,
    )


RECORD = VisibleBeckmann
