"""Meshes as xatlas receives them: scaled, and divided into pieces if small faces are far apart."""

from typing import NamedTuple

import numpy as np

from warpsample.texture.uv.charts import (
    find_areas,
    find_longest_edges,
    find_longest_part,
    find_wide,
    label_charts,
    number_points,
)
from warpsample.texture.uv.smooth import divide_smooth

MeshCharts = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Charts of a mesh: (V2,) old vertex of each new vertex, (F, 3) new vertices of each face, and (V2, 2) coordinates."""

NO_CHARTS: MeshCharts = (np.zeros(0, np.uint32), np.zeros((0, 3), np.uint32), np.zeros((0, 2)))
"""Charts of a mesh without faces."""

_DIAGONAL = 1000.0  # diagonal of the scaled meshes: xatlas drops faces with an area below 1e-7
_SMALL = 2.0**-15  # of the diagonal: with narrower faces charts are uneven, and meshes are divided
_SHARE = 1e-3  # of the area: faces with less of it have too few texels to count
_CELL = 2.0**14  # side of the cells whose connected parts become one piece, in widths of small faces
_IMAGE = 1.6  # side of an image by xatlas, in sides of a square with the area of all faces
_APART = 2.0**-20  # steps of positions: xatlas joins vertices less than 1.2e-7 apart, and here only equal ones are joined
_LARGEST = 1e9  # largest diagonal of a scaled piece: xatlas fails at 1e12


class Piece(NamedTuple):
    """Some faces of a mesh, for xatlas.

    Attributes:
        part: number of the mesh.
        rows: (n,) rows of the faces in the mesh.
        old: (k,) vertices in the mesh.
        vertices: (k, 3) float32, scaled positions about the centre of the piece.
        faces: (n, 3) vertices of the faces, as rows of `old`.
    """

    part: int
    rows: np.ndarray
    old: np.ndarray
    vertices: np.ndarray
    faces: np.ndarray


def find_kept(parts: list[tuple[np.ndarray, np.ndarray]]) -> list[np.ndarray]:
    """Return rows of the faces of each mesh for xatlas: all but slivers that would shrink all charts.

    Such slivers are longer than the image at the scale of the other faces, and than all connected other faces.

    Args:
        parts: vertices and faces of each mesh.
    """
    corners = [vertices[faces] for vertices, faces in parts]
    wide = [find_wide(own) for own in corners]
    longest = [find_longest_edges(own) for own in corners]
    others = np.concatenate([own[mask] for own, mask in zip(corners, wide, strict=True)])
    limit = _IMAGE * np.sqrt(find_areas(others).sum()) if len(others) else np.inf
    if max(own.max(initial=0.0) for own in longest) > limit:
        limit = max(limit, find_longest_part(others, limit))
    return [np.flatnonzero(own_wide | (own <= limit)) for own_wide, own in zip(wide, longest, strict=True)]


def divide_meshes(parts: list[tuple[np.ndarray, np.ndarray]]) -> list[Piece]:
    """Return meshes as pieces with one common scale: one piece each, or more if small faces are far apart.

    Smooth surfaces and faces with the same corners are divided, too: see `divide_smooth` and `_divide_repeated`.

    xatlas computes in float32 and drops small faces. A single face 10 km away would spoil the charts of all others.
    Connected faces stay in one piece, so that the borders of charts do not change.

    Args:
        parts: vertices and faces of each mesh.
    """
    whole = _box(np.concatenate([vertices[np.unique(faces)] for vertices, faces in parts]))
    small, diagonal = _find_small_width(parts), _diagonal(whole)
    is_even = small >= _SMALL * diagonal
    groups = [
        (part, vertices, faces, rows)
        for part, (vertices, faces) in enumerate(parts)
        for rows in ([np.arange(len(faces))] if is_even else _group_faces(vertices, faces, _CELL * small))
    ]
    boxes = [whole if is_even else _box(vertices[faces[rows]].reshape(-1, 3)) for _, vertices, faces, rows in groups]
    scale = _DIAGONAL / (diagonal or 1.0) if is_even else min(1.0 / small, _LARGEST / max(map(_diagonal, boxes)))
    found = []
    for (part, vertices, faces, rows), box in zip(groups, boxes, strict=True):
        old, local = np.unique(faces[rows], return_inverse=True)
        local = local.reshape(-1, 3)
        scaled = (vertices[old] - 0.5 * (box[0] + box[1])) * scale
        if find_wide(scaled[local]).any():
            scaled = np.rint(scaled / _APART) * _APART
        scaled = scaled.astype(np.float32)
        for own in _divide_faces(scaled, local):
            used, corners = np.unique(local[own], return_inverse=True)
            found.append(Piece(part, rows[own], old[used], scaled[used], corners.reshape(-1, 3)))
    return found


def _divide_faces(vertices: np.ndarray, faces: np.ndarray) -> list[np.ndarray]:
    """Return rows of faces in groups that xatlas cuts apart from each other."""
    vertices = vertices.astype(np.float64)
    corners, numbers = vertices[faces], number_points(vertices)[faces]
    groups = _divide_repeated(numbers, find_wide(corners))
    return [rows[own] for rows in groups for own in divide_smooth(corners[rows], numbers[rows])]


def _divide_repeated(numbers: np.ndarray, is_wide: np.ndarray) -> list[np.ndarray]:
    """Return rows of faces in groups without two wide faces of the same corners, as in the two sides of a leaf.

    xatlas lays a face given twice on itself, and it joins no faces where four of them share an edge.

    Args:
        numbers: (F, 3) numbers of the corners of each face.
        is_wide: (F,) whether a face is no sliver.
    """
    order = np.lexsort(np.sort(numbers, axis=1).T)
    corner = np.sort(numbers[order], axis=1)
    is_first = (corner != np.roll(corner, 1, axis=0)).any(axis=1) | ~is_wide[order]
    is_first[0] = True
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order)) - np.maximum.accumulate(np.where(is_first, np.arange(len(order)), 0))
    return np.split(np.argsort(rank, kind="stable"), np.cumsum(np.bincount(rank))[:-1])


def join_charts(pieces: list[Piece], charts: list[MeshCharts], count: int) -> list[MeshCharts]:
    """Return the charts of `count` meshes from the charts of all pieces."""
    found: list[list[tuple[Piece, MeshCharts]]] = [[] for _ in range(count)]
    for piece, chart in zip(pieces, charts, strict=True):
        found[piece.part].append((piece, chart))
    return [_join(own) for own in found]


def _join(own: list[tuple[Piece, MeshCharts]]) -> MeshCharts:
    """Return the charts of a mesh from its pieces and their charts."""
    faces, first = np.empty((sum(len(piece.rows) for piece, _ in own), 3), np.uint32), 0
    for piece, (old, corners, _) in own:
        faces[piece.rows] = corners + first
        first += len(old)
    old = np.concatenate([piece.old[chart[0]] for piece, chart in own])
    return old, faces, np.concatenate([chart[2] for _, chart in own])


def _find_small_width(parts: list[tuple[np.ndarray, np.ndarray]]) -> float:
    """Return the width of small faces: the root of an area; all smaller faces have 0.1 % of the whole area together.

    Areas count and not numbers of faces, because a file may have any number of slivers by rounding. Infinite if all faces
    are flat.
    """
    area = np.sort(np.concatenate([find_areas(vertices[faces]) for vertices, faces in parts]))
    total = np.cumsum(area)
    return float(np.sqrt(area[np.searchsorted(total, _SHARE * total[-1], side="right")])) if total[-1] else np.inf


def _group_faces(vertices: np.ndarray, faces: np.ndarray, cell: float) -> list[np.ndarray]:
    """Return the rows of faces in groups: connected parts whose boxes have their centres in one cell of a grid."""
    corners = vertices[faces]
    label = label_charts(corners)
    count = int(label.max()) + 1
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, label, corners.min(axis=1))
    np.maximum.at(high, label, corners.max(axis=1))
    middle = 0.5 * (low + high)
    group = np.unique(np.rint((middle - middle.min(axis=0)) / cell), axis=0, return_inverse=True)[1].ravel()[label]
    return np.split(np.argsort(group, kind="stable"), np.cumsum(np.bincount(group))[:-1])


def _box(points: np.ndarray) -> np.ndarray:
    """Return the lower and the upper corner of the box of some points, (2, 3)."""
    return np.stack([points.min(axis=0), points.max(axis=0)])


def _diagonal(box: np.ndarray) -> float:
    return float(np.linalg.norm(box[1] - box[0]))
