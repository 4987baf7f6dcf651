"""Opening of netCDF files with xarray: GDAL ignores units, gaps and the order of coordinates, and some nodata values."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import xarray as xr
from rioxarray.exceptions import RioXarrayError

from warpsample.host.arguments import quote
from warpsample.host.extras import missing

_CLASSIC, _HDF5 = (b"CDF\1", b"CDF\2"), b"\x89HDF"
_SUPERBLOCK, _SIZE_AT = 52, {0: 40, 1: 44, 2: 28, 3: 28}  # bytes of it, and place of the file's size in it by its version
_SUFFIXES = (".nc", ".nc4", ".cdf", ".grd")  # of netCDF-4 files, which begin like all HDF5 files

DAMAGED = (ValueError, TypeError, LookupError, OSError, RuntimeError, AttributeError, MemoryError)
"""Errors of SciPy, h5py and xarray for damaged files."""


def is_netcdf(path: str) -> bool:
    """Return whether a file is a netCDF file that xarray can open: of the classic format, or netCDF-4 by its suffix."""
    start = _read_start(path)
    return start[:4] in _CLASSIC or (start[:4] == _HDF5 and Path(path).suffix.lower() in _SUFFIXES)


def _read_start(path: str) -> bytes:
    """Return the first bytes of a file, or b"" for a pipe, a folder or a missing file."""
    if not Path(path).is_file():  # reading a pipe may never end
        return b""
    with Path(path).open("rb") as stream:
        return stream.read(_SUPERBLOCK)


def _stored_size(start: bytes) -> int:
    """Return the size of an HDF5 file that its superblock states, or 0 in unknown versions.

    HDF5 reads missing bytes as 0.
    """
    at = _SIZE_AT.get(start[8] if len(start) == _SUPERBLOCK else -1)
    return 0 if at is None else int.from_bytes(start[at : at + 8], "little")


@contextmanager
def open_netcdf(path: str) -> Iterator[xr.DataArray]:
    """Open the only variable of a netCDF file with dimensions y and x, decoded by xarray, within a `with` statement.

    Rows are from north to south, as in most rasters, if the file has coordinates.

    Raises:
        ValueError: The file is damaged, or it has no such variable, or several.
        ModuleNotFoundError: A netCDF-4 file, and h5netcdf is not installed.
    """
    with _open_dataset(path) as dataset:
        placed = [name for name in dataset.data_vars if _is_placed(dataset[name])]
        if len(placed) != 1:
            names = ", ".join(map(str, placed or dataset.data_vars)) or "nothing"
            raise ValueError(
                f"source: got {path!r} with {names}, want one variable with y and x; pass xarray.open_dataset(path)[NAME]"
            )
        array = dataset[placed[0]]
        rows = array.rio.y_dim
        if rows in array.coords and array.sizes[rows] > 1 and array[rows][0] < array[rows][-1]:
            array = array.isel({rows: slice(None, None, -1)})
        yield array


def _open_dataset(path: str) -> xr.Dataset:
    """Open a netCDF file with xarray."""
    start = _read_start(path)
    is_classic = start[:4] in _CLASSIC
    if not is_classic and Path(path).stat().st_size < _stored_size(start):
        raise ValueError(f"source: got {path!r}, whose end is missing: the file is damaged")
    if not is_classic and find_spec("h5netcdf") is None:
        raise missing(f"source: got {path!r}, which needs h5netcdf", "h5netcdf")
    how = {"decode_times": False, "decode_coords": "all", "cache": False}
    try:
        if not is_classic:
            with import_module("h5py").File(path, "r") as file:  # h5netcdf would print tracebacks, of damaged objects, too
                file.visititems(lambda *_: None)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about several nodata values, and attributes of other variables
            return xr.open_dataset(path, engine="scipy" if is_classic else "h5netcdf", **how)
    except DAMAGED as error:
        raise explain_damage(path, error) from error


def valid_range_of(array: xr.DataArray) -> tuple[float, float]:
    """Return the range of valid heights that the attributes of a decoded netCDF variable state; infinite without any.

    Limits of the stored type are packed as the numbers are; others are in the unit of the heights.

    Raises:
        ValueError: A limit is not a number.
    """
    about, encoding = array.attrs, array.encoding
    try:
        limits = np.ravel(about.get("valid_range", [-np.inf, np.inf]))
        low, high = (np.asarray(about.get(*one)).item() for one in (("valid_min", limits[0]), ("valid_max", limits[1])))
        stored = [np.asarray(about.get(name, limits)).dtype for name in ("valid_min", "valid_max")]
        is_packed = [kind.newbyteorder("=") == np.dtype(encoding["dtype"]).newbyteorder("=") for kind in stored]
        scale, offset = float(encoding.get("scale_factor", 1.0)), float(encoding.get("add_offset", 0.0))
        ends = [scale * end + offset if packed else end for end, packed in zip((low, high), is_packed, strict=True)]
        kind = array.dtype.type if array.dtype.kind == "f" else float  # float32 heights equal to a limit are within
        return float(kind(ends[0])), float(kind(ends[1]))
    except (TypeError, ValueError, LookupError):
        given = {name: value for name, value in about.items() if str(name).startswith("valid_")}
        raise ValueError(f"source: got attributes {quote(given)}, want numbers") from None


def explain_damage(path: str, error: Exception) -> ValueError:
    """Return the error for a damaged netCDF file, with the reason of the library that reads it."""
    reason = (str(error).strip().splitlines() or [type(error).__name__])[0]
    return ValueError(f"source: got {path!r}, which cannot be read as netCDF: {reason}")


def _is_placed(array: xr.DataArray) -> bool:
    """Return whether an array has the dimensions y and x."""
    try:
        return {array.rio.y_dim, array.rio.x_dim} <= set(array.dims)
    except RioXarrayError:
        return False
