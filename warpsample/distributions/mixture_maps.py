"""Functions of a mixture for kernels: the choice of a lobe, its draw, and the density of all lobes."""

import warp as wp

from warpsample.distributions.maps import Maps
from warpsample.distributions.parameters import Parameters, number_at
from warpsample.host.locks import once
from warpsample.maths.frames import frame_about, to_local, to_world
from warpsample.maths.numerics import uniform_from_double


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
def build_sum(parts: tuple[Maps, ...], first: int, in_world: tuple[bool, ...]) -> wp.Function:
    """Build the wp.func (local w, world w, index, drawn, Parameters) that returns the density of a mixture at a direction w.

    `drawn` replaces the density of the part of the index, if it is at least 0. `in_world` states which parts read the world
    direction.
    """
    density, last, place, of_world = parts[-1].pdf, len(parts) - 1, len(parts) - 1.0, in_world[len(parts) - 1]

    @wp.func
    def part(local: wp.vec3, world: wp.vec3, index: wp.float32, drawn: wp.float32, parameters: Parameters):
        """Return the share of the last part."""
        w = local
        if wp.static(of_world):
            w = world
        known = wp.where(index == place, drawn, -1.0)
        return number_at(parameters, first + last) * wp.where(known >= 0.0, known, density(w, parameters))

    if last == 0:
        return part
    before = build_sum(parts[:-1], first, in_world)

    @wp.func
    def total(local: wp.vec3, world: wp.vec3, index: wp.float32, drawn: wp.float32, parameters: Parameters):
        """Return the sum of the shares of all parts."""
        return before(local, world, index, drawn, parameters) + part(local, world, index, drawn, parameters)

    return total


@once
def build_chosen_drawer(parts: tuple[Maps, ...], first: int) -> wp.Function:
    """Build the wp.func (u, Parameters) that chooses a part by u[0] and draws from it; it returns (w, density) and index."""
    choose, draw_part = build_chooser(len(parts), first), build_drawer(parts)

    @wp.func
    def draw_chosen(u: wp.vec2, parameters: Parameters):
        """Stretch the part's interval of u[0] to the unit interval, and draw from the part."""
        c = choose(u[0], parameters)
        x = uniform_from_double((wp.float64(u[0]) - wp.float64(c[0])) / wp.float64(c[1]))
        return draw_part(wp.vec2(x, u[1]), c[2], parameters), c[2]

    return draw_chosen


@once
def mixture_about(parts: tuple[Maps, ...], first: int, in_world: tuple[bool, ...], tangents: bool) -> wp.Function:
    """Build the wp.func (unit normal or frame, u, Parameters) of a mixture with parts in world coordinates."""
    draw_chosen, total = build_chosen_drawer(parts, first), build_sum(parts, first, in_world)
    mask = sum(1 << i for i, of_world in enumerate(in_world) if of_world)

    @wp.func
    def about_frame(frame: wp.mat33, u: wp.vec2, parameters: Parameters):
        """Sample a direction of a part that is chosen by u[0]; return the world direction and the density of all parts."""
        d, index = draw_chosen(u, parameters)
        drawn = wp.vec3(d[0], d[1], d[2])
        of_world = ((mask >> wp.int32(index)) & 1) != 0
        world, local = to_world(frame, drawn), to_local(frame, drawn)
        for i in range(3):
            world[i] = wp.where(of_world, drawn[i], world[i])
            local[i] = wp.where(of_world, local[i], drawn[i])
        return wp.vec4(world[0], world[1], world[2], total(local, world, index, d[3], parameters))

    if tangents:
        return about_frame

    @wp.func
    def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):
        """Sample in the frame about a unit normal."""
        return about_frame(frame_about(n), u, parameters)

    return about


@once
def mixture_maps(parts: tuple[Maps, ...], first: int, in_world: tuple[bool, ...]) -> Maps:
    """Build map and density of a mixture about +z from the functions of the lobes; weights begin at parameter `first`."""
    draw_chosen, total = build_chosen_drawer(parts, first), build_sum(parts, first, in_world)

    @wp.func
    def draw(u: wp.vec2, parameters: Parameters):
        """Return a direction of a part that is chosen by u[0], and the density of all parts."""
        d, index = draw_chosen(u, parameters)
        w = wp.vec3(d[0], d[1], d[2])
        return wp.vec4(d[0], d[1], d[2], total(w, w, index, d[3], parameters))

    @wp.func
    def sample(u: wp.vec2, parameters: Parameters):
        """Return the direction of `draw`."""
        d, _index = draw_chosen(u, parameters)
        return wp.vec3(d[0], d[1], d[2])

    @wp.func
    def pdf(w: wp.vec3, parameters: Parameters):
        """Return the weighted sum of the densities of all parts."""
        return total(w, w, -1.0, -1.0, parameters)

    return Maps(sample, pdf, draw=draw)
