"""All directions, equally likely."""

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
    """z = 1 - 2 u[0], azimuth 2 pi u[1]; sin theta as 2 sqrt(u (1 - u)), where sqrt(1 - z^2) loses 4e-5 near the poles."""
    r = 2.0 * root(u[0] * (1.0 - u[0]))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], 1.0 - 2.0 * u[0])


@wp.func
def square_to_uniform_sphere_pdf(w: wp.vec3) -> wp.float32:
    """1 / (4 pi) per steradian."""
    return wp.where(w[2] == w[2], _PDF, 0.0)


@wp.func
def uniform_sphere_to_square(w: wp.vec3) -> wp.vec2:
    """(1 - z) / 2, from sin^2 theta on the pole's side, where 1 - z would cancel."""
    near_pole = 0.5 * (w[0] * w[0] + w[1] * w[1]) / (1.0 + wp.abs(w[2]))
    return wp.vec2(clamp_uniform(wp.where(w[2] > 0.0, near_pole, 1.0 - near_pole)), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class UniformSphere(Distribution):
    """Uniform on the unit sphere: 1 / (4 pi) per steradian."""

    name = "uniform_sphere"
    density = "1/(4π)"
    support = "sphere"
    source = "Nori2025, UniformSphere; Pharr2023, section A.5.2"
    maps: ClassVar[Maps] = Maps(square_to_uniform_sphere, square_to_uniform_sphere_pdf, uniform_sphere_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """(1 - cos theta) / 2. See `Distribution.cdf`."""
        return np.sin(0.5 * theta) ** 2


RECORD = UniformSphere
