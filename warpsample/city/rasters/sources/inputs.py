"""Files that a raster is read from, which no output may replace."""

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from html import unescape
from pathlib import Path

from warpsample.city.rasters.sources.reading import open_raster

_SOURCE = re.compile(rb"<Source(?:Filename|Dataset)[^>]*>([^<]+)<")  # in the text of a VRT
_ADDRESS = re.compile(r'/vsi\w+/|://|[:,?"]')  # what surrounds file names in GDAL's addresses, as in vrt://in.tif?bands=1


def files_read(path: str) -> list[Path]:
    """Return the files of a raster: the file itself, and files that it refers to.

    A .vrt refers to other rasters, which may be .vrt files, too, and an address within an archive refers to the archive.
    """
    found: dict[str, str] = {}
    waiting = [path, *_list_parts(path)]
    while waiting:
        one = waiting.pop(0)
        is_known = os.path.realpath(one) in found
        found.setdefault(os.path.realpath(one), one)
        is_virtual = _is_virtual(one)
        if not is_known and (one == path or is_virtual):
            with suppress(FileNotFoundError, ValueError), open_raster(one) as file:  # reported when the file is read
                waiting += file.files
        if not is_known and is_virtual:
            waiting += _list_sources(Path(one))
    return [Path(one) for one in found.values()]


def _is_virtual(path: str) -> bool:
    """Return whether a file is a .vrt; a mosaic may have too many other files to open each."""
    if path.lower().endswith(".vrt"):
        return True
    try:
        with Path(path).open("rb") as file:
            return b"<VRTDataset" in file.read(1024)
    except OSError:
        return False


def _list_sources(path: Path) -> Iterator[str]:
    """Yield the files within the GDAL addresses of a VRT, which GDAL does not list as its files."""
    for source in _SOURCE.findall(path.read_bytes()) if path.is_file() else ():
        yield from _list_parts(unescape(os.fsdecode(source)), path.parent)


def _list_parts(address: str, folder: Path = Path()) -> Iterator[str]:
    """Yield the existing files that an address names, relative to a folder or to the current one."""
    for part in _ADDRESS.split(address):
        with suppress(OSError):  # a part may be too long for a name
            yield from (str(place / part) for place in (folder, Path()) if part and (place / part).is_file())
