"""Reflection and refraction of a view at the normals of a rough interface of two transparent media."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.by_point.rows import copy_rows
from warpsample.distributions.maps import Maps
from warpsample.distributions.microfacets.visible_beckmann import VisibleBeckmann
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.distributions.parameters import Parameters, number_at
from warpsample.distributions.record import Cases, Distribution
from warpsample.distributions.scattering.base import ScatteredLight
from warpsample.distributions.scattering.dielectric import (
    fresnel_dielectric,
    normal_to_refraction,
    reflection_of,
    refraction_of,
    third_uniform,
    transmitted_share,
)
from warpsample.distributions.scattering.reflection import cosine_between, normals_per_cosine, reflected
from warpsample.host.arguments import check_number, quote
from warpsample.host.locks import once
from warpsample.maths.numerics import fma, root

_LOWEST, _HIGHEST, _APART = 0.01, 100.0, 1e-3
_WANTS = f"a number from {_LOWEST} to {_HIGHEST:g}, at least {_APART} away from 1"


@once
def _scene_reader(view_at: int) -> wp.Function:
    """Build the wp.func (Parameters) that returns (view, eta) as if the view came from above, and the sign of the view's z.

    The view is at number `view_at`, eta behind it. For a view from below, the scene is turned by a reflection at the point.
    """

    @wp.func
    def read(parameters: Parameters):
        """Read the numbers."""
        z = number_at(parameters, view_at + 2)
        eta = number_at(parameters, view_at + 3)
        sign = wp.where(z < 0.0, -1.0, 1.0)
        view = wp.vec3(sign * number_at(parameters, view_at), sign * number_at(parameters, view_at + 1), sign * z)
        return view, wp.where(z < 0.0, 1.0 / eta, eta), sign

    return read


@wp.func
def _pass_light(m: wp.vec3, cosine: wp.float32, view: wp.vec3, eta: wp.float32, chance: wp.float32):
    """Return (w, whether m reflects, factor): the view v reflected at the normal m if `chance` is below F, else refracted.

    The density of w from the chosen part is that of m, divided by the cosine m.v, times the factor.
    """
    share = fresnel_dielectric(cosine, eta)
    mirrors = chance < share
    mirrored = reflected(m, view, cosine)
    bent = normal_to_refraction(m, view, eta)
    w = wp.vec3(
        wp.where(mirrors, mirrored[0], bent[0]),
        wp.where(mirrors, mirrored[1], bent[1]),
        wp.where(mirrors, mirrored[2], bent[2]),
    )
    excess = (eta - 1.0) * (eta + 1.0)
    g = root(wp.max(fma(cosine, cosine, excess), 0.0))
    spread = (cosine + g) / excess
    through = wp.float32(transmitted_share(wp.float64(cosine), wp.float64(g), wp.float64(eta) * wp.float64(eta)))
    return w, mirrors, wp.where(mirrors, 0.25 * share, cosine * through * g * eta * spread * spread)


@wp.func
def _other_normal(w: wp.vec3, view: wp.vec3, eta: wp.float32, mirrors: wp.bool):
    """Return (m, m.v, factor) for the part that was not chosen: w may also be refracted, or reflected, at another normal."""
    h, half_cosine, half_factor = reflection_of(w, view, eta)
    t, cosine, factor = refraction_of(w, view, eta)
    m = wp.vec3(wp.where(mirrors, t[0], h[0]), wp.where(mirrors, t[1], h[1]), wp.where(mirrors, t[2], h[2]))
    return m, wp.where(mirrors, cosine, half_cosine), wp.where(mirrors, factor, half_factor)


@once
def rough_dielectric_maps(lobe: Maps, view_at: int, lobe_view_at: int, both: bool) -> Maps:
    """Build the Warp functions of `RoughDielectric` (map and density) from the functions of the lobe of normals.

    Args:
        lobe: functions of (u or m, Parameters).
        view_at: index of the first number of the view in `Parameters`; eta follows the view.
        lobe_view_at: index of the first number of the lobe's own view, for visible normals.
        both: whether m and -m can both have a density above 0.
    """
    sample_normal, scene = lobe.sample, _scene_reader(view_at)
    side = normals_per_cosine(lobe, view_at, lobe_view_at, True)

    @wp.func
    def normals(m: wp.vec3, cosine: wp.float32, parameters: Parameters):
        """Return the density of m and -m together, divided by the cosine."""
        return side(m, cosine, parameters) + side(wp.vec3(-m[0], -m[1], -m[2]), -cosine, parameters)

    @wp.func
    def pdf(w: wp.vec3, parameters: Parameters):
        """Return the sum of the densities of reflection and refraction."""
        view, eta, sign = scene(parameters)
        d = wp.vec3(sign * w[0], sign * w[1], sign * w[2])
        h, half_cosine, half_factor = reflection_of(d, view, eta)
        t, cosine, factor = refraction_of(d, view, eta)
        reflection = half_factor * normals(h, half_cosine, parameters)
        refraction = factor * normals(t, cosine, parameters)
        return wp.where(half_factor > 0.0, reflection, 0.0) + wp.where(factor > 0.0, refraction, 0.0)

    @wp.func
    def draw(u: wp.vec2, parameters: Parameters):
        """Choose by Fresnel's share, and take the density of the chosen part from the normal."""
        view, eta, sign = scene(parameters)
        m = sample_normal(u, parameters)
        cosine = cosine_between(m, view)
        own = side(m, cosine, parameters)
        if wp.static(both):
            own += side(wp.vec3(-m[0], -m[1], -m[2]), -cosine, parameters)
        turn = wp.where(cosine < 0.0, -1.0, 1.0)
        m = wp.vec3(turn * m[0], turn * m[1], turn * m[2])
        w, mirrors, factor = _pass_light(m, wp.abs(cosine), view, eta, third_uniform(u))
        n, other_cosine, other_factor = _other_normal(w, view, eta, mirrors)
        other = wp.where(other_factor > 0.0, other_factor * normals(n, other_cosine, parameters), 0.0)
        return wp.vec4(sign * w[0], sign * w[1], sign * w[2], factor * own + other)

    @wp.func
    def sample(u: wp.vec2, parameters: Parameters):
        """Reflect or refract the view at a normal."""
        drawn = draw(u, parameters)
        return wp.vec3(drawn[0], drawn[1], drawn[2])

    return Maps(sample, pdf, draw=draw)


