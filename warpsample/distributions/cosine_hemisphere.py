"""Cosine lobe, by four methods that all have the density cos(theta) / pi per steradian above the surface."""

from dataclasses import dataclass
from typing import ClassVar, Literal, get_args

import numpy as np
import warp as wp

from warpsample.distributions.parameters import Parameters
from warpsample.distributions.record import Cases, Distribution, Maps
from warpsample.distributions.uniform_disk import square_to_concentric_disk, uniform_disk_to_square_concentric
from warpsample.distributions.uniform_sphere import square_to_uniform_sphere
from warpsample.host.arguments import check_choice
from warpsample.maths.angles import turns_of
from warpsample.maths.frames import frame_about, to_world
from warpsample.maths.numerics import GRID, INV_PI, INV_TWO_PI, clamp_uniform, fma, root, sincos_turns
from warpsample.sequences.hashing import pcg4d

Method = Literal["polar", "concentric", "inversion", "offset"]

_GRID_SIZE = wp.constant(wp.float32(GRID))
_HALF_RIM = wp.constant(wp.float32(2.0**-7))
_RIM_PDF = 2.0**-6 * 0.15915494309189535  # the pdf where abs(n + s) = 2^-6
_STEP = wp.constant(wp.float32(2.0**-23))


@wp.func
def square_to_cosine_hemisphere(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a cosine-distributed direction about +z, by Malley's method with a polar disk.

    A uniform point of the disk, of radius sqrt(u[0]), is lifted to the hemisphere. cos theta = sqrt(1 - u[0]) is exact to
    one unit in the last place and above 0 for every u; sqrt(1 - x^2 - y^2) would be 73 % wrong at the horizon.
    """
    r = root(u[0])
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.sqrt(1.0 - u[0]))


@wp.func
def square_to_cosine_hemisphere_pdf(w: wp.vec3) -> wp.float32:
    """Return the density cos(theta) / pi per steradian above the surface, else 0. Cranberry2020, equation 5."""
    return wp.where(w[2] > 0.0, w[2] * INV_PI, 0.0)


@wp.func
def cosine_hemisphere_to_square(w: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_cosine_hemisphere` maps to the direction w.

    u[0] = sin^2 theta = 1 - cos^2 theta, computed from the smaller square; u[1] the azimuth in turns.
    """
    small = w[0] * w[0] + w[1] * w[1]
    return wp.vec2(clamp_uniform(wp.where(small < 0.5, small, 1.0 - w[2] * w[2])), turns_of(w[0], w[1]))


@wp.func
def square_to_cosine_hemisphere_concentric(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a cosine-distributed direction about +z, by Malley's method with a concentric disk.

    The radius r of the disk is below 1, so cos theta = sqrt((1 - r)(1 + r)) is above 0.
    """
    p = square_to_concentric_disk(u)
    return wp.vec3(p[0], p[1], wp.sqrt((1.0 - p[2]) * (1.0 + p[2])))


@wp.func
def cosine_hemisphere_to_square_concentric(w: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_cosine_hemisphere_concentric` maps to the direction w."""
    return uniform_disk_to_square_concentric(wp.vec2(w[0], w[1]))


@wp.func
def square_to_cosine_hemisphere_inversion(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a cosine-distributed direction about +z, by inversion of the cdf.

    theta = acos(1 - 2 u[0]) / 2 (Cranberry2020, equation 7). cos 2 theta = 1 - 2 u[0] is exact, and the half-angle formulas
    give cos theta and sin theta as square roots, which are more precise than acos.
    """
    cos_double = 1.0 - 2.0 * u[0]
    r = root(0.5 * (1.0 - cos_double))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.sqrt(0.5 * (1.0 + cos_double)))


@wp.func
def square_to_cosine_hemisphere_offset(u: wp.vec2) -> wp.vec3:
    """Map a point of the unit square to a cosine-distributed direction about +z, by Shirley's trick.

    A uniform point of the unit sphere plus +z is normalised. 1 + z = 2 - 2 u[0] is exact, so the sum is precise down to the
    horizon.
    """
    s = square_to_uniform_sphere(u)
    z = 2.0 - 2.0 * u[0]
    inverse = 1.0 / wp.sqrt(fma(s[0], s[0], fma(s[1], s[1], z * z)))
    return wp.vec3(s[0] * inverse, s[1] * inverse, z * inverse)


@wp.func
def cosine_offset_about(n: wp.vec3, u: wp.vec2, parameters: Parameters) -> wp.vec4:
    """Sample a cosine-distributed direction about any unit normal n by Shirley's trick, without a tangent frame.

    Returns (normalize(n + s), pdf) for a uniform point s of the unit sphere. abs(n + s) = 2 cos theta, since the angle of s
    is twice that of the sum (ShirleyTrick, figure 1), so pdf = abs(n + s) / (2 pi). Where the sum is short, n and s cancel:
    see `cosine_offset_redraw`.
    """
    s = square_to_uniform_sphere(u)
    x = n[0] + s[0]
    y = n[1] + s[1]
    z = n[2] + s[2]
    length = wp.sqrt(fma(x, x, fma(y, y, z * z)))
    inverse = 1.0 / length
    return wp.vec4(x * inverse, y * inverse, z * inverse, length * INV_TWO_PI)


@wp.func
def cosine_offset_redraw(n: wp.vec3, u: wp.vec2, parameters: Parameters) -> wp.vec4:
    """Sample a direction near the horizon again from a hash of u, because Shirley's trick is imprecise there.

    This replaces 6 of 10^5 directions. P(abs(n + s) < r) = r^2 / 4, so cos theta = 2^-7 sqrt(u') for a new variate u' keeps
    the distribution exact. The published remedy, scaling the sphere by 0.99999, never samples 2e-5 of the lobe.
    """
    bits = pcg4d(wp.uint32(u[0] * _GRID_SIZE), wp.uint32(u[1] * _GRID_SIZE), wp.uint32(0), wp.uint32(0))
    fresh = (wp.float32(wp.int32(bits[0] >> wp.uint32(9))) + 0.5) * _STEP
    turns = wp.float32(wp.int32(bits[1] >> wp.uint32(9))) * _STEP
    cos_theta = _HALF_RIM * wp.sqrt(fresh)
    sin_theta = wp.sqrt(1.0 - cos_theta * cos_theta)
    cs = sincos_turns(turns)
    d = to_world(frame_about(n), wp.vec3(sin_theta * cs[0], sin_theta * cs[1], cos_theta))
    return wp.vec4(d[0], d[1], d[2], cos_theta * INV_PI)


_POLAR = Maps(square_to_cosine_hemisphere, square_to_cosine_hemisphere_pdf, cosine_hemisphere_to_square)
_MAPS = {
    "polar": _POLAR,
    "concentric": Maps(
        square_to_cosine_hemisphere_concentric, square_to_cosine_hemisphere_pdf, cosine_hemisphere_to_square_concentric
    ),
    "inversion": Maps(square_to_cosine_hemisphere_inversion, square_to_cosine_hemisphere_pdf, cosine_hemisphere_to_square),
    "offset": Maps(
        square_to_cosine_hemisphere_offset,
        square_to_cosine_hemisphere_pdf,
        cosine_hemisphere_to_square,
        about=cosine_offset_about,
        redraw=cosine_offset_redraw,
        redraw_below=_RIM_PDF,
    ),
}


@dataclass(frozen=True)
class CosineHemisphere(Distribution):
    """Cosine lobe about the normal, with density cos(theta) / pi per steradian.

    Attributes:
        method: "polar" (uniform polar disk, lifted to the hemisphere), "concentric" (concentric disk of Shirley1997,
            lifted), "inversion" (theta = acos(1 - 2 u[0]) / 2) or "offset" (uniform point of the sphere plus the normal,
            normalised, without a tangent frame). All methods have the same density. They differ in cost and in the mapping
            of neighbouring u; "offset" samples 6 of 10^5 directions again, from a hash of u.
    """

    method: Method = "polar"

    name = "cosine_hemisphere"
    density = "cosθ/π"
    support = "hemisphere"
    source = "Nori2025, Malley; Cranberry2020, equations 5 and 7; ShirleyTrick, equation 6; Chizhov2019, section 4.3"
    limits = "the method offset adds float32 vectors, so that angle and pdf have errors up to 1.3e-5 near the horizon"
    case_values: ClassVar[Cases] = tuple((method,) for method in get_args(Method))

    def __post_init__(self) -> None:
        """Raise an error if the name of the sampling method is unknown."""
        check_choice(self.method, "method", get_args(Method))

    @property
    def polar(self) -> bool:
        """True if u[0] alone determines the angle and u[1] the azimuth, as for the methods "polar" and "inversion"."""
        return self.method in ("polar", "inversion")

    @property
    def maps(self) -> Maps:
        """Warp functions of the distribution for kernels: map, density and inverse."""
        return _MAPS[self.method]

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: sin^2 theta. See `Distribution.cdf`."""
        return np.sin(np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) ** 2


RECORD = CosineHemisphere
