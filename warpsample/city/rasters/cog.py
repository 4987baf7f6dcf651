"""GeoTIFFs of results that are cut for reading over a network (COG): tiles, overviews, and what the numbers are."""

import shutil
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import rasterio
import rasterio.shutil
from rasterio.errors import RasterioError
from rasterio.windows import Window

from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.host.files import WriteError, complete_or_absent

_BLOCK = 512  # cells along the sides of the file's own tiles
_HOW = {"compress": "DEFLATE", "overview_resampling": "AVERAGE", "blocksize": _BLOCK, "bigtiff": "IF_SAFER"}


def write_cog(
    path: Path, run: RasterRun, about: Mapping[str, Any], tiles: Iterable[tuple[Span, Mapping[str, np.ndarray]]]
) -> None:
    """Writes the numbers of all tiles, a band for each name: first into a plain file, since a COG is not filled in parts.

    Args:
        path: of the file, which appears when it is complete.
        run: what the numbers are of.
        about: what the file says of them.
        tiles: where they belong, and what they are, by name.

    Raises:
        WriteError: it cannot be written.
    """
    with _beside(path) as folder:
        _write_plain(folder / "plain.tif", run, about, tiles)
        rasterio.shutil.copy(folder / "plain.tif", folder / "cog.tif", driver="COG", predictor="FLOATING_POINT", **_HOW)
        with complete_or_absent(path) as stream, (folder / "cog.tif").open("rb") as made:
            shutil.copyfileobj(made, stream, 1 << 24)


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


@contextmanager
def _beside(path: Path) -> Iterator[Path]:
    """A hidden folder beside a file, for what is not the file yet; what a killed process left there goes.

    Raises:
        WriteError: nothing can be written there.
    """
    folder = path.with_name(f".{path.name}.making")
    shutil.rmtree(folder, ignore_errors=True)
    try:
        folder.mkdir()
        yield folder
    except RasterioError as error:
        raise WriteError(f"{path} cannot be written: {str(error).splitlines()[0]}") from error
    except OSError as error:
        if isinstance(error, WriteError):
            raise
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(folder, ignore_errors=True)
