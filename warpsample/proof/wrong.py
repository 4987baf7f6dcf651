"""Sampler with deliberately wrong functions, to test the tests."""

from collections.abc import Callable
from typing import Any

import numpy as np

from warpsample.distributions.record import Distribution


class WrongSampler:
    """Deliberately wrong sampler: a distribution with some of its functions replaced by wrong ones."""

    def __init__(self, claims: Distribution, **replaced: Callable[[np.ndarray], np.ndarray]):
        """Store the correct distribution and the wrong functions that replace some of its functions.

        Args:
            claims: distribution that the sampler claims to be.
            replaced: functions `sample`, `pdf` or `invert`, by name. They replace the methods of `Distribution` with these
                names: `sample` maps points of the unit square, (..., 2), to directions, (..., 3); `pdf` returns densities,
                (...), of directions; `invert` maps directions to points of the unit square. In the plane, directions are
                (..., 2).
        """
        self.claims = claims
        self.__dict__.update(replaced)

    def __getattr__(self, name: str) -> Any:
        """Return the distribution's attribute for all names that are not replaced."""
        return getattr(self.claims, name)
