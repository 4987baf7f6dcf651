"""The unit disk, by two maps of the square that preserve area: the basis of the cosine lobe, and for lenses."""

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
    """Radius sqrt(u[0]), azimuth 2 pi u[1]. Cranberry2020, Nori2025; Chizhov2019, section 3.2."""
    r = root(u[0])
    cs = sincos_turns(u[1])
    return wp.vec2(r * cs[0], r * cs[1])


@wp.func
def uniform_disk_to_square(p: wp.vec2) -> wp.vec2:
    """Squared radius and azimuth in turns."""
    return wp.vec2(clamp_uniform(p[0] * p[0] + p[1] * p[1]), turns_of(p[0], p[1]))


@wp.func
def square_to_concentric_disk(u: wp.vec2) -> wp.vec3:
    """(x, y, radius) by Shirley1997: squares become rings, so neighbours stay neighbours.

    The grid is shifted exactly to the middles of its cells, so that the radius stays below 1. Not differentiable by u on the
    diagonals, where its gradient is that of one side.
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
    """The point of `square_to_concentric_disk`, without the radius."""
    p = square_to_concentric_disk(u)
    return wp.vec2(p[0], p[1])


@wp.func
def uniform_disk_to_square_concentric(p: wp.vec2) -> wp.vec2:
    """The inverse: the radius is the longer coordinate, the angle in the octant the ratio of the two.

    Not differentiable on the diagonals, where its gradient is finite, and at the centre, where it is 0.
    """
    # Unlike that of wp.abs, the gradient of this knows -0.0, so it undoes that of the copysign below.
    ax = wp.copysign(p[0], 1.0)
    ay = wp.copysign(p[1], 1.0)
    longer = root(ax * ax + ay * ay)
    shorter = 8.0 * longer * turns_of(wp.max(ax, ay), wp.min(ax, ay))
    a = wp.copysign(wp.where(ax > ay, longer, shorter), p[0])
    b = wp.copysign(wp.where(ax > ay, shorter, longer), p[1])
    return wp.vec2(clamp_uniform(0.5 * (a + 1.0 - _HALF_CELL)), clamp_uniform(0.5 * (b + 1.0 - _HALF_CELL)))


@wp.func
def square_to_uniform_disk_pdf(p: wp.vec2) -> wp.float32:
    """1 / pi per unit area inside the unit circle, else 0."""
    return wp.where(p[0] * p[0] + p[1] * p[1] <= _RIM, INV_PI, 0.0)


_MAPS = {
    "polar": Maps(square_to_uniform_disk, square_to_uniform_disk_pdf, uniform_disk_to_square),
    "concentric": Maps(square_to_uniform_disk_concentric, square_to_uniform_disk_pdf, uniform_disk_to_square_concentric),
}


@dataclass(frozen=True)
class UniformDisk(Distribution):
    """Points (x, y) uniform on the unit disk: 1 / pi per unit area.

    Attributes:
        method: "polar" (radius sqrt(u), azimuth 2 pi v) or "concentric" (Shirley1997; less distortion).
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
        """Checks the method's name."""
        check_choice(self.method, "method", get_args(Method))

    @property
    def maps(self) -> Maps:
        """The `wp.func`s to use in kernels of your own."""
        return _MAPS[self.method]

    @property
    def largest_angle(self) -> float:
        """The radius of the unit disk, in place of an angle."""
        return 1.0

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """The square of the radius. See `Distribution.cdf`."""
        return np.clip(theta, 0.0, 1.0, dtype=np.float64) ** 2


RECORD = UniformDisk
