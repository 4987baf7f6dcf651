"""The kernel of `horizons`: a task for each point, which looks for the horizons of a chunk of azimuths at a time."""

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import set_byte, set_float, set_int
from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.sequences.fibonacci import fibonacci_sample
from warpsample.sequences.hashing import ONE_WORD, one_of, point_key, stream_key
from warpsample.tracing.placement import Placement, id_of
from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, Accelerator, set_direction
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.packets import NO_RAYS, first_rays, ray_set
from warpsample.tracing.sight.point import ShadingPoint, orient_point, place_point, point_in, workspace_floats
from warpsample.tracing.sight.rays import move_rays_near, prepare_rays, rays_blocked, whole_vectors

_LOW, _HIGH, _SINE, _ANYWHERE, _EAST, _NORTH = (wp.constant(wp.int32(row * CHUNK)) for row in range(6))
_OWN = 6 * CHUNK
_FLOATS = workspace_floats(_OWN, packets=True)
_LEAST = wp.constant(wp.float64(1e-30))
_TURN = wp.constant(wp.float32(2.0 * np.pi))
_prepare, _blocked = prepare_rays(), rays_blocked()


@wp.struct
class HorizonRows:
    """Scalars and addresses of the points on a field of heights, and where their numbers go.

    placement: of the points, which have ids. normals: (P, 3) float32.
    azimuths: of each of the two lattices. per_azimuth: rays of an azimuth. cosine: whether the sky counts by the cosine
    about the normal, else by its solid angle. skip: whether rays start around the point.
    value, standard_error, rays, status: (P,) float32, float32, int32, uint8, as `Seen` has them.
    """

    placement: Placement
    seed: wp.uint64
    normals: wp.uint64
    azimuths: wp.int32
    per_azimuth: wp.int32
    cosine: wp.int32
    skip: wp.int32
    value: wp.uint64
    standard_error: wp.uint64
    rays: wp.uint64
    status: wp.uint64


HorizonRowsArgs = type(HorizonRows().__ctype__())


@wp.func
def _plane_of(along: wp.float32, up: wp.float32) -> wp.float32:
    """The sine of the height at which the receiver's own plane is, or 0 where that is below the horizon.

    along, up: the normal's components, to the azimuth and upwards.
    """
    return wp.max(-along / wp.sqrt(along * along + up * up), 0.0)


@wp.func
def _seen_above(sine: wp.float64, along: wp.float64, up: wp.float64, cosine: wp.int32) -> wp.float64:
    """What is seen of an azimuth's sky above a horizon, of which the mean over all azimuths is the value."""
    if cosine == 0:
        return ONE - sine
    seen = up * (ONE - sine * sine)
    if along != ZERO:
        seen += along * (wp.acos(sine) - sine * wp.sqrt(ONE - sine * sine))
    return seen


@wp.func
def _density(sine: wp.float64, along: wp.float64, up: wp.float64) -> wp.float64:
    """How dense in the sine is what `_seen_above` a horizon is, by the cosine."""
    return wp.max(TWO * (up * sine + along * wp.sqrt(wp.max(ONE - sine * sine, ZERO))), ZERO)


@wp.func
def _as_dense(low: wp.float64, high: wp.float64, u: wp.float64, along: wp.float64, up: wp.float64) -> wp.float64:
    """A sine of an interval, as dense as what a tilted receiver sees: by a straight line, and two steps of Newton's."""
    start = _density(low, along, up)
    end = _density(high, along, up)
    whole = u * (start + end)
    share = whole / wp.max(start + wp.sqrt(start * start + (end - start) * whole), _LEAST)
    sine = low + wp.min(share, ONE) * (high - low)
    top = _seen_above(low, along, up, 1)
    wanted = top - u * (top - _seen_above(high, along, up, 1))
    for _ in range(2):
        step = (_seen_above(sine, along, up, 1) - wanted) / wp.max(_density(sine, along, up), _LEAST)
        sine = wp.min(wp.max(sine + step, low), high)
    return sine


@wp.func
def _turn(rows: HorizonRows, point: ShadingPoint, at: wp.int32, length: wp.int32):
    """Writes azimuths, both lattices one after the other, from the at-th on; horizons are above the receiver's own plane."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    key = stream_key(point.key, wp.uint32(0))
    other = stream_key(point.key, ONE_WORD)
    n = point.n
    tilt = wp.where(rows.cosine == 0, 0.0, 1.0)
    k = wp.int32(0)
    while k < length:
        i = at + k
        second = wp.where(i >= rows.azimuths, 1, 0)
        u = fibonacci_sample(one_of(key, other, second), wp.uint32(i - second * rows.azimuths), wp.uint32(rows.azimuths))
        east = wp.cos(_TURN * u[0])
        north = wp.sin(_TURN * u[0])
        own[_LOW + k] = tilt * _plane_of(n[0] * east + n[1] * north, n[2])
        own[_HIGH + k] = 1.0
        own[_ANYWHERE + k] = u[1]
        own[_EAST + k] = east
        own[_NORTH + k] = north
        k += 1


@wp.func
def _choose_tilted(point: ShadingPoint, length: wp.int32):
    """Writes where in their intervals the last rays of a tilted receiver go."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    up = wp.float64(point.n[2])
    for k in range(length):
        along = wp.float64(point.n[0] * own[_EAST + k] + point.n[1] * own[_NORTH + k])
        u = wp.float64(own[_ANYWHERE + k])
        own[_SINE + k] = wp.float32(_as_dense(wp.float64(own[_LOW + k]), wp.float64(own[_HIGH + k]), u, along, up))


