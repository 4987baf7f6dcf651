"""One row of a sky matrix a task: its patches are looked into, and those of which nothing is known get the rays."""

import warp as wp

from warpsample.directions.samples import normal_status, weigh_by_mask
from warpsample.estimate.skipping.frontier import HORIZON_MARGIN, frontier
from warpsample.estimate.spot import NONFINITE_POSITION, Spot, start
from warpsample.host.locks import once
from warpsample.maths.memory import set_byte, set_int, vec3_at
from warpsample.maths.numerics import HALF, ONE, ZERO, scaled_to_unit
from warpsample.radiation.sky.form_factors import open_share, patch_at
from warpsample.radiation.sky.patch_rays import WEIGHTS, SkyRows, sum_rays
from warpsample.radiation.sky.shafts import CLOSED, OPEN, UNKNOWN, aim_at, look
from warpsample.sequences.hashing import point_key
from warpsample.tracing.placement import far_off, in_double, local_origin, point_of, reach_along
from warpsample.tracing.wide.layout import BEAM_FLOATS, CHUNK_FLOATS, SCRATCH, START_FLOATS, Accelerator

CONCENTRATION = 4.0
"""How many times as densely patches may be sampled as `count` rays would sample the lobe, where little of that is sky.

What is found of other patches must not matter: the same rays are cast wherever the tree's boxes are."""

_CONCENTRATION = wp.constant(wp.float64(CONCENTRATION))
_NONFINITE_POSITION = wp.constant(wp.int32(NONFINITE_POSITION))
_OPEN = wp.constant(wp.int32(OPEN))
_CLOSED = wp.constant(wp.int32(CLOSED))
_UNKNOWN = wp.constant(wp.int32(UNKNOWN))


@wp.func
def _in_frame(sky: SkyRows, n: wp.vec3) -> wp.vec3d:
    """A normal in the frame of the patches: east, north, up; unit in float64."""
    frame = wp.array(ptr=sky.frame, shape=(3,), dtype=wp.vec3d)
    v = in_double(n)
    return wp.normalize(wp.vec3d(wp.dot(frame[0], v), wp.dot(frame[1], v), wp.dot(frame[2], v)))


@wp.func
def _look_into(
    sky: SkyRows, accelerator: Accelerator, spot: Spot, n: wp.vec3d, near: wp.int32, search: wp.bool, row: wp.int64
):
    """Writes the open shares of all patches, and what is known of each in place of its error."""
    at = wp.uint64(row) * wp.uint64(sky.patches) * wp.uint64(4)
    value = wp.array(ptr=sky.value + at, shape=(sky.patches,), dtype=wp.float32)
    error = wp.array(ptr=sky.error + at, shape=(sky.patches,), dtype=wp.float32)
    begins = wp.array(ptr=sky.begins, shape=(sky.groups + 1,), dtype=wp.int32)
    filled = wp.uint64(0)
    of_all = wp.where(accelerator.starts == 0 and near == 0, _OPEN, _UNKNOWN)
    for group in range(sky.groups):
        most = wp.float32(0.0)
        for k in range(begins[group], begins[group + 1]):
            value[k] = wp.float32(open_share(n, patch_at(sky.table, k)))
            most = wp.max(most, value[k])
        of_group = of_all
        if search and most > 0.0 and of_all == _UNKNOWN and begins[group + 1] - begins[group] > 1:
            aim_at(sky.group_beams, group, spot)
            of_group, filled = look(accelerator, spot, near, filled)
        for k in range(begins[group], begins[group + 1]):
            known = wp.int32(0)
            if value[k] > 0.0:
                known = of_group
                if search and known == _UNKNOWN:
                    aim_at(sky.beams, k, spot)
                    known, filled = look(accelerator, spot, near, filled)
            error[k] = wp.float32(known)


