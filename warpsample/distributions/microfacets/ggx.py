"""GGX (Trowbridge-Reitz) distribution of microfacet normals: the normals of an ellipsoid, with long tails."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.microfacets.base import Microfacets
from warpsample.distributions.record import Cases, Maps, Range
from warpsample.maths.angles import turns_of
from warpsample.maths.anisotropy import contracted, mean_and_stretch, stretched_to_unit
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


@wp.func
def square_to_anisotropic_ggx(u: wp.vec2, alpha: wp.float32, alpha_y: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a GGX microfacet normal about +z, of roughness alpha along x and alpha_y along y.

    The normal has the slopes r (alpha cos phi, alpha_y sin phi) with r^2 = u[0] / (1 - u[0]) and phi = 2 pi u[1].
    """
    m = mean_and_stretch(alpha, alpha_y)
    return stretched_to_unit(square_to_ggx(u, m[0]), m)


@wp.func
def square_to_anisotropic_ggx_pdf(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32) -> wp.float32:
    """Return the anisotropic GGX density of a normal w, per steradian; 0 below the surface.

    The density is w.z / (pi alpha alpha_y ((w.x / alpha)^2 + (w.y / alpha_y)^2 + w.z^2)^2).
    """
    m = mean_and_stretch(alpha, alpha_y)
    return square_to_ggx_pdf(contracted(w, m), m[0])


@wp.func
def anisotropic_ggx_to_square(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_anisotropic_ggx` maps to the direction w."""
    m = mean_and_stretch(alpha, alpha_y)
    return ggx_to_square(contracted(w, m), m[0])


@dataclass(frozen=True)
class GGX(Microfacets):
    """GGX (Trowbridge-Reitz) distribution of the microfacet normals of a rough surface.

    The density of a normal m = (x, y, z) is D(m) cosθ = cosθ / (π α_x α_y (x²/α_x² + y²/α_y² + z²)²) per steradian. For
    equal roughnesses it is α² cosθ / (π (sin²θ + α² cos²θ)²).

    Attributes:
        alpha: roughness, from 1e-6 to 1; 1 gives the cosine lobe. With `alpha_y`, the roughness along the x axis of the
            frame.
        alpha_y: roughness along the y axis of the frame, from 1e-6 to 1. Default: that along x.
    """

    alpha: float
    alpha_y: float | None = None

    name = "ggx"
    density = "cosθ/(πα_xα_y(x²/α_x²+y²/α_y²+cos²θ)²)"
    shown: ClassVar[Range] = (0.01, 1.0)
    source = "Walter2007, equations 33, 35 and 36; Heitz2014, by stretching, for alpha_y"
    # From almost a mirror to the cosine lobe; brushed along y, and along x.
    case_values: ClassVar[Cases] = ((1e-6,), (0.01,), (0.3,), (1e-6, 1e-3), (0.5, 0.01), (0.3, 0.1), (1.0,))
    isotropic: ClassVar[Maps] = Maps(square_to_ggx, square_to_ggx_pdf, ggx_to_square)
    anisotropic: ClassVar[Maps] = Maps(square_to_anisotropic_ggx, square_to_anisotropic_ggx_pdf, anisotropic_ggx_to_square)

    def _isotropic_cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta. See `Distribution.cdf`.

        It is sin^2 theta / (sin^2 theta + alpha^2 cos^2 theta).
        """
        theta = np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)
        sine, cosine = np.sin(theta), np.cos(theta)
        return sine**2 / (sine**2 + (self.alpha * cosine) ** 2)


RECORD = GGX
