"""Complementary error function and a rough inverse, in plain arithmetic that vectorises; float64 uses half the lanes."""

from math import pi

import warp as wp

from warpsample.maths.exponentials import exp_double, logarithm
from warpsample.maths.numerics import ONE, TWO, ZERO, fma_double

BEYOND = 6.5
"""Magnitude from which the error function is taken to have reached its limit, from which it then differs by 4e-20."""

_BEYOND = wp.constant(wp.float64(BEYOND))
_MIDDLE = wp.constant(wp.float64(3.75))
# (1 + 2x) e^(x^2) erfc(x) by powers of (x - 3.75) / (x + 3.75), for x from 0 to 6.5: interpolated at Chebyshev's points.
_POWERS = (
    *(1.2375126308378301, -0.14024059858549762, 0.003585415484176921, 0.08227673847932263, -0.10880393004707622),
    *(0.09230432191894905, -0.05869340021446876, 0.02836225585251061, -0.009746600916533904, 0.0017558486997220457),
    *(0.00029444376673006347, -0.00029001497089464756, 4.797270313834018e-05, 1.2839436784108025e-05),
    *(-2.3488761996589714e-05, -9.395247957634652e-06, -1.047268859454696e-06),
)
_TWO_BY_ROOT_PI = wp.constant(wp.float64(2.0 / pi**0.5))
_WINITZKI = wp.constant(wp.float32(0.147))
_TWO_BY_PI_A = wp.constant(wp.float32(2.0 / (pi * 0.147)))


@wp.func
def erfc_double(x: wp.float64) -> wp.vec2d:
    """Return (erfc(x), e^(-x^2)) for x clamped to [-6.5, 6.5]; worst relative error 2e-14.

    The polynomial is in the variable of Shepherd1981, in which erfc(x) e^(x^2) is almost linear.
    """
    x = wp.clamp(x, -_BEYOND, _BEYOND)
    y = wp.abs(x)
    bell = exp_double(-y * y)[1]
    both = ONE / ((y + _MIDDLE) * (ONE + TWO * y))
    t = (y - _MIDDLE) * (ONE + TWO * y) * both
    series = ZERO
    for i in range(17):
        series = fma_double(series, t, wp.float64(wp.static(_POWERS[16 - i])))
    tail = series * (y + _MIDDLE) * both * bell
    return wp.vec2d(wp.where(x < ZERO, TWO - tail, tail), bell)


@wp.func_grad(erfc_double)
def _adj_erfc_double(x: wp.float64, adj_ret: wp.vec2d):
    if wp.abs(x) < _BEYOND:
        bell = wp.exp(-x * x)
        wp.adjoint[x] -= bell * (_TWO_BY_ROOT_PI * adj_ret[0] + TWO * x * adj_ret[1])


@wp.func
def erfc_inverse_roughly(share: wp.float64) -> wp.float32:
    """Return x with erfc(x) = share, to a relative error of 0.003, for a share in (0, 2); a starting value for iterations.

    Winitzki2008, equation 7, rearranged so that no difference cancels.
    """
    tail = wp.float32(wp.min(share, TWO - share))
    depth = -logarithm(tail * (2.0 - tail))
    b = _TWO_BY_PI_A - 0.5 * depth
    square = depth / (_WINITZKI * (b + wp.sqrt(b * b + depth / _WINITZKI)))
    return wp.where(share > ONE, -1.0, 1.0) * wp.sqrt(wp.max(square, 0.0))
