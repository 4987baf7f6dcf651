"""Checked readers of rasters of heights: files, xarray.DataArrays, and arrays with a transform."""

import re
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from affine import Affine
from rasterio.enums import ColorInterp
from rasterio.windows import Window
from rioxarray.exceptions import MissingSpatialDimensionError

from warpsample.city.rasters.sources.coding import Coding
from warpsample.city.rasters.sources.damage import check_undamaged
from warpsample.city.rasters.sources.netcdf import (
    check_netcdf,
    coding_of,
    explain_damage,
    is_classic,
    is_netcdf,
    open_netcdf,
)
from warpsample.city.rasters.sources.opening import WANTS, open_raster
from warpsample.city.rasters.sources.reader import RasterReader
from warpsample.city.rasters.sources.reference import (
    REPROJECT,
    check_unit,
    check_upward,
    crs_of,
    describe_stretch,
    height_metres_of,
    length_of,
    metres_of,
)
from warpsample.city.rasters.sources.transforms import (
    affine_of,
    check_cells,
    check_lengths,
    check_place,
    coordinates_of,
    transform_of,
)
from warpsample.host.arrays import as_real
from warpsample.host.neighbours import describe_type

_ARRAY = "an xarray.DataArray"
_HEIGHT_UNIT = re.compile(rb"^\s*Zunits\s+\"?(\w+)", re.IGNORECASE | re.MULTILINE)


def reader_of(source: Any) -> RasterReader:
    """Open a raster of heights (file, DataArray, or array with transform), and return a reader; no heights are read yet.

    Args:
        source: Path of a raster with one band that GDAL reads; an xarray.DataArray (NumPy or Dask) of two dimensions, or
            with one entry in each other dimension; or (array, affine.Affine or its six numbers, a CRS or None). Cells
            without data are masked, NaN, infinite, beyond 2147483646 or its negative, the raster's nodata value, -32767,
            -32768, or -9999, -99999 and so on to -999999999.

    Raises:
        TypeError, ValueError, FileNotFoundError: Another object, several bands, degrees, depths, or no place on a map.

    Warns:
        UserWarning: Unknown unit of heights with coordinates in another unit than metres; an unsupported unit; or a map on
            which distances differ from the ground by 5 % or more, such as Web Mercator.
    """
    if isinstance(source, str | PathLike):
        path = fspath(source)
        return _netcdf_reader(path) if is_netcdf(path) else _file_reader(path)
    if isinstance(source, xr.DataArray):
        return _data_array_reader(source)
    if isinstance(source, tuple) and len(source) == 3:
        return _array_reader(*source)
    raise TypeError(f"source: got {describe_type(source)}, want {WANTS}")


def ground_of(source: Any) -> RasterReader:
    """Open the main raster of a call, and return a reader; without a CRS, coordinates are taken as metres.

    Raises:
        TypeError, ValueError, FileNotFoundError: As `reader_of`; or no CRS, and coordinates that must be degrees.

    Warns:
        UserWarning: A file or an xarray.DataArray without a CRS; a tuple with None states that there is none.
    """
    reader = reader_of(source)
    if reader.crs is None:
        check_lengths(reader.transform, reader.shape, reader.read)
        if not isinstance(source, tuple):
            got = repr(fspath(source)) if isinstance(source, str | PathLike) else _ARRAY
            warnings.warn(
                f"source: got {got} without a CRS; its coordinates are taken as metres, and the map's y axis as true north; "
                "pass (array, affine, None) to state that the raster has no CRS",
                stacklevel=4,
            )
    return reader


