"""Highest and lowest heights of a raster's surface: in each cell, and in blocks of cells."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from affine import Affine

from warpsample.city.rasters.canopy import Canopy
from warpsample.city.rasters.grid import Bounds, mask_covered, resample_extremes
from warpsample.city.rasters.sources.reader import RasterReader

_BAND = 1 << 22  # cells per reading step


class Frame(NamedTuple):
    """Cells in the ring around a raster: their heights, or a mask.

    Attributes:
        top: (columns + 2,) or a single value, in the row above the first.
        bottom: (columns + 2,) or a single value, in the row below the last.
        left: (rows,) or a single value, in the column before the first.
        right: (rows,) or a single value, in the column after the last.
    """

    top: np.ndarray | float
    bottom: np.ndarray | float
    left: np.ndarray | float
    right: np.ndarray | float

    def around(self, cells: np.ndarray, first: int) -> np.ndarray:
        """Return rows of a raster, from the row `first` on, with one further cell on each side.

        The further cells above and below are those of the whole raster, also if the given rows are only a part of it.
        """
        padded = np.pad(cells, 1)
        sides = (side[first : first + len(cells)] if np.ndim(side) else side for side in self[2:])
        padded[0], padded[-1], padded[1:-1, 0], padded[1:-1, -1] = *self[:2], *sides
        return padded


NOTHING = Frame(*[np.nan] * 4)
"""Heights in the ring around a raster that nothing surrounds."""


class Surroundings(NamedTuple):
    """Ring of cells around a raster with the extremes of another raster's heights in each cell.

    Attributes:
        highest: Highest heights; NaN without data.
        lowest: Lowest heights; NaN without data.
        missing: Mask of the cells that are not entirely covered by data.
    """

    highest: Frame = NOTHING
    lowest: Frame = NOTHING
    missing: Frame = Frame(True, True, True, True)

    @classmethod
    def of(cls, heights: np.ndarray, where: Affine, shape: tuple[int, int]) -> "Surroundings":
        """Find the extremes of some heights of another raster around a raster of a shape.

        `where` is the affine map from cells of the other raster to those of the raster itself.
        """
        rows, columns = shape
        sides = []
        for column, row, down, along in (
            (-1, -1, 1, columns + 2),
            (-1, rows, 1, columns + 2),
            (-1, 0, rows, 1),
            (columns, 0, rows, 1),
        ):
            place = Affine.translation(column, row), (down, along)
            missing = np.isnan(resample_extremes(Bounds(heights, heights, where), *place)[1])
            sides.append([found.ravel() for found in (*_resample_data(Bounds(heights, heights, where), *place), missing)])
        return cls(*(Frame(*side) for side in zip(*sides, strict=True)))


def pool_raster(
    reader: RasterReader, canopy: Canopy | None, size: int, model: str, around: Surroundings
) -> tuple[Bounds, np.ndarray]:
    """Compute the highest and lowest height in each block of `size` x `size` cells of a raster.

    Return them, and the mask of the blocks that contain cells without data.

    The lower height is NaN for a block with cells without data, and for a block that the raster's edge cuts. With "tin" it
    is also NaN for a block next to a cell without data, because triangles do not cover the whole block. `around` has the
    cells of another raster around this one.
    """
    rows, columns = reader.shape
    grow = int(model != "block")
    step = max(1, _BAND // max(columns, 1) // size) * size
    uppers, lowers, holes = [], [], []
    for first in range(0, rows, step):
        begin, end = max(0, first - grow), min(rows, first + step + grow)
        band = slice(begin, end), slice(0, columns)
        heights = reader.read(*band)
        tops = _read_tops(reader, canopy, band, heights)
        missing = np.isnan(heights)
        without = _mask_near(around.missing.around(missing, begin)) if model == "tin" else missing
        highest = _widen_extremes(around.highest.around(tops, begin), np.fmax) if grow else tops
        lowest = _widen_extremes(around.lowest.around(heights, begin), np.fmin) if grow else heights
        kept = slice(first - begin, min(first + step, rows) - begin)
        for made, whole, pick, beyond in (
            (uppers, highest, np.fmax, np.nan),
            (lowers, np.where(without, np.nan, lowest), np.minimum, np.nan),
            (holes, missing, np.logical_or, False),
        ):
            part = whole[kept]
            padding = [(0, -part.shape[0] % size), (0, -columns % size)]
            part = np.pad(part, padding, constant_values=beyond)
            part = pick.reduce(part.reshape(len(part) // size, size, -1), axis=1)
            made.append(pick.reduce(part.reshape(len(part), -1, size), axis=2))
    return Bounds(np.concatenate(uppers), np.concatenate(lowers), Affine.scale(size)), np.concatenate(holes)


def read_border(reader: RasterReader, canopy: Canopy | None) -> Iterator[Bounds]:
    """Yield the heights in a raster's first and last row and column, with and without crowns.

    No other cells of the raster are neighbours of the terrain beyond its edge.
    """
    rows, columns = (slice(0, count) for count in reader.shape)
    last_row, last_column = (slice(count - 1, count) for count in reader.shape)
    for band in ((slice(0, 1), columns), (last_row, columns), (rows, slice(0, 1)), (rows, last_column)):
        heights = reader.read(*band)
        yield Bounds(_read_tops(reader, canopy, band, heights), heights, Affine.translation(band[1].start, band[0].start))


def find_gaps(heights: np.ndarray, where: Affine, holes: np.ndarray, size: int, shape: tuple[int, int]) -> np.ndarray:
    """Return the mask of the cells of another raster in which neither that raster nor the raster itself has data.

    Inside the raster itself only its own data count.

    Args:
        heights: (rows, columns) heights of the other raster.
        where: Affine map from cells of the other raster to those of the raster itself.
        holes: Mask of the blocks of the raster itself that contain cells without data, from `pool_raster`.
        size: Side of these blocks.
        shape: Numbers of rows and columns of the raster itself.
    """
    gaps = np.isnan(heights) & ~_mask_inside(where, heights.shape, shape)
    if holes.any():
        some = holes.astype(np.float64)
        gaps |= resample_extremes(Bounds(some, some, Affine.scale(size)), where, heights.shape)[0] == 1.0
    return gaps


def bounds_beyond(
    heights: np.ndarray, border: Iterable[Bounds], where: Affine, shape: tuple[int, int], gaps: np.ndarray | None
) -> Bounds:
    """Return the bounds of the surface of another raster around a raster, for models in which cells depend on neighbours.

    A neighbour inside the raster itself has the raster's heights, whatever the other raster has there.

    Args:
        heights: (rows, columns) heights of the other raster.
        border: Heights of the raster's first and last row and column, from `read_border`.
        where: Affine map from cells of the other raster to those of the raster itself.
        shape: Numbers of rows and columns of the raster itself.
        gaps: Mask of the cells of the other raster without data, from `find_gaps`, for "tin"; None for other models.
    """
    missing = np.isnan(heights)
    alone = np.where(_mask_inside(where, heights.shape, shape), np.nan, heights)
    upper, lower = alone.copy(), alone.copy()
    for part in border:
        corner, cells = _find_window(part, where, heights.shape)
        highest, lowest = _resample_data(part, where @ Affine.translation(*corner[::-1]), cells)
        at = tuple(slice(first, first + count) for first, count in zip(corner, cells, strict=True))
        upper[at], lower[at] = np.fmax(upper[at], highest), np.fmin(lower[at], lowest)
    highest, with_own, lowest = (
        _widen_extremes(np.pad(cells, 1, constant_values=np.nan), pick)
        for cells, pick in ((alone, np.fmax), (upper, np.fmax), (lower, np.fmin))
    )
    without = missing if gaps is None else missing | _mask_near(np.pad(gaps, 1, constant_values=True))
    return Bounds(np.where(missing, highest, with_own), np.where(without, np.nan, lowest), where)


def _find_window(part: Bounds, where: Affine, shape: tuple[int, int]) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return the first row and column, and the numbers of rows and columns, of a grid's cells that a raster may overlap.

    Args:
        part: Raster.
        where: Affine map from cells of the grid.
        shape: Numbers of rows and columns of the grid.
    """
    rows, columns = part.upper.shape
    to_grid = ~where @ part.transform
    x, y = np.array([to_grid @ corner for corner in ((0, 0), (columns, 0), (0, rows), (columns, rows))]).T
    first, last = (
        np.clip((np.floor(y.min()) - 1, np.floor(x.min()) - 1), 0, shape).astype(int),
        np.clip((np.ceil(y.max()) + 1, np.ceil(x.max()) + 1), 0, shape).astype(int),
    )
    return tuple(first), tuple(last - first)


