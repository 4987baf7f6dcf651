"""Kernel that computes directions block by block, for few samples per point on the CPU; see `samples`."""

import warp as wp

from warpsample.directions.samples import Samples, build_unit_writer, normal_status, select_accessors
from warpsample.directions.variates import LANES
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.host.locks import once
from warpsample.maths.numerics import normalize
from warpsample.sequences.record import Sequence

_BLOCK = wp.constant(wp.int64(FLAT_BLOCK))
_STRIDE = FLAT_BLOCK + LANES


@once
def _build_mender(
    sequence: Sequence, about: wp.Function, *, redraw: wp.Function | None, redraw_below: float, with_pdf: bool, masked: bool
) -> wp.Function:
    """Build the wp.func that corrects the rare pairs of a block that the vectorised loop cannot handle.

    The function writes zeros and a status where a point has no direction, and applies `redraw` where `about` is imprecise.
    """
    (store, weigh), redraws = select_accessors(with_pdf, masked), redraw is not None
    key_of, sample_of = sequence.key, sequence.sample

    @wp.func
    def mend(
        samples: Samples,
        point: wp.int64,
        start: wp.int32,
        length: wp.int32,
        normals: wp.array[wp.float32],
        active: wp.array[wp.uint8],
        vectors: wp.array[wp.float32],
        pdf: wp.array[wp.float32],
    ):
        for i in range(length):
            q = (start + i) / samples.count
            normal = wp.vec3(normals[3 * q], normals[3 * q + 1], normals[3 * q + 2])
            code = normal_status(normal, weigh(active, q))
            if code != 0:
                status = wp.array(ptr=samples.status + wp.uint64(point) + wp.uint64(q), shape=(1,), dtype=wp.uint8)
                status[0] = wp.uint8(code)
                store(vectors, pdf, i, wp.vec4(0.0))
            elif wp.static(redraws):
                n = normalize(normal)
                key = key_of(samples.run, samples.first_point + wp.uint32(point) + wp.uint32(q))
                u = sample_of(key, wp.uint32(start + i - q * samples.count), wp.uint32(samples.count))
                if about(n, u, samples.parameters)[3] < redraw_below:
                    store(vectors, pdf, i, redraw(n, u, samples.parameters))

    return mend


@once
def _build_block_variates(sequence: Sequence, one_sample: bool) -> wp.Function:
    """Build the wp.func that writes the points u of a block: u[0] of all pairs, then u[1] from index FLAT_BLOCK on."""
    key_of, sample_of = sequence.key, sequence.sample

    @wp.func
    def fill(samples: Samples, point: wp.int64, start: wp.int32, length: wp.int32, u: wp.array[wp.float32]):
        count = wp.int32(1)
        if wp.static(not one_sample):
            count = samples.count
        per_count = 1.0 / wp.float32(samples.count)
        run = samples.run
        low = samples.first_point + wp.uint32(point)
        total = wp.uint32(count)
        i = wp.int32(0)
        while i < length:
            q = i
            sample = wp.uint32(0)
            if wp.static(not one_sample):
                # Exact: the half keeps the quotient away from integers by more than the error of float32 below 2^13.
                q = wp.int32((wp.float32(start + i) + 0.5) * per_count)
                sample = wp.uint32(start + i - q * count)
            v = sample_of(key_of(run, low + wp.uint32(q)), sample, total)
            u[i] = v[0]
            u[FLAT_BLOCK + i] = v[1]
            i += 1

    return fill


@wp.func
def _repeat_normals(
    units: wp.array[wp.float32],
    points: wp.int32,
    count: wp.int32,
    start: wp.int32,
    length: wp.int32,
    repeated: wp.array[wp.float32],
):
    """Write the unit normal of each pair of a block, by repeating the unit normals of the points."""
    for p in range(points):
        x = units[p]
        y = units[_STRIDE + p]
        z = units[2 * _STRIDE + p]
        # Whole SIMD vectors: the next point overwrites the surplus, and the buffer has room for the last surplus.
        for m in range(wp.max(p * count - start, 0), wp.min((p + 1) * count - start, length), LANES):
            at = wp.array(ptr=repeated.ptr + wp.uint64(4 * m), shape=(3 * _STRIDE,), dtype=wp.float32)
            for k in range(LANES):
                at[k] = x
                at[_STRIDE + k] = y
                at[2 * _STRIDE + k] = z


