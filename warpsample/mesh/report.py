"""A report on a mesh: its size, and the defects that it has."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from warpsample.mesh.mesh import Mesh


@dataclass(frozen=True)
class MeshReport:
    """The size of a mesh, and the defects that it has.

    Attributes:
        vertices: how many.
        faces: how many, degenerate ones included.
        degenerate_faces: whose area is 0 or lost to rounding; they carry no points and have a zero normal.
        duplicate_faces: that have the same three vertices as an earlier face, in any order.
        unreferenced_vertices: that no face uses.
        boundary_edges: with one face, by the numbers of their vertices; where a file writes corners anew for each part,
            parts have such edges where they meet.
        nonmanifold_edges: with more than two.
        inconsistent_edges: that two faces run along in the same direction, so one of them is inside out.
        area: of all faces, in square units of the coordinates.
        lower: smallest coordinates of the vertices that faces use, (3,).
        upper: largest coordinates of them, (3,).
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
    """The report on a checked mesh; it takes a sort of all edges."""
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
