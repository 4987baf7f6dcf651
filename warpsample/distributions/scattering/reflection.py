"""Reflection of a view at the normals of a rough surface, for any lobe of normals."""

from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.maps import Maps
from warpsample.distributions.microfacets.beckmann import Beckmann
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.microfacets.visible_beckmann import VisibleBeckmann
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX, blurred_facing
from warpsample.distributions.parameters import Parameters, number_at
from warpsample.distributions.record import Cases, Distribution
from warpsample.distributions.scattering.base import ScatteredLight
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.host.locks import once
from warpsample.maths.numerics import fma, polish

_LEAST = wp.constant(wp.float32(2.0**-24))
_BLUR = wp.constant(wp.float32(2.0**-20))
_TINY = wp.constant(wp.float32(1e-30))


@wp.func
def cosine_between(m: wp.vec3, view: wp.vec3) -> wp.float32:
    """Return the cosine m.v of unit vectors."""
    return fma(m[0], view[0], fma(m[1], view[1], m[2] * view[2]))


@wp.func
def reflected(m: wp.vec3, view: wp.vec3, cosine: wp.float32) -> wp.vec3:
    """Return 2 `cosine` m - v, for the cosine m.v; a cosine below 2^-24 counts as 2^-24, so that the result is not -v."""
    twice = 2.0 * wp.where(wp.abs(cosine) < _LEAST, _LEAST, cosine)
    return polish(wp.vec3(fma(twice, m[0], -view[0]), fma(twice, m[1], -view[1]), fma(twice, m[2], -view[2])))


@wp.func
def half_vector(w: wp.vec3, view: wp.vec3) -> wp.vec4:
    """Return (m, m.v) for the unit normal m along v + w, with m.v = abs(v + w) / 2; (0, 0, 0, 0) where w = -v.

    Each component of m has the relative precision of float32, as the sum does not cancel the digits of w. The cosine by the
    product of m and v would be off by 5e-2 for grazing views.
    """
    x = view[0] + w[0]
    y = view[1] + w[1]
    z = view[2] + w[2]
    square = fma(x, x, fma(y, y, z * z))
    inverse = wp.where(square > 0.0, 1.0 / wp.sqrt(wp.max(square, _TINY)), 0.0)
    m = wp.vec3(x * inverse, y * inverse, z * inverse)
    m = polish(m)
    return wp.vec4(m[0], m[1], m[2], 0.5 * square * inverse)


@wp.func
def normal_to_reflection(m: wp.vec3, view: wp.vec3) -> wp.vec3:
    """Return the direction w = 2 (v.m) m - v in which a surface with the normal m reflects light to the viewer.

    A normal and its opposite give the same direction.
    """
    return reflected(m, view, cosine_between(m, view))


@wp.func
def reflection_to_normal(w: wp.vec3, view: wp.vec3) -> wp.vec3:
    """Return the unit normal m along v + w, which reflects the view v to the direction w; zero where w = -v."""
    m = half_vector(w, view)
    return wp.vec3(m[0], m[1], m[2])


@wp.func
def normal_per_reflection(w: wp.vec3, view: wp.vec3) -> wp.float32:
    """Return the Jacobian of reflection: solid angle of normals per solid angle of directions w, 1 / (4 abs(v.m)).

    The density of w is that of the normals m and -m together, times this number. A cosine v.m below 2^-24 counts as 2^-24.
    """
    return 0.25 / wp.max(half_vector(w, view)[3], _LEAST)


