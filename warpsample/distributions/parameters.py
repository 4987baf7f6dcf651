"""The functions of a distribution in the form that kernels call: parameters in a struct, and its map about a normal."""

from functools import lru_cache
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about, to_world


@wp.struct
class Parameters:
    """The parameters of a distribution, a scalar and a vector, as a kernel argument: a new value compiles nothing.

    The vector is kept by components: a vector in a struct is copied as a whole, and the loop is then not vectorised.
    """

    scalar: wp.float32
    x: wp.float32
    y: wp.float32
    z: wp.float32


@lru_cache(maxsize=256)
def pack_parameters(values: tuple[Any, ...]) -> Any:
    """A scalar, or a scalar and a vector, as kernels take them; zeros where there are none."""
    parameters = Parameters()
    for field, value in zip(("scalar", "x", "y", "z"), np.hstack(values or (0.0,)), strict=False):
        setattr(parameters, field, value)
    return parameters


@once
def bind_parameters(func: wp.Function, argument: type, count: int) -> wp.Function:
    """`func(x)`, `func(x, scalar)` or `func(x, scalar, vector)`, by `count`, as a wp.func of (x: argument, Parameters)."""
    if count == 0:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Calls a function that takes no parameters."""
            return func(x)

    elif count == 1:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """With the scalar."""
            return func(x, parameters.scalar)

    else:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """With the scalar and the vector."""
            return func(x, parameters.scalar, wp.vec3(parameters.x, parameters.y, parameters.z))

    return call


@once
def build_about(sample: wp.Function, pdf: wp.Function) -> wp.Function:
    """A local map (u, Parameters) and its density as a map about a unit normal, (n, u, Parameters) -> (direction, pdf)."""

    @wp.func
    def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):
        """By a tangent frame."""
        w = sample(u, parameters)
        d = to_world(frame_about(n), w)
        return wp.vec4(d[0], d[1], d[2], pdf(w, parameters))

    return about
