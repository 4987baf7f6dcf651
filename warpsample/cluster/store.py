"""A Zarr store of one run: its arrays, what repeats it, which of its chunks are whole, and who writes it."""

import json
import math
import os
import shutil
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
import zarr
from zarr.codecs import Crc32cCodec, ZstdCodec

from warpsample.cluster.arrays import dimensions, places_of
from warpsample.cluster.content import difference
from warpsample.cluster.job import STREAMS_OF, Job
from warpsample.host.arguments import told
from warpsample.host.files import WriteError
from warpsample.host.locks import making

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None  # type: ignore[assignment]

SUFFIX = ".zarr"

_ABSENT = {"f": float("nan"), "i": -2, "u": 255}  # what is read where no chunk is
_ITS_OWN = ("coordinates",)  # attributes that xarray reads


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


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Within, this process alone writes the store. The lock, a file beside it, goes with a process that is killed.

    Raises:
        WriteError: another process writes it, or it cannot be written at all.
    """
    file = path.with_name(f".{path.name}.lock")
    while True:  # again, if who had it removed it in between
        try:
            held = file.open("a")
        except OSError as error:
            raise WriteError(f"{path} cannot be written: {error.strerror}") from error
        if not _lock(held):
            held.close()
            raise WriteError(f"{path} cannot be written: another process is writing it")
        with suppress(FileNotFoundError):
            if file.stat().st_ino == os.fstat(held.fileno()).st_ino:
                break
        held.close()
    try:
        yield
    finally:
        file.unlink(missing_ok=True)
        held.close()


def _lock(file: Any) -> bool:
    """Whether no other process has locked the file, which this one does now."""
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # of file systems without locks
            pass
    return True


def begin(path: Path, job: Job, resume: bool, argument: str) -> np.ndarray:
    """Makes the store of a job without its chunks, or finds the one that it is to go on with.

    Returns:
        which chunks are there already, and whole.

    Raises:
        ValueError: there is one, and it is not to be resumed, or is of another run; names what differs. Or it is damaged, or
            would have too many chunks.
        WriteError: it cannot be made, or there is no room for it.
    """
    if path.exists() and not resume:
        raise ValueError(f"{argument}: got {str(path)!r}, which is there already, want a new name, or to resume it")
    if path.exists():
        check_same(path, job.about, argument)
        for part in path.rglob("*.partial"):  # of killed writers
            part.unlink(missing_ok=True)
        _check_arrays(path, job, argument)
        whole = whole_chunks(path, (*places_of(job), *job.gives), argument)
        _check_room(path, job, job.count - np.count_nonzero(whole))
        return whole
    _check_room(path, job, job.count)
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
    kinds = {**places_of(job), **job.gives}
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


def _check_room(path: Path, job: Job, chunks: int) -> None:
    """Refuses more chunks than there is room for, before they are compressed: positions hardly can be.

    Raises:
        WriteError: says how much they take, and how much is free.
    """
    kinds = {**places_of(job), **job.gives}.values()
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


def about_of(path: Path, argument: str) -> dict[str, Any]:
    """All that repeats the run of a store.

    Raises:
        ValueError: its metadata cannot be read.
    """
    kept = _opened(path, argument).attrs.asdict()
    return {name: value for name, value in kept.items() if name not in _ITS_OWN}


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


def _make(path: Path, job: Job) -> None:
    """The metadata, complete or absent."""
    places, part = places_of(job), _part(path)
    shutil.rmtree(part, ignore_errors=True)
    attributes = {**job.about, "coordinates": " ".join(name for name in places if name not in job.gives)}
    group = zarr.create_group(part, zarr_format=3, attributes=attributes)
    for name, (dtype, shape) in {**places, **job.gives}.items():
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