@once
def normals_per_cosine(lobe: Maps, view_at: int, lobe_view_at: int, below: bool = False) -> wp.Function:
    """Build the wp.func (m, cosine, Parameters) that returns the density of normals m, divided by abs(cosine).

    `cosine` is v.m for the view v at number `view_at` of the parameters. For visible normals the quotient of both cosines,
    with the view of the lobe at number `lobe_view_at`, is taken as 1 if both views are equal. With `below`, -v takes the
    place of a view v from below the surface.
    """
    density, per_cosine = lobe.pdf, lobe.per_cosine
    if per_cosine is None:

        @wp.func
        def side(m: wp.vec3, cosine: wp.float32, parameters: Parameters):
            """Return the density of the normal m, divided by abs(cosine)."""
            return density(m, parameters) / wp.max(wp.abs(cosine), _LEAST)

    else:

        @wp.func
        def side(m: wp.vec3, cosine: wp.float32, parameters: Parameters):
            """Return the density of the visible normal m, divided by abs(cosine)."""
            view = wp.vec3(
                number_at(parameters, view_at), number_at(parameters, view_at + 1), number_at(parameters, view_at + 2)
            )
            if wp.static(below):
                sign = wp.where(view[2] < 0.0, -1.0, 1.0)
                view = wp.vec3(sign * view[0], sign * view[1], sign * view[2])
            own = wp.vec3(
                number_at(parameters, lobe_view_at),
                number_at(parameters, lobe_view_at + 1),
                number_at(parameters, lobe_view_at + 2),
            )
            same = wp.abs(view[0] - own[0]) + wp.abs(view[1] - own[1]) + wp.abs(view[2] - own[2]) == 0.0
            facing = blurred_facing(m, own) / wp.max(wp.abs(cosine), _LEAST)
            return per_cosine(m, parameters) * wp.where(same, wp.where(cosine > -_BLUR, 1.0, 0.0), facing)

    return side


@once
def reflection_maps(lobe: Maps, view_at: int, lobe_view_at: int, both: bool) -> Maps:
    """Build the Warp functions of `Reflection` (map, density and inverse) from the functions of the lobe of normals.

    Args:
        lobe: functions of (u or m, Parameters).
        view_at: index of the first number of the view in `Parameters`.
        lobe_view_at: index of the first number of the lobe's own view, for visible normals.
        both: whether m and -m can both have a density above 0.
    """
    sample_normal, invert_normal, side = lobe.sample, lobe.invert, normals_per_cosine(lobe, view_at, lobe_view_at)
    inverse = None

    @wp.func
    def sample(u: wp.vec2, parameters: Parameters):
        """Return the direction in which the normal at u reflects the view."""
        return normal_to_reflection(
            sample_normal(u, parameters),
            wp.vec3(number_at(parameters, view_at), number_at(parameters, view_at + 1), number_at(parameters, view_at + 2)),
        )

    @wp.func
    def pdf(w: wp.vec3, parameters: Parameters):
        """Return the density of a reflected direction w: that of the normals m and -m, divided by 4 abs(v.m)."""
        h = half_vector(
            w,
            wp.vec3(number_at(parameters, view_at), number_at(parameters, view_at + 1), number_at(parameters, view_at + 2)),
        )
        m = wp.vec3(h[0], h[1], h[2])
        density = side(m, h[3], parameters) + side(wp.vec3(-h[0], -h[1], -h[2]), -h[3], parameters)
        return wp.where(h[3] > 0.0, 0.25 * density, 0.0)

    @wp.func
    def draw(u: wp.vec2, parameters: Parameters):
        """Return the direction in which the normal at u reflects the view, and its density, as a vec4."""
        view = wp.vec3(
            number_at(parameters, view_at), number_at(parameters, view_at + 1), number_at(parameters, view_at + 2)
        )
        m = sample_normal(u, parameters)
        cosine = cosine_between(m, view)
        w = reflected(m, view, cosine)
        density = side(m, cosine, parameters)
        if wp.static(both):
            density += side(wp.vec3(-m[0], -m[1], -m[2]), -cosine, parameters)
        return wp.vec4(w[0], w[1], w[2], 0.25 * density)

    if invert_normal is not None and not both:

        @wp.func
        def invert(w: wp.vec3, parameters: Parameters):
            """Return the point u that the lobe maps to the normal, with z above 0, that reflects the view to w."""
            m = reflection_to_normal(
                w,
                wp.vec3(
                    number_at(parameters, view_at), number_at(parameters, view_at + 1), number_at(parameters, view_at + 2)
                ),
            )
            return invert_normal(wp.where(m[2] < 0.0, -m, m), parameters)

        inverse = invert
    return Maps(sample, pdf, inverse, draw=draw)


