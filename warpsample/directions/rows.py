"""Warp kernel that samples directions point by point, for many samples per point and for CUDA."""

from typing import Any

import warp as wp

from warpsample.directions.samples import (
    INVALID_PARAMETER,
    Samples,
    build_orienter,
    build_unit_writer,
    normal_status,
    select_accessors,
)
from warpsample.directions.variates import LANES, fill_variates
from warpsample.distributions.by_point.tables import Layout, row_check, row_loader
from warpsample.distributions.parameters import Parameters
from warpsample.host.locks import once
from warpsample.maths.memory import address_at
from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.record import Sequence

MOST_ROWS = 128
"""Largest number of rows in a CPU task, which share the setup of the loops; a task on CUDA has one row."""


@once
def _build_mover(with_pdf: bool) -> wp.Function:
    """Build the wp.func that copies sampled directions and densities from a temporary buffer to the output arrays."""

    @wp.func
    def move(samples: Samples, at: wp.uint64, length: wp.int32, source: wp.uint64, source_pdf: wp.uint64):
        vectors = wp.array(ptr=source, shape=(3 * length,), dtype=wp.float32)
        pdf = wp.array(ptr=source_pdf, shape=(length,), dtype=wp.float32)
        kept = wp.array(ptr=samples.vectors + at * wp.uint64(12), shape=(3 * length,), dtype=wp.float32)
        k = wp.int32(0)
        while k < 3 * length:
            kept[k] = vectors[k]
            k += 1
        if wp.static(with_pdf):
            kept_pdf = wp.array(ptr=samples.pdf + at * wp.uint64(4), shape=(length,), dtype=wp.float32)
            k = wp.int32(0)
            while k < length:
                kept_pdf[k] = pdf[k]
                k += 1

    return move


@once
def _build_clearer(with_pdf: bool, masked: bool) -> wp.Function:
    """Build the wp.func that writes zero vectors and a status code for a point whose normal or parameters are invalid.

    Without another reason, the reason is a parameter.
    """
    store, weigh = select_accessors(with_pdf, masked)

    @wp.func
    def clear(samples: Samples, point: wp.int64, start: wp.int32, end: wp.int32):
        at = wp.uint64(point)
        normal = wp.array(ptr=samples.normals + at * wp.uint64(12), shape=(1,), dtype=wp.vec3)[0]
        active = wp.array(ptr=samples.active + at, shape=(1,), dtype=wp.uint8)
        status = wp.array(ptr=samples.status + at, shape=(1,), dtype=wp.uint8)
        code = normal_status(normal, weigh(active, 0))
        status[0] = wp.uint8(wp.where(code == 0, INVALID_PARAMETER, code))
        first = at * wp.uint64(samples.count) + wp.uint64(start)
        vectors = wp.array(ptr=samples.vectors + first * wp.uint64(12), shape=(3 * (end - start),), dtype=wp.float32)
        pdf = wp.array(ptr=samples.pdf + first * wp.uint64(4), shape=(end - start,), dtype=wp.float32)
        for k in range(end - start):
            store(vectors, pdf, k, wp.vec4(0.0))

    return clear


@once
def _build_chunk_filler(
    sequence: Sequence,
    about: wp.Function,
    *,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    tangents: bool,
    chunk: int,
) -> wp.Function:
    """Build the wp.func that samples consecutive directions of one point into a temporary buffer.

    Directions that need `redraw` are rare and are replaced in a second pass.
    """
    fill, (store, _), redraws = fill_variates(sequence, chunk), select_accessors(with_pdf, False), redraw is not None
    orientation = wp.mat33 if tangents else wp.vec3

    @wp.func
    def fill_chunk(
        samples: Samples,
        key: wp.vec4ui,
        n: orientation,
        parameters: Parameters,
        first: wp.int32,
        length: wp.int32,
        padded: wp.int32,
        variates: wp.uint64,
        target: wp.uint64,
        target_pdf: wp.uint64,
    ):
        u = wp.array(ptr=variates, shape=(2 * chunk,), dtype=wp.float32)
        vectors = wp.array(ptr=target, shape=(3 * padded,), dtype=wp.float32)
        pdf = wp.array(ptr=target_pdf, shape=(padded,), dtype=wp.float32)
        fill(key, first, padded, wp.uint32(samples.count), u)
        rare = wp.int32(0)
        j = wp.int32(0)
        while j < padded:
            # The sum with 0 stops LLVM from joining the two loads, which would prevent vectorisation.
            d = about(n, wp.vec2(u[j] + 0.0, u[chunk + j] + 0.0), parameters)
            store(vectors, pdf, j, d)
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            j += 1
        if wp.static(redraws):
            if rare != 0:
                for i in range(length):
                    p = wp.vec2(u[i], u[chunk + i])
                    if about(n, p, parameters)[3] < redraw_below:
                        store(vectors, pdf, i, redraw(n, p, parameters))

    return fill_chunk


