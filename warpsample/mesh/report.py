"""Report on a mesh: numbers of vertices and faces, and of defects."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class MeshReport:
    """Report on a mesh: numbers of vertices and faces, and counts of defects.

    Attributes:
        vertices: Number of vertices.
        faces: Number of faces, degenerate ones included.
        degenerate_faces: Number of faces whose area is 0 or lost to rounding. Such faces carry no points and have a zero
            normal.
        duplicate_faces: Number of faces with the same three vertices as an earlier face, in any order.
        unreferenced_vertices: Number of vertices that no face uses.
        boundary_edges: Number of edges with one face. Edges are identified by vertex indices; a file that repeats vertices
            for each part has boundary edges where parts touch.
        nonmanifold_edges: Number of edges with more than two faces.
        inconsistent_edges: Number of edges that two faces traverse in the same direction, so that one of the faces is inside
            out.
        area: Total area of all faces, in square units of the coordinates.
        lower: (3,) smallest coordinates of the vertices that faces use.
        upper: (3,) largest coordinates of the vertices that faces use.
    """

    vertices: int
    faces: int
    degenerate_faces: int
    duplicate_faces: int
    unreferenced_vertices: int
    boundary_edges: int
    nonmanifold_edges: int
    inconsistent_edges: int
    area: float
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]


def report_of(faces: np.ndarray, areas: np.ndarray, used: np.ndarray, bounds: np.ndarray) -> MeshReport:
    """Count the vertices, faces and defects of a checked mesh, and return a `MeshReport`.

    Args:
        faces: (F, 3) int32 indices of vertices.
        areas: (F,) float64 areas of the faces.
        used: (V,) bool mask of the vertices that faces use.
        bounds: (2, 3) smallest and largest coordinates of these vertices.
    """
    start = faces.ravel().astype(np.int64)
    end = faces[:, [1, 2, 0]].ravel().astype(np.int64)
    stride = len(used)
    _, uses = np.unique(np.minimum(start, end) * stride + np.maximum(start, end), return_counts=True)
    _, same_way = np.unique(start * stride + end, return_counts=True)
    return MeshReport(
        vertices=len(used),
        faces=len(faces),
        degenerate_faces=int(np.count_nonzero(areas == 0.0)),
        duplicate_faces=len(faces) - len(np.unique(np.sort(faces, axis=1), axis=0)),
        unreferenced_vertices=int(np.count_nonzero(~used)),
        boundary_edges=int(np.count_nonzero(uses == 1)),
        nonmanifold_edges=int(np.count_nonzero(uses > 2)),
        inconsistent_edges=int(np.count_nonzero(same_way > 1)),
        area=float(areas.sum()),
        lower=bounds[0],
        upper=bounds[1],
    )