class Reflection(ScatteredLight):
    """Directions in which a rough surface reflects the view v: w = 2 (v·m) m − v, with normals m sampled from a lobe.

    The density is (p(m) + p(−m)) / (4 abs(v·m)) per steradian over the sphere, for the density p of the lobe. A rough
    surface also reflects below its mean plane. A renderer drops those directions; here they count.

    Attributes:
        lobe: lobe of normals, usually `VisibleGGX` or `VisibleBeckmann` with the same view; also any other distribution.
        view: direction v to the viewer in the local frame, at or above the surface, of any length; stored as a unit vector.
    """

    name = "reflection"
    density = "(p(m)+p(−m))/(4abs(v·m)), m=(v+w)/abs(v+w)"
    source = "Walter2007, equations 13 and 14"
    limits = (
        "the direction has twice the error of the lobe's normals. For v·m below 2⁻²⁴ the density has 2⁻²⁴ in its place, and "
        "for w = −v it is 0. There is no inverse if m and −m can both be normals. The error of the inverse is measured for "
        "u[0] above 0.01 and abs(v·m) above 0.3. The density of Beckmann's normals is less precise than others, because the "
        "exponential of the slope of m multiplies the rounding of w"
    )
    worst_angle: ClassVar[float] = 1.2e-6
    worst_pdf: ClassVar[float] = 6e-6
    # Visible normals, rough, brushed and narrow; normals that face away; and lobes over the whole sphere.
    case_values: ClassVar[Cases] = (
        (VisibleGGX(1.0), (0.0, 0.0, 1.0)),
        (VisibleGGX(0.3, (0.6, -0.64, 0.48)), (0.6, -0.64, 0.48)),
        (VisibleGGX(0.3, (0.6, -0.64, 0.48), 0.1), (0.6, -0.64, 0.48)),
        (VisibleGGX(1e-3), (0.0, 0.0, 1.0)),
        (VisibleBeckmann(0.5, (0.6, 0.0, 0.8)), (0.6, 0.0, 0.8)),
        (GGX(0.3), (0.6, -0.64, 0.48)),
        (Beckmann(0.5, 0.2), (0.8, 0.0, 0.6)),
        (UniformHemisphere(), (0.0, 0.6, 0.8)),
        (HenyeyGreenstein(0.7), (0.0, 0.6, 0.8)),
    )

    def __post_init__(self) -> None:
        """Check the parameters, and derive the bounds of errors from the bounds for the lobe of normals."""
        super().__post_init__()
        if self.lobe.in_world:
            raise ValueError(f"lobe: got {self.lobe!r}, whose directions are in world coordinates, want a lobe of normals")
        object.__setattr__(self, "worst_angle", 2.0 * self.lobe.worst_angle + 2e-7)
        if "beckmann" not in self.lobe.name:
            object.__setattr__(self, "worst_pdf", Distribution.worst_pdf)

    def bound_maps(self, start: int = 0) -> Maps:
        """Return the Warp functions of (u or w, Parameters), with parameters from number `start` on; see `Distribution`."""
        lobe, end = self.lobe, start + self.lobe.size
        return reflection_maps(lobe.bound_maps(start), end, end - 3, lobe.support != "hemisphere")

    @property
    def stretch(self) -> Any:
        """The stretch matrix of the lobe of normals, for tests that count normals in cells."""
        return self.lobe.stretch

    @property
    def mirror(self) -> tuple[float, ...]:  # type: ignore[override]
        """The view as a tuple of numbers, rounded to float32 as in kernels."""
        return tuple(self.view_of_kernels.tolist())

    @property
    def largest_angle(self) -> float:
        """Largest angle to +z, in radians, of the normals with z above 0 that reflect the view."""
        return min(self.lobe.largest_angle, float(np.pi / 2.0))

    def seam(self, u: Any) -> Any:
        """Return the mask of points u near a seam or the pole of the lobe, or with a normal nearly across the view."""
        return self.lobe.seam(u) | (u[..., 0] < 0.01) | (np.abs(self.lobe.sample(u) @ self.view_of_kernels) < 0.3)


RECORD = Reflection
