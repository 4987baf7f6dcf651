"""Sampling of directions in the visible part of a sky patch, with a density nearly proportional to the cosine.

A column is the part of the patch at one azimuth. A direction's drop is 1 - sin(altitude).
"""

import warp as wp

from warpsample.maths.numerics import HALF, TWO, ZERO, greater, lesser, sincos_turns
from warpsample.radiation.sky.form_factors import Patch, azimuth_near, reaches

LEAST: wp.float32 = wp.constant(wp.float32(1e-20))
"""Number added to denominators, so that 0 / 0 gives 0."""

_ALIKE = wp.constant(wp.float32(0.05))
_BENT = wp.constant(wp.float32(0.2))
_THIRD = wp.constant(wp.float32(1.0 / 3.0))
_ROOT_SEED = wp.constant(wp.int32(709921077))
_PI = wp.constant(wp.float64(3.141592653589793))
_TURN = wp.constant(wp.float64(0.15915494309189535))
_UPRIGHT = wp.constant(wp.float64(1e-12))


@wp.func
def _find_visible_azimuths(n: wp.vec3d, patch: Patch):
    """Return the range of azimuths with visible parts of a sky patch, as (first, width) in units of 2 pi.

    If these azimuths form two intervals, return the whole width of the patch.
    """
    first = patch.first
    last = patch.last
    level = wp.sqrt(n[0] * n[0] + n[1] * n[1])
    if level > _UPRIGHT:
        half = reaches(wp.where(n[2] < ZERO, n[2] * patch.tan_low, n[2] * patch.tan_high), level)
        middle = azimuth_near(n, HALF * (first + last))
        if last - first > _PI:  # the cap, which spans all azimuths
            first = middle - half
            last = middle + half
        elif middle + half - TWO * _PI <= first and middle - half + TWO * _PI >= last:
            first = wp.max(first, middle - half)
            last = wp.max(first, wp.min(last, middle + half))
    return wp.float32(first * _TURN - wp.floor(first * _TURN)), wp.float32((last - first) * _TURN)


@wp.struct
class Slope:
    """Parameters for sampling directions in a sky patch as seen from a point with a given normal.

    A column is the part of the patch at one azimuth. top, bottom: drops of the upper and lower edge; near the zenith a drop
    keeps digits that the height loses. first, width: azimuths over 2 pi. start, end: square roots of the weights of the
    first and last column, relative to the greater.
    """

    nx: wp.float32
    ny: wp.float32
    nz: wp.float32
    top: wp.float32
    bottom: wp.float32
    first: wp.float32
    width: wp.float32
    start: wp.float32
    end: wp.float32


@wp.func
def azimuth_at(slope: Slope, share: wp.float32) -> wp.vec2:
    """Return (cosine, sine) of the azimuth at a fraction, 0 to 1, of the width of a sky patch's visible part."""
    turn = slope.first + slope.width * share
    return sincos_turns(wp.where(turn < 1.0, turn, turn - 1.0))


@wp.func
def _cosine_at(level: wp.float32, nz: wp.float32, drop: wp.float32) -> wp.float32:
    """Return the cosine between the normal and a direction whose height is 1 - drop; 0 below the horizon."""
    return greater(level * wp.sqrt(drop * (2.0 - drop)) + nz * (1.0 - drop), 0.0)


@wp.func
def column_at(slope: Slope, cs: wp.vec2) -> wp.vec4:
    """Return the range of heights at which a sky patch is visible at one azimuth, and the cosines at both ends.

    It is (upper drop, extent in drop, cosine at the upper end, cosine at the lower end).
    """
    level = slope.nx * cs[1] + slope.ny * cs[0]
    # A column's visible part is above the horizon's height if the normal points up, else below that height.
    downwards = slope.nz < 0.0
    horizon = 1.0 + wp.where(downwards, -level, level) / wp.sqrt(level * level + slope.nz * slope.nz + LEAST)
    upper = wp.where(downwards, greater(horizon, slope.top), slope.top)
    extent = greater(wp.where(downwards, slope.bottom, lesser(horizon, slope.bottom)) - upper, 0.0)
    return wp.vec4(upper, extent, _cosine_at(level, slope.nz, upper), _cosine_at(level, slope.nz, upper + extent))


@wp.func
def weight_of(column: wp.vec4) -> wp.float32:
    """Return the sampling weight of one azimuth of a sky patch: about twice the integral of the cosine over its heights."""
    return column[1] * (column[2] + column[3])


@wp.func
def slope_of(n: wp.vec3d, patch: Patch) -> Slope:
    """Compute the parameters for sampling directions in a sky patch from a point with normal n.

    Column weights are interpolated as the square of a linear function.
    """
    slope = Slope()
    slope.nx = wp.float32(n[0])
    slope.ny = wp.float32(n[1])
    slope.nz = wp.float32(n[2])
    slope.top = wp.float32(patch.top)
    slope.bottom = wp.float32(patch.bottom)
    first, width = _find_visible_azimuths(n, patch)
    slope.first = first
    slope.width = width
    start = wp.sqrt(weight_of(column_at(slope, azimuth_at(slope, 0.0))))
    end = wp.sqrt(weight_of(column_at(slope, azimuth_at(slope, 1.0))))
    middle = wp.sqrt(weight_of(column_at(slope, azimuth_at(slope, 0.5))))
    most = wp.max(start, end)
    # Uniform columns if the two weights agree, or if the middle is not on the line between them.
    alike = wp.abs(end - start) <= _ALIKE * most
    slope.start = 1.0
    slope.end = 1.0
    if not alike and wp.abs(middle - 0.5 * (start + end)) <= _BENT * most:
        slope.start = start / most
        slope.end = end / most
    return slope


@wp.func
def cube_root(x: wp.float32) -> wp.float32:
    """Return the cube root of a number from 1e-12 to 2, with relative error 2e-7.

    From the number's bits, and two Halley steps.
    """
    y = wp.cast(wp.int32(wp.float32(wp.cast(x, wp.int32)) * _THIRD) + _ROOT_SEED, wp.float32)
    y = y * (y * y * y + 2.0 * x) / (2.0 * y * y * y + x)
    return y * (y * y * y + 2.0 * x) / (2.0 * y * y * y + x)
