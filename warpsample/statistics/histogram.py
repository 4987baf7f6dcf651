"""Chi-square tests of counts in cells against the counts that a density predicts."""

from dataclasses import dataclass

import numpy as np

from warpsample.host.locks import imported

_LEAST_EXPECTED = 5.0  # below this a count is too far from normal for chi-square (Cochran1954)
_LEAST_VARIANCE = 1.0  # of a count with a residual: the error of an expected count is up to a tenth of a direction


@dataclass(frozen=True, eq=False)
class HistogramTest:
    """Result of Pearson's chi-square test of one histogram of K cells.

    Attributes:
        observed: (K,) observed counts.
        expected: (K,) counts expected under the density.
        residuals: (K,) observed - expected, in standard deviations of a binomial count.
        chi_square: the statistic.
        dof: degrees of freedom.
        p_value: probability of at least this chi-square under the density.
    """

    observed: np.ndarray
    expected: np.ndarray
    residuals: np.ndarray
    chi_square: float
    dof: int
    p_value: float

    @property
    def largest_residual(self) -> float:
        """Largest absolute residual of the histogram's cells, in standard deviations."""
        return float(np.abs(self.residuals).max())


def histogram_test(observed: np.ndarray, expected: np.ndarray) -> HistogramTest:
    """Test (K,) observed counts of independent draws against (K,) expected counts, by Pearson's chi-square.

    Raises:
        ValueError: an expected count is below 5, or the sums differ by more than 1e-3 of the total. The expectation is then
            not integrated precisely enough, and the test would reject a correct sampler.
    """
    observed, expected = np.asarray(observed, np.float64), np.asarray(expected, np.float64)
    if not expected.min() >= _LEAST_EXPECTED:
        raise ValueError(
            f"expected: got a count of {expected.min():.3g}, want at least {_LEAST_EXPECTED:g}; use wider cells"
        )
    total = observed.sum()
    if not abs(expected.sum() - total) <= 1e-3 * total:
        raise ValueError(f"expected: got a sum of {expected.sum():.6g}, want that of the observed counts, {total:.6g}")
    difference = observed - expected
    statistic = float((difference**2 / expected).sum())
    dof = len(observed) - 1
    deviation = np.sqrt(expected * (1.0 - expected / total))
    p_value = float(imported("scipy.stats").chi2.sf(statistic, dof))
    return HistogramTest(observed, expected, difference / deviation, statistic, dof, p_value)


def joined_test(observed: np.ndarray, expected: np.ndarray) -> HistogramTest | None:
    """Test observed against expected counts after joining neighbouring cells until each expects at least 5.

    Return None if fewer than two cells remain.
    """
    starts = _join(expected)
    if len(starts) < 2:
        return None
    return histogram_test(np.add.reduceat(observed, starts), np.add.reduceat(expected, starts))


def mixture_test(observed: np.ndarray, probabilities: np.ndarray) -> HistogramTest | None:
    """Test the sum of the histograms of several lobes against the sum of the counts that the lobes' densities predict.

    Each lobe has the same number of independent draws. The counts of the sum vary less than those of one lobe with the mean
    probabilities, so Pearson's statistic would be too small. The statistic here is d C^+ d, for the differences d and their
    covariance matrix C; for a single lobe this is Pearson's. Neighbouring cells are joined until each expects at least 5
    directions. Sums of cells with a variance below 5 along an eigenvector of C are left out for the same reason. The degrees
    of freedom are the number of eigenvectors that remain.

    Args:
        observed: (K,) sum of the counts in each cell.
        probabilities: (L, K) probability of each cell for each lobe.

    Returns:
        the test, with cells after joining, and residuals in standard deviations of the sum; None if no cells can be tested.
    """
    draws = observed.sum() / len(probabilities)
    starts = _join(draws * probabilities.sum(axis=0))
    masses = np.add.reduceat(probabilities, starts, axis=1)
    counts = np.add.reduceat(np.asarray(observed, np.float64), starts)
    expected = draws * masses.sum(axis=0)
    covariance = np.diag(expected) - draws * masses.T @ masses
    variances, along = np.linalg.eigh(covariance)
    tested = variances >= _LEAST_EXPECTED * (1.0 - 1e-9)  # the share is rounding
    if not tested.any():
        return None
    difference = counts - expected
    statistic = float((np.square(difference @ along[:, tested]) / variances[tested]).sum())
    dof = int(tested.sum())
    residuals = standardise(difference, covariance.diagonal())
    p_value = float(imported("scipy.stats").chi2.sf(statistic, dof))
    return HistogramTest(counts, expected, residuals, statistic, dof, p_value)


def standardise(difference: np.ndarray, variance: np.ndarray) -> np.ndarray:
    """Return differences of counts in standard deviations; 0 where the variance is below 1."""
    return np.where(variance >= _LEAST_VARIANCE, difference / np.sqrt(np.maximum(variance, _LEAST_VARIANCE)), 0.0)


def _join(expected: np.ndarray) -> list[int]:
    """Return the first cell of each group of neighbouring cells that together expect at least 5."""
    starts, waiting = [0], 0.0
    for cell, count in enumerate(expected[:-1]):
        waiting += count
        if waiting >= _LEAST_EXPECTED:
            starts.append(cell + 1)
            waiting = 0.0
    if len(starts) > 1 and expected[starts[-1] :].sum() < _LEAST_EXPECTED:
        starts.pop()
    return starts
