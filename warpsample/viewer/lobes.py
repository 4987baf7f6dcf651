"""Shape of a distribution's density for the viewer: a surface, and probabilities of histogram bins."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.distributions.record import Distribution
from warpsample.statistics.charts import SPHERE
from warpsample.statistics.quadrature import cell_masses

CELLS = 45
"""Number of bins of the angle to the normal inside the chart."""
SECTORS = 24
"""Number of bins of the angle about the normal."""

_FINE = 8  # points of the density's line in a bin
_RINGS, _SPOKES = 96, 72
_PILOT = 4096
_ALMOST_ALL = 0.998
_TALLEST = 8.0  # times the median density; higher values, as at the edge of an offset sphere, are cut
_NARROWEST = 1e-2  # degrees
_ROUND = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3, 6, 12, 18, 24, 30, 45, 60, 90, 120, 180)  # degrees


@dataclass(frozen=True, eq=False)
class LobeShape:
    """Density of a distribution as a surface over the tangent plane, with the probability of each histogram bin.

    Attributes:
        surface: (I, J, 3) local coordinates: directions with length density / `peak`, at most 1.
        peak: density per steradian with length 1.
        edges: (CELLS + 2,) edges of the bins of theta, radians. The last bin reaches from the end of the chart to pi.
        theta: (CELLS + 1,) probability of each bin of theta.
        azimuth: (SECTORS,) probability of each bin of the azimuth.
        angles: (M,) angles of `line`, radians.
        line: (M,) density of theta per radian.
    """

    surface: np.ndarray
    peak: float
    edges: np.ndarray
    theta: np.ndarray
    azimuth: np.ndarray
    angles: np.ndarray
    line: np.ndarray


@lru_cache(maxsize=256)
def lobe_of(claim: Distribution) -> LobeShape:
    """Compute the surface of a distribution's density and the probabilities of its histogram bins.

    Raises:
        ValueError: the lobe is too narrow for float32 directions about a normal.
    """
    pilot = claim.sample(sample_square("fibonacci", 1, _PILOT)[0])
    high = _covering_angle(claim, pilot)
    edges = np.append(np.linspace(0.0, high, CELLS + 1), max(np.pi, high + 1e-9))
    theta, azimuth = _bin_probabilities(claim, edges)
    fine = np.linspace(0.0, high, _FINE * CELLS + 1) if claim.symmetric else edges[:-1]
    line = (np.diff(claim.cdf(fine)) if claim.symmetric else theta[:-1]) / np.diff(fine)
    grid = SPHERE.point(np.linspace(0.0, high, _RINGS)[:, None], np.linspace(0.0, 1.0, _SPOKES)).astype(np.float32)
    pdf, on_grid = claim.pdf(pilot), claim.pdf(grid)
    peak = min(float(max(pdf.max(), on_grid.max())), _TALLEST * float(np.median(pdf)))
    surface = np.minimum(on_grid / peak, 1.0)[..., None] * grid
    return LobeShape(surface, peak, edges, theta, azimuth, 0.5 * (fine[1:] + fine[:-1]), line)


def _covering_angle(claim: Distribution, pilot: np.ndarray) -> float:
    """Return a round angle to the normal, in radians, within which 99.8 % of the directions of a distribution are."""
    reach = float(np.degrees(np.quantile(SPHERE.polar(pilot), _ALMOST_ALL)))
    if reach < _NARROWEST:
        raise ValueError(
            f"distribution: got {claim!r}, a lobe of {reach:.1g} degrees, want one of at least {_NARROWEST} to see it"
        )
    return float(np.radians(next(angle for angle in _ROUND if angle >= reach - 1e-3)))


def _bin_probabilities(claim: Distribution, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the probabilities of the histogram bins of the polar angle and of the azimuth, by integrating the density."""
    if claim.symmetric:
        return np.diff(claim.cdf(edges)), np.full(SECTORS, 1.0 / SECTORS)
    masses = cell_masses(claim, edges, SECTORS, chart=SPHERE)
    masses /= masses.sum()
    return masses.sum(axis=1), masses.sum(axis=0)
