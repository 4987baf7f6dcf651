"""Terrain beyond the margin of a tile, pooled: columns that hide at least what it hides, and others that hide at most that.

Cells of the raster, or of a coarser one where that ends, are pooled by the highest and by the lowest, in rings about the
tile whose cells double in size as the distance does, a fiftieth of it. A ray that meets the terrain meets the upper columns,
and one that meets the lower ones meets the terrain: what is seen lies between what is seen with the two.
"""

from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from affine import Affine

from warpsample.city.rasters.canopy import Canopy, Crowns, prisms
from warpsample.city.rasters.grid import Grid
from warpsample.city.rasters.reader import RasterReader
from warpsample.city.rasters.scenery import Columns, Part, joined

_FINENESS = 50  # cells of a ring that its distance has at least: a horizon turns by a fiftieth of its slope's sine
_EARTH, _REFRACTION = 6_371_000.0, 0.13  # m; and how much less light bends than the ground
_BAND = 1 << 22  # cells that are read at a time
_ALMOST = 1e-6  # of a cell: coordinates of corners that are rounded


@dataclass(frozen=True, eq=False)
class Bounds:
    """Heights of the cells of a raster, from above and from below.

    Attributes:
        upper: (rows, columns) float64; NaN where there is nothing.
        lower: the same; NaN where there may be nothing.
        transform: from (column, row) of these to those of the raster that is cut into tiles.
    """

    upper: np.ndarray
    lower: np.ndarray
    transform: Affine


