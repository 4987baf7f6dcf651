"""Checks of raster files for damage: where some files lack bytes, GDAL reads heights of 0, without an error."""

import warnings
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city.rasters.sources.arc_grid import check_arc_grid
from warpsample.city.rasters.sources.inputs import files_read
from warpsample.city.rasters.sources.opening import open_raster
from warpsample.city.rasters.sources.side_files import check_texts, list_side_files
from warpsample.city.rasters.sources.tiff import check_tiff
from warpsample.host.arguments import is_file

_REPORTED = {"GTiff", "LIBERTIFF", "HFA", "JP2OpenJPEG", "GRIB", "BT", "GSBG", "HF2", "SIGDEM"}
"""Formats of which GDAL reports a missing part. Parts of a GeoTIFF may be left out to mean one value."""

_VIRTUAL = ("VRT", "GTI")
_TIFF = (".tif", ".tiff")


def check_undamaged(path: str, file: Any) -> None:
    """Raise a ValueError for a damaged raster, of those kinds of damage that GDAL does not report.

    Args:
        path: Path or GDAL's address of the raster; of a virtual one, each file that it is made of is checked.
        file: The raster, opened with rasterio.

    Warns:
        UserWarning: The format is one of those whose damage neither GDAL nor this function finds.
    """
    parts = files_read(path) if file.driver in _VIRTUAL else []
    formats = {_check(path, file), *(_check_part(str(part)) for part in parts)}
    if unsure := ", ".join(sorted(formats - {""})):
        warnings.warn(
            f"source: got {path!r} in {unsure} format; where parts of it are missing or damaged, GDAL may read heights of 0 "
            "without an error, unlike in a GeoTIFF",
            stacklevel=2,
        )


def _check_part(path: str) -> str:
    """Check a file of a virtual raster as `_check` does, unless it is no raster itself, such as a file of statistics."""
    if path.lower().endswith(_TIFF) and not any(list_side_files(path)):
        if is_file(path):
            check_tiff(path)
        return ""  # GDAL reports other damage when it is read, and opening many files takes time
    with ExitStack() as stack:
        try:
            file = stack.enter_context(open_raster(path))
        except (FileNotFoundError, ValueError):
            return ""
        return _check(path, file)


def _check(path: str, file: Any) -> str:
    """Raise a ValueError for a damaged file; return the name of its format if its damage may not be found, otherwise ""."""
    path = _path_of(path, file)
    is_local = is_file(path)
    check_texts(path, file)
    if file.driver == "AAIGrid" and is_local:
        check_arc_grid(path, file.shape, np.issubdtype(file.dtypes[0], np.integer))
    elif file.driver in ("GTiff", "LIBERTIFF") and is_local:
        check_tiff(path)
    elif file.driver == "VRT" and is_local and b"VRTRawRasterBand" in Path(path).read_bytes():
        return "raw VRT"
    elif file.driver not in (*_VIRTUAL, *_REPORTED):
        return str(file.driver)
    return ""


def _path_of(path: str, file: Any) -> str:
    """Return the path of an open raster's own file, without the rest of an address of GDAL, as GTIFF_DIR:1:dsm.tif."""
    if file.driver in ("GTiff", "LIBERTIFF") or path.lower().startswith("file:"):
        return next(iter(file.files), path)
    return path  # the files of vrt://dsm.tif are the parts of a virtual raster
