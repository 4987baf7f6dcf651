"""Adaptation of a distribution's functions to kernels, which pass all parameters as one struct."""

from functools import lru_cache
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about, to_world

_FIELDS = ("scalar", "x", "y", "z", *(f"p{i}" for i in range(4, 20)))


def _make_struct() -> Any:
    """Create the Warp struct `Parameters`, which holds the numbers of all parameters of a distribution."""
    fields = {"__annotations__": dict.fromkeys(_FIELDS, wp.float32), "__module__": __name__}
    return wp.struct(type("Parameters", (), fields | {"__doc__": _DOCUMENTATION}))


_DOCUMENTATION = """Parameters of a distribution as a kernel argument, 20 float32 numbers: new values compile nothing.

The numbers are those of all parameters, one after another. The first four are called `scalar`, `x`, `y` and `z`, after
the most frequent parameters, a scalar and a vector; the others `p4` to `p19`. They are scalars because Warp copies a vector
in a struct as a whole, which prevents vectorisation.
"""

Parameters: Any = _make_struct()

MOST_NUMBERS = len(_FIELDS)
"""Largest number of float32 numbers of all parameters of a distribution, with those of nested lobes."""

SIZES: dict[Any, int] = {wp.float32: 1, float: 1, wp.vec3: 3, wp.mat33: 9, wp.uint64: 3}
"""Number of float32 numbers of a parameter, by its type in the signature of a `wp.func`; an address takes three numbers."""

_ADDRESS_BITS = 22  # of each of the three numbers of an address: float32 holds whole numbers of 24 bits
_SHIFT = wp.constant(wp.uint64(_ADDRESS_BITS))


def split_address(address: int) -> tuple[float, float, float]:
    """Return the three numbers as which `Parameters` holds an address in memory, the lowest bits first."""
    mask = (1 << _ADDRESS_BITS) - 1
    return float(address & mask), float(address >> _ADDRESS_BITS & mask), float(address >> 2 * _ADDRESS_BITS)


@wp.func_native(snippet="return (&parameters.scalar)[i];", adj_snippet="(&adj_parameters.scalar)[i] += adj_ret;")
def number_at(parameters: Parameters, i: wp.int32) -> wp.float32:
    """Return the i-th number of the parameters."""


@once
def number_setter(i: int) -> wp.Function:
    """Build the wp.func that returns a copy of the parameters with another i-th number."""

    @wp.func
    def set_number(p: Parameters, value: wp.float32):
        """Return a copy of the parameters p with `value` as the i-th number."""
        q = p
        if wp.static(i == 0):
            q.scalar = value
        if wp.static(i == 1):
            q.x = value
        if wp.static(i == 2):
            q.y = value
        if wp.static(i == 3):
            q.z = value
        if wp.static(i == 4):
            q.p4 = value
        if wp.static(i == 5):
            q.p5 = value
        if wp.static(i == 6):
            q.p6 = value
        if wp.static(i == 7):
            q.p7 = value
        if wp.static(i == 8):
            q.p8 = value
        if wp.static(i == 9):
            q.p9 = value
        if wp.static(i == 10):
            q.p10 = value
        if wp.static(i == 11):
            q.p11 = value
        if wp.static(i == 12):
            q.p12 = value
        if wp.static(i == 13):
            q.p13 = value
        if wp.static(i == 14):
            q.p14 = value
        if wp.static(i == 15):
            q.p15 = value
        if wp.static(i == 16):
            q.p16 = value
        if wp.static(i == 17):
            q.p17 = value
        if wp.static(i == 18):
            q.p18 = value
        if wp.static(i == 19):
            q.p19 = value
        return q

    return set_number


@lru_cache(maxsize=256)
def pack_parameters(values: tuple[Any, ...]) -> Any:
    """Return the struct `Parameters` that holds the given values, one after another."""
    parameters = Parameters()
    numbers = np.hstack([np.ravel(value) for value in values] or [0.0])
    for field, value in zip(_FIELDS, numbers, strict=False):
        setattr(parameters, field, value)
    return parameters


def parameter_types(func: wp.Function) -> list[Any]:
    """Return the types of a function's parameters, which follow its first argument."""
    return list(func.input_types.values())[1:]


