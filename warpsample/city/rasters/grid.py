"""A raster of heights, checked: what surfaces are made of, and what results are laid out by; and triangles of surfaces."""

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
    """Heights of cells on a map.

    Attributes:
        height: (rows, columns) float64, in the unit of the map's coordinates; NaN where a cell has none.
        transform: from (column, row) to the map's (x, y); whole numbers are corners of cells, their centres are at halves.
        crs: of the map; None if it is not known.
        metres: the length of the coordinates' unit in metres; 1 if it is not known.
        dims: what the axes of rows and columns are called.
        coordinates: of the cells' centres, as xarray takes them; none where they are not told.
    """

    height: np.ndarray
    transform: Affine
    crs: pyproj.CRS | None
    metres: float
    dims: tuple[str, str]
    coordinates: Mapping[str, Any]

    @property
    def valid(self) -> np.ndarray:
        """(rows, columns) bool: the cells that have a height."""
        return ~np.isnan(self.height)

    @property
    def whole(self) -> bool:
        """Whether there are no holes: all cells have a height, but in rows and columns along the edges where none has."""
        valid = self.valid
        rows, columns = (np.flatnonzero(valid.any(axis=axis)) for axis in (1, 0))
        return len(rows) == 0 or bool(valid[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].all())

    @property
    def cells(self) -> np.ndarray:
        """(P,) int64, row * columns + column of the cells that have a height."""
        return np.flatnonzero(self.valid)

    @property
    def sides(self) -> tuple[float, float]:
        """How far the centres of neighbours in a row are apart, and of neighbours in a column."""
        a, b, _, d, e, _ = self.transform[:6]
        return float(np.hypot(a, d)), float(np.hypot(b, e))

    @property
    def mirrored(self) -> bool:
        """Whether rows and columns turn the other way round than in a raster with its north at the top."""
        return self.transform.determinant > 0.0

    @property
    def north(self) -> tuple[float, float, float]:
        """True north at the raster's middle, in the map's coordinates, of unit length; its y axis without a CRS.

        Raises:
            ValueError: the raster is where its CRS does not reach.
        """
        rows, columns = self.height.shape
        middle = self.places(np.array([0.5 * columns]), np.array([0.5 * rows]), np.zeros(1))[0]
        return true_north(self.crs, float(middle[0]), float(middle[1]))

    def places(self, column: np.ndarray, row: np.ndarray, height: np.ndarray) -> np.ndarray:
        """(N, 3) float64, where points of the raster are on the map; its corners are whole columns and rows."""
        a, b, c, d, e, f = self.transform[:6]
        return np.stack([a * column + b * row + c, d * column + e * row + f, height], axis=1)

    def centres(self, cells: np.ndarray) -> np.ndarray:
        """(N, 3) float64, the middles of cells at their heights."""
        row, column = np.divmod(cells, self.height.shape[1])
        return self.places(column + 0.5, row + 0.5, self.height.ravel()[cells])


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
