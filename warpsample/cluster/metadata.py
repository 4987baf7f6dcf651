"""The metadata of a store: what a run makes, in memory, and whether a store that is there has the same."""

import json
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
import zarr
from zarr.codecs import Crc32cCodec, ZstdCodec
from zarr.storage import MemoryStore

from warpsample.cluster.arrays import dimensions, point_arrays_of
from warpsample.cluster.holdings import RECORDS, arrays_of
from warpsample.cluster.job import Job
from warpsample.host.locks import making

_FILE = "zarr.json"
_ABSENT = {"f": float("nan"), "i": -2, "u": 255}  # what is read where no chunk is
_COMPARED = ("shape", "data_type", "chunk_grid", "chunk_key_encoding", "fill_value", "codecs", "dimension_names")
"""What tells how an array's chunks are read; other entries may differ from one version of Zarr to the next."""


def metadata_of(job: Job) -> dict[str, bytes]:
    """The contents of all files of a job's store, but for its chunks, by their paths within it."""
    coordinates, files = point_arrays_of(job), {}
    attributes = {**job.about, "coordinates": " ".join(name for name in coordinates if name not in job.gives)}
    group = zarr.create_group(MemoryStore(files), zarr_format=3, attributes=attributes)
    for name, kind in {**coordinates, **job.gives}.items():
        add_array(group, name, kind, job.total, job.chunk)
    return contents_of(group, files)


def contents_of(group: zarr.Group, files: dict[str, Any]) -> dict[str, bytes]:
    """The contents of all files of a store in memory, its metadata consolidated, with a place for the records."""
    with making, warnings.catch_warnings():  # that the format's text does not have them yet, though its readers do
        warnings.simplefilter("ignore")
        zarr.consolidate_metadata(group.store)
    group.create_group(RECORDS)  # so that readers who list the store find nothing strange; the metadata above are without
    return {path: content.to_bytes() for path, content in files.items()}


def add_array(group: zarr.Group, name: str, kind: tuple[np.dtype, tuple[int, ...]], rows: int, chunk: int) -> Any:
    """An array of a store, of so many rows of a (type, shape)."""
    dtype, shape = kind
    return group.create_array(
        name,
        shape=(rows, *shape),
        chunks=(chunk, *shape),
        dtype=dtype,
        fill_value=_ABSENT[dtype.kind],
        compressors=[ZstdCodec(level=1), Crc32cCodec()],  # for other readers: a chunk that is cut short does not read
        dimension_names=dimensions(name, 1 + len(shape)),
    )


def check_metadata(path: Path, job: Job, argument: str) -> None:
    """Refuses a store whose metadata are not those that its run makes, though its attributes are.

    Raises:
        ValueError: names the file.
    """
    kinds = {**point_arrays_of(job), **job.gives}
    arrays_of(path, kinds, argument)  # which says what cannot be read at all
    got = f"{argument}: got {str(path)!r}"
    wanted = {name: _read(content) for name, content in metadata_of(job).items()}
    for name in kinds:
        file = f"{name}/{_FILE}"
        if flaw := _difference(_read((path / file).read_bytes()), wanted[file]):
            raise ValueError(f"{got}, whose {file} {flaw}; bake it anew")
    if flaw := _flaw(_read((path / _FILE).read_bytes()), wanted[_FILE]):
        raise ValueError(f"{got}, whose {_FILE} {flaw}; bake it anew")
    if flaw := _unreadable(path):
        raise ValueError(f"{got}, whose {_FILE} cannot be read: {flaw}; bake it anew")


def _read(content: bytes) -> dict[str, Any]:
    try:
        found = json.loads(content)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _difference(kept: Any, wanted: dict[str, Any]) -> str:
    """What differs of an array's metadata, as a sentence says it; empty if nothing does."""
    if not isinstance(kept, dict):
        return "is damaged"
    return next((f"has another {key} than its run" for key in _COMPARED if kept.get(key) != wanted.get(key)), "")


def _flaw(kept: dict[str, Any], wanted: dict[str, Any]) -> str:
    """What differs of a store's own metadata, and of those of its arrays that it keeps with them, if it does."""
    attributes = "attributes", "coordinates"
    if kept[attributes[0]].get(attributes[1]) != wanted[attributes[0]][attributes[1]]:
        return f"has other {attributes[1]} than its run"
    if kept.get("consolidated_metadata") is None:
        return ""
    try:
        kept, wanted = (found["consolidated_metadata"]["metadata"] for found in (kept, wanted))
        if sorted(kept) != sorted(wanted):
            return "has other arrays than its run"
    except (TypeError, KeyError):
        return "is damaged"
    flaws = ((name, _difference(kept[name], wanted[name])) for name in wanted)
    return next((f"{flaw} at {name!r}" for name, flaw in flaws if flaw), "")


def _unreadable(path: Path) -> str:
    """Why xarray cannot read a store's metadata; empty if it can."""
    try:
        with making, warnings.catch_warnings():  # that none are consolidated, where xarray takes the arrays' own
            warnings.simplefilter("ignore")
            xr.open_zarr(path)
    except Exception as error:  # a file that holds anything fails in any way
        return " ".join(str(error).split()) or type(error).__name__
    return ""
