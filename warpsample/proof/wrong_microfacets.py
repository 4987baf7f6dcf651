"""Wrong samplers of anisotropic microfacet normals, each with one defect that real samplers have had."""

from collections.abc import Callable
from functools import partial

import numpy as np

from warpsample.distributions.microfacets.beckmann import Beckmann
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.microfacets.visible_beckmann import VisibleBeckmann
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.proof.wrong import WrongSampler

_F = np.float32
_X, _Y, _VIEW = 0.3, 0.1, (0.6, -0.64, 0.48)
_GGX, _BECKMANN = GGX(_X, _Y), Beckmann(_X, _Y)
_VISIBLE_GGX, _VISIBLE_BECKMANN = VisibleGGX(_X, _VIEW, _Y), VisibleBeckmann(_X, _VIEW, _Y)
_MILD = 0.2  # so that the quadrature of the wrong density converges soon
_NARROW = GGX(1e-3, 1e-2)
_MIRROR = VisibleGGX(1e-6, (-0.8, 0.0, 0.6))
_AZIMUTH = 2.0 * np.pi


def _scaled(density: Callable[[np.ndarray], np.ndarray], factor: float, w: np.ndarray) -> np.ndarray:
    """Return a wrong density: the density of directions w times a factor."""
    return (density(w) * factor).astype(_F)


def _unstretched_azimuth(u: np.ndarray) -> np.ndarray:
    """Return wrong anisotropic GGX normals: the azimuth is not stretched by the roughnesses."""
    u = u.astype(np.float64)
    c, s = np.cos(_AZIMUTH * u[..., 1]), np.sin(_AZIMUTH * u[..., 1])
    slope = np.sqrt(u[..., 0] / (1.0 - u[..., 0]) / ((c / _X) ** 2 + (s / _Y) ** 2))
    return _unit(np.stack([slope * c, slope * s, np.ones_like(c)], axis=-1))


def _density_by_cosine(w: np.ndarray) -> np.ndarray:
    """Return the GGX density with float32 rounding errors, by tan^2 theta = (1 - z^2) / z^2 and the azimuth."""
    x, y, z = w.astype(_F).T
    square = z * z
    tangent = (1 - square) / square
    across = np.maximum(x * x + y * y, _F(1e-30))
    e = tangent * (x * x / across / _F(1e-6) + y * y / across / _F(1e-4))
    return np.where(z > 0, 1 / (_F(np.pi) * _F(1e-5) * square * z * (1 + e) ** 2), 0).astype(_F)


def _visible(u: np.ndarray, seen: tuple[float, float, float], lowest: float | None = None) -> np.ndarray:
    """Return visible GGX normals by a cap about the stretched view `seen`, from `lowest` on in place of -seen.z."""
    u, view = u.astype(np.float64), np.array(seen) / np.linalg.norm(seen)
    low = -view[2] if lowest is None else lowest
    z = 1.0 - u[..., 0] * (1.0 - low)
    sine, azimuth = np.sqrt(np.maximum(1.0 - z * z, 0.0)), _AZIMUTH * u[..., 1] + np.arctan2(view[1], view[0])
    cap = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), z], axis=-1)
    return _unit((cap + view) * (_X, _Y, 1.0))


def _unit(w: np.ndarray) -> np.ndarray:
    """Return vectors scaled to unit length, in float32."""
    return (w / np.linalg.norm(w, axis=-1, keepdims=True)).astype(_F)


def _area(x: float, y: float) -> float:
    """Return the projected area of GGX normals visible from the view, for roughnesses x and y."""
    return (_VIEW[2] + np.sqrt((x * _VIEW[0]) ** 2 + (y * _VIEW[1]) ** 2 + _VIEW[2] ** 2)) / 2.0


_STRETCHED = (_X * _VIEW[0], _Y * _VIEW[1], _VIEW[2])
_RIGHT_AREA = _area(_X, _Y)
_MEAN_NORM = _X * _Y / (0.5 * (_X + _Y)) ** 2

WRONG_MICROFACETS: dict[str, WrongSampler] = {
    "GGX with swapped roughnesses": WrongSampler(_GGX, sample=GGX(_Y, _X).sample),
    "GGX with the mean roughness in the norm": WrongSampler(_GGX, pdf=partial(_scaled, _GGX.pdf, _MEAN_NORM)),
    "GGX with an unstretched azimuth": WrongSampler(_GGX, sample=_unstretched_azimuth),
    "anisotropic GGX density by 1 − z²": WrongSampler(_NARROW, pdf=_density_by_cosine),
    "GGX density without alpha_y": WrongSampler(GGX(_X, _MILD), pdf=GGX(_X).pdf),
    "Beckmann with swapped roughnesses": WrongSampler(_BECKMANN, sample=Beckmann(_Y, _X).sample),
    "Beckmann with the mean roughness in the norm": WrongSampler(_BECKMANN, pdf=partial(_scaled, _BECKMANN.pdf, _MEAN_NORM)),
    "Beckmann density without alpha_y": WrongSampler(Beckmann(_X, _MILD), pdf=Beckmann(_X).pdf),
    "visible GGX with an unstretched view": WrongSampler(_VISIBLE_GGX, sample=partial(_visible, seen=_VIEW)),
    "visible GGX with a cap from 0": WrongSampler(_VISIBLE_GGX, sample=partial(_visible, seen=_STRETCHED, lowest=0.0)),
    "visible GGX with the area of the mean roughness": WrongSampler(
        _VISIBLE_GGX, pdf=partial(_scaled, _VISIBLE_GGX.pdf, _RIGHT_AREA / _area(0.2, 0.2))
    ),
    "visible GGX with the area of alpha": WrongSampler(
        _VISIBLE_GGX, pdf=partial(_scaled, _VISIBLE_GGX.pdf, _RIGHT_AREA / _area(_X, _X))
    ),
    "visible GGX with alpha clamped at 1e-3": WrongSampler(_MIRROR, sample=VisibleGGX(1e-3, _MIRROR.view).sample),
    "visible Beckmann with swapped roughnesses": WrongSampler(
        _VISIBLE_BECKMANN, sample=VisibleBeckmann(_Y, _VIEW, _X).sample
    ),
    "visible Beckmann with the density of alpha": WrongSampler(
        VisibleBeckmann(_X, _VIEW, _MILD), pdf=VisibleBeckmann(_X, _VIEW).pdf
    ),
}
"""Wrong samplers, keyed by name."""
