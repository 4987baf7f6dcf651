"""The laws that a sampler must obey, one function each: measured errors, or the p-value of a statistic.

They take distributions and directions, know nothing of meshes, and assert nothing: tests and `warpsample verify` compare.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from warpsample.distributions.record import Distribution
from warpsample.numerics import GRID
from warpsample.proof.histogram import HistogramTest, histogram_test

_SLAB = 1 << 20
_SPREAD = 0x9E3779B1  # odd, so k -> k * _SPREAD mod 2^24 meets every value once


def corner_grid() -> np.ndarray:
    """(N, 2) float32: all pairs of values of u where maps break: ends, middle, quarters, eighths and their neighbours."""
    edges = np.array(
        [0, 1, 2, 1 << 8, 1 << 16, GRID // 8, GRID // 4, 3 * GRID // 8, GRID // 2, 5 * GRID // 8, 3 * GRID // 4]
    )
    near = np.unique(np.concatenate([edges + step for step in (-1, 0, 1)] + [[GRID - 1, GRID - 2, GRID - 257]]))
    values = near[(near >= 0) & (near < GRID)] / GRID
    return np.stack(np.meshgrid(values, values), axis=-1).reshape(-1, 2).astype(np.float32)


def all_variates() -> Iterator[np.ndarray]:
    """Yields (2^20, 2) float32 slabs in which each coordinate takes each of the 2^24 values of the grid once."""
    for start in range(0, GRID, _SLAB):
        k = np.arange(start, start + _SLAB, dtype=np.int64)
        yield np.stack([k / GRID, (k * _SPREAD % GRID) / GRID], axis=1).astype(np.float32)


def length_error(w: np.ndarray) -> float:
    """Greatest abs(abs(w) - 1); infinite for a NaN."""
    return _worst(np.linalg.norm(w.astype(np.float64), axis=-1) - 1.0)


def angle_error(w: np.ndarray, twin: np.ndarray) -> float:
    """Greatest angle in radians between directions and their float64 twins; infinite for a NaN."""
    w = w.astype(np.float64)
    return _worst(np.arctan2(np.linalg.norm(np.cross(w, twin), axis=-1), (w * twin).sum(axis=-1)))


def pdf_error(pdf: np.ndarray, exact: np.ndarray) -> float:
    """Greatest relative error of densities; infinite for a NaN."""
    return _worst(pdf.astype(np.float64) / exact - 1.0)


def round_trip_error(distribution: Distribution, u: np.ndarray) -> float:
    """Greatest distance of a coordinate from invert(sample(u)) to u, on the circle for an azimuth; infinite for a NaN."""
    difference = distribution.invert(distribution.sample(u)).astype(np.float64) - u
    return _worst(difference - np.round(difference))


def area_stretch_error(distribution: Distribution, u: np.ndarray, step: float = 2.0**-11) -> tuple[float, float]:
    """(greatest, mean) of pdf times the stretch of area, minus 1, at points u at least `step` inside a smooth part.

    The stretch is the solid angle of the image of a square of side 2 step, as two spherical triangles, so that it is exact
    for any curvature of the sphere; the density is averaged over the square by Simpson's rule.
    """
    ring = step * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    a, b, c, d = (distribution.sample((u + offset).astype(np.float32)).astype(np.float64) for offset in ring)
    stretch = (np.abs(_solid_angle(a, b, c)) + np.abs(_solid_angle(a, c, d))) / (2.0 * step) ** 2
    weights = np.outer((1, 4, 1), (1, 4, 1)) / 36.0
    inverse = sum(
        weights[i, j] / distribution.pdf(distribution.sample((u + step * np.array((i - 1, j - 1))).astype(np.float32)))
        for i in range(3)
        for j in range(3)
    )
    ratio = stretch / inverse
    return _worst(ratio - 1.0), float((ratio - 1.0).mean())


def mass(distribution: Distribution, cells: int = 512) -> float:
    """The integral of the pdf over the sphere by the midpoint rule in (cos theta, phi); 1 for a density per steradian."""
    return float(_cell_masses(distribution, cells, 8, 8).sum())


def solid_angle_test(distribution: Distribution, w: np.ndarray, rows: int = 40, columns: int = 40) -> HistogramTest:
    """Chi-square of independent directions in cells of equal (cos theta, phi); the expectation is refined until converged.

    The p-value is twice the smaller of the full cells' and of that for as many directions in all the others.

    Raises:
        ValueError: the expected counts do not come to sum to the number of directions.
    """
    from scipy.stats import poisson  # noqa: PLC0415  (slow to import)

    observed, _, _ = np.histogram2d(
        w[:, 2].astype(np.float64),
        np.arctan2(w[:, 1], w[:, 0]).astype(np.float64),
        bins=(np.linspace(-1.0, 1.0, rows + 1), np.linspace(-np.pi, np.pi, columns + 1)),
    )
    observed[0, 0] += len(w) - observed.sum()  # NaN or longer than 1: counted where no such direction belongs
    refine = 4
    while True:
        expected = len(w) * _cell_masses(distribution, rows, columns, refine)
        if abs(expected.sum() - len(w)) <= 1e-3 * len(w):
            break
        refine *= 2
        if refine > 64:
            raise ValueError(f"pdf: its integral over the sphere converges to {expected.sum() / len(w):.5f}, want 1")
    # Cells too empty for the test are judged together by Poisson's law: outside the support one direction is too many.
    full = expected >= 10.0
    rest = float(poisson.sf(observed[~full].sum() - 1, expected[~full].sum()))
    inside = expected[full] * (observed[full].sum() / expected[full].sum())
    if inside.min() < 5.0:  # half of all directions are where none should be: too few are left to compare
        return HistogramTest(observed.ravel(), expected.ravel(), np.full(observed.size, np.inf), np.inf, full.sum(), rest)
    test = histogram_test(observed[full], inside)
    return replace(test, p_value=min(1.0, 2.0 * min(test.p_value, rest)))


def count_p_value(observed: int, draws: int, probability: float) -> float:
    """Two-sided p-value of a count of independent events of known probability: tails, rims, caps."""
    from scipy.stats import binomtest  # noqa: PLC0415  (slow to import)

    return float(binomtest(int(observed), int(draws), probability).pvalue)


def uniform_p_value(values: np.ndarray) -> float:
    """Kolmogorov-Smirnov p-value of independent values against the uniform distribution on (0, 1)."""
    from scipy.stats import kstest  # noqa: PLC0415  (slow to import)

    return float(kstest(values, "uniform").pvalue)


def azimuth_gap_p_value(w: np.ndarray) -> float:
    """p-value of the widest gap between the azimuths of independent directions: a missing sector, however thin.

    n uniform points leave a gap above x turns somewhere with probability about n (1 - x)^(n - 1) (Whitworth 1897).
    """
    turns = np.sort(np.arctan2(w[:, 1], w[:, 0]).astype(np.float64) / (2.0 * np.pi))
    widest = max(np.diff(turns).max(), 1.0 - (turns[-1] - turns[0]))
    return float(min(1.0, len(turns) * (1.0 - widest) ** (len(turns) - 1)))


def mean_error(values: np.ndarray, mean: float) -> float:
    """Distance of the mean of independent values from the known one, in its standard errors."""
    values = values.astype(np.float64)
    return float(abs(values.mean() - mean) / (values.std(ddof=1) / np.sqrt(values.size)))


def _cell_masses(distribution: Distribution, rows: int, columns: int, refine: int) -> np.ndarray:
    """(rows, columns): integral of the pdf over each cell of equal (cos theta, phi), by refine^2 midpoints."""
    z = (np.arange(rows * refine) + 0.5) / (rows * refine) * 2.0 - 1.0
    phi = (np.arange(columns * refine) + 0.5) / (columns * refine) * 2.0 * np.pi - np.pi
    r = np.sqrt(1.0 - z * z)
    w = np.stack(np.broadcast_arrays(r[:, None] * np.cos(phi), r[:, None] * np.sin(phi), z[:, None]), axis=-1)
    density = distribution.pdf(w.astype(np.float32)).astype(np.float64)
    area = 4.0 * np.pi / density.size
    return density.reshape(rows, refine, columns, refine).sum(axis=(1, 3)) * area


def _solid_angle(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Signed solid angle of spherical triangles. Van Oosterom and Strackee 1983, equation (8)."""
    volume = (a * np.cross(b - a, c - a)).sum(axis=-1)
    return 2.0 * np.arctan2(volume, 1.0 + (a * b).sum(axis=-1) + (b * c).sum(axis=-1) + (c * a).sum(axis=-1))


def _worst(errors: np.ndarray) -> float:
    return float(np.abs(errors).max()) if np.isfinite(errors).all() else np.inf
