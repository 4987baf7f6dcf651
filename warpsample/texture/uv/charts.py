"""Grouping of faces: UV charts (faces connected in the texture) and closed parts of a mesh."""

import numpy as np

from warpsample.host.locks import imported

POINT = 1e-30
"""Length or area of a point, so that nothing is divided by 0."""

_NARROW = 1e-4  # of the longest edge: narrower faces are slivers


def label_charts(corners: np.ndarray) -> np.ndarray:
    """Return the number of each face's UV chart, (F,) int32: faces that share corners in the texture form a chart.

    Faces without coordinates get arbitrary numbers.

    Args:
        corners: (F, 3, k) float64, the values compared at each corner: texture coordinates, or coordinates and positions.
    """
    corner = number_points(corners.reshape(-1, corners.shape[-1]))
    a, b, c = corner.reshape(-1, 3).T
    return connect_nodes(np.r_[a, b], np.r_[b, c], int(corner.max()) + 1)[a].astype(np.int32)


def number_points(points: np.ndarray) -> np.ndarray:
    """Return a number for each point, (n,) int64; equal points of k float64, (n, k), have equal numbers."""
    same = np.ascontiguousarray(np.nan_to_num(points) + 0.0)  # + 0.0 turns -0 into 0
    return np.unique(same.view(f"V{8 * same.shape[1]}").ravel(), return_inverse=True)[1].astype(np.int64)


def find_wide(corners: np.ndarray) -> np.ndarray:
    """Return the mask of faces (F, 3, 3) that are no slivers: at least 1/10,000 as wide as their longest edge is long."""
    corners = corners.astype(np.float64)
    longest = find_longest_edges(corners)
    return (2.0 * find_areas(corners) >= _NARROW * longest**2) & (longest > 0.0)


def find_areas(corners: np.ndarray) -> np.ndarray:
    """Return the areas of faces, (F,), for corners (F, 3, 3)."""
    return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)


def find_flat_areas(corners: np.ndarray) -> np.ndarray:
    """Return the areas of faces in the plane, (F,), for corners (F, 3, 2)."""
    return find_areas(np.pad(corners, ((0, 0), (0, 0), (0, 1))))


def find_longest_edges(corners: np.ndarray) -> np.ndarray:
    """Return the length of the longest edge of each face, (F,), for corners (F, 3, k)."""
    return find_edge_lengths(corners).max(axis=1)


def find_edge_lengths(corners: np.ndarray) -> np.ndarray:
    """Return the lengths of the edges of faces, (F, 3), for corners (F, 3, k); edge i begins at corner i."""
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)


def find_longest_part(corners: np.ndarray, limit: float) -> float:
    """Return the largest diagonal of the boxes of connected faces (F, 3, 3); 0 if none is longer than `limit`."""
    if not len(corners) or np.linalg.norm(np.ptp(corners, axis=(0, 1))) <= limit:
        return 0.0
    longest = float(np.linalg.norm(find_box_sides(corners, label_charts(corners)), axis=1).max())
    return longest if longest > limit else 0.0


def find_box_sides(corners: np.ndarray, label: np.ndarray) -> np.ndarray:
    """Return the sides of the boxes around groups of faces, (groups, k), in the order of the groups' numbers.

    Args:
        corners: (F, 3, k) corners of the faces.
        label: (F,) number of each face's group, at least 0.
    """
    order = np.argsort(label, kind="stable")
    starts = np.flatnonzero(np.diff(label[order], prepend=-1))
    low = np.minimum.reduceat(corners.min(axis=1)[order], starts)
    return np.maximum.reduceat(corners.max(axis=1)[order], starts) - low


def label_closed(faces: np.ndarray) -> np.ndarray:
    """Return the number of the closed part that contains each face, (N,), counted from 0; -1 for faces in open parts.

    In a closed part each edge is used equally often in either direction, so parity is defined. At first, faces are joined
    over edges of two faces: bodies that share a vertex or an edge are counted apart, and may overlap. Then, faces without a
    closed part are joined over vertices, as in two crates that share the faces of a wall.
    """
    found = np.full(len(faces), -1, np.int64)
    for over_edges in (True, False):
        rows = np.flatnonzero(found < 0)
        label = _label_balanced(faces[rows], over_edges)
        found[rows] = np.where(label < 0, -1, label + found.max(initial=-1) + 1)
    return found