@wp.func
def _aim(rows: HorizonRows, point: ShadingPoint, length: wp.int32, last: wp.bool, tilted: wp.bool):
    """Writes the directions of rays, to the middles of the intervals; the last ones as dense in them as what is seen."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    chunk = point.chunk
    even = rows.cosine == 0
    if last and tilted:
        _choose_tilted(point, length)
    k = wp.int32(0)
    while k < length:
        low = own[_LOW + k]
        high = own[_HIGH + k]
        u = own[_ANYWHERE + k]
        by_sine = low + u * (high - low)
        by_square = wp.sqrt(low * low + u * (high * high - low * low))
        anywhere = wp.where(tilted, own[_SINE + k], wp.where(even, by_sine, by_square))
        sine = wp.where(last, anywhere, 0.5 * (low + high))
        own[_SINE + k] = sine
        level = wp.sqrt(1.0 - sine * sine)
        set_direction(chunk, k, wp.vec3(level * own[_EAST + k], level * own[_NORTH + k], sine))
        k += 1


@wp.func
def _narrow(point: ShadingPoint, length: wp.int32, blocked: wp.uint64):
    """Halves the intervals."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    for k in range(length):
        if (blocked & ray_set(k)) != NO_RAYS:
            own[_LOW + k] = own[_SINE + k]
        else:
            own[_HIGH + k] = own[_SINE + k]


@wp.func
def _sum(rows: HorizonRows, point: ShadingPoint, at: wp.int32, length: wp.int32, blocked: wp.uint64) -> wp.vec2d:
    """What is seen of the azimuths of a chunk, by the last rays: of the first lattice, and of the second."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    total = wp.vec2d(ZERO, ZERO)
    for k in range(length):
        along = wp.float64(point.n[0] * own[_EAST + k] + point.n[1] * own[_NORTH + k])
        horizon = own[_HIGH + k]
        if (blocked & ray_set(k)) == NO_RAYS:
            horizon = own[_LOW + k]
        seen = _seen_above(wp.float64(horizon), along, wp.float64(point.n[2]), rows.cosine)
        total[wp.where(at + k < rows.azimuths, 0, 1)] += seen
    return total


@wp.func
def _look_around(rows: HorizonRows, tree: Accelerator, point: ShadingPoint, local: wp.int32, at: wp.int32) -> wp.vec2d:
    """`_sum` of a chunk of azimuths, after all their rays."""
    length = wp.min(CHUNK, 2 * rows.azimuths - at)
    tilted = rows.cosine != 0 and (point.n[0] != 0.0 or point.n[1] != 0.0)
    anything = tree.starts != 0 or local != 0
    _turn(rows, point, at, whole_vectors(length))
    blocked = NO_RAYS
    for ray in range(rows.per_azimuth):
        _aim(rows, point, whole_vectors(length), ray == rows.per_azimuth - 1, tilted)
        if anything:
            move_rays_near(point, length)
            _prepare(tree, point, local, length)
            blocked = _blocked(tree, point, local, first_rays(length), length)
        if ray < rows.per_azimuth - 1:
            _narrow(point, length, blocked)
    return _sum(rows, point, at, length, blocked)


@once
def horizon_kernel() -> wp.Kernel:
    """A kernel with a task for each point, in the order of the placement."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def see_sky(rows: HorizonRows, tree: Accelerator, first_task: wp.int64):
        memory = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
        visit = first_task + wp.int64(wp.tid())
        point = orient_point(point_in(memory.ptr, _OWN, CHUNK_FLOATS), rows.placement, rows.normals, wp.uint64(0), visit)
        point = place_point(point, rows.placement, 1)
        point.key = point_key(rows.seed, id_of(rows.placement, wp.uint64(0), point.index))
        total = wp.vec2d(ZERO, ZERO)
        cast = wp.int32(0)
        if point.status == 0:
            seen = tree
            local = wp.int32(0)
            if rows.skip != 0:
                seen, local, _opened = open_around(tree, point)
            cast = wp.where(seen.starts == 0 and local == 0, 0, 2 * rows.azimuths * rows.per_azimuth)
            for at in range(0, 2 * rows.azimuths, CHUNK):
                total += _look_around(rows, seen, point, local, at)
        scale = HALF / wp.float64(rows.azimuths)
        set_float(rows.value, point.index, wp.float32(scale * (total[0] + total[1])))
        set_float(rows.standard_error, point.index, wp.float32(scale * wp.abs(total[0] - total[1])))
        set_int(rows.rays, point.index, cast)
        set_byte(rows.status, point.index, point.status)

    return see_sky
