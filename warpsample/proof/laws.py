"""Tests of samplers, one function each, which returns a measured error or the p-value of a statistical test.

The functions take distributions and arrays, not meshes. They assert nothing; `verify` and the tests compare their results
with limits. A wrong sampler may return anything, so NaN counts as the worst error.
"""

from collections.abc import Iterator

import numpy as np

from warpsample.maths.numerics import GRID
from warpsample.statistics.charts import DISK, Sampler, chart_of, support_of
from warpsample.statistics.histogram import histogram_test
from warpsample.statistics.quadrature import cell_masses

SLAB = 1 << 16  # float64 arrays of this length stay in a core's cache
_SPREAD = 0x9E3779B1  # odd, so k -> k * _SPREAD mod 2^24 takes every value once
_COLUMNS = 16
_LEAST_COUNT = 10.0  # least expected count of a cell in Pearson's test


def corner_grid() -> np.ndarray:
    """Return points of the unit square where samplers tend to fail (corners, edges, ...), (N, 2) float32.

    These are the ends, the middle, quarters, eighths, and their neighbours.
    """
    edges = np.array(
        [0, 1, 2, 1 << 8, 1 << 16, GRID // 8, GRID // 4, 3 * GRID // 8, GRID // 2, 5 * GRID // 8, 3 * GRID // 4]
    )
    near = np.unique(np.concatenate([edges + step for step in (-1, 0, 1)] + [[GRID - 1, GRID - 2, GRID - 257]]))
    values = near[(near >= 0) & (near < GRID)] / GRID
    return np.stack(np.meshgrid(values, values), axis=-1).reshape(-1, 2).astype(np.float32)


def all_variates(every: int = 1) -> Iterator[np.ndarray]:
    """Yield arrays of points of the unit square; overall, each coordinate takes all 2^24 multiples of 2^-24 once.

    Each array has up to 2^16 points, float32.

    With `every` above 1 only every n-th point is yielded, and always the last of the grid.
    """
    for start in range(0, GRID, SLAB * every):
        k = np.arange(start, min(start + SLAB * every, GRID), every, dtype=np.int64) + (every - 1)
        yield np.stack([k / GRID, (k * _SPREAD % GRID) / GRID], axis=1).astype(np.float32)


def length_error(w: np.ndarray) -> float:
    """Return the greatest deviation of the length of directions w from 1."""
    w = w.astype(np.float64)
    return worst(np.sqrt(_dot(w, w)) - 1.0)


def angle_error(w: np.ndarray, twin: np.ndarray) -> float:
    """Return the largest angle, in radians, between float32 directions and exact directions computed in float64.

    It is computed from the component of w perpendicular to the twin, and is pi if some angle is 90 degrees or more.
    """
    along = _dot(w, twin)
    across = w - along[..., None] * twin
    return worst(np.sqrt(_dot(across, across))) if (along > 0.0).all() else np.pi


def distance_error(w: np.ndarray, twin: np.ndarray) -> float:
    """Return the largest distance between float32 points and exact points computed in float64."""
    difference = w - twin
    return worst(np.sqrt(_dot(difference, difference)))


def sine_error(w: np.ndarray, twin: np.ndarray) -> float:
    """Return the largest relative error of the sine of the angle between directions and +z."""
    exact = twin[..., 0] ** 2 + twin[..., 1] ** 2
    ratio = (w[..., 0] ** 2 + w[..., 1] ** 2) / np.maximum(exact, 1e-60)
    return worst(np.sqrt(ratio) - (exact > 0.0))  # at the pole itself any nonzero sine is an error


def density_error(pdf: np.ndarray, exact: np.ndarray) -> float:
    """Return the greatest relative error of densities, compared with exact densities."""
    return worst(pdf.astype(np.float64) / exact - 1.0)


def round_trip_error(back: np.ndarray, u: np.ndarray) -> float:
    """Return the largest difference between u and invert(sample(u)), modulo 1."""
    difference = back.astype(np.float64) - u
    return worst(difference - np.round(difference))


def area_stretch_error(sampler: Sampler, u: np.ndarray, step: float = 2.0**-11) -> tuple[float, float]:
    """Return the (largest, mean) deviation from 1 of the density times the local stretch of areas by the map.

    The product is 1 for a correct sampler.

    The stretch is the area of the image of a square of side 2 `step`, divided by the area of the square. On the sphere the
    image is two spherical triangles, so that the area is exact for any curvature. The density is averaged over the square by
    Simpson's rule.

    Args:
        sampler: sampler with a map and a density.
        u: (N, 2) points of the unit square, at least `step` inside a smooth part of the map.
        step: half the side of the square.
    """
    ring = step * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    a, b, c, d = (sampler.sample((u + offset).astype(np.float32)).astype(np.float64) for offset in ring)
    area = _triangle if chart_of(sampler) is DISK else _solid_angle
    stretch = (np.abs(area(a, b, c)) + np.abs(area(a, c, d))) / (2.0 * step) ** 2
    weights = np.outer((1, 4, 1), (1, 4, 1)) / 36.0
    inverse = sum(
        weights[i, j] / sampler.pdf(sampler.sample((u + step * np.array((i - 1, j - 1))).astype(np.float32))).astype(float)
        for i in range(3)
        for j in range(3)
    )
    ratio = stretch / inverse
    return worst(ratio - 1.0), worst((ratio - 1.0).mean())


def density_outside(sampler: Sampler) -> float:
    """Return the greatest density that a sampler has outside its support and at NaN; infinite if a density is NaN."""
    chart, (low, high) = chart_of(sampler), support_of(sampler)
    away = np.linspace(1e-3, 1.0, 200) ** 2
    beyond = np.concatenate([high + (chart.high - high) * away, low + (chart.low - low) * away])
    beyond = beyond[(beyond > high + 1e-6 * (high - low)) | (beyond < low)]
    width = chart.point(np.zeros(1), np.zeros(1)).shape[-1]
    w = np.concatenate(
        [chart.point(beyond[:, None], np.linspace(0.0, 1.0, 17)).reshape(-1, width), np.full((1, width), np.nan)]
    )
    return worst(sampler.pdf(w.astype(np.float32)))


def cells_p_value(sampler: Sampler, w: np.ndarray, edges: np.ndarray) -> float:
    """Return the p-value of a chi-square test of independent directions w against a sampler's density.

    The cells of the test are bounded by polar coordinates `edges` and by azimuths.

    It is twice the smaller p-value of the cells with enough counts and of the sum of all other cells.

    Raises:
        ValueError: the integral of the density is not within 1e-3 of 1, or does not converge.
    """
    from scipy.stats import poisson

    chart = chart_of(sampler)
    observed, _, _ = np.histogram2d(
        chart.polar(w), chart.azimuth(w), bins=(edges, np.linspace(0.0, 1.0, _COLUMNS + 1) if chart.azimuths > 1.0 else 1)
    )
    observed = observed if chart.azimuths > 1.0 else observed.reshape(-1, 1)
    masses = cell_masses(sampler, edges, observed.shape[1])
    if not abs(masses.sum() - 1.0) <= 1e-3:
        raise ValueError(f"pdf: got an integral of {masses.sum():.5f}, want 1")
    expected = len(w) * masses
    lost = len(w) - observed.sum()  # NaN, or outside the chart
    # Cells too empty for the test are added and compared with a Poisson distribution: outside the support one hit fails.
    full = expected >= _LEAST_COUNT
    rest = float(poisson.sf(observed[~full].sum() + lost - 1, max(expected[~full].sum(), 1e-30)))
    inside = expected[full] * (observed[full].sum() / expected[full].sum())
    if inside.min() < 5.0:  # most directions are in nearly empty cells: too few remain for chi-square
        return rest
    return joint_p_value(histogram_test(observed[full], inside).p_value, rest)


def mass_error(sampler: Sampler, edges: np.ndarray) -> float:
    """Return by how much the integral of a sampler's density differs from 1."""
    return worst(cell_masses(sampler, edges, _COLUMNS).sum() - 1.0)


def angles_p_value(sampler: Sampler, a: np.ndarray) -> float:
    """Return the p-value of a Kolmogorov-Smirnov test of angles to the normal against the sampler's cdf."""
    return uniform_p_value(sampler.cdf(a))


def tails_p_value(sampler: Sampler, a: np.ndarray) -> float:
    """Return the p-value of the numbers of directions at very small and very large angles.

    It is twice the smaller p-value of the two tails.

    The tails are at the pole and at the far end of the coordinate a.
    """
    low, high = (_quantile(sampler, p) for p in (sampler.thinnest_tail, 1.0 - sampler.thinnest_tail))
    near = count_p_value((a < low).sum(), len(a), float(sampler.cdf(low)))
    return joint_p_value(near, count_p_value((~(a <= high)).sum(), len(a), 1.0 - float(sampler.cdf(high))))


def moments_p_value(sampler: Sampler, a: np.ndarray, edges: np.ndarray) -> float:
    """Return the p-value of the mean angle and mean squared angle of directions, compared with integrals of the density.

    It is twice the smaller p-value of the two means.
    """
    from scipy.stats import norm

    scale = np.abs(a).mean()
    first, second, fourth = (
        float(cell_masses(sampler, edges, _COLUMNS, weight).sum()) / np.float_power(scale, weight) for weight in (1, 2, 4)
    )
    errors = [
        ((a / scale).mean() - first) / np.sqrt(second - first**2),
        (((a / scale) ** 2).mean() - second) / np.sqrt(fourth - second**2),
    ]
    return joint_p_value(*(_reject_nan(2.0 * norm.sf(abs(e) * np.sqrt(len(a)))) for e in errors))


def azimuth_p_value(w: np.ndarray) -> float:
    """Return the p-value of Rayleigh's test of whether directions w prefer one azimuth.

    Under a uniform azimuth, n R^2 of the mean unit vector is exponentially distributed (Mardia2000).
    """
    turns = np.exp(2j * np.pi * DISK.azimuth(w))
    return _reject_nan(np.exp(-(np.abs(turns.mean()) ** 2) * len(turns)))


def azimuth_gap_p_value(w: np.ndarray) -> float:
    """Return the p-value of the widest gap between azimuths of independent directions; it reveals any missing sector.

    n uniform points leave a gap above x turns somewhere with probability about n (1 - x)^(n - 1) (Whitworth1897).
    """
    turns = np.sort(DISK.azimuth(w))
    widest = max(np.diff(turns).max(), 1.0 - (turns[-1] - turns[0]))
    return _reject_nan(min(1.0, len(turns) * np.float_power(1.0 - widest, len(turns) - 1)))


def count_p_value(observed: int, draws: int, probability: float) -> float:
    """Return the two-sided p-value of a count of independent events with known probability."""
    from scipy.stats import binomtest

    return float(binomtest(int(observed), int(draws), probability).pvalue)


def uniform_p_value(values: np.ndarray) -> float:
    """Return the p-value of a Kolmogorov-Smirnov test of independent values against the uniform distribution on (0, 1)."""
    from scipy.stats import kstest

    return _reject_nan(kstest(np.asarray(values, np.float64), "uniform", method="asymp").pvalue)


def correlation_p_value(a: np.ndarray, b: np.ndarray) -> float:
    """Return the p-value of the sample correlation of independent pairs of uniform values."""
    from scipy.stats import norm

    return _reject_nan(2.0 * norm.sf(abs(np.corrcoef(a, b)[0, 1]) * np.sqrt(len(a))))


def joint_p_value(*p_values: float) -> float:
    """Return the combined p-value of several tests: the smallest times the number of tests, at most 1 (Bonferroni)."""
    return min(1.0, len(p_values) * min(p_values))


def worst(errors: np.ndarray) -> float:
    """Return the greatest absolute value of errors; infinite if an error is NaN, 0 for an empty array."""
    greatest = float(np.abs(errors).max(initial=0.0))
    return greatest if np.isfinite(greatest) else np.inf


def _quantile(sampler: Sampler, probability: float) -> float:
    """Return the quantile of a sampler's angle to the normal at a probability, by bisection of the cdf."""
    low, high = support_of(sampler)
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if sampler.cdf(middle) < probability else (low, middle)
    return high


def _dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the dot products of vectors a and b along the last axis."""
    return np.einsum("...i,...i", a, b)  # three times as fast as .sum(axis=-1) over an axis of 3


def _reject_nan(p_value: float) -> float:
    """Return a p-value as a float; NaN becomes 0, which rejects."""
    return float(p_value) if np.isfinite(p_value) else 0.0


def _solid_angle(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the signed solid angle of spherical triangles with unit vectors as corners (VanOosterom1983, equation 8)."""
    volume = (a * np.cross(b - a, c - a)).sum(axis=-1)
    return 2.0 * np.arctan2(volume, 1.0 + (a * b).sum(axis=-1) + (b * c).sum(axis=-1) + (c * a).sum(axis=-1))


def _triangle(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the signed area of triangles in the plane."""
    first, second = b - a, c - a
    return 0.5 * (first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0])
