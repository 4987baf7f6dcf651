"""Meshes of a raster tile with and without tree crowns, built when needed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from warpsample.mesh.mesh import Mesh

Part = tuple[np.ndarray, np.ndarray]
"""(V, 3) float64 vertices, (F, 3) int32 faces."""

Columns = Callable[[], Part]
"""Function that builds the triangles of distant columns."""


@dataclass(frozen=True, eq=False)
class Scenery:
    """Pair of functions that build the mesh of a tile without and with tree crowns.

    The meshes are built on each call, so that only one mesh and its search tree is in memory at a time.

    Attributes:
        without_crowns: Function that returns the mesh without crowns.
        with_crowns: Function that returns the mesh with opaque crowns; None without crowns.
    """

    without_crowns: Callable[[], Mesh]
    with_crowns: Callable[[], Mesh] | None = None


@dataclass(eq=False)
class Foreground:
    """Triangles of a raster tile at full resolution, ground and tree crowns, to which distant terrain is added.

    After a scene with all triangles is built, its mesh holds them.

    Attributes:
        triangles: Vertices and faces of the ground, followed by those of the crowns.
        ground: Numbers of vertices and faces of the ground.
    """

    triangles: Part
    ground: tuple[int, int]

    def add_columns(self, *columns: Columns) -> Scenery:
        """Return functions that build the tile's meshes with distant terrain added as columns.

        The scene without crowns gets the first columns, the scene with crowns the last ones.
        """
        sizes = len(self.triangles[0]), len(self.triangles[1])
        with_crowns = (
            partial(self._append_columns, sizes, *columns[-1:]) if sizes != self.ground or len(columns) > 1 else None
        )
        return Scenery(partial(self._append_columns, self.ground, *columns[:1]), with_crowns)

    def _append_columns(self, sizes: tuple[int, int], *columns: Columns) -> Mesh:
        """Build a mesh of the tile's first `sizes` vertices and faces, followed by columns of distant terrain."""
        own = tuple(array[:size] for array, size in zip(self.triangles, sizes, strict=True))
        mesh = Mesh(*join_triangles([own, *(made() for made in columns)]))
        if len(own[1]) == len(self.triangles[1]):
            self.triangles = mesh.vertices[: sizes[0]], mesh.faces[: sizes[1]]
        return mesh


@dataclass(frozen=True, eq=False)
class Seen:
    """Values and errors of a quantity at P points of a raster tile.

    Attributes:
        value: (P,) float32.
        standard_error: (P,) float32, an upper bound with crowns.
        half_width: (P,) float32 half of the 95 % confidence interval, an upper bound with crowns.
        rays: (P,) int32 number of rays in all runs.
        status: (P,) uint8, a `PointStatus`.
    """

    value: np.ndarray
    standard_error: np.ndarray
    half_width: np.ndarray
    rays: np.ndarray
    status: np.ndarray


def join_triangles(parts: Sequence[Part]) -> Part:
    """Concatenate vertices and faces of several meshes into one, and renumber the faces."""
    vertices, faces = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
    first, start = 0, 0
    for some_vertices, some_faces in parts:
        faces[start : start + len(some_faces)] += first
        first, start = first + len(some_vertices), start + len(some_faces)
    return vertices, faces
