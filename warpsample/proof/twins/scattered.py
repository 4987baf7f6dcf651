"""Second implementations of lobes of scattered light, built from those of the lobes of normals."""

from collections.abc import Callable
from typing import Any

import numpy as np

from warpsample.proof.twins.angles import BLUR

Function = Callable[[Any, np.ndarray], np.ndarray]


def twins_of(directions: Function, density: Function) -> dict[str, tuple[Function, Function]]:
    """Build the second implementations (map, density) of lobes of scattered light, keyed by the lobe's name.

    Args:
        directions: map of the twin of any distribution.
        density: density of the twin of any distribution.
    """

    def reflected(d: Any, u: np.ndarray) -> np.ndarray:
        """Return the reflected directions: the view rotated by half a turn about each normal."""
        m, v = directions(d.lobe, u), d.view_of_kernels
        along = (m @ v)[..., None] * m
        return along - (v - along)

    def reflected_density(d: Any, w: np.ndarray) -> np.ndarray:
        """Return the density of w: that of both normals times the change of solid angle (Walter2007, equation 14)."""
        half = w + d.view_of_kernels
        length = np.sqrt(np.einsum("...i,...i", half, half))
        m, cosine = half / length[..., None], 0.5 * length
        return (_normals(density, d, m, cosine) + _normals(density, d, -m, -cosine)) / (4.0 * cosine)

    return {"reflection": (reflected, reflected_density)}


def _normals(density: Function, d: Any, m: np.ndarray, cosine: np.ndarray) -> np.ndarray:
    """Return the density of the normals m that reflect the view v, from m and the cosine m.v, in float64."""
    lobe = d.lobe
    if not hasattr(lobe, "view"):
        return _inside(lobe, m, density(lobe, m))
    seen = np.array(lobe.view, np.float32).astype(np.float64)
    by_product = m @ seen
    own = np.maximum(by_product, BLUR * (np.abs(m) @ np.abs(seen)))  # the cosine in the lobe's density
    facing = cosine if (seen == d.view_of_kernels).all() else np.where(by_product > 0.0, by_product, 0.0)
    return np.where((m[..., 2] > 0.0) & (facing > 0.0), density(lobe, m) / own * facing, 0.0)


def _inside(lobe: Any, m: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Return the densities `value`, with 0 for normals m below the surface if the lobe covers the upper hemisphere only."""
    upper = lobe.support == "hemisphere" and lobe.name != "linearly_transformed_cosine"
    return np.where(m[..., 2] >= 0.0, value, 0.0) if upper else value
