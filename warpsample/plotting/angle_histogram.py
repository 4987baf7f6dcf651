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
        return self.test is not None and self.test.p_value < _SURE

    def verdict(self) -> str:
        """Return the result of the comparison with the density in two lines of text: a verdict, and the test's numbers."""
        if self.test is None:
            return "cannot be judged\ntoo few directions"
        agreement = f"{'does NOT agree' if self.is_wrong else 'agrees'} with {self.claim}"
        if not self.independent:
            return f"{agreement}\nevenly spread: residuals up to {self.test.largest_residual:.1f} σ"
        chance = "p < 10⁻⁶" if self.is_wrong else f"p = {self.test.p_value:.3f}"
        note = " (too even)" if self.test.p_value > 1.0 - _SURE else ""
        return f"{agreement}\nχ² = {self.test.chi_square:,.1f}, dof = {self.test.dof}, {chance}{note}"
