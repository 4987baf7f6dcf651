"""Opening of raster files with rasterio, with errors that name the file."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import rasterio
from rasterio._err import CPLE_BaseError  # of errors that rasterio meets later, such as those of a damaged CRS
from rasterio.errors import NotGeoreferencedWarning, RasterioError, RasterioIOError

from warpsample.host.arguments import flaw_of

WANTS = "the path of a raster, an xarray.DataArray, or a tuple (array, affine, crs or None)"
"""What a source of heights may be, for error messages."""


@contextmanager
def open_raster(path: str) -> Iterator[Any]:
    """Open a raster file with rasterio within a `with` statement.

    Raises:
        FileNotFoundError: The file does not exist.
        ValueError: The file is not a raster, or is damaged.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", NotGeoreferencedWarning)
            with rasterio.Env(GTIFF_REPORT_COMPD_CS="YES"), rasterio.open(path) as file:  # with the CRS of heights
                yield file
    except UnicodeEncodeError as error:
        raise ValueError(
            f"source: got {path!r}, whose name is not in UTF-8, as GDAL needs; rename the file or folder"
        ) from error
    except UnicodeDecodeError as error:
        raise ValueError(
            f"source: got {path!r}, whose CRS or unit has letters that are not in UTF-8; write them in ASCII letters"
        ) from error
    except (RasterioError, CPLE_BaseError) as error:
        flaw = flaw_of(Path(path))
        is_path = "://" not in path and ":" not in path[2:]
        if isinstance(error, RasterioIOError) and is_path and flaw in ("missing", "out of reach"):
            raise FileNotFoundError(f"source: got {path!r}, which is {flaw}, want {WANTS}") from error
        told = error.__cause__ or error  # GDAL's own words; without them rasterio tells to look at the cause
        reason = (str(told).strip().splitlines() or [type(error).__name__])[0]
        raise ValueError(f"source: got {path!r}, which cannot be read as a raster: {reason}") from error
