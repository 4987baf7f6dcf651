"""Planar direction to a random point on the unit circle that touches the surface from above: uniform in angle."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import INV_PI, clamp_uniform, sincos_turns


@wp.func
def square_to_offset_circle(u: wp.vec2) -> wp.vec2:
    """Map u[0] to a planar direction with uniform angle theta in [-pi/2, pi/2) to +y; u[1] is not used.

    The direction is (sin theta, cos theta) with theta = (u[0] - 1/2) pi. Chizhov2019, section 3.4, third method.
    """
    cs = sincos_turns(0.5 * u[0])
    return wp.vec2(-cs[0], cs[1])


@wp.func
def square_to_offset_circle_pdf(w: wp.vec2) -> wp.float32:
    """Return the density 1 / pi per radian on the half circle about +y, else 0. Chizhov2019, section 3.3."""
    return wp.where(w[1] >= 0.0, INV_PI, 0.0)


@wp.func
def offset_circle_to_square(w: wp.vec2) -> wp.vec2:
    """Return (theta / pi + 1/2, 0), the point that `square_to_offset_circle` maps to the direction w."""
    return wp.vec2(clamp_uniform(2.0 * turns_of(-w[0], w[1])), 0.0)


@dataclass(frozen=True)
class OffsetCircle(Distribution):
    """Planar direction of the normal plus a random point on the unit circle: density 1/π per radian, θ in [−π/2, π/2]."""

    name = "offset_circle"
    density = "1/π"
    measure = "per radian"
    support = "half circle"
    width = 2
    variates = 1
    source = "Chizhov2019, sections 3.3 and 3.4"
    maps: ClassVar[Maps] = Maps(square_to_offset_circle, square_to_offset_circle_pdf, offset_circle_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the signed angle to +y is at most theta: theta / pi + 1/2. See `Distribution.cdf`.

        Chizhov2019 prints + 1 in error.
        """
        return np.clip(theta, -np.pi / 2.0, np.pi / 2.0, dtype=np.float64) / np.pi + 0.5


RECORD = OffsetCircle
