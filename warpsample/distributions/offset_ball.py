"""Direction to a random point in the unit ball that touches the surface from above: density 2 cos^3(theta) / pi."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import TWO_OVER_PI, clamp_uniform, root, sincos_turns


@wp.func
def square_to_offset_ball(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a direction about +z with density 2 cos^3(theta) / pi per steradian.

    cos theta = (1 - u[0])^(1/4), azimuth 2 pi u[1]. sin theta = sqrt(u[0] / (1 + sqrt(1 - u[0]))), since
    sqrt(1 - cos^2 theta) would cancel.
    """
    above = wp.sqrt(1.0 - u[0])
    r = root(u[0] / (1.0 + above))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.sqrt(above))


@wp.func
def square_to_offset_ball_pdf(w: wp.vec3) -> wp.float32:
    """Return the density 2 cos^3(theta) / pi per steradian above the surface, else 0. Chizhov2019, section 4.1."""
    return wp.where(w[2] > 0.0, TWO_OVER_PI * (w[2] * w[2] * w[2]), 0.0)


@wp.func
def offset_ball_to_square(w: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_offset_ball` maps to the direction w.

    u[0] = 1 - cos^4 theta = sin^2 theta (1 + cos^2 theta), u[1] the azimuth in turns.
    """
    small = w[0] * w[0] + w[1] * w[1]
    return wp.vec2(clamp_uniform(small * (1.0 + w[2] * w[2])), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class OffsetBall(Distribution):
    """Direction of the normal plus a random point in the unit ball, with density 2 cos³θ / π per steradian.

    Use the cosine lobe instead for a cosine integrand: the weight cosθ / pdf is proportional to 1 / cos²θ, which is
    unbounded at the horizon.
    """

    name = "offset_ball"
    density = "2cos³θ/π"
    support = "hemisphere"
    source = "Chizhov2019, sections 4.1 and 4.2"
    maps: ClassVar[Maps] = Maps(square_to_offset_ball, square_to_offset_ball_pdf, offset_ball_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: 1 - cos^4 theta. See `Distribution.cdf`."""
        sin_squared = np.sin(np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) ** 2
        return sin_squared * (2.0 - sin_squared)


RECORD = OffsetBall
