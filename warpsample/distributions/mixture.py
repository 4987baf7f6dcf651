"""Mixture of lobes: each direction comes from one of them, chosen by weights."""

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import warp as wp
from typing_extensions import Self

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.maps import Maps
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.parameters import MOST_NUMBERS, Parameters, number_at
from warpsample.distributions.record import Cases, Distribution
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.distributions.von_mises_fisher import VonMisesFisher
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.host.locks import once
from warpsample.maths.numerics import GRID, uniform_from_double

_MOST = 8
_PART = 1 << 16  # rows of weights that are converted at a time


@once
def build_chooser(count: int, first: int) -> wp.Function:
    """Build the wp.func (x, Parameters) that chooses one of `count` parts of the unit interval for x.

    The widths of the parts begin with number `first` of the parameters. The result is (start of the part, width, index of
    the part, end of all parts). All sums of widths are exact: the widths are multiples of 2^-24.
    """
    if count == 1:

        @wp.func
        def choose(x: wp.float32, parameters: Parameters):  # noqa: ARG001
            """Return the first part."""
            width = number_at(parameters, first)
            return wp.vec4(0.0, width, 0.0, width)

        return choose

    before, last, place = build_chooser(count - 1, first), count - 1, count - 1.0

    @wp.func
    def choose(x: wp.float32, parameters: Parameters):
        """Return the last part if x is in the last part, else a part before."""
        c = before(x, parameters)
        width = number_at(parameters, first + last)
        inside = x >= c[3]
        return wp.vec4(
            wp.where(inside, c[3], c[0]), wp.where(inside, width, c[1]), wp.where(inside, place, c[2]), c[3] + width
        )

    return choose


@once
def build_drawer(parts: tuple[Maps, ...]) -> wp.Function:
    """Build the wp.func (u, index, Parameters) that returns the direction and the density of the part of an index at u.

    The density is -1 for parts without a function `draw`.
    """
    sample, draw, last, place = parts[-1].sample, parts[-1].draw, len(parts) - 1, len(parts) - 1.0
    if draw is None:

        @wp.func
        def draw(u: wp.vec2, parameters: Parameters):
            """Return a direction of the last part, with density -1."""
            w = sample(u, parameters)
            return wp.vec4(w[0], w[1], w[2], -1.0)

    if last == 0:

        @wp.func
        def draw_part(u: wp.vec2, index: wp.float32, parameters: Parameters):  # noqa: ARG001
            """Return a direction of the only part."""
            return draw(u, parameters)

        return draw_part

    before = build_drawer(parts[:-1])

    @wp.func
    def draw_part(u: wp.vec2, index: wp.float32, parameters: Parameters):
        """Return a direction of the last part or of one before."""
        a = before(u, index, parameters)
        b = draw(u, parameters)
        here = index == place
        return wp.vec4(
            wp.where(here, b[0], a[0]), wp.where(here, b[1], a[1]), wp.where(here, b[2], a[2]), wp.where(here, b[3], a[3])
        )

    return draw_part


@once
def build_sum(parts: tuple[Maps, ...], first: int) -> wp.Function:
    """Build the wp.func (w, index, drawn, Parameters) that returns the density of a mixture at a direction w.

    `drawn` replaces the density of the part of the index, if it is at least 0.
    """
    density, last, place = parts[-1].pdf, len(parts) - 1, len(parts) - 1.0

    @wp.func
    def part(w: wp.vec3, index: wp.float32, drawn: wp.float32, parameters: Parameters):
        """Return the share of the last part."""
        known = wp.where(index == place, drawn, -1.0)
        return number_at(parameters, first + last) * wp.where(known >= 0.0, known, density(w, parameters))

    if last == 0:
        return part
    before = build_sum(parts[:-1], first)

    @wp.func
    def total(w: wp.vec3, index: wp.float32, drawn: wp.float32, parameters: Parameters):
        """Return the sum of the shares of all parts."""
        return before(w, index, drawn, parameters) + part(w, index, drawn, parameters)

    return total


