"""Reads rasters of heights: files, xarray's arrays, and arrays with a transform. Here alone they are checked."""

import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np
import rasterio
import xarray as xr
from affine import Affine
from rasterio.enums import ColorInterp
from rasterio.errors import NotGeoreferencedWarning, RasterioError, RasterioIOError
from rasterio.windows import Window
from rioxarray.exceptions import MissingSpatialDimensionError

from warpsample.city.rasters.grid import Grid
from warpsample.city.rasters.reader import RasterReader
from warpsample.city.rasters.reference import crs_of, height_metres_of, metres_of
from warpsample.host.arguments import told
from warpsample.host.arrays import as_real
from warpsample.host.neighbours import kind_told

_WANTS = "the path of a raster, an xarray.DataArray, or a tuple (array, affine, crs or None)"
_UNDECLARED = (-9999.0, -99999.0, -32767.0, -32768.0)
"""Heights that stand for none also where no tag says so: no place on Earth is as low, and programs write them."""

_LARGEST = 1e30
"""What is larger stands for none, such as float32's largest number in a raster whose tag is float64's copy of it."""


def with_heights(grid: Grid) -> Grid:
    """A grid that has some height.

    Raises:
        ValueError: it has none.
    """
    if not grid.valid.any():
        rows, columns = grid.height.shape
        raise ValueError(f"source: got {rows} x {columns} cells without any height, want at least one")
    return grid


def reader_of(source: Any) -> RasterReader:
    """A raster of heights that is checked, and not read yet.

    Args:
        source: the path of a raster that GDAL reads, with one band; an xarray.DataArray of two dimensions, or whose others
            have one entry, NumPy's or Dask's; or (array, affine.Affine or its six numbers, a CRS or None). Cells without a
            height are masked, NaN, infinite, beyond 1e30, what the raster says is none, or -9999, -99999, -32767, -32768.

    Raises:
        TypeError, ValueError, FileNotFoundError: something else; several bands; a CRS in degrees; no place on a map.

    Warns:
        UserWarning: the unit of its heights is not told, and that of its coordinates is no metre.
    """
    if isinstance(source, str | PathLike):
        return _of_file(fspath(source))
    if isinstance(source, xr.DataArray):
        return _of_data_array(source)
    if isinstance(source, tuple) and len(source) == 3:
        return _of_array(*source)
    raise TypeError(f"source: got {kind_told(source)}, want {_WANTS}")


def _of_file(path: str) -> RasterReader:
    with _opened(path) as file:
        bands = [n for n, colour in enumerate(file.colorinterp, 1) if colour != ColorInterp.alpha]
        if len(bands) != 1:
            raise ValueError(f"source: got {path!r} with {len(bands)} bands, want one band of heights")
        _check_place(file.transform, file.crs, repr(path))
        unit = file.units[bands[0] - 1] or ""
        return _reader(file.shape, file.transform, file.crs, unit, partial(_band, path, bands[0]))


def _band(path: str, band: int, rows: slice, columns: slice) -> np.ndarray:
    """A part of a file's heights; opened for it alone, since GDAL's files are for one thread and one process."""
    with _opened(path) as file:
        window = Window.from_slices(rows, columns)
        values = file.read(band, window=window)
        heights = _heights(values, file.nodata, file.scales[band - 1], file.offsets[band - 1])
        heights[file.read_masks(band, window=window) == 0] = np.nan
        return heights


def _of_data_array(array: xr.DataArray) -> RasterReader:
    try:
        dims = array.rio.y_dim, array.rio.x_dim
    except MissingSpatialDimensionError:
        raise ValueError(
            f"source: got an xarray.DataArray of dimensions {array.dims}, want y and x; da.rio.set_spatial_dims names others"
        ) from None
    others = {name: size for name, size in array.sizes.items() if name not in dims}
    if any(size != 1 for size in others.values()):
        raise ValueError(f"source: got an xarray.DataArray of sizes {dict(array.sizes)}, want y and x alone: one band")
    array = array.isel(dict.fromkeys(others, 0)).transpose(*dims)
    known, nodata = array.attrs, array.rio.nodata
    coordinates = {name: array.coords[name].variable for name in dims if name in array.coords}
    if not array.size:
        raise ValueError(f"source: got an xarray.DataArray of sizes {dict(array.sizes)}, want cells")

    def heights(rows: slice, columns: slice) -> np.ndarray:
        part = array.isel(dict(zip(dims, (rows, columns), strict=True))).to_numpy()
        return _heights(part, nodata, known.get("scale_factor", 1.0), known.get("add_offset", 0.0))

    where = _transform_of(array, dims), array.rio.crs, str(known.get("units", ""))
    return _reader(array.shape, *where, heights, dims=dims, coordinates=coordinates)


