"""Division of smooth surfaces by direction, because xatlas takes any chain of nearly coplanar faces for a plane."""

import numpy as np

from warpsample.texture.uv.charts import connect_nodes

_COPLANAR = 1.1e-4  # 1 - cosine of two neighbours' normals: for xatlas, neighbours below 1e-4 are coplanar
_FLAT = 1e-7  # the same for faces of a plane, by rounding in float32
_TURNED = 0.64  # least cosine with the mean normal, 50 degrees, of surfaces that are not divided


def divide_smooth(vertices: np.ndarray, faces: np.ndarray) -> list[np.ndarray]:
    """Return rows of faces in groups for xatlas: smooth surfaces that turn, by direction, and all other faces together.

    xatlas projects a plane along the normal of its first face. Of a tube with 600 sides, the front lay on the back. So such
    surfaces are divided by the axis nearest to the normals, and a middle face of each surface comes first.
    """
    edges = vertices[faces[:, 1:]] - vertices[faces[:, :1]]
    normals = np.cross(edges[:, 0], edges[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), np.finfo(np.float64).tiny)[:, None]
    pairs = _find_neighbours(vertices, faces)
    bent = 1.0 - (normals[pairs[0]] * normals[pairs[1]]).sum(axis=1)
    pairs, bent = pairs[:, bent < _COPLANAR], bent[bent < _COPLANAR]
    if not (bent > _FLAT).any():
        return [np.arange(len(faces))]
    label, cosine = _label_surfaces(pairs, normals)
    least = np.ones(label.max() + 1)
    np.minimum.at(least, label, cosine)
    axis = np.abs(normals).argmax(axis=1)
    side = 1 + 2 * axis + (normals[np.arange(len(faces)), axis] < 0.0)
    side[least[label] > _TURNED] = 0
    part, cosine = _label_surfaces(pairs[:, side[pairs[0]] == side[pairs[1]]], normals)
    order = np.lexsort((-cosine * (side > 0), part * (side > 0), side))  # other faces keep their order
    return np.split(order, np.flatnonzero(np.diff(side[order])) + 1)


def _find_neighbours(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return pairs of faces that share an edge, (2, E); vertices at one position count as one."""
    rows = np.ascontiguousarray(vertices + 0.0)  # + 0.0 turns -0 into 0
    corner = np.unique(rows.view(f"V{rows.itemsize * 3}").ravel(), return_inverse=True)[1][faces].astype(np.int64)
    start, end = corner.ravel(), np.roll(corner, -1, axis=1).ravel()
    edge = np.minimum(start, end) * len(vertices) + np.maximum(start, end)
    order = np.argsort(edge, kind="stable")
    is_shared = edge[order[1:]] == edge[order[:-1]]
    return np.stack([order[:-1], order[1:]])[:, is_shared] // 3


def _label_surfaces(pairs: np.ndarray, normals: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the surface of each face, if pairs of faces are joined, and its cosine with the surface's mean normal."""
    label = connect_nodes(pairs[0], pairs[1], len(normals))
    mean = np.column_stack([np.bincount(label, own) for own in normals.T])
    mean /= np.maximum(np.linalg.norm(mean, axis=1), np.finfo(np.float64).tiny)[:, None]
    return label, (normals * mean[label]).sum(axis=1)
