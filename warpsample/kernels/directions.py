"""Directions at points, in two shapes of loop with the same results, bit for bit.

*Rows* walk the samples of one point, so all that depends on the point alone (frame, scramble keys) is computed once: for
many samples on the CPU, some rows a task, since the constants of the loops are set up once a task. In parts of one sample
they serve CUDA, where neighbouring threads then store side by side.
*Blocks* walk consecutive (point, sample) pairs: for few samples on the CPU, where a row would not fill a vector.
"""

from functools import cache

import warp as wp

from warpsample.kernels import FLAT_BLOCK
from warpsample.kernels.parameters import Parameters
from warpsample.kernels.variates import LANES, fill_variates
from warpsample.numerics import high_word, low_word, normalize, scaled_to_unit
from warpsample.sequences.record import Sequence

OK = 0
INACTIVE = 1
ZERO_NORMAL = 2
NONFINITE_NORMAL = 3

_BLOCK = wp.constant(wp.int64(FLAT_BLOCK))
_STATUS_INACTIVE = wp.constant(wp.int32(INACTIVE))
_STATUS_ZERO = wp.constant(wp.int32(ZERO_NORMAL))
_STATUS_NONFINITE = wp.constant(wp.int32(NONFINITE_NORMAL))


@wp.func
def normal_status(n: wp.vec3, weight: wp.float32) -> wp.int32:
    """INACTIVE where the weight is 0, else OK, ZERO_NORMAL or NONFINITE_NORMAL."""
    finite = (n[0] - n[0]) + (n[1] - n[1]) + (n[2] - n[2]) == 0.0
    zero = wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]) == 0.0
    code = wp.where(finite, wp.where(zero, _STATUS_ZERO, 0), _STATUS_NONFINITE)
    return wp.where(weight == 0.0, _STATUS_INACTIVE, code)


@wp.func
def _store(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):
    vectors[3 * i] = d[0]
    vectors[3 * i + 1] = d[1]
    vectors[3 * i + 2] = d[2]


@wp.func
def _store_pdf(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):
    _store(vectors, pdf, i, d)
    pdf[i] = d[3]


