"""GeoTIFFs of results that are cut for reading over a network (COG): tiles, overviews, and what the numbers are."""

import shutil
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import rasterio
import rasterio.shutil
from rasterio._err import CPLE_BaseError
from rasterio.errors import RasterioError
from rasterio.windows import Window

from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.host.files import WriteError, complete_or_absent

_BLOCK = 512  # cells along the sides of the file's own tiles
_SIDECARS = (".msk", ".ovr", ".aux.xml")  # masks, overviews and statistics, which GDAL would read as those of the new file
_HOW = {"compress": "DEFLATE", "overview_resampling": "AVERAGE", "blocksize": _BLOCK, "bigtiff": "IF_SAFER"}


def check_sidecars(path: Path, argument: str) -> None:
    """Refuse a new GeoTIFF beside files that GDAL would read as its masks, overviews or statistics.

    Raises:
        ValueError: there is no such GeoTIFF yet, but a file that GDAL would read with it.
    """
    older = [file.name for suffix in _SIDECARS if (file := Path(f"{path}{suffix}")).exists()]
    if older and not path.exists():
        raise ValueError(f"{argument}: got {str(path)!r}, but GDAL would read {older[0]} with it; want another name")


def write_cog(
    path: Path,
    run: RasterRun,
    about: Mapping[str, Any],
    tiles: Callable[[], Iterable[tuple[Span, Mapping[str, np.ndarray]]]],
    folder: Path,
) -> None:
    """Writes the numbers of all tiles, a band for each name: first into a plain file, since a COG is not filled in parts.

    It is read again before it appears: what GDAL cannot write while it closes a file is no error, on a full disk, say.

    Args:
        path: of the file, which appears when it is complete. What GDAL keeps beside an older one of this name goes.
        run: what the numbers are of.
        about: what the file says of them.
        tiles: gives where they belong and what they are, by name, as often as it is called.
        folder: for what is not the file yet; it may be there, and whoever gives it removes it.

    Raises:
        WriteError: it cannot be written.
    """
    with _telling(path):
        folder.mkdir(exist_ok=True)
        _write_plain(folder / "plain.tif", run, about, tiles())
        rasterio.shutil.copy(folder / "plain.tif", folder / "cog.tif", driver="COG", predictor="FLOATING_POINT", **_HOW)
        _check_written(folder / "cog.tif", run, tiles())
        older = [Path(f"{path}{suffix}") for suffix in _SIDECARS] if path.exists() else []
        with complete_or_absent(path) as stream, (folder / "cog.tif").open("rb") as made:
            shutil.copyfileobj(made, stream, 1 << 24)
        for sidecar in older:
            sidecar.unlink(missing_ok=True)


def _write_plain(
    path: Path, run: RasterRun, about: Mapping[str, Any], tiles: Iterable[tuple[Span, Mapping[str, np.ndarray]]]
) -> None:
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
    """Reads all numbers again."""
    with rasterio.open(path) as file:
        for span, arrays in tiles:
            there = file.read(window=Window.from_slices(*span))
            if not np.array_equal(there, np.stack([arrays[name] for name in run.names]), equal_nan=True):
                raise OSError("other numbers are read from it than were written, as happens on a full disk")


@contextmanager
def _telling(path: Path) -> Iterator[None]:
    """Tells what cannot be written as a WriteError that names the file."""
    try:
        yield
    except (RasterioError, CPLE_BaseError) as error:
        raise WriteError(f"{path} cannot be written: {str(error).splitlines()[0]}") from error
    except OSError as error:
        if isinstance(error, WriteError):
            raise
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
