"""Checksums of the blocks of a raster, which detect changes between a first and a second reading."""

from collections.abc import Iterator
from dataclasses import replace
from hashlib import sha256

import numpy as np

from warpsample.city.rasters.sources.reader import RasterReader
from warpsample.host.shared_values import digest_of

_BLOCK = 64, 256
"""Rows and columns of a block; readers read whole blocks."""

_BAND = 1 << 22  # cells per reading step


def digests_of(reader: RasterReader) -> np.ndarray:
    """Compute the SHA-256 checksum of the heights in each block of a raster, (block rows, block columns, 32) uint8."""
    rows, columns = reader.shape
    found = np.empty((-(-rows // _BLOCK[0]), -(-columns // _BLOCK[1]), 32), np.uint8)
    wide = max(1, min(found.shape[1], _BAND // (_BLOCK[0] * _BLOCK[1])))
    high = max(1, _BAND // (wide * _BLOCK[0] * _BLOCK[1]))
    for top in range(0, found.shape[0], high):
        for left in range(0, found.shape[1], wide):
            part = slice(top, min(top + high, found.shape[0])), slice(left, min(left + wide, found.shape[1]))
            found[part] = _hash_blocks(reader.heights(*_cells_of_blocks(part, reader.shape)))
    return found


def unchanging(reader: RasterReader, digests: np.ndarray, argument: str) -> RasterReader:
    """Return a copy of a raster's reader that raises an error if heights differ from earlier checksums.

    Args:
        reader: Reader of the raster.
        digests: Earlier result of `digests_of`.
        argument: Name of the argument for error messages.

    Returns:
        A reader whose `heights` raise a ValueError for changed heights; the message names the block.
    """

    def heights(rows: slice, columns: slice) -> np.ndarray:
        part = tuple(
            slice(cut.start // side, -(-cut.stop // side)) for cut, side in zip((rows, columns), _BLOCK, strict=True)
        )
        cells = _cells_of_blocks(part, reader.shape)
        found = reader.heights(*cells)
        other = np.argwhere((_hash_blocks(found) != digests[part]).any(axis=-1))
        if len(other):
            row, column = (other[0] + [part[0].start, part[1].start]) * _BLOCK
            raise ValueError(
                f"{argument}: got heights that changed since the run began, from row {row:,} and column {column:,}; want "
                "the original raster to resume the run"
            )
        return found[tuple(slice(c.start - p.start, c.stop - p.start) for c, p in zip((rows, columns), cells, strict=True))]

    return replace(reader, heights=heights)


def place_of(reader: RasterReader) -> dict[str, str | float]:
    """Return texts that identify a raster's place on the map: transform, reference system and unit of heights."""
    crs = reader.crs and f"{reader.crs.name}, {sha256(reader.crs.to_wkt().encode()).hexdigest()[:16]}"
    transform = " ".join(repr(float(number)) for number in reader.transform[:6])
    return {"transform": transform, "crs": crs or "none", "factor": reader.factor}


def _cells_of_blocks(part: tuple[slice, slice], shape: tuple[int, int]) -> tuple[slice, slice]:
    """Convert a range of blocks of a raster to the rows and columns of its cells."""
    ends = zip(part, _BLOCK, shape, strict=True)
    return tuple(slice(cut.start * side, min(cut.stop * side, size)) for cut, side, size in ends)


def _hash_blocks(heights: np.ndarray) -> np.ndarray:
    """Compute the checksum of each block of an array whose first cell is the first cell of a block."""
    digests = [[bytes.fromhex(digest_of(block)) for block in _split_blocks(band, 1)] for band in _split_blocks(heights, 0)]
    return np.frombuffer(b"".join(map(b"".join, digests)), np.uint8).reshape(len(digests), -1, 32)


def _split_blocks(heights: np.ndarray, axis: int) -> Iterator[np.ndarray]:
    """Split an array along an axis into blocks, and return an iterator over the blocks; the last one may be shorter."""
    starts = range(_BLOCK[axis], heights.shape[axis], _BLOCK[axis])
    return iter(np.split(heights, starts, axis))
