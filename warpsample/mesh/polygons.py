"""Triangulation of polygons: a fan where the fan lies inside the polygon, else the library earcut.

Fans are computed for all polygons of a file in one step, and most polygons are convex; earcut takes one polygon at a time.
earcut leaves out triangles without area, and all triangles of some self-intersecting polygons. `_cut_polygon` handles both.
"""

from typing import Any

import numpy as np
from mapbox_earcut import triangulate_float64

_COVERS = 1e-9  # relative error of the triangles' total area that rounding can cause


def triangles(points: np.ndarray, counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    """Return (F, 3) vertex indices of triangles: n - 2 for each polygon of n corners, in the polygon's winding and order.

    A polygon that crosses itself is cut as a fan with overlapping triangles.

    Args:
        points: (V, 3) float64 coordinates.
        counts: (P,) number of corners of each polygon, at least 3.
        indices: (K,) point indices of all polygons' corners, one polygon after the other.

    Raises:
        ValueError: Counts with a sum other than K, fewer than three corners, or an index outside `points`.
    """
    if counts.sum() != len(indices):
        raise ValueError(f"the {len(counts):,} faces need {counts.sum():,} corners, but there are {len(indices):,}")
    if (counts < 3).any():
        raise ValueError(f"face {np.argmax(counts < 3)} has {counts[counts < 3][0]} corners, want at least 3")
    if len(indices) and not (indices.min() >= 0 and indices.max() < len(points)):
        outside = (indices < 0) | (indices >= len(points))
        raise ValueError(
            f"a face has the vertex {indices[np.argmax(outside)]:,}, want a vertex from 0 to {len(points) - 1:,}"
        )
    if (counts == 3).all():
        return indices.reshape(-1, 3)
    counts = counts.astype(np.int64)
    faces = _fans(counts, indices)
    starts, ends = np.cumsum(counts) - counts, np.cumsum(counts)
    for polygon in _folded(points, faces, counts):
        corners = indices[starts[polygon] : ends[polygon]]
        first = starts[polygon] - 2 * polygon
        cut = _cut(points[corners])
        if cut is not None:
            faces[first : first + len(cut)] = corners[cut]
    return faces


def corner_triangles(points: np.ndarray, counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    """Triangulate polygons; return each triangle's corners as positions in `indices`, (F, 3)."""
    return triangles(points[indices], counts, np.arange(len(indices)))


def _fans(counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    """Return the (F, 3) triangles of each polygon's fan around its first corner."""
    starts = np.repeat(np.cumsum(counts) - counts, counts - 2)
    step = np.arange(len(starts)) - np.repeat(np.cumsum(counts - 2) - (counts - 2), counts - 2)
    return np.stack([indices[starts], indices[starts + step + 1], indices[starts + step + 2]], axis=1)


def _folded(points: np.ndarray, fans: np.ndarray, counts: np.ndarray) -> np.ndarray:
    """Return the numbers of the polygons that a fan of triangles would not cover correctly, mostly concave polygons."""
    owner = np.repeat(np.arange(len(counts)), counts - 2)
    with np.errstate(all="ignore"):  # `Mesh` reports coordinates that are not finite
        crosses = np.cross(points[fans[:, 1]] - points[fans[:, 0]], points[fans[:, 2]] - points[fans[:, 0]])
        normals = np.add.reduceat(crosses, np.cumsum(counts - 2) - (counts - 2))
        return np.unique(owner[np.einsum("ij,ij->i", crosses, normals[owner]) < 0.0])


def _cut(corners: np.ndarray) -> np.ndarray | None:
    """Triangulate one polygon (n, 3); return (n - 2, 3) corner numbers, or None if the polygon crosses itself.

    In the second case the triangles do not cover the polygon's area. Repeated corners are hidden from earcut: next to
    repeats, earcut drops corners on a straight line, which opens a gap to a neighbouring polygon with the same corners. The
    triangles that are then missing are filled with (0, 0, 0), which has no area.
    """
    flat, whole = _flattened(corners)
    alone = np.flatnonzero((flat != np.roll(flat, 1, axis=0)).any(axis=1))
    found = alone[triangulate_float64(flat[alone], np.array([len(alone)], np.uint32)).reshape(-1, 3)]
    first, second = flat[found[:, 1]] - flat[found[:, 0]], flat[found[:, 2]] - flat[found[:, 0]]
    covered = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]).sum()
    if not abs(covered - whole) <= _COVERS * whole:
        return None
    return np.pad(found, ((0, len(corners) - 2 - len(found)), (0, 0)))


def _flattened(corners: np.ndarray) -> tuple[np.ndarray, float]:
    """Project a polygon along the axis with the largest projected area; return the projection and twice its area.

    The projection (n, 2) is counter-clockwise.
    """
    about = corners - corners[0]
    normal = np.cross(about[1:-1], about[2:]).sum(axis=0)
    axis = int(np.argmax(np.abs(normal)))
    seen = about[:, [(axis + 1) % 3, (axis + 2) % 3]]
    return np.ascontiguousarray(seen if normal[axis] >= 0.0 else seen * (-1.0, 1.0)), abs(normal[axis])


def faces_of_cells(value: Any, argument: str) -> np.ndarray:
    """Return the triangles, quadrilaterals and polygons of a meshio.Mesh as (F, 3) triangles; lines and points are ignored.

    Raises:
        ValueError: Cells of other types, such as tetrahedra, or invalid polygons.
    """
    blocks = [block for block in value.cells if block.type != "vertex" and not block.type.startswith("line")]
    others = sorted({block.type for block in blocks} - {"triangle", "quad", "polygon"})
    if others:
        raise ValueError(f"{argument}: got cells of type {', '.join(others)}, want only triangle, quad and polygon")
    lengths = [np.array([len(face) for face in block.data], np.int64) for block in blocks if len(block.data)]
    corners = [np.concatenate([np.asarray(face) for face in block.data]) for block in blocks if len(block.data)]
    if not corners:
        return np.empty((0, 3), np.int32)
    try:
        return triangles(np.asarray(value.points, np.float64), np.concatenate(lengths), np.concatenate(corners))
    except ValueError as error:
        raise ValueError(f"{argument}: got a meshio.Mesh whose cells are not faces: {error}") from None
