"""All directions above the surface, equally likely."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import INV_TWO_PI, clamp_uniform, root, sincos_turns


@wp.func
def square_to_uniform_hemisphere(u: wp.vec2) -> wp.vec3:
    """z = 1 - u[0], azimuth 2 pi u[1]; sin theta as sqrt(u (2 - u)), where sqrt(1 - z^2) loses 4e-5 near the pole."""
    r = root(u[0] * (2.0 - u[0]))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], 1.0 - u[0])


@wp.func
def square_to_uniform_hemisphere_pdf(w: wp.vec3) -> wp.float32:
    """1 / (2 pi) per steradian where z >= 0, else 0."""
    return wp.where(w[2] >= 0.0, INV_TWO_PI, 0.0)


@wp.func
def uniform_hemisphere_to_square(w: wp.vec3) -> wp.vec2:
    """1 - z, from sin^2 theta, which does not cancel near the pole."""
    return wp.vec2(clamp_uniform((w[0] * w[0] + w[1] * w[1]) / wp.max(1.0 + w[2], 1.0e-30)), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class UniformHemisphere(Distribution):
    """Uniform on the hemisphere about the normal: 1 / (2 pi) per steradian."""

    name = "uniform_hemisphere"
    density = "1/(2π)"
    support = "hemisphere"
    source = "Nori2025, P(θ) = 1 − cosθ; Pharr2023, section A.5.2"
    maps: ClassVar[Maps] = Maps(square_to_uniform_hemisphere, square_to_uniform_hemisphere_pdf, uniform_hemisphere_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """1 - cos theta. See `Distribution.cdf`."""
        return 2.0 * np.sin(0.5 * np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) ** 2


RECORD = UniformHemisphere
