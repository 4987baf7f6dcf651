"""Reading of a Zarr store: its attributes, its arrays, and which of its chunks are complete."""

import json
from collections.abc import Iterable
from math import prod
from pathlib import Path
from typing import Any
from zlib import crc32

import google_crc32c
import numpy as np
import zarr

RECORDS = ".run"
"""Folder of a store with a record for each chunk: the index of the chunk and the checksums of its files."""
INDEX = "chunk"
"""Key of the chunk's index in a record."""
SUMS = "crc32c"
"""Key of the checksums in a record, by name of the array; records of version 0.1 have CRC-32s under the names alone."""

_CHECKSUM = 4  # bytes
_OF_XARRAY = ("coordinates",)  # attributes for xarray, not part of the run


def about_of(path: Path, argument: str) -> dict[str, Any]:
    """Read the attributes of a store that describe how it was computed: arguments, hashes of inputs, and versions.

    Args:
        path: Path of the store.
        argument: Name of the path's argument, for error messages.

    Raises:
        ValueError: if the metadata cannot be read.
    """
    kept = _open_group(path, argument).attrs.asdict()
    return {name: value for name, value in kept.items() if name not in _OF_XARRAY}


def file_of(name: str, place: Iterable[int]) -> str:
    """Return the path, relative to the store, of the file with one chunk of an array."""
    return "/".join([name, "c", *map(str, place)])


def checksum_of(content: bytes) -> int | None:
    """Return the CRC-32C checksum at the end of a chunk's file, or None if the content does not match the checksum."""
    kept = int.from_bytes(content[-_CHECKSUM:], "little")
    return kept if google_crc32c.value(content[:-_CHECKSUM]) == kept else None


def record_of(chunk: int) -> str:
    """Return the path, relative to the store, of the file that records the checksums of a chunk."""
    return f"{RECORDS}/chunks/{chunk}"


def _open_group(path: Path, argument: str) -> Any:
    """Open a store for reading as a Zarr group.

    Raises:
        ValueError: if a metadata file is a pipe or another special file, or cannot be read.
    """
    for metadata in (path / "zarr.json", *path.glob("*/zarr.json")):
        if metadata.exists() and not metadata.is_file():  # opening a pipe would block
            raise ValueError(f"{argument}: got {str(path)!r}, whose {metadata.relative_to(path)} is not an ordinary file")
    try:
        return zarr.open_group(path, mode="r", use_consolidated=False)
    except Exception as error:  # damaged files raise errors of many types
        reason = " ".join(str(error).split())
        raise ValueError(f"{argument}: got {str(path)!r}, whose zarr.json cannot be read: {reason}") from None


def arrays_of(path: Path, names: Iterable[str], argument: str) -> dict[str, Any]:
    """Return a dictionary of the named Zarr arrays of a store.

    Args:
        path: Path of the store.
        names: Names of the arrays.
        argument: Name of the path's argument, for error messages.

    Raises:
        ValueError: if an array is missing or cannot be read; the message names the array.
    """
    group = _open_group(path, argument)
    return {name: _array(group, name, f"{argument}: got {str(path)!r}") for name in names}


def _array(group: Any, name: str, got: str) -> Any:
    """Return the named array of a Zarr group, or raise an error if there is none.

    Raises:
        ValueError: if the array is missing or cannot be read.
    """
    try:
        return group[name]
    except KeyError:
        raise ValueError(f"{got}, whose array {name!r} is missing; compute the store again under a new name") from None
    except Exception as error:  # as for the group
        raise ValueError(f"{got}, whose array {name!r} cannot be read: {' '.join(str(error).split())}") from None


def whole_chunks(path: Path, names: Iterable[str], argument: str = "path") -> np.ndarray:
    """Return the (chunks,) bool mask of chunks that are complete in every named array.

    A chunk is complete if all its files match the checksums in the chunk's record.

    Raises:
        ValueError: if an array is missing or cannot be read; the message names the array.
    """
    arrays = arrays_of(path, names, argument)
    first = next(iter(arrays.values()))
    chunks = range(prod(_grid_of(first)))
    return np.array([_is_whole(path, arrays, i) for i in chunks], np.bool_)


def _grid_of(array: Any) -> tuple[int, ...]:
    """Return the number of chunks of an array along each dimension."""
    return tuple(-(-size // side) for size, side in zip(array.shape, array.chunks, strict=True))


def _is_whole(path: Path, arrays: dict[str, Any], chunk: int) -> bool:
    """Return whether the files of a chunk match the checksums in the chunk's record."""
    try:
        record = json.loads(_read_bytes(path.joinpath(record_of(chunk))))
        places = {name: np.unravel_index(chunk, _grid_of(array)) for name, array in arrays.items()}
        sums, checksum = (record[SUMS], checksum_of) if SUMS in record else (record, crc32)
        whole = (sums[name] == checksum(_read_bytes(path / file_of(name, place))) for name, place in places.items())
        return record[INDEX] == chunk and all(whole)
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return False


def _read_bytes(file: Path) -> bytes:
    """Return the content of a regular file, as bytes.

    Raises:
        FileNotFoundError: if the path is not a regular file; reading from a pipe would block.
    """
    if not file.is_file():
        raise FileNotFoundError(file)
    return file.read_bytes()
