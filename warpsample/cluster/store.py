"""A Zarr store of one run as it is made, and gone on with."""

import json
import math
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from warpsample.cluster.arrays import point_arrays_of
from warpsample.cluster.holdings import about_of, whole_chunks
from warpsample.cluster.job import STREAMS_OF, Job
from warpsample.cluster.lock import lock_name
from warpsample.cluster.metadata import check_metadata, metadata_of
from warpsample.estimate.source.content import difference
from warpsample.host.arguments import told
from warpsample.host.engine import check_space
from warpsample.host.files import WriteError
from warpsample.host.interrupts import uninterrupted

SUFFIX = ".zarr"


def check_store(path: Any, argument: str) -> Path:
    """A path that a store may be at, absolute: workers may run elsewhere; and without links: a store has one lock.

    Raises:
        ValueError: another suffix, a file, a name that cannot be one, or no folder to make it in.
    """
    if Path(path).suffix != SUFFIX:
        raise ValueError(f"{argument}: got {str(path)!r}, want a name that ends in {SUFFIX}")
    try:
        found = Path(os.path.realpath(path))
        found.with_name(lock_name(found)).exists()  # which raises an error where that is too long
        if found.is_symlink():
            raise ValueError(f"{argument}: got {str(path)!r}, which is a link to itself")
        if found.exists() and not (found / "zarr.json").is_file():
            raise ValueError(f"{argument}: got {str(path)!r}, which is there already and is no store, want a new name")
        if not found.parent.is_dir():
            raise ValueError(f"{argument}: got {str(path)!r}, whose folder does not exist")
    except OSError as error:
        raise ValueError(f"{argument}: got {str(path)!r}, which cannot be written: {error.strerror}") from error
    return found


def begin(path: Path, job: Job, resume: bool, argument: str) -> np.ndarray:
    """Makes the store of a job without its chunks, or finds the one that it is to go on with.

    Returns:
        which chunks are there already, and whole.

    Raises:
        ValueError: there is one, and it is not to be resumed, or is of another run; names what differs. Or it is damaged, or
            would have too many chunks.
        WriteError: it cannot be made, or there is no space for it.
    """
    check_new(path, resume, argument)
    if path.exists():
        check_same(path, job.about, argument)
        check_metadata(path, job, argument)
        whole = whole_chunks(path, (*point_arrays_of(job), *job.gives), argument)
        _check_space(path, job, job.count - np.count_nonzero(whole))
        return whole
    _check_space(path, job, job.count)
    job.check_count()
    make_store(path, partial(metadata_of, job))
    return np.zeros(job.count, np.bool_)


def check_new(path: Path, resume: bool, argument: str) -> None:
    """Refuses, by a ValueError, a store that is there and not to be resumed."""
    if path.exists() and not resume:
        how = "a new name, or to resume it (resume=True, --resume)"
        raise ValueError(f"{argument}: got {str(path)!r}, which is there already, want {how}")


def _check_space(path: Path, job: Job, chunks: int) -> None:
    """Refuses more chunks than there is space for, before they are compressed: positions hardly can be."""
    kinds, points = {**point_arrays_of(job), **job.gives}.values(), min(job.total, chunks * job.chunk)
    needed = sum(points * dtype.itemsize * math.prod(shape) for dtype, shape in kinds)
    check_space(path, needed, f"{points:,} points")


def check_same(path: Path, about: dict[str, Any], argument: str) -> None:
    """Refuses a store of another run.

    Raises:
        ValueError: names what differs.
    """
    kept = {STREAMS_OF: 1, **about_of(path, argument)}
    for name in dict.fromkeys((STREAMS_OF, *about, *kept)):
        old, new = kept.get(name), json.loads(json.dumps(about.get(name)))
        if old != new and name == STREAMS_OF:
            raise ValueError(
                f"{argument}: got {str(path)!r} of random streams by definition {old}, want one by definition {new}, whose "
                "seeds give other numbers: bake it anew"
            )
        if old != new and isinstance(old, dict) and isinstance(new, dict):
            raise ValueError(f"{argument}: got {str(path)!r} of another run; {difference(name, old, new)}")
        if old != new:
            raise ValueError(f"{argument}: got {str(path)!r} of {name} {told(old)}, want one of {name} {told(new)}")


def make_store(path: Path, metadata: Callable[[], dict[str, bytes]]) -> None:
    """Writes the metadata of a store, contents by their paths within it; complete or absent, also after an interrupt.

    Raises:
        WriteError: they cannot be written.
    """
    uninterrupted(partial(_make_store, path, metadata))


def _make_store(path: Path, metadata: Callable[[], dict[str, bytes]]) -> None:
    try:
        with TemporaryDirectory(prefix=f".{path.name}.", suffix=".part", dir=path.parent) as folder:
            part = Path(folder) / path.name  # in it: such a folder is its user's alone, which the store need not be
            for file, content in metadata().items():
                part.joinpath(file).parent.mkdir(parents=True, exist_ok=True)
                part.joinpath(file).write_bytes(content)
            part.rename(path)
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
