"""Poisson-disk sampling: random points on a surface are thinned until all have a minimum distance.

The order of the points alone determines the result: a point is accepted if no earlier accepted point is within the distance.
Parallel rounds decide each point whose earlier neighbours are decided (Blelloch2012). So the result is that of the
sequential method for any number of threads.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import check_memory, run
from warpsample.host.locks import once

if TYPE_CHECKING:
    from warpsample.mesh.surface import SurfacePoints

_DARTS = 16  # random points per accepted point; with infinitely many the distance would be 1.09 times as large
_FILLED = 0.585  # measured: accepted points * distance^2 / area for this number of darts; the search starts with it
_BYTES_PER_DART = 150
_ROUNDS, _TOO_MANY = 20, 1.003  # largest number of tries of a distance; accepted / requested points that ends the search
_OPPOSITE = wp.constant(wp.float32(-0.5))  # cosine: points on two sides of a thin sheet may be close
_OPEN, _STAYS, _GOES = 0, 1, 2


def darts_for(count: int | None, radius: float | None, area: float) -> int:
    """Return the number of random points to thin for a requested count or distance.

    Raises:
        MemoryError: The points do not fit into the free memory.
    """
    darts = _DARTS * (count if count is not None else _FILLED * area / radius**2 if radius else 0.0)
    check_memory(int(darts * _BYTES_PER_DART), f"{darts:,.0f} points to choose from", "take fewer, or a larger radius")
    return max(int(darts), 64)


def thinned(points: "SurfacePoints", count: int | None, radius: float | None, area: float, workers: int) -> np.ndarray:
    """Return the rows of the random points to keep, ascending, so that all kept points have a minimum distance.

    With `radius`, that is the distance. With `count`, the distance is searched for, as large as possible for `count` points.
    """

    def select_rows(distance: float) -> np.ndarray:
        """Return the rows of the points to keep for a minimum distance."""
        return np.flatnonzero(_stay(points, distance, workers))

    if count is None:
        assert radius is not None
        return select_rows(radius)
    return _distance_of(count, np.sqrt(_FILLED * area / count), select_rows)[:count]


def _distance_of(count: int, guess: float, select_rows: Callable[[float], np.ndarray]) -> np.ndarray:
    """Search for the largest minimum distance that keeps at least `count` points; return the rows of the kept points."""
    low, high, best = 0.0, np.inf, None
    distance = guess
    for _ in range(_ROUNDS):
        rows = select_rows(distance)
        if len(rows) >= count:
            low, best = distance, rows
            if len(rows) <= _TOO_MANY * count:
                break
        else:
            high = distance
        foretold = distance * np.sqrt(max(len(rows), 1) / (count * (1.0 + _TOO_MANY) / 2.0))
        distance = foretold if low < foretold < high else 2.0 * low if np.isinf(high) else (low + high) / 2.0
    return select_rows(0.0) if best is None else best


def _stay(points: "SurfacePoints", distance: float, workers: int) -> np.ndarray:
    """Return a mask of the points to keep so that all kept points have a minimum distance, (N,) bool."""
    count = len(points)
    if not distance > 0.0:
        return np.ones(count, bool)
    position = points.position - points.position.min(axis=0)
    order, runs = _neighbours(position, distance)
    arrays = [position[order], points.normal[order], order.astype(np.int32), runs]
    inputs = [_array(a, kind) for a, kind in zip(arrays, (wp.vec3d, wp.vec3, wp.int32, wp.int32), strict=True)]
    state, after = np.zeros(count, np.uint8), np.zeros(count, np.uint8)
    while (state == _OPEN).any():
        given = [distance * distance, *inputs, _array(state, wp.uint8), _array(after, wp.uint8)]
        run(settle(), count, given, cpu(), workers=workers, work=16 * count)
        state, after = after, state
    found = np.zeros(count, bool)
    found[order] = state == _STAYS
    return found


def _array(values: np.ndarray, kind: Any) -> wp.array:
    return wp.array(values, dtype=kind, device=cpu(), copy=False)


def _neighbours(position: np.ndarray, distance: float) -> tuple[np.ndarray, np.ndarray]:
    """Sort points (N, 3) by grid cells as wide as the distance, and find the points in the cells around each point.

    Returns:
        The sorted order (N,), and (N, 18) int32 start and end rows of nine runs of cells around each point.

    Raises:
        ValueError: A distance so small that the number of grid cells exceeds int64.
    """
    with np.errstate(over="ignore"):
        cell = np.floor(position / distance) + 1.0
    sides = cell.max(axis=0) + 2.0
    if sides.prod() > 2.0**62:
        raise ValueError(f"radius: got {distance:g}, which is too small for the size of the mesh, want a larger radius")
    cell, sides = cell.astype(np.int64), sides.astype(np.int64)
    key = (cell[:, 2] * sides[1] + cell[:, 1]) * sides[0] + cell[:, 0]
    order = np.argsort(key, kind="stable")
    cells, first, of_point = np.unique(key[order], return_index=True, return_inverse=True)
    ends = np.append(first, len(key))
    runs = np.empty((len(cells), 9, 2), np.int32)
    for k, (y, z) in enumerate(np.ndindex(3, 3)):
        middle = cells + ((z - 1) * sides[1] + (y - 1)) * sides[0]
        runs[:, k, 0] = ends[np.searchsorted(cells, middle - 1)]
        runs[:, k, 1] = ends[np.searchsorted(cells, middle + 1, side="right")]
    return order, runs.reshape(-1, 18)[of_point]


@once
def settle() -> wp.Kernel:
    """Build the kernel of one round of thinning: each point is accepted, rejected, or left for the next round."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def settle(
        distance_squared: wp.float64,
        position: wp.array[wp.vec3d],
        normal: wp.array[wp.vec3],
        order: wp.array[wp.int32],
        runs: wp.array2d[wp.int32],
        state: wp.array[wp.uint8],
        after: wp.array[wp.uint8],
        first_task: wp.int64,
    ):
        i = wp.int32(first_task) + wp.tid()
        found = wp.int32(state[i])
        if found == 0:
            found = wp.int32(1)
            for k in range(9):
                for j in range(runs[i, 2 * k], runs[i, 2 * k + 1]):
                    if found != 2 and order[j] < order[i] and state[j] != wp.uint8(2):
                        way = position[j] - position[i]
                        if wp.dot(way, way) < distance_squared and wp.dot(normal[j], normal[i]) > _OPPOSITE:
                            found = wp.where(state[j] == wp.uint8(1), 2, 0)
        after[i] = wp.uint8(found)

    return settle
