"""Spherical rectangle: directions from a point to a rectangle, uniform in solid angle."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.lights.solid_angles import BLUR, half_solid_angles, is_usable, vector_of
from warpsample.distributions.record import Cases, Distribution, Maps
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.maths.angles import arctan2_double, sincos_double
from warpsample.maths.numerics import HALF, ONE, ZERO, clamp_uniform

Vector = tuple[float, float, float]

_WANTS = {
    "corner": "a vector to a corner of a rectangle with a solid angle from 1e-12 sr to just below a hemisphere's",
    "edge_x": "three finite numbers, not all 0",
    "edge_y": "three finite numbers, not all 0, perpendicular to edge_x",
}
_LARGEST_COSINE = 1e-4  # of the angle between the edges; the rest is removed from edge_y
_PART = 1 << 16  # rows that are checked at a time
_TINY = wp.constant(wp.float64(1e-30))


@wp.func
def axes_of(corner: wp.vec3, edge_x: wp.vec3, edge_y: wp.vec3) -> tuple[wp.vec3d, wp.vec3d, wp.vec3d]:
    """Return unit vectors along both edges of a rectangle, and along its normal that points away from the eye."""
    e = vector_of(edge_y[0], edge_y[1], edge_y[2])
    x = wp.normalize(vector_of(edge_x[0], edge_x[1], edge_x[2]))
    y = wp.normalize(e - wp.dot(e, x) * x)
    z = wp.cross(x, y)
    away = wp.where(wp.dot(vector_of(corner[0], corner[1], corner[2]), z) < ZERO, -ONE, ONE)
    return x, y, away * z


@wp.func
def range_of(corner: wp.vec3, edge: wp.vec3, axis: wp.vec3d) -> tuple[wp.float64, wp.float64]:
    """Return the coordinates, along an axis, of both ends of a rectangle's edge."""
    low = wp.dot(vector_of(corner[0], corner[1], corner[2]), axis)
    return low, low + wp.dot(vector_of(edge[0], edge[1], edge[2]), axis)


@wp.func
def half_solid_angle_between(x0: wp.float64, x1: wp.float64, y0: wp.float64, y1: wp.float64, z: wp.float64) -> wp.float64:
    """Return half the solid angle of a rectangle in a plane z, as the sum of two triangles (VanOosterom1983, equation 8)."""
    a, b, c, d = distance_of(x0, y0, z), distance_of(x1, y0, z), distance_of(x1, y1, z), distance_of(x0, y1, z)
    depth, volume = z * z, z * (x1 - x0) * (y1 - y0)
    diagonal = a * c + x0 * x1 + y0 * y1 + depth
    lower = diagonal * b + (x0 * x1 + y0 * y0 + depth) * c + (x1 * x1 + y0 * y1 + depth) * a
    upper = diagonal * d + (x0 * x0 + y0 * y1 + depth) * c + (x0 * x1 + y1 * y1 + depth) * a
    return arctan2_double(volume * (lower + upper), lower * upper - volume * volume)


@wp.func
def distance_of(x: wp.float64, y: wp.float64, z: wp.float64) -> wp.float64:
    """Return the distance of a point from the origin."""
    return wp.sqrt(x * x + y * y + z * z)


@wp.func
def height_at(y: wp.float64, square: wp.float64) -> wp.float64:
    """Return the sine of the elevation of a point, from its height y and the square of its horizontal distance."""
    return y / wp.sqrt(square + y * y)


@wp.func
def square_to_spherical_rectangle(u: wp.vec2, corner: wp.vec3, edge_x: wp.vec3, edge_y: wp.vec3) -> wp.vec3:
    """Map a point of the unit square to a direction towards a rectangle, given by a corner and the two edges from it.

    u[0] is the share of the solid angle left of a line along edge_y, and u[1] the share along this line (Urena2013). The
    angles of the spherical rectangle are used as points of the unit circle, without inverse cosines.
    """
    x, y, z = axes_of(corner, edge_x, edge_y)
    x0, x1 = range_of(corner, edge_x, x)
    y0, y1 = range_of(corner, edge_y, y)
    h = wp.dot(vector_of(corner[0], corner[1], corner[2]), z)
    depth = h * h
    near, far = depth + y0 * y0, depth + y1 * y1
    # Both angles on the left side, as (cos, sin) times positive lengths: their sum is turned by u[0] times the solid angle.
    below, above = h * wp.sqrt(x0 * x0 + near), h * wp.sqrt(x0 * x0 + far)
    scale = ONE / (wp.sqrt(near * far) * (depth + x0 * x0))
    c = -(x0 * x0 * y0 * y1 + below * above) * scale
    s = x0 * (y0 * above - y1 * below) * scale
    turn = sincos_double(wp.float64(u[0]) * (half_solid_angle_between(x0, x1, y0, y1, h) / HALF))
    sine = s * turn[0] + c * turn[1]
    f = -y0 / wp.sqrt(near) * (c * turn[0] - s * turn[1]) - y1 / wp.sqrt(far)
    root = wp.sqrt(wp.max(f * f - depth / near * sine * sine, _TINY))
    across = wp.clamp(h * wp.where(f < ZERO, -sine, sine) / root, x0, x1)
    square = depth + across * across
    first = height_at(y0, square)
    height = first + wp.float64(u[1]) * (height_at(y1, square) - first)
    up = wp.clamp(height * wp.sqrt(square / wp.max(ONE - height * height, _TINY)), y0, y1)
    w = ONE / distance_of(across, up, h) * (across * x + up * y + h * z)
    return wp.vec3(wp.float32(w[0]), wp.float32(w[1]), wp.float32(w[2]))


