"""Reader of a raster of heights, which reads any part of the raster on demand."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyproj
from affine import Affine

from warpsample.city.rasters.grid import Grid, mask_blocks
from warpsample.host.engine import check_memory

_BYTES = 1000
"""Bytes of memory per cell: triangles, normals and ray-tracing tree."""

_BAND = 1 << 22  # cells per reading step

_MOST_CELLS = 2**28
"""Largest number of cells: a cell has up to five vertices, whose indices are int32."""

_ALL = slice(None)


@dataclass(frozen=True, eq=False)
class RasterReader:
    """Reader of a raster: its position on the map, and a function that reads heights. `Grid` describes the other attributes.

    Attributes:
        shape: Numbers of rows and columns.
        factor: Factor that converts heights to the unit of the coordinates.
        has_unit: Whether the raster states the unit of its heights.
        heights: Function (rows, columns) that returns the float64 heights in two slices, NaN in cells without data.
    """

    shape: tuple[int, int]
    transform: Affine
    crs: pyproj.CRS | None
    metres: float
    dims: tuple[str, str]
    coordinates: Mapping[str, Any]
    factor: float
    has_unit: bool
    heights: Callable[[slice, slice], np.ndarray]

    @property
    def outline(self) -> Grid:
        """Position and shape of the raster's cells, as a `Grid` whose heights are all NaN."""
        nothing = np.broadcast_to(np.nan, self.shape)
        return Grid(nothing, self.transform, self.crs, self.metres, self.dims, self.coordinates)

    def grid(self, rows: slice = _ALL, columns: slice = _ALL) -> Grid:
        """Read the heights of the raster, or of the given rows and columns, as a Grid.

        Raises:
            ValueError: No cells, or too many cells, before anything is read.
            MemoryError: The triangles do not fit into the free memory.
        """
        rows, columns = slice(*rows.indices(self.shape[0])), slice(*columns.indices(self.shape[1]))
        check_size((rows.stop - rows.start, columns.stop - columns.start))
        heights = self.read(rows, columns)
        transform = self.transform @ Affine.translation(columns.start, rows.start)
        cut = dict(zip(self.dims, (rows, columns), strict=True))
        coordinates = {name: array[cut[name]] for name, array in self.coordinates.items()}
        return Grid(heights, transform, self.crs, self.metres, self.dims, coordinates)

    def read(self, rows: slice, columns: slice) -> np.ndarray:
        """Read the heights of some rows and columns, float64 in the unit of the raster's coordinates."""
        rows, columns = slice(*rows.indices(self.shape[0])), slice(*columns.indices(self.shape[1]))
        heights = self.heights(rows, columns)
        return heights * self.factor if abs(self.factor - 1.0) > 1e-5 else heights

    def check_heights(self, model: str) -> None:
        """Raise a ValueError if the raster has no surface: no cell with a height, or for "tin" no 2 x 2 block of heights.

        Bands of rows are read until a height, or for "tin" a block, is found: for most rasters one band.
        """
        rows, columns = self.shape
        some, step = False, max(1, _BAND // max(columns, 1))
        for first in range(0, rows, step):
            valid = ~np.isnan(self.read(slice(first, min(first + step + 1, rows)), _ALL))
            some = some or bool(valid.any())
            if some and (model != "tin" or mask_blocks(valid).any()):
                return
        if not some:
            raise ValueError(f"source: got {rows} x {columns} cells without any height, want at least one")
        raise ValueError(
            f"source: got {rows} x {columns} cells without a block of 2 x 2 cells with heights, want at least one block "
            "for model='tin'; or pass model='joined' or model='block', which need no such block"
        )


def check_size(shape: tuple[int, int], advice: str = "split the raster into tiles") -> None:
    """Raise an error for a raster without cells, or with too many cells for the free memory; it ends in the advice."""
    rows, columns = shape
    if not 0 < rows * columns <= _MOST_CELLS:
        raise ValueError(f"source: got {rows:,} x {columns:,} cells, want 1 to {_MOST_CELLS:,}; {advice}")
    check_memory(
        _BYTES * rows * columns,
        f"surfaces of {rows:,} x {columns:,} cells",
        advice,
    )
