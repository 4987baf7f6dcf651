"""Kernels that apply a function to each vector of an array, for example a density to each direction."""

import warp as wp

from warpsample.distributions.by_point.tables import LANES, Layout, column_loader, column_writer, row_check
from warpsample.distributions.parameters import Parameters
from warpsample.host.locks import once

FLAT_BLOCK = 256
"""Number of vectors in one CPU task: enough to hide the setup, few enough that a rare redraw repeats little work."""


@wp.func
def _read_2(x: wp.array[wp.float32], i: wp.int32) -> wp.vec2:
    """Return the i-th vector of a flat array of 2-vectors."""
    # Adding 0 changes only -0.0. Without the sum LLVM joins the two loads into a short vector and does not vectorise the
    # loop.
    return wp.vec2(x[2 * i] + 0.0, x[2 * i + 1] + 0.0)


@wp.func
def _read_3(x: wp.array[wp.float32], i: wp.int32) -> wp.vec3:
    """Return the i-th vector of a flat array of 3-vectors."""
    return wp.vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2])


@wp.func
def _write_1(y: wp.array[wp.float32], i: wp.int32, value: wp.float32):
    """Write the i-th number of a flat array."""
    y[i] = value


@wp.func
def _write_2(y: wp.array[wp.float32], i: wp.int32, value: wp.vec2):
    """Write the i-th vector of a flat array of 2-vectors."""
    y[2 * i] = value[0]
    y[2 * i + 1] = value[1]


@wp.func
def _write_3(y: wp.array[wp.float32], i: wp.int32, value: wp.vec3):
    """Write the i-th vector of a flat array of 3-vectors."""
    y[3 * i] = value[0]
    y[3 * i + 1] = value[1]
    y[3 * i + 2] = value[2]


_READ = {2: _read_2, 3: _read_3}
_WRITE = {1: _write_1, 2: _write_2, 3: _write_3}


@once
def elementwise(func: wp.Function, width: int, out_width: int) -> wp.Kernel:
    """Build the kernel that applies a function of (vector, parameters) to each vector of an array."""
    read = _READ[width]
    write = _WRITE[out_width]

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def elementwise(
        total: wp.int64,
        block: wp.int32,
        source: wp.uint64,
        target: wp.uint64,
        parameters: Parameters,
        first_task: wp.int64,
    ):
        """Apply the function to one block of vectors of the array `source`, and write the results to `target`."""
        first = (first_task + wp.int64(wp.tid())) * wp.int64(block)
        length = wp.int32(wp.min(wp.int64(block), total - first))
        x = wp.array(ptr=source + wp.uint64(first * wp.int64(4 * width)), shape=(width * length,), dtype=wp.float32)
        y = wp.array(ptr=target + wp.uint64(first * wp.int64(4 * out_width)), shape=(out_width * length,), dtype=wp.float32)
        i = wp.int32(0)
        while i < length:
            write(y, i, func(read(x, i), parameters))
            i += 1

    return elementwise


@wp.func
def _clear_1(y: wp.array[wp.float32], i: wp.int32):
    """Set the i-th number of a flat array to 0."""
    y[i] = 0.0


@wp.func
def _clear_2(y: wp.array[wp.float32], i: wp.int32):
    """Set the i-th vector of a flat array of 2-vectors to 0."""
    _write_2(y, i, wp.vec2(0.0))


@wp.func
def _clear_3(y: wp.array[wp.float32], i: wp.int32):
    """Set the i-th vector of a flat array of 3-vectors to 0."""
    _write_3(y, i, wp.vec3(0.0))


_CLEAR = {1: _clear_1, 2: _clear_2, 3: _clear_3}


@once
def elementwise_by_point(func: wp.Function, width: int, out_width: int, layout: Layout, block: int) -> wp.Kernel:
    """Build the kernel that applies a function of (vector, parameters) to an array, with different parameters per point.

    Each point has `count` consecutive vectors. Points whose parameters are out of range get zeros.
    """
    read, write, clear, stride = _READ[width], _WRITE[out_width], _CLEAR[out_width], block + LANES
    fill, load, check, floats = (
        column_writer(layout, stride),
        column_loader(layout, stride),
        row_check(layout),
        stride * len(layout),
    )

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def elementwise_by_point(
        total: wp.int64,
        count: wp.int32,
        source: wp.uint64,
        target: wp.uint64,
        tables: wp.uint64,
        parameters: Parameters,
        first_task: wp.int64,
    ):
        """Apply the function to one block of vectors of `source`, each with the parameters of its point."""
        buffer = wp.zeros(shape=(floats,), dtype=wp.float32)
        columns = wp.array(ptr=buffer.ptr, shape=(floats,), dtype=wp.float32)
        first = (first_task + wp.int64(wp.tid())) * wp.int64(block)
        length = wp.int32(wp.min(wp.int64(block), total - first))
        point = first / wp.int64(count)
        start = wp.int32(first - point * wp.int64(count))
        points = (start + length - 1) / count + 1
        rare = fill(tables, point, points, count, start, length, buffer.ptr)
        x = wp.array(ptr=source + wp.uint64(first * wp.int64(4 * width)), shape=(width * length,), dtype=wp.float32)
        y = wp.array(ptr=target + wp.uint64(first * wp.int64(4 * out_width)), shape=(out_width * length,), dtype=wp.float32)
        i = wp.int32(0)
        while i < length:
            write(y, i, func(read(x, i), load(parameters, columns, i)))
            i += 1
        if rare != 0:
            for k in range(length):
                if check(load(parameters, columns, k)) != 0:
                    clear(y, k)

    return elementwise_by_point
