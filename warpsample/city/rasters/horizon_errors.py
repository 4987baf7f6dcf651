"""Standard errors of horizons: sums over the azimuths of a point, and the variance that follows from them.

The terms of the variance are explained in README.md.
"""

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO

Sums = wp.types.vector(length=11, dtype=wp.float64)
"""Sums over the azimuths of a point, and values of the latest azimuth that are compared with the next azimuth."""
SEEN, _JUMPS, _SPIKES, _WIDTHS = (wp.constant(wp.int32(row)) for row in range(4))
_LOW, _HIGH, _JUMP, _RUN = (wp.constant(wp.int32(row)) for row in range(4, 8))  # sines, jump, azimuths of equal intervals
_RANGE = wp.constant(wp.int32(8))  # sum of the widths of the final intervals, for the term of few open azimuths
_SQUARES = wp.constant(wp.int32(9))  # sum of the squares of the azimuths' values, for the same term
_CHANGE = wp.constant(wp.int32(10))  # largest change of the visible fraction from an azimuth to the next, at least

# Factors of the terms of the variance, see README.md. They are fitted to towns, terrain, yards, and cells close to masts
# and walls (`tests/city/test_horizon_errors.py` checks the fit on other scenes).
_OF_JUMP = wp.constant(wp.float64(1.0 / 16.0))
_OF_SPIKE = wp.constant(wp.float64(0.35))
_OF_WIDTH = wp.constant(wp.float64(0.1))
_OF_WIDTH_BY_FEW = wp.constant(wp.float64(0.5))
_OF_WIDTH_IN_A_RUN = wp.constant(wp.float64(0.25))
_OF_WIDTH_IN_COURTS = wp.constant(wp.float64(0.08))
_OF_UNSEEN = wp.constant(wp.float64(0.6))
_OF_FEW = wp.constant(wp.float64(0.3))
# M, the term of slots whose ends few azimuths see, is for more azimuths than _FEWEST_AZIMUTHS and for sums of the azimuths'
# values below _LARGEST_SUM. It counts in full up to _AZIMUTHS_IN_FULL; with fewer than _AZIMUTHS_OF_SUM the sum counts more.
_FEWEST_AZIMUTHS = wp.constant(wp.float64(8.0))
_LARGEST_SUM = wp.constant(wp.float64(3.0))
_AZIMUTHS_IN_FULL = wp.constant(wp.float64(24.0))
_AZIMUTHS_OF_SUM = wp.constant(wp.float64(25.0))
_OF_SEVERAL = wp.constant(wp.float64(0.25))
_OF_OWN_PLANE = wp.constant(wp.float64(0.95))
_RUN_OF_TURN = wp.constant(wp.float64(1.0 / 8.0))
_LEAST_RUN = wp.constant(wp.float64(40.0))
_LEAST = wp.constant(wp.float64(1e-30))
_ROUNDING = wp.constant(wp.float64(2.0**-23))


@wp.func
def seen_above(sine: wp.float64, along: wp.float64, up: wp.float64, cosine: wp.int32) -> wp.float64:
    """Return the fraction of the sky that is visible in one azimuth above a horizon with the given sine of elevation.

    cosine = 0: 1 - s with the sine s of the horizon. Else up (1 - s^2) + along (acos(s) - s sqrt(1 - s^2)).
    """
    if cosine == 0:
        return ONE - sine
    seen = up * (ONE - sine * sine)
    if along != ZERO:
        seen += along * (wp.acos(sine) - sine * wp.sqrt(ONE - sine * sine))
    return seen


@wp.func
def _growth(run: wp.float64, azimuths: wp.float64) -> wp.float64:
    """Return what one more azimuth adds to the term of the last rays, after `run` azimuths of equal intervals."""
    if run > wp.max(_LEAST_RUN, _RUN_OF_TURN * azimuths):
        return _OF_WIDTH_IN_A_RUN
    return wp.sqrt(run + ONE) - wp.sqrt(run)


