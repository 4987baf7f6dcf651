"""What a distribution says of itself, and its maps on arrays."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.arrays import Array, as_vectors, new_vectors
from warpsample.engine import check_workers, run
from warpsample.kernels import FLAT_BLOCK
from warpsample.kernels.flat import elementwise
from warpsample.kernels.parameters import Parameters, about_frame, with_parameters


@dataclass(frozen=True)
class Maps:
    """The `wp.func`s of a distribution. Those that take its parameters take them as scalars after the first argument.

    Attributes:
        sample: u (vec2 in [0, 1)^2) -> w (vec3, unit length, local frame, +z the normal).
        pdf: w -> density in the distribution's measure; 0 outside the support.
        invert: w -> u, the way back of `sample`.
        about: (unit normal n, u, Parameters) -> (world direction, pdf), where a way without a tangent frame exists.
        redraw: what replaces `about` where its pdf is below `redraw_below`, should it lose its digits there.
        redraw_below: that pdf.
    """

    sample: wp.Function
    pdf: wp.Function
    invert: wp.Function
    about: wp.Function | None = None
    redraw: wp.Function | None = None
    redraw_below: float = 0.0


@dataclass(frozen=True)
class Distribution:
    """A density of directions about a normal. Subclasses are frozen dataclasses of its parameters.

    Attributes:
        name: what users call it by.
        density: formula of the pdf, for tables.
        measure: what the pdf is per.
        support: "sphere" or "hemisphere": where the pdf is above 0.
        parameters: names of the fields that travel to the kernels.
        source: where the formulas come from.
        worst_unit_length: abs(abs(w) - 1) of `sample` over the whole grid of u.
        worst_angle: radians between `sample` and its float64 twin.
        worst_pdf: relative error of `pdf` at exact directions.
        worst_round_trip: of u, away from u's own rim.
    """

    name: ClassVar[str]
    density: ClassVar[str]
    measure: ClassVar[str] = "per steradian"
    support: ClassVar[str]
    parameters: ClassVar[tuple[str, ...]] = ()
    source: ClassVar[str]
    worst_unit_length: ClassVar[float] = 2e-7
    worst_angle: ClassVar[float] = 3e-7
    worst_pdf: ClassVar[float] = 2e-6
    worst_round_trip: ClassVar[float] = 2e-6

    @classmethod
    def cases(cls) -> tuple["Distribution", ...]:
        """Instances that every law is proven for, from ordinary to extreme."""
        return (cls(),)

    @property
    def maps(self) -> Maps:
        """The `wp.func`s to use in kernels of your own."""
        raise NotImplementedError

    def sample(self, u: Any) -> Array:
        """Directions of points of the square.

        Args:
            u: (..., 2) float, in [0, 1).

        Returns:
            (..., 3) float32, unit length, local frame with +z the normal; NumPy for NumPy, wp.array for wp.array.

        Raises:
            TypeError: u is not floating-point.
            ValueError: its last axis is not 2, or a value is outside [0, 1).
        """
        if not isinstance(u, wp.array):
            u = _in_square(u)
        return self._map(self.maps.sample, u, 2, 3, "u")

    def pdf(self, w: Any) -> Array:
        """Density at unit directions, in the distribution's measure.

        Args:
            w: (..., 3) float, unit length, local frame.

        Returns:
            (...) float32, at least 0; 0 outside the support and where w is NaN.

        Raises:
            TypeError: w is not floating-point.
            ValueError: its last axis is not 3.
        """
        return self._map(self.maps.pdf, w, 3, 1, "w")

    def invert(self, w: Any) -> Array:
        """The points of the square that `sample` sends to the directions w.

        Args:
            w: (..., 3) float, unit length, local frame, in the support.

        Returns:
            (..., 2) float32 in [0, 1).

        Raises:
            TypeError: w is not floating-point.
            ValueError: its last axis is not 3.
        """
        return self._map(self.maps.invert, w, 3, 2, "w")

    def kernel_parameters(self) -> Parameters:
        """This instance's scalars as the kernels take them."""
        values = Parameters()
        for field, name in zip(("first",)[: len(self.parameters)], self.parameters, strict=True):
            setattr(values, field, getattr(self, name))
        return values

    def about(self) -> wp.Function:
        """The `wp.func` (unit normal, u, Parameters) -> (world direction, pdf)."""
        maps = self.maps
        if maps.about is not None:
            return maps.about
        scalars = len(self.parameters)
        return about_frame(with_parameters(maps.sample, wp.vec2, scalars), with_parameters(maps.pdf, wp.vec3, scalars))

    def _map(self, func: wp.Function, x: Any, width: int, out_width: int, argument: str) -> Array:
        source = as_vectors(x, width, argument)
        target = new_vectors(source, source.shape, out_width)
        bound = with_parameters(func, wp.vec2 if width == 2 else wp.vec3, len(self.parameters))
        block = FLAT_BLOCK if source.device.is_cpu else 1
        inputs = [source.count, block, source.address, target.address, self.kernel_parameters()]
        if source.count:
            kernel = elementwise(bound, width, out_width)
            run(kernel, -(-source.count // block), inputs, source.device, check_workers(None), source.count)
        return target.owner


def _in_square(u: Any) -> Any:
    """u, if its values are in [0, 1); float64 values that would round up to 1 become the float32 below it."""
    array = np.asarray(u)
    if array.dtype in (np.float32, np.float64) and array.size:
        if not (array.min() >= 0.0 and array.max() < 1.0):
            raise ValueError(f"u: got values from {array.min()} to {array.max()}, want [0, 1)")
        if array.dtype == np.float64:
            array = np.minimum(array.astype(np.float32), np.float32(1 - 2**-24))
    return array
