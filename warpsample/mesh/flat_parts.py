"""Detection of flat parts of a mesh: neighbouring faces in one plane, with two axes in each plane."""

import numpy as np

from warpsample.host.locks import imported
from warpsample.mesh.mesh import Mesh

_ALIKE = 1.0 - 1.5e-6  # cosine of 0.1 degrees, the largest angle between normals of one flat part
_LEVEL = 1e-3  # sine of the largest angle between up and the normal of a horizontal plane


def flat_parts(mesh: Mesh, rows: np.ndarray, upward: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Group connected faces that lie in one plane; return the group of each face, and two axes in each group's plane.

    Args:
        mesh: Mesh whose neighbouring faces share vertices.
        rows: (N,) indices of faces with an area above 0.
        upward: (3,) unit vector that points up.

    Returns:
        (N,) number of each face's flat part, and two arrays (K, 3) of the parts' unit axes; see `axes_in_plane`.
    """
    normal = mesh.face_normals[rows].astype(np.float64)
    part = _joined(mesh.faces[rows].astype(np.int64), normal, len(mesh.vertices))
    mean = np.zeros((part.max() + 1, 3))
    np.add.at(mean, part, normal * mesh.face_areas[rows][:, None])
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    return part, *axes_in_plane(mean, upward)


def axes_in_plane(normal: np.ndarray, upward: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return two arrays (K, 3) of perpendicular unit axes in the planes with unit normals (K, 3).

    The first axis is horizontal. In a horizontal plane the first axis is the projection of +x, or of +y if x points up. The
    second axis is 90 degrees to the left of the first, seen against the normal.
    """
    level = np.cross(upward, normal)
    near = np.eye(3)[0 if abs(upward[0]) < 0.9 else 1]
    along = near - (normal @ near)[:, None] * normal
    x = np.where(np.linalg.norm(level, axis=1, keepdims=True) < _LEVEL, along, level)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    return x, np.cross(normal, x)


def _joined(faces: np.ndarray, normal: np.ndarray, vertices: int) -> np.ndarray:
    """Return the number of each face's flat part, (N,): connected faces in one plane.

    Two faces are joined if they alone share an edge and the angle between their normals is below 0.1 degrees.
    """
    sparse, graph = imported("scipy.sparse"), imported("scipy.sparse.csgraph")
    ends = np.sort(np.stack([faces, faces[:, [1, 2, 0]]], axis=2).reshape(-1, 2), axis=1)
    edge = ends[:, 0] * vertices + ends[:, 1]
    order = np.argsort(edge, kind="stable")
    _, first, uses = np.unique(edge[order], return_index=True, return_counts=True)
    one, other = (order[first[uses == 2] + k] // 3 for k in (0, 1))
    alike = np.einsum("nx,nx->n", normal[one], normal[other]) > _ALIKE
    links = sparse.coo_array((np.ones(np.count_nonzero(alike)), (one[alike], other[alike])), shape=(len(faces),) * 2)
    return graph.connected_components(links, directed=False)[1].astype(np.int64)
