"""Surface of a raster of heights as a mesh, and conversion of results at cells back to a raster."""

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from warpsample.city.rasters.canopy import TRUNK, Canopy, Crowns, build_prisms
from warpsample.city.rasters.cells import STEP, build_joined_cells
from warpsample.city.rasters.centres import build_tin
from warpsample.city.rasters.grid import TOP, Grid
from warpsample.city.rasters.scenery import Scenery, join_triangles
from warpsample.city.rasters.sources.reading import ground_of
from warpsample.host.arguments import check_choice
from warpsample.host.arrays import as_real
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.surface import SurfacePoints

MODELS = ("joined", "block", "tin")
RECEIVERS = ("horizontal", "surface")


@dataclass(frozen=True, eq=False, repr=False)
class RasterSurface(Summary):
    """Surface of a raster of heights as a mesh of triangles, in map coordinates.

    Attributes:
        grid: Heights of the cells.
        model: "joined", "block" or "tin".
        mesh: Triangles of the surface, with normals up.
        kind: (F,) uint8, 0 for the top of a cell, 1 for a wall.
        cell: (F,) int64 cell number, row * columns + column; for a wall, the upper cell.
        canopy_mesh: Triangles of the surface followed by those of opaque crowns; None without crowns.
    """

    grid: Grid
    model: str
    mesh: Mesh
    kind: np.ndarray
    cell: np.ndarray
    canopy_mesh: Mesh | None = None

    @property
    def north(self) -> tuple[float, float, float]:
        """Unit vector to true north at the raster's middle, in map coordinates, for `north=` of `irradiation`."""
        return self.grid.north

    @property
    def scenery(self) -> Scenery:
        """Meshes of the surface without and with tree crowns, both kept in memory."""
        return Scenery(lambda: self.mesh, None if self.canopy_mesh is None else lambda: self.canopy_mesh)

    def points(self, receiver: str = "horizontal") -> tuple[SurfacePoints, np.ndarray]:
        """Return the centres of the cells with heights as surface points, and the numbers of the cells.

        Args:
            receiver: "horizontal" for normals up, "surface" for the area-weighted mean normal of the cell's triangles.
                Default: "horizontal".

        Returns:
            SurfacePoints, and (P,) int64 cell numbers, row * columns + column, which are also the ids of the random numbers.

        Raises:
            TypeError, ValueError: Another receiver.

        Example:
            >>> from affine import Affine
            >>> step = ws.rasters.surface((np.array([[0.0, np.nan], [5.0, 5.0]]), Affine(1, 0, 0, 0, -1, 0), None))
            >>> points, cell = step.points()
            >>> print(cell, points.position[1])
            [0 2 3] [ 0.5 -1.5  5. ]
        """
        check_choice(receiver, "receiver", RECEIVERS)
        cells = self.grid.cells
        if receiver == "horizontal":
            normal = np.tile(np.float32([0.0, 0.0, 1.0]), (len(cells), 1))
        elif self.model == "tin":
            normal = self.mesh.vertex_normals[: len(cells)]
        else:
            top = self.kind == TOP
            crosses, place = self.mesh.cross_products[top].T, np.searchsorted(cells, self.cell[top])
            normal = unit_or_zero(np.stack([np.bincount(place, axis, len(cells)) for axis in crosses], axis=1))
        raised = self._mask_peaks(cells)
        return SurfacePoints(self.grid.centres(cells), normal, id=cells.astype(np.uint64), raised=raised), cells

    def _mask_peaks(self, cells: np.ndarray) -> np.ndarray | None:
        """Return the mask of the given cells with a vertex at the centre, where facets of any slope meet; None for no cell.

        Such cells are all cells of "tin", and the cells of four triangles.
        """
        if self.model == "tin":
            return np.ones(len(cells), bool)
        peaks = np.bincount(self.cell[self.kind == TOP], minlength=self.grid.height.size)[cells] == 4
        return peaks if peaks.any() else None

    def to_raster(self, values: Any, cell: np.ndarray) -> xr.DataArray:
        """Convert one number per cell to a georeferenced raster (xarray.DataArray).

        Args:
            values: (P,) numbers.
            cell: (P,) cell numbers, as `points` returns them.

        Returns:
            (y, x) DataArray, float32 or float64 as the values, NaN in other cells, with the CRS and the transform of the
            raster.

        Raises:
            TypeError, ValueError: Values that are not numbers, a number of values other than that of `cell`, or numbers of
                other cells.

        Example:
            >>> from affine import Affine
            >>> step = ws.rasters.surface((np.array([[0.0, np.nan], [5.0, 5.0]]), Affine(1, 0, 0, 0, -1, 0), None))
            >>> points, cell = step.points()
            >>> print(step.to_raster(points.position[:, 2], cell).values.tolist())
            [[0.0, nan], [5.0, 5.0]]
        """
        numbers = as_real(values, "values")
        if numbers.shape != np.shape(cell):
            raise ValueError(f"values: got shape {numbers.shape}, want {np.shape(cell)}, one value for each cell")
        grid = self.grid
        laid = np.full(grid.height.size, np.nan, numbers.dtype)
        laid[_check_cells(cell, grid.height.size)] = numbers
        return on_map(grid, laid.reshape(grid.height.shape))


