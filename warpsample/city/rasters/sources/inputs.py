"""Files that a raster is read from, which no output may replace."""

import os
import re
import sqlite3
from bisect import bisect_right
from collections.abc import Iterator
from contextlib import closing, suppress
from html import unescape
from itertools import accumulate, chain, pairwise
from pathlib import Path

from warpsample.city.rasters.sources.netcdf import is_netcdf
from warpsample.city.rasters.sources.opening import open_raster

_BREAK = re.compile(r"[\x00-\x1f\"<>]|  +")
"""What is between names in a text: tags, quotation marks, and the spaces that fill the columns of a table."""

_EDGE = re.compile(r"\s|['()\[\]{}|,;:?&=]|/vsi\w+/|//")
"""Where names of files may begin or end in addresses of GDAL, as in vrt://in.tif?bands=1; names may also hold these."""

_NUMBERS = re.compile(r"[\s\d.,;:eE+\[\](){}-]*")
"""A part of a text that has no name, such as heights and coordinates."""

_MOST_EDGES = 24  # within a name and its folders
_MOST = 1 << 24  # bytes of a text in which names are looked for
_ESCAPED = re.compile(r"\\(?:u([0-9a-fA-F]{4})|/)")  # characters in JSON
_TEXT_COLUMNS = """SELECT m.name, c.name FROM sqlite_master AS m, pragma_table_info(m.name) AS c
WHERE m.type = 'table' AND (c.type LIKE '%TEXT%' OR c.type LIKE '%CHAR%')"""


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
        if (one == path or text) and not is_netcdf(one):  # GDAL may crash on damaged ones
            with suppress(FileNotFoundError, ValueError), open_raster(one) as file:  # reported when the file is read
                waiting += file.files
            waiting += _list_named(text, Path(one).parent)
        if one.lower().endswith(".shp"):
            waiting += [f"{one[:-4]}{suffix}" for suffix in (".dbf", ".DBF")]
    return [Path(one) for one in found.values()]


def _read_text(path: Path) -> str:
    """Read the beginning of a file that is a text or a table of texts; "" for other files, which begin with zeros."""
    with suppress(OSError):
        if path.is_file():  # reading a pipe may never end
            with path.open("rb") as file:
                content = file.read(1024)
                if content.startswith(b"SQLite format 3"):
                    return _read_database(path)
                if b"\0" in content and path.suffix.lower() != ".dbf":
                    return ""
                content += file.read(_MOST)
                if path.suffix.lower() == ".dbf":
                    content = _divide_columns(content)
                text = unescape(os.fsdecode(content))
                return _ESCAPED.sub(lambda match: chr(int(match[1] or "2f", 16)), text)
    return ""


def _divide_columns(table: bytes) -> bytes:
    """Return the texts of a .dbf, each in a line of its own: they fill their columns, with nothing between them."""
    begin, size = (int.from_bytes(table[at : at + 2], "little") for at in (8, 10))
    ends = list(accumulate(table[48 : max(begin - 1, 48) : 32], initial=1))  # the widths of the columns, after a mark
    rows = range(begin, len(table), size) if size else ()
    return b"\n".join(table[row + start : row + end] for row in rows for start, end in pairwise(ends))


def _read_database(path: Path) -> str:
    """Read the texts in all tables of an SQLite file, such as an index of tiles in a GeoPackage."""
    texts = []
    address = f"{path.absolute().as_uri()}?mode=ro&immutable=1"  # so that no journal appears next to it
    with suppress(sqlite3.Error), closing(sqlite3.connect(address, uri=True)) as database:
        for table, column in database.execute(_TEXT_COLUMNS).fetchall():
            names = (name.replace('"', '""') for name in (column, table))
            texts += database.execute('SELECT "{}" FROM "{}"'.format(*names)).fetchall()
    return "\n".join(text for (text,) in texts if isinstance(text, str))


def _list_named(text: str, folder: Path) -> list[str]:
    """Return the existing files that a text names, relative to a folder or to the current one."""
    names = {name for piece in _BREAK.split(text) if not _NUMBERS.fullmatch(piece) for name in _names_in(piece)}
    found = []
    for place in (folder, Path()):
        for name in names:
            with suppress(OSError, ValueError):  # it may be too long for a name
                if (place / name).is_file():
                    found.append(str(place / name))
    return sorted(set(found))


def _names_in(piece: str) -> Iterator[str]:
    """Yield each part of a text that may be the name of a file: from one edge to another, and not a number."""
    edges = [match.span() for match in _EDGE.finditer(piece)]
    starts = sorted({0, *chain.from_iterable(edges)})
    ends = sorted({*chain.from_iterable(edges), *(match.start() for match in re.finditer("/", piece)), len(piece)})
    for start in starts:
        after = bisect_right(ends, start)
        for end in ends[after : after + _MOST_EDGES]:
            if not piece[start:end].replace(".", "").replace("-", "").isdecimal():
                yield piece[start:end]
