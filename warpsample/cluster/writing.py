"""Writing of chunks into a Zarr store by worker tasks, which stop writing when the call that started them ends.

Each call has a folder with a random name inside its store. Files are written completely in the folder, and then moved to
their paths. When the call ends, the folder is removed. Tasks that still run, in any process, stop soon and cannot write.
The same holds if the store is removed and another one is created at its path.
"""

import json
import shutil
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import lru_cache, partial
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
import zarr
from zarr.storage import MemoryStore

from warpsample.cluster.holdings import INDEX, RECORDS, SUMS, checksum_of, file_of, record_of
from warpsample.cluster.job import MOST_CHUNKS
from warpsample.cluster.metadata import add_array
from warpsample.host.files import WriteError
from warpsample.host.interrupts import uninterrupted
from warpsample.host.progress import asking

_OPEN, _ENDED, _HEX = "writing-", "ended-", "[0-9a-f]" * 32
_BEAT = 0.01  # seconds between two checks whether tasks have stopped
_at_work: list[Path] = []
"""Folders of the tasks running in this process, one entry per task."""


@contextmanager
def writing(store: Path) -> Iterator[Path]:
    """Create a temporary folder in a store within a `with` statement; tasks may write to the store while it exists.

    After the body no task of the call runs in this process, and tasks in other processes can write nothing more.

    Yields:
        the path of the folder.

    Raises:
        WriteError: if the folder cannot be created.
    """
    folder = store / RECORDS / f"{_OPEN}{uuid4().hex}"
    try:
        uninterrupted(partial(_begin, folder))
        yield folder
    finally:
        uninterrupted(partial(_end, folder))


def _begin(folder: Path) -> None:
    """Remove the folders of calls that were killed, and create the folder of this call.

    Raises:
        WriteError: if the folder cannot be created.
    """
    for left in folder.parent.glob(_OPEN + _HEX):
        _end(left)
    for left in folder.parent.glob(_ENDED + _HEX):
        shutil.rmtree(left, ignore_errors=True)
    try:
        folder.parent.mkdir(exist_ok=True)  # stores of earlier versions do not have the folder
        folder.mkdir()
    except OSError as error:
        raise WriteError(f"{store_of(folder)} cannot be written: {error.strerror or error}") from error


def _end(folder: Path) -> None:
    """End the writing of a call by renaming its folder, then wait until the call's tasks in this process stop."""
    ended = folder.with_name(f"{_ENDED}{uuid4().hex}")
    with suppress(OSError):  # already removed with its store
        folder.rename(ended)
    while folder in _at_work:
        time.sleep(_BEAT)
    shutil.rmtree(ended, ignore_errors=True)


def store_of(folder: Path) -> Path:
    """Return the path of the store that contains the folder of a writing call."""
    return folder.parents[1]


@contextmanager
def at_work(folder: Path) -> Iterator[None]:
    """Mark a task as running within a `with` statement, so that the call that writes the store waits for its end.

    Kernels in the body stop between two batches of rays when the call ends.

    Raises:
        WriteError: if the call has ended.
    """
    _at_work.append(folder)
    try:
        check = partial(_check, folder)
        check()
        with asking(check):
            yield
    finally:
        _at_work.remove(folder)


def _check(folder: Path) -> None:
    """Raise a WriteError if the writing call has ended or the store has been removed."""
    if not folder.is_dir():
        raise WriteError(f"{store_of(folder)} cannot be written: the call has ended, or the store was removed meanwhile")


def write_chunk(
    folder: Path, index: int, place: tuple[int, ...], sides: tuple[int, ...], arrays: Mapping[str, np.ndarray]
) -> None:
    """Write one chunk of every array into the store, then a record of the chunk's checksums.

    Other processes never see a partly written file.

    Args:
        folder: Folder of the writing call.
        index: Index of the chunk among all chunks.
        place: Index of the chunk along each of the first dimensions, which are split: rows, or rows and columns of tiles.
        sides: Size of a chunk along these dimensions; the last chunks may be smaller.
        arrays: Content of the chunk, by array name.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    files = {}
    for name, array in arrays.items():
        file = file_of(name, (*place, *[0] * (array.ndim - len(place))))
        files[name] = file, _encode(folder, name, index, array, sides) if len(array) else b""
    uninterrupted(partial(_write_files, folder, index, files))


def _write_files(folder: Path, index: int, files: dict[str, tuple[str, bytes]]) -> None:
    """Write the encoded files of a chunk, (path in the store, content) by array name, and the record of the chunk."""
    record = {INDEX: index, SUMS: {name: checksum_of(content) for name, (_, content) in files.items()}}
    try:
        for file, content in files.values():
            _move_into_store(folder, file, content)
        _move_into_store(folder, record_of(index), json.dumps(record).encode())
    except OSError as error:
        _check(folder)
        raise WriteError(f"{error.filename2 or store_of(folder)} cannot be written: {error.strerror or error}") from None


def _encode(folder: Path, name: str, index: int, array: np.ndarray, sides: tuple[int, ...]) -> bytes:
    """Encode one chunk of an array, and return the content of the chunk's file."""
    chunk = (*sides, *array.shape[len(sides) :])
    encoder, encoded = _encoder(folder, name, array.dtype, chunk)
    slot = index % MOST_CHUNKS
    encoder[(slice(slot * chunk[0], slot * chunk[0] + len(array)), *map(slice, array.shape[1:]))] = array
    return encoded.pop(file_of(name, (slot, *[0] * (array.ndim - 1)))).to_bytes()


@lru_cache(maxsize=64)
def _encoder(_: Path, name: str, dtype: np.dtype, chunk: tuple[int, ...]) -> tuple[Any, dict[str, Any]]:
    """Return an in-memory Zarr array that encodes chunks, and the dictionary that receives the encoded bytes.

    Keys of the dictionary are paths in the store. Threads share the dictionary, because no two tasks use the same path.
    The first argument is the folder of the writing call; it only makes the cache entry specific to the call.
    """
    encoded: dict[str, Any] = {}
    shape = (MOST_CHUNKS * chunk[0], *chunk[1:])
    array = add_array(zarr.create_group(MemoryStore(encoded)), name, dtype, shape, chunk)
    return array.with_config({"write_empty_chunks": True}), encoded


def _move_into_store(folder: Path, file: str, content: bytes) -> None:
    """Write one file in the call's folder, and move it to its path in the store."""
    part, store, parts = folder / uuid4().hex, store_of(folder), Path(file).parts
    part.write_bytes(content)
    for depth in range(2, len(parts)):  # not the array's folder, which must not be created again after the store was removed
        store.joinpath(*parts[:depth]).mkdir(exist_ok=True)
    part.replace(store / file)