@wp.func
def _fill_row(sky: SkyRows, accelerator: Accelerator, spot: Spot, row: wp.int64):
    """Writes a point's row; (rays cast, patches open, closed, below the horizon)."""
    starts = wp.int32(-1)
    near = wp.int32(0)
    if not far_off(spot.place):
        starts, around = frontier(accelerator, spot.o, spot.n, spot.low, spot.reach, spot.room, spot.scratch)
        near = (1 << around) - 1
    seen = accelerator
    if starts >= 0:
        seen.start = spot.room
        seen.starts = starts
    else:
        near = 0
    n = _in_frame(sky, spot.n)
    _look_into(sky, seen, spot, n, near, starts >= 0, row)
    if sky.skip == 0:
        seen = accelerator
        near = 0
    of_sky = HALF + HALF * n[2]
    density = HALF * wp.float64(sky.count) / wp.max(of_sky, ONE / _CONCENTRATION)
    at = wp.uint64(row) * wp.uint64(sky.patches) * wp.uint64(4)
    value = wp.array(ptr=sky.value + at, shape=(sky.patches,), dtype=wp.float32)
    error = wp.array(ptr=sky.error + at, shape=(sky.patches,), dtype=wp.float32)
    cast = wp.int32(0)
    open = wp.int32(0)
    closed = wp.int32(0)
    below = wp.int32(0)
    for k in range(sky.patches):
        known = wp.int32(error[k])
        share = wp.float64(value[k])
        part = wp.where(known == _CLOSED, ZERO, ONE)
        deviation = ZERO
        if known == 0:
            below += 1
        elif known == _UNKNOWN or sky.skip == 0:
            each = wp.max(1, wp.int32(density * share))
            part, deviation, rays = sum_rays(sky, seen, spot, near, n, k, patch_at(sky.table, k), each)
            cast += rays
        elif known == _OPEN:
            open += 1
        else:
            closed += 1
        value[k] = wp.float32(part * share)
        error[k] = wp.float32(deviation * share)
    return cast, open, closed, below


@once
def sky_kernel() -> wp.Kernel:
    """A kernel with a task for each point, in the order of the placement."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def fill_rows(sky: SkyRows, accelerator: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        floats = wp.zeros(shape=(CHUNK_FLOATS,), dtype=wp.float32)
        weights = wp.zeros(shape=(WEIGHTS,), dtype=wp.float32)
        beam = wp.zeros(shape=(BEAM_FLOATS,), dtype=wp.float32)
        room = wp.zeros(shape=(START_FLOATS,), dtype=wp.float32)
        task = first_task + wp.int64(wp.tid())
        point = point_of(sky.placement, task)
        normal = vec3_at(sky.normals, point)
        unit = scaled_to_unit(normal)
        spot = Spot()
        spot.n = wp.vec3(unit[0], unit[1], unit[2])
        spot.key = point_key(sky.seed, sky.first_point + wp.uint64(point))
        spot.chunk = floats.ptr
        spot.square = weights.ptr
        spot.room = room.ptr
        spot.beam = beam.ptr
        spot.scratch = words.ptr
        spot.place = local_origin(sky.placement, point)
        spot.o = vec3_at(sky.placement.starts, point)
        spot.low = HORIZON_MARGIN * reach_along(sky.placement, spot.n, spot.o)
        spot.reach = wp.float32(sky.placement.reach)
        start(spot.chunk, spot.o, spot.reach)
        weight = wp.float32(1.0)
        if sky.active != wp.uint64(0):
            weight = weigh_by_mask(wp.array(ptr=sky.active + wp.uint64(point), shape=(1,), dtype=wp.uint8), 0)
        status = normal_status(normal, weight)
        if status == 0 and wp.dot(spot.place - spot.place, spot.place - spot.place) != ZERO:
            status = _NONFINITE_POSITION
        cast = wp.int32(0)
        open = wp.int32(0)
        closed = wp.int32(0)
        below = wp.int32(0)
        if status == 0:
            cast, open, closed, below = _fill_row(sky, accelerator, spot, wp.where(sky.by_task != 0, task, point))
        at = wp.uint64(point) * wp.uint64(4)
        set_int(sky.cast + at, 0, cast)
        set_int(sky.open + at, 0, open)
        set_int(sky.closed + at, 0, closed)
        set_int(sky.below + at, 0, below)
        set_byte(sky.status, point, status)

    return fill_rows
