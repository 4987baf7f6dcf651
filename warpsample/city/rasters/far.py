"""Simplified terrain far from a tile: columns too high and columns too low, between which the true result lies.

Around a tile and its margin, cells of the raster are pooled to their highest and lowest heights, in rings. Cells of a ring
double in size when the distance doubles; their size is at most a fiftieth of the distance. Another raster covers the terrain
beyond the edges, also inside the margin, in cells by the same rule. A ray that hits the terrain hits the upper columns; a
ray that hits the lower columns hits the terrain. So the true value lies between the values with upper and with lower
columns.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np
from affine import Affine

from warpsample.city.rasters.canopy import Canopy, Crowns, build_prisms
from warpsample.city.rasters.fringe import fringe_bounds
from warpsample.city.rasters.grid import Bounds, Grid, resample_extremes
from warpsample.city.rasters.pooling import Surroundings, bounds_beyond, find_gaps, pool_raster, read_border
from warpsample.city.rasters.scenery import Columns, Part, join_triangles
from warpsample.city.rasters.sources.reader import RasterReader

_FINENESS = 50  # smallest distance of a ring in cells of the ring
_EARTH, _REFRACTION = 6_371_000.0, 0.13  # radius in m; curvature of light rays as a fraction of the Earth's curvature

Window = tuple[slice, slice]
"""Rows and columns."""


@dataclass(frozen=True, eq=False)
class FarField:
    """Simplified distant terrain of a raster: upper and lower bounds of heights, in cells that grow with distance.

    Attributes:
        own: The raster's own cells, pooled in blocks of `size` x `size`.
        surroundings: Another raster for the terrain beyond the edges, or None.
        size: Side of a cell of the nearest ring, in cells of the raster; a power of 2.
        outline: The raster without heights.
        fringe: Bounds of the heights of the cells next to the raster's edge, see `add_fringe`; None if there is no other
            raster, or if the surface of a cell does not depend on its neighbours.
    """

    own: Bounds
    surroundings: Bounds | None
    size: int
    outline: Grid
    fringe: Bounds | None = None

    @classmethod
    def of(
        cls, reader: RasterReader, other: RasterReader | None, *, margin: int, model: str, canopy: Canopy | None = None
    ) -> "FarField":
        """Compute bounds of a raster's heights in coarse cells, and read the raster of the terrain beyond its edges.

        Args:
            reader: Reader of the raster.
            other: Reader of a raster on the same map for the terrain beyond the edges, or None.
            margin: Number of full-resolution cells around a tile.
            model: Surface model. With "block" heights are those of cells, else the extremes of cells and their neighbours.
            canopy: Crowns to include in the upper columns, or None.
        """
        size = _size_of_ring(margin)
        if other is None:
            return cls(pool_raster(reader, canopy, size, model, Surroundings())[0], None, size, reader.outline)
        heights, where = other.read(slice(None), slice(None)), ~reader.transform @ other.transform
        if model == "block":
            own, _ = pool_raster(reader, canopy, size, model, Surroundings())
            return cls(own, Bounds(heights, heights, where), size, reader.outline)
        own, holes = pool_raster(reader, canopy, size, model, Surroundings.of(heights, where, reader.shape))
        gaps = find_gaps(heights, where, holes, size, reader.shape) if model == "tin" else None
        beyond = bounds_beyond(heights, read_border(reader, canopy), where, reader.shape, gaps)
        return cls(own, beyond, size, reader.outline, fringe_bounds(heights, beyond))

    def columns(self, tile: Window, near: Window, lowest: float) -> list[Columns]:
        """Return two functions that build a tile's distant terrain as triangles: with too high and with too low columns.

        The list is empty if there is no terrain outside the full-resolution part.

        Args:
            tile: Rows and columns of the points. Columns are lowered by distance, because of the Earth's curvature.
            near: Rows and columns at full resolution, from `window_of`.
            lowest: Lowest height of the full-resolution part. Columns reach below it, so that no ray passes underneath.
        """
        levels = [level for level in self._pool_rings(tile, near) if not np.isnan(level[0]).all()]
        known = [some for level in levels for some in level[:2] if not np.isnan(some).all()]
        floor = min([lowest, *map(np.nanmin, known)]) - 1.0
        return [partial(self._build_columns, levels, which, floor) for which in (0, 1)] if levels else []

    def _build_columns(self, levels: list[tuple[np.ndarray, np.ndarray, Affine]], which: int, floor: float) -> Part:
        """Build the triangles of all columns of distant terrain, at upper (`which` = 0) or lower (`which` = 1) bounds."""
        return join_triangles([self._build_prisms(level[which], level[2], floor) for level in levels])

    def _pool_rings(self, tile: Window, near: Window) -> list[tuple[np.ndarray, np.ndarray, Affine]]:
        """Return bounds of the terrain's heights around a tile, in rings of cells that grow with distance.

        Return the upper heights, the lower heights and the transform of each ring.
        """
        levels = list(self._read_other(tile, near)) if self.surroundings else []
        inner, size = near, self.size
        reach = _FINENESS * size
        while any(part.start > low or part.stop < high for part, (low, high) in zip(inner, self._extent(), strict=True)):
            whole = 2 * size
            outer = _widen_window(inner, reach, whole)
            upper, lower, where = self._pool_window(outer, size)
            hole = tuple(
                slice((i.start - o.start) // size, (i.stop - o.start) // size) for i, o in zip(inner, outer, strict=True)
            )
            upper[hole] = lower[hole] = np.nan
            levels.append((upper, lower, where))
            inner, size, reach = outer, whole, 2 * reach
        return [(*self._lower_by_curvature(tile, *level), level[2]) for level in levels]

    def _extent(self) -> list[tuple[float, float]]:
        """Return the first and last row, and the first and last column, that the two rasters cover together."""
        rows, columns = self.outline.height.shape
        x, y = [0.0, columns], [0.0, rows]
        if self.surroundings:
            height, width = self.surroundings.upper.shape
            for corner in ((0, 0), (width, 0), (0, height), (width, height)):
                column, row = self.surroundings.transform @ corner
                x.append(column)
                y.append(row)
        return [(min(y), max(y)), (min(x), max(x))]

    def _pool_window(self, window: Window, size: int) -> tuple[np.ndarray, np.ndarray, Affine]:
        """Return bounds of the terrain's heights in a window, in blocks of `size` x `size` cells.

        Return the upper heights, the lower heights and the transform of the blocks.
        """
        rows, columns = (np.arange(part.start, part.stop, size) for part in window)
        whole, none = self._mask_own_blocks(rows, columns, size)
        where = Affine.translation(window[1].start, window[0].start) @ Affine.scale(size)
        shape = len(rows), len(columns)
        upper, lower = resample_extremes(self.own, where, shape)
        if self.surroundings:
            highest, lowest = resample_extremes(self.surroundings, where, shape)
            upper = np.where(whole, upper, np.fmax(upper, highest))
            lower = np.where(whole, lower, np.where(none, lowest, np.nan))
        return upper, lower, where

    def _mask_own_blocks(self, rows: np.ndarray, columns: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the mask of blocks entirely inside the raster and the mask of blocks entirely outside.

        The blocks have `size` x `size` cells and begin at the given rows and columns.
        """
        within, outside = [], []
        for first, most in zip((rows, columns), self.outline.height.shape, strict=True):
            within.append((first >= 0) & (first + size <= most))
            outside.append((first + size <= 0) | (first >= most))
        return within[0][:, None] & within[1], outside[0][:, None] | outside[1]

    def _read_other(self, tile: Window, near: Window) -> Iterator[tuple[np.ndarray, np.ndarray, Affine]]:
        """Yield bounds of heights of the terrain beyond the raster's edge, inside a window, from the surrounding raster.

        Blocks have a side of 1 cell, and of 2, 4, ... cells from 50 times this distance from the tile on. Where the raster's
        edge cuts a large block, blocks of 1 cell replace it.
        """
        rings, inner = {}, [slice(0, 0), slice(0, 0)]
        for size in (1 << power for power in range(self.size.bit_length())):
            outer = near if size == self.size else _widen_window(tile, 2 * _FINENESS * size, 2 * size)
            rings[size], inner = (outer, inner), outer
        single = _mask_ring(near, 1, *rings[1])
        for size, ring in rings.items():
            whole, none = self._mask_own_blocks(*(np.arange(part.start, part.stop) // size * size for part in near), size)
            single |= _mask_ring(near, 1, *ring) & ~whole & ~none
        for size, ring in rings.items():
            _, outside = self._mask_own_blocks(*(np.arange(part.start, part.stop, size) for part in near), size)
            chosen = outside & (single if size == 1 else _mask_ring(near, size, *ring))
            if chosen.any():
                where = Affine.translation(near[1].start, near[0].start) @ Affine.scale(size)
                upper, lower = resample_extremes(self.surroundings, where, chosen.shape)
                yield np.where(chosen, upper, np.nan), np.where(chosen, lower, np.nan), where

    def _lower_by_curvature(
        self, tile: Window, upper: np.ndarray, lower: np.ndarray, where: Affine
    ) -> tuple[np.ndarray, np.ndarray]:
        """Lower bounds of distant heights by the drop due to the Earth's curvature, less atmospheric refraction.

        Upper heights are reduced for the smallest distance from the tile, lower heights for the largest.
        """
        a, b, _, d, e, _ = self.outline.transform[:6]
        longest, shortest = np.linalg.svd([[a, b], [d, e]], compute_uv=False)
        gaps, spans = [], []
        for part, count, first, size in zip(tile, upper.shape, (where.f, where.c), (where.e, where.a), strict=True):
            begin = first + size * np.arange(count)
            gaps.append(np.maximum(0.0, np.maximum(begin - part.stop, part.start - begin - size)))
            spans.append(np.maximum(begin + size - part.start, part.stop - begin))
        scale = (1.0 - _REFRACTION) * self.outline.metres / (2.0 * _EARTH)
        nearest, farthest = (np.square(x[:, None]) + np.square(y) for x, y in (gaps, spans))
        return upper - scale * shortest**2 * nearest, lower - scale * longest**2 * farthest

    def _build_prisms(self, heights: np.ndarray, where: Affine, floor: float) -> Part:
        """Build the triangles of one column per cell, from the height `floor` to the given height of the cell."""
        outline = self.outline
        grid = Grid(heights, outline.transform @ where, outline.crs, outline.metres, outline.dims, {})
        return build_prisms(grid, Crowns(np.where(np.isnan(heights), np.nan, floor), heights))


def window_of(tile: Window, margin: int) -> Window:
    """Return the rows and columns at full resolution for a tile and its margin, perhaps beyond the raster's edges.

    The margin is extended to whole cells of the nearest ring.
    """
    return _widen_window(tile, margin, _size_of_ring(margin))


def _size_of_ring(margin: int) -> int:
    """Return the side of a cell of the nearest ring, in cells of the raster."""
    return 1 << (max(1, margin // _FINENESS).bit_length() - 1)


def _widen_window(window: Window, reach: int, whole: int) -> Window:
    """Return a window widened by `reach` cells on all sides, and further to whole blocks of `whole` x `whole` cells."""
    rows, columns = (
        slice((part.start - reach) // whole * whole, -(-(part.stop + reach) // whole) * whole) for part in window
    )
    return rows, columns


def _mask_ring(near: Window, size: int, outer: Window, inner: Window) -> np.ndarray:
    """Return the mask of the blocks of a window, of `size` x `size` cells, inside one window and outside another."""
    masks = []
    for window in (outer, inner):
        rows, columns = (
            (np.arange(part.start, part.stop, size) >= one.start) & (np.arange(part.start, part.stop, size) < one.stop)
            for part, one in zip(near, window, strict=True)
        )
        masks.append(rows[:, None] & columns)
    return masks[0] & ~masks[1]
