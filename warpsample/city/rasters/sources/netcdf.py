"""Checks of netCDF files that GDAL reads without a word: a missing end, uneven coordinates, units, and nodata values."""

import re
from collections.abc import Iterator
from contextlib import suppress
from math import inf
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city.rasters.sources.coding import Coding
from warpsample.city.rasters.sources.opening import open_raster
from warpsample.city.rasters.sources.reference import check_unit, crs_of
from warpsample.city.rasters.sources.transforms import step_of

_NUMBER = re.compile(r"[-+]?(?:nan|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)", re.IGNORECASE)
_LIMITS = "missing_value", "valid_min", "valid_max"
_USUAL = {"x", "y", "easting", "northing"}  # names of coordinates, which have no attributes in some files


def check_end(path: str) -> str:
    """Raise a ValueError for a classic netCDF file without its end; return the format if it is of 64-bit data (CDF-5)."""
    from scipy.io import netcdf_file

    with Path(path).open("rb") as stream:
        signature = stream.read(4)
    if signature in (b"CDF\1", b"CDF\2"):
        try:
            with netcdf_file(path, mmap=True):
                pass
        except (ValueError, TypeError, LookupError, OSError) as error:
            raise ValueError(f"source: got {path!r}, whose end is missing: the file is damaged") from error
    return "CDF-5" if signature == b"CDF\5" else ""


def check_coordinates(file: Any) -> None:
    """Raise a ValueError if coordinates of an open netCDF raster are uneven or in another unit than that of the CRS.

    GDAL looks at the first, the middle and the last step of coordinates, and at no unit.
    """
    a, b, c, d, e, f = file.transform[:6]
    if b or d or not file.files:
        return
    axes = (c + 0.5 * a, a, file.width), (f + 0.5 * e, e, file.height)
    for name, centres, unit in _list_coordinates(file):
        for first, step, count in axes:
            ends = np.array([first, first + (count - 1) * step])
            if len(centres) == count > 1 and np.allclose(np.sort(centres[[0, -1]]), np.sort(ends), 0.0, abs(step)):
                step_of(centres, name)
                check_unit(unit, crs_of(file.crs), f"coordinates {name!r}")


def _list_coordinates(file: Any) -> Iterator[tuple[str, np.ndarray, str]]:
    """Yield the name, the values, and the unit or standard name of each variable of one dimension in a netCDF file."""
    for name in sorted({key.partition("#")[0] for key in file.tags() if "#" in key} | _USUAL):
        address = f'netCDF:"{file.files[0]}":{name}'
        with suppress(FileNotFoundError, ValueError), open_raster(address) as variable:  # else it has no such numbers
            about = variable.tags(1)
            if variable.height == 1 and variable.count == 1 and about.get("NETCDF_VARNAME") == name:
                yield name, variable.read(1)[0], about.get("units") or about.get("standard_name", "")


def coding_of(file: Any, band: int) -> Coding:
    """Return how a netCDF file stores heights, with all its nodata values and its range, of which GDAL ignores some."""
    about = file.tags(band)
    numbers = {name: [float(text) for text in _NUMBER.findall(about.get(name, ""))] for name in _LIMITS}
    lowest, highest = (next(iter(numbers[name]), limit) for name, limit in (("valid_min", -inf), ("valid_max", inf)))
    scaling = file.scales[band - 1], file.offsets[band - 1]
    return Coding(file.nodatavals[band - 1], *scaling, tuple(numbers["missing_value"]), (lowest, highest))
