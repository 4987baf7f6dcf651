"""Warp kernel that computes the visible sky of raster cells: rays search for the height of the horizon by bisection.

An azimuth's interval is the range of sines of elevation that contains its horizon. "Seen fraction" is the part of an
azimuth's sky above an elevation, weighted as the quantity requires.
"""

import numpy as np
import warp as wp

from warpsample.city.rasters.horizon_errors import SEEN, Sums, add_azimuth, own_plane_error, seen_above, variance_of
from warpsample.host.locks import once
from warpsample.maths.memory import float_at, set_byte, set_float, set_int
from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.sequences.fibonacci import fibonacci_sample
from warpsample.sequences.hashing import point_key, stream_key
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
    """Kernel argument of the horizon search: numbers, and addresses of the points' arrays and of the results.

    placement: points, with ids. normals: (P, 3) float32. azimuths: number per point. per_azimuth: rays per azimuth.
    cosine: 1 for weights by the cosine to the normal, 0 for weights by solid angle. skip: 1 to start rays outside empty
    space.
    depths: (P, 2) float32, from `bound_depths`.
    value, standard_error, rays, status: (P,) float32, float32, int32, uint8, as in `Seen`.
    """

    placement: Placement
    seed: wp.uint64
    normals: wp.uint64
    azimuths: wp.int32
    per_azimuth: wp.int32
    cosine: wp.int32
    skip: wp.int32
    depths: wp.uint64
    value: wp.uint64
    standard_error: wp.uint64
    rays: wp.uint64
    status: wp.uint64


HorizonRowsArgs = type(HorizonRows().__ctype__())


@wp.func
def _plane_of(along: wp.float32, up: wp.float32) -> wp.float32:
    """Return the sine of the elevation, at least 0, at which a tilted receiver's own plane hides the sky in an azimuth.

    along, up: components of the normal along the azimuth and upwards.
    """
    return wp.max(-along / wp.sqrt(along * along + up * up), 0.0)


@wp.func
def _density(sine: wp.float64, along: wp.float64, up: wp.float64) -> wp.float64:
    """Return how fast the visible fraction of an azimuth's sky decreases with the sine of the horizon, at least 0.

    It is minus the derivative of `seen_above`.
    """
    return wp.max(TWO * (up * sine + along * wp.sqrt(wp.max(ONE - sine * sine, ZERO))), ZERO)


@wp.func
def _as_dense(low: wp.float64, high: wp.float64, u: wp.float64, along: wp.float64, up: wp.float64) -> wp.float64:
    """Sample a sine of elevation between `low` and `high` from u in [0, 1], with a probability density like `_density`.

    Start from the solution for a linear density, then do two steps of Newton's method.
    """
    start = _density(low, along, up)
    end = _density(high, along, up)
    whole = u * (start + end)
    share = whole / wp.max(start + wp.sqrt(start * start + (end - start) * whole), _LEAST)
    sine = low + wp.min(share, ONE) * (high - low)
    top = seen_above(low, along, up, 1)
    wanted = top - u * (top - seen_above(high, along, up, 1))
    for _ in range(2):
        step = (seen_above(sine, along, up, 1) - wanted) / wp.max(_density(sine, along, up), _LEAST)
        sine = wp.min(wp.max(sine + step, low), high)
    return sine


@wp.func
def _turn(rows: HorizonRows, point: ShadingPoint, at: wp.int32, length: wp.int32):
    """Start the horizon search in `length` azimuths: the horizon is between the receiver's own plane and the zenith."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    key = stream_key(point.key, wp.uint32(0))
    n = point.n
    tilt = wp.where(rows.cosine == 0, 0.0, 1.0)
    k = wp.int32(0)
    while k < length:
        u = fibonacci_sample(key, wp.uint32(at + k), wp.uint32(rows.azimuths))
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
    """Sample the elevations of the last rays of a tilted receiver, within the intervals that contain the horizons."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    up = wp.float64(point.n[2])
    for k in range(length):
        along = wp.float64(point.n[0] * own[_EAST + k] + point.n[1] * own[_NORTH + k])
        u = wp.float64(own[_ANYWHERE + k])
        own[_SINE + k] = wp.float32(_as_dense(wp.float64(own[_LOW + k]), wp.float64(own[_HIGH + k]), u, along, up))


