"""The judges: every map, density and frame once more in float64 NumPy, slow and written differently from the kernels.

Where a record states a limit (an edge held, a horizon blurred), its twin holds and blurs the same. Parameters are rounded
to float32 first, as the kernels take them. The twins of the sequences, in exact integers, are in `sequences`.
"""

import numpy as np

from warpsample.distributions.record import Distribution
from warpsample.proof.twins import microfacets, shapes
from warpsample.proof.twins.angles import frames, polar_angle, spherical

__all__ = ["density", "directions", "frames", "names", "polar_angle", "spherical"]

_TWINS = {**shapes.TWINS, **microfacets.TWINS}


def directions(distribution: Distribution, u: np.ndarray) -> np.ndarray:
    """What `distribution.sample(u)` should be: (..., width) float64 for float64 u."""
    return _TWINS[distribution.name][0](distribution, u)


def density(distribution: Distribution, w: np.ndarray) -> np.ndarray:
    """What `distribution.pdf(w)` should be at w in the support: float64 for float64 w of about unit length."""
    return _TWINS[distribution.name][1](distribution, w)


def names() -> set[str]:
    """The distributions that have a twin."""
    return set(_TWINS)