def _label_balanced(faces: np.ndarray, over_edges: bool) -> np.ndarray:
    """Return the number of each face's part, (N,); -1 in parts with an edge not used equally often in both directions.

    Args:
        faces: (N, 3) int64 vertices.
        over_edges: True joins faces over edges of two faces with the same orientation; False joins faces over vertices.
    """
    if not len(faces):
        return np.zeros(0, np.int64)
    vertex, corner = np.unique(faces, return_inverse=True)
    faces, count = corner.reshape(faces.shape).astype(np.int64), len(vertex)
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    along, back = start * count + end, end * count + start
    label = _join_over_edges(along, back) if over_edges else _join_over_vertices(start, end, count)
    _, edge = np.unique(np.minimum(along, back), return_inverse=True)
    pairs, pair = np.unique(np.repeat(label, 3) * len(edge) + edge.ravel(), return_inverse=True)
    surplus = np.bincount(pair.ravel(), np.where(along < back, 1, -1), minlength=len(pairs))
    closed = np.ones(int(label.max()) + 1, np.bool_)
    closed[pairs[surplus != 0] // len(edge)] = False
    return np.where(closed, np.cumsum(closed) - 1, -1)[label]


def _join_over_edges(along: np.ndarray, back: np.ndarray) -> np.ndarray:
    """Return the number of each face's part, (N,), if faces are joined by edges that exactly two faces share.

    Args:
        along: (3 N,) keys of the edges of each face in its direction.
        back: (3 N,) keys of the same edges in the other direction.
    """
    order = np.argsort(along, kind="stable")
    known, first, uses = np.unique(along[order], return_index=True, return_counts=True)
    place = np.minimum(np.searchsorted(known, back), len(known) - 1)
    single = (known[place] == back) & (uses[place] == 1) & (uses[np.searchsorted(known, along)] == 1)
    mine = np.flatnonzero(single)
    return connect_nodes(mine // 3, order[first[place[mine]]] // 3, len(along) // 3)


def _join_over_vertices(start: np.ndarray, end: np.ndarray, count: int) -> np.ndarray:
    """Return the number of each face's part, (N,), if faces are joined by common vertices."""
    return connect_nodes(start, end, count)[start[::3]]


def connect_nodes(start: np.ndarray, end: np.ndarray, count: int) -> np.ndarray:
    """Return the number of each node's connected component, (count,), in a graph with edges from `start` to `end`."""
    links = imported("scipy.sparse").coo_array((np.ones(len(start), np.bool_), (start, end)), (count, count))
    return imported("scipy.sparse.csgraph").connected_components(links, directed=False)[1].astype(np.int64)


def add_left_out(
    faces: np.ndarray, kept: np.ndarray, old: np.ndarray, corners: np.ndarray, uv: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return charts of all faces of a mesh: a face left out has the coordinates of one of its vertices, or 0.

    Args:
        faces: (F, 3) vertices of all faces of the mesh.
        kept: (K,) rows of the faces that have charts.
        old: (V2,) vertex of the mesh for each vertex of the charts.
        corners: (K, 3) vertices of the charts, for each face with charts.
        uv: (V2, 2) their coordinates.
    """
    left = np.ones(len(faces), np.bool_)
    left[kept] = False
    if not left.any():
        return old, corners, uv
    place = np.zeros(int(faces.max()) + 1, np.int64)
    place[old] = 1 + np.arange(len(old))
    at = place[faces[left]].max(axis=1)  # any vertex that another face shares
    own = np.concatenate([np.zeros((1, 2)), uv])[at]
    whole = np.empty((len(faces), 3), np.uint32)
    whole[~left] = corners
    whole[left] = len(old) + np.arange(3 * len(at)).reshape(-1, 3)
    return np.concatenate([old, faces[left].ravel()]), whole, np.concatenate([uv, np.repeat(own, 3, axis=0)])


def find_neighbours(numbers: np.ndarray) -> np.ndarray:
    """Return pairs of faces that share an edge, (2, E), for the numbers of each face's corners, (F, 3)."""
    start, end = numbers.ravel(), np.roll(numbers, -1, axis=1).ravel()
    edge = np.minimum(start, end) * (numbers.max(initial=0) + 1) + np.maximum(start, end)
    order = np.argsort(edge, kind="stable")
    pairs = [np.stack([order[:-step], order[step:]])[:, edge[order[step:]] == edge[order[:-step]]] for step in (1, 2)]
    return np.concatenate(pairs, axis=1) // 3
