"""Uniform distribution on the unit disk, by two area-preserving maps of the unit square."""

from dataclasses import dataclass
from typing import ClassVar, Literal, get_args

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps
from warpsample.host.arguments import check_choice
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import GRID, INV_PI, clamp_uniform, root, sincos_eighth, sincos_turns

Method = Literal["polar", "concentric"]

_HALF_CELL = wp.constant(wp.float32(1.0 / GRID))
_RIM = wp.constant(wp.float32(1.0 + 5e-7))  # points within rounding of the edge are in the disk


@wp.func
def square_to_uniform_disk(u: wp.vec2) -> wp.vec2:
    """Map a point of the unit square to a uniform point of the unit disk, with polar coordinates.

    Radius sqrt(u[0]), azimuth 2 pi u[1]. Cranberry2020; Nori2025; Chizhov2019, section 3.2.
    """
    r = root(u[0])
    cs = sincos_turns(u[1])
    return wp.vec2(r * cs[0], r * cs[1])


@wp.func
def uniform_disk_to_square(p: wp.vec2) -> wp.vec2:
    """Return the point u of the unit square that `square_to_uniform_disk` maps to the point p."""
    return wp.vec2(clamp_uniform(p[0] * p[0] + p[1] * p[1]), turns_of(p[0], p[1]))


@wp.func
def square_to_concentric_disk(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to (x, y, radius) of a uniform point of the unit disk, by the concentric map.

    Shirley1997 maps squares to rings, so that neighbours stay neighbours. The multiples of 2^-24 are shifted to the middles
    of their cells, exactly, so that the radius stays below 1. The map is not differentiable on the diagonals of the square;
    the gradient there is that of one side.
    """
    a = (2.0 * u[0] - 1.0) + _HALF_CELL
    b = (2.0 * u[1] - 1.0) + _HALF_CELL
    a_longer = wp.abs(a) > wp.abs(b)
    longer = wp.where(a_longer, a, b)
    ratio = wp.where(a_longer, b, a) / wp.where(longer == 0.0, 1.0, longer)
    cs = sincos_eighth(0.125 * ratio)
    return wp.vec3(longer * wp.where(a_longer, cs[0], cs[1]), longer * wp.where(a_longer, cs[1], cs[0]), wp.abs(longer))


@wp.func
def square_to_uniform_disk_concentric(u: wp.vec2) -> wp.vec2:
    """Map a point of the unit square to a uniform point (x, y) of the unit disk, by the concentric map of Shirley1997."""
    p = square_to_concentric_disk(u)
    return wp.vec2(p[0], p[1])


@wp.func
def uniform_disk_to_square_concentric(p: wp.vec2) -> wp.vec2:
    """Return the point u of the unit square that `square_to_uniform_disk_concentric` maps to the point p.

    The radius is the longer coordinate; the angle within the octant is the ratio of the coordinates. The inverse is not
    differentiable on the diagonals, where the gradient is finite, and at the centre, where the gradient is 0.
    """
    # The gradient of copysign, unlike that of wp.abs, handles -0.0 and so cancels the gradient of the copysign below.
    ax = wp.copysign(p[0], 1.0)
    ay = wp.copysign(p[1], 1.0)
    longer = root(ax * ax + ay * ay)
    shorter = 8.0 * longer * turns_of(wp.max(ax, ay), wp.min(ax, ay))
    a = wp.copysign(wp.where(ax > ay, longer, shorter), p[0])
    b = wp.copysign(wp.where(ax > ay, shorter, longer), p[1])
    return wp.vec2(clamp_uniform(0.5 * (a + 1.0 - _HALF_CELL)), clamp_uniform(0.5 * (b + 1.0 - _HALF_CELL)))


@wp.func
def square_to_uniform_disk_pdf(p: wp.vec2) -> wp.float32:
    """Return the density 1 / pi per unit area inside the unit circle, else 0."""
    return wp.where(p[0] * p[0] + p[1] * p[1] <= _RIM, INV_PI, 0.0)


_MAPS = {
    "polar": Maps(square_to_uniform_disk, square_to_uniform_disk_pdf, uniform_disk_to_square),
    "concentric": Maps(square_to_uniform_disk_concentric, square_to_uniform_disk_pdf, uniform_disk_to_square_concentric),
}


@dataclass(frozen=True)
class UniformDisk(Distribution):
    """Uniform distribution of points (x, y) on the unit disk, with density 1 / pi per unit area.

    Attributes:
        method: map of the square: "polar" (radius sqrt(u[0]), azimuth 2 pi u[1]) or "concentric" (Shirley1997; less
            distortion).
    """

    method: Method = "polar"

    name = "uniform_disk"
    density = "1/π"
    measure = "per unit area"
    support = "disk"
    width = 2
    source = "Cranberry2020; Nori2025, UniformDisk; Shirley1997"
    case_values: ClassVar[Cases] = tuple((method,) for method in get_args(Method))

    def __post_init__(self) -> None:
        """Raise an error if the name of the sampling method is unknown."""
        check_choice(self.method, "method", get_args(Method))

    @property
    def maps(self) -> Maps:
        """Warp functions of the distribution for kernels: map, density and inverse."""
        return _MAPS[self.method]

    @property
    def largest_angle(self) -> float:
        """Radius of the unit disk, in place of an angle."""
        return 1.0

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the radius is at most theta: theta squared. See `Distribution.cdf`."""
        return np.clip(theta, 0.0, 1.0, dtype=np.float64) ** 2


RECORD = UniformDisk
