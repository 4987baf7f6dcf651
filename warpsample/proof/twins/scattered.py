"""Second implementations of lobes of scattered light, built from those of the lobes of normals."""

from collections.abc import Callable
from typing import Any

import numpy as np

from warpsample.proof.twins.angles import BLUR

Function = Callable[[Any, np.ndarray], np.ndarray]
RIM = 1e-3
"""Squared cosine behind the interface, times the square of eta, below which directions are not compared."""
_WORD = np.uint64(2**32 - 1)


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
        return _both(density, d.lobe, half / length[..., None], 0.5 * length, d.view_of_kernels) / (2.0 * length)

    def passed(d: Any, u: np.ndarray) -> np.ndarray:
        """Return the view reflected or refracted at normals (Walter2007, equations 39 and 40), by Fresnel's share.

        Where rounding decides between both, and close to the rim of total reflection, it is the direction of the kernel.
        """
        v, eta, sign = _scene(d)
        m = directions(d.lobe, u)
        cosine = m @ v
        m, cosine = m * np.sign(cosine)[..., None], np.abs(cosine)
        behind = 1.0 - (1.0 - cosine**2) / eta**2  # the squared cosine behind the interface
        root = np.sqrt(np.maximum(behind, 0.0))
        share, chance = _fresnel(cosine, root, eta), _hashed(u)
        bent = (cosine / eta - root)[..., None] * m - v / eta
        found = np.where((chance < share)[..., None], 2.0 * cosine[..., None] * m - v, bent)
        own = d.sample(u.astype(np.float32)).astype(np.float64)
        unsure = (np.abs(behind) * eta**2 < RIM) | (np.abs(chance - share) < 1e-5 + 3e-6 / np.maximum(eta * root, 1e-3))
        return np.where(unsure[..., None], own, sign * found)

    def passed_density(d: Any, w: np.ndarray) -> np.ndarray:
        """Return the densities of reflection and refraction together (Walter2007, equations 14 and 17)."""
        v, eta, sign = _scene(d)
        w = sign * w
        half = w + v
        length = np.sqrt(np.einsum("...i,...i", half, half))
        cosine = 0.5 * length
        root = np.sqrt(np.maximum(1.0 - (1.0 - cosine**2) / eta**2, 0.0))
        share = np.where(root > 0.0, _fresnel(cosine, root, eta), 1.0)
        reflection = _both(density, d.lobe, half / length[..., None], cosine, v) * share / (4.0 * cosine)
        reflection = np.where(length > 0.0, reflection, 0.0)
        along = v + eta * w
        size = np.sqrt(np.einsum("...i,...i", along, along))
        t = -np.sign(eta - 1.0) * along / size[..., None]
        front, behind = t @ v, -np.einsum("...i,...i", w, t)
        bends = (front > 0.0) & (behind > 0.0)
        share = _fresnel(front, behind, eta)
        refraction = _both(density, d.lobe, t, front, v) * (1.0 - share) * behind * eta**2 / size**2
        return reflection + np.where(bends, refraction, 0.0)

    return {"reflection": (reflected, reflected_density), "rough_dielectric": (passed, passed_density)}


def _scene(d: Any) -> tuple[np.ndarray, float, float]:
    """Return (view, eta) as if the view came from above, and the sign of its z."""
    v, eta = d.view_of_kernels, np.float32(d.eta)
    return (v, float(eta), 1.0) if v[2] >= 0.0 else (-v, float(np.float32(1.0) / eta), -1.0)


def _fresnel(front: np.ndarray, behind: np.ndarray, eta: float) -> np.ndarray:
    """Return Fresnel's share from both cosines, by the usual quotients; 1 where `behind` is 0."""
    parallel = (eta * front - behind) / (eta * front + behind)
    perpendicular = (front - eta * behind) / (front + eta * behind)
    return (parallel**2 + perpendicular**2) / 2.0


def _hashed(u: np.ndarray) -> np.ndarray:
    """Return the third uniform number of points of the square, in exact integers."""
    first, second = np.moveaxis((u * 2.0**24).astype(np.uint64), -1, 0)
    return (_finalize(_finalize(first) + second * np.uint64(0x9E3779B9) & _WORD) >> np.uint64(8)) / 2.0**24


def _finalize(word: np.ndarray) -> np.ndarray:
    """Mix 32-bit words with the finaliser fmix32 of Appleby2016."""
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35), (16, 1)):
        word = (word ^ word >> np.uint64(shift)) * np.uint64(factor) & _WORD
    return word


def _both(density: Function, lobe: Any, m: np.ndarray, cosine: np.ndarray, view: np.ndarray) -> np.ndarray:
    """Return the density of normals m and -m together, for the cosine m.v."""
    return _normals(density, lobe, m, cosine, view) + _normals(density, lobe, -m, -cosine, view)


def _normals(density: Function, lobe: Any, m: np.ndarray, cosine: np.ndarray, view: np.ndarray) -> np.ndarray:
    """Return the density of the normals m that reflect the view v, from m and the cosine m.v, in float64."""
    if not hasattr(lobe, "view"):
        return _inside(lobe, m, density(lobe, m))
    seen = np.array(lobe.view, np.float32).astype(np.float64)
    by_product = m @ seen
    own = np.maximum(by_product, BLUR * (np.abs(m) @ np.abs(seen)))  # the cosine in the lobe's density
    facing = cosine if (seen == view).all() else np.where(by_product > 0.0, by_product, 0.0)
    with np.errstate(all="ignore"):  # of normals below the surface
        return np.where((m[..., 2] > 0.0) & (facing > 0.0), density(lobe, m) / own * facing, 0.0)


def _inside(lobe: Any, m: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Return the densities `value`, with 0 for normals m below the surface if the lobe covers the upper hemisphere only."""
    upper = lobe.support == "hemisphere" and lobe.name != "linearly_transformed_cosine"
    return np.where(m[..., 2] >= 0.0, value, 0.0) if upper else value
