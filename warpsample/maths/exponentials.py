"""Logarithm and exponential that vectorise, in float32 and, for densities, in float64.

A density e^-s at the largest variate below 1 has s = 17. The relative error of the density is 17 times that of s, too large
in float32. The float64 forms are plain arithmetic, too, and use half the lanes.
"""

from math import factorial

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, fma_double

_ONE_BITS = wp.constant(wp.int32(0x3F800000))
_SQRT_HALF_BITS = wp.constant(wp.int32(0x3F3504F3))
_MANTISSA_MASK = wp.constant(wp.int32(0x007FFFFF))
_LN_2 = wp.constant(wp.float64(0.6931471805599453))
_LOG2_E = wp.constant(wp.float64(1.4426950408889634))
_LEAST_EXPONENT = wp.constant(wp.float64(-170.0))


@wp.func
def _split(x: wp.float32):
    """Split a normal x above 0 into (k, mantissa) with x = 2^k mantissa and the mantissa in [sqrt(1/2), sqrt(2))."""
    bits = wp.cast(x, wp.int32) + _ONE_BITS - _SQRT_HALF_BITS
    return wp.float32((bits >> 23) - 127), wp.cast((bits & _MANTISSA_MASK) + _SQRT_HALF_BITS, wp.float32)


@wp.func
def _log_of(k: wp.float32, f: wp.float32, c: wp.float32) -> wp.float32:
    """Return log(2^k (1 + f)) + c, with c a small correction for the rounding error of f."""
    s = f / (2.0 + f)
    z = s * s
    r = z * (0.6666666 + z * (0.40000972 + z * (0.28498787 + z * 0.24279079)))
    half_square = 0.5 * f * f
    return k * 0.69313812 - ((half_square - (s * (half_square + r) + (k * 9.0580006e-06 + c))) - f)


@wp.func
def logarithm(x: wp.float32) -> wp.float32:
    """Return log(x) of a normal x above 0, by the polynomial of `log1p`."""
    k, mantissa = _split(x)
    return _log_of(k, mantissa - 1.0, 0.0)


@wp.func
def log1p(x: wp.float32) -> wp.float32:
    """Return log(1 + x) for x > -1; worst relative error 8.1e-8, also for the smallest x.

    The method is s_log1pf.c of FreeBSD's msun, with selects in place of branches: 1 + x = 2^k (1 + f) with 1 + f in
    [sqrt(1/2), sqrt(2)), and c corrects the rounding error of the sum 1 + x.
    """
    one_plus_x = 1.0 + x
    near = wp.abs(x) < 0.29
    k, mantissa = _split(one_plus_x)
    c = (x - (one_plus_x - 1.0)) / one_plus_x
    return _log_of(wp.where(near, 0.0, k), wp.where(near, x, mantissa - 1.0), wp.where(near, 0.0, c))


@wp.func_grad(log1p)
def _adj_log1p(x: wp.float32, adj_ret: wp.float32):
    # The forward function reads the mantissa from the bits, which have no gradient.
    wp.adjoint[x] += adj_ret / (1.0 + x)


@wp.func
def log1p_double(x: wp.float64) -> wp.float64:
    """Return log(1 + x) for 1 + x in [1e-37, 1e38], in float64.

    1 + x = 2^k (1 + f), where k is the exponent of the sum rounded to float32; log(1 + f) = 2 atanh(f / (2 + f)) by its
    series. Worst relative error 2e-15, and 1e-13 where abs(x) is below the smallest normal float32.
    """
    sum = ONE + x
    bits = wp.cast(wp.float32(sum), wp.int32) + _ONE_BITS - _SQRT_HALF_BITS
    k = (bits >> 23) - 127
    f = wp.where(k == 0, x, sum * wp.float64(wp.cast((127 - k) << 23, wp.float32)) - ONE)
    s = f / (TWO + f)
    z = s * s
    series = wp.float64(0.0)
    for i in range(9):
        series = fma_double(series, z, wp.float64(wp.static(1.0 / (17 - 2 * i))))
    return wp.float64(k) * _LN_2 + TWO * s * series


@wp.func_grad(log1p_double)
def _adj_log1p_double(x: wp.float64, adj_ret: wp.float64):
    wp.adjoint[x] += adj_ret / (ONE + x)


@wp.func
def exp_double(x: wp.float64) -> wp.vec2d:
    """Return (e^x - 1, e^x) for x <= 175 in float64; worst relative error 2e-14.

    Below -170, x counts as -170, for which e^x is 0 in float32. x = k ln 2 + r, and e^r - 1 is a Taylor series, so that
    e^x - 1 keeps its digits near 0.
    """
    x = wp.max(x, _LEAST_EXPONENT)
    k = wp.floor(x * _LOG2_E + HALF)
    r = fma_double(-k, _LN_2, x)
    series = wp.float64(0.0)
    for i in range(12):
        series = fma_double(series, r, wp.float64(wp.static(1.0 / factorial(12 - i))))
    scale = wp.cast(wp.int64(1023 + wp.int32(k)) << wp.int64(52), wp.float64)
    return wp.vec2d(scale * r * series + (scale - ONE), scale * r * series + scale)


@wp.func_grad(exp_double)
def _adj_exp_double(x: wp.float64, adj_ret: wp.vec2d):
    if x > _LEAST_EXPONENT:
        wp.adjoint[x] += exp_double(x)[1] * (adj_ret[0] + adj_ret[1])
