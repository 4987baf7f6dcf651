"""The surface that a raster of heights stands for, and the way from its points back to the raster."""

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from warpsample.city.rasters.canopy import TRUNK, Canopy, Crowns, prisms
from warpsample.city.rasters.cells import STEP, joined_cells
from warpsample.city.rasters.centres import between_centres
from warpsample.city.rasters.grid import Grid
from warpsample.city.rasters.reading import reader_of, with_heights
from warpsample.city.rasters.scenery import Scenery, joined
from warpsample.city.rasters.triangles import TOP
from warpsample.host.arguments import check_choice
from warpsample.host.arrays import as_real
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.surface import SurfacePoints

MODELS = ("joined", "block", "tin")
RECEIVERS = ("horizontal", "surface")


@dataclass(frozen=True, eq=False, repr=False)
class RasterSurface(Summary):
    """The triangles of a raster of heights, in the map's coordinates.

    Attributes:
        grid: the heights.
        model: "joined", "block" or "tin".
        mesh: its triangles, normals up.
        kind: (F,) uint8, 0 for the top of a cell, 1 for a wall.
        cell: (F,) int64, row * columns + column; of a wall, of the upper cell.
        canopy_mesh: the same triangles, and then those of crowns, opaque; None if there are none.
    """

    grid: Grid
    model: str
    mesh: Mesh
    kind: np.ndarray
    cell: np.ndarray
    canopy_mesh: Mesh | None = None

    @property
    def north(self) -> tuple[float, float, float]:
        """True north at the raster's middle, in the map's coordinates, as `north=` of `irradiation` takes it."""
        return self.grid.north

    @property
    def scenery(self) -> Scenery:
        """Both meshes, which stay."""
        return Scenery(lambda: self.mesh, None if self.canopy_mesh is None else lambda: self.canopy_mesh)

    def points(self, receiver: str = "horizontal") -> tuple[SurfacePoints, np.ndarray]:
        """The middles of the cells that have a height.

        Args:
            receiver: "horizontal" has normals up; "surface" those of the cell, the mean of its triangles' by area.

        Returns:
            the points, and (P,) int64, their cells, row * columns + column; these are the ids of their random numbers, too.

        Raises:
            TypeError, ValueError: another receiver.

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
        raised = np.ones(len(cells), bool) if self.model == "tin" else None  # where points are vertices without walls
        return SurfacePoints(self.grid.centres(cells), normal, id=cells.astype(np.uint64), raised=raised), cells

    def to_raster(self, values: Any, cell: np.ndarray) -> xr.DataArray:
        """Numbers of cells, laid out as the raster is.

        Args:
            values: (P,) numbers.
            cell: (P,) their cells, as `points` gives them.

        Returns:
            (y, x), float32 or float64 as the values are; NaN elsewhere. CRS and transform are the raster's.

        Raises:
            TypeError, ValueError: no numbers, or not one for each cell.

        Example:
            >>> from affine import Affine
            >>> step = ws.rasters.surface((np.array([[0.0, np.nan], [5.0, 5.0]]), Affine(1, 0, 0, 0, -1, 0), None))
            >>> points, cell = step.points()
            >>> print(step.to_raster(points.position[:, 2], cell).values.tolist())
            [[0.0, nan], [5.0, 5.0]]
        """
        numbers = as_real(values, "values")
        if numbers.shape != np.shape(cell):
            raise ValueError(f"values: got shape {numbers.shape}, want {np.shape(cell)}, a number for each cell")
        grid = self.grid
        laid = np.full(grid.height.size, np.nan, numbers.dtype)
        laid[cell] = numbers
        return on_map(grid, laid.reshape(grid.height.shape))


def on_map(grid: Grid, values: np.ndarray) -> xr.DataArray:
    """Numbers of all cells with the coordinates, the CRS and the transform of a raster."""
    made = xr.DataArray(values, grid.coordinates, grid.dims)
    if grid.crs is not None:
        with warnings.catch_warnings():  # CF has no words for some, the WKT beside it has
            warnings.filterwarnings("ignore", ".*lost in conversion to CF", UserWarning)
            made = made.rio.write_crs(grid.crs)
    return made.rio.write_transform(grid.transform).rio.write_nodata(np.nan)


def surface(
    source: Any, *, model: str = "joined", canopy: Any = None, trunk: Any = TRUNK, relative: bool = True
) -> RasterSurface:
    """The surface that a raster of heights stands for.

    Args:
        source: the path of a raster of one band that GDAL reads, an xarray.DataArray with `rio.crs`, or (array, affine, crs
            or None). Coordinates are lengths; heights that are told to be in another unit than these are converted.
        model: "joined": cells share their corners with neighbours that differ by at most a step of two cells, 63°, and
            vertical walls stand between the others; for cities with roofs, and all else. "block": each cell is flat, with
            vertical walls; for models of boxes. "tin": triangles between the centres of cells; for bare terrain.
        canopy: a raster of the same cells, as `source`: how high crowns of trees reach above the ground, 0 where there are
            none. `source` is without trees then. A crown is a closed prism over its cell, joined with its neighbours'.
        trunk: how high the underside of a crown is above the ground, below which rays pass: a share of its height, 0 to 1,
            or another raster. A point of the ground that is within a crown, as all are with 0, sees nothing but through it.
        relative: whether `canopy` and `trunk` are heights above the ground; False: elevations.

    Returns:
        its triangles, in the coordinates of the map.

    Raises:
        TypeError, ValueError, FileNotFoundError: no such raster or model, or crowns of other cells or below the ground; says
            what it got and what it wants.
        MemoryError: its triangles need more memory than is free.

    Warns:
        UserWarning: the unit of its heights is not told, and that of its coordinates is no metre; or crowns have their
            underside at or above their top.

    Example:
        >>> from affine import Affine
        >>> step = ws.rasters.surface((np.array([[0.0, 0.0], [5.0, 5.0]]), Affine(1, 0, 0, 0, -1, 0), None))
        >>> print(step.mesh.face_areas[step.kind == 0].sum(), step.mesh.face_areas[step.kind == 1].sum())
        4.0 10.0
    """
    check_choice(model, "model", MODELS)
    reader = reader_of(source)
    canopy = Canopy.of(reader, canopy, trunk, relative)
    grid = with_heights(reader.grid())
    return surface_of(grid, model, canopy and canopy.crowns(grid))


def surface_of(grid: Grid, model: str, crowns: Crowns | None = None) -> RasterSurface:
    """The surface of a grid, and of the crowns over it."""
    made = between_centres(grid) if model == "tin" else joined_cells(grid, STEP if model == "joined" else 0.0)
    mesh, with_crowns = Mesh(made.vertices, made.faces), None
    if crowns is not None and crowns.any:
        with_crowns = Mesh(*joined([(mesh.vertices, mesh.faces), prisms(grid, crowns)]))
    return RasterSurface(grid, model, mesh, made.kind, made.cell, with_crowns)
