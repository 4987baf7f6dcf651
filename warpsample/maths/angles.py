"""Angles of a direction: the azimuth, and functions of the angle to +z."""

from math import factorial

import warp as wp

from warpsample.maths.numerics import HALF, INV_TWO_PI_DOUBLE, ONE, TWO, ZERO, fma_double

_EIGHTH = wp.constant(wp.float64(0.125))
_QUARTER = wp.constant(wp.float64(0.25))
# Terms of cos 2 pi x and sin 2 pi x, by the power of x.
_TAYLOR = tuple((-1.0) ** (n // 2) * 6.283185307179586**n / factorial(n) for n in range(16))
# Terms of cos x and of sin x / x in x^2.
_COSINE = tuple((-1.0) ** n / factorial(2 * n) for n in range(12))
_SINE = tuple((-1.0) ** n / factorial(2 * n + 1) for n in range(12))
# Cephes' atan: a quotient of polynomials in x^2, from the highest power on.
_ATAN_OVER = (-0.8750608600031904, -16.157537187333652, -75.00855792314705, -122.88666844901361, -64.85021904942025)
_ATAN_UNDER = (1.0, 24.858464901423062, 165.02700983169885, 432.88106049129027, 485.3903996359137, 194.5506571482614)
_TAN_EIGHTH = wp.constant(wp.float64(0.41421356237309503))
_QUARTER_PI = wp.constant(wp.float64(0.7853981633974483))
_HALF_PI = wp.constant(wp.float64(1.5707963267948966))
_PI = wp.constant(wp.float64(3.141592653589793))
_LEAST = wp.constant(wp.float64(1e-300))
_POLE = wp.constant(wp.float32(1e-30))  # closer to the pole the azimuth's gradient overflows float32
_TINY = wp.constant(wp.float64(1e-90))
_LARGEST_TAN_SQUARED = wp.constant(wp.float64(1e37))


@wp.func
def turns_of(x: wp.float32, y: wp.float32) -> wp.float32:
    """Return the azimuth of the vector (x, y) divided by 2 pi, in [0, 1); worst absolute error 6e-8.

    At the origin the azimuth and its gradient are 0. The method is atan2 without branches: the angle is reduced
    to an octant, then to [0, tan(pi/8)], where the polynomial of Cephes' atanf is used.
    """
    ax = wp.abs(x)
    ay = wp.abs(y)
    longer = wp.max(wp.max(ax, ay), 1.0e-38)
    r = wp.min(ax, ay) / longer
    outer = r > 0.41421357
    r = wp.where(outer, (r - 1.0) / (r + 1.0), r)
    t = r * r
    a = r * (0.15915494 + t * (-0.053051636 + t * (0.031805573 + t * (-0.022112465 + t * 0.012850129))))
    a = wp.where(outer, 0.125 + a, a)
    a = wp.where(ay > ax, 0.25 - a, a)
    a = wp.where(x < 0.0, 0.5 - a, a)
    a = wp.where(y < 0.0, 1.0 - a, a)
    return wp.where(a >= 1.0, 0.0, a)


@wp.func_grad(turns_of)
def _adj_turns_of(x: wp.float32, y: wp.float32, adj_ret: wp.float32):
    # The derivative of the azimuth itself. The polynomial's derivative is less precise, and undefined between octants.
    dx, dy = wp.float64(x), wp.float64(y)
    turn = INV_TWO_PI_DOUBLE * wp.float64(adj_ret) / (dx * dx + dy * dy)
    if wp.max(wp.abs(x), wp.abs(y)) > _POLE:
        wp.adjoint[x] -= wp.float32(dy * turn)
        wp.adjoint[y] += wp.float32(dx * turn)


@wp.func
def sincos_turns_double(u: wp.float64) -> wp.vec2d:
    """Return (cos 2 pi u, sin 2 pi u) for u in [0, 1] in float64; worst absolute error 1e-12, without libm calls.

    u is reduced to an eighth of a turn as in `sincos_turns`, where both series of Taylor converge.
    """
    half = HALF - u
    x = wp.abs(half) - _QUARTER
    y = wp.abs(x)
    nearer = y < _EIGHTH
    turned = wp.where(nearer, y, _QUARTER - y)
    t = turned * turned
    c = ZERO
    s = ZERO
    for i in range(8):
        c = fma_double(c, t, wp.float64(wp.static(_TAYLOR[14 - 2 * i])))
        s = fma_double(s, t, wp.float64(wp.static(_TAYLOR[15 - 2 * i])))
    s = s * turned
    return wp.vec2d(wp.copysign(wp.where(nearer, s, c), x), wp.copysign(wp.where(nearer, c, s), half))


@wp.func
def sincos_double(x: wp.float64) -> wp.vec2d:
    """Return (cos x, sin x) for x in [0, 2 pi] radians in float64, without libm calls; worst absolute error 1e-15.

    The sine keeps its relative precision towards x = 0. Both series of Taylor converge at a quarter of x, which is doubled
    twice.
    """
    quarter = _QUARTER * x
    t = quarter * quarter
    c = ZERO
    s = ZERO
    for i in range(12):
        c = fma_double(c, t, wp.float64(wp.static(_COSINE[11 - i])))
        s = fma_double(s, t, wp.float64(wp.static(_SINE[11 - i])))
    s = s * quarter
    half = TWO * s * c
    return wp.vec2d(ONE - TWO * half * half, TWO * half * (ONE - TWO * s * s))


@wp.func
def arctan2_double(y: wp.float64, x: wp.float64) -> wp.float64:
    """Return the angle of (x, y) to the x axis in radians, in [0, pi], for y at least 0; worst relative error 4e-16.

    The angle is reduced as in `turns_of`, without branches and libm calls.
    """
    ax = wp.abs(x)
    r = wp.min(ax, y) / wp.max(wp.max(ax, y), _LEAST)
    outer = r > _TAN_EIGHTH
    r = wp.where(outer, (r - ONE) / (r + ONE), r)
    t = r * r
    over = ZERO
    under = ZERO
    for i in range(5):
        over = fma_double(over, t, wp.float64(wp.static(_ATAN_OVER[i])))
    for i in range(6):
        under = fma_double(under, t, wp.float64(wp.static(_ATAN_UNDER[i])))
    a = fma_double(r * t, over / under, r)
    a = wp.where(outer, _QUARTER_PI + a, a)
    a = wp.where(y > ax, _HALF_PI - a, a)
    return wp.where(x < ZERO, _PI - a, a)


@wp.func_grad(arctan2_double)
def _adj_arctan2_double(y: wp.float64, x: wp.float64, adj_ret: wp.float64):
    square = wp.max(x * x + y * y, _LEAST)
    wp.adjoint[y] += x / square * adj_ret
    wp.adjoint[x] -= y / square * adj_ret


@wp.func
def sin_squared(w: wp.vec3) -> wp.float64:
    """Return sin^2 of the angle between w and +z, for w of any length, in float64 to keep the precision of w."""
    x, y, z = wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2])
    across = x * x + y * y
    return across / (across + z * z)


@wp.func
def tan_squared(w: wp.vec3) -> wp.float64:
    """Return tan^2 of the angle between w and +z, at most 1e37; 1 / z^2 - 1 would lose precision near the pole."""
    x, y, z = wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2])
    return quotient_of_squares(x * x + y * y, z)


@wp.func
def quotient_of_squares(across: wp.float64, z: wp.float64) -> wp.float64:
    """Return the quotient `across` / z^2, limited to 1e37."""
    return wp.min(across / wp.max(z * z, _TINY), _LARGEST_TAN_SQUARED)


@wp.func
def versine(w: wp.vec3) -> wp.float64:
    """Return 1 - cos of the angle between w and +z, precise near both poles."""
    x, y, z = wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2])
    across = x * x + y * y
    length = wp.sqrt(across + z * z)
    near = across / (length * (length + wp.abs(z)))
    return wp.where(z > ZERO, near, TWO - near)
