"""Checks of raster transforms, and conversion between transforms and coordinates of cell centres."""

from collections.abc import Callable

import numpy as np
import xarray as xr
from affine import Affine

from warpsample.host.arguments import told

_DEGREES = 360.0, 90.0  # largest longitude and latitude
_ARC_MINUTE = 0.02  # degrees, slightly more than an arc minute: rasters with larger cells resolve no shading terrain
_STEEP = 50.0
"""Least relief over the diagonal of a raster in degrees: a second of arc is 31 m, so 1 m over 10 cells is a ratio of 250.

In metres, with cells of at most 2 cm, it would be 7 m of relief in 5 x 5 cells; a model 1 m wide and 0.3 m high has 0.2.
"""
_RELIEF = 1.0
_LOOKED_AT = 512  # rows and columns in the middle whose relief is checked
_APART = 1e-3  # largest rounding of coordinates, in cells


def affine_of(transform: object) -> Affine:
    """Return six numbers as an affine.Affine; raise a TypeError for anything else."""
    try:
        return Affine(*(float(number) for number in tuple(transform)[:6]))
    except (TypeError, ValueError):
        raise TypeError(
            f"source: got {told(transform)} for its transform, want an affine.Affine or its numbers a, b, c, d, e, f"
        ) from None


def check_place(transform: Affine, crs: object, what: str) -> None:
    """Raise a ValueError for a raster without a transform and without a CRS."""
    if transform == Affine.identity() and crs is None:
        raise ValueError(
            f"source: got {what}, which has no place on a map, want a raster with a transform; "
            "pass (array, affine, None) to state its position"
        )


def check_cells(transform: Affine, shape: tuple[int, int]) -> None:
    """Raise a ValueError for cells without area, or too small for the precision of their coordinates in float64."""
    numbers = np.array(transform[:6])
    size = max(np.abs(numbers[[0, 1, 3, 4]]).max(), 1e-300)
    if not np.isfinite(numbers).all() or abs(transform.determinant) <= 1e-12 * size**2:
        raise ValueError(f"source: got the transform {tuple(numbers.tolist())}, want one whose cells have an area")
    corners = [transform @ corner for corner in ((0, 0), (shape[1], 0), (0, shape[0]), shape[::-1])]
    farthest, side = np.abs(corners).max(), np.hypot(numbers[[0, 1]], numbers[[3, 4]]).min()
    if not np.spacing(farthest) <= _APART * side:
        raise ValueError(
            f"source: got coordinates up to {farthest:g} of cells {side:g} long, want some that float64 can distinguish"
        )


def check_lengths(transform: Affine, shape: tuple[int, int], heights: Callable[[slice, slice], np.ndarray]) -> None:
    """Raise a ValueError for a raster without a CRS whose coordinates must be degrees, judged by the relief in its middle.

    The message names `source`.
    """
    corners = np.array([transform @ corner for corner in ((0, 0), (shape[1], 0), (0, shape[0]), shape[::-1])])
    sides = np.hypot(np.array(transform[:2]), np.array(transform[3:5]))
    if sides.max() > _ARC_MINUTE or (np.abs(corners) > np.array(_DEGREES) + sides.max()).any():
        return
    found = heights(*(slice(max(0, (size - _LOOKED_AT) // 2), (size + _LOOKED_AT) // 2) for size in shape))
    known = found[~np.isnan(found)]
    relief = float(np.ptp(known)) if known.size else 0.0
    if relief > max(_RELIEF, _STEEP * np.hypot(*(sides * found.shape[::-1]))):
        raise ValueError(
            "source: got no CRS, heights that differ by {:g}, and cells of {:g} about {:g}, {:g}, as in degrees; want "
            "lengths: give it its CRS, and reproject it".format(relief, sides.max(), *corners.mean(axis=0))
        )


def transform_of(array: xr.DataArray, dims: tuple[str, str]) -> Affine:
    """Return the transform of an array from its coordinates, or from the stored transform if coordinates are missing.

    Coordinates have precedence, because the stored transform may belong to a larger array of which this one is a part.
    """
    if not all(name in array.coords and array.coords[name].ndim == 1 and array.sizes[name] > 1 for name in dims):
        transform = array.rio.transform()
        check_place(transform, array.rio.crs, "an xarray.DataArray")
        return transform
    steps, starts = [], []
    for name in dims:
        centres = array.coords[name].to_numpy()
        if centres.dtype.kind not in "fiu":
            raise TypeError(f"source: got coordinates {name!r} of dtype {centres.dtype}, want real numbers")
        step = (float(centres[-1]) - float(centres[0])) / (len(centres) - 1)
        off = np.abs(centres - (centres[0] + step * np.arange(len(centres)))).max()
        if not off <= 0.1 * abs(step):  # coordinates may be float32
            raise ValueError(f"source: got coordinates {name!r} that are not evenly spaced, want cells of one size")
        steps.append(step)
        starts.append(float(centres[0]) - 0.5 * step)
    return Affine(steps[1], 0.0, starts[1], 0.0, steps[0], starts[0])


def coordinates_of(transform: Affine, shape: tuple[int, int]) -> dict[str, np.ndarray]:
    """Return the coordinates of cell centres, bit for bit as rioxarray computes them; empty for a rotated raster."""
    a, b, c, d, e, f = transform[:6]
    if b or d:
        return {}
    return {"y": np.arange(shape[0]) * e + (0.5 * e + f), "x": np.arange(shape[1]) * a + (0.5 * a + c)}
