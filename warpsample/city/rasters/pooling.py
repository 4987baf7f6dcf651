"""Highest and lowest heights of a raster's surface: in each cell, and in blocks of cells."""

from dataclasses import replace

import numpy as np
from affine import Affine

from warpsample.city.rasters.canopy import Canopy
from warpsample.city.rasters.grid import Bounds, resample_extremes
from warpsample.city.rasters.sources.reader import RasterReader

_BAND = 1 << 22  # cells per reading step


def pool_raster(reader: RasterReader, canopy: Canopy | None, size: int, model: str, *, joined: bool) -> Bounds:
    """Compute the highest and lowest height in each block of `size` x `size` cells of a raster.

    The lower height is NaN for a block with cells without data, and for a block that the raster's edge cuts. With "tin" it
    is also NaN for a block next to a cell without data, because triangles do not cover the whole block. The same holds for
    a block at the raster's edge, unless the surface is `joined` with terrain beyond.
    """
    rows, columns = reader.shape
    grow = int(model != "block")
    step = max(1, _BAND // max(columns, 1) // size) * size
    uppers, lowers = [], []
    for first in range(0, rows, step):
        begin, end = max(0, first - grow), min(rows, first + step + grow)
        band = slice(begin, end), slice(0, columns)
        heights = reader.read(*band)
        grid = replace(reader.outline, height=heights)
        tops = heights if canopy is None else np.fmax(heights, canopy.crowns(grid, *band).top)
        without = np.isnan(heights)
        if model == "tin":
            without = _mask_uncovered(heights, (begin == 0, end == rows), joined=joined)
        highest = _widen_extremes(tops, grow, np.fmax)
        lowest = np.where(without, np.nan, _widen_extremes(heights, grow, np.fmin))
        kept = slice(first - begin, min(first + step, rows) - begin)
        for made, heights, pick in ((uppers, highest, np.fmax), (lowers, lowest, np.minimum)):
            part = heights[kept]
            padding = [(0, -part.shape[0] % size), (0, -columns % size)]
            part = np.pad(part, padding, constant_values=np.nan)
            part = pick.reduce(part.reshape(len(part) // size, size, -1), axis=1)
            made.append(pick.reduce(part.reshape(len(part), -1, size), axis=2))
    return Bounds(np.concatenate(uppers), np.concatenate(lowers), Affine.scale(size))


def bounds_beyond(heights: np.ndarray, own: Bounds, where: Affine, model: str) -> Bounds:
    """Return the bounds of the surface of another raster, which may have cells without data.

    The surface of a cell depends on its neighbours. A neighbour without data has the heights of the raster itself, if any.

    Args:
        heights: (rows, columns) heights of the other raster.
        own: Bounds of the raster itself, from `pool_raster`.
        where: Affine map from cells of the other raster to those of the raster itself.
        model: Surface model.
    """
    if model == "block":
        return Bounds(heights, heights, where)
    missing = np.isnan(heights)
    upper = lower = heights
    if missing.any():
        upper, lower = (np.where(missing, some, heights) for some in resample_extremes(own, where, heights.shape))
    highest = np.where(missing, _widen_extremes(heights, 1, np.fmax), _widen_extremes(upper, 1, np.fmax))
    without = missing | _mask_uncovered(upper, (True, True), joined=False) if model == "tin" else missing
    return Bounds(highest, np.where(without, np.nan, _widen_extremes(lower, 1, np.fmin)), where)


def _mask_uncovered(heights: np.ndarray, at_edge: tuple[bool, bool], *, joined: bool) -> np.ndarray:
    """Return the mask of the cells that triangles between centres do not cover: one of their eight neighbours has no data.

    Args:
        heights: Heights of a band of rows.
        at_edge: Whether the first and the last row are at the raster's edge. Outside the band, neighbours count as data.
        joined: Whether neighbours beyond the raster's edge have data.
    """
    beyond = not joined
    padded = np.pad(np.isnan(heights), 1, constant_values=beyond)
    padded[0, 1:-1], padded[-1, 1:-1] = (beyond and edge for edge in at_edge)
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
