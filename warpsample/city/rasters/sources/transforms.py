"""Checks of raster transforms, and conversion between transforms and coordinates of cell centres."""

from collections.abc import Callable
from itertools import product

import numpy as np
import xarray as xr
from affine import Affine

from warpsample.host.arguments import quote

_DEGREES = 360.0, 90.0  # largest longitude and latitude
_STEEP = 50.0
"""Ratio of relief to the diagonal of a window above which coordinates cannot be lengths.

In degrees, a second of arc is 31 m, so 1 m over 10 cells is a ratio of 250. In metres, 5 x 5 cells of 2 cm would have 7 m of
relief; a model 1 m wide and 0.3 m high has 0.2.
"""
_STEEP_TERRAIN, _PEAKS = 5.0, 2000.0
"""The same ratio for more than 2,000 m of relief in a block. The highest cliffs of the Earth have 1,300 m.

This ratio finds rasters whose cells are arc minutes or more, and windows therefore wide.
"""
_KEPT = (5.0, 95.0)  # percentiles of heights that bound the relief: a mast, or a few damaged cells, must not decide
_WINDOW, _BLOCK = 512, 32  # rows and columns of a window, and of its blocks that are checked by themselves
_INEXACT = 0.01  # largest relative error of a cell size by rounded coordinates
_APART = 1e-3  # largest rounding of coordinates, in cells


def affine_of(transform: object) -> Affine:
    """Return six numbers as an affine.Affine; raise a TypeError for anything else."""
    try:
        return Affine(*(float(number) for number in tuple(transform)[:6]))
    except (TypeError, ValueError):
        raise TypeError(
            f"source: got {quote(transform)} for its transform, want an affine.Affine or its numbers a, b, c, d, e, f"
        ) from None


def check_place(transform: Affine, what: str) -> None:
    """Raise a ValueError for a raster without a transform, for which readers return the identity."""
    if transform == Affine.identity():
        raise ValueError(
            f"source: got {what}, which has no place on a map, want a raster with a transform; "
            "pass (array, affine, crs) to state the raster's position"
        )


def check_cells(transform: Affine, shape: tuple[int, int]) -> None:
    """Raise a ValueError for cells without area, or too small for the precision of their coordinates in float64."""
    numbers = np.array(transform[:6])
    size = max(np.abs(numbers[[0, 1, 3, 4]]).max(), 1e-300)
    if not np.isfinite(numbers).all() or abs(transform.determinant) <= 1e-12 * size**2:
        hint = "" if size > 1e-300 else "; for a raster turned by 90 degrees, which rioxarray misreads, pass its path"
        wants = f"want a transform whose cells have an area{hint}"
        raise ValueError(f"source: got the transform {tuple(numbers.tolist())}, {wants}")
    corners = [transform @ corner for corner in ((0, 0), (shape[1], 0), (0, shape[0]), shape[::-1])]
    farthest, side = np.abs(corners).max(), np.hypot(numbers[[0, 1]], numbers[[3, 4]]).min()
    if not np.spacing(farthest) <= _APART * side:
        raise ValueError(
            f"source: got coordinates up to {farthest:g} of cells {side:g} long, want coordinates that float64 can "
            "distinguish"
        )


def check_lengths(transform: Affine, shape: tuple[int, int], heights: Callable[[slice, slice], np.ndarray]) -> None:
    """Raise a ValueError for a raster without a CRS whose coordinates must be degrees, judged by its relief.

    Up to nine windows are read: in the corners, at the edges and in the middle. The message names `source`.
    """
    corners = np.array([transform @ corner for corner in ((0, 0), (shape[1], 0), (0, shape[0]), shape[::-1])])
    sides = np.hypot(np.array(transform[:2]), np.array(transform[3:5]))
    if (np.abs(corners) > np.array(_DEGREES) + sides.max()).any():
        return
    for rows, columns in product(*map(_windows, shape)):
        relief = _impossible_relief(heights(rows, columns), sides)
        if relief:
            raise ValueError(
                "source: got cells of {:g} around ({:g}, {:g}) without a CRS, which look like degrees, and heights that "
                "differ by {:g}; want lengths; set the CRS of the raster, and reproject the raster to metres".format(
                    sides.max(), *corners.mean(axis=0), relief
                )
            )


