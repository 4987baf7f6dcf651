"""GGX normals as a viewer sees them: weighted by the area that each shows to the view."""

from dataclasses import dataclass
from typing import Any, ClassVar

import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.host.arrays import as_view
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import INV_PI, ZERO, clamp_uniform, fma, polish, root, sincos_turns

_BLUR = wp.constant(wp.float64(2.0**-21))
_TINY = wp.constant(wp.float32(1e-30))


@wp.func
def stretched_view(alpha: wp.float32, view: wp.vec3) -> wp.vec4:
    """(sine, cosine of the angle to +z; cosine, sine of the azimuth) of the view, the surface stretched to a sphere.

    A view along +z has no azimuth; by the view's x and y the gradient there is 0.
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
    """v.m, at least the rounding error of its three terms; 0 where it is below minus that. So is its gradient."""
    x = wp.float64(m[0]) * wp.float64(view[0])
    y = wp.float64(m[1]) * wp.float64(view[1])
    z = wp.float64(m[2]) * wp.float64(view[2])
    facing = x + y + z
    rounding = _BLUR * (wp.abs(x) + wp.abs(y) + wp.abs(z))
    return wp.float32(wp.where(facing > -rounding, wp.max(facing, rounding), ZERO))


@wp.func
def square_to_visible_ggx(u: wp.vec2, alpha: wp.float32, view: wp.vec3) -> wp.vec3:
    """The cap of the sphere above -v.z, plus the view v, unstretched: Dupuy2023, listing 3.

    Like the sphere plus the normal, it cancels where the sum h is short. With c the cap's point,
    h.z = (1 - u[0]) (1 + v.z) is exact, sin c - sin v = h.z (2 v.z - h.z) / (sin c + sin v), and 1 + cos phi is
    2 cos^2(phi / 2) for phi = 2 pi u[1] from the view's azimuth; so the result is precise.
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
    """2 (v.m) D(m) / (cos v + sqrt(cos^2 v + alpha^2 sin^2 v)) per steradian where v.m > 0 and m above the surface, else 0.

    The view's horizon, v.m = 0, is blurred by the rounding error of the sum, so that no sampled direction has density 0.
    """
    across = fma(w[0], w[0], w[1] * w[1])
    ratio = alpha / fma(alpha * w[2], alpha * w[2], across)
    length = wp.sqrt(fma(alpha * alpha, fma(view[0], view[0], view[1] * view[1]), view[2] * view[2]))
    facing = blurred_facing(w, view)
    density = 2.0 * INV_PI * facing * ratio * ratio / (view[2] + length)
    return wp.where(facing > 0.0 and w[2] > 0.0, density, 0.0)


@wp.func
def visible_ggx_to_square(w: wp.vec3, alpha: wp.float32, view: wp.vec3) -> wp.vec2:
    """The cap's point is the view reflected about the stretched normal."""
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


@dataclass(frozen=True)
class VisibleNormals(Distribution):
    """Normals of a rough surface that are visible from a direction; not one distribution, but what they have in common."""

    alpha: float
    view: tuple[float, float, float] = (0.0, 0.0, 1.0)

    support = "hemisphere"
    parameters: ClassVar[tuple[str, ...]] = ("alpha", "view")
    shown: ClassVar[Range] = (0.05, 1.0)
    bounds: ClassVar[Range] = (1e-6, 1.0)
    symmetric = False

    def __post_init__(self) -> None:
        """Checks the roughness and the view."""
        super().__post_init__()
        object.__setattr__(self, "view", as_view(self.view, "view"))


class VisibleGGX(VisibleNormals):
    """GGX normals visible from a direction: D(m) max(0, v·m) / σ(v) per steradian, σ the area that the view sees.

    Attributes:
        alpha: roughness, from 1e-6 to 1.
        view: direction to the viewer in the local frame, at or above the surface, of any length; kept as a unit vector.
    """

    name = "visible_ggx"
    density = "D(m)max(0,v·m)/σ(v), σ=(v_z+√(v_z²+α²(1−v_z²)))/2"
    source = "Heitz2014, equation 3; sampled as in Dupuy2023, section 3"
    limits = (
        "the horizon of the view is blurred by rounding; "
        "the error of the inverse holds off the cap's poles, for u[0] from 0.06 to 0.94"
    )
    # From above, from the side, from the horizon.
    case_values: ClassVar[Cases] = (
        (1.0, (0.0, 0.0, 1.0)),
        (0.3, (0.6, -0.64, 0.48)),
        (0.5, (1.0, 0.0, 0.0)),
        (1e-6, (-0.8, 0.0, 0.6)),
        (1e-6, (1.0, 0.0, 0.0)),
    )
    maps: ClassVar[Maps] = Maps(square_to_visible_ggx, square_to_visible_ggx_pdf, visible_ggx_to_square)

    def seam(self, u: Any) -> Any:
        """The cap's poles. See `Distribution.seam`."""
        return abs(u[..., 0] - 0.5) > 0.44


RECORD = VisibleGGX
