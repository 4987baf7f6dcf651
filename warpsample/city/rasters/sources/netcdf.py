"""Opening of netCDF files with xarray: GDAL ignores units, gaps and the order of coordinates, and some nodata values."""

import json
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import xarray as xr
from rioxarray.exceptions import RioXarrayError

from warpsample.city.rasters.sources.coding import VALID, Coding, stored_attributes
from warpsample.host.arguments import is_file, quote
from warpsample.host.engine import check_memory
from warpsample.host.extras import REFUSED, missing, run_program

_CLASSIC, _HDF5 = (b"CDF\1", b"CDF\2"), b"\x89HDF"
_SUPERBLOCK, _SIZE_AT = 52, {0: 40, 1: 44, 2: 28, 3: 28}  # bytes of it, and place of the file's size in it by its version
_SUFFIXES = (".nc", ".nc4", ".cdf", ".grd")  # of netCDF-4 files, which begin like all HDF5 files

# HDF5 follows some damaged lists without an end, and crashes on others, so a process of its own reads a file first. The file
# counts as damaged after so many seconds of a processor, and one more for so many bytes:
_SECONDS, _BYTES = 30, 10_000_000
_TRY = """import itertools, json, math, sys
import h5py
{plugins}
try:
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, ({seconds}, {seconds}))
except ImportError:  # on Windows
    pass

def read_about(name, item):
    dict(item.attrs)
    is_raster = isinstance(item, h5py.Dataset) and "/" not in name and sum(size > 1 for size in item.shape or ()) < 3
    if not is_raster:  # which is not read later
        return
    if item.is_virtual or item.external:  # numbers of missing files would be 0
        raise ValueError(f"the numbers of {{name!r}} are in other files")
    if item.dtype.hasobject:
        item[()]
    elif item.chunks and item.size:
        read_chunks(name, item)

def read_chunks(name, item):
    places = []
    item.id.chunk_iter(lambda chunk: places.append(chunk.byte_offset))
    lost = math.prod(-(-size // step) for size, step in zip(item.shape, item.chunks)) - sum(map(bool, places))
    if 0 in places:
        raise ValueError(f"{{lost}} chunks of {{name!r}} are missing")
    if lost:
        unwritten[name] = lost, item.fillvalue.item() if item.dtype.kind in "iuf" else 0.0
    for place in itertools.product(*map(range, (0,) * item.ndim, item.shape, item.chunks)) if not lost else ():
        item.id.read_direct_chunk(place)  # an error where a damaged index leads past a chunk
    axis = next((axis for axis, size in enumerate(item.shape) if size > 1), 0)
    for first in range(0, item.shape[axis], item.chunks[axis]):
        item[(slice(None),) * axis + (slice(first, first + item.chunks[axis]),)]

try:
    unwritten = {{}}
    with h5py.File({file!r}, "r") as file:
        read_about("", file)
        file.visititems(read_about)
    print(json.dumps(unwritten))
except Exception as error:
    print(error or type(error).__name__)
    sys.exit({refused})
"""

DAMAGED = (ValueError, TypeError, LookupError, OSError, RuntimeError, AttributeError, MemoryError)
"""Errors of SciPy, h5py and xarray for damaged files."""


def is_netcdf(path: str) -> bool:
    """Return whether a file is a netCDF file that xarray can open: of the classic format, or netCDF-4 by its suffix."""
    is_hdf5 = _read_start(path)[:4] == _HDF5
    return is_classic(path) or (is_hdf5 and Path(path).suffix.lower() in _SUFFIXES)


def is_classic(path: str) -> bool:
    """Return whether a file is a netCDF file of the classic format."""
    return _read_start(path)[:4] in _CLASSIC


