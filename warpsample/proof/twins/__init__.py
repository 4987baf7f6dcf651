"""Second implementations ("twins") of every map, density and frame, in float64 NumPy, to compare the kernels with.

Where a record states a limit (a clamped edge, a blurred horizon), its twin has the same limit. Parameters are first rounded
to float32, as in the kernels. The module `sequences` has the twins of the sequences, in exact integers.
"""

import numpy as np

from warpsample.distributions.own import Twin, user_distributions
from warpsample.distributions.record import Distribution
from warpsample.proof.twins import lights, microfacets, mixtures, pictures, scattered, shapes
from warpsample.proof.twins.angles import frames, polar_angle, spherical

__all__ = ["check_twin", "density", "directions", "frames", "names", "polar_angle", "spherical"]


def check_twin(distribution: Distribution) -> Twin:
    """Return the second implementation of a distribution in float64 NumPy: functions (directions, density).

    Raises:
        NotImplementedError: the distribution has no twin; the message explains how to add it.
    """
    found = _TWINS.get(distribution.name)
    if found is None and distribution.name in user_distributions:
        found = user_distributions[distribution.name].twin
    if found is None:
        raise NotImplementedError(
            f"distribution: got {distribution!r}, which has no twin to be judged by; write a second implementation in "
            "float64 NumPy, of the directions and of the density, and give it to register(..., twin=(directions, density)), "
            "or, within the package, name it in TWINS of proof/twins/shapes.py"
        )
    return found


def directions(distribution: Distribution, u: np.ndarray) -> np.ndarray:
    """Compute the exact directions of `distribution.sample(u)` in float64, (..., width), for float64 u."""
    return check_twin(distribution)[0](distribution, u)


def density(distribution: Distribution, w: np.ndarray) -> np.ndarray:
    """Compute the exact density of `distribution.pdf(w)` in float64, for float64 w in the support, of about unit length."""
    return check_twin(distribution)[1](distribution, w)


_TWINS = {
    **shapes.TWINS,
    **microfacets.TWINS,
    **lights.TWINS,
    **pictures.TWINS,
    **scattered.twins_of(directions, density),
    **mixtures.twins_of(directions, density),
}


def names() -> set[str]:
    """Return the names of the package's distributions that have a second implementation."""
    return set(_TWINS)
