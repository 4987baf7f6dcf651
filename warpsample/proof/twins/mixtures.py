"""Second implementation of mixtures, built from those of their lobes."""

from collections.abc import Callable
from typing import Any

import numpy as np

Function = Callable[[Any, np.ndarray], np.ndarray]


def twins_of(directions: Function, density: Function) -> dict[str, tuple[Function, Function]]:
    """Build the second implementation (map, density) of mixtures, keyed by the name of the distribution.

    Args:
        directions: map of the twin of any distribution.
        density: density of the twin of any distribution.
    """

    def mixed(d: Any, u: np.ndarray) -> np.ndarray:
        """Return directions of the lobes in whose intervals u[0] lies, at the stretched and truncated u[0]."""
        shares = np.array(d.weights)
        ends = np.cumsum(shares)
        chosen = np.searchsorted(ends, u[..., 0], side="right")
        within = (u[..., 0] - (ends - shares)[chosen]) / shares[chosen]
        inner = np.stack([np.floor(within * 2.0**24) / 2.0**24, u[..., 1]], axis=-1)
        found = np.empty((*u.shape[:-1], 3))
        for i, lobe in enumerate(d.lobes):
            found[chosen == i] = directions(lobe, inner[chosen == i])
        return found

    def mixed_density(d: Any, w: np.ndarray) -> np.ndarray:
        """Return the weighted sum of the densities of all lobes, with 0 below the surface for lobes on the hemisphere."""
        above = [lobe.support != "hemisphere" or w[..., 2] >= 0.0 for lobe in d.lobes]
        parts = zip(d.weights, d.lobes, above, strict=True)
        return sum(weight * np.where(seen, density(lobe, w), 0.0) for weight, lobe, seen in parts)

    return {"mixture": (mixed, mixed_density)}