def _file_reader(path: str) -> RasterReader:
    """Open a raster file with rasterio, and return a reader of its heights."""
    with open_raster(path) as file:
        bands = [n for n, colour in enumerate(file.colorinterp, 1) if colour != ColorInterp.alpha]
        if len(bands) != 1:
            raise ValueError(
                f"source: got {path!r} with {len(bands)} bands, want one band of heights; extract the band, for example "
                "with gdal_translate -b 1"
            )
        check_place(file.transform, repr(path))
        check_undamaged(path, file)
        band = bands[0]
        check_upward(file.tags() | file.tags(band))
        read = partial(_band, path, band, Coding.of_file(file, band))
        return _reader(file.shape, file.transform, file.crs, file.units[band - 1] or _read_prj_unit(file), read)


def _read_prj_unit(file: Any) -> str:
    """Return the unit of heights in the .prj from which GDAL reads the CRS, as for Arc rasters; "" if there is none."""
    for projection in (Path(name) for name in file.files if name.lower().endswith(".prj")):
        found = _HEIGHT_UNIT.search(projection.read_bytes()) if projection.is_file() else None
        if found and found[1].upper() != b"NO":
            return found[1].decode().lower()
    return ""


def _band(path: str, band: int, coding: Coding, rows: slice, columns: slice) -> np.ndarray:
    """Read the heights in some rows and columns of a raster file, which is opened and closed each time."""
    with open_raster(path) as file:
        window = Window.from_slices(rows, columns)
        heights = coding.heights(file.read(band, window=window))
        heights[file.read_masks(band, window=window) == 0] = np.nan
        for alpha in (n for n, colour in enumerate(file.colorinterp, 1) if colour == ColorInterp.alpha):
            heights[file.read(alpha, window=window) == 0] = np.nan  # GDAL's mask has only an alpha of uint8 or uint16
        return heights


def _netcdf_reader(path: str) -> RasterReader:
    """Return a reader of the heights of a netCDF file: one of netCDF-4 is opened each time, another is read once."""
    unwritten = check_netcdf(path)
    with _explaining(path), open_netcdf(path) as found:
        array = _to_map(found, repr(path))
        coding = coding_of(array, repr(path))
        if array.name in unwritten:
            lost, number = unwritten[array.name]
            if np.isfinite(coding.heights(np.array([number], array.dtype))[0]):
                raise explain_damage(
                    path, f"{lost} chunks of {array.name!r} are missing, with heights of {number:g} instead"
                )
        kept = array.load() if is_classic(path) else None
        return _map_reader(array, partial(_netcdf_heights, path, coding, kept), repr(path))


def _netcdf_heights(path: str, coding: Coding, kept: xr.DataArray | None, rows: slice, columns: slice) -> np.ndarray:
    """Read the heights in some rows and columns of a netCDF file, or of the array that is kept of it."""
    if kept is not None:
        return coding.heights(kept[rows, columns].to_numpy())
    with _explaining(path), open_netcdf(path) as array:
        return coding.heights(_to_map(array, repr(path))[rows, columns].to_numpy())


@contextmanager
def _explaining(path: str) -> Iterator[None]:
    """Context manager that converts errors of libraries, such as for a damaged CRS or damaged numbers, to a ValueError."""
    try:
        yield
    except (RuntimeError, LookupError, AttributeError, OSError) as error:
        raise explain_damage(path, error) from error


def _data_array_reader(array: xr.DataArray) -> RasterReader:
    """Check an xarray.DataArray of heights, and return a reader of the heights."""
    made = _to_map(array, _ARRAY)  # without the nodata value that `rio.set_nodata` has stored
    coding = Coding.of_array(array, _ARRAY)
    return _map_reader(made, lambda rows, columns: coding.heights(made[rows, columns].to_numpy()), _ARRAY)


