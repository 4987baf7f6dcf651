"""Solid angles of triangles with the eye at the origin, in float64, and the limits that lights must keep."""

import numpy as np
import warp as wp

LEAST: float = 1e-12
"""Least solid angle of a light in steradians, and least gap between its solid angle and that of a hemisphere."""

BLUR: wp.float64 = wp.constant(wp.float64(3e-7))
"""Angle in radians beyond the edges of a light at which its density is still above 0.

Rounding moves a float32 direction by at most 5e-8 rad, and rotations to the world and back by 2e-7 rad more.
"""


@wp.func
def vector_of(x: wp.float32, y: wp.float32, z: wp.float32) -> wp.vec3d:
    """Convert a vector of three numbers to float64."""
    return wp.vec3d(wp.float64(x), wp.float64(y), wp.float64(z))


@wp.func
def half_solid_angle(a: wp.vec3d, b: wp.vec3d, c: wp.vec3d) -> wp.vec2d:
    """Return the cosine and the sine of half the solid angle of a triangle, times a positive number.

    The formula is equation 8 of VanOosterom1983 for corners of any length. The volume is computed from edges, so that a
    small triangle keeps its digits.
    """
    volume = wp.dot(a, wp.cross(b - a, c - a))
    p, q, r = wp.length(a), wp.length(b), wp.length(c)
    return wp.vec2d(p * q * r + wp.dot(a, b) * r + wp.dot(b, c) * p + wp.dot(c, a) * q, wp.abs(volume))


@wp.func
def distance_to_plane(w: wp.vec3d, a: wp.vec3d, b: wp.vec3d) -> wp.float64:
    """Return the signed distance of a point w from the plane through the origin and the points a and b."""
    normal = wp.cross(a, b)
    return wp.dot(w, normal) / wp.length(normal)


def half_solid_angles(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return half the solid angles of triangles with (P, 3) float64 corners a, b and c, in radians.

    The result is (P,) float64, at least 0; NaN if a corner is not finite. Corners are scaled, so that no product overflows.
    """
    with np.errstate(all="ignore"):
        largest = np.abs(np.stack([a, b, c])).max(axis=(0, 2))[:, None]
        a, b, c = a / largest, b / largest, c / largest
        volume = np.einsum("pi,pi->p", a, np.cross(b - a, c - a))
        p, q, r = (np.sqrt(np.square(v).sum(axis=1)) for v in (a, b, c))
        ab, bc, ca = ((v * w).sum(axis=1) for v, w in ((a, b), (b, c), (c, a)))
        return np.arctan2(np.abs(volume), p * q * r + ab * r + bc * p + ca * q)


def is_usable(half: np.ndarray) -> np.ndarray:
    """Return True where a solid angle, given by its half, is at least `LEAST` and smaller than a hemisphere."""
    return (half >= 0.5 * LEAST) & (half <= np.pi - 0.5 * LEAST)
