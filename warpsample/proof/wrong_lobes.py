"""Wrong samplers of lobes with several parameters, each with one defect that real samplers have had."""

from functools import partial

import numpy as np

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.scattering.linearly_transformed_cosine import LinearlyTransformedCosine
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.proof.wrong import WrongSampler

_F = np.float32
_UNIFORM = UniformSphere()
_FORWARD, _BACKWARD, _ALMOST_UNIFORM, _BEAM = map(HenyeyGreenstein, (0.7, -0.7, 5e-4, 0.9999))

_TRANSFORMED, _MIRRORED = (LinearlyTransformedCosine.cases()[i] for i in (1, -1))


def _henyey_greenstein_by_cosine(g: float, u: np.ndarray) -> np.ndarray:
    """Return directions of the phase function with float32 rounding errors, by the usual formula for the cosine."""
    g, (x, turns) = _F(g), u.astype(_F).T
    quotient = (1 - g * g) / (1 - g + 2 * g * (1 - x))
    cosine = (1 + g * g - quotient * quotient) / (2 * g)
    sine = np.sqrt(np.maximum(1 - cosine * cosine, 0))
    circle = np.stack([f(2 * np.pi * turns.astype(np.float64)) for f in (np.cos, np.sin)]).astype(_F)
    return np.stack([*(sine * circle), cosine], axis=-1)


def _henyey_greenstein_of_power_1(w: np.ndarray) -> np.ndarray:
    """Return a wrong phase function for g = 0.7: the power 1 in place of 3/2, normalised to the integral 1."""
    g, cosine = 0.7, w[..., 2].astype(np.float64)
    factor = g / (2.0 * np.pi * np.log((1.0 + g) / (1.0 - g)))
    return np.nan_to_num(factor / (1.0 + g * g - 2.0 * g * cosine)).astype(_F)


def _of_power_2(w: np.ndarray) -> np.ndarray:
    """Return a wrong density of a linearly transformed cosine: a length to the power 2 instead of 3."""
    length = np.linalg.norm(w.astype(np.float64) @ np.linalg.inv(_TRANSFORMED.stretch).T, axis=-1)
    return (_TRANSFORMED.pdf(w) * length).astype(_F)


def _not_normalised(u: np.ndarray) -> np.ndarray:
    """Return wrong directions of a linearly transformed cosine, which do not have unit length."""
    return (CosineHemisphere().sample(u).astype(np.float64) @ np.array(_TRANSFORMED.stretch).T).astype(_F)


WRONG_LOBES: dict[str, WrongSampler] = {
    "Henyey-Greenstein of −g": WrongSampler(_FORWARD, sample=_BACKWARD.sample),
    "Henyey-Greenstein uniform below 1e-3": WrongSampler(_ALMOST_UNIFORM, sample=_UNIFORM.sample, pdf=_UNIFORM.pdf),
    "Henyey-Greenstein uniform for g < 0": WrongSampler(_BACKWARD, sample=_UNIFORM.sample, pdf=_UNIFORM.pdf),
    "Henyey-Greenstein by the usual quotient": WrongSampler(_BEAM, sample=partial(_henyey_greenstein_by_cosine, 0.9999)),
    "Henyey-Greenstein of the power 1": WrongSampler(_FORWARD, pdf=_henyey_greenstein_of_power_1),
    "cosine transformed by the inverse": WrongSampler(
        _TRANSFORMED, sample=LinearlyTransformedCosine(np.linalg.inv(_TRANSFORMED.stretch)).sample
    ),
    "cosine transformed by the transpose": WrongSampler(
        _TRANSFORMED, sample=LinearlyTransformedCosine(np.array(_TRANSFORMED.stretch).T).sample
    ),
    "transformed cosine with a signed determinant": WrongSampler(_MIRRORED, pdf=lambda w: -_MIRRORED.pdf(w)),
    "transformed cosine of the power 2": WrongSampler(_TRANSFORMED, pdf=_of_power_2),
    "transformed cosine not normalised": WrongSampler(_TRANSFORMED, sample=_not_normalised),
}
"""Wrong samplers, keyed by name."""