def _map_reader(array: xr.DataArray, heights: Callable[[slice, slice], np.ndarray], got: str) -> RasterReader:
    """Check an array of the dimensions y and x, and return a reader of its heights.

    Args:
        array: Array with its coordinates and attributes.
        heights: Function that reads the heights in some rows and columns.
        got: Description of the array for messages.
    """
    check_upward(array.attrs)
    unit = str(array.attrs.get("units") or array.attrs.get("unit") or "")
    coordinates = {name: array.coords[name].variable for name in array.dims if name in array.coords}
    if not array.size:
        raise ValueError(f"source: got {got} of sizes {dict(array.sizes)}, want at least one cell")
    for name, coordinate in coordinates.items():
        stated = coordinate.attrs.get("units") or coordinate.attrs.get("standard_name", "")
        check_unit(str(stated), crs_of(array.rio.crs), f"coordinates {name!r}")
    where = transform_of(array, array.dims, got), array.rio.crs, unit
    return _reader(array.shape, *where, heights, dims=array.dims, coordinates=coordinates)


def _to_map(array: xr.DataArray, got: str) -> xr.DataArray:
    """Return an array of the dimensions y and x alone, in this order; raise a ValueError if it has others, or not these."""
    try:
        dims = array.rio.y_dim, array.rio.x_dim
    except MissingSpatialDimensionError:
        raise ValueError(
            f"source: got {got} of dimensions {array.dims}, want y and x; da.rio.set_spatial_dims selects other dimensions"
        ) from None
    others = {name: size for name, size in array.sizes.items() if name not in dims}
    if any(size != 1 for size in others.values()):
        raise ValueError(f"source: got {got} of sizes {dict(array.sizes)}, want y and x alone; select one band")
    return array.isel(dict.fromkeys(others, 0)).transpose(*dims)


def _array_reader(array: Any, transform: Any, crs: Any) -> RasterReader:
    """Check an array of heights with a transform and a CRS, and return a reader of the heights."""
    array = array.compute() if hasattr(array, "compute") else array  # an array of Dask may have a mask
    values = as_real(np.ma.getdata(array) if np.ma.isMaskedArray(array) else array, "source", "an array of real numbers")
    masked = np.broadcast_to(np.ma.getmask(array), values.shape)
    if values.ndim == 3 and len(values) == 1:
        values, masked = values[0], masked[0]
    if values.ndim != 2 or not values.size:
        raise ValueError(f"source: got an array of shape {values.shape}, want (rows, columns), at least one of each")
    affine = affine_of(transform)

    def heights(rows: slice, columns: slice) -> np.ndarray:
        part = Coding().heights(values[rows, columns])
        part[masked[rows, columns]] = np.nan
        return part

    return _reader(values.shape, affine, crs, "", heights)


def _reader(
    shape: tuple[int, int],
    transform: Affine,
    crs: Any,
    unit: str,
    heights: Callable[[slice, slice], np.ndarray],
    *,
    dims: tuple[str, str] = ("y", "x"),
    coordinates: Mapping[str, Any] | None = None,
) -> RasterReader:
    """Build a reader that converts heights to the unit of the horizontal coordinates, after checks."""
    check_cells(transform, shape)
    found = crs_of(crs)
    metres, stated, of_crs = metres_of(found), length_of(unit), height_metres_of(found)
    if stated is None and (unit.strip() or (of_crs is None and abs(metres - 1.0) > 1e-5)):
        message = f"heights in {unit!r}, a unit that is not known here" if unit.strip() else "no unit of its heights"
        whose = "coordinates" if of_crs is None else "a CRS with heights"
        warnings.warn(
            f"source: got {message}, and {whose} in units of {of_crs or metres:g} m; both are taken to be the same unit",
            stacklevel=2,
        )
    height_metres = stated or of_crs or metres
    stretched = describe_stretch(found, *(transform @ (shape[1] / 2.0, shape[0] / 2.0)))
    if stretched:
        warnings.warn(
            f"source: {stretched}: slopes are wrong by the same factor; {REPROJECT}",
            stacklevel=2,
        )
    coordinates = coordinates_of(transform, shape) if coordinates is None else coordinates
    factor = height_metres / metres
    return RasterReader(shape, transform, found, metres, dims, coordinates, factor, stated is not None, heights)
