"""Check of Arc ASCII grids (.asc): GDAL reads a missing or damaged number as 0, without an error."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

_CHUNK = 1 << 24  # bytes read at a time
_KEYS = rb"(?:ncols|nrows|[xy]ll(?:corner|center)|cellsize|d[xy]|nodata_value)"
_HEADER = re.compile(rb"\s*(?:" + _KEYS + rb"[ \t]+\S+[ \t]*[\r\n]+)+", re.IGNORECASE)
"""Lines of a header: GDAL takes an indented line, and a value on a line of its own, for heights."""

_LONGEST_HEADER = 4096
SPECIAL = rb"(?i:[+]?nan|[+-]?inf(?:inity)?)|-?1[.]#QNAN|-1[.]#IND|[+-]?1[.]#INF"
"""Numbers that GDAL reads as not finite; it reads -nan as 0, and 1.#IND as 1."""

_DECIMAL = rb"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?"
_NUMBER, _NOT_FINITE = re.compile(_DECIMAL), re.compile(SPECIAL)
_LENGTHS = (b"cellsize", b"dx", b"dy")
_PLACES = ({b"xllcorner", b"yllcorner"}, {b"xllcenter", b"yllcenter"})

_INTEGER = rb"[+-]?0*(?:\d{1,9}|1\d{9}|20\d{8}|214748364[78])"  # within int32, to which GDAL would reduce others
_DAMAGED, _NO_INTEGER = (
    re.compile(rb"(?<=[\t-\r ])(?!(?:" + number + rb")[\t-\r ])[^\t-\r ]+")
    for number in (_DECIMAL + b"|" + SPECIAL, _INTEGER)
)
_LONE_WORD = re.compile(rb"[ \t]*[A-Za-z]\S*[ \t]*[\r\n]")


def check_arc_grid(path: str, shape: tuple[int, int], is_integer: bool) -> None:
    """Raise a ValueError for an Arc ASCII grid with a wrong count of heights, or with a text that is not a number.

    Args:
        path: Path of the file.
        shape: Numbers of rows and columns from its header.
        is_integer: Whether GDAL reads the heights as integers; it reads NaN and infinite heights among integers as 0.
    """
    header, count = _read_header(path), 0
    _check_header(path, header)
    for chunk in _chunks(path, len(header)):
        if damaged := (_NO_INTEGER if is_integer else _DAMAGED).search(chunk):
            text = damaged[0][:40].decode("ascii", "replace")
            is_special = not _DAMAGED.search(b" " + damaged[0] + b" ")
            want = "integers below 2^31, as the others are, and -9999 for no data" if is_special else "numbers"
            raise ValueError(f"source: got {path!r} with {text!r} among its heights, want {want}: the file is damaged")
        codes = np.frombuffer(chunk, np.uint8)
        is_space = (codes == ord(" ")) | ((codes >= ord("\t")) & (codes <= ord("\r")))
        count += np.count_nonzero(is_space[:-1] & ~is_space[1:])
    rows, columns = shape
    if count != rows * columns:
        raise ValueError(
            f"source: got {path!r} with {count:,} heights, want {rows * columns:,}, {rows:,} rows of {columns:,}: the file "
            "is damaged"
        )


def _read_header(path: str) -> bytes:
    """Return the text before the heights: names with their values."""
    with Path(path).open("rb") as file:
        header = _HEADER.match(file.read(_LONGEST_HEADER))
    return header[0] if header else b""


def _check_header(path: str, header: bytes) -> None:
    """Raise a ValueError for a value of the header that is not a number, cells without a positive length, or no place."""
    words = header.split()
    keys = [word.lower() for word in words[::2]]
    if len(set(keys)) < len(keys) or not any(place <= set(keys) for place in _PLACES):  # GDAL puts the raster at (0, 0)
        lines = ", ".join(key.decode() for key in keys) or "nothing"
        raise ValueError(f"source: got {path!r} with {lines} in its header, want xllcorner and yllcorner, each once")
    for name, text in zip(words[::2], words[1::2], strict=True):
        key, got = name.lower(), f"source: got {path!r} with {name.decode()} {text.decode('ascii', 'replace')!r}"
        if not _NUMBER.fullmatch(text) and not (key == b"nodata_value" and _NOT_FINITE.fullmatch(text)):
            raise ValueError(f"{got}, want a number")
        if key in _LENGTHS and not float(text.replace(b",", b".")) > 0.0:
            raise ValueError(f"{got}, want a length above 0")


def _chunks(path: str, start: int) -> Iterator[bytes]:
    """Yield the text of the heights, from byte `start`, in chunks of whole numbers; each begins and ends with a space.

    Raises:
        ValueError: The heights begin with a line such as nan, which GDAL takes for a line of the header.
    """
    with Path(path).open("rb") as file:
        file.seek(start)
        rest, is_first = b"\n", True
        while chunk := file.read(_CHUNK):
            if is_first and (word := _LONE_WORD.match(chunk)):
                text = word[0][:40].decode("ascii", "replace").strip()
                raise ValueError(
                    f"source: got {path!r} with {text!r} alone in the first line of heights, which GDAL takes for the "
                    "header; write a number, such as -9999"
                )
            is_first = False
            rest += chunk
            end = max(rest.rfind(space) for space in (b" ", b"\n", b"\t", b"\r"))
            yield rest[: end + 1]
            rest = rest[end:]
        yield rest + b"\n"
