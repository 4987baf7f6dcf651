"""Access of kernels to distribution parameters that differ from point to point.

Terms:
    table: (P, ...) float32 array of one parameter, with one row for each point. Rows out of range hold NaN.
    tables: address of an array with the addresses of all tables of a call.
    column: float32 numbers of one component of a parameter, one for each vector of a block, in a local buffer.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsample.distributions.parameters import Parameters, number_at, number_setter
from warpsample.host.device_memory import Loan
from warpsample.host.locks import once
from warpsample.maths.memory import address_at, float_at

LANES = 8
"""Numbers that a column has room for beyond a block: the float32 lanes of an AVX2 vector."""


@dataclass(frozen=True)
class Column:
    """Number that differs from point to point: its position among the parameters, and the array that holds it.

    Attributes:
        number: index in `Parameters`.
        table: index of the table.
        width: number of float32 in a row of the table.
        component: index in a row of the table.
    """

    number: int
    table: int
    width: int
    component: int


Layout = tuple[Column, ...]
"""Columns of a distribution. Kernels are keyed by the layout and never by values; it is empty for constant parameters."""


def tables_in(values: tuple[Any, ...]) -> list[np.ndarray]:
    """Return the arrays with a row per point among the values of parameters."""
    return [value for value in values if isinstance(value, np.ndarray)]


def count_numbers(values: tuple[Any, ...]) -> int:
    """Return the number of float32 numbers that the values of parameters take in the struct `Parameters`."""
    return sum(_width(value) for value in values)


def _width(value: Any) -> int:
    """Return the number of float32 numbers of a parameter: of each row of a table, or of a constant."""
    return int(np.prod(value.shape[1:])) if isinstance(value, np.ndarray) else np.size(value)


def layout_of(values: tuple[Any, ...]) -> Layout:
    """Return a `Column` for each number that differs from point to point, given the values of all parameters."""
    columns, number, table = [], 0, 0
    for value in values:
        by_point = isinstance(value, np.ndarray)
        width = _width(value)
        if by_point:
            columns += [Column(number + c, table, width, c) for c in range(width)]
            table += 1
        number += width
    return tuple(columns)


def without_tables(values: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return the values of parameters with zeros in place of arrays with a row per point."""
    return tuple(tuple([0.0] * _width(v)) if isinstance(v, np.ndarray) else v for v in values)


def lend_tables(loan: Loan, tables: list[np.ndarray], rows: slice) -> int:
    """Copy arrays of parameters to the device if necessary; return the address of the array of their addresses, or 0."""
    if not tables:
        return 0
    if loan.memory.in_place and not loan.memory.device.is_cpu:  # normals in a wp.array on CUDA: tables need a copy there
        owned = [wp.array(table, dtype=wp.float32, device=loan.memory.device) for table in tables]
        addresses = np.array([loan.lend(table) for table in owned], np.uint64)
        return loan.lend(wp.array(addresses, dtype=wp.uint64, device=loan.memory.device))
    return loan.lend(np.array([loan.lend(table, rows) for table in tables], np.uint64))


@once
def row_loader(layout: Layout) -> wp.Function:
    """Build the wp.func that returns the parameters of one point, taken from its row of the arrays."""
    if not layout:

        @wp.func
        def load(parameters: Parameters, tables: wp.uint64, row: wp.int64):
            """Return the parameters unchanged, since none differs between points."""
            return parameters

        return load

    before, last = row_loader(layout[:-1]), layout[-1]
    replace, table, width, component = number_setter(last.number), last.table, last.width, last.component

    @wp.func
    def load(parameters: Parameters, tables: wp.uint64, row: wp.int64):
        """Return the parameters of the point with number `row`, taken from its row of the arrays."""
        value = float_at(address_at(tables, table), row * wp.int64(width) + wp.int64(component))
        return replace(before(parameters, tables, row), value)

    return load