def _of_array(array: Any, transform: Any, crs: Any) -> RasterReader:
    masked = np.ma.getmask(array)
    values = as_real(np.ma.getdata(array) if masked is not np.ma.nomask else array, "source", "an array of real numbers")
    masked = np.broadcast_to(masked, values.shape)
    if values.ndim == 3 and len(values) == 1:
        values, masked = values[0], masked[0]
    if values.ndim != 2:
        raise ValueError(f"source: got an array of shape {values.shape}, want (rows, columns)")
    try:
        affine = Affine(*(float(number) for number in tuple(transform)[:6]))
    except TypeError:
        raise TypeError(
            f"source: got {told(transform)} for its transform, want an affine.Affine or its numbers a, b, c, d, e, f"
        ) from None

    def heights(rows: slice, columns: slice) -> np.ndarray:
        part = _heights(values[rows, columns], None)
        part[masked[rows, columns]] = np.nan
        return part

    return _reader(values.shape, affine, crs, "", heights)


def _transform_of(array: xr.DataArray, dims: tuple[str, str]) -> Affine:
    """The transform by the coordinates of an array; where it has none, or one only, by what is stored beside them.

    That may be of a larger array, of which this one is a part.
    """
    if not all(name in array.coords and array.coords[name].ndim == 1 and array.sizes[name] > 1 for name in dims):
        transform = array.rio.transform()
        _check_place(transform, array.rio.crs, "an xarray.DataArray")
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


def _heights(values: np.ndarray, nodata: float | None, scale: float = 1.0, offset: float = 0.0) -> np.ndarray:
    """A float64 copy of heights, NaN where there is none."""
    if values.dtype.kind not in "fiu":
        raise TypeError(f"source: got heights of dtype {values.dtype}, want real numbers")
    heights = values.astype(np.float64)
    none = ~(np.abs(heights) < _LARGEST)
    for code in (*_UNDECLARED, *(() if nodata is None else (nodata, np.float32(nodata)))):
        none |= heights == float(code)
    heights = heights * scale + offset
    heights[none] = np.nan
    return heights


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
    """A checked reader, whose heights are made those of the unit of its coordinates."""
    numbers = np.array(transform[:6])
    size = max(np.abs(numbers[[0, 1, 3, 4]]).max(), 1e-300)
    if not np.isfinite(numbers).all() or abs(transform.determinant) <= 1e-12 * size**2:
        raise ValueError(f"source: got the transform {tuple(numbers.tolist())}, want one whose cells have an area")
    found = crs_of(crs)
    metres, height_metres = metres_of(found), height_metres_of(found, unit) if found else None
    if height_metres is None and abs(metres - 1.0) > 1e-5:
        warnings.warn(
            f"source: got no unit of its heights, and coordinates in units of {metres:g} m; they are taken to be the same",
            stacklevel=2,
        )
    coordinates = _coordinates(transform, shape) if coordinates is None else coordinates
    return RasterReader(shape, transform, found, metres, dims, coordinates, (height_metres or metres) / metres, heights)


def _coordinates(transform: Affine, shape: tuple[int, int]) -> dict[str, np.ndarray]:
    """The centres of cells, to the bit as rioxarray has them when it opens a file; none for a raster that is turned."""
    a, b, c, d, e, f = transform[:6]
    if b or d:
        return {}
    return {"y": np.arange(shape[0]) * e + (0.5 * e + f), "x": np.arange(shape[1]) * a + (0.5 * a + c)}


def _check_place(transform: Affine, crs: Any, what: str) -> None:
    """Refuses rasters that neither say where they are nor how large their cells are."""
    if transform == Affine.identity() and crs is None:
        raise ValueError(
            f"source: got {what}, which has no place on a map, want a raster with a transform; "
            "(array, affine, None) says where it is"
        )


@contextmanager
def _opened(path: str) -> Iterator[Any]:
    """A file that rasterio reads.

    Raises:
        FileNotFoundError: it is missing.
        ValueError: it is no raster, or damaged.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", NotGeoreferencedWarning)
            with rasterio.open(path) as file:
                yield file
    except RasterioError as error:
        if isinstance(error, RasterioIOError) and "://" not in path and ":" not in path[2:] and not Path(path).exists():
            raise FileNotFoundError(f"source: got {path!r}, which is missing, want {_WANTS}") from error
        reason = (str(error).strip().splitlines() or [type(error).__name__])[0]
        raise ValueError(f"source: got {path!r}, which cannot be read as a raster: {reason}") from error