@wp.func
def square_to_spherical_rectangle_pdf(w: wp.vec3, corner: wp.vec3, edge_x: wp.vec3, edge_y: wp.vec3) -> wp.float32:
    """Return the density of directions uniform in the solid angle A of a rectangle: 1 / A per steradian; 0 outside.

    The edges are blurred by 3e-7 rad, so that no sampled direction has density 0.
    """
    x, y, z = axes_of(corner, edge_x, edge_y)
    x0, x1 = range_of(corner, edge_x, x)
    y0, y1 = range_of(corner, edge_y, y)
    h = wp.dot(vector_of(corner[0], corner[1], corner[2]), z)
    v = vector_of(w[0], w[1], w[2])
    across, up, ahead = wp.dot(v, x), wp.dot(v, y), wp.dot(v, z)
    # The distances from the planes through the eye and an edge.
    left, right = (across * h - x0 * ahead) / wp.sqrt(h * h + x0 * x0), (x1 * ahead - across * h) / wp.sqrt(h * h + x1 * x1)
    below, above = (up * h - y0 * ahead) / wp.sqrt(h * h + y0 * y0), (y1 * ahead - up * h) / wp.sqrt(h * h + y1 * y1)
    inside = wp.min(wp.min(wp.min(left, right), wp.min(below, above)), ahead)
    return wp.where(inside > -BLUR, wp.float32(HALF / half_solid_angle_between(x0, x1, y0, y1, h)), 0.0)


