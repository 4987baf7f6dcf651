"""Check of Arc ASCII grids (.asc): GDAL reads a missing or damaged number as 0, without an error."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

_CHUNK = 1 << 24  # bytes read at a time
_HEADER = re.compile(rb"(?:\s*(?:ncols|nrows|[xy]ll(?:corner|center)|cellsize|d[xy]|nodata_value)\s+\S+)+", re.IGNORECASE)
_LONGEST_HEADER = 4096
_NUMBER = re.compile(rb"[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?", re.IGNORECASE)
_NO_NUMBER = re.compile(rb"[+-]?(nan|inf(inity)?|1[.]#(qnan|ind|inf))", re.IGNORECASE)  # nodata values that are no heights
_LENGTHS = (b"cellsize", b"dx", b"dy")
_PLACES = ({b"xllcorner", b"yllcorner"}, {b"xllcenter", b"yllcenter"})

_SPACE, _DIGIT, _SIGN, _POINT, _EXPONENT, _LETTER, _OTHER = range(7)
_CLASSES = np.full(256, _OTHER, np.uint8)
_CLASSES[:33] = _SPACE
for _class, _bytes in ((_DIGIT, b"0123456789"), (_SIGN, b"+-"), (_POINT, b".,"), (_EXPONENT, b"eE")):
    _CLASSES[[*_bytes]] = _class
_CLASSES[[*b"nNaAiIfFqQdD#"]] = _LETTER  # of nan, inf, 1.#QNAN and 1.#IND
_FOLLOWS = np.zeros((7, 7), bool)
"""Whether a byte of the second class may follow one of the first in a text of numbers."""
for _first, _seconds in (
    (_SPACE, (_SPACE, _DIGIT, _SIGN, _POINT, _LETTER)),
    (_DIGIT, (_SPACE, _DIGIT, _POINT, _EXPONENT)),
    (_SIGN, (_DIGIT, _POINT, _LETTER)),
    (_POINT, (_SPACE, _DIGIT, _EXPONENT, _LETTER)),
    (_EXPONENT, (_DIGIT, _SIGN)),
    (_LETTER, (_SPACE, _DIGIT, _LETTER)),
):
    _FOLLOWS[_first, _seconds] = True


def check_arc_grid(path: str, shape: tuple[int, int]) -> None:
    """Raise a ValueError for an Arc ASCII grid with a wrong count of heights, or with a text that is not a number.

    The bytes of the heights are compared with those that may follow each other in numbers, without converting the numbers.

    Args:
        path: Path of the file.
        shape: Numbers of rows and columns from its header.
    """
    header, count = _read_header(path), 0
    _check_header(path, header)
    for chunk in _chunks(path, len(header)):
        classes = _CLASSES[np.frombuffer(chunk, np.uint8)]
        wrong = ~_FOLLOWS.ravel()[7 * classes[:-1] + classes[1:]]
        if wrong.any():
            text = _token_at(chunk, int(wrong.argmax()) + 1)
            raise ValueError(f"source: got {path!r} with {text!r} among its heights, want numbers: the file is damaged")
        count += np.count_nonzero((classes[:-1] == _SPACE) & (classes[1:] != _SPACE))
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
        if not _NUMBER.fullmatch(text) and not (key == b"nodata_value" and _NO_NUMBER.fullmatch(text)):
            raise ValueError(f"{got}, want a number")
        if key in _LENGTHS and not float(text.replace(b",", b".")) > 0.0:
            raise ValueError(f"{got}, want a length above 0")


def _chunks(path: str, start: int) -> Iterator[bytes]:
    """Yield the text of the heights, from byte `start`, in chunks; each begins with the last byte of the preceding one.

    The last chunk ends in a space.
    """
    with Path(path).open("rb") as file:
        file.seek(start)
        last = b"\n"
        while chunk := file.read(_CHUNK):
            yield last + chunk
            last = chunk[-1:]
        yield last + b"\n"


def _token_at(chunk: bytes, index: int) -> str:
    """Return the word of a text at a byte index, or the word that ends there if the byte is a space."""
    before = re.search(rb"[^\x00-\x20]{0,20}$", chunk[:index])
    after = re.match(rb"[^\x00-\x20]{0,20}", chunk[index:])
    return ((before[0] if before else b"") + (after[0] if after else b"")).decode("ascii", "replace")
