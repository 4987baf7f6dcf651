"""Metadata files of a Zarr store: creation, and comparison with those of an existing store."""

import json
import warnings
from collections.abc import Mapping
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
_ABSENT = {"f": float("nan"), "i": -2, "u": 255}  # values of chunks that are not written, by kind of dtype
_COMPARED = (
    *("node_type", "zarr_format", "shape", "data_type", "chunk_grid", "chunk_key_encoding", "fill_value", "codecs"),
    *("dimension_names", "attributes"),
)
"""Metadata that determine how chunks are read; other entries may differ between versions of Zarr."""


def metadata_of(job: Job) -> dict[str, bytes]:
    """Return the contents of a store's metadata files, by path relative to the store."""
    coordinates, files = point_arrays_of(job), {}
    attributes = {**job.about, "coordinates": " ".join(name for name in coordinates if name not in job.gives)}
    group = zarr.create_group(MemoryStore(files), zarr_format=3, attributes=attributes)
    for name, kind in {**coordinates, **job.gives}.items():
        dtype, row = kind
        named = dimensions(name, 1 + len(row))
        add_array(group, name, dtype, (job.total, *row), (job.chunk, *row), dimension_names=named)
    return contents_of(group, files)


def contents_of(group: zarr.Group, files: dict[str, Any]) -> dict[str, bytes]:
    """Return the contents of all files of a store in memory, by path.

    The metadata are consolidated, and the group of records is added.
    """
    with making, warnings.catch_warnings():  # Zarr warns that its specification does not include consolidated metadata yet
        warnings.simplefilter("ignore")
        zarr.consolidate_metadata(group.store)
    group.create_group(RECORDS)  # created after the consolidation, because the group holds no arrays
    return {path: content.to_bytes() for path, content in files.items()}


def add_array(
    group: zarr.Group, name: str, dtype: np.dtype, shape: tuple[int, ...], chunks: tuple[int, ...], **about: Any
) -> Any:
    """Create an array with compressed chunks in a Zarr group; each chunk ends in a CRC-32C, which all readers check.

    Args:
        group: Group of a store.
        name: Name of the array.
        dtype: Type of the numbers.
        shape: Shape of the array.
        chunks: Shape of a chunk.
        **about: Attributes and names of dimensions, as for `zarr.Group.create_array`.
    """
    codecs = [ZstdCodec(level=1), Crc32cCodec()]
    absent = _ABSENT[dtype.kind]
    return group.create_array(name, shape=shape, chunks=chunks, dtype=dtype, fill_value=absent, compressors=codecs, **about)


def check_metadata(path: Path, files: Mapping[str, bytes], argument: str) -> None:
    """Raise an error if the metadata files of a store differ from the files that the run would create.

    The attributes of the run are not compared here, but by `check_same`.

    Args:
        path: Path of the store.
        files: Contents of the files that the run would create, by path relative to the store.
        argument: Name of the path's argument, for error messages.

    Raises:
        ValueError: if a metadata file differs or cannot be read; the message names the file.
    """
    wanted = {name: _read(content) for name, content in files.items() if name.endswith(_FILE)}
    names = [name.removesuffix(f"/{_FILE}") for name, content in wanted.items() if content["node_type"] == "array"]
    arrays_of(path, names, argument)  # raises an error for arrays that cannot be read
    for file, content in wanted.items():
        describe = _describe_flaw if file == _FILE else _describe_difference
        if flaw := describe(_read((path / file).read_bytes() if (path / file).is_file() else b""), content):
            raise _flawed(path, flaw, argument, file)


def check_readable(path: Path, argument: str) -> None:
    """Raise a ValueError if xarray cannot open a store."""
    if flaw := _find_read_error(path):
        raise _flawed(path, f"cannot be read: {flaw}", argument)


def _flawed(path: Path, flaw: str, argument: str, file: str = _FILE) -> ValueError:
    """Return the error for a flaw of a metadata file of a store."""
    return ValueError(f"{argument}: got {str(path)!r}, whose {file} {flaw}; compute the store again under a new name")


def _read(content: bytes) -> dict[str, Any]:
    """Parse the JSON object in a metadata file; return {} if the content is not an object."""
    try:
        found = json.loads(content)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _describe_difference(kept: Any, wanted: dict[str, Any]) -> str:
    """Describe the first difference between the metadata of two arrays, to end an error message; return "" if equal."""
    if not isinstance(kept, dict) or not kept:
        return "is damaged"
    other = (key for key in _COMPARED if kept.get(key, {}) != wanted.get(key, {}))
    return next((f"has another {key!r} than this run writes" for key in other), "")


def _describe_flaw(kept: dict[str, Any], wanted: dict[str, Any]) -> str:
    """Describe how a store's metadata differ from the expected metadata, to end an error message; return "" if equal."""
    attributes = "attributes", "coordinates"
    if kept[attributes[0]].get(attributes[1]) != wanted[attributes[0]][attributes[1]]:
        return f"has other {attributes[1]} than this run writes"
    if kept.get("consolidated_metadata") is None:
        return ""
    try:
        kept, wanted = (found["consolidated_metadata"]["metadata"] for found in (kept, wanted))
        if sorted(kept) != sorted(wanted):
            return "has other arrays than this run writes"
    except (TypeError, KeyError):
        return "is damaged"
    flaws = ((name, _describe_difference(kept[name], wanted[name])) for name in wanted)
    return next((f"{flaw} at {name!r}" for name, flaw in flaws if flaw), "")


def _find_read_error(path: Path) -> str:
    """Return the reason why xarray cannot open a store; "" if xarray can."""
    try:
        with making, warnings.catch_warnings():  # xarray warns if metadata are not consolidated
            warnings.simplefilter("ignore")
            xr.open_zarr(path)
    except Exception as error:  # damaged files raise errors of many types
        return " ".join(str(error).split()) or type(error).__name__
    return ""
