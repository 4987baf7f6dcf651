"""Base class of all distributions, with methods to sample directions, evaluate densities and invert the map."""

from dataclasses import dataclass
from math import pi
from typing import Any, ClassVar, TypeAlias

import numpy as np
import warp as wp

from warpsample.distributions.by_point.parameterised import Parameterised, Range
from warpsample.distributions.elementwise import FLAT_BLOCK, elementwise, elementwise_by_point
from warpsample.distributions.maps import Maps
from warpsample.distributions.parameters import (
    about_normal_of,
    bind_parameters,
    build_about,
    build_about_drawn,
    build_about_frame,
)
from warpsample.host.arguments import check_flag
from warpsample.host.arrays import Array, Floats, as_real, as_square
from warpsample.host.device_memory import Memory
from warpsample.host.engine import check_workers, run
from warpsample.host.neighbours import from_cuda
from warpsample.host.vectors import Vectors, as_vectors, new_vectors

Cases: TypeAlias = tuple[tuple[Any, ...], ...]

_VECTORS = {2: wp.vec2, 3: wp.vec3}


@dataclass(frozen=True)
class Distribution(Parameterised):
    """Probability density of directions about a normal; subclasses are frozen dataclasses of the parameters.

    A parameter is a constant, or an array with one row for each point: (P,) numbers, (P, 3) vectors. Arrays are copied as
    float32. A row out of range becomes NaN, and gives zero vectors, density 0 and a status.

    Attributes:
        maps: `wp.func`s of the distribution, for use in kernels.
        case_values: parameters of the instances that tests use, one tuple for each instance.
        name: value for the argument `distribution`.
        density: formula of the pdf, for tables.
        measure: unit of the pdf: "per steradian", "per unit area" or "per radian".
        support: name of the set where the pdf is above 0, such as "hemisphere".
        parameters: names of the fields that kernels receive as float32, at most four: scalars, vectors and matrices.
        bounds: smallest and largest value of the scalar; None for no check.
        shown: range of the scalar for logarithmic sliders, above 0; None for no slider.
        width: number of components of w: 3, or 2 in the plane.
        variates: number of coordinates of u that the map uses.
        symmetric: whether the density depends only on the angle to +z.
        mirror: unit vector v to the viewer, for a lobe of reflections of v; None for other lobes. The laws count directions
            in cells of the normals that reflect v to the directions.
        stretch: 3 x 3 matrix M, such that the lobe is round about +z in the coordinates o of directions M o / abs(M o); None
            for the coordinates themselves. The laws count directions in cells of o.
        jumps: angles to +z in radians, before the stretch, at which the density jumps; it may also jump at multiples of 1/16
            of a full azimuth.
        polar: whether u[0] is the cdf of the angle and u[1] the azimuth in turns.
        in_world: whether directions are in world coordinates, whatever the normal.
        source: source of the formulas.
        worst_unit_length: bound of abs(abs(w) - 1) for `sample`, over all u.
        worst_angle: bound of the angle in radians between `sample` and the float64 twin; for points of a disk, of the
            distance.
        worst_pdf: bound of the relative error of `pdf` at exact directions.
        worst_round_trip: bound of the error of u after `sample` and `invert`, outside `seam`.
        limits: exceptions to the bounds and to the formula of the density, with reasons, for tables.
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
    stretch: ClassVar[tuple[tuple[float, ...], ...] | None] = None
    mirror: ClassVar[tuple[float, ...] | None] = None
    jumps: ClassVar[tuple[float, ...]] = ()
    polar: ClassVar[bool] = True
    in_world: ClassVar[bool] = False
    source: ClassVar[str]
    worst_unit_length: ClassVar[float] = 2e-7
    worst_angle: ClassVar[float] = 3e-7
    worst_pdf: ClassVar[float] = 2e-6
    worst_round_trip: ClassVar[float] = 2e-6
    limits: ClassVar[str] = ""

    @classmethod
    def cases(cls) -> tuple["Distribution", ...]:
        """Return the instances that `warpsample verify` tests, from ordinary to extreme parameters.

        Returns:
            at least one instance.

        Example:
            >>> print(len(ws.GGX.cases()), ws.PowerCosine.cases()[0])
            7 PowerCosine(exponent=0.0)
        """
        return tuple(cls(*values) for values in cls.case_values)

    @property
    def largest_angle(self) -> float:
        """Largest angle to +z of the support in radians, before the stretch; for points of a disk, the radius."""
        return pi if self.support == "sphere" else pi / 2.0

    @property
    def thinnest_tail(self) -> float:
        """Smallest probability of extreme angles that statistical tests of float32 directions can examine."""
        return 1e-5

    def cdf(self, theta: Any) -> np.ndarray:
        """Return the cumulative distribution function: the probability of an angle to +z of at most theta.

        Args:
            theta: (...) radians, in [0, pi]; signed for directions in the plane; for points of a disk, the radius.

        Returns:
            (...) float64 in [0, 1]; 0 below that range and 1 above it.

        Raises:
            TypeError: theta is not real.
            NotImplementedError: the density depends on more than the angle, as for VisibleGGX.

        Example:
            >>> print(ws.CosineHemisphere().cdf(np.radians([0.0, 30.0, 45.0, 90.0])).round(2))
            [0.   0.25 0.5  1.  ]
        """
        return self._cdf(np.clip(as_real(theta, "theta").astype(np.float64), 0.0 if self.width == 3 else -pi, pi))

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the cumulative distribution function at float64 angles that are already clipped to the valid range."""
        raise NotImplementedError(
            f"{self!r}: this distribution has no cdf of the angle, because its density also depends on the azimuth"
        )

    def seam(self, u: np.ndarray) -> np.ndarray:
        """Return a mask of points u that `invert` cannot recover precisely: by default, the points mapped to the pole.

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
        """Map points of the unit square to directions about +z.

        Args:
            u: (..., 2) float, in [0, 1).

        Returns:
            (..., 3) float32, unit length, local frame with +z the normal; in the plane (..., 2), with +y the normal.
            The result is a wp.array if u is a wp.array or an array of another library on a CUDA device, else a NumPy array.

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
        """Return the probability density at unit directions, in the distribution's measure.

        Args:
            w: (..., 3) float, unit length, local frame; in the plane (..., 2).

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
        """Return the points of the unit square that `sample` maps to the directions w.

        Args:
            w: (..., 3) float, unit length, local frame, in the support; in the plane (..., 2).

        Returns:
            (..., 2) float32 in [0, 1).

        Raises:
            TypeError, ValueError: w is not floating-point, or its last axis has another length.
            NotImplementedError: `sample` maps several u to one w, or `maps` has no function `invert`.

        Example:
            >>> lobe = ws.GGX(alpha=0.3)
            >>> print(lobe.invert(lobe.sample(np.array([[0.25, 0.75]]))).round(3))
            [[0.25 0.75]]
        """
        if self.maps.invert is None:
            raise NotImplementedError(
                f"{self!r}: this distribution has no inverse, because several points u map to one direction, or because "
                "Maps has no invert"
            )
        return self._apply(self.maps.invert, w, width=self.width, out_width=2, argument="w")

    def about(self, tangents: bool = False) -> wp.Function:
        """Return the wp.func that samples directions about any normal or, with `tangents`, in any tangent frame.

        Args:
            tangents: whether the first argument of the function is a frame, a mat33 with the normal as its last column, in
                place of the unit normal. Default: False.

        Returns:
            a `wp.func` (unit normal, u, Parameters) -> (world direction, pdf).

        Example:
            >>> print(type(ws.GGX(alpha=0.5).about()).__name__)  # called in a kernel, as about(n, u, parameters)
            Function
        """
        maps = self.maps
        tangents = check_flag(tangents, "tangents")
        if maps.about is not None:
            return about_normal_of(maps.about) if tangents else maps.about
        maps = self.bound_maps()
        if maps.draw is not None:
            return build_about_drawn(maps.draw, tangents)
        return (build_about_frame if tangents else build_about)(maps.sample, maps.pdf)

    def bound_maps(self, start: int = 0) -> Maps:
        """Return the Warp functions of (u or w, Parameters), which read all parameters from one struct, for kernels.

        Args:
            start: index of the first number of the parameters in the struct. Default: 0.

        Returns:
            `Maps` with `sample`, `pdf`, `invert`, `draw` and `per_cosine` as functions of (u or w, Parameters).

        Example:
            >>> print(list(ws.GGX(alpha=0.5).bound_maps().sample.input_types))
            ['x', 'parameters']
        """
        return self.maps.bound(len(self.parameters), self.width, start)

    def _apply(self, func: wp.Function, x: Any, *, width: int, out_width: int, argument: str) -> Array:
        """Apply a wp.func of the distribution (map, density or inverse) to each vector in x; return an array like x."""
        source = as_vectors(x, width, argument)
        if self.by_point:
            self._check_rows_of(source, argument)
        target = new_vectors(source, source.shape, out_width)
        bound = bind_parameters(func, _VECTORS[width], len(self.parameters))
        if source.count:
            (self._apply_by_point if self.by_point else self._apply_constant)(bound, source, target)
        return target.owner

    def _check_rows_of(self, source: Vectors, argument: str) -> None:
        """Raise ValueError unless vectors are (P, ...) or (P, n, ...), with one row for each row of the parameters."""
        name, table = next(iter(self.by_point.items()))
        if len(source.shape) not in (1, 2) or source.shape[0] != len(table):
            wants = f"({len(table)}, {source.width}) or ({len(table)}, n, {source.width}), as {name} has {len(table):,} rows"
            raise ValueError(f"{argument}: got shape {(*source.shape, source.width)}, want {wants}")

    def _apply_constant(self, bound: wp.Function, source: Vectors, target: Vectors) -> None:
        """Apply a function of (vector, parameters) to each vector in `source`, with the same parameters for all."""
        block = FLAT_BLOCK if source.device.is_cpu else 1
        kernel = elementwise(bound, source.width, target.width)
        with Memory.of(None, source.owner).loan() as loan:
            inputs = [source.count, block, source.address, target.address, self.kernel_parameters(loan)]
            run(kernel, -(-source.count // block), inputs, source.device, workers=check_workers(None), work=source.count)

    def _apply_by_point(self, bound: wp.Function, source: Vectors, target: Vectors) -> None:
        """Apply a function of (vector, parameters) to each vector in `source`, with the parameters of the vector's point."""
        block, count = FLAT_BLOCK if source.device.is_cpu else 1, source.count // source.shape[0]
        kernel = elementwise_by_point(bound, source.width, target.width, self.layout, block)
        with Memory.of(None, source.owner).loan() as loan:
            inputs = [source.count, count, source.address, target.address, self.lend_tables(loan), self.kernel_parameters()]
            run(kernel, -(-source.count // block), inputs, source.device, workers=check_workers(None), work=source.count)
