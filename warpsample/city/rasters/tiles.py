"""Computation of a quantity tile by tile; terrain near a tile is traced at full resolution, distant terrain simplified.

Random numbers of a cell depend on its number in the whole raster, row * columns + column. So tiles agree with the whole,
except for the pooled terrain and for float32 rounding in another mesh.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np

from warpsample.city.rasters.canopy import Canopy, build_prisms
from warpsample.city.rasters.far import FarField, window_of
from warpsample.city.rasters.fringe import add_fringe, cut_fringe
from warpsample.city.rasters.grid import Grid
from warpsample.city.rasters.horizons import finds_horizons, sky_by_horizons
from warpsample.city.rasters.leaves import compute_through_crowns
from warpsample.city.rasters.raster_surface import build_surface
from warpsample.city.rasters.scenery import Foreground, Part, Scenery, Seen, join_triangles
from warpsample.city.rasters.sources.reader import RasterReader, check_size
from warpsample.estimate.estimating import collect_missed_tolerances, warn_of_missed_tolerance
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import has_value
from warpsample.host.engine import check_memory
from warpsample.host.progress import log
from warpsample.mesh.surface import SurfacePoints

_BEYOND = 60  # bytes for each cell of a tile's margin beyond the raster, where there is other terrain; 50 to 72 measured

Span = tuple[slice, slice]
"""Rows and columns."""


@dataclass(eq=False)
class RasterRun:
    """Computation of one quantity on a raster, tile by tile: checked arguments, and the distant terrain.

    Attributes:
        reader: Reader of the heights.
        quantity: Quantity to compute in each cell.
        options: Arguments of the quantity's call by name, without the mesh and the points.
        model, receiver: Surface model and receiver, see `surface` and the calls.
        canopy: Tree crowns, or None.
        transmittance: (1,), (12,) or (365,) transmittance of crowns.
        tile: Number of cells along the sides of a tile; None for a single tile.
        margin: Number of full-resolution cells around a tile.
        other: Reader of the terrain beyond the edges, or None.
        warned: Whether a tile has already warned that it does not reach the tolerance.
    """

    reader: RasterReader
    quantity: Quantity
    options: dict[str, Any]
    model: str
    receiver: str
    canopy: Canopy | None
    transmittance: np.ndarray
    tile: int | None
    margin: int
    other: RasterReader | None
    warned: bool = field(default=False, init=False)

    def check(self) -> None:
        """Raise an error for invalid options of the quantity, by a computation for 2 x 2 cells of level ground.

        The model "tin" has no triangles with fewer cells. A raster without a surface is refused, too.

        Raises:
            TypeError, ValueError: An option that cannot be used, or a raster without heights; the message names it.
        """
        flat = replace(self.reader, shape=(2, 2), coordinates={}, heights=lambda *_: np.zeros((2, 2)))
        trial = replace(self, reader=flat, canopy=None, tile=None, other=None)
        trial.warned = True  # the raster's own tiles warn of a missed tolerance
        trial.numbers((slice(0, 2), slice(0, 2)))
        self.reader.check_heights(self.model)

    def check_size(self) -> None:
        """Raise an error if a tile with its margin has too many cells for this machine, before anything is read."""
        rows, columns = self._cuts()
        spans = (((part, columns[0]) for part in rows), ((rows[0], part) for part in columns))
        height, width = (
            max(window.stop - window.start for window in (self._widen(self._clip(self._near(span)))[axis] for span in along))
            for axis, along in enumerate(spans)
        )
        if self.other is not None:
            (top, left) = (part.stop - part.start for part in self._near((rows[0], columns[0])))
            check_memory(
                _BEYOND * top * left, f"cells of a margin of {self.margin:,} cells with far terrain", "take smaller margins"
            )
        check_size((height, width), "split the raster into tiles" if self.tile is None else "take smaller tiles or margins")

    @property
    def rasters(self) -> dict[str, RasterReader]:
        """Readers of all input rasters, keyed by argument name."""
        trees = {} if self.canopy is None else {"canopy": self.canopy.top, "trunk": self.canopy.trunk}
        given = {"source": self.reader, **trees, "far": self.other}
        return {name: raster for name, raster in given.items() if isinstance(raster, RasterReader)}

    def reading(self, rasters: Mapping[str, RasterReader]) -> "RasterRun":
        """Return a copy of this computation that reads the given input rasters, keyed by argument name."""
        canopy = self.canopy
        if canopy is not None:
            canopy = replace(canopy, top=rasters["canopy"], trunk=rasters.get("trunk", canopy.trunk))
        return replace(self, reader=rasters["source"], canopy=canopy, other=rasters.get("far"))

    @property
    def far(self) -> bool:
        """True if terrain outside the tiles' margins is simplified, so that results have upper and lower bounds."""
        return self.tile is not None or self.other is not None

    @cached_property
    def far_field(self) -> FarField | None:
        """Simplified distant ground and buildings; None if all terrain is inside the tiles' margins."""
        return FarField.of(self.reader, self.other, margin=self.margin, model=self.model) if self.far else None

    @cached_property
    def far_field_with_trees(self) -> FarField | None:
        """Simplified distant terrain with tree crowns; the same as `far_field` for a raster without tree crowns."""
        if not self.far or self.canopy is None:
            return self.far_field
        return FarField.of(self.reader, self.other, margin=self.margin, model=self.model, canopy=self.canopy)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the result arrays, for example "value" and "standard_error"."""
        return ("value", "standard_error", "half_width", *(("far_error",) if self.far else ()))

    @property
    def grid(self) -> tuple[int, int]:
        """Number of tile rows and tile columns."""
        (rows, columns), (height, width) = self.reader.shape, self.sides
        return -(-rows // height), -(-columns // width)

    @property
    def sides(self) -> tuple[int, int]:
        """Number of rows and columns of a tile; the last tiles may be smaller."""
        rows, columns = self.reader.shape
        return (rows, columns) if self.tile is None else (min(self.tile, rows), min(self.tile, columns))

    def spans(self) -> Iterator[Span]:
        """Yield the rows and columns of the tiles, row by row."""
        yield from product(*self._cuts())

    def _cuts(self) -> list[list[slice]]:
        """Return the rows of the tiles, and the columns."""
        both = zip(self.sides, self.reader.shape, strict=True)
        return [[slice(at, min(at + side, size)) for at in range(0, size, side)] for side, size in both]

    def numbers(self, span: Span) -> dict[str, np.ndarray]:
        """Compute the quantity in the cells of one tile; return (rows, columns) float32 arrays, keyed by name.

        Cells without data are NaN.
        """
        shape = tuple(part.stop - part.start for part in span)
        log.info("tile of rows %d to %d, columns %d to %d", *(edge for part in span for edge in (part.start, part.stop - 1)))
        laid = {name: np.full(shape, np.nan, np.float32) for name in self.names}
        near = self._near(span)
        window = self._clip(near)
        wide = self._widen(window)
        grid = self.reader.grid(*wide)
        row, column = (first.start - part.start for first, part in zip(span, wide, strict=True))
        if not grid.valid[row : row + shape[0], column : column + shape[1]].any():
            return laid
        points, (i, j), ground = self._build_ground(grid, wide, window, span)
        rows, columns = (
            slice(part.start - whole.start, part.stop - whole.start) for part, whole in zip(window, wide, strict=True)
        )
        foreground = self._build_foreground(ground, grid.crop(rows, columns), window)
        del ground  # whose arrays are in it
        scenes = self._build_scenes(foreground, span, near)
        with collect_missed_tolerances() as missed:
            found = [self._compute_values(points, scenery) for scenery in scenes]
        for name, values in _average_bounds(found).items():
            if name in laid:
                laid[name][i, j] = values
        if missed and not self.warned:
            self.warned = True
            warn_of_missed_tolerance(missed[0], stacklevel=5)
        return laid

    def _near(self, span: Span) -> Span:
        """Return the rows and columns of a tile and its margin, perhaps beyond the raster's edges."""
        return window_of(span, self.margin) if self.far else span

    def _clip(self, near: Span) -> Span:
        """Return rows and columns without those beyond the raster's edges."""
        rows, columns = (slice(max(0, n.start), min(n.stop, size)) for n, size in zip(near, self.reader.shape, strict=True))
        return rows, columns

    def _widen(self, window: Span) -> Span:
        """Return the rows and columns of a tile and its margin with one more ring of cells, which shapes their surface."""
        ring = int(self.model != "block")
        rows, columns = (
            slice(max(0, part.start - ring), min(part.stop + ring, size))
            for part, size in zip(window, self.reader.shape, strict=True)
        )
        return rows, columns

    def _build_ground(self, grid: Grid, window: Span, kept: Span, span: Span) -> tuple[SurfacePoints, np.ndarray, Part]:
        """Return the points of a tile, their rows and columns in the tile, (2, P), and the triangles of the ground.

        The triangles are those of the cells in `kept`, the tile and its margin.
        """
        shape = self.reader.shape
        if self.far_field is not None and self.far_field.fringe is not None:
            grid, window = add_fringe(grid, window, shape, self.far_field.fringe, self.model)
        surface = build_surface(grid, self.model)
        points, cells = surface.points(self.receiver)
        place = np.stack(np.divmod(cells, grid.height.shape[1])) + [[part.start] for part in window]
        inside = np.all([(at >= part.start) & (at < part.stop) for at, part in zip(place, span, strict=True)], axis=0)
        if not inside.all():
            place, points = place[:, inside], points.take(inside)
        points = replace(points, id=place[0] * shape[1] + place[1])
        return points, place - [[part.start] for part in span], cut_fringe(surface, window, kept)

    def _build_foreground(self, ground: Part, grid: Grid, window: Span) -> Foreground:
        """Build the triangles of a tile and its margin at full resolution: ground first, then tree crowns."""
        crowns = self.canopy and self.canopy.crowns(grid, *window)
        triangles = join_triangles([ground, build_prisms(grid, crowns)]) if crowns and crowns.any else ground
        return Foreground(triangles, tuple(map(len, ground)))

    def _build_scenes(self, foreground: Foreground, span: Span, near: Span) -> list[Scenery]:
        """Return two versions of a tile's meshes: with distant terrain that is too high, and with one that is too low.

        Without distant terrain there is only one scene.
        """
        if self.far_field is None:
            return [foreground.add_columns()]
        fields = [self.far_field, *([] if self.far_field_with_trees is self.far_field else [self.far_field_with_trees])]
        lowest = float(foreground.triangles[0][:, 2].min())
        columns = zip(*(field.columns(span, near, lowest) for field in fields), strict=True)
        return [foreground.add_columns(*each) for each in columns] or [foreground.add_columns()]

    @property
    def by_horizons(self) -> bool:
        """True if tiles are computed by a search for the horizon in each azimuth.

        Rays pass below crowns, so that an azimuth has no single horizon there.
        """
        return self.canopy is None and finds_horizons(self.quantity, self.options)

    def _compute_values(self, points: SurfacePoints, scene: Scenery) -> Seen:
        """Compute the quantity at points of a tile: from horizons where possible, else by independent rays."""
        if self.by_horizons:
            return sky_by_horizons(self.quantity, scene.without_crowns(), points, self.options)
        return compute_through_crowns(self.quantity, scene, points, self.options, self.transmittance)


def _average_bounds(found: list[Seen]) -> dict[str, np.ndarray]:
    """Average two results, computed with too high and with too low distant terrain; half the difference is `far_error`.

    Points without a value, such as cells of "tin" without a triangle that would give them a slope, are NaN.
    """
    upper, lower = (vars(seen) for seen in (found[0], found[-1]))
    names = ("value", "standard_error", "half_width")
    means = {name: (upper[name].astype(np.float64) + lower[name]) / 2.0 for name in names}
    means["far_error"] = np.abs(lower["value"].astype(np.float64) - upper["value"]) / 2.0
    known = has_value(found[0].status)
    return {name: np.where(known, values, np.nan) for name, values in means.items()}
