"""Polygons cut into triangles: as a fan where it lies inside the polygon, else by ear clipping."""

from typing import Any

import numpy as np


def triangles(points: np.ndarray, counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    """(F, 3) indices: each polygon of n corners as n - 2 triangles of the same winding, in the order of the polygons.

    Args:
        points: (V, 3) float64.
        counts: (P,) corners of each polygon.
        indices: of points, the corners of one polygon after the other.

    Raises:
        ValueError: counts that do not fit the indices, a polygon of fewer than three corners or an index that is no point's.
    """
    if counts.sum() != len(indices):
        raise ValueError(f"its {len(indices):,} corners do not fill its {len(counts):,} faces")
    if (counts < 3).any():
        raise ValueError(f"face {np.argmax(counts < 3)} has {counts[counts < 3][0]} corners")
    if len(indices) and not (indices.min() >= 0 and indices.max() < len(points)):
        outside = (indices < 0) | (indices >= len(points))
        raise ValueError(f"a face has the vertex {indices[np.argmax(outside)]:,}, but they are 0 to {len(points) - 1:,}")
    if (counts == 3).all():
        return indices.reshape(-1, 3)
    counts = counts.astype(np.int64)
    faces = _fans(counts, indices)
    starts, ends = np.cumsum(counts) - counts, np.cumsum(counts)
    for polygon in _folded(points, faces, counts):
        corners = indices[starts[polygon] : ends[polygon]]
        first = starts[polygon] - 2 * polygon
        faces[first : first + len(corners) - 2] = corners[_ears(points[corners])]
    return faces


def _fans(counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    starts = np.repeat(np.cumsum(counts) - counts, counts - 2)
    step = np.arange(len(starts)) - np.repeat(np.cumsum(counts - 2) - (counts - 2), counts - 2)
    return np.stack([indices[starts], indices[starts + step + 1], indices[starts + step + 2]], axis=1)


def _folded(points: np.ndarray, fans: np.ndarray, counts: np.ndarray) -> np.ndarray:
    """The polygons whose fan has flipped triangles: mostly those that are not convex."""
    owner = np.repeat(np.arange(len(counts)), counts - 2)
    with np.errstate(all="ignore"):  # `Mesh` reports coordinates that are not finite
        crosses = np.cross(points[fans[:, 1]] - points[fans[:, 0]], points[fans[:, 2]] - points[fans[:, 0]])
        normals = np.add.reduceat(crosses, np.cumsum(counts - 2) - (counts - 2))
        return np.unique(owner[np.einsum("ij,ij->i", crosses, normals[owner]) < 0.0])


def _ears(corners: np.ndarray) -> list[tuple[int, int, int]]:
    """n - 2 triangles of a polygon (n, 3), by ear clipping; the rest of one that crosses itself becomes a fan."""
    flat, left, found = _flattened(corners), list(range(len(corners))), []
    while len(left) > 3:
        ears = (at for at in range(len(left)) if _is_ear(flat[left], at))
        ear = next(ears, 1)
        found.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        del left[ear]
    return [*found, (left[0], left[1], left[2])]


def _flattened(corners: np.ndarray) -> np.ndarray:
    """The polygon as (n, 2), counter-clockwise, in the plane of the two axes where its area is largest."""
    about = corners - corners[0]
    normal = np.cross(about[1:-1], about[2:]).sum(axis=0)
    axis = int(np.argmax(np.abs(normal)))
    seen = about[:, [(axis + 1) % 3, (axis + 2) % 3]]
    return seen if normal[axis] >= 0.0 else seen * (-1.0, 1.0)


def _is_ear(corners: np.ndarray, at: int) -> bool:
    """Whether corner `at` of (n, 2) is convex and its triangle contains no other corner."""
    a, b, c = corners[at - 1], corners[at], corners[(at + 1) % len(corners)]
    if _turn(a, b, c) <= 0.0:
        return False
    inside = (_turn(a, b, corners) >= 0.0) & (_turn(b, c, corners) >= 0.0) & (_turn(c, a, corners) >= 0.0)
    at_corner = (corners == a).all(axis=1) | (corners == b).all(axis=1) | (corners == c).all(axis=1)
    return not (inside & ~at_corner).any()


def _turn(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Twice the signed area of the triangle abc, positive for a left turn."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])


def faces_of_cells(value: Any, argument: str) -> np.ndarray:
    """The triangles, quadrilaterals and polygons of a meshio.Mesh as triangles; lines and points are ignored.

    Raises:
        ValueError: cells of other kinds, such as tetrahedra, or invalid polygons.
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
