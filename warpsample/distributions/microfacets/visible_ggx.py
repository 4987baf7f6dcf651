"""Distribution of visible GGX normals: each microfacet is weighted by the area that it shows to the viewer."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.by_point.rows import copy_views
from warpsample.distributions.microfacets.base import Microfacets
from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.host.arrays import as_view
from warpsample.maths.angles import turns_of
from warpsample.maths.anisotropy import contracted, mean_and_stretch, stretched, stretched_to_unit
from warpsample.maths.numerics import INV_PI, ZERO, clamp_uniform, fma, polish, root, sincos_turns

_BLUR = wp.constant(wp.float64(2.0**-21))
_TINY = wp.constant(wp.float32(1e-30))


@wp.func
def stretched_view(alpha: wp.float32, view: wp.vec3) -> wp.vec4:
    """Return (sin v, cos v, cos phi, sin phi) of the view direction after x and y are multiplied by alpha.

    The scaling turns the ellipsoid of the normals into a sphere; v is the angle to +z and phi the azimuth of the scaled
    view. A view along +z has no azimuth; the gradient with respect to the view's x and y is 0 there.
    """
    across = root(fma(view[0], view[0], view[1] * view[1]))
    inverse = 1.0 / wp.sqrt(fma(alpha * across, alpha * across, view[2] * view[2]))
    per_across = 1.0 / wp.max(across, _TINY)
    turned = across > 0.0
    return wp.vec4(
        alpha * across * inverse,
        view[2] * inverse,
        wp.where(turned, view[0] * per_across, 1.0),
        wp.where(turned, view[1] * per_across, 0.0),
    )


@wp.func
def blurred_facing(m: wp.vec3, view: wp.vec3) -> wp.float32:
    """Return the cosine between normal m and view v, but not less than its own rounding error.

    Below minus the rounding error of the three products, the value and the gradient are 0.
    """
    x = wp.float64(m[0]) * wp.float64(view[0])
    y = wp.float64(m[1]) * wp.float64(view[1])
    z = wp.float64(m[2]) * wp.float64(view[2])
    facing = x + y + z
    rounding = _BLUR * (wp.abs(x) + wp.abs(y) + wp.abs(z))
    return wp.float32(wp.where(facing > -rounding, wp.max(facing, rounding), ZERO))


@wp.func
def square_to_visible_ggx(u: wp.vec2, alpha: wp.float32, view: wp.vec3) -> wp.vec3:
    """Map a point of the unit square to a GGX normal about +z that is visible from the direction `view`.

    Dupuy2023, listing 3: a uniform point c of the spherical cap above -v.z, plus the scaled view v, gives the scaled normal
    h. The sum would cancel where h is short. Three identities keep the result precise: h.z = (1 - u[0]) (1 + v.z) is exact,
    sin c - sin v = h.z (2 v.z - h.z) / (sin c + sin v), and 1 + cos phi = 2 cos^2(phi / 2) for phi = 2 pi u[1], counted from
    the azimuth of the view.
    """
    v = stretched_view(alpha, view)
    sin_v = v[0]
    rise = (1.0 - u[0]) * (1.0 + v[1])
    fall = u[0] * (1.0 + v[1])
    sin_c = root(fall * (rise + sin_v * sin_v / (1.0 + v[1])))
    half = sincos_turns(0.5 * u[1])
    cos_phi = fma(half[0], half[0], -half[1] * half[1])
    more = rise * (2.0 * v[1] - rise) / wp.max(sin_c + sin_v, _TINY)
    x = alpha * fma(more, cos_phi, 2.0 * sin_v * half[0] * half[0])
    y = alpha * (2.0 * sin_c * half[0] * half[1])
    inverse = 1.0 / wp.sqrt(fma(x, x, fma(y, y, rise * rise)))
    x = x * inverse
    y = y * inverse
    return polish(wp.vec3(fma(x, v[2], -y * v[3]), fma(x, v[3], y * v[2]), rise * inverse))


@wp.func
def square_to_visible_ggx_pdf(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the visible GGX normal m = w, per steradian; 0 where m faces away or is below the surface.

    The density is 2 (v.m) D(m) / (cos v + sqrt(cos^2 v + alpha^2 sin^2 v)) for the view v. The horizon of the view, v.m = 0,
    is blurred by the rounding error of v.m, so that no sampled normal has density 0.
    """
    return _density(w, alpha, view, blurred_facing(w, view))