@once
def read_parameter(kind: Any, i: int) -> wp.Function:
    """Build the wp.func that reads one parameter (number, vector, matrix or address) that starts at the i-th number."""
    if kind is wp.uint64:

        @wp.func
        def read(p: Parameters):
            """Return the parameter, a memory address, from three numbers; see `split_address`."""
            high = (wp.uint64(number_at(p, i + 2)) << _SHIFT) | wp.uint64(number_at(p, i + 1))
            return (high << _SHIFT) | wp.uint64(number_at(p, i))

    elif SIZES[kind] == 1:

        @wp.func
        def read(p: Parameters):
            """Return the parameter, a single number."""
            return number_at(p, i)

    elif SIZES[kind] == 3:

        @wp.func
        def read(p: Parameters):
            """Return the parameter, a vector of three numbers."""
            # The sums with 0 stop LLVM from joining the loads of two vectors, which would prevent vectorisation.
            return wp.vec3(number_at(p, i) + 0.0, number_at(p, i + 1) + 0.0, number_at(p, i + 2) + 0.0)

    else:

        @wp.func
        def read(p: Parameters):
            """Return the parameter, a 3 x 3 matrix stored row by row."""
            return wp.mat33(
                number_at(p, i), number_at(p, i + 1), number_at(p, i + 2),
                number_at(p, i + 3), number_at(p, i + 4), number_at(p, i + 5),
                number_at(p, i + 6), number_at(p, i + 7), number_at(p, i + 8),
            )  # fmt: skip

    return read


@once
def bind_parameters(func: wp.Function, argument: type, count: int, start: int = 0) -> wp.Function:
    """Build the wp.func (x, Parameters) that calls `func` with x and the parameters that `func` expects, at most four.

    The parameters are float32, vec3, mat33 or addresses (uint64), as in the signature of `func`. Their numbers begin with
    number `start` of the struct. A function that takes the struct `Parameters` already is returned unchanged.
    """
    types = parameter_types(func)[:count]
    if parameter_types(func) == [Parameters]:
        return func
    starts = np.cumsum([start, *(SIZES[kind] for kind in types)]).tolist()
    reads = [read_parameter(kind, first) for kind, first in zip(types, starts, strict=False)]
    first, second, third, fourth = (*reads, None, None, None, None)[:4]
    if count == 0:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Return func(x), for a function without parameters."""
            return func(x)

    elif count == 1:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Return the function's value at x, with its one parameter read from the struct."""
            return func(x, first(parameters))

    elif count == 2:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Return the function's value at x, with its two parameters read from the struct."""
            return func(x, first(parameters), second(parameters))

    elif count == 3:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Return the function's value at x, with its three parameters read from the struct."""
            return func(x, first(parameters), second(parameters), third(parameters))

    else:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Return the function's value at x, with its four parameters read from the struct."""
            return func(x, first(parameters), second(parameters), third(parameters), fourth(parameters))

    return call


@once
def build_about(sample: wp.Function, pdf: wp.Function) -> wp.Function:
    """Build the wp.func that samples a direction about a unit normal, from a map and a density for directions about +z."""

    @wp.func
    def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):
        """Sample a direction about the unit normal n; return the direction and its density as a vec4."""
        w = sample(u, parameters)
        d = to_world(frame_about(n), w)
        return wp.vec4(d[0], d[1], d[2], pdf(w, parameters))

    return about


@once
def build_about_frame(sample: wp.Function, pdf: wp.Function) -> wp.Function:
    """Build the wp.func that samples a direction in a tangent frame, from a map and a density for directions about +z."""

    @wp.func
    def about(frame: wp.mat33, u: wp.vec2, parameters: Parameters):
        """Sample a direction in a tangent frame; return the direction in world coordinates and its density as a vec4."""
        w = sample(u, parameters)
        d = to_world(frame, w)
        return wp.vec4(d[0], d[1], d[2], pdf(w, parameters))

    return about


@once
def build_about_drawn(draw: wp.Function, tangents: bool) -> wp.Function:
    """Build the wp.func of `build_about`, or with `tangents` of `build_about_frame`, from a function `Maps.draw`."""
    if tangents:

        @wp.func
        def about(frame: wp.mat33, u: wp.vec2, parameters: Parameters):
            """Draw a direction about +z with its density and rotate it by the frame."""
            drawn = draw(u, parameters)
            d = to_world(frame, wp.vec3(drawn[0], drawn[1], drawn[2]))
            return wp.vec4(d[0], d[1], d[2], drawn[3])

    else:

        @wp.func
        def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):
            """Draw a direction about +z with its density and rotate it to the normal."""
            drawn = draw(u, parameters)
            d = to_world(frame_about(n), wp.vec3(drawn[0], drawn[1], drawn[2]))
            return wp.vec4(d[0], d[1], d[2], drawn[3])

    return about


@once
def about_normal_of(about: wp.Function) -> wp.Function:
    """Build the wp.func (frame, u, Parameters) that samples about the frame's normal by `about` and ignores the tangent."""

    @wp.func
    def about_frame(frame: wp.mat33, u: wp.vec2, parameters: Parameters):
        """Sample a direction about the normal, the last column of the frame."""
        return about(wp.vec3(frame[0, 2], frame[1, 2], frame[2, 2]), u, parameters)

    return about_frame


def redraw_of(maps: Any, tangents: bool) -> wp.Function | None:
    """Return the wp.func that replaces imprecise directions, for normals or tangent frames; None if there are none."""
    return about_normal_of(maps.redraw) if tangents and maps.redraw is not None else maps.redraw
