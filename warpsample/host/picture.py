"""Pictures of distant light in files: Radiance's .hdr and NumPy's .npy. A damaged file is an error.

An .hdr is decoded here, with a count of the pixels of each line. VTK, the only dependency that reads .hdr, returns
uninitialised memory for a truncated file; the tests compare whole files with VTK. An .npy is read by a memory map, which
compares the declared shape with the size of the file before anything is allocated.
"""

import re
from math import ceil
from os import PathLike
from pathlib import Path
from typing import BinaryIO

import numpy as np

from warpsample.host.arguments import check_file, naming_file
from warpsample.host.files import read_array

_SHORTEST, _LONGEST = 8, 32767  # pixels of a line of an .hdr that may be encoded channel by channel
_LONGEST_RUN = 127
_FAINTEST = 1e-20  # exposure; the same limit for its inverse


def read_picture(path: str | PathLike[str], argument: str = "radiance") -> np.ndarray:
    """Read a picture from an .hdr file, (H, W, 3) float32, or from an .npy file; row 0 is the top.

    No pickle is loaded; `argument` names the path in errors.

    Raises:
        TypeError, FileNotFoundError: as `check_file`.
        ValueError: the suffix is another one, or the file is truncated, damaged or of another format.
    """
    path = check_file(path, argument, "an .hdr or .npy file")
    readers = {".hdr": _read_hdr, ".npy": read_array}
    if path.suffix.lower() not in readers:
        raise ValueError(f"{argument}: got {path.name!r}, want a file that ends in .hdr or .npy")
    with naming_file(argument, path, "a picture"):
        return readers[path.suffix.lower()](path)


def _read_hdr(path: Path) -> np.ndarray:
    """Return the (H, W, 3) float32 picture in an .hdr file."""
    with path.open("rb") as file:
        rows, columns, height, width, exposure = _header(file)
        data = file.read()
    least = min(4 * width, 4 + 8 * ceil(width / _LONGEST_RUN))
    if height * least > len(data):
        raise ValueError(f"the header declares {height:,} lines of {width:,} pixels, but only {len(data):,} bytes follow")
    pixels, at = np.empty((height, width, 4), np.uint8), 0
    for row in range(height):
        pixels[row], at = _line(data, at, width)
    if at < len(data):
        raise ValueError("the file has more bytes than the header declares")
    picture = pixels[..., :3].astype(np.float32)
    np.ldexp(picture, pixels[..., 3:].astype(np.int32) - 136, out=picture)
    picture[pixels[..., 3] == 0] = 0.0
    with np.errstate(all="ignore"):  # infinity and NaN are refused like numbers that are too large
        np.divide(picture, exposure, out=picture, casting="same_kind")
    return picture[rows, columns]


def _header(file: BinaryIO) -> tuple[slice, slice, int, int, np.ndarray]:
    """Read the header of an .hdr file; return (slices that flip the picture upright, height, width, exposure).

    The exposure is (3,), the product of the factors of all pixels (EXPOSURE) and of each colour (COLORCORR). Lines that
    begin with a tab are the headers of pictures from which this one was made.
    """
    exposure = np.ones(3)
    if not file.readline(80).startswith(b"#?"):
        raise ValueError("the file does not begin with '#?', as an .hdr file does")
    while line := file.readline(4096).rstrip():
        if line.startswith(b"FORMAT=") and line != b"FORMAT=32-bit_rle_rgbe":
            raise ValueError(f"the header has {line.decode('latin-1')[:60]!r}, want FORMAT=32-bit_rle_rgbe")
        name, _, value = line.partition(b"=")
        if name in (b"EXPOSURE", b"COLORCORR"):
            exposure *= _factors(line.decode("latin-1"), value.split(), 1 if name == b"EXPOSURE" else 3)
    size = re.fullmatch(rb"([+-])Y +([1-9]\d{0,8}) +([+-])X +([1-9]\d{0,8})\s*", file.readline(80))
    if not size:
        raise ValueError("the header declares no size such as '-Y 512 +X 1024'")
    down, height, right, width = size.groups()
    turned = slice(None, None, -1)
    rows, columns = (turned if is_turned else slice(None) for is_turned in (down == b"+", right == b"-"))
    return rows, columns, int(height), int(width), exposure


def _factors(line: str, values: list[bytes], count: int) -> np.ndarray:
    """Return the numbers in a line of the header, (count,) float64."""
    try:
        factors = np.zeros(0) if b"_" in b"".join(values) else np.array(values, np.float64)  # Python reads 1_0 as 10
    except ValueError:
        factors = np.zeros(0)
    if factors.shape != (count,) or not ((factors >= _FAINTEST) & (factors <= 1.0 / _FAINTEST)).all():
        raise ValueError(f"the header has {line[:60]!r}, want {count} {'number' if count == 1 else 'numbers'} above 0")
    return factors


def _line(data: bytes, at: int, width: int) -> tuple[np.ndarray, int]:
    """Decode one line of pixels of an .hdr file, (W, 4) uint8; also return the offset of the next line."""
    start = data[at : at + 4].ljust(4)
    if not (_SHORTEST <= width <= _LONGEST and start[:2] == b"\2\2" and start[2] < 128):
        return _plain_line(data[at : at + 4 * width], width), at + 4 * width
    if start[2:] != width.to_bytes(2, "big"):
        raise ValueError(
            f"a line of the picture declares {int.from_bytes(start[2:], 'big'):,} pixels, want {width:,}, as in the header"
        )
    planes, at = bytearray(), at + 4
    for channel in range(1, 5):
        while len(planes) < channel * width and at < len(data):
            code = data[at]
            run = code - 128 if code > 128 else 0
            planes += data[at + 1 : at + 2] * run if run else data[at + 1 : at + 1 + code]
            at += 2 if run else 1 + code
        if len(planes) != channel * width or at > len(data):
            raise ValueError(
                "the file ends within a line of pixels"
                if at >= len(data)
                else "a run of equal pixels is longer than the rest of the line"
            )
    return np.frombuffer(planes, np.uint8).reshape(4, width).T, at


def _plain_line(data: bytes, width: int) -> np.ndarray:
    """Decode a line of pixels that is stored without run-length encoding, (W, 4) uint8."""
    if len(data) < 4 * width:
        raise ValueError("the file ends within a line of pixels")
    line = np.frombuffer(data, np.uint8).reshape(width, 4)
    if (line[:, :3] == 1).all(axis=1).any():
        raise ValueError(
            "the file uses the old run-length encoding, want the new encoding, line by line; save the picture again"
        )
    return line
