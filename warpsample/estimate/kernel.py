"""Numbers for each point in one kernel: cells are found empty or not, rays made, traced and summed; none is stored."""

import warp as wp

from warpsample.estimate.intervals import edge_variance, posterior, worth_of_prior
from warpsample.estimate.job import NONFINITE_POSITION, EstimateJob, Spot, bring_near, found_in, start
from warpsample.kernels.job import normal_status, weigh_by_mask
from warpsample.kernels.parameters import Parameters
from warpsample.kernels.variates import LANES
from warpsample.locks import once
from warpsample.numerics import high_word, low_word, scaled_to_unit
from warpsample.sequences.record import Sequence
from warpsample.tracing.frontier import HORIZON_MARGIN, NEAR, NEAR_EDGE, frontier
from warpsample.tracing.layout import (
    BEAM_FLOATS,
    CHUNK,
    CHUNK_FLOATS,
    DIRECTION,
    REACH,
    SCRATCH,
    START_FLOATS,
    Accelerator,
)
from warpsample.tracing.prepare import ray_in
from warpsample.tracing.rays import far_off, lift, local_origin, point_of, reach_along
from warpsample.tracing.wide import any_of, nearest_of

_NONFINITE_POSITION = wp.constant(wp.int32(NONFINITE_POSITION))
_STREAM_STEP = wp.constant(wp.uint32(0x9E3779B9))
_LAST_UNIFORM = wp.constant(wp.float32(1.0 - 2.0**-24))
_SQUARE = 2 * CHUNK
_NOTHING = wp.constant(wp.vec3d(0.0, 0.0, 0.0))
_ZERO = wp.constant(wp.float64(0.0))
_ONE = wp.constant(wp.float64(1.0))
_HALF = wp.constant(wp.float64(0.5))


