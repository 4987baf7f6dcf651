"""Multiplication of a sky matrix by radiances of the sky patches, in float64.

The order of summation is fixed, so that a row's result does not depend on the other rows. A library's matrix product is as
fast, but its last bits depend on the number of rows.
"""

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.maths.numerics import ZERO

_ROWS = 8  # per task: each number of the sky is loaded once for all of them
_COLUMNS = 64  # at a time
_ROWS_IN_KERNEL = wp.constant(wp.int32(_ROWS))
_SUMS = 2 * _ROWS * _COLUMNS


@wp.struct
class Fold:
    """Kernel argument of the multiplication of a sky matrix by weights: numbers, and addresses of arrays.

    value, error: (rows, patches) float32. points: (rows,) int64, the result's row of each row. weights: (patches, columns)
    float64. sums, errors: (P, columns) float32.
    """

    rows: wp.int64
    patches: wp.int32
    columns: wp.int32
    value: wp.uint64
    error: wp.uint64
    points: wp.uint64
    weights: wp.uint64
    sums: wp.uint64
    errors: wp.uint64


FoldArgs = type(Fold().__ctype__())


def fold_rows(
    value: np.ndarray, error: np.ndarray, points: np.ndarray, *, weights: np.ndarray, out: list[np.ndarray], workers: int
) -> None:
    """Multiply rows of a sky matrix by weights of the patches, and write the products and their standard errors to `out`.

    Errors of patches are taken as independent.

    Args:
        value: (B, K) float32, rows of the matrix.
        error: (B, K) float32, standard errors of `value`.
        points: (B,) int64, the row of `out` for each row of `value`.
        weights: (K, T) float64, contiguous: T skies.
        out: the arrays to write, sums and errors, (P, T) float32 each.
        workers: number of CPU threads.
    """
    fold = FoldArgs(rows=len(points), patches=weights.shape[0], columns=weights.shape[1])
    fold.value, fold.error, fold.points, fold.weights = (a.ctypes.data for a in (value, error, points, weights))
    fold.sums, fold.errors = (array.ctypes.data for array in out)
    run(
        _fold_kernel(),
        -(-len(points) // _ROWS),
        [fold],
        cpu(),
        workers=workers,
        work=len(points) * weights.size // _ROWS + 1,
    )


@wp.func
def _add(weights: wp.uint64, length: wp.int32, factor: wp.float64, sums: wp.uint64):
    """Add factor * weights[i] to sums[i], for `length` numbers."""
    w = wp.array(ptr=weights, shape=(_COLUMNS,), dtype=wp.float64)
    total = wp.array(ptr=sums, shape=(_COLUMNS,), dtype=wp.float64)
    i = wp.int32(0)
    while i < length:
        total[i] = total[i] + factor * w[i]
        i += 1


@wp.func
def _add_squares(weights: wp.uint64, length: wp.int32, factor: wp.float64, sums: wp.uint64):
    """Add (factor * weights[i])^2 to sums[i], for `length` numbers."""
    w = wp.array(ptr=weights, shape=(_COLUMNS,), dtype=wp.float64)
    total = wp.array(ptr=sums, shape=(_COLUMNS,), dtype=wp.float64)
    i = wp.int32(0)
    while i < length:
        x = factor * w[i]
        total[i] = total[i] + x * x
        i += 1


@once
def _fold_kernel() -> wp.Kernel:
    """Build the kernel that multiplies rows of a sky matrix by weights of the patches, _ROWS rows per task."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def fold_sky(fold: Fold, first_task: wp.int64):
        sums = wp.zeros(shape=(_SUMS,), dtype=wp.float64)
        begin = (first_task + wp.int64(wp.tid())) * wp.int64(_ROWS_IN_KERNEL)
        rows = wp.int32(wp.min(wp.int64(_ROWS_IN_KERNEL), fold.rows - begin))
        at = wp.uint64(begin) * wp.uint64(fold.patches) * wp.uint64(4)
        value = wp.array(ptr=fold.value + at, shape=(rows * fold.patches,), dtype=wp.float32)
        error = wp.array(ptr=fold.error + at, shape=(rows * fold.patches,), dtype=wp.float32)
        points = wp.array(ptr=fold.points + wp.uint64(begin) * wp.uint64(8), shape=(rows,), dtype=wp.int64)
        for first in range(0, fold.columns, _COLUMNS):
            length = wp.min(_COLUMNS, fold.columns - first)
            for i in range(_SUMS):
                sums[i] = ZERO
            for k in range(fold.patches):
                place = wp.uint64(k) * wp.uint64(fold.columns) + wp.uint64(first)
                weights = fold.weights + place * wp.uint64(8)
                for row in range(rows):
                    x = wp.float64(value[row * fold.patches + k])
                    e = wp.float64(error[row * fold.patches + k])
                    there = sums.ptr + wp.uint64(row) * wp.uint64(16 * _COLUMNS)
                    if x != ZERO:
                        _add(weights, length, x, there)
                    if e != ZERO:
                        _add_squares(weights, length, e, there + wp.uint64(8 * _COLUMNS))
            for row in range(rows):
                place = (wp.uint64(points[row]) * wp.uint64(fold.columns) + wp.uint64(first)) * wp.uint64(4)
                total = wp.array(ptr=fold.sums + place, shape=(length,), dtype=wp.float32)
                deviation = wp.array(ptr=fold.errors + place, shape=(length,), dtype=wp.float32)
                for i in range(length):
                    total[i] = wp.float32(sums[2 * row * _COLUMNS + i])
                    deviation[i] = wp.float32(wp.sqrt(sums[(2 * row + 1) * _COLUMNS + i]))

    return fold_sky
