"""Division of smooth surfaces by direction, because xatlas takes any chain of nearly coplanar faces for a plane."""

import numpy as np

from warpsample.texture.uv.charts import connect_nodes

_COPLANAR = 1.1e-4  # 1 - cosine of two neighbours' normals: for xatlas, neighbours below 1e-4 are coplanar
_FLAT = 1e-7  # the same for faces of a plane, by rounding in float32
_TURNED = 0.866  # least cosine with the mean normal, 30 degrees, of surfaces that are not divided
_WEIGHTS = 1.0, 0.97, 0.94  # of the axes, so that a wall at 45 degrees is on one side in spite of rounding


def divide_smooth(vertices: np.ndarray, faces: np.ndarray) -> list[np.ndarray]:
    """Return rows of faces in groups for xatlas: smooth surfaces that turn, by direction, and all other faces together.

    xatlas projects a plane along the normal of its first face. Of a tube with 600 sides, the front lay on the back. So such
    surfaces are divided by the axis nearest to the normals, and the face nearest to this axis comes first.
    """
    normals = _find_normals(vertices, faces)
    rows = np.flatnonzero(normals.any(axis=1))
    pairs = rows[_find_neighbours(vertices, faces[rows])]
    bent = 1.0 - (normals[pairs[0]] * normals[pairs[1]]).sum(axis=1)
    pairs, bent = pairs[:, bent < _COPLANAR], bent[bent < _COPLANAR]
    if not (bent > _FLAT).any():
        return [np.arange(len(faces))]
    label = connect_nodes(pairs[0], pairs[1], len(faces))
    mean = np.column_stack([np.bincount(label, own) for own in normals.T])
    mean /= np.maximum(np.linalg.norm(mean, axis=1), np.finfo(np.float64).tiny)[:, None]
    least = np.ones(len(mean))
    np.minimum.at(least, label[rows], (normals * mean[label]).sum(axis=1)[rows])
    weighted = np.abs(normals) * _WEIGHTS
    axis = weighted.argmax(axis=1)[:, None]
    side = 1 + 2 * axis[:, 0] + (np.take_along_axis(normals, axis, 1)[:, 0] < 0.0)
    side[least[label] > _TURNED] = 0
    closeness = np.take_along_axis(weighted, axis, 1)[:, 0]
    order = np.lexsort((-closeness * (side > 0), label * (side > 0), side))  # other faces keep their order
    return np.split(order, np.flatnonzero(np.diff(side[order])) + 1)


def _find_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the normals of faces, (F, 3), or 0 for faces without an area."""
    edges = vertices[faces[:, 1:]] - vertices[faces[:, :1]]
    normals = np.cross(edges[:, 0], edges[:, 1])
    return normals / np.maximum(np.linalg.norm(normals, axis=1), np.finfo(np.float64).tiny)[:, None]


def _find_neighbours(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return pairs of faces that share an edge, (2, E); vertices at one position count as one."""
    used, local = np.unique(faces, return_inverse=True)
    corners = np.ascontiguousarray(vertices[used] + 0.0)  # + 0.0 turns -0 into 0
    corner = np.unique(corners.view(f"V{corners.itemsize * 3}").ravel(), return_inverse=True)[1][local.reshape(-1, 3)]
    start, end = corner.ravel().astype(np.int64), np.roll(corner, -1, axis=1).ravel().astype(np.int64)
    edge = np.minimum(start, end) * len(used) + np.maximum(start, end)
    order = np.argsort(edge, kind="stable")
    pairs = [np.stack([order[:-step], order[step:]])[:, edge[order[step:]] == edge[order[:-step]]] for step in (1, 2)]
    return np.concatenate(pairs, axis=1) // 3