@once
def mixture_maps(parts: tuple[Maps, ...], first: int) -> Maps:
    """Build the functions of a mixture from the functions of the parts; the weights begin at parameter `first`."""
    choose, draw_part, total = build_chooser(len(parts), first), build_drawer(parts), build_sum(parts, first)

    @wp.func
    def draw(u: wp.vec2, parameters: Parameters):
        """Choose a part by u[0], stretch the part's interval of u[0] to the unit interval, and draw from the part."""
        c = choose(u[0], parameters)
        x = uniform_from_double((wp.float64(u[0]) - wp.float64(c[0])) / wp.float64(c[1]))
        d = draw_part(wp.vec2(x, u[1]), c[2], parameters)
        return wp.vec4(d[0], d[1], d[2], total(wp.vec3(d[0], d[1], d[2]), c[2], d[3], parameters))

    @wp.func
    def sample(u: wp.vec2, parameters: Parameters):
        """Return the direction of `draw`."""
        c = choose(u[0], parameters)
        x = uniform_from_double((wp.float64(u[0]) - wp.float64(c[0])) / wp.float64(c[1]))
        d = draw_part(wp.vec2(x, u[1]), c[2], parameters)
        return wp.vec3(d[0], d[1], d[2])

    @wp.func
    def pdf(w: wp.vec3, parameters: Parameters):
        """Return the weighted sum of the densities of all parts."""
        return total(w, -1.0, -1.0, parameters)

    return Maps(sample, pdf, draw=draw)


