"""An angle of many directions against the density that it should have, and the verdict in words."""

from dataclasses import dataclass

import numpy as np

from warpsample.statistics.histogram import HistogramTest

_SURE = 1e-6  # p-values below it, or above 1 - it, do not happen by chance


@dataclass(frozen=True, eq=False)
class AngleHistogram:
    """Counts of an angle, and what a density predicts.

    Attributes:
        edges: (K + 1,) degrees.
        observed: (K,) density of the directions, per radian.
        expected: (K,) mean of the claimed density over each bin, per radian.
        angles: (M,) degrees.
        density: (M,) the claimed density at those angles, per radian.
        residuals: (K,) observed minus expected count, in standard deviations of independent counts; 0 in bins that
            expect too few directions to be judged.
        test: over all bins, joined until each expects enough; None if there are too few directions.
        independent: whether the directions are independent of each other. The counts of evenly spread ones vary less, so
            that chi-square's p-value says nothing about a sampler that passes, while one that fails is wrong all the more.
    """

    edges: np.ndarray
    observed: np.ndarray
    expected: np.ndarray
    angles: np.ndarray
    density: np.ndarray
    residuals: np.ndarray
    test: HistogramTest | None
    independent: bool

    @property
    def wrong(self) -> bool:
        """Whether the directions certainly do not have the density."""
        return self.test is not None and self.test.p_value < _SURE

    def verdict(self) -> str:
        """Whether the directions agree with the density, in words; and on a second line the numbers behind it."""
        if self.test is None:
            return "cannot be judged\ntoo few directions"
        if self.wrong:
            said = "does NOT agree"
        elif self.independent and self.test.p_value > 1.0 - _SURE:
            said = "agrees more evenly than chance"
        else:
            said = "agrees"
        if not self.independent:
            return f"{said} (evenly spread points)\nlargest residual {self.test.largest_residual:.1f} σ"
        chance = "p < 10⁻⁶" if self.wrong else f"p = {self.test.p_value:.3f}"
        return f"{said} with the density\nχ² = {self.test.chi_square:,.1f}, dof = {self.test.dof}, {chance}"