@wp.func
def _weigh(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:
    return wp.where(active[i] == wp.uint8(0), 0.0, 1.0)


@wp.func
def _all_active(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:
    return 1.0


@wp.struct
class DirectionJob:
    """Scalars and addresses: normals (P, 3), vectors (P, count, 3), pdf (P, count) float32; status, active (P,) uint8.

    The ids of all points, from first_point on, have the same high word. Rows come in parts of `block` samples, `rows` of
    them a task.
    """

    seed: wp.uint64
    first_point: wp.uint64
    points: wp.int64
    count: wp.int32
    block: wp.int32
    rows: wp.int32
    normals: wp.uint64
    vectors: wp.uint64
    pdf: wp.uint64
    status: wp.uint64
    active: wp.uint64
    parameters: Parameters


Job = type(DirectionJob().__ctype__())
"""As ctypes takes it: made in 2 us, where setting the fields of a `DirectionJob` one by one takes 50."""


@wp.func
def _point_id(job: DirectionJob, point: wp.uint32) -> wp.uint64:
    """The global id of a point, by words: the high one is the job's, so a loop over points has 32-bit lanes."""
    low = low_word(job.first_point) + point
    return (wp.uint64(high_word(job.first_point)) << wp.uint64(32)) | wp.uint64(low)


@cache
def direction_rows(
    sequence: Sequence,
    about: wp.Function,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    chunk: int,
) -> wp.Kernel:
    """A kernel over `rows` parts of rows, each of `block` samples of one point.

    Args:
        sequence: its record.
        about: (unit normal, u, Parameters) -> (direction, pdf).
        redraw: what replaces `about` where it loses its digits; rare, so in a second pass over such chunks only.
        redraw_below: the pdf below which it does.
        with_pdf: whether the pdf is stored.
        masked: whether `active` is read.
        chunk: samples whose variates are computed ahead: CHUNK, or 1.
    """
    store = _store_pdf if with_pdf else _store
    weigh = _weigh if masked else _all_active
    redraws = redraw is not None
    fill = fill_variates(sequence, chunk)
    lanes = min(LANES, chunk)
    floats = 6 * chunk

    @wp.func
    def move(job: DirectionJob, at: wp.uint64, length: wp.int32, vectors: wp.array[wp.float32], pdf: wp.array[wp.float32]):
        """The first `length` of a padded chunk into the output."""
        kept = wp.array(ptr=job.vectors + at * wp.uint64(12), shape=(3 * length,), dtype=wp.float32)
        k = wp.int32(0)
        while k < 3 * length:
            kept[k] = vectors[k]
            k += 1
        if wp.static(with_pdf):
            kept_pdf = wp.array(ptr=job.pdf + at * wp.uint64(4), shape=(length,), dtype=wp.float32)
            k = wp.int32(0)
            while k < length:
                kept_pdf[k] = pdf[k]
                k += 1

    @wp.func
    def clear(job: DirectionJob, point: wp.int64, start: wp.int32, end: wp.int32, normal: wp.vec3, weight: wp.float32):
        """Zeros for a point without directions, and why."""
        status = wp.array(ptr=job.status + wp.uint64(point), shape=(1,), dtype=wp.uint8)
        status[0] = wp.uint8(normal_status(normal, weight))
        at = wp.uint64(point) * wp.uint64(job.count) + wp.uint64(start)
        vectors = wp.array(ptr=job.vectors + at * wp.uint64(12), shape=(3 * (end - start),), dtype=wp.float32)
        pdf = wp.array(ptr=job.pdf + at * wp.uint64(4), shape=(end - start,), dtype=wp.float32)
        for k in range(end - start):
            store(vectors, pdf, k, wp.vec4(0.0))

    @wp.func
    def redraw_rare(
        job: DirectionJob,
        n: wp.vec3,
        length: wp.int32,
        u: wp.array[wp.float32],
        vectors: wp.array[wp.float32],
        pdf: wp.array[wp.float32],
    ):
        """Redraws; scalar, for the few chunks that hold such a sample."""
        for j in range(length):
            p = wp.vec2(u[j], u[chunk + j])
            if about(n, p, job.parameters)[3] < redraw_below:
                store(vectors, pdf, j, redraw(n, p, job.parameters))

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def direction_rows(job: DirectionJob, first_task: wp.int64):
        # Views, since a local array keeps its address in memory that the compiler thinks the loops may write to.
        buffer = wp.zeros(shape=(floats,), dtype=wp.float32)
        u = wp.array(ptr=buffer.ptr, shape=(2 * chunk,), dtype=wp.float32)
        spare = buffer.ptr + wp.uint64(8 * chunk)
        parts = wp.int64((job.count + job.block - 1) / job.block)
        first_part = (first_task + wp.int64(wp.tid())) * wp.int64(job.rows)
        for k in range(wp.int32(wp.min(wp.int64(job.rows), job.points * parts - first_part))):
            point = (first_part + wp.int64(k)) / parts
            start = wp.int32(first_part + wp.int64(k) - point * parts) * job.block
            end = wp.min(start + job.block, job.count)
            normal = wp.array(ptr=job.normals + wp.uint64(point) * wp.uint64(12), shape=(1,), dtype=wp.vec3)
            active = wp.array(ptr=job.active + wp.uint64(point), shape=(1,), dtype=wp.uint8)
            unit = scaled_to_unit(normal[0] * weigh(active, 0))
            n = wp.vec3(unit[0], unit[1], unit[2])
            id = _point_id(job, wp.uint32(point))
            row = wp.uint64(point) * wp.uint64(job.count)
            if wp.abs(unit[3]) < 0.1:
                for first in range(start, end, chunk):
                    length = wp.min(chunk, end - first)
                    padded = (length + lanes - 1) / lanes * lanes
                    at = row + wp.uint64(first)
                    target = wp.where(length == padded, job.vectors + at * wp.uint64(12), spare)
                    target_pdf = wp.where(length == padded, job.pdf + at * wp.uint64(4), spare + wp.uint64(12 * chunk))
                    vectors = wp.array(ptr=target, shape=(3 * padded,), dtype=wp.float32)
                    pdf = wp.array(ptr=target_pdf, shape=(padded,), dtype=wp.float32)
                    fill(job.seed, id, first, padded, wp.uint32(job.count), u)
                    rare = wp.int32(0)
                    j = wp.int32(0)
                    while j < padded:
                        # Adding 0 keeps LLVM from one short load of both.
                        d = about(n, wp.vec2(u[j] + 0.0, u[chunk + j] + 0.0), job.parameters)
                        store(vectors, pdf, j, d)
                        if wp.static(redraws):
                            rare = rare | wp.where(d[3] < redraw_below, 1, 0)
                        j += 1
                    if wp.static(redraws):  # noqa: SIM102  (one is decided when the kernel is built, the other when it runs)
                        if rare != 0:
                            redraw_rare(job, n, length, u, vectors, pdf)
                    if length != padded:
                        move(job, at, length, vectors, pdf)
            else:
                clear(job, point, start, end, normal[0], weigh(active, 0))

    return direction_rows


@cache
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

    Variates first, as there. Unless each point has one sample, the block's normals are then repeated into a local buffer,
    pair by pair: a gather from an array that the stores might alias would keep the loop scalar.
    """
    store = _store_pdf if with_pdf else _store
    weigh = _weigh if masked else _all_active
    redraws = redraw is not None
    stride = FLAT_BLOCK + LANES
    floats = 2 * FLAT_BLOCK + (0 if one_sample else 3 * stride)
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
                id = _point_id(job, wp.uint32(point) + wp.uint32(q))
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
        repeated = wp.array(ptr=buffer.ptr + wp.uint64(8 * FLAT_BLOCK), shape=(3 * stride,), dtype=wp.float32)
        per_count = 1.0 / wp.float32(job.count)
        i = wp.int32(0)
        while i < length:
            # Exact: the half keeps the quotient off the integers by more than float32 errs below 2^13.
            q = i
            sample = wp.uint32(0)
            if wp.static(not one_sample):
                q = wp.int32((wp.float32(start + i) + 0.5) * per_count)
                sample = wp.uint32(start + i - q * count)
            v = sample_of(job.seed, _point_id(job, wp.uint32(point) + wp.uint32(q)), sample, wp.uint32(count))
            u[i] = v[0]
            u[FLAT_BLOCK + i] = v[1]
            i += 1
        if wp.static(not one_sample):
            for p in range(span):
                weight = weigh(active, p)
                x = weight * normals[3 * p]
                y = weight * normals[3 * p + 1]
                z = weight * normals[3 * p + 2]
                # A vector at a time, over what the next point overwrites and the rim of the buffer.
                for m in range(wp.max(p * count - start, 0), wp.min((p + 1) * count - start, length), LANES):
                    at = wp.array(ptr=repeated.ptr + wp.uint64(4 * m), shape=(3 * stride,), dtype=wp.float32)
                    for k in range(LANES):
                        at[k] = x
                        at[stride + k] = y
                        at[2 * stride + k] = z
        rare = wp.int32(0)
        j = wp.int32(0)
        while j < length:
            given = wp.vec3(0.0)
            if wp.static(one_sample):
                given = weigh(active, j) * wp.vec3(normals[3 * j], normals[3 * j + 1], normals[3 * j + 2])
            else:
                given = wp.vec3(repeated[j], repeated[stride + j], repeated[2 * stride + j])
            unit = scaled_to_unit(given)
            n = wp.vec3(unit[0], unit[1], unit[2])
            d = about(n, wp.vec2(u[j] + 0.0, u[FLAT_BLOCK + j] + 0.0), job.parameters)
            store(vectors, pdf, j, d)
            rare = rare | wp.where(wp.abs(unit[3]) < 0.1, 0, 1)
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            j += 1
        if rare != 0:
            mend(job, point, start, length, normals, active, vectors, pdf)

    return direction_blocks
