"""Report on a mesh: numbers of vertices and faces, and of defects."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from warpsample.mesh.mesh import Mesh


@dataclass(frozen=True)
class MeshReport:
    """Size and defects of a mesh.

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


def report_of(mesh: "Mesh") -> MeshReport:
    """Count the vertices, faces and defects of a checked mesh; sorts all edges."""
    start = mesh.faces.ravel().astype(np.int64)
    end = mesh.faces[:, [1, 2, 0]].ravel().astype(np.int64)
    stride = len(mesh.vertices)
    _, uses = np.unique(np.minimum(start, end) * stride + np.maximum(start, end), return_counts=True)
    _, same_way = np.unique(start * stride + end, return_counts=True)
    return MeshReport(
        vertices=len(mesh.vertices),
        faces=len(mesh.faces),
        degenerate_faces=int(np.count_nonzero(mesh.face_areas == 0.0)),
        duplicate_faces=len(mesh.faces) - len(np.unique(np.sort(mesh.faces, axis=1), axis=0)),
        unreferenced_vertices=int(np.count_nonzero(~mesh.used)),
        boundary_edges=int(np.count_nonzero(uses == 1)),
        nonmanifold_edges=int(np.count_nonzero(uses > 2)),
        inconsistent_edges=int(np.count_nonzero(same_way > 1)),
        area=float(mesh.face_areas.sum()),
        lower=mesh.bounds[0],
        upper=mesh.bounds[1],
    )
