"""Uniform distribution of directions on the unit sphere."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import clamp_uniform, root, sincos_turns

_PDF = wp.constant(wp.float32(0.07957747154594767))  # 1 / (4 pi)


@wp.func
def square_to_uniform_sphere(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a uniform direction on the unit sphere.

    z = 1 - 2 u[0], azimuth 2 pi u[1]. sin theta = 2 sqrt(u[0] (1 - u[0])); sqrt(1 - z^2) would lose 4e-5 near the poles.
    """
    r = 2.0 * root(u[0] * (1.0 - u[0]))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], 1.0 - 2.0 * u[0])


@wp.func
def square_to_uniform_sphere_pdf(w: wp.vec3) -> wp.float32:
    """Return the density 1 / (4 pi) per steradian; 0 where w is NaN."""
    return wp.where(w[2] == w[2], _PDF, 0.0)


@wp.func
def uniform_sphere_to_square(w: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_uniform_sphere` maps to the direction w.

    u[0] = (1 - z) / 2, computed from sin^2 theta because 1 - z would cancel near the pole; u[1] the azimuth in turns.
    """
    near_pole = 0.5 * (w[0] * w[0] + w[1] * w[1]) / (1.0 + wp.abs(w[2]))
    return wp.vec2(clamp_uniform(wp.where(w[2] > 0.0, near_pole, 1.0 - near_pole)), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class UniformSphere(Distribution):
    """Uniform distribution on the unit sphere, with density 1 / (4 pi) per steradian."""

    name = "uniform_sphere"
    density = "1/(4π)"
    support = "sphere"
    source = "Nori2025, UniformSphere; Pharr2023, section A.5.2"
    maps: ClassVar[Maps] = Maps(square_to_uniform_sphere, square_to_uniform_sphere_pdf, uniform_sphere_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: (1 - cos theta) / 2. See `Distribution.cdf`."""
        return np.sin(0.5 * theta) ** 2


RECORD = UniformSphere
