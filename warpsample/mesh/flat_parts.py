"""Flat parts of a mesh: neighbouring faces in one plane, with axes in it."""

import numpy as np

from warpsample.host.locks import imported
from warpsample.mesh.mesh import Mesh

_ALIKE = 1.0 - 1.5e-6  # cosine: 0.1 degrees
_LEVEL = 1e-3  # sine of the angle to up, below which a plane is level


def flat_parts(mesh: Mesh, rows: np.ndarray, upward: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The flat part of each of some faces, and two axes of each part.

    Args:
        mesh: whose faces with an area share vertices where they are neighbours.
        rows: (N,) faces that have an area.
        upward: (3,) a unit vector.

    Returns:
        (N,) the number of each face's part, and the axes of each part, (K, 3) each, see `axes_in_plane`.
    """
    normal = mesh.face_normals[rows].astype(np.float64)
    part = _joined(mesh.faces[rows].astype(np.int64), normal, len(mesh.vertices))
    mean = np.zeros((part.max() + 1, 3))
    np.add.at(mean, part, normal * mesh.face_areas[rows][:, None])
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    return part, *axes_in_plane(mean, upward)


def axes_in_plane(normal: np.ndarray, upward: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two axes (K, 3) in planes of normals (K, 3): a level one, in a level plane that nearest to +x, and that to its left.

    Where x itself points up, it is y that the level one is nearest to.
    """
    level = np.cross(upward, normal)
    near = np.eye(3)[0 if abs(upward[0]) < 0.9 else 1]
    along = near - (normal @ near)[:, None] * normal
    x = np.where(np.linalg.norm(level, axis=1, keepdims=True) < _LEVEL, along, level)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    return x, np.cross(normal, x)


def _joined(faces: np.ndarray, normal: np.ndarray, vertices: int) -> np.ndarray:
    """(N,), the part of each face: those are joined that share an edge with no third one, and a plane."""
    sparse, graph = imported("scipy.sparse"), imported("scipy.sparse.csgraph")
    ends = np.sort(np.stack([faces, faces[:, [1, 2, 0]]], axis=2).reshape(-1, 2), axis=1)
    edge = ends[:, 0] * vertices + ends[:, 1]
    order = np.argsort(edge, kind="stable")
    _, first, uses = np.unique(edge[order], return_index=True, return_counts=True)
    one, other = (order[first[uses == 2] + k] // 3 for k in (0, 1))
    alike = np.einsum("nx,nx->n", normal[one], normal[other]) > _ALIKE
    links = sparse.coo_array((np.ones(np.count_nonzero(alike)), (one[alike], other[alike])), shape=(len(faces),) * 2)
    return graph.connected_components(links, directed=False)[1].astype(np.int64)
