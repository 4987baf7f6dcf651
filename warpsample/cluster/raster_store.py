"""Zarr store of a quantity on a raster: one chunk per tile, with the raster's coordinates and reference system."""

import json
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import zarr
from zarr.storage import MemoryStore

from warpsample.city.rasters.datasets import attributes_of
from warpsample.city.rasters.raster_surface import on_map
from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.cluster.holdings import arrays_of, whole_chunks
from warpsample.cluster.metadata import add_array, check_metadata, check_readable, contents_of
from warpsample.cluster.store import check_same, make_store
from warpsample.cluster.writing import write_chunk
from warpsample.host.engine import check_space
from warpsample.host.files import write_bytes

_MAP = "spatial_ref"
_KIND = np.dtype(np.float32)


def begin_raster(path: Path, run: RasterRun, about: Mapping[str, Any], argument: str) -> np.ndarray:
    """Create the empty Zarr store of a raster run, or check that an existing store can be resumed.

    Args:
        path: Path of the store.
        run: Checked run.
        about: Attributes that identify the run.
        argument: Name of the path's argument, for error messages.

    Returns:
        (tiles,) bool mask of the tiles that are complete already.

    Raises:
        ValueError: if an existing store is of another run, with the difference in the message; or is damaged.
        WriteError: if the store cannot be written, or the disk has too little space.
    """
    cells = run.reader.shape[0] * run.reader.shape[1]
    whole = np.zeros(run.grid[0] * run.grid[1], np.bool_)
    if path.exists():
        check_same(path, dict(about), argument)
        files = _metadata(run, about)
        check_metadata(path, files, argument)
        _mend_coordinates(path, files)
        check_readable(path, argument)
        whole = whole_chunks(path, run.names, argument)
    check_space(path, int(cells * (1.0 - whole.mean())) * _KIND.itemsize * len(run.names), f"{cells:,} cells")
    if not path.exists():
        make_store(path, partial(_metadata, run, about))
    return whole


def write_tile(folder: Path, index: int, run: RasterRun, arrays: Mapping[str, np.ndarray]) -> None:
    """Write one tile of every array into the store, then a record of the tile's checksums.

    Args:
        folder: Folder of the writing call.
        index: Number of the tile, row by row.
        run: Run of the store.
        arrays: (rows, columns) float32 arrays, by name.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    write_chunk(folder, index, divmod(index, run.grid[1]), run.sides, arrays)


def tiles_in(path: Path, run: RasterRun) -> Iterator[tuple[Span, dict[str, np.ndarray]]]:
    """Return an iterator over the tiles of a finished store, as (span, arrays by name)."""
    arrays = arrays_of(path, run.names, "store")
    return ((span, {name: array[span] for name, array in arrays.items()}) for span in run.spans())


def _mend_coordinates(path: Path, files: Mapping[str, bytes]) -> None:
    """Write the coordinates of a store again where they are missing or damaged; `files` are those of a new store."""
    for name, content in files.items():
        file = path / name
        if not name.endswith("zarr.json") and not (file.is_file() and file.read_bytes() == content):
            file.parent.mkdir(parents=True, exist_ok=True)
            write_bytes(file, content)


def _metadata(run: RasterRun, about: Mapping[str, Any]) -> dict[str, bytes]:
    """Return the contents of a store's metadata and coordinate files, by path relative to the store."""
    files: dict[str, Any] = {}
    outline = run.reader.outline
    laid = on_map(outline, outline.height)
    places = {name: np.asarray(values) for name, values in laid.coords.items() if name != _MAP}
    attributes = {**about, "coordinates": " ".join([*places, _MAP])}
    group = zarr.create_group(MemoryStore(files), zarr_format=3, attributes=json.loads(json.dumps(attributes)))
    for name in run.names:
        own = {**attributes_of(name, run.quantity), "grid_mapping": _MAP}
        add_array(group, name, _KIND, run.reader.shape, run.sides, attributes=own, dimension_names=outline.dims)
    for name, values in places.items():
        array = group.create_array(name, shape=values.shape, dtype=values.dtype, dimension_names=(name,), compressors=None)
        array[:] = values
    mapping = {key: value.item() if hasattr(value, "item") else value for key, value in laid[_MAP].attrs.items()}
    group.create_array(_MAP, shape=(), dtype=np.int64, attributes=mapping, compressors=None)[...] = 0
    return contents_of(group, files)
