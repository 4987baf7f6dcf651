"""Mixture of lobes: each direction comes from one of them, chosen by weights."""

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import warp as wp
from typing_extensions import Self

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.maps import Maps
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.mixture_maps import mixture_about, mixture_maps
from warpsample.distributions.parameters import MOST_NUMBERS
from warpsample.distributions.record import Cases, Distribution
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.distributions.von_mises_fisher import VonMisesFisher
from warpsample.host.arguments import check_flag, quote
from warpsample.host.arrays import as_real
from warpsample.maths.numerics import GRID

_MOST = 8
_PART = 1 << 16  # rows of weights that are converted at a time


@dataclass(frozen=True)
class Mixture(Distribution):
    """Mixture of one to eight lobes: a direction comes from lobe i with the weight w_i. The density is Σ w_i p_i.

    u[0] chooses the lobe, and its place in the lobe's interval is the lobe's own u[0]; so points that are even in the square
    stay even within each lobe. The density at a direction is that of all lobes, the balance heuristic of Veach1995.

    A lobe may be an `EnvironmentMap`, whose directions are in world coordinates. Then `sample` and `pdf` raise
    NotImplementedError, since they would need normals; `sample_directions` and `integrate` work.

    Attributes:
        lobes: one to eight distributions of directions in space, with 20 float32 numbers at most, weights included.
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
        if any(lobe.in_world and isinstance(lobe, Mixture) for lobe in lobes):
            raise NotImplementedError("lobes: got a mixture with a lobe in world coordinates, want that lobe itself")
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
        """Lobes of the mixture, keyed by "lobes[0]", "lobes[1]" and so on."""
        return {f"lobes[{i}]": lobe for i, lobe in enumerate(self.lobes)}

    def _with_nested(self, lobes: dict[str, Any]) -> Self:
        """Return a copy with other lobes, given by their names."""
        copy = super()._with_nested({})
        object.__setattr__(copy, "lobes", tuple(lobes.values()))
        return copy

    def bound_maps(self, start: int = 0) -> Maps:
        """Return the Warp functions of (u or w, Parameters), with parameters from number `start` on; see `Distribution`."""
        parts, first = self._bound_parts(start)
        return parts[0] if len(parts) == 1 else mixture_maps(parts, first, self._worlds)

    def _bound_parts(self, start: int) -> tuple[tuple[Maps, ...], int]:
        """Return the functions of the lobes, and the number of the first weight, for parameters from number `start` on."""
        starts = (start + np.cumsum([0, *(lobe.size for lobe in self.lobes)])).tolist()
        return tuple(lobe.bound_maps(at) for lobe, at in zip(self.lobes, starts, strict=False)), starts[-1]

    @property
    def in_world(self) -> bool:  # type: ignore[override]
        """True if a lobe's directions are in world coordinates, so that `sample` and `pdf` need normals."""
        return any(self._worlds)

    @property
    def _worlds(self) -> tuple[bool, ...]:
        """For each lobe, True if the directions are in world coordinates."""
        return tuple(lobe.in_world for lobe in self.lobes)

    def about(self, tangents: bool = False) -> wp.Function:
        """Return the wp.func that samples directions about any normal or, with `tangents`, in any tangent frame.

        Args:
            tangents: whether the first argument of the function is a frame, see `Distribution`. Default: False.

        Returns:
            a `wp.func` (unit normal or frame, u, Parameters) -> (world direction, pdf).

        Example:
            >>> lobe = ws.Mixture([ws.GGX(0.3), ws.EnvironmentMap(np.ones((2, 4)))], weights=[0.5, 0.5])
            >>> print(type(lobe.about()).__name__)
            Function
        """
        if len(self.lobes) == 1:
            return self.lobes[0].about(tangents)
        if not self.in_world:
            return super().about(tangents)
        return mixture_about(*self._bound_parts(0), self._worlds, check_flag(tangents, "tangents"))

    def _apply(self, func: wp.Function, x: Any, **how: Any) -> Any:
        """Apply a function to each vector, see `Distribution`, if all lobes are in local coordinates."""
        if self.in_world and len(self.lobes) > 1:
            raise NotImplementedError(
                f"{self!r}: sample and pdf need the normals of points, since a lobe is in world coordinates; "
                "sample_directions and integrate have them"
            )
        return super()._apply(func, x, **how)

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
