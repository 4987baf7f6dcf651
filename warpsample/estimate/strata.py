"""The cosine lobe cut into strata of equal weight, by which rays are stratified and which shafts may find empty.

A stratum is a rectangle of the square that the polar map makes directions of: a band of sin^2 theta in a sector of azimuths.
Each has rays of its own, in two independent randomisations, so that their differences, stratum by stratum, tell the error.
"""

from dataclasses import dataclass
from itertools import pairwise
from math import cos, inf, pi, sin, sqrt

import numpy as np

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.host.locks import once
from warpsample.tracing.sight.shafts import shaft_vectors

REPLICATES = 2
"""Randomisations of a stratum's rays: with more, each has fewer rays, and low-discrepancy ones lose what sets them apart."""

POLAR_COSINE = CosineHemisphere("polar")
"""The lobe of the built-in quantities."""

_HALVINGS = 60  # of an interval of angles: more than float64 has digits

_GRIDS = ((1, 1, 1), (32, 1, 4), (256, 2, 4), (448, 4, 8), (4096, 4, 16), (16384, 8, 16))
"""(rays from which on, bands, sectors): the fastest to an RMSE of 0.01 and 0.003 on the bunny, but for the four sectors
from 32 rays on, which cost an eighth and give the error bar more than one difference to stand on."""


@dataclass(frozen=True, eq=False)
class Strata:
    """The strata of a lobe, sector by sector, and the shafts about them.

    Attributes:
        bands: of sin^2 theta, of equal width.
        sectors: of azimuth; 1, without shafts, or at least 4.
        samples_per_stratum: rays of a stratum in each replicate.
        shafts: (sectors, bands + 1, 3, 16) float32, local frame: of each sector and of its bands, as `shaft_vectors` has
            them, with two planes at the azimuths, the one towards the normal and the one towards the horizon.
    """

    bands: int
    sectors: int
    samples_per_stratum: int
    shafts: np.ndarray

    @property
    def step(self) -> int:
        """What the number of rays of a point is a multiple of, since all strata have as many."""
        return self.bands * self.sectors * REPLICATES

    @property
    def rays(self) -> int:
        """The number of rays of a point."""
        return self.step * self.samples_per_stratum


@once
def strata_of(count: int, lobe: Distribution = POLAR_COSINE, traced: bool = True) -> Strata:
    """The strata for at most `count` rays a point, at least 2; few if none is traced, as more would only cost time.

    Without shafts if the lobe's strata are no parts of cones.
    """
    _, bands, sectors = next(grid for grid in _grids(traced)[::-1] if count >= grid[0])
    edges = _edges(lobe, bands) if traced else None
    spans = [] if edges is None else [(edges[0], edges[-1]), *pairwise(edges)]
    shafts = [
        [_shaft(s / sectors, (s + 1) / sectors, *span) for span in spans]
        for s in range(sectors if sectors > 1 and spans else 0)
    ]
    vectors = np.reshape(shafts, (-1, bands + 1, 8, 3))
    shafts = shaft_vectors(vectors[:, :, :4], vectors[:, :, 4:])
    return Strata(bands, sectors, count // (bands * sectors * REPLICATES), shafts)


def counts_with_the_strata_of(count: float, traced: bool = True) -> tuple[int, float]:
    """(fewest, most) rays that `strata_of` cuts into as many strata as `count`; infinity if there are no finer ones."""
    begins = [rays for rays, _, _ in _grids(traced)]
    fewest = max(rays for rays in begins if rays <= max(count, 1))
    finer = min((rays for rays in begins if rays > fewest), default=inf)
    return fewest, finer if finer == inf else strata_of(finer - 1, traced=traced).rays


def _grids(traced: bool) -> tuple[tuple[int, int, int], ...]:
    return _GRIDS if traced else _GRIDS[:2]


def _edges(lobe: Distribution, bands: int) -> np.ndarray | None:
    """(bands + 1,) sin^2 of the angles between which equal bands of u[0] are mapped; None if these are no bands of cones."""
    shares = np.arange(bands + 1) / bands
    if lobe == POLAR_COSINE:
        return shares
    if not (lobe.symmetric and lobe.polar) or lobe.largest_angle > pi / 2.0:
        return None
    low, high = np.zeros(bands + 1), np.full(bands + 1, lobe.largest_angle)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        below = lobe.cdf(middle) < shares
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return np.square(np.sin(np.where(shares == 1.0, lobe.largest_angle, np.where(shares == 0.0, 0.0, high))))


def _shaft(first: float, last: float, low: float, high: float) -> list[tuple[float, float, float]]:
    """The shaft about azimuths from first to last, in turns, and sin^2 theta from low to high.

    The cone towards the normal is replaced by the plane through its two corners, which cuts off more of it, and the one
    towards the horizon by the plane that touches it between them.
    """
    start, stop, middle = 2.0 * pi * first, 2.0 * pi * last, pi * (first + last)
    half = cos(0.5 * (stop - start))
    corners = [
        _unit(along, up, azimuth)
        for azimuth in (start, stop)
        for along, up in ((sqrt(low), sqrt(1.0 - low)), (sqrt(high) / half, sqrt(1.0 - high)))
    ]
    return [
        (-sin(start), cos(start), 0.0),
        (sin(stop), -cos(stop), 0.0),
        _unit(sqrt(1.0 - low), -sqrt(low) * half, middle),
        _unit(-sqrt(1.0 - high), sqrt(high), middle),
        *corners,
    ]


def _unit(along: float, up: float, azimuth: float) -> tuple[float, float, float]:
    """The unit vector with those shares along an azimuth and upwards."""
    length = sqrt(along * along + up * up)
    return along * cos(azimuth) / length, along * sin(azimuth) / length, up / length
