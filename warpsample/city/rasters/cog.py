"""Writer of results as cloud-optimized GeoTIFFs (COG), with tiles, overviews, and a description of the numbers."""

import os
import shutil
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np
import pyproj
import rasterio
import rasterio.shutil
from rasterio._err import CPLE_BaseError
from rasterio.errors import RasterioError
from rasterio.io import MemoryFile
from rasterio.windows import Window

from warpsample.city.rasters.sources.reference import is_same_map
from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.host.files import WriteError, complete_or_absent, is_same, to_disk

_BLOCK = 512  # cells along the sides of the file's own tiles
_SIDECARS = (".msk", ".ovr", ".aux.xml")  # masks, overviews and statistics, which GDAL would read as those of the new file
_ERDAS = b"EHFA_HEADER_TAG"
_HOW = {"compress": "DEFLATE", "overview_resampling": "AVERAGE", "blocksize": _BLOCK, "bigtiff": "IF_SAFER"}


def check_sidecars(path: Path, argument: str, inputs: Iterable[Path]) -> None:
    """Raise a ValueError for a GeoTIFF beside files that GDAL would read as its masks, overviews or statistics.

    Those of an older GeoTIFF with this name are accepted, unless they are inputs: `write_cog` removes them. Files
    with names in other case may be those of another GeoTIFF, but GDAL reads them, too.
    """
    inputs, own = list(inputs), _list_sidecars(path)
    for older in own + _list_similar(path, own):
        if older not in own or not path.exists() or any(is_same(older, file) for file in inputs):
            raise ValueError(
                f"{argument}: got {str(path)!r} next to {older.name}, which GDAL would read as part of it; want another name"
            )


def check_reference(run: RasterRun, path: Path, argument: str) -> None:
    """Raise a ValueError if GDAL cannot write to a path, or if a GeoTIFF cannot hold the CRS of a raster.

    GDAL would write no CRS or another one. Such a CRS has no code that GDAL knows, and a projection without GeoTIFF keys, as
    +proj=eqearth.
    """
    try:
        str(path.absolute()).encode()
    except UnicodeEncodeError:
        raise ValueError(
            f"{argument}: got {str(path)!r}, whose name or folder is not in UTF-8, as GDAL needs; write a .zarr"
        ) from None
    outline, (rows, columns) = run.reader.outline, run.reader.shape
    if outline.crs is None or outline.crs.geodetic_crs is None:  # a map without a place on Earth
        return
    where = {"crs": outline.crs.to_wkt(), "transform": outline.transform}
    with rasterio.Env(GDAL_PAM_ENABLED="NO"), MemoryFile() as memory:  # without a sidecar file, which nobody keeps
        with memory.open(driver="GTiff", height=1, width=1, count=1, dtype="uint8", **where) as file:
            file.write(np.zeros((1, 1, 1), np.uint8))
        with memory.open() as file:
            found = file.crs and pyproj.CRS.from_wkt(file.crs.to_wkt())
    if not (found and is_same_map(outline.crs, found, *(outline.transform @ (columns / 2.0, rows / 2.0)))):
        raise ValueError(
            f"{argument}: got {str(path)!r}, but a GeoTIFF cannot hold the CRS of the raster, {outline.crs.name}; write a "
            ".zarr, or reproject the raster first"
        )


def _list_sidecars(path: Path) -> list[Path]:
    """Return the existing sidecar files of a GeoTIFF; of a link also those of its target."""
    return [one for file in _list_names(path) for suffix in _SIDECARS if (one := Path(f"{file}{suffix}")).exists()]


def _list_similar(path: Path, own: list[Path]) -> list[Path]:
    """Return the files that GDAL reads as sidecars, but that are not in `own`: in other case, or .aux files of ERDAS."""
    found = []
    for file in _list_names(path):
        wanted = {f"{file.name}{suffix}".lower() for suffix in (*_SIDECARS, ".aux")} | {f"{file.stem}.aux".lower()}
        near = sorted(file.parent.iterdir()) if file.parent.is_dir() else []
        found += [one for one in near if one.name.lower() in wanted and one not in own and _is_sidecar(one)]
    return found


