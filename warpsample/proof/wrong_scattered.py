"""Wrong samplers of scattered light and of mixtures, each with one defect that real samplers have had."""

import numpy as np

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.distributions.mixture import Mixture
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.scattering.reflection import Reflection
from warpsample.distributions.scattering.rough_dielectric import RoughDielectric
from warpsample.proof.wrong import WrongSampler

_F = np.float32
_VIEW = (0.6, -0.64, 0.48)
_SEEN = Reflection(VisibleGGX(0.5, _VIEW), _VIEW)
_ALL = Reflection(GGX(0.5), _VIEW)
_ROUND = Reflection(HenyeyGreenstein(0.3), _VIEW)
_ETA, _SLANTED = 1.5, (0.6, 0.0, 0.8)
_GLASS = RoughDielectric(VisibleGGX(0.4, _SLANTED), _SLANTED, _ETA)
_BELOW = RoughDielectric(VisibleGGX(0.4, _SLANTED), (-0.6, 0.0, -0.8), _ETA)
_MIRRORED = RoughDielectric(VisibleGGX(0.4, _SLANTED), (-0.6, 0.0, 0.8), 1.0 / _ETA)
_MIXED = Mixture([CosineHemisphere(), GGX(0.3)], [0.3, 0.7])


def _not_stretched(u: np.ndarray) -> np.ndarray:
    """Return directions of the chosen lobe at the u[0] that chose it, so that each lobe gets a part of the unit interval."""
    return np.where(u[..., :1] < _MIXED.weights[0], *(lobe.sample(u) for lobe in _MIXED.lobes))


def _normal(w: np.ndarray) -> np.ndarray:
    """Return the (..., 3) unit normals that reflect the view to the directions w, in float64."""
    half = w.astype(np.float64) + _VIEW
    return half / np.maximum(np.linalg.norm(half, axis=-1, keepdims=True), 1e-30)


def _by_z(w: np.ndarray) -> np.ndarray:
    """Return the density of a reflection with the cosine to +z in place of that to the view."""
    m = _normal(w)
    return (_SEEN.pdf(w) * (m @ _VIEW) / np.maximum(np.abs(m[..., 2]), 1e-6)).astype(_F)


def _signed(w: np.ndarray) -> np.ndarray:
    """Return the density of a reflection with the cosine of the normal above the surface in place of its magnitude."""
    m = _normal(w)
    return (_ALL.pdf(w) * np.where(m[..., 2] < 0.0, -1.0, 1.0)).astype(_F)


def _of_one_normal(w: np.ndarray) -> np.ndarray:
    """Return the density of a reflection without that of the opposite normal."""
    m = _normal(w)
    return (_ROUND.lobe.pdf(m.astype(_F)) / np.maximum(4.0 * (m @ _VIEW), 1e-7)).astype(_F)


def _fresnel(cosine: np.ndarray) -> np.ndarray:
    """Return Fresnel's share of glass."""
    behind = np.sqrt(1.0 - (1.0 - cosine * cosine) / _ETA**2)
    parallel = (_ETA * cosine - behind) / (_ETA * cosine + behind)
    perpendicular = (cosine - _ETA * behind) / (cosine + _ETA * behind)
    return (parallel * parallel + perpendicular * perpendicular) / 2.0


def _parts(w: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the densities of both parts of glass without Fresnel's share, and the cosines of both normals."""
    w = w.astype(np.float64)
    half, along = w + _SLANTED, w * _ETA + _SLANTED
    length, size = (np.maximum(np.linalg.norm(x, axis=-1), 1e-30) for x in (half, along))
    h, t = half / length[..., None], -along / size[..., None]
    front, behind = t @ _SLANTED, -np.einsum("...i,...i", w, t)
    refracted = _GLASS.lobe.pdf(t.astype(_F)) * behind * _ETA**2 / size**2
    refracted = np.where((front > 0.0) & (behind > 0.0), refracted, 0.0)
    return (
        _GLASS.lobe.pdf(h.astype(_F)) / (2.0 * length),
        refracted,
        np.clip(0.5 * length, 0.0, 1.0),
        np.clip(front, 0.0, 1.0),
    )


def _with_one_share(w: np.ndarray) -> np.ndarray:
    """Return the density of glass with Fresnel's share at the mean normal."""
    reflected, refracted, _, _ = _parts(w)
    share = _fresnel(np.float64(_SLANTED[2]))
    return np.nan_to_num(share * reflected + (1.0 - share) * refracted).astype(_F)


def _without_index(w: np.ndarray) -> np.ndarray:
    """Return the density of glass without the square of the index in the refracted part."""
    _, refracted, _, front = _parts(w)
    return (_GLASS.pdf(w) - np.nan_to_num((1.0 - _fresnel(front)) * refracted) * (1.0 - 1.0 / _ETA**2)).clip(0.0).astype(_F)


def _chosen_by_first_number(u: np.ndarray) -> np.ndarray:
    """Return directions of glass, reflected where u[0] is below Fresnel's share."""
    m = _GLASS.lobe.sample(u).astype(np.float64)
    cosine = (m @ _SLANTED)[..., None]
    bent = (cosine / _ETA - np.sqrt(1.0 - (1.0 - cosine * cosine) / _ETA**2)) * m - np.array(_SLANTED) / _ETA
    return np.where(u[..., :1] < _fresnel(cosine), 2.0 * cosine * m - _SLANTED, bent).astype(_F)


WRONG_SCATTERED: dict[str, WrongSampler] = {
    "reflection by 1/(2 v·h)": WrongSampler(_SEEN, pdf=lambda w: 2.0 * _SEEN.pdf(w)),
    "reflection with v·h by z": WrongSampler(_SEEN, pdf=_by_z),
    "reflection mirrored up": WrongSampler(
        _SEEN, sample=lambda u: np.abs(_SEEN.sample(u) * _F([0, 0, 1])) + _SEEN.sample(u) * _F([1, 1, 0])
    ),
    "reflection with a signed cosine": WrongSampler(_ALL, pdf=_signed),
    "mixture with u[0] not stretched": WrongSampler(_MIXED, sample=_not_stretched),
    "mixture with the density of one lobe": WrongSampler(_MIXED, pdf=_MIXED.lobes[1].pdf),
    "mixture in reversed order": WrongSampler(_MIXED, sample=Mixture(_MIXED.lobes[::-1], _MIXED.weights).sample),
    "reflection without −h": WrongSampler(_ROUND, pdf=_of_one_normal),
    "glass with Fresnel's share at v·n": WrongSampler(_GLASS, pdf=_with_one_share),
    "glass without η²": WrongSampler(_GLASS, pdf=_without_index),
    "glass with η for 1/η from below": WrongSampler(
        _BELOW, sample=RoughDielectric(_BELOW.lobe, _BELOW.view, 1.0 / _ETA).sample
    ),
    "glass mirrored at the plane": WrongSampler(_BELOW, sample=lambda u: _MIRRORED.sample(u) * _F([1, 1, -1])),
    "glass with the choice by u[0]": WrongSampler(_GLASS, sample=_chosen_by_first_number),
}
"""Wrong samplers, keyed by name."""
