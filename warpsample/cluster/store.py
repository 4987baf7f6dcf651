"""Creation of a Zarr store, and checks that an existing store can be resumed."""

import json
import math
import os
from collections.abc import Callable, Mapping
from functools import partial
from itertools import takewhile
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from warpsample.cluster.arrays import point_arrays_of
from warpsample.cluster.holdings import about_of, whole_chunks
from warpsample.cluster.job import SHAPE, STREAMS_OF, Job
from warpsample.cluster.lock import lock_name
from warpsample.cluster.metadata import check_metadata, check_readable, metadata_of
from warpsample.estimate.source.content import difference
from warpsample.host.arguments import quote
from warpsample.host.engine import check_space
from warpsample.host.files import WriteError
from warpsample.host.interrupts import uninterrupted
from warpsample.host.shared_values import describe_remedy

SUFFIX = ".zarr"


def check_store(path: Any, argument: str) -> Path:
    """Check the path of a Zarr store, and return the absolute path with links resolved.

    Workers may run in another folder, so the path is absolute. Links are resolved so that each store has one lock.

    Args:
        path: Path ending in .zarr.
        argument: Name of the path's argument, for error messages.

    Raises:
        ValueError: if the suffix is wrong, the path exists and is not a store, the name is not allowed by the file system,
            or the parent folder is missing.
    """
    if Path(path).suffix != SUFFIX:
        raise ValueError(f"{argument}: got {str(path)!r}, want a name that ends in {SUFFIX}")
    try:
        found = Path(os.path.realpath(path))
        found.with_name(lock_name(found)).exists()  # raises an error if the name is too long
        if found.is_symlink():
            raise ValueError(f"{argument}: got {str(path)!r}, which is a link to itself")
        if found.exists() and not (found / "zarr.json").is_file():
            raise ValueError(f"{argument}: got {str(path)!r}, which exists and is not a Zarr store, want another name")
        if not found.parent.is_dir():
            raise ValueError(f"{argument}: got {str(path)!r}, whose folder does not exist")
    except OSError as error:
        raise ValueError(f"{argument}: got {str(path)!r}, which cannot be written: {error.strerror}") from error
    return found


def begin(path: Path, job: Job, resume: bool, argument: str) -> np.ndarray:
    """Create the empty store of a job, or check that an existing store can be resumed.

    Args:
        path: Path of the store.
        job: Job to compute.
        resume: Whether an existing store may be continued.
        argument: Name of the path's argument, for error messages.

    Returns:
        (chunks,) bool mask of the chunks that are complete already.

    Raises:
        ValueError: if the store exists and `resume` is False, belongs to another run, is damaged, or would have too many
            chunks.
        WriteError: if the store cannot be written, or the disk has too little space.
    """
    check_new(path, resume, argument)
    if path.exists():
        check_same(path, job.about, argument)
        check_metadata(path, metadata_of(job), argument)
        check_readable(path, argument)
        whole = whole_chunks(path, (*point_arrays_of(job), *job.gives), argument)
        _check_space(path, job, job.count - np.count_nonzero(whole))
        return whole
    _check_space(path, job, job.count)
    job.check_count()
    make_store(path, partial(metadata_of, job))
    return np.zeros(job.count, np.bool_)


def check_new(path: Path, resume: bool, argument: str) -> None:
    """Raise a ValueError if a store exists and is not to be resumed."""
    if path.exists() and not resume:
        how = "a new name, or resume=True (--resume) to continue the run"
        raise ValueError(f"{argument}: got {str(path)!r}, which exists already, want {how}")


def _check_space(path: Path, job: Job, chunks: int) -> None:
    """Raise a WriteError if the disk has too little space for the chunks before compression.

    Positions hardly compress, so the uncompressed size is a good estimate.
    """
    kinds, points = {**point_arrays_of(job), **job.gives}.values(), min(job.total, chunks * job.chunk)
    needed = sum(points * dtype.itemsize * math.prod(shape) for dtype, shape in kinds)
    check_space(path, needed, f"{points:,} points")


def check_same(path: Path, about: dict[str, Any], argument: str) -> None:
    """Raise an error if a store was computed with other arguments, input data or versions.

    Args:
        path: Path of the store.
        about: Attributes that identify the run.
        argument: Name of the path's argument, for error messages.

    Raises:
        ValueError: if an attribute differs; the message names the attribute.
    """
    kept = {STREAMS_OF: 1, **about_of(path, argument)}
    for name in dict.fromkeys((STREAMS_OF, *about, *kept)):
        old, new = kept.get(name), json.loads(json.dumps(about.get(name)))
        if old != new and name == STREAMS_OF:
            raise ValueError(
                f"{argument}: got {str(path)!r} with random numbers of version {old}, want version {new}, which gives "
                "other numbers; compute the store again under a new name"
            )
        if name == SHAPE:
            continue  # the hash called "mesh" is of the shape, too
        if old != new and name == "mesh" and _shape_of(kept) == _shape_of(about):
            raise ValueError(
                f"{argument}: got {str(path)!r} of the same mesh with another transmittance or reflectance of its faces; "
                "repeat the arguments of that run, or use a new name"
            )
        if old != new and isinstance(old, dict) and isinstance(new, dict):
            raise ValueError(
                f"{argument}: got {str(path)!r} of another run; {difference(name, old, new)}; repeat the arguments of "
                "that run, or use a new name"
            )
        if old != new:
            old, new = _cut_common_clauses(old, new)
            raise ValueError(
                f"{argument}: got {str(path)!r} of {name} {quote(old)}, want a store of {name} {quote(new)}; "
                + describe_remedy(name)
            )


def _cut_common_clauses(old: Any, new: Any) -> tuple[Any, Any]:
    """Return two texts from the clause on in which they differ; a message shows only the beginning of a long text."""
    if not (isinstance(old, str) and isinstance(new, str)):
        return old, new
    clauses = old.split("; "), new.split("; ")
    same = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(*clauses, strict=False)))
    return "; ".join(clauses[0][same:]), "; ".join(clauses[1][same:])


def _shape_of(about: Mapping[str, Any]) -> Any:
    """Return the hash of a mesh without its optical properties, from the attributes of a store."""
    return about.get(SHAPE, about.get("mesh"))


def make_store(path: Path, metadata: Callable[[], dict[str, bytes]]) -> None:
    """Create a store from its metadata files.

    The store appears complete or not at all, also after an interrupt.

    Args:
        path: Path of the store.
        metadata: Function that returns the contents of the files, by path relative to the store.

    Raises:
        WriteError: if the files cannot be written.
    """
    uninterrupted(partial(_make_store, path, metadata))


def _make_store(path: Path, metadata: Callable[[], dict[str, bytes]]) -> None:
    """Create a store in a temporary folder, and move it to its path."""
    try:
        with TemporaryDirectory(prefix=f".{path.name}.", suffix=".part", dir=path.parent) as folder:
            part = Path(folder) / path.name  # in the folder, which only its user may read, unlike the store
            for file, content in metadata().items():
                part.joinpath(file).parent.mkdir(parents=True, exist_ok=True)
                part.joinpath(file).write_bytes(content)
            part.rename(path)
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