@once
def row_check(layout: Layout) -> wp.Function:
    """Build the wp.func that returns 1 if a parameter of a point is NaN (out of range), else 0."""
    if not layout:

        @wp.func
        def check(parameters: Parameters):
            """Return 0, since constant parameters are checked when the distribution is created."""
            return wp.int32(0)

        return check

    before, number = row_check(layout[:-1]), layout[-1].number

    @wp.func
    def check(parameters: Parameters):
        """Return 1 if any parameter of a point is NaN (out of range), else 0."""
        value = number_at(parameters, number)
        return before(parameters) | wp.where(value == value, 0, 1)

    return check


@once
def column_loader(layout: Layout, stride: int) -> wp.Function:
    """Build the wp.func that returns the parameters of the j-th direction in a block, taken from the block's columns."""
    if not layout:

        @wp.func
        def load(parameters: Parameters, columns: wp.array[wp.float32], j: wp.int32):
            """Return the parameters unchanged, since none differs between the directions of a block."""
            return parameters

        return load

    before, replace, at = column_loader(layout[:-1], stride), number_setter(layout[-1].number), stride * (len(layout) - 1)

    @wp.func
    def load(parameters: Parameters, columns: wp.array[wp.float32], j: wp.int32):
        """Return the parameters of the j-th direction in a block, taken from the block's columns."""
        return replace(before(parameters, columns, j), columns[at + j])

    return load


@wp.func
def repeat_number(value: wp.float32, first: wp.int32, end: wp.int32, column: wp.array[wp.float32]):
    """Fill the entries from `first` to `end` of a column with a number; up to 7 entries more may be overwritten."""
    for m in range(first, end, LANES):
        at = wp.array(ptr=column.ptr + wp.uint64(4 * m), shape=(LANES,), dtype=wp.float32)
        for k in range(LANES):
            at[k] = value


@once
def column_writer(layout: Layout, stride: int) -> wp.Function:
    """Build the wp.func that copies the parameters of a block's points to columns with one entry for each direction.

    The function returns 1 if a parameter is NaN, else 0.

    The block holds `length` vectors from number `start` on, with `count` consecutive vectors for each of `points` points.
    Their rows begin at `row`. A column has room for `stride` numbers, 8 more than a block.
    """
    if not layout:

        @wp.func
        def write(
            tables: wp.uint64,
            row: wp.int64,
            points: wp.int32,
            count: wp.int32,
            start: wp.int32,
            length: wp.int32,
            columns: wp.uint64,
        ):
            """Do nothing and return 0, since constant parameters need no columns."""
            return wp.int32(0)

        return write

    before, last = column_writer(layout[:-1], stride), layout[-1]
    table, width, component, offset = last.table, last.width, last.component, 4 * stride * (len(layout) - 1)

    @wp.func
    def write(
        tables: wp.uint64,
        row: wp.int64,
        points: wp.int32,
        count: wp.int32,
        start: wp.int32,
        length: wp.int32,
        columns: wp.uint64,
    ):
        """Write the parameters of a block's points to columns; return 1 if any parameter is NaN, else 0."""
        rare = before(tables, row, points, count, start, length, columns)
        source = address_at(tables, table) + wp.uint64(row) * wp.uint64(4 * width) + wp.uint64(4 * component)
        values = wp.array(ptr=source, shape=(width * points,), dtype=wp.float32)
        column = wp.array(ptr=columns + wp.uint64(offset), shape=(stride,), dtype=wp.float32)
        if count == 1:
            i = wp.int32(0)
            while i < length:
                value = values[width * i]
                column[i] = value
                rare = rare | wp.where(value == value, 0, 1)
                i += 1
        else:
            for p in range(points):
                value = values[width * p]
                begin = wp.int64(p) * wp.int64(count) - wp.int64(start)
                end = wp.int32(wp.min(begin + wp.int64(count), wp.int64(length)))
                repeat_number(value, wp.int32(wp.max(begin, wp.int64(0))), end, column)
                rare = rare | wp.where(value == value, 0, 1)
        return rare

    return write
