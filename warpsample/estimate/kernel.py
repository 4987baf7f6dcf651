"""Numbers for each point in one kernel: cells are found empty or not, rays made, traced and summed; none is stored."""

import warp as wp

from warpsample.directions.samples import normal_status, weigh_by_mask
from warpsample.estimate.free import BLOCK, free_lobe
from warpsample.estimate.lobe import NOTHING, counted_lobe, weighed_lobe
from warpsample.estimate.rays import SQUARE_FLOATS
from warpsample.estimate.skipping.frontier import HORIZON_MARGIN
from warpsample.estimate.slots import Slots
from warpsample.estimate.spot import NONFINITE_POSITION, NONFINITE_VALUE, Lobes, Spot, start
from warpsample.host.locks import once
from warpsample.maths.memory import set_byte, set_int, vec3_at
from warpsample.maths.numerics import ZERO, scaled_to_unit
from warpsample.sequences.hashing import point_key
from warpsample.tracing.placement import lift, local_origin, point_of, reach_along
from warpsample.tracing.wide.layout import BEAM_FLOATS, CHUNK_FLOATS, PREPARED, SCRATCH, START_FLOATS, Accelerator

_NONFINITE_POSITION = wp.constant(wp.int32(NONFINITE_POSITION))
_NONFINITE_VALUE = wp.constant(wp.int32(NONFINITE_VALUE))
_ANYTHING = wp.constant(wp.float32(2.0**60))  # nothing is so low below a horizon


@once
def _keep(channels: int) -> wp.Function:
    """A function that stores the numbers of a point."""

    @wp.func
    def keep(lobes: Lobes, point: wp.int64, total: wp.vec3d, variance: wp.vec3d, width: wp.vec3d, degrees: wp.vec3d):
        """Stores means over the rays, from sums over them."""
        rays = wp.float64(2 * lobes.each * lobes.bands * lobes.sectors)
        at = wp.uint64(point) * wp.uint64(4 * channels)
        value = wp.array(ptr=lobes.value + at, shape=(channels,), dtype=wp.float32)
        error = wp.array(ptr=lobes.error + at, shape=(channels,), dtype=wp.float32)
        spreads = wp.array(ptr=lobes.spread + at, shape=(channels,), dtype=wp.float32)
        freedom = wp.array(ptr=lobes.degrees + at, shape=(channels,), dtype=wp.float32)
        for c in range(channels):
            value[c] = wp.float32(total[c] / rays)
            error[c] = wp.float32(wp.sqrt(variance[c]) / rays)
            spreads[c] = wp.float32(wp.sqrt(width[c]) / rays)
            freedom[c] = wp.float32(degrees[c])

    return keep


@once
def _placer(slots: Slots) -> wp.Function:
    """A function that places a point and its rays; nothing to do where there is no mesh."""
    wide, upward, traced = slots.wide, slots.upward, slots.query is not None

    @wp.func
    def place(lobes: Lobes, point: wp.int64, spot: Spot) -> Spot:
        if wp.static(traced):
            spot.place = local_origin(lobes.placement, point)
            if wp.static(wide):
                spot.o = vec3_at(lobes.placement.starts, point)
            else:
                side = vec3_at(lobes.placement.normals, point)
                spot.o = wp.vec3(spot.place) + wp.copysign(lift(lobes.placement, side), wp.dot(side, spot.n)) * side
            spot.low = _ANYTHING
            if wp.static(upward):
                spot.low = HORIZON_MARGIN * reach_along(lobes.placement, spot.n, spot.o)
            spot.reach = wp.float32(lobes.placement.reach)
            start(spot.chunk, spot.o, spot.reach)
        return spot

    return place


@once
def _estimator(slots: Slots) -> wp.Function:
    """A function that estimates one point."""
    struct, keep, place = slots.struct, _keep(slots.channels), _placer(slots)
    sum_lobe = free_lobe(slots) if slots.query is None else (counted_lobe if slots.counts else weighed_lobe)(slots)

    @wp.func
    def estimate_point(lobes: Lobes, accelerator: Accelerator, data: struct, visit: wp.int64, spot: Spot):
        """The numbers of the point that is visited so many points after the first; `spot` has the memory to work in."""
        point = point_of(lobes.placement, visit)
        normal = vec3_at(lobes.normals, point)
        unit = scaled_to_unit(normal)
        spot.n = wp.vec3(unit[0], unit[1], unit[2])
        spot.lobe.normal = spot.n
        spot.lobe.row = lobes.first_row + wp.int32(point)
        spot.lobe.point = lobes.first_point + wp.uint64(point)
        spot.key = point_key(lobes.seed, spot.lobe.point)
        weight = wp.float32(1.0)
        if lobes.active != wp.uint64(0):
            weight = weigh_by_mask(wp.array(ptr=lobes.active + wp.uint64(point), shape=(1,), dtype=wp.uint8), 0)
        status = normal_status(normal, weight)
        spot = place(lobes, point, spot)
        if status == 0 and wp.dot(spot.place - spot.place, spot.place - spot.place) != ZERO:
            status = _NONFINITE_POSITION
        total = NOTHING
        variance = NOTHING
        width = NOTHING
        degrees = NOTHING
        cast = wp.int32(0)
        empty = wp.int32(0)
        if status == 0:
            total, variance, width, degrees, cast, empty = sum_lobe(lobes, accelerator, data, spot)
            if wp.dot(total - total, total - total) != ZERO:
                status = _NONFINITE_VALUE
                total = NOTHING
                variance = NOTHING
                width = NOTHING
                degrees = NOTHING
        keep(lobes, point, total, variance, width, degrees)
        at = wp.uint64(point) * wp.uint64(4)
        set_int(lobes.cast + at, 0, cast)
        set_int(lobes.empty + at, 0, empty)
        set_byte(lobes.status, point, status)

    return estimate_point


@once
def estimate_kernel(slots: Slots) -> wp.Kernel:
    """A kernel with a task for each `rows` points in the order of the placement, which share cleared memory."""
    struct, estimate_point, traced = slots.struct, _estimator(slots), slots.query is not None
    words_size, beam_size, room_size = (SCRATCH, BEAM_FLOATS, START_FLOATS) if traced and slots.wide else (1, 1, 1)
    chunk_floats = (CHUNK_FLOATS if slots.wide else PREPARED) if traced else slots.channels * BLOCK
    square_floats = SQUARE_FLOATS if traced else 2 * BLOCK

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def estimate(lobes: Lobes, accelerator: Accelerator, data: struct, first_task: wp.int64):
        words = wp.zeros(shape=(words_size,), dtype=wp.int32)
        floats = wp.zeros(shape=(chunk_floats,), dtype=wp.float32)
        square = wp.zeros(shape=(square_floats,), dtype=wp.float32)
        beam = wp.zeros(shape=(beam_size,), dtype=wp.float32)
        room = wp.zeros(shape=(room_size,), dtype=wp.float32)
        spot = Spot()
        spot.chunk = floats.ptr
        spot.square = square.ptr
        spot.room = room.ptr
        spot.beam = beam.ptr
        spot.scratch = words.ptr
        first = (first_task + wp.int64(wp.tid())) * wp.int64(lobes.rows)
        for k in range(lobes.rows):
            if first + wp.int64(k) < lobes.visits:
                estimate_point(lobes, accelerator, data, first + wp.int64(k), spot)

    return estimate
