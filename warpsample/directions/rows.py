"""Directions row by row: see `job`."""

import warp as wp

from warpsample.directions.job import DirectionJob, accessors, normal_status, point_id
from warpsample.directions.variates import LANES, fill_variates
from warpsample.host.locks import once
from warpsample.maths.numerics import scaled_to_unit
from warpsample.sequences.record import Sequence

MOST_ROWS = 128
"""Of a task, whose loops set up their constants once; one on CUDA."""


@once
def direction_rows(
    sequence: Sequence,
    about: wp.Function,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    chunk: int,
) -> wp.Kernel:
    """A kernel over tasks of `rows` points with `block` samples each, which are all of `count` where rows is above 1.

    Args:
        sequence: its record.
        about: (unit normal, u, Parameters) -> (direction, pdf).
        redraw: what replaces `about` where it loses its digits; rare, so in a second pass over such chunks only.
        redraw_below: the pdf below which it does.
        with_pdf: whether the pdf is stored.
        masked: whether `active` is read.
        chunk: samples whose variates are computed ahead: CHUNK, or 1.
    """
    store, weigh = accessors(with_pdf, masked)
    redraws = redraw is not None
    fill = fill_variates(sequence, chunk)
    lanes = min(LANES, chunk)
    most_rows = MOST_ROWS if chunk > 1 else 1
    floats = 6 * chunk + 4 * most_rows

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
        units = wp.array(ptr=buffer.ptr + wp.uint64(24 * chunk), shape=(4 * most_rows,), dtype=wp.float32)
        parts = wp.int64((job.count + job.block - 1) / job.block)
        first_part = (first_task + wp.int64(wp.tid())) * wp.int64(job.rows)
        rows = wp.int32(wp.min(wp.int64(job.rows), job.points * parts - first_part))
        first_point = first_part / parts
        normals = wp.array(ptr=job.normals + wp.uint64(first_point) * wp.uint64(12), shape=(3 * rows,), dtype=wp.float32)
        active = wp.array(ptr=job.active + wp.uint64(first_point), shape=(rows,), dtype=wp.uint8)
        r = wp.int32(0)
        while r < rows:
            unit = scaled_to_unit(weigh(active, r) * wp.vec3(normals[3 * r], normals[3 * r + 1], normals[3 * r + 2]))
            units[r] = unit[0]
            units[most_rows + r] = unit[1]
            units[2 * most_rows + r] = unit[2]
            units[3 * most_rows + r] = unit[3]
            r += 1
        start = wp.int32(first_part - first_point * parts) * job.block
        end = wp.min(start + job.block, job.count)
        for k in range(rows):
            point = first_point + wp.int64(k)
            n = wp.vec3(units[k], units[most_rows + k], units[2 * most_rows + k])
            id = point_id(job, wp.uint32(point))
            row = wp.uint64(point) * wp.uint64(job.count)
            if wp.abs(units[3 * most_rows + k]) < 0.1:
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
                normal = wp.vec3(normals[3 * k], normals[3 * k + 1], normals[3 * k + 2])
                clear(job, point, start, end, normal, weigh(active, k))

    return direction_rows
