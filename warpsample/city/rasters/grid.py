"""Checked raster of heights, the triangles of its surface, and bounds of heights in the cells of another grid."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pyproj
from affine import Affine

from warpsample.city.rasters.sources.reference import true_north

TOP, WALL = 0, 1
"""Kinds of triangles."""

_ALMOST = 1e-6  # rounding of corner coordinates, in cells
_MOST_PASSES = 64  # passes over all cells of a raster, from which on a loop over its cells is faster


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
    def steps(self) -> np.ndarray:
        """Steps in metres along x and y to the next cell in a row, and to the next cell in a column, (2, 2)."""
        a, b, _, d, e, _ = self.transform[:6]
        return self.metres * np.array([[a, d], [b, e]])

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

    def crop(self, rows: slice, columns: slice) -> "Grid":
        """Return the given rows and columns as a Grid, without coordinates for xarray."""
        transform = self.transform @ Affine.translation(columns.start, rows.start)
        return replace(self, height=self.height[rows, columns], transform=transform, coordinates={})

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


@dataclass(frozen=True, eq=False)
class Bounds:
    """Upper and lower bounds of the heights of the terrain in each cell of a coarse raster.

    Attributes:
        upper: (rows, columns) float64 upper bounds; NaN in cells without data.
        lower: (rows, columns) float64 lower bounds; NaN in cells that may lack data.
        transform: Transform from (column, row) of these arrays to (column, row) of the raster that is cut into tiles.
    """

    upper: np.ndarray
    lower: np.ndarray
    transform: Affine


def mask_blocks(valid: np.ndarray) -> np.ndarray:
    """Return the mask of the 2 x 2 blocks of cells that all have heights, (rows - 1, columns - 1) bool."""
    return valid[:-1, :-1] & valid[:-1, 1:] & valid[1:, :-1] & valid[1:, 1:]


def resample_extremes(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Resample upper and lower bounds of heights to another grid of cells.

    Return the highest and lowest height of all raster cells that overlap each lattice cell.
    """
    upper, lower = np.full(shape, -np.inf), np.full(shape, np.inf)
    rows, columns, box = _find_overlap(bounds, where, shape)
    part = slice(rows[0], rows[1]), slice(columns[0], columns[1])
    highest, lowest = bounds.upper[part].ravel(), bounds.lower[part].ravel()
    first, last = (np.stack(ends).reshape(2, -1) for ends in box)
    span = (last - first).max(axis=1, initial=0)
    if span.prod() > _MOST_PASSES:
        first, last = (np.clip(ends, 0, np.array(shape)[:, None]) for ends in (first, last))
        for n in np.flatnonzero((last > first).all(axis=0)):
            at = slice(first[0, n], last[0, n]), slice(first[1, n], last[1, n])
            upper[at], lower[at] = np.fmax(upper[at], highest[n]), np.minimum(lower[at], lowest[n])
        span *= 0
    for down in range(span[0]):
        for right in range(span[1]):
            i, j = first[0] + down, first[1] + right
            inside = (i < last[0]) & (j < last[1]) & (i >= 0) & (j >= 0) & (i < shape[0]) & (j < shape[1])
            at = i[inside], j[inside]
            np.fmax.at(upper, at, highest[inside])
            np.minimum.at(lower, at, lowest[inside])
    upper[np.isinf(upper)] = np.nan
    lower[np.isinf(lower) | ~mask_covered(bounds, where, shape)] = np.nan
    return upper, lower


def _find_overlap(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> tuple[Any, Any, Any]:
    """Return the cells of a raster that overlap another grid, and the range of grid cells that each one overlaps."""
    to_lattice = ~where @ bounds.transform
    corners = [~to_lattice @ corner for corner in ((0, 0), (shape[1], 0), (0, shape[0]), (shape[1], shape[0]))]
    ends = []
    for along, most in ((1, bounds.upper.shape[0]), (0, bounds.upper.shape[1])):
        places = [corner[along] for corner in corners]
        ends.append((int(np.clip(np.floor(min(places)), 0, most)), int(np.clip(np.ceil(max(places)), 0, most))))
    row, column = np.mgrid[ends[0][0] : ends[0][1], ends[1][0] : ends[1][1]]
    a, b, c, d, e, f = to_lattice[:6]
    x, y = a * column + b * row + c, d * column + e * row + f
    box = ([], [])
    for start, one, other in ((y, d, e), (x, a, b)):
        low = start + min(one, 0.0) + min(other, 0.0)
        high = start + max(one, 0.0) + max(other, 0.0)
        box[0].append(np.floor(low + _ALMOST).astype(np.int64))
        box[1].append(np.ceil(high - _ALMOST).astype(np.int64))
    return *ends, box


def mask_covered(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> np.ndarray:
    """Return a mask of the cells of a grid that lie entirely within a raster."""
    row, column = np.mgrid[: shape[0] + 1, : shape[1] + 1]
    a, b, c, d, e, f = (~bounds.transform @ where)[:6]
    x, y = a * column + b * row + c, d * column + e * row + f
    rows, columns = bounds.upper.shape
    inside = (x > -_ALMOST) & (x < columns + _ALMOST) & (y > -_ALMOST) & (y < rows + _ALMOST)
    return inside[:-1, :-1] & inside[1:, :-1] & inside[:-1, 1:] & inside[1:, 1:]
