"""Uniform distribution of directions on the hemisphere about the normal."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import INV_TWO_PI, clamp_uniform, root, sincos_turns


@wp.func
def square_to_uniform_hemisphere(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a uniform direction on the hemisphere about +z.

    z = 1 - u[0], azimuth 2 pi u[1]. sin theta = sqrt(u[0] (2 - u[0])); sqrt(1 - z^2) would be wrong by 4e-5 near the pole.
    """
    r = root(u[0] * (2.0 - u[0]))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], 1.0 - u[0])


@wp.func
def square_to_uniform_hemisphere_pdf(w: wp.vec3) -> wp.float32:
    """Return the density 1 / (2 pi) per steradian where z >= 0, else 0."""
    return wp.where(w[2] >= 0.0, INV_TWO_PI, 0.0)


@wp.func
def uniform_hemisphere_to_square(w: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_uniform_hemisphere` maps to the direction w.

    u[0] = 1 - z = sin^2 theta / (1 + z), which does not cancel near the pole; u[1] the azimuth in turns.
    """
    return wp.vec2(clamp_uniform((w[0] * w[0] + w[1] * w[1]) / wp.max(1.0 + w[2], 1.0e-30)), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class UniformHemisphere(Distribution):
    """Uniform distribution on the hemisphere about the normal, with density 1 / (2 pi) per steradian."""

    name = "uniform_hemisphere"
    density = "1/(2π)"
    support = "hemisphere"
    source = "Nori2025, P(θ) = 1 − cosθ; Pharr2023, section A.5.2"
    maps: ClassVar[Maps] = Maps(square_to_uniform_hemisphere, square_to_uniform_hemisphere_pdf, uniform_hemisphere_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: 1 - cos theta. See `Distribution.cdf`."""
        return 2.0 * np.sin(0.5 * np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) ** 2


RECORD = UniformHemisphere