@once
def estimate_kernel(
    sequence: Sequence,
    about: wp.Function,
    weigh: wp.Function,
    constant: bool,
    counts: bool,
    channels: int,
    prepare: wp.Function,
    query: wp.Function,
    any_hit: bool,
    wide: bool,
) -> wp.Kernel:
    """A kernel with a task for each point, in the order of job.rays.

    Args:
        sequence: its record.
        about: (unit normal, u, Parameters) -> (direction, pdf): the polar map, whose cells `Cells` are.
        weigh: (direction, Weights) -> vec3 that a ray adds which meets nothing; one of weight 0 is not cast.
        constant: whether that is (1, 0, 0) in all directions.
        counts: whether each ray adds 1 or 0, and nothing between.
        channels: 1 or 3, how many of the vec3 are kept.
        prepare: (chunk, rays): adds what the query needs.
        query: (Accelerator, ray, reach, scratch) -> (distance, face, nodes, leaves).
        any_hit: whether some face is enough; else what is met at t of reach leaves 1 - (1 - t)^falloff of the weight.
        wide: whether the query is that of the wide tree, which can be searched for what to skip.
    """
    sample = sequence.sample
    open_jump = _ONE if any_hit else _HALF
    worth = wp.constant(wp.float64(worth_of_prior(counts)))

    @wp.func
    def spread(job: EstimateJob, spot: Spot, cell: wp.int32, first: wp.int32, length: wp.int32):
        """The directions of a cell's rays, both replicates one after the other, from the first-th on.

        Each replicate of each cell is a stream of its own: its number goes into the seed's high word.
        """
        u = wp.array(ptr=spot.square, shape=(_SQUARE,), dtype=wp.float32)
        rays = wp.array(ptr=spot.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
        low = low_word(job.seed)
        high = high_word(job.seed)
        stream = wp.uint32(2 * cell)
        sector = cell / job.bands
        band = wp.float32(cell - sector * job.bands)
        band_size = 1.0 / wp.float32(job.bands)
        sector_size = 1.0 / wp.float32(job.sectors)
        n = spot.n
        id = spot.id
        each = job.each
        k = wp.int32(0)
        while k < length:
            i = first + k
            second = wp.where(i >= each, 1, 0)
            word = high ^ ((stream + wp.uint32(second)) * _STREAM_STEP)
            seed = (wp.uint64(word) << wp.uint64(32)) | wp.uint64(low)
            p = sample(seed, id, wp.uint32(i - second * each), wp.uint32(each))
            x = (p[0] + band) * band_size
            y = (p[1] + wp.float32(sector)) * sector_size
            u[k] = wp.where(x < _LAST_UNIFORM, x, _LAST_UNIFORM)  # where the sum is rounded up to the next cell
            u[CHUNK + k] = wp.where(y < _LAST_UNIFORM, y, _LAST_UNIFORM)
            k += 1
        k = wp.int32(0)
        while k < length:
            d = about(n, wp.vec2(u[k] + 0.0, u[CHUNK + k] + 0.0), Parameters())
            rays[DIRECTION + k] = d[0]
            rays[DIRECTION + CHUNK + k] = d[1]
            rays[DIRECTION + 2 * CHUNK + k] = d[2]
            k += 1

    @wp.func
    def distance_of(
        accelerator: Accelerator, spot: Spot, near: wp.int32, column: wp.uint64, reach: wp.float32
    ) -> wp.float32:
        """Of a ray to what it meets, with any_hit to some of it, the triangles around the point first; inf: to nothing."""
        distance = wp.float32(wp.INF)
        if wp.static(wide):
            if near != 0:
                edge = wp.array(ptr=spot.room + NEAR_EDGE, shape=(1,), dtype=wp.float32)
                leaf = spot.room + NEAR
                if wp.static(any_hit):
                    if any_of(leaf, near, ray_in(column), column, reach, edge[0]) >= 0:
                        distance = 0.0
                else:
                    met, triangle = nearest_of(leaf, near, ray_in(column), column, reach, edge[0])
                    if triangle >= 0:
                        distance = met
                        reach = met
        if accelerator.starts > 0 and (wp.static(not any_hit) or not (distance < wp.INF)):
            met, face, nodes, leaves = query(accelerator, column, reach, spot.scratch)
            distance = wp.min(distance, met)
        return distance

    @wp.func
    def jump_at(w: wp.vec3, total: wp.vec3d, free: wp.int32, rays: wp.int32) -> wp.vec3d:
        """By how much a ray's weight changes where an edge begins, squared: of a cell's total and its free rays.

        w is the weight of one ray, for where none is free.
        """
        jump = wp.vec3d(_ONE, _ZERO, _ZERO)
        if wp.static(not any_hit):
            # What ends at an edge occludes by anything from nothing to what the others do, and so does what begins there.
            if free < rays:
                jump[0] = (wp.float64(rays) - total[0]) / wp.float64(rays - free)
            return wp.vec3d(_HALF * jump[0] * jump[0], _ZERO, _ZERO)
        if wp.static(not counts):
            jump = wp.vec3d(wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2]))
            if free > 0:
                jump = total / wp.float64(free)
        return wp.cw_mul(jump, jump)

    @wp.func
    def sum_cell(job: EstimateJob, accelerator: Accelerator, spot: Spot, cell: wp.int32, found: wp.int32, near: wp.int32):
        """(sum of the weights of both replicates' rays, how much more the first has, rays cast, free, a weight)."""
        # Scalars: a vector of doubles goes through memory, and costs half as much as a ray. Hits are whole numbers.
        hits = wp.int32(0)
        more_hits = wp.int32(0)
        x = _ZERO
        y = _ZERO
        z = _ZERO
        more_x = _ZERO
        more_y = _ZERO
        more_z = _ZERO
        cast = wp.int32(0)
        free = 2 * job.each
        w = wp.vec3(1.0, 0.0, 0.0)
        for first in range(0, 2 * job.each, CHUNK):
            length = wp.min(CHUNK, 2 * job.each - first)
            padded = (length + LANES - 1) / LANES * LANES
            spread(job, spot, cell, first, padded)
            if far_off(spot.place):
                for k in range(length):
                    bring_near(spot, spot.chunk + wp.uint64(4 * k))
            if found != 0:
                prepare(spot.chunk, padded)
            for k in range(length):
                column = spot.chunk + wp.uint64(4 * k)
                ray = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
                w = weigh(wp.vec3(ray[DIRECTION], ray[DIRECTION + CHUNK], ray[DIRECTION + 2 * CHUNK]), job.weights)
                share = wp.float32(1.0)
                if found != 0 and (w[0] != 0.0 or w[1] != 0.0 or w[2] != 0.0):
                    cast += 1
                    reach = ray[REACH]
                    distance = wp.float32(wp.INF)
                    if reach > 0.0:
                        distance = distance_of(accelerator, spot, near, column, reach)
                    if distance < wp.INF:
                        share = 0.0
                        free -= 1
                        if wp.static(not any_hit):
                            t = (distance + (spot.reach - reach)) / spot.reach
                            share = 1.0 - wp.pow(1.0 - t, job.falloff)
                sign = wp.where(first + k < job.each, 1, -1)
                if wp.static(counts):
                    hit = wp.where(share * w[0] != 0.0, 1, 0)
                    hits += hit
                    more_hits += sign * hit
                else:
                    x += wp.float64(share * w[0])
                    more_x += wp.float64(sign) * wp.float64(share * w[0])
                    if wp.static(channels > 1):
                        y += wp.float64(share * w[1])
                        z += wp.float64(share * w[2])
                        more_y += wp.float64(sign) * wp.float64(share * w[1])
                        more_z += wp.float64(sign) * wp.float64(share * w[2])
        if wp.static(counts):
            x = wp.float64(hits)
            more_x = wp.float64(more_hits)
            free = hits  # and weighs 1
        return wp.vec3d(x, y, z), wp.vec3d(more_x, more_y, more_z), cast, free, w

    @wp.func
    def widths_of(
        variance: wp.vec3d,
        expected: wp.vec3d,
        unseen: wp.vec3d,
        rest: wp.vec3d,
        fourth: wp.vec3d,
        mixed: wp.int32,
        cells: wp.int32,
    ):
        """`posterior` of each channel; `unseen` is summed over the cells."""
        width = _NOTHING
        degrees = _NOTHING
        for c in range(channels):
            of_ray = unseen[c] / wp.float64(cells)
            square, freedom = posterior(variance[c], expected[c], of_ray, rest[c], fourth[c], mixed, cells, worth)
            width[c] = square
            degrees[c] = freedom
        return width, degrees

    @wp.func
    def sum_lobe(job: EstimateJob, accelerator: Accelerator, spot: Spot):
        """(sum of the weights of all rays, squares of its standard error and spread, degrees, rays cast, in empty cells)."""
        total = _NOTHING
        variance = _NOTHING
        hits = wp.int32(0)
        squared = _ZERO
        edges = _ZERO
        mixed = wp.int32(0)
        expected = _NOTHING
        unseen = _NOTHING
        rest = _NOTHING
        fourth = _NOTHING
        cast = wp.int32(0)
        empty = wp.int32(0)
        starts = wp.int32(-1)
        near = wp.int32(0)
        if wp.static(wide):
            if job.skip != 0 and not far_off(spot.place):
                starts, around = frontier(accelerator, spot.o, spot.n, spot.low, spot.reach, spot.room, spot.scratch)
                near = (1 << around) - 1
                if starts >= 0:
                    accelerator.start = spot.room
                    accelerator.starts = starts
        beams = starts > 0 or near != 0
        if job.beams == wp.uint64(0) or starts < 0:
            beams = False
        nothing = starts == 0 and near == 0
        for sector in range(job.sectors):
            sector_found = wp.where(nothing, 0, 1)
            for step in range(wp.where(job.bands == 1, 1, 0), job.bands + 1):  # the sector as a whole first, then its bands
                found = sector_found
                cell_near = near
                if wp.static(wide):
                    if beams and found != 0:
                        found, cell_near = found_in(job, accelerator, spot, sector * (job.bands + 1) + step, near)
                if step == 0:
                    sector_found = found
                else:
                    if found == 0:
                        empty += 2 * job.each
                    if wp.static(constant) and found == 0:
                        if wp.static(counts):
                            hits += 2 * job.each
                        else:
                            total[0] += wp.float64(2 * job.each)
                            unseen[0] += open_jump
                    else:
                        cell = sector * job.bands + step - 1
                        add, difference, rays, free, w = sum_cell(job, accelerator, spot, cell, found, cell_near)
                        cast += rays
                        edge = _ZERO
                        if free > 0 and free < 2 * job.each:
                            edge = edge_variance(free, 2 * job.each, job.edge)
                            mixed += 1
                        if wp.static(counts):  # scalars again; where all rays agree their difference is 0
                            hits += free
                            squared += difference[0] * difference[0]
                            edges += edge
                        else:
                            squares = wp.cw_mul(difference, difference)
                            total += add
                            variance += squares
                            jump = jump_at(w, add, free, 2 * job.each)
                            expected += edge * jump
                            unseen += jump
                            if edge == _ZERO:
                                rest += squares
                                fourth += wp.cw_mul(squares, squares)
        if wp.static(counts):
            total[0] = wp.float64(hits)
            variance[0] = squared
            expected[0] = edges
            unseen[0] = wp.float64(job.bands * job.sectors)
        width, degrees = widths_of(variance, expected, unseen, rest, fourth, mixed, job.bands * job.sectors)
        return total, variance, width, degrees, cast, empty

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def estimate(job: EstimateJob, accelerator: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        floats = wp.zeros(shape=(CHUNK_FLOATS,), dtype=wp.float32)
        square = wp.zeros(shape=(_SQUARE,), dtype=wp.float32)
        beam = wp.zeros(shape=(BEAM_FLOATS,), dtype=wp.float32)
        room = wp.zeros(shape=(START_FLOATS,), dtype=wp.float32)
        point = point_of(job.rays, first_task + wp.int64(wp.tid()))
        normal = wp.array(ptr=job.normals + wp.uint64(point) * wp.uint64(12), shape=(1,), dtype=wp.vec3)[0]
        unit = scaled_to_unit(normal)
        spot = Spot()
        spot.id = job.first_point + wp.uint64(point)
        spot.n = wp.vec3(unit[0], unit[1], unit[2])
        spot.place = local_origin(job.rays, point)
        if wp.static(wide):
            spot.o = wp.array(ptr=job.rays.starts + wp.uint64(point) * wp.uint64(12), shape=(1,), dtype=wp.vec3)[0]
        else:
            side = wp.array(ptr=job.rays.normals + wp.uint64(point) * wp.uint64(12), shape=(1,), dtype=wp.vec3)[0]
            spot.o = wp.vec3(spot.place) + wp.copysign(lift(job.rays, side), wp.dot(side, spot.n)) * side
        spot.low = HORIZON_MARGIN * reach_along(job.rays, spot.n, spot.o)
        spot.reach = wp.float32(job.rays.reach)
        spot.chunk = floats.ptr
        spot.square = square.ptr
        spot.room = room.ptr
        spot.beam = beam.ptr
        spot.scratch = words.ptr
        weight = wp.float32(1.0)
        if job.active != wp.uint64(0):
            weight = weigh_by_mask(wp.array(ptr=job.active + wp.uint64(point), shape=(1,), dtype=wp.uint8), 0)
        status = normal_status(normal, weight)
        if status == 0 and wp.dot(spot.place - spot.place, spot.place - spot.place) != _ZERO:
            status = _NONFINITE_POSITION
        total = _NOTHING
        variance = _NOTHING
        width = _NOTHING
        degrees = _NOTHING
        cast = wp.int32(0)
        empty = wp.int32(0)
        if status == 0:
            start(spot.chunk, spot.o, spot.reach)
            total, variance, width, degrees, cast, empty = sum_lobe(job, accelerator, spot)
        rays = wp.float64(2 * job.each * job.bands * job.sectors)
        at = wp.uint64(point) * wp.uint64(4 * channels)
        value = wp.array(ptr=job.value + at, shape=(channels,), dtype=wp.float32)
        error = wp.array(ptr=job.error + at, shape=(channels,), dtype=wp.float32)
        spreads = wp.array(ptr=job.spread + at, shape=(channels,), dtype=wp.float32)
        freedom = wp.array(ptr=job.degrees + at, shape=(channels,), dtype=wp.float32)
        for c in range(channels):
            value[c] = wp.float32(total[c] / rays)
            error[c] = wp.float32(wp.sqrt(variance[c]) / rays)
            spreads[c] = wp.float32(wp.sqrt(width[c]) / rays)
            freedom[c] = wp.float32(degrees[c])
        at = wp.uint64(point) * wp.uint64(4)
        counts = wp.array(ptr=job.cast + at, shape=(1,), dtype=wp.int32)
        counts[0] = cast
        counts = wp.array(ptr=job.empty + at, shape=(1,), dtype=wp.int32)
        counts[0] = empty
        statuses = wp.array(ptr=job.status + wp.uint64(point), shape=(1,), dtype=wp.uint8)
        statuses[0] = wp.uint8(status)

    return estimate
