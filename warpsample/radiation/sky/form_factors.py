"""The share of a lobe that a sky patch takes, in closed form, wherever the point's horizon cuts it.

In the patches' frame (east, north, up) a direction at altitude a and azimuth p has the cosine n_z sin a + h(p) cos a to a
normal n, h(p) = H cos(p - p_n). Its integral over the altitude, n_z sin^2 a / 2 + h (a + sin a cos a) / 2, is to be
integrated over the azimuth at the upper edge of what is above the horizon, less at the lower edge. Along the horizon that is
a total differential but for the angle that the horizon turns by about n: by Stokes, as for the area of a polygon.
"""

import numpy as np
import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.radiation.sky.patches import SkyPatches

FAINT = 2.0**-12
"""A cosine to the normal below which rays are not cast: what lies so low adds 1e-8 of a patch's azimuths."""

_COLUMNS = 20  # of the table
_FAINT = wp.constant(wp.float64(FAINT))
_PI = wp.constant(wp.float64(np.pi))
_INVERSE_PI = wp.constant(wp.float64(1.0 / np.pi))
_UPRIGHT = wp.constant(wp.float64(1e-12))  # less of a normal lies in the horizontal plane than counts


@wp.struct
class Patch:
    """A patch as kernels see it; angles in radians, in the patches' frame.

    Azimuths, their sines and cosines, half the chord's sagitta; sines, cosines and tangents of the altitudes of the lower
    and the upper edge; the integrals of cos^2 up to them; the moment: the integral of the direction over the patch; how much
    lower than the zenith the upper and the lower edge are.
    """

    first: wp.float64
    last: wp.float64
    sin_first: wp.float64
    cos_first: wp.float64
    sin_last: wp.float64
    cos_last: wp.float64
    bulge: wp.float64
    sin_low: wp.float64
    cos_low: wp.float64
    tan_low: wp.float64
    along_low: wp.float64
    sin_high: wp.float64
    cos_high: wp.float64
    tan_high: wp.float64
    along_high: wp.float64
    moment: wp.vec3d
    top: wp.float64
    bottom: wp.float64


def table_of(patches: SkyPatches) -> np.ndarray:
    """(K, 20) float64: the numbers of `Patch`."""
    (low, high), (first, last) = np.radians(patches.altitudes).T, np.radians(patches.azimuths).T
    table = np.zeros((len(patches), _COLUMNS))
    table[:, 0:6] = np.stack([first, last, np.sin(first), np.cos(first), np.sin(last), np.cos(last)], axis=1)
    table[:, 6] = np.where(last - first > np.pi, 2.0, 1.0 - np.cos(0.5 * (last - first)))
    for column, altitude in ((7, low), (11, high)):
        sine, cosine = np.sin(altitude), np.cos(altitude)
        table[:, column : column + 4] = np.stack([sine, cosine, sine / cosine, 0.5 * (altitude + sine * cosine)], axis=1)
    up = 0.5 * (np.square(table[:, 11]) - np.square(table[:, 7]))
    along = table[:, 14] - table[:, 10]
    table[:, 15:18] = np.stack(
        [(table[:, 3] - table[:, 5]) * along, (table[:, 4] - table[:, 2]) * along, (last - first) * up], axis=1
    )
    table[-1, 15:17] = 0.0  # all around
    table[:, 18:20] = 2.0 * np.square(np.sin(0.5 * (0.5 * np.pi - np.stack([high, low], axis=1))))
    return table


@wp.func
def patch_at(table: wp.uint64, k: wp.int32) -> Patch:
    """The k-th patch."""
    return wp.array(ptr=table, shape=(k + 1,), dtype=Patch)[k]


@wp.func
def _turned(x: wp.float64, nz: wp.float64, level: wp.float64) -> wp.float64:
    """By which angle about the normal the horizon turns from the normal's azimuth to x beyond it; and h' a / 2 there."""
    s = wp.sin(x)
    c = wp.cos(x)
    return HALF * (level * s * wp.atan2(-level * c, nz) - wp.atan2(nz * s, c) + nz * x)


@wp.func
def _below_edge(x: wp.float64, nz: wp.float64, level: wp.float64, w_low: wp.float64, w_high: wp.float64, patch: Patch):
    """The integral from the normal's azimuth to x, 0 to pi, beyond it, at the lower edge of what is above the horizon."""
    total = HALF * nz * patch.sin_low * patch.sin_low * wp.min(x, w_low)
    total += level * patch.along_low * wp.sin(wp.min(x, w_low))
    if x > w_low and w_high > w_low:
        total += _turned(wp.min(x, w_high), nz, level) - _turned(w_low, nz, level)
    if x > w_high:
        total += HALF * nz * patch.sin_high * patch.sin_high * (x - w_high)
        total += level * patch.along_high * (wp.sin(x) - wp.sin(w_high))
    return total


