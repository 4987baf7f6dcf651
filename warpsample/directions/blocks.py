"""Warp kernel that samples directions for few samples per point on the CPU; one task covers blocks of several points."""

import warp as wp

from warpsample.directions.samples import (
    INVALID_PARAMETER,
    Samples,
    build_orienter,
    build_unit_writer,
    normal_status,
    select_accessors,
)
from warpsample.directions.variates import LANES
from warpsample.distributions.by_point.tables import (
    Layout,
    column_loader,
    column_writer,
    repeat_number,
    row_check,
    row_loader,
)
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.host.locks import once
from warpsample.maths.frames import frame_along
from warpsample.maths.numerics import normalize
from warpsample.sequences.record import Sequence

_BLOCK = wp.constant(wp.int64(FLAT_BLOCK))
_STRIDE = FLAT_BLOCK + LANES


@once
def _build_mender(
    sequence: Sequence,
    about: wp.Function,
    *,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    layout: Layout,
    tangents: bool,
) -> wp.Function:
    """Build the wp.func that recomputes the few directions that the vectorised loop gets wrong, as for zero normals.

    The function writes zeros and a status where a point has no direction, and applies `redraw` where `about` is imprecise.
    """
    (store, weigh), redraws = select_accessors(with_pdf, masked), redraw is not None
    key_of, sample_of = sequence.key, sequence.sample
    load, check, orient = row_loader(layout), row_check(layout), build_orienter(tangents)

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
            parameters = load(samples.parameters, samples.tables, samples.row + point + wp.int64(q))
            if code == 0 and check(parameters) != 0:
                code = INVALID_PARAMETER
            if code != 0:
                status = wp.array(ptr=samples.status + wp.uint64(point) + wp.uint64(q), shape=(1,), dtype=wp.uint8)
                status[0] = wp.uint8(code)
                store(vectors, pdf, i, wp.vec4(0.0))
            elif wp.static(redraws or tangents):
                n = orient(samples, point + wp.int64(q), normalize(normal))
                if wp.static(redraws):
                    key = key_of(samples.run, samples.first_point + wp.uint32(point) + wp.uint32(q))
                    u = sample_of(key, wp.uint32(start + i - q * samples.count), wp.uint32(samples.count))
                    if about(n, u, parameters)[3] < redraw_below:
                        store(vectors, pdf, i, redraw(n, u, parameters))

    return mend


@once
def _build_block_variates(sequence: Sequence, one_sample: bool) -> wp.Function:
    """Build the wp.func that writes the unit-square points of a block of directions: all u[0], then all u[1]."""
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
    """Copy the unit normal of each point once for each of the point's directions in a block."""
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
def _build_frame_writer(one_sample: bool) -> wp.Function:
    """Build the wp.func that writes the x and y axes of the tangent frame of each direction in a block, as six columns.

    With several samples, the frames of the points are written behind the columns first. The function returns 1 if a tangent
    cannot be used, else 0.
    """
    own = 0 if one_sample else 24 * _STRIDE  # bytes

    @wp.func
    def write(
        tangents: wp.uint64,
        point: wp.int64,
        units: wp.array[wp.float32],
        points: wp.int32,
        count: wp.int32,
        start: wp.int32,
        length: wp.int32,
        frames: wp.array[wp.float32],
    ):
        t = wp.array(ptr=tangents + wp.uint64(point) * wp.uint64(16), shape=(4 * points,), dtype=wp.float32)
        each = wp.array(ptr=frames.ptr + wp.uint64(own), shape=(6 * _STRIDE,), dtype=wp.float32)
        rare = wp.int32(0)
        j = wp.int32(0)
        while j < points:
            n = wp.vec3(units[j], units[_STRIDE + j], units[2 * _STRIDE + j])
            frame, usable = frame_along(n, wp.vec4(t[4 * j], t[4 * j + 1], t[4 * j + 2], t[4 * j + 3]))
            each[j] = frame[0, 0]
            each[_STRIDE + j] = frame[1, 0]
            each[2 * _STRIDE + j] = frame[2, 0]
            each[3 * _STRIDE + j] = frame[0, 1]
            each[4 * _STRIDE + j] = frame[1, 1]
            each[5 * _STRIDE + j] = frame[2, 1]
            rare = rare | wp.where(usable == 0, 1, 0)
            j += 1
        if wp.static(not one_sample):
            for p in range(points):
                first = wp.max(p * count - start, 0)
                end = wp.min((p + 1) * count - start, length)
                for c in range(6):
                    column = wp.array(ptr=frames.ptr + wp.uint64(4 * _STRIDE * c), shape=(_STRIDE,), dtype=wp.float32)
                    repeat_number(each[c * _STRIDE + p], first, end, column)
        return rare

    return write


