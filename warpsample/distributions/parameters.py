"""Conversion of a distribution's functions to the signatures that kernels call, with all parameters in one struct."""

from functools import lru_cache
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about, to_world


@wp.struct
class Parameters:
    """Parameters of a distribution, a scalar and a vector (x, y, z), as a kernel argument: new values compile nothing.

    The vector is stored as three scalars because Warp copies a vector in a struct as a whole, which prevents vectorisation.
    """

    scalar: wp.float32
    x: wp.float32
    y: wp.float32
    z: wp.float32


@lru_cache(maxsize=256)
def pack_parameters(values: tuple[Any, ...]) -> Any:
    """Pack a scalar, or a scalar and a vector, into the struct `Parameters`; missing values become 0."""
    parameters = Parameters()
    for field, value in zip(("scalar", "x", "y", "z"), np.hstack(values or (0.0,)), strict=False):
        setattr(parameters, field, value)
    return parameters


@once
def bind_parameters(func: wp.Function, argument: type, count: int) -> wp.Function:
    """Build the wp.func (x: argument, Parameters) that calls `func` with its `count` parameters.

    `func` is called as func(x), func(x, scalar) or func(x, scalar, vector), for a count of 0, 1 or 2.
    """
    if count == 0:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Call the function without parameters."""
            return func(x)

    elif count == 1:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Call the function with the scalar."""
            return func(x, parameters.scalar)

    else:

        @wp.func
        def call(x: argument, parameters: Parameters):
            """Call the function with the scalar and the vector."""
            return func(x, parameters.scalar, wp.vec3(parameters.x, parameters.y, parameters.z))

    return call


@once
def build_about(sample: wp.Function, pdf: wp.Function) -> wp.Function:
    """Build the wp.func (unit normal n, u, Parameters) -> (world direction, pdf) from a map and a density about +z."""

    @wp.func
    def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):
        """Sample a direction about +z and rotate it to the normal."""
        w = sample(u, parameters)
        d = to_world(frame_about(n), w)
        return wp.vec4(d[0], d[1], d[2], pdf(w, parameters))

    return about
