"""Beckmann normals as a viewer sees them: weighted by the area that each shows to the view."""

from typing import ClassVar

import warp as wp

from warpsample.distributions.record import Cases, Maps
from warpsample.distributions.visible_ggx import VisibleNormals, blurred_facing
from warpsample.maths.error_function import erfc_double, erfc_inverse_roughly
from warpsample.maths.exponentials import exp_double, logarithm
from warpsample.maths.numerics import GRID, HALF, INV_PI_DOUBLE, ONE, TWO, ZERO, clamp_uniform, root_double

_ROOT_PI = wp.constant(wp.float64(1.7724538509055160))
_HALF_INV_ROOT_PI = wp.constant(wp.float64(0.28209479177387814))
_HALF_CELL = wp.constant(wp.float64(0.5 / GRID))
_STEEPEST = wp.constant(wp.float64(6.0))  # no slope of the grid's variates is steeper, in units of alpha
_FROM_ABOVE = wp.constant(wp.float64(1e12))
_SIXTH = wp.constant(wp.float64(1.0 / 6.0))
# Of the start of `slope_along_view`: by trial over all views, so that two steps suffice for every variate.
_MOVED = wp.constant(wp.float64(0.45))
_BENT = wp.constant(wp.float64(0.6))
_TINY = wp.constant(wp.float64(1e-12))


@wp.func
def slope_view(alpha: wp.float32, view: wp.vec3) -> wp.vec4d:
    """(cos v / (alpha sin v), the slope at which normals face away; alpha sin v; cosine and sine of the azimuth).

    A view along +z has no azimuth; by the view's x and y the gradient there is 0.
    """
    x = wp.float64(view[0])
    y = wp.float64(view[1])
    across = root_double(x * x + y * y)
    if across < _TINY:
        return wp.vec4d(wp.float64(view[2]) / (wp.float64(alpha) * _TINY), wp.float64(alpha) * _TINY, ONE, ZERO)
    return wp.vec4d(wp.float64(view[2]) / (wp.float64(alpha) * across), wp.float64(alpha) * across, x / across, y / across)


@wp.func
def visible_share_above(x: wp.float64, a: wp.float64) -> wp.float64:
    """The integral from x to infinity of (a + s) e^(-s^2) / sqrt(pi): what the view sees of slopes above x."""
    tail = erfc_double(x)
    return HALF * a * tail[0] + _HALF_INV_ROOT_PI * tail[1]


@wp.func
def _refine_slope(x: wp.float64, target: wp.float64, a: wp.float64) -> wp.float64:
    """A slope closer to that above which the view sees the target: a step of Householder's method, of fourth order."""
    tail = erfc_double(x)
    s = a + x
    excess = HALF * a * tail[0] + _HALF_INV_ROOT_PI * tail[1] - target
    q = excess * _ROOT_PI / (s * s * tail[1])  # Newton's step by s
    bend = ONE - TWO * x * s  # s p' / p of the density p(x) = s e^(-x^2)
    curl = bend * bend - ONE - TWO * s * s  # s^2 p'' / p
    return x + s * q * (ONE + HALF * q * bend) / (ONE + q * (bend + _SIXTH * q * curl))