def _windows(size: int) -> list[slice]:
    """Return the rows or columns to check: the first, middle and last `_WINDOW` rows or columns, or all."""
    last = max(0, size - _WINDOW)
    return [slice(start, start + min(size, _WINDOW)) for start in sorted({0, last // 2, last})]


def _impossible_relief(heights: np.ndarray, sides: np.ndarray) -> float:
    """Return the height difference in a window of cells if it is impossibly large for the sizes of the cells, else 0."""
    relief, least = _relief(heights), max(_PEAKS, _STEEP_TERRAIN * np.hypot(*(sides * _BLOCK)))
    if relief > _STEEP * np.hypot(*(sides * heights.shape[::-1])):
        return relief
    if not np.fmax.reduce(heights, axis=None) - np.fmin.reduce(heights, axis=None) > least:
        return 0.0
    blocks = product(*(range(0, size, _BLOCK) for size in heights.shape))
    reliefs = (_relief(heights[row : row + _BLOCK, column : column + _BLOCK]) for row, column in blocks)
    return next((found for found in reliefs if found > least), 0.0)


def _relief(heights: np.ndarray) -> float:
    """Return the difference between the 95th and 5th percentile of heights; 0 without heights."""
    known = heights[~np.isnan(heights)]
    return float(np.subtract(*np.percentile(known, _KEPT[::-1]))) if known.size else 0.0


def transform_of(array: xr.DataArray, dims: tuple[str, str], got: str) -> Affine:
    """Return the transform of an array from its coordinates, or from the stored transform if coordinates are missing.

    Coordinates have precedence, because the stored transform may belong to a larger array of which this one is a part.
    """
    if not all(name in array.coords and array.coords[name].ndim == 1 and array.sizes[name] > 1 for name in dims):
        transform = array.rio.transform()
        check_place(transform, got)
        return transform
    steps, starts = [], []
    for name in dims:
        centres = array.coords[name].to_numpy()
        steps.append(step := step_of(centres, name))
        starts.append(float(centres[0]) - 0.5 * step)
    stored = array.rio.transform()
    if stored.b or stored.d:
        raise ValueError(
            f"source: got {got}, which is turned and has coordinates without the turn; write it as a GeoTIFF, or pass "
            "(array, affine, crs)"
        )
    transform = Affine(steps[1], 0.0, starts[1], 0.0, steps[0], starts[0])
    check_place(transform, got)  # rioxarray gives these coordinates to a file without a transform
    return transform


def step_of(centres: np.ndarray, name: str) -> float:
    """Return the step of coordinates of cell centres; raise an error if they are not numbers or not evenly spaced."""
    if centres.dtype.kind not in "fiu":
        raise TypeError(f"source: got coordinates {name!r} of dtype {centres.dtype}, want real numbers")
    step = (float(centres[-1]) - float(centres[0])) / (len(centres) - 1)
    off = np.abs(centres - (centres[0] + step * np.arange(len(centres)))).max()
    rounding = np.spacing(np.abs(centres).max()) if centres.dtype.kind == "f" else 0.0  # of float32
    if not off <= 0.1 * abs(step) + rounding:
        raise ValueError(f"source: got coordinates {name!r} that are not evenly spaced, want cells of one size")
    if rounding > _INEXACT * abs(step) * (len(centres) - 1):
        raise ValueError(
            f"source: got coordinates {name!r} rounded to {rounding:g}, too coarse for cells of about {abs(step):g}; want "
            "float64, or pass (array, affine, crs)"
        )
    return step


def coordinates_of(transform: Affine, shape: tuple[int, int]) -> dict[str, np.ndarray]:
    """Return x and y of the cell centres, with the same bits as in rioxarray; an empty dictionary for a rotated raster."""
    a, b, c, d, e, f = transform[:6]
    if b or d:
        return {}
    return {"y": np.arange(shape[0]) * e + (0.5 * e + f), "x": np.arange(shape[1]) * a + (0.5 * a + c)}
