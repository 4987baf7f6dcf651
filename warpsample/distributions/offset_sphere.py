"""Direction of the normal plus a random point on a sphere of any radius: Shirley's trick with the radius as a parameter."""

from dataclasses import dataclass
from numbers import Real
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.maths.angles import sin_squared, turns_of
from warpsample.maths.numerics import HALF, ONE, ZERO, clamp_uniform, fma, polish, root, root_double, sincos_turns

_BLUR = wp.constant(wp.float64(2.0**-21))
_INV_FOUR_PI = wp.constant(wp.float64(0.07957747154594767))


@wp.func
def square_to_offset_sphere(u: wp.vec2, rho: wp.float32) -> wp.vec3:
    """Map a point of the unit square to the direction of (0, 0, 1) + rho s, with s uniform on the unit sphere.

    z = 1 + rho (1 - 2 u[0]) is computed as (1 - rho) + 2 rho (1 - u[0]), which is exact where the sum is short.
    """
    r = 2.0 * rho * root(u[0] * (1.0 - u[0]))
    cs = sincos_turns(u[1])
    z = fma(2.0 * rho, 1.0 - u[0], 1.0 - rho)
    inverse = 1.0 / wp.sqrt(fma(r, r, z * z))
    return polish(wp.vec3(r * inverse * cs[0], r * inverse * cs[1], z * inverse))


@wp.func
def square_to_offset_sphere_pdf(w: wp.vec3, rho: wp.float32) -> wp.float32:
    """Return the density of a direction w per steradian: the sum of t^2 / (4 pi rho sqrt(D)) over one or two distances t.

    The direction w hits the sphere about the tip of the normal at the distances t = cos theta -+ sqrt(D), with
    D = rho^2 - sin^2 theta. For rho < 1 the density is infinite at the edge sin theta = rho. D is clamped within 5e-7 on
    both sides of the edge, so that the density still integrates to 1 and no sampled direction has density 0. The gradient
    there is that of the clamped density.
    """
    radius = wp.float64(rho)
    square = radius * radius
    inside = rho < 1.0
    gap = square - sin_squared(w)
    rim = wp.where(inside, _BLUR * square, ZERO)
    root = wp.sqrt(wp.max(gap, wp.max(rim, wp.float64(1e-300))))
    x = wp.float64(w[0])
    y = wp.float64(w[1])
    z = wp.float64(w[2])
    cos_theta = z / wp.sqrt(x * x + y * y + z * z)
    far = cos_theta + root
    near = wp.where(inside, cos_theta - root, ZERO)
    density = (far * far + near * near) * _INV_FOUR_PI / (radius * root)
    above = gap > -rim and (rho > 1.0 or w[2] > 0.0)
    return wp.where(above, wp.float32(density), 0.0)


@wp.func
def offset_sphere_to_square(w: wp.vec3, rho: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_offset_sphere` maps to the direction w; only for rho >= 1.

    u[0] = (1 - s.z) / 2 for the point s of the sphere, u[1] the azimuth in turns.
    1 - s.z = 1 - (t cos theta - 1) / rho = sin^2 theta' / (1 + s.z), with the angle theta' of s; the form that cancels less
    is used.
    """
    radius = wp.float64(rho)
    sine_squared = sin_squared(w)
    x = wp.float64(w[0])
    y = wp.float64(w[1])
    z = wp.float64(w[2])
    cos_theta = z / wp.sqrt(x * x + y * y + z * z)
    distance = cos_theta + root_double(wp.max(radius * radius - sine_squared, ZERO))
    s = (distance * cos_theta - ONE) / radius
    across = distance * distance * sine_squared / (radius * radius)
    u = wp.where(s > ZERO, HALF * across / (ONE + wp.max(s, ZERO)), HALF * (ONE - s))
    return wp.vec2(clamp_uniform(wp.float32(u)), turns_of(w[0], w[1]))


def _is_checked(rho: Any) -> bool:
    """Return whether rho is an array with a row per point that has been checked already."""
    return isinstance(rho, np.ndarray) and rho.dtype == np.float32


@dataclass(frozen=True)
class OffsetSphere(Distribution):
    """Direction of the normal plus a random point on a sphere of radius ρ.

    Directions fill a cone for ρ < 1, form the cosine lobe for ρ = 1, and approach the uniform sphere for large ρ.

    Attributes:
        rho: radius of the sphere about the tip of the normal, from 1e-15 to 1e15.
    """

    rho: float = 1.0

    name = "offset_sphere"
    density = "Σt²/(4πρ√(ρ²−sin²θ)), t=cosθ±√(ρ²−sin²θ)"
    parameters: ClassVar[tuple[str, ...]] = ("rho",)
    shown: ClassVar[Range] = (0.2, 5.0)
    bounds: ClassVar[Range] = (1e-15, 1e15)
    source = "Chizhov2019, sections 4.3 and 4.4, for ρ = 1; own derivation for other ρ"
    limits = (
        "for ρ < 1 the density is infinite at the edge sinθ = ρ and is clamped within 5e-7 of the edge. "
        "For ρ < 1 there is no inverse, because two points u map to the same direction"
    )
    # A narrow cone, values on both sides of the cosine lobe, and almost uniform.
    case_values: ClassVar[Cases] = ((1e-15,), (0.5,), (1.0 - 2.0**-24,), (1.0,), (1.0 + 2.0**-23,), (1.5,), (1e15,))

    @property
    def polar(self) -> bool:
        """True if u[0] alone determines the angle to +z, which is the case for rho >= 1."""
        return isinstance(self.rho, Real) and self.rho >= 1.0

    @property
    def maps(self) -> Maps:
        """Warp functions of the distribution for kernels: map, density and inverse."""
        ambiguous = bool((self.rho < 1.0).any()) if _is_checked(self.rho) else self.support == "cone"
        invert = None if ambiguous else offset_sphere_to_square
        return Maps(square_to_offset_sphere, square_to_offset_sphere_pdf, invert)

    @property
    def support(self) -> str:
        """Name of the support: "cone" for rho < 1, "hemisphere" for rho = 1, "sphere" for rho > 1 or rho by point."""
        if not isinstance(self.rho, Real):
            return "sphere"
        rho = np.float32(self.rho)  # kernels round rho to float32
        return "cone" if rho < 1.0 else "hemisphere" if rho == 1.0 else "sphere"

    @property
    def largest_angle(self) -> float:
        """Largest angle to +z in radians: for rho < 1 that of the edge, asin(rho), plus the width of the clamp."""
        edge = min(1.0, self.rho * np.sqrt(1.0 + float(_BLUR)))
        return float(np.arcsin(edge)) if self.support == "cone" else super().largest_angle

    @property
    def thinnest_tail(self) -> float:
        """Smallest probability of extreme angles that statistical tests can examine: 1e-2 for a cone, else 1e-5.

        7e-4 of the directions are within the clamped edge, half of which the clamped density places past the edge.
        """
        return 1e-2 if self.support == "cone" else super().thinnest_tail

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: the part of the sphere seen within this angle.

        See `Distribution.cdf`.
        """
        theta = np.clip(theta, 0.0, self.largest_angle, dtype=np.float64)
        beyond = np.arcsin(np.clip(np.sin(theta) / self.rho, -1.0, 1.0))
        far = np.sin(0.5 * (theta + beyond)) ** 2
        return far + np.sin(0.5 * (beyond - theta)) ** 2 if self.support == "cone" else far


RECORD = OffsetSphere
