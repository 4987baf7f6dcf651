"""Map of directions over (cos theta, phi), compared with a density, and the verdict of the comparison in words."""

from dataclasses import dataclass

import numpy as np

from warpsample.plotting.angle_histogram import describe_test, is_certainly_wrong
from warpsample.statistics.histogram import HistogramTest


@dataclass(frozen=True, eq=False)
class CellMap:
    """Counts of directions in cells of cos theta and phi, compared with the counts that densities predict.

    Attributes:
        edges: (R + 1,) descending cosines of theta at the edges of the rows.
        observed: (R, C) share of the directions in each cell, per steradian.
        expected: (R, C) mean of the compared densities over each cell and over the points, per steradian.
        residuals: (R, C) observed minus expected count, in standard deviations; 0 in cells whose count varies by less than
            one direction.
        test: chi-square test over all cells, also those outside the map; None if there are too few directions.
        independent: whether the directions are independent of each other; see `AngleHistogram`.
        claim: name of the compared density, for the verdict.
    """

    edges: np.ndarray
    observed: np.ndarray
    expected: np.ndarray
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