@dataclass(frozen=True, eq=False)
class FarField:
    """What is known of the terrain beyond the margins of all tiles.

    Attributes:
        own: the raster's own cells, pooled by `size`.
        beyond: of another raster, where the own one ends; or None.
        size: cells of the raster, in rows and columns, that a cell of the nearest ring has: a power of 2.
        outline: the raster without heights.
        metres: in the unit of the coordinates.
    """

    own: Bounds
    beyond: Bounds | None
    size: int
    outline: Grid

    @classmethod
    def of(
        cls, reader: RasterReader, other: RasterReader | None, *, margin: int, model: str, canopy: Canopy | None = None
    ) -> "FarField":
        """Reads all of a raster, by bands of rows, and all of the other one.

        Args:
            reader: of the raster.
            other: of one on the same map, or None.
            margin: cells around a tile that are as they are.
            model: of the surface: of blocks heights are those of cells, else of cells and their neighbours.
            canopy: crowns that the upper columns hide, too.
        """
        size, beyond = 1 << (max(1, margin // _FINENESS).bit_length() - 1), None
        if other is not None:
            heights = other.read(slice(None), slice(None))
            beyond = Bounds(heights, heights, ~reader.transform @ other.transform)
        return cls(_pooled(reader, canopy, size, int(model != "block")), beyond, size, reader.outline)

    def columns(self, tile: tuple[slice, slice], near: tuple[slice, slice], lowest: float) -> list[Columns]:
        """What makes the upper, and what makes the lower columns; nothing if there is nothing beyond.

        Args:
            tile: rows and columns of the points; far columns are lowered by the distance from them, as the Earth is round.
            near: rows and columns that are there as they are, `window_of` the tile.
            lowest: of the heights there: columns reach below it, so that no ray passes underneath them.
        """
        levels = [level for level in self._levels(tile, near) if not np.isnan(level[0]).all()]
        known = [some for level in levels for some in level[:2] if not np.isnan(some).all()]
        floor = min([lowest, *map(np.nanmin, known)]) - 1.0
        return [partial(self._columns, levels, which, floor) for which in (0, 1)] if levels else []

    def _columns(self, levels: list[tuple[np.ndarray, np.ndarray, Affine]], which: int, floor: float) -> Part:
        return joined([self._prisms(level[which], level[2], floor) for level in levels])

    def window_of(self, tile: tuple[slice, slice], margin: int) -> tuple[slice, slice]:
        """The rows and columns of a tile with its margin, out to where cells of the nearest ring begin."""
        lowest = [(part.start - margin) // self.size * self.size for part in tile]
        highest = [-(-(part.stop + margin) // self.size) * self.size for part in tile]
        return tuple(slice(low, high) for low, high in zip(lowest, highest, strict=True))

    def _levels(self, tile: tuple[slice, slice], near: tuple[slice, slice]) -> list[tuple[np.ndarray, np.ndarray, Affine]]:
        """Heights from above and from below of all rings, and where their cells are on the raster."""
        levels = [self._inside(near, size) for size in dict.fromkeys((1, self.size))] if self.beyond else []
        inner, size = near, self.size
        reach = _FINENESS * size
        while any(part.start > low or part.stop < high for part, (low, high) in zip(inner, self._extent(), strict=True)):
            whole = 2 * size
            outer = tuple(
                slice((part.start - reach) // whole * whole, -(-(part.stop + reach) // whole) * whole) for part in inner
            )
            upper, lower, where = self._pooled(outer, size)
            hole = tuple(
                slice((i.start - o.start) // size, (i.stop - o.start) // size) for i, o in zip(inner, outer, strict=True)
            )
            upper[hole] = lower[hole] = np.nan
            levels.append((upper, lower, where))
            inner, size, reach = outer, whole, 2 * reach
        return [(*self._lowered(tile, *level), level[2]) for level in levels]

    def _extent(self) -> list[tuple[float, float]]:
        """The first and the last row, and column, of all that is known."""
        rows, columns = self.outline.height.shape
        x, y = [0.0, columns], [0.0, rows]
        if self.beyond:
            height, width = self.beyond.upper.shape
            for corner in ((0, 0), (width, 0), (0, height), (width, height)):
                column, row = self.beyond.transform @ corner
                x.append(column)
                y.append(row)
        return [(min(y), max(y)), (min(x), max(x))]

    def _pooled(self, window: tuple[slice, slice], size: int) -> tuple[np.ndarray, np.ndarray, Affine]:
        """(upper, lower) heights of cells so large in a window, and where these are."""
        rows, columns = (np.arange(part.start, part.stop, size) for part in window)
        whole, none = self._own_part(rows, columns, size)
        where = Affine.translation(window[1].start, window[0].start) @ Affine.scale(size)
        shape = len(rows), len(columns)
        upper, lower = _scattered(self.own, where, shape)
        if self.beyond:
            highest, lowest = _scattered(self.beyond, where, shape)
            upper = np.where(whole, upper, np.fmax(upper, highest))
            lower = np.where(whole, lower, np.where(none, lowest, np.nan))
        return upper, lower, where

    def _own_part(self, rows: np.ndarray, columns: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
        """Whether cells that begin at these rows and columns are within the raster, and whether they are outside."""
        within, outside = [], []
        for first, most in zip((rows, columns), self.outline.height.shape, strict=True):
            within.append((first >= 0) & (first + size <= most))
            outside.append((first + size <= 0) | (first >= most))
        return within[0][:, None] & within[1], outside[0][:, None] | outside[1]

    def _inside(self, near: tuple[slice, slice], size: int) -> tuple[np.ndarray, np.ndarray, Affine]:
        """What is within a window but beyond the raster's edge: in large cells, in small ones where an edge cuts those."""
        rows, columns = (np.arange(part.start, part.stop, size) for part in near)
        large = (np.arange(part.start, part.stop, size) // self.size * self.size for part in near)
        _, outside = self._own_part(rows, columns, size)
        whole, beyond = self._own_part(*large, self.size)
        chosen = outside if size == self.size else outside & ~whole & ~beyond
        where = Affine.translation(near[1].start, near[0].start) @ Affine.scale(size)
        heights = _scattered(self.beyond, where, (len(rows), len(columns)))
        return (*(np.where(chosen, height, np.nan) for height in heights), where)

    def _lowered(
        self, tile: tuple[slice, slice], upper: np.ndarray, lower: np.ndarray, where: Affine
    ) -> tuple[np.ndarray, np.ndarray]:
        """Heights as they seem from the tile, by the Earth's curvature less refraction: by the nearest and the farthest."""
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

    def _prisms(self, heights: np.ndarray, where: Affine, floor: float) -> Part:
        """Columns from the floor to these heights."""
        outline = self.outline
        grid = Grid(heights, outline.transform @ where, outline.crs, outline.metres, outline.dims, {})
        return prisms(grid, Crowns(np.where(np.isnan(heights), np.nan, floor), heights))


def _pooled(reader: RasterReader, canopy: Canopy | None, size: int, grow: int) -> Bounds:
    """A raster by cells so large; of the lowest there is none where a cell is missing, or at edges that cut it."""
    rows, columns = reader.shape
    step = max(1, _BAND // max(columns, 1) // size) * size
    uppers, lowers = [], []
    for first in range(0, rows, step):
        begin, end = max(0, first - grow), min(rows, first + step + grow)
        band = slice(begin, end), slice(0, columns)
        heights = reader.read(*band)
        grid = replace(reader.outline, height=heights)
        tops = heights if canopy is None else np.fmax(heights, canopy.crowns(grid, *band).top)
        highest, lowest = _spread(tops, grow, np.fmax), _spread(heights, grow, np.fmin)
        lowest = np.where(np.isnan(heights), np.nan, lowest)
        kept = slice(first - begin, min(first + step, rows) - begin)
        for made, heights, pick in ((uppers, highest, np.fmax), (lowers, lowest, np.minimum)):
            part = heights[kept]
            padding = [(0, -part.shape[0] % size), (0, -columns % size)]
            part = np.pad(part, padding, constant_values=np.nan)
            part = pick.reduce(part.reshape(len(part) // size, size, -1), axis=1)
            made.append(pick.reduce(part.reshape(len(part), -1, size), axis=2))
    return Bounds(np.concatenate(uppers), np.concatenate(lowers), Affine.scale(size))


def _spread(heights: np.ndarray, grow: int, pick: np.ufunc) -> np.ndarray:
    """The highest or the lowest of each cell and its neighbours."""
    if not grow:
        return heights
    padded = np.pad(heights, 1, constant_values=np.nan)
    along = pick(pick(padded[:-2], padded[1:-1]), padded[2:])
    return pick(pick(along[:, :-2], along[:, 1:-1]), along[:, 2:])


def _scattered(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """(highest, lowest) of all that overlaps each of the cells of a lattice."""
    upper, lower = np.full(shape, -np.inf), np.full(shape, np.inf)
    rows, columns, box = _reached(bounds, where, shape)
    part = slice(rows[0], rows[1]), slice(columns[0], columns[1])
    highest, lowest = bounds.upper[part].ravel(), bounds.lower[part].ravel()
    first, last = (np.stack(ends).reshape(2, -1) for ends in box)
    span = (last - first).max(axis=1, initial=0)
    for down in range(span[0]):
        for right in range(span[1]):
            i, j = first[0] + down, first[1] + right
            inside = (i < last[0]) & (j < last[1]) & (i >= 0) & (j >= 0) & (i < shape[0]) & (j < shape[1])
            at = i[inside], j[inside]
            np.fmax.at(upper, at, highest[inside])
            np.minimum.at(lower, at, lowest[inside])
    upper[np.isinf(upper)] = np.nan
    lower[np.isinf(lower) | ~_covered(bounds, where, shape)] = np.nan
    return upper, lower


def _reached(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> tuple[Any, Any, Any]:
    """Rows and columns that reach into a lattice, and the lattice's cells, first and after the last, that each covers."""
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


def _covered(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> np.ndarray:
    """Whether all corners of a lattice's cells, and so these, are within a raster."""
    row, column = np.mgrid[: shape[0] + 1, : shape[1] + 1]
    a, b, c, d, e, f = (~bounds.transform @ where)[:6]
    x, y = a * column + b * row + c, d * column + e * row + f
    rows, columns = bounds.upper.shape
    inside = (x > -_ALMOST) & (x < columns + _ALMOST) & (y > -_ALMOST) & (y < rows + _ALMOST)
    return inside[:-1, :-1] & inside[1:, :-1] & inside[:-1, 1:] & inside[1:, 1:]
