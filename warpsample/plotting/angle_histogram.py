"""Histogram of an angle of many directions, compared with a density, and the verdict of the comparison in words."""

from dataclasses import dataclass

import numpy as np

from warpsample.statistics.histogram import HistogramTest

_SURE = 1e-6  # p-values below this, or above 1 minus this, do not happen by chance


@dataclass(frozen=True, eq=False)
class AngleHistogram:
    """Histogram of an angle of directions, compared with the counts that a density predicts.

    Attributes:
        edges: (K + 1,) edges of the bins, degrees.
        observed: (K,) density of the directions, per radian.
        expected: (K,) mean of the compared density over each bin, per radian.
        angles: (M,) angles of `density`, degrees.
        density: (M,) compared density, per radian.
        residuals: (K,) observed minus expected count, in standard deviations of independent counts; 0 in bins that expect
            less than one direction.
        test: chi-square test over all bins, joined until each expects enough directions; None if there are too few
            directions.
        independent: whether the directions are independent of each other. Counts of evenly spread directions vary less: then
            a large p-value means nothing, and a small one still shows a wrong sampler.
        claim: name of the compared density, for the verdict.
    """

    edges: np.ndarray
    observed: np.ndarray
    expected: np.ndarray
    angles: np.ndarray
    density: np.ndarray
    residuals: np.ndarray
    test: HistogramTest | None
    independent: bool
    claim: str = "the density"

    @property
    def is_wrong(self) -> bool:
        """True if the directions certainly do not follow the compared density."""
        return is_certainly_wrong(self.test)

    def verdict(self) -> str:
        """Return the result of the comparison with the density in two lines of text: a verdict, and the test's numbers."""
        return describe_test(self.test, self.independent, self.claim)


def is_certainly_wrong(test: HistogramTest | None) -> bool:
    """Return whether a test rejects its density with certainty."""
    return test is not None and test.p_value < _SURE


def describe_test(test: HistogramTest | None, independent: bool, claim: str) -> str:
    """Describe a chi-square test of directions against a density in two lines of text: a verdict, and the test's numbers.

    Args:
        test: the test; None if there are too few directions.
        independent: whether the directions are independent of each other.
        claim: name of the density.
    """
    if test is None:
        return "cannot be judged\ntoo few directions"
    wrong = is_certainly_wrong(test)
    agreement = f"{'does NOT agree' if wrong else 'agrees'} with {claim}"
    if not independent:
        return f"{agreement}\nevenly spread: residuals up to {test.largest_residual:.1f} σ"
    chance = "p < 10⁻⁶" if wrong else f"p = {test.p_value:.3f}"
    note = " (too even)" if test.p_value > 1.0 - _SURE else ""
    return f"{agreement}\nχ² = {test.chi_square:,.1f}, dof = {test.dof}, {chance}{note}"
