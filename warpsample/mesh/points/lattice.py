"""Search for the integer lattice points in triangles of the plane, exact on shared edges."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from warpsample.host.engine import check_memory

_AT_A_TIME = 1 << 21  # pairs of a triangle and a lattice point of its bounding box per step
_BYTES_PER_POINT = 96


@dataclass(frozen=True)
class LatticePoints:
    """Points with integer coordinates in triangles of the plane: triangle, coordinates and barycentric weights of each.

    Attributes:
        triangle: (N,) int64 index of the triangle that contains the point.
        place: (N, 2) int64 coordinates of the point.
        weights: (N, 3) float64 barycentric coordinates of the point in the triangle.
    """

    triangle: np.ndarray
    place: np.ndarray
    weights: np.ndarray


def lattice_points(corners: np.ndarray) -> LatticePoints:
    """Return the points with integer coordinates in triangles (N, 3, 2) float64, boundaries included.

    A point on an edge of two triangles is in both. No point falls between two triangles, because both compute the same
    number for a shared edge. Triangles without area have no points.

    Raises:
        MemoryError: The points do not fit into the free memory.
    """
    low, high = np.ceil(corners.min(axis=1)), np.floor(corners.max(axis=1))
    sides = np.maximum(high - low + 1.0, 0.0)
    counts = sides.prod(axis=1)
    check_memory(
        int(counts.sum() * _BYTES_PER_POINT / 2.0), f"grids of {counts.sum() / 2.0:,.0f} points", "widen the spacing"
    )
    found = [_inside(corners, rows, low[rows].astype(np.int64), sides[rows].astype(np.int64)) for rows in _blocks(counts)]
    if not found:
        return LatticePoints(np.empty(0, np.int64), np.empty((0, 2), np.int64), np.empty((0, 3)))
    return LatticePoints(*(np.concatenate(arrays) for arrays in zip(*found, strict=True)))


def _blocks(counts: np.ndarray) -> Iterator[np.ndarray]:
    """Yield groups of triangles that are small enough to be searched for lattice points at once."""
    rows = np.flatnonzero(counts)
    block = (np.cumsum(counts[rows]) // _AT_A_TIME).astype(np.int64)
    yield from np.split(rows, np.flatnonzero(np.diff(block)) + 1) if len(rows) else ()


def _inside(
    corners: np.ndarray, rows: np.ndarray, low: np.ndarray, sides: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the lattice points in the triangles `rows`: triangle, coordinates and barycentric weights of each.

    Their bounding boxes begin at `low` and have `sides` lattice points per axis.
    """
    counts = sides.prod(axis=1)
    pair = np.repeat(np.arange(len(rows)), counts)
    step = np.arange(len(pair)) - np.repeat(np.cumsum(counts) - counts, counts)
    place = low[pair] + np.stack([step % sides[pair, 0], step // sides[pair, 0]], axis=1)
    triangle = rows[pair]
    across = np.stack(
        [_side(corners[triangle, (k + 1) % 3], corners[triangle, (k + 2) % 3], place) for k in range(3)], axis=1
    )
    whole = across.sum(axis=1)
    inside = ((across >= 0.0).all(axis=1) | (across <= 0.0).all(axis=1)) & (whole != 0.0)
    return triangle[inside], place[inside], across[inside] / whole[inside, None]


def _side(start: np.ndarray, end: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Return twice the signed area of the triangle of an edge and a point, (N,): the sign is the side of the edge.

    Reversing the edge only changes the sign, exactly.
    """
    turned = (start[:, 0] > end[:, 0]) | ((start[:, 0] == end[:, 0]) & (start[:, 1] > end[:, 1]))
    a, b = np.where(turned[:, None], end, start), np.where(turned[:, None], start, end)
    cross = (b[:, 0] - a[:, 0]) * (place[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (place[:, 0] - a[:, 0])
    return np.where(turned, -cross, cross)
