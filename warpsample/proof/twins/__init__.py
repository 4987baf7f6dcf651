"""Second implementations, the twins: every map, density and frame in float64 NumPy, written differently from the kernels.

Where a record states a limit (a clamped edge, a blurred horizon), its twin does the same. Parameters are first rounded to
float32, as the kernels take them. The twins of the sequences, in exact integers, are in `sequences`.
"""

import numpy as np

from warpsample.distributions.record import Distribution
from warpsample.proof.twins import microfacets, shapes
from warpsample.proof.twins.angles import frames, polar_angle, spherical

__all__ = ["density", "directions", "frames", "names", "polar_angle", "spherical"]

_TWINS = {**shapes.TWINS, **microfacets.TWINS}


def directions(distribution: Distribution, u: np.ndarray) -> np.ndarray:
    """The exact value of `distribution.sample(u)`: (..., width) float64 for float64 u."""
    return _TWINS[distribution.name][0](distribution, u)


def density(distribution: Distribution, w: np.ndarray) -> np.ndarray:
    """The exact value of `distribution.pdf(w)` for w in the support: float64 for float64 w of about unit length."""
    return _TWINS[distribution.name][1](distribution, w)


def names() -> set[str]:
    """The distributions that have a twin."""
    return set(_TWINS)