@wp.func
def _odd_edge(x: wp.float64, nz: wp.float64, level: wp.float64, w_low: wp.float64, w_high: wp.float64, patch: Patch):
    """What `_below_edge` gives, from -2 pi to 2 pi: the integrand is even about the normal's azimuth and its opposite."""
    size = wp.abs(x)
    total = _below_edge(wp.min(size, TWO * _PI - size), nz, level, w_low, w_high, patch)
    if size > _PI:
        total = TWO * _below_edge(_PI, nz, level, w_low, w_high, patch) - total
    return wp.where(x < ZERO, -total, total)


@wp.func
def reaches(slope: wp.float64, level: wp.float64) -> wp.float64:
    """How far from the normal's azimuth, 0 to pi, the horizon of a normal is below the altitude of a tangent slope / n_z."""
    return wp.acos(wp.clamp(-slope / level, -ONE, ONE))


@wp.func
def azimuth_near(n: wp.vec3d, middle: wp.float64) -> wp.float64:
    """The normal's azimuth, within pi of a patch's middle."""
    azimuth = wp.atan2(n[0], n[1])
    return azimuth + TWO * _PI * wp.round((middle - azimuth) / (TWO * _PI))


@wp.func
def _cut(n: wp.vec3d, level: wp.float64, patch: Patch) -> wp.float64:
    """pi times the share of a patch that the horizon cuts; n_z at least 0."""
    w_low = reaches(n[2] * patch.tan_low, level)
    w_high = reaches(n[2] * patch.tan_high, level)
    azimuth = azimuth_near(n, HALF * (patch.first + patch.last))
    upper = HALF * n[2] * patch.sin_high * patch.sin_high * (patch.last - patch.first)
    across = n[0] * (patch.cos_first - patch.cos_last) + n[1] * (patch.sin_last - patch.sin_first)
    end = _odd_edge(patch.last - azimuth, n[2], level, w_low, w_high, patch)
    return upper + across * patch.along_high - (end - _odd_edge(patch.first - azimuth, n[2], level, w_low, w_high, patch))


@wp.func
def highest(n: wp.vec3d, patch: Patch) -> wp.vec3d:
    """The direction of a patch that is farthest above the point's horizon."""
    level = wp.sqrt(n[0] * n[0] + n[1] * n[1])
    azimuth = azimuth_near(n, HALF * (patch.first + patch.last))
    s = patch.sin_last
    c = patch.cos_last
    if level > _UPRIGHT and azimuth > patch.first and azimuth < patch.last:
        s = n[0] / level
        c = n[1] / level
    elif n[0] * patch.sin_first + n[1] * patch.cos_first > n[0] * s + n[1] * c:
        s = patch.sin_first
        c = patch.cos_first
    h = n[0] * s + n[1] * c
    sine = patch.sin_low
    cosine = patch.cos_low
    if n[2] * patch.cos_low > h * patch.sin_low:  # rising there
        sine = patch.sin_high
        cosine = patch.cos_high
        if n[2] * patch.cos_high < h * patch.sin_high:
            sine = n[2] / wp.sqrt(h * h + n[2] * n[2])
            cosine = h / wp.sqrt(h * h + n[2] * n[2])
    return wp.vec3d(cosine * s, cosine * c, sine)


@wp.func
def open_form_factor(n: wp.vec3d, patch: Patch) -> wp.float64:
    """The integral of max(0, n.w) / pi over a patch, for a unit normal in the patches' frame."""
    level = wp.sqrt(n[0] * n[0] + n[1] * n[1])
    at_first = n[0] * patch.sin_first + n[1] * patch.cos_first
    at_last = n[0] * patch.sin_last + n[1] * patch.cos_last
    least = wp.max(wp.min(at_first, at_last) - level * patch.bulge, -level)
    most = wp.min(wp.max(at_first, at_last) + level * patch.bulge, level)
    share = ZERO
    if wp.max(most * patch.cos_low + n[2] * patch.sin_low, most * patch.cos_high + n[2] * patch.sin_high) > _FAINT:
        whole = wp.dot(n, patch.moment)
        lowest = wp.min(least * patch.cos_low + n[2] * patch.sin_low, least * patch.cos_high + n[2] * patch.sin_high)
        if lowest >= -_FAINT or level < _UPRIGHT:
            share = whole
        elif wp.dot(n, highest(n, patch)) > _FAINT:
            # max(0, c) = c + max(0, -c)
            share = _cut(n, level, patch) if n[2] >= ZERO else whole + _cut(-n, level, patch)
    return wp.max(share, ZERO) * _INVERSE_PI
