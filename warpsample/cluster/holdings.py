"""What a Zarr store holds: what repeats its run, its arrays, and which of its chunks are whole."""

import json
from collections.abc import Iterable
from math import prod
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import zarr

RECORDS = ".run"
"""The folder of a store that is no array: of each chunk the checksums of its files, with its index."""
INDEX = "chunk"
"""The entry of a record that is no array's."""

_OF_XARRAY = ("coordinates",)  # attributes that xarray reads


def about_of(path: Path, argument: str) -> dict[str, Any]:
    """All that repeats the run of a store.

    Raises:
        ValueError: its metadata cannot be read.
    """
    kept = _opened(path, argument).attrs.asdict()
    return {name: value for name, value in kept.items() if name not in _OF_XARRAY}


def file_of(name: str, chunk: int, dimensions: int) -> str:
    """The path of a chunk's file within its store."""
    return "/".join([name, "c", str(chunk), *["0"] * (dimensions - 1)])


def record_of(chunk: int) -> str:
    """The path of a chunk's record within its store."""
    return f"{RECORDS}/chunks/{chunk}"


def _opened(path: Path, argument: str) -> Any:
    for metadata in (path / "zarr.json", *path.glob("*/zarr.json")):
        if metadata.exists() and not metadata.is_file():  # a pipe would wait for who writes to it
            raise ValueError(f"{argument}: got {str(path)!r}, whose {metadata.relative_to(path)} is not an ordinary file")
    try:
        return zarr.open_group(path, mode="r", use_consolidated=False)
    except Exception as error:  # a file that holds anything fails in any way
        reason = " ".join(str(error).split())
        raise ValueError(f"{argument}: got {str(path)!r}, whose zarr.json cannot be read: {reason}") from None


def arrays_of(path: Path, names: Iterable[str], argument: str) -> dict[str, Any]:
    """The arrays of a store.

    Raises:
        ValueError: one of these is not there, or cannot be read; names it.
    """
    group = _opened(path, argument)
    return {name: _array(group, name, f"{argument}: got {str(path)!r}") for name in names}


def _array(group: Any, name: str, got: str) -> Any:
    try:
        return group[name]
    except KeyError:
        raise ValueError(f"{got}, whose array {name!r} is missing; bake it anew") from None
    except Exception as error:  # as for the group
        raise ValueError(f"{got}, whose array {name!r} cannot be read: {' '.join(str(error).split())}") from None


def whole_chunks(path: Path, names: Iterable[str], argument: str = "path") -> np.ndarray:
    """(chunks,) bool: which chunks are there in every array of these names, and read as they were written.

    Raises:
        ValueError: as `arrays_of`.
    """
    arrays = arrays_of(path, names, argument)
    first = next(iter(arrays.values()))
    chunks = range(prod(_grid_of(first)))
    return np.array([_is_whole(path, arrays, i) for i in chunks], np.bool_)


def _grid_of(array: Any) -> tuple[int, ...]:
    """How many chunks an array has along each axis."""
    return tuple(-(-size // side) for size, side in zip(array.shape, array.chunks, strict=True))


def _is_whole(path: Path, arrays: dict[str, Any], chunk: int) -> bool:
    """Whether a chunk's files hold what was written to them, by the record that was written last."""
    try:
        record = json.loads(_content(path.joinpath(record_of(chunk))))
        places = {name: np.unravel_index(chunk, _grid_of(array)) for name, array in arrays.items()}
        files = {name: path.joinpath(name, "c", *map(str, place)) for name, place in places.items()}
        return record[INDEX] == chunk and all(record[name] == crc32(_content(file)) for name, file in files.items())
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return False


def _content(file: Path) -> bytes:
    """The bytes of an ordinary file; a pipe would wait for who writes to it."""
    if not file.is_file():
        raise FileNotFoundError(file)
    return file.read_bytes()
