"""The record of a distribution: its properties, and its maps applied to arrays."""

from dataclasses import dataclass
from math import pi
from typing import Any, ClassVar, TypeAlias

import numpy as np
import warp as wp

from warpsample.distributions.elementwise import FLAT_BLOCK, elementwise
from warpsample.distributions.parameters import bind_parameters, build_about, pack_parameters
from warpsample.host.arguments import check_number
from warpsample.host.arrays import Array, Floats, as_real, as_square
from warpsample.host.engine import check_workers, run
from warpsample.host.neighbours import from_cuda
from warpsample.host.vectors import as_vectors, new_vectors

Range: TypeAlias = tuple[float, float] | None
Cases: TypeAlias = tuple[tuple[Any, ...], ...]

_VECTORS = {2: wp.vec2, 3: wp.vec3}


@dataclass(frozen=True)
class Maps:
    """The `wp.func`s of a distribution. Those that take its parameters take them after the first argument.

    Attributes:
        sample: u (vec2 in [0, 1)^2) -> w (vec3, unit length, local frame, +z the normal; planar ones vec2).
        pdf: w -> density in the distribution's measure; 0 outside the support.
        invert: w -> u, the way back of `sample`; None where several u go to one w.
        about: (unit normal n, u, Parameters) -> (world direction, pdf), where a way without a tangent frame exists.
        redraw: what replaces `about` where its pdf is below `redraw_below`, should it lose its digits there.
        redraw_below: that pdf.
    """

    sample: wp.Function
    pdf: wp.Function
    invert: wp.Function | None = None
    about: wp.Function | None = None
    redraw: wp.Function | None = None
    redraw_below: float = 0.0