@wp.func
def spherical_rectangle_to_square(w: wp.vec3, corner: wp.vec3, edge_x: wp.vec3, edge_y: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_spherical_rectangle` maps to the direction w."""
    x, y, z = axes_of(corner, edge_x, edge_y)
    x0, x1 = range_of(corner, edge_x, x)
    y0, y1 = range_of(corner, edge_y, y)
    h = wp.dot(vector_of(corner[0], corner[1], corner[2]), z)
    v = vector_of(w[0], w[1], w[2])
    across = wp.clamp(h * wp.dot(v, x) / wp.max(wp.dot(v, z), _TINY), x0, x1)
    share = half_solid_angle_between(x0, across, y0, y1, h) / half_solid_angle_between(x0, x1, y0, y1, h)
    square = h * h + across * across
    first = height_at(y0, square)
    part = (wp.dot(v, y) / wp.length(v) - first) / (height_at(y1, square) - first)
    return wp.vec2(clamp_uniform(wp.float32(share)), clamp_uniform(wp.float32(part)))


@dataclass(frozen=True)
class SphericalRectangle(Distribution):
    """Directions towards a rectangle, such as a window, uniform in its solid angle A: density 1 / A per steradian.

    Each attribute may have one row for each point, (P, 3). The solid angle must be at least 1e-12 sr, and the point must not
    lie in the rectangle.

    Attributes:
        corner: local vector from the point to a corner.
        edge_x: vector from the corner along an edge, to the next corner.
        edge_y: vector from the corner along the other edge, perpendicular to `edge_x` within 1e-4 rad. What is left along
            `edge_x` is removed.
    """

    corner: Vector
    edge_x: Vector
    edge_y: Vector

    name = "spherical_rectangle"
    density = "1/A, A the solid angle"
    support = "rectangle"
    parameters: ClassVar[tuple[str, ...]] = ("corner", "edge_x", "edge_y")
    source = "Urena2013; VanOosterom1983, equation 8"
    symmetric = False
    polar = False
    worst_round_trip: ClassVar[float] = 1e-5
    limits = (
        "the density is blurred by 3e-7 rad at the edges. The error of the inverse is measured for solid angles above 4e-3 "
        "sr, and grows as 6e-8 over the rectangle's width in radians, because w is rounded"
    )
    # A face of a cube; a window; a small one seen from the side; a ceiling that almost surrounds the point; and a long lamp
    # that reaches below the surface.
    case_values: ClassVar[Cases] = (
        ((-1.0, -1.0, 1.0), (2.0, 0.0, 0.0), (0.0, 2.0, 0.0)),
        ((0.8, -0.5, 0.3), (0.0, 0.9, 0.0), (-0.2, 0.0, 0.7)),
        ((3.0, 0.2, 1.0), (0.0, 0.4, -0.3), (0.3, 0.12, 0.16)),
        ((-3.0, -2.0, 0.3), (7.0, 0.0, 0.0), (0.0, 5.0, 0.0)),
        ((0.5, -2.0, -0.4), (0.0, 5.0, 0.5), (0.2, -0.03, 0.3)),
    )
    maps: ClassVar[Maps] = Maps(
        square_to_spherical_rectangle, square_to_spherical_rectangle_pdf, spherical_rectangle_to_square
    )

    def __post_init__(self) -> None:
        """Check the vectors of the rectangle; raise a ValueError if the edges do not span a rectangle."""
        super().__post_init__()
        for name in (name for name in self.parameters if np.ndim(getattr(self, name)) != 2):
            vector = as_real(getattr(self, name), name, _WANTS[name])
            with np.errstate(over="ignore"):
                rounded = vector.astype(np.float32)
            if vector.shape != (3,) or not np.isfinite(rounded).all() or (name != "corner" and not rounded.any()):
                raise ValueError(f"{name}: got {quote(getattr(self, name))}, want {_WANTS[name]}")
            object.__setattr__(self, name, tuple(vector.astype(np.float64).tolist()))
        self._check_rectangles()

    def _check_rectangles(self) -> None:
        """Raise ValueError for constant vectors without a rectangle; set rows by point without a rectangle to NaN."""
        values = [np.array(value, np.float32).reshape(-1, 3) for value in self.kernel_values()]
        if len(values[1]) == len(values[2]) == 1 and not _are_perpendicular(*(v.astype(np.float64) for v in values[1:]))[0]:
            raise ValueError(f"edge_y: got {quote(self.edge_y)}, want {_WANTS['edge_y']}")
        name = next(iter(self.by_point), "corner")
        table = np.array(getattr(self, name), np.float32).reshape(-1, 3)
        for start in range(0, len(table), _PART):
            part = [(v if len(v) == 1 else v[start : start + _PART]).astype(np.float64) for v in values]
            usable = _are_perpendicular(*part[1:]) & is_usable(_half_solid_angles(*part))
            if not self.by_point and not usable[0]:
                raise ValueError(f"corner: got {quote(self.corner)}, want {_WANTS['corner']}")
            table[start : start + _PART][~usable] = np.nan
        if self.by_point:
            table.setflags(write=False)
            object.__setattr__(self, name, table)

    @property
    def largest_angle(self) -> float:
        """Coordinate of the edges in the rectangle's chart, a `StretchedSquare`, with a margin for rounding; no angle."""
        return float(np.pi / 4.0 + float(BLUR) * np.linalg.cond(self.stretch))

    @property
    def stretch(self) -> tuple[Vector, Vector, Vector]:
        """Matrix whose columns are the halves of both edges and the vector to the middle of the rectangle."""
        corner, x, y = (np.array(value, np.float32).astype(np.float64) for value in self.kernel_values())
        y = y - (x @ y) / (x @ x) * x
        return tuple(map(tuple, np.stack([0.5 * x, 0.5 * y, corner + 0.5 * (x + y)], axis=1).tolist()))


def _are_perpendicular(edge_x: np.ndarray, edge_y: np.ndarray) -> np.ndarray:
    """Return the mask of rows whose two edges, (P, 3) float64, are not zero and are perpendicular within 1e-4 rad."""
    with np.errstate(all="ignore"):
        x, y = (edge / np.abs(edge).max(axis=1, keepdims=True) for edge in (edge_x, edge_y))
        lengths = np.sqrt(np.square(x).sum(axis=1) * np.square(y).sum(axis=1))
        return np.abs((x * y).sum(axis=1)) <= _LARGEST_COSINE * lengths


def _half_solid_angles(corner: np.ndarray, edge_x: np.ndarray, edge_y: np.ndarray) -> np.ndarray:
    """Return half the solid angles of rectangles with (P, 3) float64 vectors, in radians."""
    with np.errstate(all="ignore"):
        edge_y = (
            edge_y - (edge_x * edge_y).sum(axis=1, keepdims=True) / np.square(edge_x).sum(axis=1, keepdims=True) * edge_x
        )
        a, b, c, d = np.broadcast_arrays(corner, corner + edge_x, corner + edge_x + edge_y, corner + edge_y)
    return half_solid_angles(a, b, c) + half_solid_angles(a, c, d)


RECORD = SphericalRectangle
