"""What a model makes of a raster: triangles, and which cells they are of."""

from dataclasses import dataclass

import numpy as np

TOP, WALL = 0, 1
"""Kinds of triangles."""


@dataclass(frozen=True, eq=False)
class Triangles:
    """The triangles of a raster, tops before walls.

    Attributes:
        vertices: (V, 3) float64, on the map.
        faces: (F, 3) int32, counter-clockwise seen from above; of a wall, from where the lower cell is.
        kind: (F,) uint8, TOP or WALL.
        cell: (F,) int64, row * columns + column; of a wall, of the upper cell.
    """

    vertices: np.ndarray
    faces: np.ndarray
    kind: np.ndarray
    cell: np.ndarray
