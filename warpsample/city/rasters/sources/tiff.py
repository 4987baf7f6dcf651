"""Check that a TIFF file is as long as its directories state. For missing values, GDAL reads heights without an error."""

from collections.abc import Iterator
from pathlib import Path
from struct import Struct, error
from typing import BinaryIO

_ORDERS = {b"II*\0": "<", b"MM\0*": ">", b"II+\0": "<", b"MM\0+": ">"}  # of bytes, by the first four; "+" is BigTIFF
_SIZES = (0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8)  # bytes of a value, by the number of its type


def check_tiff(path: str) -> None:
    """Raise a ValueError for a TIFF file that ends before its directories or their values; other files pass."""
    size = Path(path).stat().st_size
    with Path(path).open("rb") as file:
        try:
            complete = all(end <= size for end in _ends(file, size))
        except error:  # too few bytes
            complete = False
    if not complete:
        raise ValueError(f"source: got {path!r}, whose end is missing; copy or download it again")


def _ends(file: BinaryIO, size: int) -> Iterator[int]:
    """Yield the ends of all directories of a TIFF file of `size` bytes, and of the values outside of the directories."""
    header = file.read(16)
    order, is_big = _ORDERS.get(header[:4]), b"+" in header[:4]
    if order is None:
        return
    count, address = Struct(order + "HQ"[is_big]), Struct(order + "IQ"[is_big])
    entry, seen = Struct(order + ("HHII", "HHQQ")[is_big]), {0}
    (at,) = address.unpack_from(header, 8 if is_big else 4)
    while at not in seen:
        seen.add(at)
        file.seek(at)
        (entries,) = count.unpack(file.read(count.size))
        end = at + count.size + entries * entry.size + address.size
        yield end
        if end > size:  # perhaps by far: it is not read
            return
        directory = file.read(end - at - count.size)
        for _, kind, number, place in entry.iter_unpack(directory[: -address.size]):
            length = number * (_SIZES[kind] if kind < len(_SIZES) else 0)
            yield place + length if length > address.size else 0
        (at,) = address.unpack(directory[-address.size :])