def _read_start(path: str) -> bytes:
    """Return the first bytes of a file, or b"" for a pipe, a folder or a missing file."""
    if not is_file(path):  # reading a pipe may never end
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
    """Open the only variable of a netCDF file with dimensions y and x within a `with` statement, in its stored numbers.

    Rows are from north to south, as in most rasters, if the file has coordinates.

    Raises:
        ValueError: The file is damaged, or it has no such variable, or several.
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
        for name in {rows, array.rio.x_dim} & array.coords.keys():
            array = array.assign_coords({name: xr.conventions.decode_cf_variable(name, array[name].variable)})
        if rows in array.coords and array.sizes[rows] > 1 and array[rows][0] < array[rows][-1]:
            array = array.isel({rows: slice(None, None, -1)})
        yield array


def check_netcdf(path: str) -> dict[str, tuple[int, float]]:
    """Raise an error for a netCDF file that is damaged, or needs a package or more memory than is free.

    Returns:
        for each variable with chunks that are not written: their number, and the number that their cells have instead.

    Raises:
        ValueError: A netCDF-4 file that HDF5 cannot read.
        ModuleNotFoundError: A netCDF-4 file, and h5netcdf is not installed.
        MemoryError: A file of the classic format, which is read as a whole, does not fit into the free memory.
    """
    if is_classic(path):
        needed = 2 * Path(path).stat().st_size
        check_memory(needed, f"the variables of {path!r}", "convert it to netCDF-4, which is read in parts")
        return {}
    return _check_hdf5(path)


def _check_hdf5(path: str) -> dict[str, tuple[int, float]]:
    """Raise an error for a netCDF-4 file that is damaged, which a process of its own finds, or if h5netcdf is missing.

    Returns the chunks that are not written, as `check_netcdf`.
    """
    size = Path(path).stat().st_size
    if size < _stored_size(_read_start(path)):
        raise ValueError(f"source: got {path!r}, whose end is missing: the file is damaged")
    if find_spec("h5netcdf") is None:
        raise missing(f"source: got {path!r}, which needs h5netcdf", "h5netcdf")
    seconds = _SECONDS + size // _BYTES
    plugins = "import hdf5plugin" if "hdf5plugin" in sys.modules else ""  # filters of further compressions
    status, found = run_program(_TRY.format(file=path, seconds=seconds, refused=REFUSED, plugins=plugins))
    told = found.decode().strip()
    if status:
        raise explain_damage(path, told or f"HDF5 crashed, or found no end in {seconds} s ({status})")
    return json.loads(told.splitlines()[-1])


def _open_dataset(path: str) -> xr.Dataset:
    """Open a netCDF file with xarray: one of the classic format is read into memory, since a map of it may be cut short."""
    engine = {"engine": "scipy", "mmap": False} if is_classic(path) else {"engine": "h5netcdf"}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about several nodata values, and attributes of other variables
            return xr.open_dataset(
                path, mask_and_scale=False, decode_times=False, decode_coords="all", cache=False, **engine
            )
    except DAMAGED as error:
        raise explain_damage(path, error) from error


def coding_of(array: xr.DataArray, got: str) -> Coding:
    """Read nodata values, scale, offset and valid range from the attributes of a netCDF variable of stored numbers.

    Raises:
        ValueError: An attribute is not a number; the message describes the array as in `got`.
    """
    coding, given = Coding.of_array(array, got), stored_attributes(array)[1]
    try:
        first, last = np.ravel(given.get("valid_range", [-np.inf, np.inf]))
        lowest, highest = (np.asarray(given.get(*one)) for one in (("valid_min", first), ("valid_max", last)))
        return replace(coding, valid=_stored_range(lowest, highest, array.dtype, coding))
    except (TypeError, ValueError):
        valid = {name: given[name] for name in VALID if name in given}
        raise ValueError(f"source: got attributes {quote(valid)} of {got}, want numbers") from None


def _stored_range(lowest: np.ndarray, highest: np.ndarray, stored: np.dtype, coding: Coding) -> tuple[float, float]:
    """Return the lowest and the highest stored number that is valid.

    Limits are stored numbers if both are integers, or have the same type; others are heights.
    """
    low, high = -np.inf, np.inf
    for limit, is_low in ((lowest, True), (highest, False)):
        if {limit.dtype.kind, stored.kind} <= {"i", "u"} or limit.dtype.newbyteorder("=") == stored.newbyteorder("="):
            number, is_lower = limit.item(), is_low
        else:
            number, is_lower = (limit.item() - coding.offset) / coding.scale, is_low != (coding.scale < 0.0)
            number = float(stored.type(number)) if stored.kind == "f" else round(number, 6)  # equal ones are valid
        low, high = (max(low, number), high) if is_lower else (low, min(high, number))
    return low, high


def explain_damage(path: str, error: Exception | str) -> ValueError:
    """Return the error for a damaged netCDF file, with the reason of the library that reads it."""
    reason = (str(error).strip().splitlines() or [type(error).__name__])[0]
    return ValueError(f"source: got {path!r}, which cannot be read as netCDF: {reason}")


def _is_placed(array: xr.DataArray) -> bool:
    """Return whether an array has the dimensions y and x."""
    try:
        return {array.rio.y_dim, array.rio.x_dim} <= set(array.dims)
    except RioXarrayError:
        return False
