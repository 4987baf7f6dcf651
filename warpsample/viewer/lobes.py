"""Shape of a distribution's density for the viewer: a surface, and probabilities of cells of directions."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.distributions.record import Distribution
from warpsample.proof.twins import frames
from warpsample.statistics.cells import Density, integrate_lobes
from warpsample.statistics.charts import SPHERE
from warpsample.viewer.own_lobes import constant_lobes

CELLS = 45
"""Number of bins of the angle to the normal inside the chart."""
SECTORS = 24
"""Number of bins of the angle about the normal."""

_FINE = 8  # points of the density's line in a bin
_EVEN, _UNEVEN = (96, 72), (128, 145)  # rings and spokes of the surface of a lobe with and without symmetry
_PILOT, _PILOT_BY_POINT = 4096, 256
_ALMOST_ALL = 0.998
_TALLEST = 8.0  # times the median density; higher values, as at the edge of an offset sphere, are cut
_NARROWEST = 1e-2  # degrees
_ROUND = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3, 6, 12, 18, 24, 30, 45, 60, 90, 120, 180)  # degrees
_WIDEN = 1.5  # of angles in the bin outside the chart, whose density falls fast
_MOST_MISSING = 1e-3  # of the probability: ten times the error of the integral


@dataclass(frozen=True, eq=False)
class LobeShape:
    """Density of a distribution as a surface over the tangent plane.

    Attributes:
        surface: (I, J, 3) local coordinates: directions with length density / `peak`, at most 1.
        peak: density per steradian with length 1.
    """

    surface: np.ndarray
    peak: float


@dataclass(frozen=True, eq=False)
class CellProbabilities:
    """Probabilities that densities predict for the bins of theta and phi, for L lobes; L is 1 if all points share a lobe.

    Attributes:
        edges: (CELLS + 2,) edges of the bins of theta, radians. The last bin reaches from the end of the chart to pi.
        theta: (L, CELLS + 1) probability of each bin of theta.
        azimuth: (L, SECTORS) probability of each bin of the azimuth.
        angles: (M,) angles of `line`, radians.
        line: (M,) mean density of theta per radian.
        cells: (L, CELLS + 1, SECTORS) probability of each pair of bins; None if all lobes are symmetric about the normal.
    """

    edges: np.ndarray
    theta: np.ndarray
    azimuth: np.ndarray
    angles: np.ndarray
    line: np.ndarray
    cells: np.ndarray | None


@lru_cache(maxsize=256)
def shape_of(claim: Distribution) -> LobeShape:
    """Compute the surface of the density of a distribution with constant parameters.

    Raises:
        ValueError: the lobe is too narrow for float32 directions about a normal.
    """
    pilot = _pilot(claim, 1)[0]
    high, pdf, frame, (rings, spokes) = _covering_angle(claim, pilot), claim.pdf(pilot), np.eye(3), _EVEN
    if not claim.symmetric:  # rings about the highest density, where the surface bends most
        frame, (rings, spokes) = frames(pilot[[pdf.argmax()]].astype(np.float64))[0], _UNEVEN
        high = np.quantile(SPHERE.polar(pilot @ frame), _ALMOST_ALL)
    grid = SPHERE.point(np.linspace(0.0, high, rings)[:, None], np.linspace(0.0, 1.0, spokes)) @ frame.T
    grid = grid.astype(np.float32)
    on_grid = claim.pdf(grid)
    peak = min(float(max(pdf.max(), on_grid.max())), _TALLEST * float(np.median(pdf)))
    return LobeShape(np.minimum(on_grid / peak, 1.0)[..., None] * grid, peak)


def peaks_of(claim: Distribution, points: int) -> np.ndarray:
    """Return the largest density at each point, (P,), of a distribution with parameters by point; cut as in `shape_of`."""
    pdf = claim.pdf(_pilot(claim, points))
    return np.minimum(pdf.max(axis=1), np.float32(_TALLEST) * np.median(pdf, axis=1))


@lru_cache(maxsize=256)
def probabilities_of(claim: Distribution, lobes: int = 1) -> CellProbabilities:
    """Compute the probability of each cell for each lobe of a distribution.

    Args:
        claim: distribution with constant parameters, or with one row of valid parameters for each lobe.
        lobes: number of lobes, 1 for constant parameters.

    Raises:
        ValueError: the lobe is too narrow for float32 directions about a normal; or the density does not integrate to 1, or
            is too rough to be integrated.
    """
    pilot = _pilot(claim, lobes)
    high = _covering_angle(claim, pilot)
    edges = np.append(np.linspace(0.0, high, CELLS + 1), max(np.pi, high + 1e-9))
    if claim.symmetric:
        each = constant_lobes(claim)
        fine = np.linspace(0.0, high, _FINE * CELLS + 1)
        line = np.mean([np.diff(lobe.cdf(fine)) for lobe in each], axis=0) / np.diff(fine)
        theta = np.stack([np.diff(lobe.cdf(edges)) for lobe in each])
        azimuth = np.full((len(each), SECTORS), 1.0 / SECTORS)
        return CellProbabilities(edges, theta, azimuth, 0.5 * (fine[1:] + fine[:-1]), line, None)
    outer = np.append(high * np.float_power(_WIDEN, np.arange(np.ceil(np.log(np.pi / high) / np.log(_WIDEN)))), np.pi)
    cells = integrate_lobes(_density_of_rows(claim), lobes, np.append(edges[:CELLS], outer), SECTORS, pilot)
    cells = np.concatenate([cells[:, :CELLS], cells[:, CELLS:].sum(axis=1, keepdims=True)], axis=1)
    total = cells.sum(axis=(1, 2), keepdims=True)
    if not np.abs(total - 1.0).max() <= _MOST_MISSING:
        worst = float(total.flat[np.abs(total - 1.0).argmax()])
        raise ValueError(f"density: got {claim!r}, which integrates to {worst:.4g} over all directions, want 1")
    cells /= total
    theta, azimuth = cells.sum(axis=2), cells.sum(axis=1)
    line = theta[:, :-1].mean(axis=0) / np.diff(edges[:-1])
    return CellProbabilities(edges, theta, azimuth, 0.5 * (edges[1:-1] + edges[:-2]), line, cells)


def _pilot(claim: Distribution, lobes: int) -> np.ndarray:
    """Return directions of each lobe, (L, S, 3), that show where the density is high."""
    u = sample_square("fibonacci", 1, _PILOT_BY_POINT if claim.by_point else _PILOT)
    return claim.sample(np.broadcast_to(u, (lobes, *u.shape[1:])))


def _density_of_rows(claim: Distribution) -> Density:
    """Return the density of a distribution as a function of rows of lobes and of directions."""
    return (lambda rows, w: claim.take(rows).pdf(w)) if claim.by_point else lambda rows, w: claim.pdf(w)  # noqa: ARG005


def _covering_angle(claim: Distribution, pilot: np.ndarray) -> float:
    """Return the radius of a cone about the normal, in radians, that contains 99.8 % of a distribution's directions.

    The angle is rounded up to one of a few round angles.
    """
    reach = float(np.degrees(np.quantile(SPHERE.polar(pilot), _ALMOST_ALL)))
    if reach < _NARROWEST:
        raise ValueError(
            f"distribution: got {claim!r}, a lobe of {reach:.1g} degrees, want one of at least {_NARROWEST} to be "
            "visible in a picture"
        )
    return float(np.radians(next(angle for angle in _ROUND if angle >= reach - 1e-3)))
