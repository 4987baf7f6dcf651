"""What stands about the cells of a raster, with crowns and without them, one mesh after the other; and what they see."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from warpsample.mesh.mesh import Mesh

Part = tuple[np.ndarray, np.ndarray]
"""(V, 3) float64 vertices, (F, 3) int32 faces."""

Columns = Callable[[], Part]
"""What makes the triangles of columns far off."""


@dataclass(frozen=True, eq=False)
class Scenery:
    """Two scenes, each made when it is looked at: so there is one at a time, with its tree, if callers keep none.

    Attributes:
        bare: () -> the mesh without crowns.
        wooded: () -> the one with opaque crowns; None where there are none.
    """

    bare: Callable[[], Mesh]
    wooded: Callable[[], Mesh] | None = None


@dataclass(eq=False)
class Foreground:
    """The triangles that are in several scenes, as they are. They are there once: as a part of the last one that has all.

    Attributes:
        triangles: of the ground, and after them of the crowns.
        ground: how many of the vertices, and of the faces, are the ground's.
    """

    triangles: Part
    ground: tuple[int, int]

    def before(self, *columns: Columns) -> Scenery:
        """The scenes with columns behind: without crowns the first ones, with crowns the last ones, if there are two."""
        sizes = len(self.triangles[0]), len(self.triangles[1])
        wooded = partial(self._beside, sizes, *columns[-1:]) if sizes != self.ground or len(columns) > 1 else None
        return Scenery(partial(self._beside, self.ground, *columns[:1]), wooded)

    def _beside(self, sizes: tuple[int, int], *columns: Columns) -> Mesh:
        own = tuple(array[:size] for array, size in zip(self.triangles, sizes, strict=True))
        mesh = Mesh(*joined([own, *(made() for made in columns)]))
        if len(own[1]) == len(self.triangles[1]):
            self.triangles = mesh.vertices[: sizes[0]], mesh.faces[: sizes[1]]
        return mesh


@dataclass(frozen=True, eq=False)
class Seen:
    """What P points see, crowns in its way.

    Attributes:
        value: (P,) float32.
        standard_error: (P,) float32, at most so much.
        half_width: (P,) float32, half of the 95 % confidence interval, at most so much.
        rays: (P,) int32, in all runs.
        status: (P,) uint8, a `PointStatus`.
    """

    value: np.ndarray
    standard_error: np.ndarray
    half_width: np.ndarray
    rays: np.ndarray
    status: np.ndarray


def joined(parts: Sequence[Part]) -> Part:
    """The triangles of all parts, one after the other."""
    vertices, faces = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
    first, start = 0, 0
    for some_vertices, some_faces in parts:
        faces[start : start + len(some_faces)] += first
        first, start = first + len(some_vertices), start + len(some_faces)
    return vertices, faces
