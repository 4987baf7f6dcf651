"""Directions by blocks of pairs: see `job`."""

import warp as wp

from warpsample.directions.job import DirectionJob, accessors, normal_status, point_id
from warpsample.directions.variates import LANES
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.host.locks import once
from warpsample.maths.numerics import normalize, scaled_to_unit
from warpsample.sequences.record import Sequence

_BLOCK = wp.constant(wp.int64(FLAT_BLOCK))


@once
def direction_blocks(
    sequence: Sequence,
    about: wp.Function,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    one_sample: bool,
) -> wp.Kernel:
    """A kernel over blocks of FLAT_BLOCK consecutive (point, sample) pairs; bit for bit the results of `direction_rows`.

    Unit normals and variates first, as there. Unless each point has one sample, the normals are then repeated, pair by pair:
    a gather from an array that the stores might alias would keep the loop scalar.
    """
    store, weigh = accessors(with_pdf, masked)
    redraws = redraw is not None
    stride = FLAT_BLOCK + LANES
    floats = 2 * FLAT_BLOCK + (3 if one_sample else 6) * stride
    repeated_at = 4 * (floats - 3 * stride)  # bytes; where each point has one sample, that is where the units are
    sample_of = sequence.sample

    @wp.func
    def mend(
        job: DirectionJob,
        point: wp.int64,
        start: wp.int32,
        length: wp.int32,
        normals: wp.array[wp.float32],
        active: wp.array[wp.uint8],
        vectors: wp.array[wp.float32],
        pdf: wp.array[wp.float32],
    ):
        """Clears what has no direction, says why, and redraws; scalar, for the few blocks that hold such a pair."""
        for i in range(length):
            q = (start + i) / job.count
            given = wp.vec3(normals[3 * q], normals[3 * q + 1], normals[3 * q + 2])
            code = normal_status(given, weigh(active, q))
            if code != 0:
                status = wp.array(ptr=job.status + wp.uint64(point) + wp.uint64(q), shape=(1,), dtype=wp.uint8)
                status[0] = wp.uint8(code)
                store(vectors, pdf, i, wp.vec4(0.0))
            elif wp.static(redraws):
                n = normalize(given)
                id = point_id(job, wp.uint32(point) + wp.uint32(q))
                u = sample_of(job.seed, id, wp.uint32(start + i - q * job.count), wp.uint32(job.count))
                if about(n, u, job.parameters)[3] < redraw_below:
                    store(vectors, pdf, i, redraw(n, u, job.parameters))

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def direction_blocks(job: DirectionJob, first_task: wp.int64):
        first = (first_task + wp.int64(wp.tid())) * _BLOCK
        count = wp.int32(1)
        if wp.static(not one_sample):
            count = job.count
        length = wp.int32(wp.min(_BLOCK, job.points * wp.int64(count) - first))
        point = first / wp.int64(count)
        start = wp.int32(first - point * wp.int64(count))
        span = (start + length - 1) / count + 1
        normals = wp.array(ptr=job.normals + wp.uint64(point) * wp.uint64(12), shape=(3 * span,), dtype=wp.float32)
        vectors = wp.array(ptr=job.vectors + wp.uint64(first) * wp.uint64(12), shape=(3 * length,), dtype=wp.float32)
        pdf = wp.array(ptr=job.pdf + wp.uint64(first) * wp.uint64(4), shape=(length,), dtype=wp.float32)
        active = wp.array(ptr=job.active + wp.uint64(point), shape=(span,), dtype=wp.uint8)
        buffer = wp.zeros(shape=(floats,), dtype=wp.float32)
        u = wp.array(ptr=buffer.ptr, shape=(2 * FLAT_BLOCK,), dtype=wp.float32)
        units = wp.array(ptr=buffer.ptr + wp.uint64(8 * FLAT_BLOCK), shape=(3 * stride,), dtype=wp.float32)
        repeated = wp.array(ptr=buffer.ptr + wp.uint64(repeated_at), shape=(3 * stride,), dtype=wp.float32)
        rare = wp.int32(0)
        r = wp.int32(0)
        while r < span:
            unit = scaled_to_unit(weigh(active, r) * wp.vec3(normals[3 * r], normals[3 * r + 1], normals[3 * r + 2]))
            units[r] = unit[0]
            units[stride + r] = unit[1]
            units[2 * stride + r] = unit[2]
            rare = rare | wp.where(wp.abs(unit[3]) < 0.1, 0, 1)
            r += 1
        per_count = 1.0 / wp.float32(job.count)
        i = wp.int32(0)
        while i < length:
            q = i
            sample = wp.uint32(0)
            if wp.static(not one_sample):
                # Exact: the half keeps the quotient off the integers by more than float32 errs below 2^13.
                q = wp.int32((wp.float32(start + i) + 0.5) * per_count)
                sample = wp.uint32(start + i - q * count)
            v = sample_of(job.seed, point_id(job, wp.uint32(point) + wp.uint32(q)), sample, wp.uint32(count))
            u[i] = v[0]
            u[FLAT_BLOCK + i] = v[1]
            i += 1
        if wp.static(not one_sample):
            for p in range(span):
                x = units[p]
                y = units[stride + p]
                z = units[2 * stride + p]
                # A vector at a time, over what the next point overwrites and the rim of the buffer.
                for m in range(wp.max(p * count - start, 0), wp.min((p + 1) * count - start, length), LANES):
                    at = wp.array(ptr=repeated.ptr + wp.uint64(4 * m), shape=(3 * stride,), dtype=wp.float32)
                    for k in range(LANES):
                        at[k] = x
                        at[stride + k] = y
                        at[2 * stride + k] = z
        j = wp.int32(0)
        while j < length:
            n = wp.vec3(repeated[j], repeated[stride + j], repeated[2 * stride + j])
            d = about(n, wp.vec2(u[j] + 0.0, u[FLAT_BLOCK + j] + 0.0), job.parameters)
            store(vectors, pdf, j, d)
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            j += 1
        if rare != 0:
            mend(job, point, start, length, normals, active, vectors, pdf)

    return direction_blocks