def _check_cells(value: Any, cells: int) -> np.ndarray:
    """Return numbers of cells as int64, after a check that a raster with so many cells has them all."""
    cell = np.asarray(value)
    if cell.dtype.kind not in "iu" and cell.size:
        raise TypeError(f"cell: got dtype {cell.dtype}, want whole numbers, as `points` returns them")
    if cell.size and not 0 <= cell.min() <= cell.max() < cells:
        raise ValueError(
            f"cell: got numbers from {cell.min()} to {cell.max()}, want cells of this raster, 0 to {cells - 1:,}"
        )
    return cell.astype(np.int64, copy=False)


def on_map(grid: Grid, values: np.ndarray) -> xr.DataArray:
    """Convert an array with a number for each cell to a DataArray with the coordinates, CRS and transform of a raster."""
    made = xr.DataArray(values, grid.coordinates, grid.dims)
    if grid.crs is not None:
        with warnings.catch_warnings():  # CF has no words for some, the WKT beside it has
            warnings.filterwarnings("ignore", ".*lost in conversion to CF", UserWarning)
            made = made.rio.write_crs(grid.crs)
    return made.rio.write_transform(grid.transform).rio.write_nodata(np.nan)


def surface(
    source: Any, *, model: str = "joined", canopy: Any = None, trunk: Any = TRUNK, relative: bool = True
) -> RasterSurface:
    """Build the surface mesh of a raster of heights, with optional tree crowns.

    Args:
        source: Path of a raster with one band that GDAL reads, an xarray.DataArray with `rio.crs`, or (array, affine, crs or
            None). Coordinates are lengths, metres without a CRS. Heights in another known unit are converted.
        model: "joined", "block" or "tin". "joined": cells share corners with neighbours that differ by at most two cell
            lengths (63°), and vertical walls separate the others; for cities with roofs and in general. "block": each cell
            is flat, with vertical walls; for models of boxes. "tin": triangles between the centres of cells; for bare
            terrain. Default: "joined".
        canopy: Raster of the heights of tree crowns above the ground, as `source`, on the same cells; 0 is no tree. `source`
            must then exclude trees. A crown is a closed prism over its cell, joined with neighbouring crowns. Default: None.
        trunk: Height of the crowns' underside above the ground, a fraction of the crown's height from 0 to 1, or another
            raster. Rays pass below it. Points of the ground inside a crown, all with 0, see only through the crown. Default:
            0.25.
        relative: Whether `canopy` and `trunk` are heights above the ground; False for elevations. Default: True.

    Returns:
        RasterSurface with triangles in map coordinates.

    Raises:
        TypeError, ValueError, FileNotFoundError: An invalid raster or model, or crowns on other cells or below the ground.
        MemoryError: The triangles do not fit into the free memory.

    Warns:
        UserWarning: Unknown unit of heights with coordinates in another unit than metres; a file or DataArray without a CRS;
            or crowns with an underside at or above their top.

    Example:
        >>> from affine import Affine
        >>> step = ws.rasters.surface((np.array([[0.0, 0.0], [5.0, 5.0]]), Affine(1, 0, 0, 0, -1, 0), None))
        >>> print(step.mesh.face_areas[step.kind == 0].sum(), step.mesh.face_areas[step.kind == 1].sum())
        4.0 10.0
    """
    check_choice(model, "model", MODELS)
    reader = ground_of(source)
    canopy = Canopy.of(reader, canopy, trunk, relative)
    grid = reader.grid()
    reader.check_heights(model)
    return build_surface(grid, model, canopy and canopy.crowns(grid))


def build_surface(grid: Grid, model: str, crowns: Crowns | None = None) -> RasterSurface:
    """Build the surface mesh of a grid of heights, and a second mesh with tree crowns if there are any."""
    made = build_tin(grid) if model == "tin" else build_joined_cells(grid, STEP if model == "joined" else 0.0)
    mesh, with_crowns = Mesh(made.vertices, made.faces), None
    if crowns is not None and crowns.any:
        with_crowns = Mesh(*join_triangles([(mesh.vertices, mesh.faces), build_prisms(grid, crowns)]))
    return RasterSurface(grid, model, mesh, made.kind, made.cell, with_crowns)
