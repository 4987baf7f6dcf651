"""GGX (Trowbridge-Reitz) distribution of microfacet normals: the normals of an ellipsoid, with long tails."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import INV_PI, clamp_uniform, fma, root, sincos_turns


@wp.func
def square_to_ggx(u: wp.vec2, alpha: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a GGX microfacet normal about +z.

    tan^2 theta = alpha^2 u[0] / (1 - u[0]), azimuth 2 pi u[1].
    """
    above = 1.0 - u[0]
    across = alpha * alpha * u[0]
    inverse = 1.0 / (above + across)
    r = root(across * inverse)
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.sqrt(above * inverse))


@wp.func
def square_to_ggx_pdf(w: wp.vec3, alpha: wp.float32) -> wp.float32:
    """Return the GGX density of a normal w, per steradian; 0 below the surface.

    The density is alpha^2 cos theta / (pi (sin^2 theta + alpha^2 cos^2 theta)^2), with theta the angle between w and +z.
    """
    across = fma(w[0], w[0], w[1] * w[1])
    ratio = alpha / fma(alpha * w[2], alpha * w[2], across)
    return wp.where(w[2] > 0.0, INV_PI * w[2] * ratio * ratio, 0.0)


@wp.func
def ggx_to_square(w: wp.vec3, alpha: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_ggx` maps to the direction w.

    u[0] = sin^2 theta / (sin^2 theta + alpha^2 cos^2 theta), u[1] the azimuth in turns.
    """
    across = w[0] * w[0] + w[1] * w[1]
    return wp.vec2(clamp_uniform(across / (across + alpha * alpha * (w[2] * w[2]))), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class GGX(Distribution):
    """GGX distribution of microfacet normals m, with density D(m) cosθ = α²cosθ / (π(sin²θ + α²cos²θ)²) per steradian.

    Attributes:
        alpha: roughness, from 1e-6 to 1; 1 gives the cosine lobe.
    """

    alpha: float

    name = "ggx"
    density = "α²cosθ/(π(sin²θ+α²cos²θ)²)"
    support = "hemisphere"
    parameters: ClassVar[tuple[str, ...]] = ("alpha",)
    shown: ClassVar[Range] = (0.01, 1.0)
    bounds: ClassVar[Range] = (1e-6, 1.0)
    source = "Walter2007, equations 33, 35 and 36"
    case_values: ClassVar[Cases] = ((1e-6,), (0.01,), (0.3,), (1.0,))  # from almost a mirror to the cosine lobe
    maps: ClassVar[Maps] = Maps(square_to_ggx, square_to_ggx_pdf, ggx_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the cdf of the angle, sin^2 theta / (sin^2 theta + alpha^2 cos^2 theta). See `Distribution.cdf`."""
        theta = np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)
        sine, cosine = np.sin(theta), np.cos(theta)
        return sine**2 / (sine**2 + (self.alpha * cosine) ** 2)


RECORD = GGX
