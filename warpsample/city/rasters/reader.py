"""A raster that is checked but for its heights, which are read when they are asked for, in whole or in part."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyproj
from affine import Affine

from warpsample.city.rasters.grid import Grid
from warpsample.host.engine import check_memory

_BYTES = 1000
"""Of memory for each cell: its triangles, their normals and their tree."""

_MOST_CELLS = 2**28
"""Vertices, of which there are at most five to a cell, are counted by 32 bits."""

_ALL = slice(None)


@dataclass(frozen=True, eq=False)
class RasterReader:
    """Where the cells of a raster are, and a way to their heights; the fields of `Grid`, and these.

    Attributes:
        shape: how many rows and columns.
        factor: what heights are multiplied by, so that their unit is that of the coordinates.
        heights: (rows, columns) -> float64 heights of these slices, NaN where there is none.
    """

    shape: tuple[int, int]
    transform: Affine
    crs: pyproj.CRS | None
    metres: float
    dims: tuple[str, str]
    coordinates: Mapping[str, Any]
    factor: float
    heights: Callable[[slice, slice], np.ndarray]

    @property
    def outline(self) -> Grid:
        """The raster without any height, and without memory for it."""
        nothing = np.broadcast_to(np.nan, self.shape)
        return Grid(nothing, self.transform, self.crs, self.metres, self.dims, self.coordinates)

    def grid(self, rows: slice = _ALL, columns: slice = _ALL) -> Grid:
        """The raster, or the part of it that has these rows and columns.

        Raises:
            ValueError: it has no cells, or too many, before they are read.
            MemoryError: its triangles need more memory than is free.
        """
        rows, columns = slice(*rows.indices(self.shape[0])), slice(*columns.indices(self.shape[1]))
        _check_size((rows.stop - rows.start, columns.stop - columns.start))
        heights = self.read(rows, columns)
        transform = self.transform @ Affine.translation(columns.start, rows.start)
        cut = dict(zip(self.dims, (rows, columns), strict=True))
        coordinates = {name: array[cut[name]] for name, array in self.coordinates.items()}
        return Grid(heights, transform, self.crs, self.metres, self.dims, coordinates)

    def read(self, rows: slice, columns: slice) -> np.ndarray:
        """The float64 heights of some rows and columns, in the unit of the coordinates."""
        rows, columns = slice(*rows.indices(self.shape[0])), slice(*columns.indices(self.shape[1]))
        heights = self.heights(rows, columns)
        return heights * self.factor if abs(self.factor - 1.0) > 1e-5 else heights


def _check_size(shape: tuple[int, int]) -> None:
    """Refuses rasters without cells, and those that are too large, before they are read."""
    rows, columns = shape
    if not 0 < rows * columns <= _MOST_CELLS:
        raise ValueError(f"source: got {rows:,} x {columns:,} cells, want 1 to {_MOST_CELLS:,}; take it in tiles")
    check_memory(_BYTES * rows * columns, f"the surface of {rows:,} x {columns:,} cells", "take it in tiles")
