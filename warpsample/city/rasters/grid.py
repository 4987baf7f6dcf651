"""Checked raster of heights, and the triangles of its surface."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyproj
from affine import Affine

from warpsample.city.rasters.reference import true_north

TOP, WALL = 0, 1
"""Kinds of triangles."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Raster of heights in memory, with its position on the map.

    Attributes:
        height: (rows, columns) float64, in the unit of the map's coordinates; NaN in cells without data.
        transform: Transform from (column, row) to (x, y) on the map. Integers are corners of cells, halves are centres.
        crs: CRS of the map, or None if unknown.
        metres: Length of the coordinates' unit in metres; 1 if unknown.
        dims: Names of the row and column dimensions.
        coordinates: Coordinates of the cell centres for xarray; empty if there are none.
    """

    height: np.ndarray
    transform: Affine
    crs: pyproj.CRS | None
    metres: float
    dims: tuple[str, str]
    coordinates: Mapping[str, Any]

    @property
    def valid(self) -> np.ndarray:
        """Mask of the cells with heights, (rows, columns) bool."""
        return ~np.isnan(self.height)

    @property
    def whole(self) -> bool:
        """True if the cells with heights fill a rectangle, with cells without data only along its outside."""
        valid = self.valid
        rows, columns = (np.flatnonzero(valid.any(axis=axis)) for axis in (1, 0))
        return len(rows) == 0 or bool(valid[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].all())

    @property
    def cells(self) -> np.ndarray:
        """Numbers of the cells with heights, row * columns + column, (P,) int64."""
        return np.flatnonzero(self.valid)

    @property
    def sides(self) -> tuple[float, float]:
        """Width and height of a cell on the map: distances between the centres of neighbours in a row, and in a column."""
        a, b, _, d, e, _ = self.transform[:6]
        return float(np.hypot(a, d)), float(np.hypot(b, e))

    @property
    def mirrored(self) -> bool:
        """True if the raster is a mirror image of the map, for example with the first row in the south."""
        return self.transform.determinant > 0.0

    @property
    def north(self) -> tuple[float, float, float]:
        """Unit vector to true north at the raster's middle, in map coordinates; (0, 1, 0) without a CRS.

        Raises:
            ValueError: The raster is outside the domain of its CRS.
        """
        rows, columns = self.height.shape
        middle = self.places(np.array([0.5 * columns]), np.array([0.5 * rows]), np.zeros(1))[0]
        return true_north(self.crs, float(middle[0]), float(middle[1]))

    def places(self, column: np.ndarray, row: np.ndarray, height: np.ndarray) -> np.ndarray:
        """Convert column, row and height of points to map positions, (N, 3) float64.

        Integer columns and rows are corners of cells.
        """
        a, b, c, d, e, f = self.transform[:6]
        return np.stack([a * column + b * row + c, d * column + e * row + f, height], axis=1)

    def centres(self, cells: np.ndarray) -> np.ndarray:
        """Return the map positions of the centres of cells, at the heights of the cells, (N, 3) float64."""
        row, column = np.divmod(cells, self.height.shape[1])
        return self.places(column + 0.5, row + 0.5, self.height.ravel()[cells])


@dataclass(frozen=True, eq=False)
class Triangles:
    """Triangle mesh of a raster's surface, with the raster cell that each triangle belongs to.

    Attributes:
        vertices: (V, 3) float64 map positions.
        faces: (F, 3) int32, counter-clockwise seen from above; walls, seen from the lower cell.
        kind: (F,) uint8, TOP or WALL.
        cell: (F,) int64 cell number, row * columns + column; for a wall, the upper cell.
    """

    vertices: np.ndarray
    faces: np.ndarray
    kind: np.ndarray
    cell: np.ndarray