@wp.func
def visible_ggx_per_cosine(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the visible GGX normal m = w, divided by v.m for the view v; 0 below the surface."""
    return _density(w, alpha, view, 1.0)


@wp.func
def _density(w: wp.vec3, alpha: wp.float32, view: wp.vec3, facing: wp.float32) -> wp.float32:
    """Return the density of a visible GGX normal w, given the cosine `facing` between normal and view."""
    across = fma(w[0], w[0], w[1] * w[1])
    ratio = alpha / fma(alpha * w[2], alpha * w[2], across)
    length = wp.sqrt(fma(alpha * alpha, fma(view[0], view[0], view[1] * view[1]), view[2] * view[2]))
    density = 2.0 * INV_PI * facing * ratio * ratio / (view[2] + length)
    return wp.where(facing > 0.0 and w[2] > 0.0, density, 0.0)


@wp.func
def visible_ggx_to_square(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_visible_ggx` maps to the direction w.

    The scaled view, reflected about the scaled normal, is the point of the cap.
    """
    v = stretched_view(alpha, view)
    x = fma(w[0], v[2], w[1] * v[3])
    y = fma(w[1], v[2], -w[0] * v[3])
    z = alpha * w[2]
    inverse = 1.0 / wp.sqrt(fma(x, x, fma(y, y, z * z)))
    x = x * inverse
    y = y * inverse
    z = z * inverse
    twice = 2.0 * fma(x, v[0], z * v[1])
    return wp.vec2(clamp_uniform(1.0 - twice * z / (1.0 + v[1])), turns_of(fma(twice, x, -v[0]), twice * y))


@wp.func
def square_to_anisotropic_visible_ggx(u: wp.vec2, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.vec3:
    """Map a point of the unit square to a visible GGX normal about +z, of roughness alpha along x and alpha_y along y.

    The isotropic map for the mean roughness and the stretched view gives a normal, which is stretched (Heitz2014).
    """
    m = mean_and_stretch(alpha, alpha_y)
    return stretched_to_unit(square_to_visible_ggx(u, m[0], stretched(view, m)), m)


@wp.func
def square_to_anisotropic_visible_ggx_pdf(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the anisotropic visible GGX normal m = w, per steradian.

    The density is 2 (v.m) D(m) / (v.z + sqrt((alpha v.x)^2 + (alpha_y v.y)^2 + v.z^2)) for the view v, with D of the two
    roughnesses. It is 0 where m faces away or is below the surface, and blurred as in `square_to_visible_ggx_pdf`.
    """
    m = mean_and_stretch(alpha, alpha_y)
    return _density(contracted(w, m), m[0], stretched(view, m), blurred_facing(w, view))


@wp.func
def anisotropic_visible_ggx_per_cosine(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.float32:
    """Return the density of the anisotropic visible GGX normal m = w, divided by v.m for the view v; 0 below the surface."""
    m = mean_and_stretch(alpha, alpha_y)
    return _density(contracted(w, m), m[0], stretched(view, m), 1.0)


@wp.func
def anisotropic_visible_ggx_to_square(w: wp.vec3, alpha: wp.float32, alpha_y: wp.float32, view: wp.vec3) -> wp.vec2:
    """Return the point u of the unit square that `square_to_anisotropic_visible_ggx` maps to the direction w."""
    m = mean_and_stretch(alpha, alpha_y)
    return visible_ggx_to_square(contracted(w, m), m[0], stretched(view, m))


@dataclass(frozen=True)
class VisibleNormals(Microfacets):
    """Base class of the distributions of visible normals, with the parameters `alpha`, `alpha_y` and `view`."""

    alpha: float
    view: tuple[float, float, float] = (0.0, 0.0, 1.0)
    alpha_y: float | None = None

    parameters: ClassVar[tuple[str, ...]] = ("alpha", "alpha_y", "view")
    shown: ClassVar[Range] = (0.05, 1.0)
    symmetric = False
    polar = False

    def __post_init__(self) -> None:
        """Check the roughness and the view, and normalise the view."""
        super().__post_init__()
        if not (isinstance(self.view, np.ndarray) and self.view.ndim == 2):
            object.__setattr__(self, "view", as_view(self.view, "view"))

    def _copy_rows(self, name: str, rows: np.ndarray) -> np.ndarray:
        """Return a read-only copy of a parameter with a row per point; view directions are normalised."""
        return copy_views(rows) if name == "view" else super()._copy_rows(name, rows)


class VisibleGGX(VisibleNormals):
    """Distribution of GGX normals m visible from a direction v, with density D(m) max(0, v·m) / σ(v) per steradian.

    σ(v) is the projected area of the visible surface.

    Attributes:
        alpha: roughness, from 1e-6 to 1. With `alpha_y`, the roughness along the x axis of the frame.
        view: direction v to the viewer in the local frame, at or above the surface, of any length; stored as a unit vector.
        alpha_y: roughness along the y axis of the frame, from 1e-6 to 1. Default: that along x.
    """

    name = "visible_ggx"
    density = "D(m)max(0,v·m)/σ(v), σ=(v_z+√(α_x²v_x²+α_y²v_y²+v_z²))/2"
    source = "Heitz2014, equation 3; sampled as in Dupuy2023, section 3"
    limits = (
        "the density is blurred by rounding at the horizon of the view, v·m = 0. "
        "The error of the inverse is measured for u[0] from 0.06 to 0.94, away from the poles of the spherical cap. "
        "With alpha_y the direction is within 5e-7, because the stretch adds to the rounding of the isotropic map"
    )
    worst_angle: ClassVar[float] = 5e-7
    # Views from above, from the side and from the horizon; then brushed surfaces.
    case_values: ClassVar[Cases] = (
        (1.0, (0.0, 0.0, 1.0)),
        (0.3, (0.6, -0.64, 0.48)),
        (0.5, (1.0, 0.0, 0.0)),
        (1e-6, (-0.8, 0.0, 0.6)),
        (1e-6, (1.0, 0.0, 0.0)),
        (0.3, (0.6, -0.64, 0.48), 0.1),
        (0.01, (0.6, 0.0, 0.8), 0.5),
        (1e-3, (0.6, 0.8, 0.0), 1e-2),
    )
    isotropic: ClassVar[Maps] = Maps(
        square_to_visible_ggx, square_to_visible_ggx_pdf, visible_ggx_to_square, per_cosine=visible_ggx_per_cosine
    )
    anisotropic: ClassVar[Maps] = Maps(
        square_to_anisotropic_visible_ggx,
        square_to_anisotropic_visible_ggx_pdf,
        anisotropic_visible_ggx_to_square,
        per_cosine=anisotropic_visible_ggx_per_cosine,
    )

    def __post_init__(self) -> None:
        """Check the parameters, and set the error bound `worst_angle` for the isotropic case."""
        super().__post_init__()
        if self.alpha_y is None:
            object.__setattr__(self, "worst_angle", Distribution.worst_angle)

    def seam(self, u: Any) -> Any:
        """Return a mask of unit-square points that `invert` cannot recover precisely. See `Distribution.seam`."""
        return abs(u[..., 0] - 0.5) > 0.44


RECORD = VisibleGGX
