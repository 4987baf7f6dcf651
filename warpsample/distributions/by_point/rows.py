"""Checks of distribution parameters that are arrays with one row per point.

A row that cannot be used becomes NaN, which kernels turn into a status. Arrays are checked in parts, without large copies.
"""

from numbers import Real
from typing import Any

import numpy as np

from warpsample.host.arrays import as_real, as_unit

_PART = 1 << 16  # rows that are checked at a time
_CLOSE = 1e-15  # relative difference of two float64 quotients of the same vector by its length, at most
_EXPORTS = ("__array__", "__array_interface__", "__dlpack__", "__cuda_array_interface__")
_WANTS = {0: "a number, or (P,) numbers, one for each point", 1: "a vector, or (P, 3) vectors, one for each point"}


def is_array(value: Any) -> bool:
    """Return whether a parameter is an array or a list, and so may have one row for each point."""
    if isinstance(value, Real | str | tuple):
        return False
    return (isinstance(value, list) and bool(value)) or any(hasattr(value, name) for name in _EXPORTS)


def as_rows(value: Any, argument: str, dimensions: int) -> np.ndarray | None:
    """Return a parameter as an array if it has one row for each point, or None if it is a constant.

    Raises:
        TypeError: the value is an array, but not of real numbers.
        ValueError: the value has too many dimensions.
    """
    wants = _WANTS.get(dimensions, "a matrix, or (P, 3, 3) matrices, one for each point")
    array = as_real(value, argument, wants)
    if array.ndim <= dimensions:
        return None
    if array.shape[1:] != (3,) * dimensions:
        raise ValueError(f"{argument}: got shape {array.shape}, want {wants}")
    return array


def copy_rows(array: np.ndarray, low: float = -np.inf, high: float = np.inf) -> np.ndarray:
    """Return a read-only float32 copy of an array, with NaN in each row that has a number outside [low, high].

    Infinite numbers are outside. The limits are rounded to float32, as the numbers are.
    """
    with np.errstate(over="ignore"):
        rows = np.array(array, np.float32, order="C")
    low, high = np.float32(low), np.float32(high)
    for start in range(0, len(rows), _PART):
        part = rows[start : start + _PART]
        good = (part >= low) & (part <= high) & np.isfinite(part)
        part[~good.reshape(len(part), -1).all(axis=1)] = np.nan
    return _closed(rows)


def copy_views(array: np.ndarray, below: bool = False, same: Any = None) -> np.ndarray:
    """Return a read-only float32 copy of (P, 3) view directions, scaled to length 1; invalid directions become NaN.

    A row has the same bits as `as_view` of the vector, rounded to float32. With `below`, views may come from below the
    surface. If the copy has the same bits as the array `same`, the result is `same`, and takes no memory of its own.
    """
    shared = isinstance(same, np.ndarray) and same.shape == array.shape
    rows = same if shared else np.empty(array.shape, np.float32)
    for start in range(0, len(rows), _PART):
        part = _views(array[start : start + _PART].astype(np.float64), below)
        if shared and part.tobytes() != same[start : start + _PART].tobytes():
            shared, rows = False, np.empty(array.shape, np.float32)
            rows[:start] = same[:start]
        if not shared:
            rows[start : start + _PART] = part
    return _closed(rows)


def _views(vectors: np.ndarray, below: bool) -> np.ndarray:
    """Return view directions scaled to unit length, float32; NaN for zero, infinite or downward vectors."""
    largest = np.abs(vectors).max(axis=1)
    good = (largest > 0.0) & (largest < np.inf)
    vectors[~good] = np.nan
    scaled = np.ldexp(vectors, -np.frexp(np.where(good, largest, 1.0))[1][:, None])
    unit = scaled / np.sqrt(np.square(scaled).sum(axis=1, keepdims=True))
    if not below:
        unit[unit[:, 2] < 0.0] = np.nan
    rows = unit.astype(np.float32)
    # `as_view` has a more precise length, which matters only next to the middle between two float32 numbers.
    doubtful = ((unit * (1.0 - _CLOSE)).astype(np.float32) != (unit * (1.0 + _CLOSE)).astype(np.float32)).any(axis=1)
    for i in np.flatnonzero(doubtful & ~np.isnan(unit[:, 0])):
        rows[i] = as_unit(vectors[i], "view")
    return rows


def _closed(rows: np.ndarray) -> np.ndarray:
    """Make an array read-only, and return the same array."""
    rows.setflags(write=False)
    return rows
