"""The chunks of a store on their way: nothing is written for a call that has ended, nor into a store that is not its own.

A call has a folder within its store, named at random. Each file is written there whole, and then moved to its place. When
the call ends, that folder goes: tasks that still run, in whichever process, stop soon after, and cannot write. Nor can they
if the store was removed, and another one made at its path.
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
_BEAT = 0.01  # seconds between two looks at whether tasks have stopped
_at_work: list[Path] = []
"""The folders of the tasks that run in this process."""


@contextmanager
def writing(store: Path) -> Iterator[Path]:
    """Makes a call's folder, and ends those of calls that were killed.

    However the call ends, no task of it is at work in this process afterwards, and those of other processes write nothing.

    Raises:
        WriteError: the folder cannot be made.
    """
    folder = store / RECORDS / f"{_OPEN}{uuid4().hex}"
    try:
        uninterrupted(partial(_begin, folder))
        yield folder
    finally:
        uninterrupted(partial(_end, folder))


def _begin(folder: Path) -> None:
    for left in folder.parent.glob(f"{_OPEN}*"):
        _end(left)
    for left in folder.parent.glob(f"{_ENDED}*"):
        shutil.rmtree(left, ignore_errors=True)
    try:
        folder.parent.mkdir(exist_ok=True)  # which a store that an earlier version made is without
        folder.mkdir()
    except OSError as error:
        raise WriteError(f"{store_of(folder)} cannot be written: {error.strerror or error}") from error


def _end(folder: Path) -> None:
    """Ends the writing in one step, by another name; then waits for this process's tasks, which find that out."""
    ended = folder.with_name(f"{_ENDED}{uuid4().hex}")
    with suppress(OSError):  # gone already, with its store
        folder.rename(ended)
    while folder in _at_work:
        time.sleep(_BEAT)
    shutil.rmtree(ended, ignore_errors=True)


def store_of(folder: Path) -> Path:
    """The store that a call's folder is in."""
    return folder.parents[1]


@contextmanager
def at_work(folder: Path) -> Iterator[None]:
    """A task of the call that has this folder: within, kernels stop between two of their batches when the call has ended.

    Raises:
        WriteError: the call has ended.
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
    if not folder.is_dir():
        raise WriteError(f"{store_of(folder)} cannot be written: the call has ended, or the store was removed meanwhile")


def put(folder: Path, start: int, chunk: int, arrays: dict[str, np.ndarray]) -> None:
    """Writes a chunk of each array, and last a record of them. Each file appears when it is complete.

    Args:
        folder: of the call.
        start: the first row.
        chunk: how many rows each chunk has, but the last.
        arrays: the rows, by name.

    Raises:
        WriteError: it cannot be written, or the call has ended.
    """
    files = {}
    for name, rows in arrays.items():
        file = file_of(name, start // chunk, rows.ndim)
        encoder, encoded = _encoder(folder, name, rows.dtype, rows.shape[1:], chunk)
        encoder[start : start + len(rows)] = rows
        files[name] = file, encoded.pop(file).to_bytes() if len(rows) else b""
    put_encoded(folder, start // chunk, files)


def put_encoded(folder: Path, index: int, files: dict[str, tuple[str, bytes]]) -> None:
    """Writes the files of a chunk, and last a record of them; as `put`.

    Args:
        folder: of the call.
        index: of the chunk.
        files: (path in the store, content) by the names of the arrays.
    """
    uninterrupted(partial(_put_encoded, folder, index, files))


def _put_encoded(folder: Path, index: int, files: dict[str, tuple[str, bytes]]) -> None:
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
    """An array in memory, to encode chunks, and where it puts them, by their paths in the store: no two tasks share one."""
    encoded: dict[str, Any] = {}
    array = add_array(zarr.create_group(MemoryStore(encoded)), name, (dtype, shape), MOST_CHUNKS * chunk, chunk)
    return array.with_config({"write_empty_chunks": True}), encoded


def _place(folder: Path, file: str, content: bytes) -> None:
    part, store, parts = folder / uuid4().hex, store_of(folder), Path(file).parts
    part.write_bytes(content)
    for depth in range(2, len(parts)):  # not the array's own: that of a store that was removed is not made again
        store.joinpath(*parts[:depth]).mkdir(exist_ok=True)
    part.replace(store / file)