@wp.func
def slope_along_view(rest: wp.float64, a: wp.float64) -> wp.float64:
    """The slope above which the view sees the share `rest`.

    Two steps from the greatest of three slopes, each near the answer elsewhere: that of a normal distribution, moved as the
    weight a + s moves it, for a steep view; that of Rayleigh's, for a flat one; and a root's series where the lowest visible
    slopes begin. It is off by a third of a + s at most, and after the steps by 1e-8 of it. Roots and logarithms are precise
    enough in float32, and no branch is taken, so that loops vectorise.
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
    # Of share above x = rest * share above the lowest slope, which does not depend on the way there.
    x = slope_along_view(rest, a)
    low = -wp.min(a, _STEEPEST)
    per_share = adj_ret * _ROOT_PI * wp.exp(x * x) / wp.max(a + x, _TINY)
    wp.adjoint[rest] -= per_share * visible_share_above(low, a)
    wp.adjoint[a] += per_share * HALF * (erfc_double(x)[0] - rest * erfc_double(low)[0])


@wp.func
def gaussian_slope(v: wp.float32) -> wp.float64:
    """The slope below which lies the share v (at its cell's middle) of e^(-s^2) / sqrt(pi), as seen from above."""
    rest = ONE - wp.float64(v) - _HALF_CELL
    return _refine_slope(wp.float64(erfc_inverse_roughly(TWO * rest)), rest * _FROM_ABOVE, _FROM_ABOVE)


@wp.func_grad(gaussian_slope)
def _adj_gaussian_slope(v: wp.float32, adj_ret: wp.float64):
    y = gaussian_slope(v)
    wp.adjoint[v] += wp.float32(adj_ret * _ROOT_PI * wp.exp(y * y))


@wp.func
def square_to_visible_beckmann(u: wp.vec2, alpha: wp.float32, view: wp.vec3) -> wp.vec3:
    """Slopes along and across the view, scaled back by alpha."""
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
    """(v.m) D(m) / area per steradian where v.m > 0 and m above the surface, else 0; the horizon as for GGX.

    The visible area is that of slopes above -a, times alpha sin v.
    """
    v = slope_view(alpha, view)
    x = wp.float64(w[0])
    y = wp.float64(w[1])
    z = wp.max(wp.float64(w[2]), _TINY)
    square = wp.float64(alpha) * wp.float64(alpha)
    facing = blurred_facing(w, view)
    area = v[1] * visible_share_above(-v[0], v[0])
    cosine_squared = z * z
    spread = exp_double(-(x * x + y * y) / (cosine_squared * square))[1]
    normals = spread * INV_PI_DOUBLE / (square * cosine_squared * cosine_squared)
    return wp.where(facing > 0.0 and w[2] > 0.0, wp.float32(wp.float64(facing) * normals / area), 0.0)


@wp.func
def visible_beckmann_to_square(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.vec2:
    """The shares of slopes below, along and across the view."""
    v = slope_view(alpha, view)
    per_z = ONE / (wp.float64(alpha) * wp.max(wp.float64(w[2]), _TINY))
    along = (wp.float64(w[0]) * v[2] + wp.float64(w[1]) * v[3]) * per_z
    aside = (wp.float64(w[1]) * v[2] - wp.float64(w[0]) * v[3]) * per_z
    rest = visible_share_above(along, v[0]) / visible_share_above(-wp.min(v[0], _STEEPEST), v[0])
    return wp.vec2(
        clamp_uniform(wp.float32(ONE - rest - _HALF_CELL)),
        clamp_uniform(wp.float32(HALF * erfc_double(-aside)[0] - _HALF_CELL)),
    )


class VisibleBeckmann(VisibleNormals):
    """Beckmann normals visible from a direction: D(m) max(0, v·m) / σ(v) per steradian, σ the area that the view sees.

    Attributes:
        alpha: roughness, from 1e-6 to 1.
        view: direction to the viewer in the local frame, at or above the surface, of any length; kept as a unit vector.
    """

    name = "visible_beckmann"
    density = "D(m)max(0,v·m)/σ(v), σ=(v_z(1+erf a)+α sinθᵥ e^(−a²)/√π)/2, a=cotθᵥ/α"
    source = "HeitzDEon2014, section 5; Walter2007, equation 25"
    limits = "the horizon of the view is blurred by rounding"
    # From above, from the side, from the horizon.
    case_values: ClassVar[Cases] = (
        (0.5, (0.0, 0.0, 1.0)),
        (0.3, (0.6, -0.64, 0.48)),
        (1.0, (1.0, 0.0, 0.0)),
        (1e-6, (1.0, 0.0, 0.0)),
    )
    maps: ClassVar[Maps] = Maps(square_to_visible_beckmann, square_to_visible_beckmann_pdf, visible_beckmann_to_square)


RECORD = VisibleBeckmann