def _is_sidecar(path: Path) -> bool:
    """Return whether a file can be a sidecar by its content: an .aux file may be of LaTeX."""
    if path.suffix.lower() != ".aux":
        return True
    with suppress(OSError):
        if path.is_file():
            with path.open("rb") as file:
                return file.read(len(_ERDAS)) == _ERDAS
    return False


def _list_names(path: Path) -> list[Path]:
    """Return the absolute paths at which GDAL opens a file: the path, and for a link also that of its target."""
    return list({Path(os.path.realpath(one.parent), one.name): None for one in (path, Path(os.path.realpath(path)))})


def write_cog(
    path: Path,
    run: RasterRun,
    about: Mapping[str, Any],
    tiles: Callable[[], Iterable[tuple[Span, Mapping[str, np.ndarray]]]],
    folder: Path,
) -> list[Path]:
    """Write the results of all tiles to a COG with one band per name.

    The results are first written to a plain file, because a COG cannot be filled in parts. The COG is read back and compared
    before it appears, because GDAL reports no error if it fails while it closes a file, for example on a full disk.

    Args:
        path: Path of the file, which appears when it is complete. Sidecar files of an older file with this name are removed,
            because GDAL would read them as those of the new file.
        run: Run that computed the results.
        about: Attributes to store in the file.
        tiles: Function that returns the spans and arrays of all tiles; it is called twice.
        folder: Folder for temporary files. It may exist already; the caller removes it.

    Returns:
        paths of the removed sidecar files.

    Raises:
        WriteError: The file cannot be written.
    """
    with _convert_write_errors(path):
        folder.mkdir(exist_ok=True)
        for name in ("plain.tif", "cog.tif"):  # they may be links to other files
            (folder / name).unlink(missing_ok=True)
        _write_plain(folder / "plain.tif", run, about, tiles())
        rasterio.shutil.copy(folder / "plain.tif", folder / "cog.tif", driver="COG", predictor="FLOATING_POINT", **_HOW)
        _check_written(folder / "cog.tif", run, tiles())
        removed = _list_sidecars(path) if path.exists() else []
        with complete_or_absent(path) as stream, (folder / "cog.tif").open("rb") as made:
            shutil.copyfileobj(made, stream, 1 << 24)
            to_disk(stream)
            for sidecar in removed:  # before the old file is replaced, because it may be impossible
                sidecar.unlink(missing_ok=True)
    return removed


def _write_plain(
    path: Path, run: RasterRun, about: Mapping[str, Any], tiles: Iterable[tuple[Span, Mapping[str, np.ndarray]]]
) -> None:
    """Write the results of all tiles to a tiled GeoTIFF without overviews."""
    outline, (rows, columns) = run.reader.outline, run.reader.shape
    shape = {"height": rows, "width": columns, "count": len(run.names), "dtype": "float32", "nodata": np.nan}
    where = {"crs": outline.crs and outline.crs.to_wkt(), "transform": outline.transform}
    how = {"tiled": True, "blockxsize": _BLOCK, "blockysize": _BLOCK, "bigtiff": "YES"}
    with rasterio.open(path, "w", "GTiff", **shape, **where, **how) as file:
        file.update_tags(**about)
        file.descriptions = run.names
        file.units = [run.quantity.unit or "1"] * len(run.names)
        for span, arrays in tiles:
            file.write(np.stack([arrays[name] for name in run.names]), window=Window.from_slices(*span))


def _check_written(path: Path, run: RasterRun, tiles: Iterable[tuple[Span, Mapping[str, np.ndarray]]]) -> None:
    """Raise an OSError if a written GeoTIFF, read again, differs from the results of the tiles."""
    with rasterio.open(path) as file:
        for span, arrays in tiles:
            there = file.read(window=Window.from_slices(*span))
            if not np.array_equal(there, np.stack([arrays[name] for name in run.names]), equal_nan=True):
                raise OSError("the numbers read back differ from those written, as happens on a full disk")


@contextmanager
def _convert_write_errors(path: Path) -> Iterator[None]:
    """Context manager that converts errors of rasterio and of the system inside to a WriteError with the file's name."""
    try:
        yield
    except (RasterioError, CPLE_BaseError) as error:
        raise WriteError(f"{path} cannot be written: {str(error).splitlines()[0]}") from error
    except OSError as error:
        if isinstance(error, WriteError):
            raise
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
