"""Spherical triangle: directions from a point to a triangle, uniform in solid angle."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.lights.solid_angles import (
    BLUR,
    distance_to_plane,
    half_solid_angle,
    half_solid_angles,
    is_usable,
    vector_of,
)
from warpsample.distributions.record import Cases, Distribution, Maps
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.maths.angles import arctan2_double, sincos_double
from warpsample.maths.numerics import HALF, ONE, TWO, ZERO, clamp_uniform, root_double

Corners = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

_WANTS = "3 corners of 3 finite numbers each, with a solid angle from 1e-12 sr to just below a hemisphere's"
_PART = 1 << 16  # rows that are checked at a time
_TINY = wp.constant(wp.float64(1e-30))


@wp.func
def rows_of(corners: wp.mat33) -> tuple[wp.vec3d, wp.vec3d, wp.vec3d]:
    """Return the three rows of a matrix as float64 vectors."""
    a = vector_of(corners[0, 0], corners[0, 1], corners[0, 2])
    b = vector_of(corners[1, 0], corners[1, 1], corners[1, 2])
    c = vector_of(corners[2, 0], corners[2, 1], corners[2, 2])
    return a, b, c


@wp.func
def square_to_spherical_triangle(u: wp.vec2, corners: wp.mat33) -> wp.vec3:
    """Map a point of the unit square to a direction towards a triangle whose corners are the rows of a matrix.

    u[0] is the share of the solid angle on the side of corner 0 of a great circle through corner 1. The circle meets the
    opposite edge at k, where 1 - cos of the angle to corner 1 is cut off in the ratio u[1] (Arvo1995). k comes from half
    the solid angle without an inverse cosine (Peters2021, section 5).
    """
    p, q, r = rows_of(corners)
    a, b, c = wp.normalize(p), wp.normalize(q), wp.normalize(r)
    half = half_solid_angle(p, q, r)
    scale = ONE / (wp.length(p) * wp.length(q) * wp.length(r))
    cs = sincos_double(wp.float64(u[0]) * arctan2_double(half[1], half[0]))
    along = half[1] * scale * cs[0] - (wp.dot(a, c) + wp.dot(b, c)) * cs[1]
    across = (ONE + wp.dot(a, b)) * cs[1]
    mirror = along * a + across * c
    k = TWO * wp.dot(a, mirror) / wp.dot(mirror, mirror) * mirror - a
    near, far = k - b, k + b
    versine, coversine = HALF * wp.dot(near, near), HALF * wp.dot(far, far)
    # The component of k perpendicular to corner 1, without cancellation where k is near the corner or opposite to it.
    side = wp.where(versine < ONE, near - wp.dot(near, b) * b, far - wp.dot(far, b) * b)
    x = wp.float64(u[1])
    w = (ONE - x * versine) * b + root_double(x * (TWO - x * versine) / coversine) * side
    return wp.vec3(wp.float32(w[0]), wp.float32(w[1]), wp.float32(w[2]))


@wp.func
def square_to_spherical_triangle_pdf(w: wp.vec3, corners: wp.mat33) -> wp.float32:
    """Return the density of directions uniform in the solid angle A of a triangle: 1 / A per steradian; 0 outside.

    The edges are blurred by 3e-7 rad, so that no sampled direction has density 0.
    """
    a, b, c = rows_of(corners)
    half = half_solid_angle(a, b, c)
    v = vector_of(w[0], w[1], w[2])
    normal = wp.cross(b - a, c - a)
    front = wp.dot(v, normal) / wp.length(normal)
    edge = wp.min(wp.min(distance_to_plane(v, a, b), distance_to_plane(v, b, c)), distance_to_plane(v, c, a))
    back = wp.max(wp.max(distance_to_plane(v, a, b), distance_to_plane(v, b, c)), distance_to_plane(v, c, a))
    inside = wp.where(wp.dot(a, normal) > ZERO, wp.min(edge, front), -wp.max(back, front))
    return wp.where(inside > -BLUR, wp.float32(HALF / arctan2_double(half[1], half[0])), 0.0)


@wp.func
def spherical_triangle_to_square(w: wp.vec3, corners: wp.mat33) -> wp.vec2:
    """Return the point u of the unit square that `square_to_spherical_triangle` maps to the direction w.

    At corner 1 every u[0] gives the same direction. There u[0] is imprecise.
    """
    p, q, r = rows_of(corners)
    a, b, c = wp.normalize(p), wp.normalize(q), wp.normalize(r)
    half = half_solid_angle(p, q, r)
    v = vector_of(w[0], w[1], w[2])
    side = wp.where(wp.dot(p, wp.cross(q - p, r - p)) > ZERO, ONE, -ONE)
    # w is a sum of the corners with these weights, times the same factor; k is the sum without corner 1.
    of_a = wp.max(side * wp.dot(v, wp.cross(b, c)), _TINY)
    of_c = wp.max(side * wp.dot(v, wp.cross(a, b)), _TINY)
    k = of_a * a + of_c * c
    volume = of_c * half[1] / (wp.length(p) * wp.length(q) * wp.length(r))
    share = arctan2_double(volume, (ONE + wp.dot(a, b)) * wp.length(k) + wp.dot(b, k) + wp.dot(a, k))
    d = wp.normalize(k) - b
    e = v - b
    ratio = wp.dot(e, e) / wp.dot(d, d)
    return wp.vec2(clamp_uniform(wp.float32(share / arctan2_double(half[1], half[0]))), clamp_uniform(wp.float32(ratio)))


@dataclass(frozen=True)
class SphericalTriangle(Distribution):
    """Directions towards a triangle, such as a lamp, uniform in its solid angle A: density 1 / A per steradian.

    Attributes:
        corners: three local vectors from the point to the corners, (3, 3), of any length and order; or (P, 3, 3), one
            triangle for each point. The solid angle must be at least 1e-12 sr, and the point must not lie in the triangle.
            Corners are rounded to float32, and the density is that of the rounded triangle: for a lamp seen with a width of
            w radians, it differs by up to 1e-7 / w. A `SphericalRectangle` stores its edges, and does not.
    """

    corners: Corners

    name = "spherical_triangle"
    density = "1/A, A the solid angle"
    support = "triangle"
    parameters: ClassVar[tuple[str, ...]] = ("corners",)
    source = "Arvo1995; Peters2021, section 5; VanOosterom1983, equation 8"
    symmetric = False
    polar = False
    worst_round_trip: ClassVar[float] = 1e-5
    limits = (
        "the density is blurred by 3e-7 rad at the edges. The error of the inverse is measured for u[1] above 0.01 and for "
        "solid angles above 4e-3 sr, and grows as 6e-8 over the triangle's width in radians, because w is rounded"
    )
    # An octant; a triangle of the other orientation; a small one seen from the side; one that almost surrounds the point;
    # and a long one that reaches below the surface.
    case_values: ClassVar[Cases] = (
        (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),),
        (((-0.3, -0.2, 1.0), (0.0, 0.5, 0.9), (0.4, -0.1, 1.1)),),
        (((3.0, 0.2, 1.0), (3.1, 0.6, 1.2), (4.3, 0.5, 2.1)),),
        (((1.0, 0.0, 0.1), (-0.5, 0.866, 0.1), (-0.5, -0.866, 0.1)),),
        (((1.0, 0.0, 0.05), (-0.5, 0.8, 0.2), (-0.4, 0.7, -0.3)),),
    )
    maps: ClassVar[Maps] = Maps(square_to_spherical_triangle, square_to_spherical_triangle_pdf, spherical_triangle_to_square)

    def __post_init__(self) -> None:
        """Check the corners of the triangle, and store floats; raise an error for a triangle without an area."""
        super().__post_init__()
        if getattr(self.corners, "ndim", 2) == 3:
            return
        corners = as_real(self.corners, "corners", _WANTS)
        if corners.shape != (3, 3) or not _are_usable(corners[None])[0]:
            raise ValueError(f"corners: got {quote(self.corners)}, want {_WANTS}")
        object.__setattr__(self, "corners", tuple(map(tuple, corners.astype(np.float64).tolist())))

    def _copy_rows(self, name: str, rows: np.ndarray) -> np.ndarray:
        """Return a read-only float32 copy of triangles with one per point; unusable triangles become NaN."""
        copy = super()._copy_rows(name, rows).copy()
        for start in range(0, len(copy), _PART):
            part = copy[start : start + _PART]
            part[~_are_usable(part)] = np.nan
        copy.setflags(write=False)
        return copy

    @property
    def stretch(self) -> Corners:
        """Matrix with the unit vectors to the corners as columns, which maps the octant x, y, z > 0 to the triangle."""
        corners = np.array(self.corners, np.float32).astype(np.float64)
        unit = corners / np.sqrt(np.square(corners).sum(axis=1, keepdims=True))
        return tuple(map(tuple, unit.T.tolist()))

    def seam(self, u: Any) -> Any:
        """Return a mask of points u near corner 1, which `invert` cannot recover precisely. See `Distribution.seam`."""
        return u[..., 1] < 0.01


def _are_usable(corners: np.ndarray) -> np.ndarray:
    """Return the mask of (P, 3, 3) triangles that have a solid angle in range, with corners rounded to float32."""
    with np.errstate(over="ignore"):
        rounded = corners.astype(np.float32).astype(np.float64)
    return is_usable(half_solid_angles(rounded[:, 0], rounded[:, 1], rounded[:, 2]))


RECORD = SphericalTriangle
