"""A distribution's functions in the one form that kernels call: its scalars in a struct, its map about a normal."""

from functools import cache

import warp as wp

from warpsample.frames import frame_about, to_world


@wp.struct
class Parameters:
    """The scalars of a distribution, so that a new value compiles nothing."""

    first: wp.float32


@cache
def with_parameters(func: wp.Function, argument: type, count: int) -> wp.Function:
    """`func(x)` or `func(x, first)`, by the number of its parameters, as a wp.func of (x: argument, Parameters)."""
    if count == 0:

        @wp.func
        def call(x: argument, parameters: Parameters):
            return func(x)

    else:

        @wp.func
        def call(x: argument, parameters: Parameters):
            return func(x, parameters.first)

    return call


@cache
def about_frame(sample: wp.Function, pdf: wp.Function) -> wp.Function:
    """A local map (u, Parameters) and its density as a map about a unit normal, (n, u, Parameters) -> (direction, pdf)."""

    @wp.func
    def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):
        w = sample(u, parameters)
        d = to_world(frame_about(n), w)
        return wp.vec4(d[0], d[1], d[2], pdf(w, parameters))

    return about
