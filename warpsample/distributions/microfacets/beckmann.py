"""Beckmann distribution of microfacet normals: a rough surface with Gaussian slopes."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.microfacets.base import Microfacets
from warpsample.distributions.record import Cases, Maps, Range
from warpsample.maths.angles import tan_squared, turns_of
from warpsample.maths.anisotropy import contracted, contracted_tan_squared, mean_and_stretch, stretched_to_unit
from warpsample.maths.exponentials import exp_double, log1p
from warpsample.maths.numerics import INV_PI_DOUBLE, ONE, clamp_uniform, root, sincos_turns


@wp.func
def square_to_beckmann(u: wp.vec2, alpha: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a Beckmann microfacet normal about +z.

    tan^2 theta = -alpha^2 log(1 - u[0]), azimuth 2 pi u[1]. Sine and cosine are computed from the tangent, for precision.
    """
    t = -(alpha * alpha) * log1p(-u[0])
    inverse = 1.0 / (1.0 + t)
    r = root(t * inverse)
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.sqrt(inverse))


@wp.func
def square_to_beckmann_pdf(w: wp.vec3, alpha: wp.float32) -> wp.float32:
    """Return the Beckmann density of a normal w, per steradian; 0 below the surface.

    The density is e^(-tan^2 theta / alpha^2) / (pi alpha^2 cos^3 theta), with theta the angle between w and +z.
    """
    return _density(w, tan_squared(w), wp.float64(alpha) * wp.float64(alpha))


@wp.func
def _density(w: wp.vec3, t: wp.float64, square: wp.float64) -> wp.float32:
    """Return the Beckmann density of a normal w, from its scaled squared slope t and the product of both roughnesses."""
    secant_squared = ONE + tan_squared(w)
    density = exp_double(-t / square)[1] * secant_squared * wp.sqrt(secant_squared) * INV_PI_DOUBLE / square
    return wp.where(w[2] > 0.0, wp.float32(density), 0.0)


@wp.func
def beckmann_to_square(w: wp.vec3, alpha: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_beckmann` maps to the direction w.

    u[0] = 1 - e^(-tan^2 theta / alpha^2), u[1] the azimuth in turns.
    """
    square = wp.float64(alpha) * wp.float64(alpha)
    return wp.vec2(clamp_uniform(-wp.float32(exp_double(-tan_squared(w) / square)[0])), turns_of(w[0], w[1]))


@wp.func
def square_to_anisotropic_beckmann(u: wp.vec2, alpha: wp.float32, alpha_y: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a Beckmann normal about +z, of roughness alpha along x and alpha_y along y.

    The normal has the slopes r (alpha cos phi, alpha_y sin phi) with r^2 = -log(1 - u[0]) and phi = 2 pi u[1].
    """
    m = mean_and_stretch(alpha, alpha_y)
    return stretched_to_unit(square_to_beckmann(u, m[0]), m)


@wp.func
def square_to_anisotropic_beckmann_pdf(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32) -> wp.float32:
    """Return the anisotropic Beckmann density of a normal w, per steradian; 0 below the surface.

    The density is e^(-((w.x / alpha)^2 + (w.y / alpha_y)^2) / w.z^2) / (pi alpha alpha_y w.z^3).
    """
    return _density(w, contracted_tan_squared(w, alpha, alpha_y), wp.float64(alpha) * wp.float64(alpha_y))


@wp.func
def anisotropic_beckmann_to_square(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_anisotropic_beckmann` maps to the direction w."""
    m = mean_and_stretch(alpha, alpha_y)
    return beckmann_to_square(contracted(w, m), m[0])


@dataclass(frozen=True)
class Beckmann(Microfacets):
    """Beckmann distribution of the microfacet normals of a rough surface, whose slopes are normally distributed.

    The density of a normal m = (x, y, z), z = cosθ, is D(m) cosθ = exp(−(x²/α_x² + y²/α_y²)/z²) / (π α_x α_y z³) per
    steradian. For equal roughnesses it is exp(−tan²θ/α²) / (π α² cos³θ).

    Attributes:
        alpha: roughness, sqrt(2) times the root mean square slope, from 1e-6 to 1. With `alpha_y`, the roughness along the
            x axis of the frame.
        alpha_y: roughness along the y axis of the frame, from 1e-6 to 1. Default: that along x.
    """

    alpha: float
    alpha_y: float | None = None

    name = "beckmann"
    density = "exp(−(x²/α_x²+y²/α_y²)/cos²θ)/(πα_xα_ycos³θ)"
    shown: ClassVar[Range] = (0.01, 1.0)
    source = "Nori2025, Beckmann; Walter2007, equations 25, 28 and 29; Heitz2014, by stretching, for alpha_y"
    # From a mirror to chalk; brushed along y, and along x.
    case_values: ClassVar[Cases] = (
        *((1e-6,), (1e-3,), (0.01,), (0.1,), (0.5,)),
        *((1e-6, 1e-3), (0.5, 0.01), (0.3, 0.1), (1.0,)),
    )
    isotropic: ClassVar[Maps] = Maps(square_to_beckmann, square_to_beckmann_pdf, beckmann_to_square)
    anisotropic: ClassVar[Maps] = Maps(
        square_to_anisotropic_beckmann, square_to_anisotropic_beckmann_pdf, anisotropic_beckmann_to_square
    )

    def _isotropic_cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: 1 - exp(-tan^2 theta / alpha^2)."""
        return -np.expm1(-((np.tan(np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) / self.alpha) ** 2))


RECORD = Beckmann