@dataclass(frozen=True)
class Mixture(Distribution):
    """Mixture of one to eight lobes: a direction comes from lobe i with the weight w_i. The density is Σ w_i p_i.

    u[0] chooses the lobe, and its place in the lobe's interval is the lobe's own u[0]; so points that are even in the square
    stay even within each lobe. The density at a direction is that of all lobes, the balance heuristic of Veach1995.

    Attributes:
        lobes: one to eight distributions of local directions in space, with 20 float32 numbers at most, weights included.
        weights: one number for each lobe, (k,), or (P, k) for each point, at least 0, not all 0. They are divided by their
            sum, and rounded to multiples of 2^-24, none above 0 to 0.
    """

    lobes: tuple[Distribution, ...]
    weights: tuple[float, ...]

    name = "mixture"
    density = "Σwᵢpᵢ(w)"
    support = "sphere"
    parameters: ClassVar[tuple[str, ...]] = ("weights",)
    symmetric = False
    polar = False
    source = "Veach1995; Pharr2023, section 2.2"
    limits = (
        "the weights are multiples of 2⁻²⁴. A lobe of weight w has 24 − log2(1/w) bits of u[0]. Directions and densities "
        "are as precise as those of the lobes. There is no inverse unless there is one lobe only"
    )
    # A surface with a coat; three of the sphere; one alone; a brushed surface; eight, one never and one rarely drawn.
    case_values: ClassVar[Cases] = (
        ((CosineHemisphere(), GGX(0.3)), (0.3, 0.7)),
        ((UniformSphere(), VonMisesFisher(8.0), HenyeyGreenstein(0.5)), (0.25, 0.5, 0.25)),
        ((GGX(0.2),), (1.0,)),
        ((CosineHemisphere(), GGX(0.3, 0.1)), (0.4, 0.6)),
        (
            (
                UniformHemisphere(),
                *map(VonMisesFisher, (1.0, 4.0, 16.0)),
                *map(HenyeyGreenstein, (-0.5, 0.5)),
                *map(GGX, (0.2, 1.0)),
            ),
            (1.0, 0.0, 1.0, 2.0, 1e-3, 1.0, 1.0, 2.0),
        ),
    )

    def __post_init__(self) -> None:
        """Check the lobes and the weights."""
        lobes = self.lobes if isinstance(self.lobes, tuple | list) else ()
        if not 1 <= len(lobes) <= _MOST or not all(isinstance(lobe, Distribution) and lobe.width == 3 for lobe in lobes):
            raise TypeError(
                f"lobes: got {quote(self.lobes)}, want a list of one to eight distributions of directions in space"
            )
        if any(lobe.in_world for lobe in lobes):
            raise NotImplementedError("lobes: got a lobe whose directions are in world coordinates, want local ones only")
        object.__setattr__(self, "lobes", tuple(lobes))
        wants = f"{len(lobes)} numbers, one for each lobe, at least 0 and not all 0, or (P, {len(lobes)}) for each point"
        weights = as_real(self.weights, "weights", wants)
        if weights.ndim not in (1, 2) or weights.shape[-1] != len(lobes):
            raise ValueError(f"weights: got shape {weights.shape}, want {wants}")
        shares = _as_shares(weights.reshape(-1, len(lobes)))
        if weights.ndim == 1 and np.isnan(shares).any():
            raise ValueError(f"weights: got {quote(self.weights)}, want {wants}")
        object.__setattr__(self, "weights", shares if weights.ndim == 2 else tuple(shares[0].tolist()))
        if self.size > MOST_NUMBERS:
            raise ValueError(f"lobes: got {self.size} numbers with the weights, want at most {MOST_NUMBERS}")
        self._check_lengths()
        for name in ("worst_angle", "worst_pdf", "worst_round_trip", "worst_unit_length"):
            object.__setattr__(self, name, max(getattr(lobe, name) for lobe in lobes))

    @property
    def nested(self) -> dict[str, Any]:
        """Lobes, by the names "lobes[0]", "lobes[1]" and so on."""
        return {f"lobes[{i}]": lobe for i, lobe in enumerate(self.lobes)}

    def _with_nested(self, lobes: dict[str, Any]) -> Self:
        """Return a copy with other lobes, given by their names."""
        copy = super()._with_nested({})
        object.__setattr__(copy, "lobes", tuple(lobes.values()))
        return copy

    def bound_maps(self, start: int = 0) -> Maps:
        """Return the functions with arguments (u or w, Parameters), which read the parameters from number `start` on."""
        starts = start + np.cumsum([0, *(lobe.size for lobe in self.lobes)])
        parts = tuple(lobe.bound_maps(int(at)) for lobe, at in zip(self.lobes, starts, strict=False))
        return parts[0] if len(parts) == 1 else mixture_maps(parts, int(starts[-1]))

    @property
    def maps(self) -> Maps:  # type: ignore[override]
        """The `wp.func`s of the mixture for kernels, with arguments (u or w, Parameters)."""
        maps, own = self.bound_maps(), self.lobes[0].maps
        return (
            maps if len(self.lobes) > 1 else replace(maps, about=own.about, redraw=own.redraw, redraw_below=own.redraw_below)
        )

    @property
    def variates(self) -> int:  # type: ignore[override]
        """Number of coordinates of u that the map uses."""
        return 2 if len(self.lobes) > 1 else self.lobes[0].variates

    def seam(self, u: Any) -> Any:
        """Return the mask of points u that `invert` cannot recover precisely. See `Distribution.seam`."""
        return self.lobes[0].seam(u)


def _as_shares(weights: np.ndarray) -> np.ndarray:
    """Return (P, k) weights over their sum as read-only float32 multiples of 2^-24 whose sum is 1; NaN for bad rows."""
    shares = np.empty(weights.shape, np.float32)
    for start in range(0, len(weights), _PART):
        part = weights[start : start + _PART].astype(np.float64)
        with np.errstate(all="ignore"):
            part = part / part.max(axis=1, keepdims=True)
            part = part / part.sum(axis=1, keepdims=True)
        part[~(part >= 0.0).all(axis=1)] = np.nan
        steps = np.where(part > 0.0, np.maximum(np.rint(part * GRID), 1.0), part)
        largest = np.argmax(np.nan_to_num(steps), axis=1)[:, None]
        rest = GRID - steps.sum(axis=1, keepdims=True)
        np.put_along_axis(steps, largest, np.take_along_axis(steps, largest, axis=1) + rest, axis=1)
        shares[start : start + _PART] = steps / GRID
    shares.setflags(write=False)
    return shares


RECORD = Mixture