@once
def _build_row_filler(
    sequence: Sequence, about: wp.Function, *, with_pdf: bool, tangents: bool, chunk: int, **how: Any
) -> wp.Function:
    """Build the wp.func that samples the directions of one point from number `start` to number `end`.

    `buffer` has room for a chunk of points u, and behind them for directions and densities of a chunk whose end is not a
    whole number of lanes. `how` holds `redraw` and `redraw_below` of `direction_rows`.
    """
    fill_chunk = _build_chunk_filler(sequence, about, with_pdf=with_pdf, tangents=tangents, chunk=chunk, **how)
    move, lanes, orientation = _build_mover(with_pdf), min(LANES, chunk), wp.mat33 if tangents else wp.vec3

    @wp.func
    def fill_row(
        samples: Samples,
        key: wp.vec4ui,
        n: orientation,
        parameters: Parameters,
        point: wp.int64,
        start: wp.int32,
        end: wp.int32,
        buffer: wp.uint64,
    ):
        spare = buffer + wp.uint64(8 * chunk)
        row = wp.uint64(point) * wp.uint64(samples.count)
        for first in range(start, end, chunk):
            length = wp.min(chunk, end - first)
            padded = (length + lanes - 1) / lanes * lanes
            at = row + wp.uint64(first)
            target = wp.where(length == padded, samples.vectors + at * wp.uint64(12), spare)
            target_pdf = wp.where(length == padded, samples.pdf + at * wp.uint64(4), spare + wp.uint64(12 * chunk))
            fill_chunk(samples, key, n, parameters, first, length, padded, buffer, target, target_pdf)
            if length != padded:
                move(samples, at, length, target, target_pdf)

    return fill_row


@once
def _build_key_function(sequence: Sequence, own_ids: bool) -> wp.Function:
    """Build the wp.func that returns the random key of a point, derived from the point's id."""
    key_of, run_with = sequence.key, sequence.run
    if own_ids:

        @wp.func
        def point_key(samples: Samples, point: wp.int64) -> wp.vec4ui:
            id = address_at(samples.ids, point)
            return key_of(run_with(samples.seed, high_word(id)), low_word(id))

    else:

        @wp.func
        def point_key(samples: Samples, point: wp.int64) -> wp.vec4ui:
            return key_of(samples.run, samples.first_point + wp.uint32(point))

    return point_key


@once
def direction_rows(
    sequence: Sequence,
    about: wp.Function,
    *,
    redraw: wp.Function | None,
    redraw_below: float,
    with_pdf: bool,
    masked: bool,
    own_ids: bool = False,
    layout: Layout = (),
    tangents: bool = False,
    chunk: int,
) -> wp.Kernel:
    """Build the Warp kernel that samples directions in tasks of `rows` points with `segment` samples each.

    Tasks of several points hold all `count` samples of each point.

    Args:
        sequence: sequence of the points u.
        about: wp.func (unit normal, u, Parameters) -> (direction, pdf), with `tangents` of a frame in place of the normal.
        redraw: replacement for `about`, with the same signature, where the pdf is below `redraw_below` and `about` is
            imprecise; None if not needed.
        redraw_below: pdf below which `redraw` replaces `about`.
        with_pdf: whether to store the pdf.
        masked: whether to read the mask `active`.
        own_ids: whether the points have user-defined ids, `Samples.ids`.
        layout: parameters by point.
        tangents: whether the points have tangents, `Samples.tangents`.
        chunk: number of samples whose points u are computed ahead of the directions, CHUNK or 1.
    """
    how = {"redraw": redraw, "redraw_below": redraw_below, "with_pdf": with_pdf, "tangents": tangents, "chunk": chunk}
    fill_row, clear = _build_row_filler(sequence, about, **how), _build_clearer(with_pdf, masked)
    load, check, orient = row_loader(layout), row_check(layout), build_orienter(tangents)
    key_of, most_rows = _build_key_function(sequence, own_ids), MOST_ROWS if chunk > 1 else 1
    write_units, floats = build_unit_writer(masked, most_rows, True), 6 * chunk + 4 * most_rows

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def direction_rows(samples: Samples, first_task: wp.int64):
        # Views instead of local arrays: the compiler assumes that the loops may overwrite the address of a local array.
        buffer = wp.zeros(shape=(floats,), dtype=wp.float32)
        units = wp.array(ptr=buffer.ptr + wp.uint64(24 * chunk), shape=(4 * most_rows,), dtype=wp.float32)
        segments = wp.int64((samples.count + samples.segment - 1) / samples.segment)
        first_segment = (first_task + wp.int64(wp.tid())) * wp.int64(samples.rows)
        rows = wp.int32(wp.min(wp.int64(samples.rows), samples.points * segments - first_segment))
        first_point = first_segment / segments
        normals = wp.array(ptr=samples.normals + wp.uint64(first_point) * wp.uint64(12), shape=(3 * rows,), dtype=wp.float32)
        active = wp.array(ptr=samples.active + wp.uint64(first_point), shape=(rows,), dtype=wp.uint8)
        write_units(normals, active, rows, units)
        start = wp.int32(first_segment - first_point * segments) * samples.segment
        end = wp.min(start + samples.segment, samples.count)
        for k in range(rows):
            point = first_point + wp.int64(k)
            n = wp.vec3(units[k], units[most_rows + k], units[2 * most_rows + k])
            key = key_of(samples, point)
            parameters = load(samples.parameters, samples.tables, samples.row + point)
            if wp.abs(units[3 * most_rows + k]) < 0.1 and check(parameters) == 0:
                fill_row(samples, key, orient(samples, point, n), parameters, point, start, end, buffer.ptr)
            else:
                clear(samples, point, start, end)

    return direction_rows
