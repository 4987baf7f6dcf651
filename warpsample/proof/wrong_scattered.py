"""Wrong samplers of scattered light, each with one defect that real samplers have had."""

import numpy as np

from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.scattering.reflection import Reflection
from warpsample.proof.wrong import WrongSampler

_F = np.float32
_VIEW = (0.6, -0.64, 0.48)
_SEEN = Reflection(VisibleGGX(0.5, _VIEW), _VIEW)
_ALL = Reflection(GGX(0.5), _VIEW)
_ROUND = Reflection(HenyeyGreenstein(0.3), _VIEW)


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


WRONG_SCATTERED: dict[str, WrongSampler] = {
    "reflection by 1/(2 v·h)": WrongSampler(_SEEN, pdf=lambda w: 2.0 * _SEEN.pdf(w)),
    "reflection with v·h by z": WrongSampler(_SEEN, pdf=_by_z),
    "reflection mirrored up": WrongSampler(
        _SEEN, sample=lambda u: np.abs(_SEEN.sample(u) * _F([0, 0, 1])) + _SEEN.sample(u) * _F([1, 1, 0])
    ),
    "reflection with a signed cosine": WrongSampler(_ALL, pdf=_signed),
    "reflection without −h": WrongSampler(_ROUND, pdf=_of_one_normal),
}
"""Wrong samplers, keyed by name."""