@wp.func
def add_azimuth(
    sums: Sums,
    azimuths: wp.float64,
    low: wp.float64,
    high: wp.float64,
    free: wp.bool,
    along: wp.float64,
    up: wp.float64,
    cosine: wp.int32,
) -> Sums:
    """Return the sums for value and variance with one more azimuth, whose horizon is between `low` and `high`.

    Args:
        sums: Sums over the preceding azimuths, in their order around the point.
        azimuths: Number of azimuths of the point.
        low, high: Sines of elevation.
        free: Whether the last ray hit nothing.
        along, up: Components of the normal along the azimuth and upwards.
        cosine: 1 for weights by the cosine to the normal, 0 for weights by solid angle.
    """
    middle = HALF * (low + high)
    above_low = seen_above(low, along, up, cosine)
    above_high = seen_above(high, along, up, cosine)
    seen = wp.where(free, above_low, above_high)
    sums[SEEN] += seen
    sums[_SQUARES] += seen * seen
    run = sums[_RUN]
    jump = ZERO
    before = HALF * (sums[_LOW] + sums[_HIGH])
    if run > ZERO and (before < low or before >= high):
        jump = seen_above(before, along, up, cosine) - seen_above(middle, along, up, cosine)
        run = ZERO
        if jump * sums[_JUMP] < ZERO:
            back = wp.min(wp.abs(jump), wp.abs(sums[_JUMP]))
            sums[_SPIKES] += back * back
        if low > sums[_HIGH]:
            sums[_CHANGE] = wp.max(sums[_CHANGE], seen_above(sums[_HIGH], along, up, cosine) - above_low)
        elif high < sums[_LOW]:
            sums[_CHANGE] = wp.max(sums[_CHANGE], above_high - seen_above(sums[_LOW], along, up, cosine))
    width = above_low - above_high
    sums[_RANGE] += width
    sums[_WIDTHS] += width * width * _growth(run, azimuths)
    sums[_JUMPS] += jump * jump
    sums[_LOW] = low
    sums[_HIGH] = high
    sums[_JUMP] = jump
    sums[_RUN] = run + ONE
    return sums


@wp.func
def variance_of(sums: Sums, azimuths: wp.float64, whole: wp.float64, depth: wp.float64, together: wp.float64) -> wp.float64:
    """Return the variance of a point's visible sky fraction, estimated from how its horizons vary between azimuths.

    whole: value of the receiver under an unobstructed sky.
    depth, together: bounds of what one azimuth and several azimuths may lose, from `bound_depths`.
    """
    gaps = azimuths / (azimuths - ONE)  # the last azimuth is not compared with the first
    change = sums[_CHANGE]
    jumps = gaps * (_OF_JUMP * (sums[_JUMPS] + change * change) + _OF_SPIKE * sums[_SPIKES])
    # In deep courtyards the last intervals are wider than all that is seen.
    deep = wp.clamp(sums[_RANGE] / wp.max(sums[SEEN], _LEAST) - ONE, ZERO, ONE)
    widths = (_OF_WIDTH + wp.max(_OF_WIDTH_BY_FEW / azimuths, _OF_WIDTH_IN_COURTS * deep)) * sums[_WIDTHS]
    if sums[_RUN] == azimuths and azimuths > _LEAST_RUN:  # equal intervals all around, as in a round pit
        widths *= TWO - deep
    value = sums[SEEN] / azimuths
    unseen = _OF_UNSEEN * value * wp.max(whole - value, ZERO) / azimuths
    unseen_ends = wp.max(ONE - sums[SEEN], ZERO)
    if azimuths > _FEWEST_AZIMUTHS:
        below = _LARGEST_SUM - sums[SEEN] * wp.max(ONE, _AZIMUTHS_OF_SUM / azimuths)
        unseen_ends = wp.max(unseen_ends, wp.min(ONE, _AZIMUTHS_IN_FULL / azimuths) * below)
    few = _OF_FEW * (sums[_SQUARES] + sums[_RANGE] / azimuths) * unseen_ends
    missed = wp.max(HALF * depth - change, ZERO)
    lost = wp.min(together * together, sums[_SQUARES])  # no azimuth loses what it does not see
    several = _OF_SEVERAL * lost - change * change
    largest = wp.max(wp.max(few, missed * missed), several)
    return wp.max(jumps + widths + unseen, largest) / (azimuths * azimuths)


@wp.func
def own_plane_error(n: wp.vec3, azimuths: wp.float64) -> wp.float64:
    """Return the standard error due to the edge of a tilted receiver's own plane with evenly spaced azimuths, plus rounding.

    The second derivative with respect to the azimuth jumps twice, by 2 sin(slope)^2 / cos(slope). The error is B3(x) / 6
    times that jump, where B3 is the Bernoulli polynomial.
    """
    level = wp.float64(n[0] * n[0] + n[1] * n[1])
    if level == ZERO:
        return ZERO
    return _OF_OWN_PLANE * level / (wp.float64(n[2]) * azimuths * azimuths * azimuths) + _ROUNDING