@wp.func
def _aim(rows: HorizonRows, point: ShadingPoint, length: wp.int32, last: wp.bool, tilted: wp.bool):
    """Aim each azimuth's ray at the middle of the interval with the horizon, or with `last` at a random height in it."""
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
    """Halve the interval that contains the horizon in each azimuth: keep the part above a blocked, below a free ray."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    for k in range(length):
        if (blocked & ray_set(k)) != NO_RAYS:
            own[_LOW + k] = own[_SINE + k]
        else:
            own[_HIGH + k] = own[_SINE + k]


@wp.func
def _add_chunk(rows: HorizonRows, point: ShadingPoint, sums: Sums, length: wp.int32, blocked: wp.uint64) -> Sums:
    """Return the sums for value and variance with `length` more azimuths, after all their rays."""
    own = wp.array(ptr=point.own, shape=(_OWN,), dtype=wp.float32)
    for k in range(length):
        along = wp.float64(point.n[0] * own[_EAST + k] + point.n[1] * own[_NORTH + k])
        free = (blocked & ray_set(k)) == NO_RAYS
        low = wp.float64(own[_LOW + k])
        high = wp.float64(own[_HIGH + k])
        up = wp.float64(point.n[2])
        sums = add_azimuth(sums, wp.float64(rows.azimuths), low, high, free, along, up, rows.cosine)
    return sums


@wp.func
def _look_around(
    rows: HorizonRows, tree: Accelerator, point: ShadingPoint, local: wp.int32, at: wp.int32, sums: Sums
) -> Sums:
    """Search for the horizon in several azimuths, starting with number `at`, and add the results to the sums."""
    length = wp.min(CHUNK, rows.azimuths - at)
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
    return _add_chunk(rows, point, sums, length, blocked)


@once
def horizon_kernel() -> wp.Kernel:
    """Build the kernel that computes the visible sky fraction of each point and its standard error."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def see_sky(rows: HorizonRows, tree: Accelerator, first_task: wp.int64):
        memory = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
        visit = first_task + wp.int64(wp.tid())
        point = orient_point(point_in(memory.ptr, _OWN, CHUNK_FLOATS), rows.placement, rows.normals, wp.uint64(0), visit)
        point = place_point(point, rows.placement, 1)
        point.key = point_key(rows.seed, id_of(rows.placement, wp.uint64(0), point.index))
        sums = Sums()
        variance = ZERO
        cast = wp.int32(0)
        azimuths = wp.float64(rows.azimuths)
        if point.status == 0:
            near, around, _opened = open_around(tree, point)  # also without skip: the error depends on whether it is empty
            seen = tree
            local = wp.int32(0)
            if rows.skip != 0:
                seen = near
                local = around
            for at in range(0, rows.azimuths, CHUNK):
                sums = _look_around(rows, seen, point, local, at, sums)
            cast = wp.where(seen.starts != 0 or local != 0, rows.azimuths * rows.per_azimuth, 0)
            if near.starts != 0 or around != 0:
                whole = wp.where(rows.cosine != 0, HALF + HALF * wp.float64(point.n[2]), ONE)
                depth = wp.float64(float_at(rows.depths, wp.int64(2) * point.index))
                together = wp.float64(float_at(rows.depths, wp.int64(2) * point.index + wp.int64(1)))
                variance = variance_of(sums, azimuths, whole, depth, together)
            if rows.cosine != 0:
                own = own_plane_error(point.n, azimuths)
                variance += own * own
        set_float(rows.value, point.index, wp.float32(wp.max(sums[SEEN], ZERO) / azimuths))  # rounding of tiny sums
        error = wp.min(wp.sqrt(variance), HALF)  # no value between 0 and 1 has a larger standard deviation
        set_float(rows.standard_error, point.index, wp.float32(error))
        set_int(rows.rays, point.index, cast)
        set_byte(rows.status, point.index, point.status)

    return see_sky
