"""Tangents of face corners from texture coordinates, by MikkTSpace, and tangents of vertices and of faces."""

import numpy as np

from warpsample.host.locks import imported
from warpsample.mesh.mesh import Mesh, unit_or_zero

_NEXT, _PREVIOUS = [1, 2, 0], [2, 0, 1]  # next and previous corner of each corner of a face


def vertex_tangents(mesh: Mesh, uv: np.ndarray) -> np.ndarray:
    """Return tangents (V, 4) float32 of the vertices, as in glTF: a vector and the sign of the bitangent.

    A vertex has the sign of its first face, and the sum of the tangents of its corners with the same sign. The tangent is 0
    for vertices without a face with coordinates.

    Args:
        mesh: mesh with F faces.
        uv: (F, 3, 2) float64 texture coordinates, v downward; NaN for faces without coordinates.
    """
    known = np.flatnonzero(np.isfinite(uv).all(axis=(1, 2)))
    faces = mesh.faces[known]
    normals = mesh.vertex_normals[faces].astype(np.float64)
    found = compute_tangents(mesh.vertices[faces], normals, uv[known]).reshape(-1, 4)
    vertex, first = np.unique(faces.ravel(), return_index=True)
    made = np.zeros((len(mesh.vertices), 4))
    made[:, 3] = 1.0
    made[vertex, 3] = found[first, 3]
    added = np.where((found[:, 3] == made[faces.ravel(), 3])[:, None], found[:, :3], 0.0)
    made[:, :3] = np.stack([np.bincount(faces.ravel(), column, len(made)) for column in added.T], axis=1)
    return made.astype(np.float32)


def face_tangents(mesh: Mesh, uv: np.ndarray, face: np.ndarray) -> np.ndarray:
    """Return tangents (P, 4) float32 of flat faces, as in glTF: the direction of increasing u, and the bitangent's sign.

    The tangent is 0 or NaN where the coordinates define no direction.

    Args:
        mesh: mesh with F faces.
        uv: (F, 3, 2) float64 texture coordinates, v downward; NaN for faces without coordinates.
        face: (P,) numbers of faces.
    """
    along, upright, _ = _compute_u_directions(mesh.vertices[mesh.faces[face]], uv[face])
    return np.column_stack([unit_or_zero(along), np.where(upright, 1.0, -1.0)]).astype(np.float32)


def compute_tangents(position: np.ndarray, normal: np.ndarray, uv: np.ndarray) -> np.ndarray:
    """Return tangents (F, 3, 4) of face corners, as in glTF: a unit vector and the sign of the bitangent.

    The result is that of MikkTSpace for triangles, with default settings (Mikkelsen2008). A corner's tangent is the mean
    over faces that share its position, normal and coordinates, weighted by angle. The faces must be connected by edges and
    have the same orientation in the image. Tangents are 0 where the coordinates define no direction. A face without an area
    in the image takes the orientation of a neighbouring face; the reference takes that of the lowest connected face.

    Args:
        position: (F, 3, 3) corner positions.
        normal: (F, 3, 3) unit corner normals.
        uv: (F, 3, 2) texture coordinates, v downward; bitangents point upward.
    """
    if not len(position):  # bincount of nothing gives integers
        return np.zeros((0, 3, 4))
    rows = np.concatenate([position, normal, uv], axis=2).reshape(-1, 8) + 0.0  # + 0.0 turns -0 into 0
    vertex = np.unique(rows, axis=0, return_inverse=True)[1].reshape(-1, 3)
    own, upright, flat = _compute_u_directions(position, uv)
    upright = _spread_orientation(upright, flat, vertex)
    groups = _group_corners(vertex, upright)
    towards, away = (_remove_normal_part(position[:, i] - position, normal) for i in (_NEXT, _PREVIOUS))
    angle = np.arccos(np.clip((towards * away).sum(axis=2), -1.0, 1.0))
    weight = np.where(flat[:, None], 0.0, angle)[..., None]
    added = (weight * _remove_normal_part(own[:, None], normal)).reshape(-1, 3)
    sums = np.stack([np.bincount(groups, column) for column in added.T], axis=1)
    tangent = unit_or_zero(sums)[groups].reshape(-1, 3, 3).astype(np.float64)
    sign = np.where(upright, 1.0, -1.0)
    return np.concatenate([tangent, np.broadcast_to(sign[:, None, None], (len(uv), 3, 1))], axis=2)


def _remove_normal_part(vectors: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """Return the (F, 3, 3) unit vectors perpendicular to the normals; 0 for vectors along the normal."""
    rest = vectors - (vectors * normal).sum(axis=2, keepdims=True) * normal
    return unit_or_zero(rest.reshape(-1, 3)).reshape(rest.shape).astype(np.float64)


def _compute_u_directions(position: np.ndarray, uv: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the (F, 3) direction of increasing u on each face, and the (F,) masks of unmirrored and of degenerate faces."""
    (ax, ay), (bx, by) = (uv[:, 1] - uv[:, 0]).T, (uv[:, 2] - uv[:, 0]).T
    first, second = position[:, 1] - position[:, 0], position[:, 2] - position[:, 0]
    area = ax * by - ay * bx
    along, down = by[:, None] * first - ay[:, None] * second, ax[:, None] * second - bx[:, None] * first
    flat = (area == 0.0) | ~along.any(axis=1) | ~down.any(axis=1)
    return np.sign(area)[:, None] * along, area < 0.0, flat


def _pair_edges(vertex: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return pairs of face edges that connect neighbouring faces: the same edge in opposite directions.

    Edges are (E,) numbers, 3 * face + first corner. `vertex` is the (F, 3) vertex number of each corner.
    """
    start, end = vertex.ravel(), vertex[:, _NEXT].ravel()
    count = int(vertex.max(initial=0)) + 1
    along, back = start * count + end, end * count + start
    order, other = np.argsort(along, kind="stable"), np.argsort(back, kind="stable")
    rank = np.arange(len(along)) - np.searchsorted(along[order], along[order])  # among edges with the same end vertices
    place = np.searchsorted(back[other], along[order]) + rank
    held = np.minimum(place, len(back) - 1)
    met = (place < len(back)) & (back[other[held]] == along[order])
    return order[met], other[held[met]]


def _spread_orientation(upright: np.ndarray, flat: np.ndarray, vertex: np.ndarray) -> np.ndarray:
    """Return a mask of the faces with unmirrored texture, (F,); degenerate faces are treated like a neighbour."""
    one, other = (edges // 3 for edges in _pair_edges(vertex))
    upright, open_ = upright.copy(), flat.copy()
    while len(found := np.flatnonzero(open_[one] & ~open_[other])[::-1]):
        upright[one[found]] = upright[other[found]]
        open_[one[found]] = False
    return upright


def _group_corners(vertex: np.ndarray, upright: np.ndarray) -> np.ndarray:
    """Return the group of each face corner, (3 F,): corners of neighbouring faces that share a tangent."""
    one, other = _pair_edges(vertex)
    alike = upright[one // 3] == upright[other // 3]
    one, other = one[alike], other[alike]
    after = [edges - edges % 3 + (edges + 1 - edges // 3 * 3) % 3 for edges in (one, other)]
    start, end = np.r_[one, after[0]], np.r_[after[1], other]
    links = imported("scipy.sparse").coo_array((np.ones(len(start), np.bool_), (start, end)), (vertex.size, vertex.size))
    return imported("scipy.sparse.csgraph").connected_components(links, directed=False)[1]