@once
def direction_blocks(
    sequence: Sequence,
    about: wp.Function,
    *,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    one_sample: bool,
) -> wp.Kernel:
    """Build the kernel that computes directions in tasks of `rows` blocks, bit for bit as `direction_rows` does.

    A block computes unit normals and points u first. If points have several samples, it then copies the normal of each pair
    to a buffer, because a gather from an array that the stores might alias would prevent vectorisation.
    """
    (store, _), redraws = select_accessors(with_pdf, masked), redraw is not None
    mend = _build_mender(sequence, about, redraw=redraw, redraw_below=redraw_below, with_pdf=with_pdf, masked=masked)
    write_units, fill = build_unit_writer(masked, _STRIDE, False), _build_block_variates(sequence, one_sample)
    floats = 2 * FLAT_BLOCK + (3 if one_sample else 6) * _STRIDE
    repeated_at = 4 * (floats - 3 * _STRIDE)  # bytes; for one sample per point, the address of the unit normals

    @wp.func
    def fill_block(samples: Samples, first: wp.int64, buffer: wp.uint64):
        count = wp.int32(1)
        if wp.static(not one_sample):
            count = samples.count
        length = wp.int32(wp.min(_BLOCK, samples.points * wp.int64(count) - first))
        point = first / wp.int64(count)
        start = wp.int32(first - point * wp.int64(count))
        span = (start + length - 1) / count + 1
        normals = wp.array(ptr=samples.normals + wp.uint64(point) * wp.uint64(12), shape=(3 * span,), dtype=wp.float32)
        vectors = wp.array(ptr=samples.vectors + wp.uint64(first) * wp.uint64(12), shape=(3 * length,), dtype=wp.float32)
        pdf = wp.array(ptr=samples.pdf + wp.uint64(first) * wp.uint64(4), shape=(length,), dtype=wp.float32)
        active = wp.array(ptr=samples.active + wp.uint64(point), shape=(span,), dtype=wp.uint8)
        u = wp.array(ptr=buffer, shape=(2 * FLAT_BLOCK,), dtype=wp.float32)
        units = wp.array(ptr=buffer + wp.uint64(8 * FLAT_BLOCK), shape=(3 * _STRIDE,), dtype=wp.float32)
        repeated = wp.array(ptr=buffer + wp.uint64(repeated_at), shape=(3 * _STRIDE,), dtype=wp.float32)
        rare = write_units(normals, active, span, units)
        fill(samples, point, start, length, u)
        if wp.static(not one_sample):
            _repeat_normals(units, span, count, start, length, repeated)
        j = wp.int32(0)
        while j < length:
            n = wp.vec3(repeated[j], repeated[_STRIDE + j], repeated[2 * _STRIDE + j])
            d = about(n, wp.vec2(u[j] + 0.0, u[FLAT_BLOCK + j] + 0.0), samples.parameters)
            store(vectors, pdf, j, d)
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            j += 1
        if rare != 0:
            mend(samples, point, start, length, normals, active, vectors, pdf)

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def direction_blocks(samples: Samples, first_task: wp.int64):
        buffer = wp.zeros(shape=(floats,), dtype=wp.float32)
        first = (first_task + wp.int64(wp.tid())) * wp.int64(samples.rows) * _BLOCK
        end = wp.min(first + wp.int64(samples.rows) * _BLOCK, samples.points * wp.int64(samples.count))
        while first < end:
            fill_block(samples, first, buffer.ptr)
            first += _BLOCK

    return direction_blocks
