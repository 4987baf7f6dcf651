"""Files that a raster is read from, which no output may replace."""

import os
import re
from contextlib import suppress
from html import unescape
from pathlib import Path

from warpsample.city.rasters.sources.reading import open_raster

_BETWEEN = re.compile(r"[\s\"'<>()\[\]{}|,;:?&=]+|/vsi\w+/|://")
"""What is between file names in texts and addresses of GDAL, as in vrt://in.tif?bands=1."""

_MOST = 1 << 20  # characters of a text in which names are looked for


def files_read(path: str) -> list[Path]:
    """Return the files of a raster: the file itself, and files that it refers to.

    GDAL lists most files of a .vrt, but neither those in addresses, such as GTIFF_DIR:1:dsm.tif, nor those of an index of
    tiles. So each existing file whose name is in the text of a .vrt or an index counts, too, and so on from file to file.
    """
    found: dict[str, str] = {}
    waiting = [path, *_list_named(path, Path())]
    while waiting:
        one = waiting.pop(0)
        if os.path.realpath(one) in found:
            continue
        found[os.path.realpath(one)] = one
        text = _read_text(Path(one))
        if one == path or text:
            with suppress(FileNotFoundError, ValueError), open_raster(one) as file:  # reported when the file is read
                waiting += file.files
            waiting += _list_named(text, Path(one).parent)
    return [Path(one) for one in found.values()]


def _read_text(path: Path) -> str:
    """Read the beginning of a file that is a text; "" for other files, which have a zero in their first bytes."""
    with suppress(OSError):
        if path.is_file():  # reading a pipe may never end
            with path.open("rb") as file:
                first = file.read(1024)
                return "" if b"\0" in first else unescape(os.fsdecode(first + file.read(_MOST)))
    return ""


def _list_named(text: str, folder: Path) -> list[str]:
    """Return the existing files that a text names, relative to a folder or to the current one."""
    names = {name for name in _BETWEEN.split(text) if not name.replace(".", "").replace("-", "").isdecimal()}
    found = []
    for place in dict.fromkeys((folder, Path())):
        for name in filter(None, names):
            with suppress(OSError):  # it may be too long for a name
                if (place / name).is_file():
                    found.append(str(place / name))
    return sorted(found)