@once
def _build_frame_reader(tangents: bool) -> wp.Function:
    """Build the wp.func that returns the normal or, with tangents, the tangent frame of the j-th direction in a block."""
    if not tangents:

        @wp.func
        def orient(frames: wp.array[wp.float32], n: wp.vec3, j: wp.int32):
            """Return the unit normal n of the point, which orients the sampled direction."""
            return n

    else:

        @wp.func
        def orient(frames: wp.array[wp.float32], n: wp.vec3, j: wp.int32):
            """Return the tangent frame of the j-th direction in a block: columns x, y and normal."""
            return wp.mat33(
                frames[j], frames[3 * _STRIDE + j], n[0],
                frames[_STRIDE + j], frames[4 * _STRIDE + j], n[1],
                frames[2 * _STRIDE + j], frames[5 * _STRIDE + j], n[2],
            )  # fmt: skip

    return orient


def _lay_out_buffer(one_sample: bool, layout: Layout, tangents: bool) -> tuple[int, int, int, int]:
    """Return the bytes at which repeated normals, frames and columns begin in a task's buffer, and its number of floats.

    For one sample per point, the unit normals of the points are the repeated normals.
    """
    own = 2 * FLAT_BLOCK + (3 if one_sample else 6) * _STRIDE
    frame_floats = (6 if one_sample else 12) * _STRIDE * tangents
    return 4 * (own - 3 * _STRIDE), 4 * own, 4 * (own + frame_floats), own + frame_floats + len(layout) * _STRIDE


@once
def _build_block_filler(
    sequence: Sequence,
    about: wp.Function,
    *,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    one_sample: bool,
    layout: Layout,
    tangents: bool,
) -> wp.Function:
    """Build the wp.func that samples the directions of a block, with a buffer for all that is computed before.

    A block computes unit normals and points u first. If points have several samples, it then copies the normal of each pair
    to the buffer, because a gather from an array that the stores might alias would prevent vectorisation.
    """
    (store, _), redraws, by_point = select_accessors(with_pdf, masked), redraw is not None, bool(layout)
    how = {"redraw": redraw, "redraw_below": redraw_below, "with_pdf": with_pdf, "masked": masked}
    mend = _build_mender(sequence, about, **how, layout=layout, tangents=tangents)
    write_frames, orient = _build_frame_writer(one_sample), _build_frame_reader(tangents)
    write_columns, load = column_writer(layout, _STRIDE), column_loader(layout, _STRIDE)
    write_units, fill = build_unit_writer(masked, _STRIDE, False), _build_block_variates(sequence, one_sample)
    repeated_at, frames_at, columns_at, _ = _lay_out_buffer(one_sample, layout, tangents)

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
        frames = wp.array(ptr=buffer + wp.uint64(frames_at), shape=(6 * _STRIDE,), dtype=wp.float32)
        columns = wp.array(ptr=buffer + wp.uint64(columns_at), shape=(_STRIDE,), dtype=wp.float32)
        if wp.static(tangents):
            rare = rare | write_frames(samples.tangents, point, units, span, count, start, length, frames)
        if wp.static(by_point):
            rare = rare | write_columns(samples.tables, samples.row + point, span, count, start, length, columns.ptr)
        j = wp.int32(0)
        while j < length:
            n = wp.vec3(repeated[j], repeated[_STRIDE + j], repeated[2 * _STRIDE + j])
            parameters = load(samples.parameters, columns, j)
            d = about(orient(frames, n, j), wp.vec2(u[j] + 0.0, u[FLAT_BLOCK + j] + 0.0), parameters)
            store(vectors, pdf, j, d)
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            j += 1
        if rare != 0:
            mend(samples, point, start, length, normals, active, vectors, pdf)

    return fill_block


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
    layout: Layout = (),
    tangents: bool = False,
) -> wp.Kernel:
    """Build the Warp kernel that samples directions block by block, with the same bits as the kernel of `direction_rows`.

    A task computes `rows` blocks of consecutive directions.
    """
    how = {"redraw": redraw, "redraw_below": redraw_below, "with_pdf": with_pdf, "masked": masked}
    shape = {"one_sample": one_sample, "layout": layout, "tangents": tangents}
    fill_block, floats = _build_block_filler(sequence, about, **how, **shape), _lay_out_buffer(**shape)[-1]

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def direction_blocks(samples: Samples, first_task: wp.int64):
        buffer = wp.zeros(shape=(floats,), dtype=wp.float32)
        first = (first_task + wp.int64(wp.tid())) * wp.int64(samples.rows) * _BLOCK
        end = wp.min(first + wp.int64(samples.rows) * _BLOCK, samples.points * wp.int64(samples.count))
        while first < end:
            fill_block(samples, first, buffer.ptr)
            first += _BLOCK

    return direction_blocks
