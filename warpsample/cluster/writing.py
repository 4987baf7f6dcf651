"""Writing of chunks into a store, only while the call that computes the chunks is running.

Each call has a folder with a random name inside its store. Files are written completely in the folder, and then moved to
their paths. When the call ends, the folder is removed. Tasks that still run, in any process, stop soon and cannot write.
The same holds if the store is removed and another one is created at its path.
"""

import json
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import lru_cache, partial
from pathlib import Path
from typing import Any
from uuid import uuid4
from zlib import crc32

import numpy as np
import zarr
from zarr.storage import MemoryStore

from warpsample.cluster.holdings import INDEX, RECORDS, file_of, record_of
from warpsample.cluster.job import MOST_CHUNKS
from warpsample.cluster.metadata import add_array
from warpsample.host.files import WriteError
from warpsample.host.interrupts import uninterrupted
from warpsample.host.progress import asking

_OPEN, _ENDED = "writing-", "ended-"
_BEAT = 0.01  # seconds between two checks whether tasks have stopped
_at_work: list[Path] = []
"""Folders of the tasks running in this process, one entry per task."""


@contextmanager
def writing(store: Path) -> Iterator[Path]:
    """Create the folder of a writing call for the body of a `with` statement, and remove folders of killed calls.

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
    for left in folder.parent.glob(f"{_OPEN}*"):
        _end(left)
    for left in folder.parent.glob(f"{_ENDED}*"):
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
    """Return the path of the store that contains a call's folder."""
    return folder.parents[1]


@contextmanager
def at_work(folder: Path) -> Iterator[None]:
    """Register the body of a `with` statement as a task of the writing call with this folder.

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


def put(folder: Path, start: int, chunk: int, arrays: dict[str, np.ndarray]) -> None:
    """Write a chunk of each array, then a record of the chunk's checksums. Each file appears complete.

    Args:
        folder: Folder of the writing call.
        start: Number of the chunk's first row.
        chunk: Number of rows per chunk; the last chunk may have fewer.
        arrays: Rows of the chunk, by array name.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    files = {}
    for name, rows in arrays.items():
        file = file_of(name, start // chunk, rows.ndim)
        encoder, encoded = _encoder(folder, name, rows.dtype, rows.shape[1:], chunk)
        encoder[start : start + len(rows)] = rows
        files[name] = file, encoded.pop(file).to_bytes() if len(rows) else b""
    put_encoded(folder, start // chunk, files)


def put_encoded(folder: Path, index: int, files: dict[str, tuple[str, bytes]]) -> None:
    """Write the encoded files of a chunk, then a record of their checksums. Each file appears complete.

    Args:
        folder: Folder of the writing call.
        index: Index of the chunk.
        files: (path in the store, content) by array name.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    uninterrupted(partial(_put_encoded, folder, index, files))


def _put_encoded(folder: Path, index: int, files: dict[str, tuple[str, bytes]]) -> None:
    """Write the files and the record of a chunk, as for `put_encoded`."""
    record = {INDEX: index}
    try:
        for name, (file, content) in files.items():
            record[name] = crc32(content)
            _place(folder, file, content)
        _place(folder, record_of(index), json.dumps(record).encode())
    except OSError as error:
        _check(folder)
        raise WriteError(f"{error.filename2 or store_of(folder)} cannot be written: {error.strerror or error}") from None


@lru_cache(maxsize=64)
def _encoder(_: Path, name: str, dtype: np.dtype, shape: tuple[int, ...], chunk: int) -> tuple[Any, dict[str, Any]]:
    """Return an array in memory that encodes chunks, and the dictionary that receives the encoded bytes.

    Keys of the dictionary are paths in the store. Threads share the dictionary, because no two tasks use the same path.
    The first argument is the folder of the writing call; it only makes the cache entry specific to the call.
    """
    encoded: dict[str, Any] = {}
    array = add_array(zarr.create_group(MemoryStore(encoded)), name, (dtype, shape), MOST_CHUNKS * chunk, chunk)
    return array.with_config({"write_empty_chunks": True}), encoded


def _place(folder: Path, file: str, content: bytes) -> None:
    """Write one file in the call's folder, and move it to its path in the store."""
    part, store, parts = folder / uuid4().hex, store_of(folder), Path(file).parts
    part.write_bytes(content)
    for depth in range(2, len(parts)):  # not the array's folder, which must not be created again after the store was removed
        store.joinpath(*parts[:depth]).mkdir(exist_ok=True)
    part.replace(store / file)