@dataclass(frozen=True)
class RoughDielectric(ScatteredLight):
    """Directions in which a rough transparent surface, such as ground glass, reflects or refracts the view.

    Fresnel's share F of a normal is reflected, the rest refracted. A hash of the bits of u chooses, so that there is no
    inverse. The density per steradian is p(m) F / (4 v·m) for the normal m that reflects the view v to w, plus
    p(t) (1−F) abs(w·t) η² / abs(v+ηw)² for the normal t that refracts the view to w. It integrates to 1.

    Attributes:
        lobe: lobe of normals, usually `VisibleGGX` or `VisibleBeckmann` with the same view; also any other distribution. For
            a view from below, the normals are those that are visible from −v: `VisibleGGX(alpha, np.where(v[:, 2:] < 0, -v,
            v))`.
        view: direction v to the viewer in the local frame, of any length, also from below the surface; stored as a unit
            vector.
        eta: index of refraction below the surface over that above, 0.01 to 100, not within 1e-3 of 1. Default: 1.5, glass.
    """

    eta: float = 1.5

    name = "rough_dielectric"
    density = "p(m)F/(4v·m)+p(t)(1−F)abs(w·t)η²/abs(v+ηw)²"
    parameters: ClassVar[tuple[str, ...]] = ("view", "eta")
    below = True
    source = "Walter2007, equations 13 to 22; the choice by a hash: own"
    limits = (
        "there is no inverse, because a hash of u chooses between reflection and refraction. A reflected direction has "
        "twice the error of the lobe's normals. For a view from the denser side the direction is less precise near the "
        "rim of total reflection, where its derivative is infinite. The error is not measured for squared cosines of "
        "refraction below 1e-3. The density of Beckmann's normals is less precise than others, because the exponential "
        "of the slope of m multiplies the rounding of w"
    )
    worst_angle: ClassVar[float] = 3e-5
    worst_pdf: ClassVar[float] = 6e-6
    # From above and from below; glass, water, and an index close to 1.
    case_values: ClassVar[Cases] = (
        (VisibleGGX(0.3), (0.0, 0.0, 1.0), 1.5),
        (VisibleGGX(0.05), (0.0, 0.0, -1.0), 1.5),
        (VisibleGGX(0.3, (0.6, 0.0, 0.8)), (0.6, 0.0, 0.8), 1.33),
        (VisibleGGX(0.4, (0.6, 0.0, 0.8), 0.3), (-0.6, 0.0, -0.8), 1.5),
        (VisibleBeckmann(0.5, (0.6, 0.0, 0.8)), (0.6, 0.0, 0.8), 1.1),
    )

    def __post_init__(self) -> None:
        """Check the parameters."""
        super().__post_init__()
        if not (isinstance(self.eta, np.ndarray) and self.eta.ndim):
            eta = check_number(self.eta, "eta", _LOWEST, _HIGHEST)
            if abs(eta - 1.0) < _APART:
                raise ValueError(f"eta: got {quote(self.eta)}, want {_WANTS}")
            object.__setattr__(self, "eta", eta)
            if isinstance(self.view, tuple) and (eta > 1.0) == (self.view[2] >= 0.0):
                object.__setattr__(self, "worst_angle", 2.0 * self.lobe.worst_angle + 2e-7)
        if "beckmann" not in self.lobe.name:
            object.__setattr__(self, "worst_pdf", Distribution.worst_pdf)

    def _copy_rows(self, name: str, rows: np.ndarray) -> np.ndarray:
        """Return a parameter by point as float32, with NaN in the rows that are out of range; see `Distribution`."""
        if name != "eta":
            return super()._copy_rows(name, rows)
        return copy_rows(np.where(np.abs(rows - 1.0) < _APART, np.nan, rows), _LOWEST, _HIGHEST)

    def bound_maps(self, start: int = 0) -> Maps:
        """Return the Warp functions of (u or w, Parameters), with parameters from number `start` on; see `Distribution`."""
        lobe, end = self.lobe, start + self.lobe.size
        return rough_dielectric_maps(lobe.bound_maps(start), end, end - 3, lobe.support != "hemisphere")

    @property
    def jumps(self) -> tuple[float, ...]:  # type: ignore[override]
        """Angles to +z of the directions at which the normals of reflection or of refraction are horizontal."""
        z = float(self.view_of_kernels[2])
        index = float(self.eta) if z >= 0.0 else 1.0 / float(self.eta)
        return tuple(float(np.arccos(-z / n)) for n in (1.0, index) if abs(z) < n)

    def seam(self, u: Any) -> Any:
        """Return a mask that is False everywhere, because there is no inverse to test. See `Distribution.seam`."""
        return np.zeros(np.shape(u)[:-1], bool)


RECORD = RoughDielectric
