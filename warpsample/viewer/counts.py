"""Histograms and maps of the angles of many directions, compared with the densities of lobes."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample.plotting.angle_histogram import AngleHistogram
from warpsample.plotting.cell_map import CellMap
from warpsample.statistics.charts import SPHERE
from warpsample.statistics.histogram import HistogramTest, joined_test, mixture_test, standardise
from warpsample.viewer.lobes import CELLS, SECTORS, CellProbabilities

_ROWS = 16  # of the map, nearly even in cos theta


@dataclass(frozen=True, eq=False)
class AngleCounts:
    """Counts of the angles of many directions, compared with densities.

    Attributes:
        theta: histogram of the angles to the normals.
        azimuth: histogram of the angles about the normals, from the tangent of each point.
        cells: map of both angles; None if all lobes are symmetric about the normal.
    """

    theta: AngleHistogram
    azimuth: AngleHistogram
    cells: CellMap | None


def count_directions(
    local: np.ndarray, probabilities: CellProbabilities, independent: bool, claim: str = "the density"
) -> AngleCounts:
    """Build histograms and a map of the directions' polar angle and azimuth, and compare them with densities.

    Args:
        local: (N, 3) unit directions with the normal along +z; of several lobes, the same number of directions for each.
        probabilities: probabilities that the densities predict for the cells.
        independent: whether the directions are independent of each other.
        claim: name of the compared density.
    """
    edges = probabilities.edges
    cell = np.minimum((SPHERE.polar(local) * (CELLS / edges[-2])).astype(np.intp), CELLS)
    sector = np.minimum((SPHERE.azimuth(local) * SECTORS).astype(np.intp), SECTORS - 1)
    around = np.linspace(0.0, 2.0 * np.pi, SECTORS + 1)
    middle = 0.5 * (around[1:] + around[:-1])
    density = probabilities.azimuth.mean(axis=0) * SECTORS / (2.0 * np.pi)
    theta, azimuth = np.bincount(cell, minlength=CELLS + 1), np.bincount(sector, minlength=SECTORS)
    names = {"independent": independent, "claim": claim}
    cells = None
    if probabilities.cells is not None:
        counts = np.bincount(cell * SECTORS + sector, minlength=(CELLS + 1) * SECTORS).reshape(-1, SECTORS)
        cells = _build_map(counts, probabilities.cells, edges, **names)
    return AngleCounts(
        _build_histogram(theta, probabilities.theta, edges, angles=probabilities.angles, line=probabilities.line, **names),
        _build_histogram(azimuth, probabilities.azimuth, around, angles=middle, line=density, **names),
        cells,
    )


def _build_histogram(
    observed: np.ndarray, masses: np.ndarray, edges: np.ndarray, *, angles: np.ndarray, line: np.ndarray, **names: Any
) -> AngleHistogram:
    """Build the histogram of one angle, with a chi-square test, from counts, (K,), and probabilities, (L, K).

    The test includes bins that are outside the chart.
    """
    shown, total = min(len(observed), CELLS), observed.sum()
    return AngleHistogram(
        edges=np.degrees(edges[: shown + 1]),
        observed=observed[:shown] / (total * np.diff(edges)[:shown]),
        expected=masses.mean(axis=0)[:shown] / np.diff(edges)[:shown],
        angles=np.degrees(angles),
        density=line,
        residuals=_residuals(observed, masses)[:shown],
        test=_test(observed, masses),
        **names,
    )


def _build_map(counts: np.ndarray, masses: np.ndarray, edges: np.ndarray, **names: Any) -> CellMap:
    """Build the map of both angles, from counts, (CELLS + 1, SECTORS), and probabilities, (L, CELLS + 1, SECTORS).

    A row of the map has all bins of theta between two edges.
    """
    cosines = np.cos(edges[:-1])
    even = np.linspace(cosines[0], cosines[-1], _ROWS + 1)
    starts = np.unique(np.abs(cosines[:, None] - even).argmin(axis=0))  # the last one begins the bin outside the map
    observed, joined = np.add.reduceat(counts, starts, axis=0), np.add.reduceat(masses, starts, axis=1)
    flat = joined.reshape(len(joined), -1)
    rows = cosines[starts]
    solid = (-np.diff(rows) * 2.0 * np.pi / SECTORS)[:, None]
    return CellMap(
        edges=rows,
        observed=observed[:-1] / (counts.sum() * solid),
        expected=joined.mean(axis=0)[:-1] / solid,
        residuals=_residuals(observed.ravel(), flat).reshape(observed.shape)[:-1],
        test=_test(observed.ravel(), flat),
        **names,
    )


def _residuals(observed: np.ndarray, masses: np.ndarray) -> np.ndarray:
    """Return counts (K,) minus expected counts in standard deviations, for the probabilities (L, K) of L lobes."""
    draws = observed.sum() / len(masses)
    expected = draws * masses
    return standardise(observed - expected.sum(axis=0), (expected * (1.0 - masses)).sum(axis=0))


def _test(observed: np.ndarray, masses: np.ndarray) -> HistogramTest | None:
    """Test counts (K,) against the probabilities (L, K) of L lobes."""
    if len(masses) == 1:
        return joined_test(observed, observed.sum() * masses[0])
    return mixture_test(observed, masses)
