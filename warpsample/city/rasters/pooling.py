"""Highest and lowest heights of a raster's surface: in each cell, and in blocks of cells."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from affine import Affine

from warpsample.city.rasters.canopy import Canopy
from warpsample.city.rasters.grid import Bounds, mask_covered, resample_extremes
from warpsample.city.rasters.sources.reader import RasterReader

_BAND = 1 << 22  # cells per reading step


class Frame(NamedTuple):
    """Masks of the cells without data in the ring of cells around a raster.

    Attributes:
        top: (columns + 2,) or a single bool, in the row above the first.
        bottom: (columns + 2,) or a single bool, in the row below the last.
        left: (rows,) or a single bool, in the column before the first.
        right: (rows,) or a single bool, in the column after the last.
    """

    top: np.ndarray | bool = True
    bottom: np.ndarray | bool = True
    left: np.ndarray | bool = True
    right: np.ndarray | bool = True

    @classmethod
    def of(cls, heights: np.ndarray, where: Affine, shape: tuple[int, int]) -> "Frame":
        """Find the cells around a raster of a shape for which another raster, with some heights, has no data.

        `where` is the affine map from cells of the other raster to those of the raster itself.
        """
        rows, columns = shape
        places = ((-1, -1, 1, columns + 2), (-1, rows, 1, columns + 2), (-1, 0, rows, 1), (columns, 0, rows, 1))
        other = Bounds(heights, heights, where)
        return cls(
            *(
                np.isnan(resample_extremes(other, Affine.translation(column, row), (down, along))[1]).ravel()
                for column, row, down, along in places
            )
        )

    def rows(self, first: int, last: int, count: int) -> "Frame":
        """Return the masks for some of `count` rows; beyond these, rows of the raster count as data."""
        sides = (side if isinstance(side, bool) else side[first:last] for side in self[2:])
        return Frame(self.top if first == 0 else False, self.bottom if last == count else False, *sides)


def pool_raster(
    reader: RasterReader, canopy: Canopy | None, size: int, model: str, frame: Frame
) -> tuple[Bounds, np.ndarray]:
    """Compute the highest and lowest height in each block of `size` x `size` cells of a raster.

    Return them, and the mask of the blocks that contain cells without data.

    The lower height is NaN for a block with cells without data, and for a block that the raster's edge cuts. With "tin" it
    is also NaN for a block next to a cell without data, because triangles do not cover the whole block. `frame` states
    which cells around the raster have no data.
    """
    rows, columns = reader.shape
    grow = int(model != "block")
    step = max(1, _BAND // max(columns, 1) // size) * size
    uppers, lowers, holes = [], [], []
    for first in range(0, rows, step):
        begin, end = max(0, first - grow), min(rows, first + step + grow)
        band = slice(begin, end), slice(0, columns)
        heights = reader.read(*band)
        grid = replace(reader.outline, height=heights)
        tops = heights if canopy is None else np.fmax(heights, canopy.crowns(grid, *band).top)
        missing = np.isnan(heights)
        without = _mask_uncovered(missing, frame.rows(begin, end, rows)) if model == "tin" else missing
        highest = _widen_extremes(tops, grow, np.fmax)
        lowest = np.where(without, np.nan, _widen_extremes(heights, grow, np.fmin))
        kept = slice(first - begin, min(first + step, rows) - begin)
        for made, whole, pick, beyond in (
            (uppers, highest, np.fmax, np.nan),
            (lowers, lowest, np.minimum, np.nan),
            (holes, missing, np.logical_or, False),
        ):
            part = whole[kept]
            padding = [(0, -part.shape[0] % size), (0, -columns % size)]
            part = np.pad(part, padding, constant_values=beyond)
            part = pick.reduce(part.reshape(len(part) // size, size, -1), axis=1)
            made.append(pick.reduce(part.reshape(len(part), -1, size), axis=2))
    return Bounds(np.concatenate(uppers), np.concatenate(lowers), Affine.scale(size)), np.concatenate(holes)


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
    outline = np.broadcast_to(0.0, shape)
    gaps = np.isnan(heights) & ~mask_covered(Bounds(outline, outline, Affine.identity()), where, heights.shape)
    if holes.any():
        some = holes.astype(np.float64)
        gaps |= resample_extremes(Bounds(some, some, Affine.scale(size)), where, heights.shape)[0] == 1.0
    return gaps


def bounds_beyond(heights: np.ndarray, own: Bounds, where: Affine, model: str, gaps: np.ndarray | None) -> Bounds:
    """Return the bounds of the surface of another raster, which may have cells without data.

    The surface of a cell depends on its neighbours. A neighbour without data has the heights of the raster itself, if any.

    Args:
        heights: (rows, columns) heights of the other raster.
        own: Bounds of the raster itself, from `pool_raster`.
        where: Affine map from cells of the other raster to those of the raster itself.
        model: Surface model.
        gaps: Mask of the cells of the other raster without data, from `find_gaps`, for "tin"; None for other models.
    """
    if model == "block":
        return Bounds(heights, heights, where)
    missing = np.isnan(heights)
    upper = lower = heights
    if missing.any():
        upper, lower = (np.where(missing, some, heights) for some in resample_extremes(own, where, heights.shape))
    highest = np.where(missing, _widen_extremes(heights, 1, np.fmax), _widen_extremes(upper, 1, np.fmax))
    without = missing if gaps is None else missing | _mask_uncovered(gaps, Frame())
    return Bounds(highest, np.where(without, np.nan, _widen_extremes(lower, 1, np.fmin)), where)


def _mask_uncovered(missing: np.ndarray, frame: Frame) -> np.ndarray:
    """Return the mask of cells that triangles between centres do not cover: one of their eight neighbours has no data."""
    padded = np.pad(missing, 1)
    padded[0], padded[-1], padded[1:-1, 0], padded[1:-1, -1] = frame
    along = padded[:-2] | padded[1:-1] | padded[2:]
    return along[:, :-2] | along[:, 1:-1] | along[:, 2:]


def _widen_extremes(heights: np.ndarray, grow: int, pick: np.ufunc) -> np.ndarray:
    """Return the highest or lowest height among each cell and its eight neighbours, or the heights unchanged for `grow` = 0.

    `pick` is numpy.fmax or numpy.fmin.
    """
    if not grow:
        return heights
    padded = np.pad(heights, 1, constant_values=np.nan)
    along = pick(pick(padded[:-2], padded[1:-1]), padded[2:])
    return pick(pick(along[:, :-2], along[:, 1:-1]), along[:, 2:])
