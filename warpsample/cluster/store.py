"""A Zarr store of one run as it is made, gone on with, and written chunk by chunk."""

import json
import math
import shutil
import warnings
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
import zarr
from zarr.codecs import Crc32cCodec, ZstdCodec

from warpsample.cluster.arrays import dimensions, point_arrays_of
from warpsample.cluster.content import difference
from warpsample.cluster.holdings import about_of, arrays_of, whole_chunks
from warpsample.cluster.job import STREAMS_OF, Job
from warpsample.host.arguments import told
from warpsample.host.files import WriteError
from warpsample.host.locks import making

SUFFIX = ".zarr"

_ABSENT = {"f": float("nan"), "i": -2, "u": 255}  # what is read where no chunk is


def check_store(path: Any, argument: str) -> Path:
    """A path that a store may be at, absolute: workers may run elsewhere.

    Raises:
        ValueError: another suffix, a file, or no folder to make it in.
    """
    found = Path(path).absolute()
    if found.suffix != SUFFIX:
        raise ValueError(f"{argument}: got {str(path)!r}, want a name that ends in {SUFFIX}")
    if found.exists() and not (found / "zarr.json").is_file():
        raise ValueError(f"{argument}: got {str(path)!r}, which is there already and is no store, want a new name")
    if not found.parent.is_dir():
        raise ValueError(f"{argument}: got {str(path)!r}, whose folder does not exist")
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
    if path.exists() and not resume:
        raise ValueError(f"{argument}: got {str(path)!r}, which is there already, want a new name, or to resume it")
    if path.exists():
        check_same(path, job.about, argument)
        for part in path.rglob("*.partial"):  # of killed writers
            part.unlink(missing_ok=True)
        _check_arrays(path, job, argument)
        whole = whole_chunks(path, (*point_arrays_of(job), *job.gives), argument)
        _check_space(path, job, job.count - np.count_nonzero(whole))
        return whole
    _check_space(path, job, job.count)
    job.check_count()
    try:
        _make(path, job)
    except OSError as error:
        shutil.rmtree(_part(path), ignore_errors=True)
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
    return np.zeros(job.count, np.bool_)


def _check_arrays(path: Path, job: Job, argument: str) -> None:
    """Refuses a store whose arrays are not those of the job, though its attributes are.

    Raises:
        ValueError: names the array.
    """
    kinds = {**point_arrays_of(job), **job.gives}
    for name, array in arrays_of(path, kinds, argument).items():
        dtype, shape = kinds[name]
        if (array.dtype, array.shape, array.chunks) != (dtype, (job.total, *shape), (job.chunk, *shape)):
            got = f"{argument}: got {str(path)!r}, whose array {name!r}"
            raise ValueError(f"{got} is of another shape or type; bake it anew")
    try:
        with making, warnings.catch_warnings():  # that there are none, from which xarray takes the arrays' own
            warnings.simplefilter("ignore")
            xr.open_zarr(path)  # by the consolidated metadata
    except Exception as error:
        told = f"whose zarr.json cannot be read: {' '.join(str(error).split())}; bake it anew"
        raise ValueError(f"{argument}: got {str(path)!r}, {told}") from None


def _check_space(path: Path, job: Job, chunks: int) -> None:
    """Refuses more chunks than there is space for, before they are compressed: positions hardly can be.

    Raises:
        WriteError: says how much they take, and how much is free.
    """
    kinds = {**point_arrays_of(job), **job.gives}.values()
    needed = sum(min(job.total, chunks * job.chunk) * dtype.itemsize * math.prod(shape) for dtype, shape in kinds)
    free = shutil.disk_usage(path.parent).free
    if needed > free:
        raise WriteError(
            f"{path} cannot be written: {min(job.total, chunks * job.chunk):,} points take {needed / 1e9:,.3f} GB, and "
            f"{free / 1e9:,.3f} GB are free"
        )


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


def _make(path: Path, job: Job) -> None:
    """The metadata, complete or absent."""
    coordinates, part = point_arrays_of(job), _part(path)
    shutil.rmtree(part, ignore_errors=True)
    attributes = {**job.about, "coordinates": " ".join(name for name in coordinates if name not in job.gives)}
    group = zarr.create_group(part, zarr_format=3, attributes=attributes)
    for name, (dtype, shape) in {**coordinates, **job.gives}.items():
        group.create_array(
            name,
            shape=(job.total, *shape),
            chunks=(job.chunk, *shape),
            dtype=dtype,
            fill_value=_ABSENT[dtype.kind],
            compressors=[ZstdCodec(level=1), Crc32cCodec()],  # a chunk that is cut short does not read as whole
            dimension_names=dimensions(name, 1 + len(shape)),
        )
    with making, warnings.catch_warnings():  # that the format's text does not have them yet, though its readers do
        warnings.simplefilter("ignore")
        zarr.consolidate_metadata(part)
    part.rename(path)


def _part(path: Path) -> Path:
    return path.with_name(f".{path.name}.part")


def put(path: Path, start: int, arrays: dict[str, np.ndarray]) -> None:
    """Writes a chunk of each array. A file appears when it is complete.

    Raises:
        WriteError: it cannot be written.
    """
    try:
        kept = _arrays(path, (path / "zarr.json").stat().st_ino)
        for name, rows in arrays.items():
            kept[name][start : start + len(rows)] = rows
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from None


@lru_cache(maxsize=4)
def _arrays(path: Path, _: int) -> dict[str, Any]:
    """The arrays of a store, to be written; anew if it has been replaced."""
    known = dict(zarr.open_group(path, mode="r+").arrays())
    return {name: array.with_config({"write_empty_chunks": True}) for name, array in known.items()}