def _mask_inside(where: Affine, cells: tuple[int, int], shape: tuple[int, int]) -> np.ndarray:
    """Return the mask of the cells of another raster that lie entirely within a raster of a shape.

    Args:
        where: Affine map from cells of the other raster to those of the raster itself.
        cells: Numbers of rows and columns of the other raster.
        shape: Numbers of rows and columns of the raster itself.
    """
    outline = np.broadcast_to(0.0, shape)
    return mask_covered(Bounds(outline, outline, Affine.identity()), where, cells)


def _resample_data(bounds: Bounds, where: Affine, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Return the highest and lowest heights, of those that are not NaN, that overlap each cell, as `resample_extremes`."""
    highest, depth = (
        resample_extremes(Bounds(some, some, bounds.transform), where, shape)[0] for some in (bounds.upper, -bounds.lower)
    )
    return highest, -depth


def _read_tops(reader: RasterReader, canopy: Canopy | None, band: tuple[slice, slice], heights: np.ndarray) -> np.ndarray:
    """Return some heights of a raster, or the tops of crowns above them."""
    if canopy is None:
        return heights
    return np.fmax(heights, canopy.crowns(replace(reader.outline, height=heights), *band).top)


def _mask_near(missing: np.ndarray) -> np.ndarray:
    """Return the mask of cells that triangles between centres do not cover: one of their eight neighbours has no data.

    `missing` has one further cell on each side.
    """
    along = missing[:-2] | missing[1:-1] | missing[2:]
    return along[:, :-2] | along[:, 1:-1] | along[:, 2:]


def _widen_extremes(heights: np.ndarray, pick: np.ufunc) -> np.ndarray:
    """Return the highest or lowest height among each cell and its eight neighbours; `pick` is numpy.fmax or numpy.fmin.

    `heights` has one further cell on each side.
    """
    along = pick(pick(heights[:-2], heights[1:-1]), heights[2:])
    return pick(pick(along[:, :-2], along[:, 1:-1]), along[:, 2:])
