"""Form factors of sky patches in closed form: the cosine-weighted share of an unobstructed view that a patch fills.

In the patches' frame (east, north, up) a direction at altitude a and azimuth p has the cosine n_z sin a + h(p) cos a to a
normal n, with h(p) = H cos(p - p_n). The integral over the altitude is n_z sin^2 a / 2 + h (a + sin a cos a) / 2. It is
integrated over the azimuth along the upper edge of the visible part, minus the same along the lower edge. On the horizon the
integrand is a total differential plus half the horizon's turning angle about n, by Stokes' theorem, as for the area of a
polygon.
"""

import numpy as np
import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.radiation.sky.patches import SkyPatches

FAINT = 2.0**-12
"""Cosine to the normal below which no rays are cast: directions below it add at most 1e-8 of a patch's azimuth width."""

_COLUMNS = 20  # of the table
_FAINT = wp.constant(wp.float64(FAINT))
_PI = wp.constant(wp.float64(np.pi))
_INVERSE_PI = wp.constant(wp.float64(1.0 / np.pi))
_UPRIGHT = wp.constant(wp.float64(1e-12))  # a horizontal part of the normal below this is taken as 0


@wp.struct
class Patch:
    """Sky patch as kernels use it: azimuths and altitudes of its edges in radians, with sines and cosines.

    first, last: azimuths of the sides, with sines and cosines. bulge: 1 - cos of half the width, 2 if wider than pi. *_low,
    *_high: sine, cosine and tangent of the altitudes of the lower and the upper edge; along_*: integrals of cos^2 up to the
    edge. moment: integral of the direction over the patch. top, bottom: drops of the upper and lower edge, 1 -
    sin(altitude).
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
    """Return a table of sky patches for kernels, (K, 20) float64: edges of each patch, with sines and cosines."""
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
    table[-1, 15:17] = 0.0  # the cap: the horizontal moment is 0 by symmetry
    table[:, 18:20] = 2.0 * np.square(np.sin(0.5 * (0.5 * np.pi - np.stack([high, low], axis=1))))
    return table


@wp.func
def patch_at(table: wp.uint64, k: wp.int32) -> Patch:
    """Return the k-th sky patch from the table at an address."""
    return wp.array(ptr=table, shape=(k + 1,), dtype=Patch)[k]


@wp.func
def _horizon_integral(x: wp.float64, nz: wp.float64, level: wp.float64) -> wp.float64:
    """Return the antiderivative of the form-factor integrand along a tilted point's horizon, at azimuth x.

    Half of: h'(x) a(x), plus the angle by which the horizon turns about the normal.
    """
    s = wp.sin(x)
    c = wp.cos(x)
    return HALF * (level * s * wp.atan2(-level * c, nz) - wp.atan2(nz * s, c) + nz * x)


@wp.func
def _integrate_edge(x: wp.float64, nz: wp.float64, level: wp.float64, w_low: wp.float64, w_high: wp.float64, patch: Patch):
    """Return the form-factor integral along the lower edge of a sky patch's visible part, from 0 to azimuth x.

    x, 0 to pi: upper limit, an azimuth measured from the normal's.
    """
    total = HALF * nz * patch.sin_low * patch.sin_low * wp.min(x, w_low)
    total += level * patch.along_low * wp.sin(wp.min(x, w_low))
    if x > w_low and w_high > w_low:
        total += _horizon_integral(wp.min(x, w_high), nz, level) - _horizon_integral(w_low, nz, level)
    if x > w_high:
        total += HALF * nz * patch.sin_high * patch.sin_high * (x - w_high)
        total += level * patch.along_high * (wp.sin(x) - wp.sin(w_high))
    return total


@wp.func
def _extend_edge(x: wp.float64, nz: wp.float64, level: wp.float64, w_low: wp.float64, w_high: wp.float64, patch: Patch):
    """Return the form-factor integral of `_integrate_edge` for any azimuth x from -2 pi to 2 pi.

    The integrand is even about the normal's azimuth and about the opposite azimuth.
    """
    size = wp.abs(x)
    total = _integrate_edge(wp.min(size, TWO * _PI - size), nz, level, w_low, w_high, patch)
    if size > _PI:
        total = TWO * _integrate_edge(_PI, nz, level, w_low, w_high, patch) - total
    return wp.where(x < ZERO, -total, total)


@wp.func
def reaches(slope: wp.float64, level: wp.float64) -> wp.float64:
    """Return the azimuth, 0 to pi from the normal's, at which a tilted point's horizon rises above an altitude.

    slope: n_z times the tangent of the altitude. level: length of the normal's horizontal part.
    """
    return wp.acos(wp.clamp(-slope / level, -ONE, ONE))


@wp.func
def azimuth_near(n: wp.vec3d, middle: wp.float64) -> wp.float64:
    """Return the azimuth of a normal in radians, shifted by a multiple of 2 pi to be within pi of `middle`."""
    azimuth = wp.atan2(n[0], n[1])
    return azimuth + TWO * _PI * wp.round((middle - azimuth) / (TWO * _PI))


@wp.func
def _compute_cut_factor(n: wp.vec3d, level: wp.float64, patch: Patch) -> wp.float64:
    """Return pi times the form factor of a sky patch that is partly below the horizon of a normal n with n_z >= 0."""
    w_low = reaches(n[2] * patch.tan_low, level)
    w_high = reaches(n[2] * patch.tan_high, level)
    azimuth = azimuth_near(n, HALF * (patch.first + patch.last))
    upper = HALF * n[2] * patch.sin_high * patch.sin_high * (patch.last - patch.first)
    across = n[0] * (patch.cos_first - patch.cos_last) + n[1] * (patch.sin_last - patch.sin_first)
    end = _extend_edge(patch.last - azimuth, n[2], level, w_low, w_high, patch)
    return upper + across * patch.along_high - (end - _extend_edge(patch.first - azimuth, n[2], level, w_low, w_high, patch))


@wp.func
def highest(n: wp.vec3d, patch: Patch) -> wp.vec3d:
    """Return the direction in a sky patch that is highest above the horizon of a point with normal n."""
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
    if n[2] * patch.cos_low > h * patch.sin_low:  # the cosine increases with altitude at the lower edge
        sine = patch.sin_high
        cosine = patch.cos_high
        if n[2] * patch.cos_high < h * patch.sin_high:
            sine = n[2] / wp.sqrt(h * h + n[2] * n[2])
            cosine = h / wp.sqrt(h * h + n[2] * n[2])
    return wp.vec3d(cosine * s, cosine * c, sine)


@wp.func
def open_form_factor(n: wp.vec3d, patch: Patch) -> wp.float64:
    """Return the unobstructed form factor of a sky patch at a point with unit normal n.

    It is the integral of max(0, n.w) / pi over the patch.
    """
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
            share = _compute_cut_factor(n, level, patch) if n[2] >= ZERO else whole + _compute_cut_factor(-n, level, patch)
    return wp.max(share, ZERO) * _INVERSE_PI