@dataclass(frozen=True)
class Distribution:
    """A density of directions about a normal. Subclasses are frozen dataclasses of its parameters.

    Attributes:
        maps: the `wp.func`s to use in kernels of your own.
        case_values: of the fields, those of `cases`, in tuples.
        name: what users call it by.
        density: the formula of the pdf, for tables.
        measure: what the pdf is per: "per steradian", "per unit area" or "per radian".
        support: where the pdf is above 0, in words.
        parameters: names of the fields that travel to the kernels, where they are float32: a scalar, then a vector.
        bounds: least and greatest value of the scalar.
        shown: what of the scalar is worth looking at, from above 0; for sliders, which span it by its logarithm.
        width: components of w, 3, or 2 for what lies in a plane.
        variates: coordinates of u that the map uses.
        symmetric: whether the density is one of the angle to +z alone.
        polar: whether u[0] is its cdf, too, and u[1] the azimuth in turns.
        source: where the formulas come from.
        worst_unit_length: abs(abs(w) - 1) of `sample` over the whole grid of u.
        worst_angle: radians between `sample` and its float64 twin; for points of a disk, their distance.
        worst_pdf: relative error of `pdf` at exact directions.
        worst_round_trip: error of u, there and back, away from `seam`.
        limits: where an error is worse than those, or the density is not the formula, and why; for tables.
    """

    maps: ClassVar[Maps]
    case_values: ClassVar[Cases] = ((),)
    name: ClassVar[str]
    density: ClassVar[str]
    measure: ClassVar[str] = "per steradian"
    support: ClassVar[str]
    parameters: ClassVar[tuple[str, ...]] = ()
    bounds: ClassVar[Range] = None
    shown: ClassVar[Range] = None
    width: ClassVar[int] = 3
    variates: ClassVar[int] = 2
    symmetric: ClassVar[bool] = True
    polar: ClassVar[bool] = True
    source: ClassVar[str]
    worst_unit_length: ClassVar[float] = 2e-7
    worst_angle: ClassVar[float] = 3e-7
    worst_pdf: ClassVar[float] = 2e-6
    worst_round_trip: ClassVar[float] = 2e-6
    limits: ClassVar[str] = ""

    def __post_init__(self) -> None:
        """Checks a scalar that has bounds, and keeps it as a float."""
        if self.bounds is not None:
            name = self.parameters[0]
            object.__setattr__(self, name, check_number(getattr(self, name), name, *self.bounds))

    @classmethod
    def cases(cls) -> tuple["Distribution", ...]:
        """Instances that every law is proven for, from ordinary to extreme.

        Returns:
            at least one instance.

        Example:
            >>> print(len(ws.GGX.cases()), ws.PowerCosine.cases()[0])
            4 PowerCosine(exponent=0.0)
        """
        return tuple(cls(*values) for values in cls.case_values)

    @property
    def largest_angle(self) -> float:
        """The support's greatest angle to +z in radians; for points of a disk its radius."""
        return pi if self.support == "sphere" else pi / 2.0

    @property
    def thinnest_tail(self) -> float:
        """Probability of the thinnest tail that float32 directions resolve: for tests."""
        return 1e-5

    def cdf(self, theta: Any) -> np.ndarray:
        """Chance of an angle to +z of at most theta.

        Args:
            theta: (...) radians, in [0, pi]; with a sign for directions in the plane; for points of a disk the radius.

        Returns:
            (...) float64 in [0, 1]; 0 below that range and 1 above it.

        Raises:
            TypeError: theta is not real numbers.
            NotImplementedError: no closed form is known.

        Example:
            >>> print(ws.CosineHemisphere().cdf(np.radians([0.0, 30.0, 45.0, 90.0])).round(2))
            [0.   0.25 0.5  1.  ]
        """
        return self._cdf(np.clip(as_real(theta, "theta").astype(np.float64), 0.0 if self.width == 3 else -pi, pi))

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """`cdf` of float64 angles that can be."""
        raise NotImplementedError(f"{self!r}: its density does not depend on the angle alone")

    def seam(self, u: np.ndarray) -> np.ndarray:
        """Which u `invert` cannot give back to float32 accuracy: by default those of the pole, which has no azimuth.

        Args:
            u: (..., 2) float, in [0, 1).

        Returns:
            (...) bool.

        Example:
            >>> print(ws.CosineHemisphere().seam(np.array([[0.0, 0.5], [0.5, 0.5]])))
            [ True False]
        """
        return u[..., 0] == 0.0

    def sample(self, u: Any) -> Floats:
        """Directions of points of the square.

        Args:
            u: (..., 2) float, in [0, 1).

        Returns:
            (..., 3) float32, unit length, local frame with +z the normal; planar ones (..., 2), with +y the normal.
            NumPy for NumPy and what else is in the CPU's memory, wp.array for wp.array and what else is on a CUDA device.

        Raises:
            TypeError, ValueError: u is not floating-point, its last axis is not 2, or a value is outside [0, 1).

        Example:
            >>> w = ws.CosineHemisphere().sample(ws.sample_square("sobol", points=1, count=256))
            >>> print(w.shape, f"{w[..., 2].mean():.2f}")  # the mean cosine is 2/3
            (1, 256, 3) 0.67
        """
        u = from_cuda(u, "u")
        u = u if isinstance(u, wp.array) else as_square(u, "u")
        return self._apply(self.maps.sample, u, width=2, out_width=self.width, argument="u")

    def pdf(self, w: Any) -> Floats:
        """Density at unit directions, in the distribution's measure.

        Args:
            w: (..., 3) float, unit length, local frame; planar ones (..., 2).

        Returns:
            (...) float32, at least 0; 0 outside the support and where w is NaN.

        Raises:
            TypeError, ValueError: w is not floating-point, or its last axis has another length.

        Example:
            >>> print(ws.CosineHemisphere().pdf(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])).round(4))  # 1 / pi; below: 0
            [0.3183 0.    ]
        """
        return self._apply(self.maps.pdf, w, width=self.width, out_width=1, argument="w")

    def invert(self, w: Any) -> Floats:
        """The points of the square that `sample` sends to the directions w.

        Args:
            w: (..., 3) float, unit length, local frame, in the support; planar ones (..., 2).

        Returns:
            (..., 2) float32 in [0, 1).

        Raises:
            TypeError, ValueError: w is not floating-point, or its last axis has another length.
            NotImplementedError: `sample` sends several u to one w, or `maps` name no inverse.

        Example:
            >>> lobe = ws.GGX(alpha=0.3)
            >>> print(lobe.invert(lobe.sample(np.array([[0.25, 0.75]]))).round(3))
            [[0.25 0.75]]
        """
        if self.maps.invert is None:
            raise NotImplementedError(f"{self!r}: sample sends several u to one w, or its Maps name no invert")
        return self._apply(self.maps.invert, w, width=self.width, out_width=2, argument="w")

    def kernel_parameters(self) -> Any:
        """This instance's scalars as the kernels take them.

        Returns:
            a struct of float32, a kernel's argument: another value compiles nothing.

        Example:
            >>> print(ws.GGX(alpha=0.5).kernel_parameters().scalar)
            0.5
        """
        return pack_parameters(tuple(getattr(self, name) for name in self.parameters))

    def about(self) -> wp.Function:
        """The map about a normal, for kernels; there is none for what lies in a plane.

        Returns:
            a `wp.func` (unit normal, u, Parameters) -> (world direction, pdf).

        Example:
            >>> print(type(ws.GGX(alpha=0.5).about()).__name__)  # called in a kernel, as about(n, u, parameters)
            Function
        """
        maps = self.maps
        if maps.about is not None:
            return maps.about
        count = len(self.parameters)
        return build_about(bind_parameters(maps.sample, wp.vec2, count), bind_parameters(maps.pdf, wp.vec3, count))

    def _apply(self, func: wp.Function, x: Any, *, width: int, out_width: int, argument: str) -> Array:
        source = as_vectors(x, width, argument)
        target = new_vectors(source, source.shape, out_width)
        bound = bind_parameters(func, _VECTORS[width], len(self.parameters))
        block = FLAT_BLOCK if source.device.is_cpu else 1
        inputs = [source.count, block, source.address, target.address, self.kernel_parameters()]
        if source.count:
            kernel = elementwise(bound, width, out_width)
            run(kernel, -(-source.count // block), inputs, source.device, workers=check_workers(None), work=source.count)
        return target.owner
