"""What a Zarr store holds: what repeats its run, its arrays, and which of its chunks are whole."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import zarr

_OF_XARRAY = ("coordinates",)  # attributes that xarray reads


def about_of(path: Path, argument: str) -> dict[str, Any]:
    """All that repeats the run of a store.

    Raises:
        ValueError: its metadata cannot be read.
    """
    kept = _opened(path, argument).attrs.asdict()
    return {name: value for name, value in kept.items() if name not in _OF_XARRAY}


def _opened(path: Path, argument: str) -> Any:
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
    chunks = range(-(-first.shape[0] // first.chunks[0]))
    return np.array([all(_is_whole(path / name, array, i) for name, array in arrays.items()) for i in chunks], np.bool_)


def _is_whole(folder: Path, array: Any, chunk: int) -> bool:
    if not folder.joinpath("c", str(chunk), *("0" for _ in array.shape[1:])).is_file():
        return False
    try:
        array[chunk * array.chunks[0] : (chunk + 1) * array.chunks[0]]
    except Exception:  # of the checksum, or of a decompressor
        return False
    return True
