"""A Zarr store of a raster's numbers: chunks are tiles, and coordinates and the CRS are those of the raster."""

import json
from collections.abc import Iterator, Mapping
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np
import zarr
from zarr.codecs import Crc32cCodec, ZstdCodec
from zarr.storage import MemoryStore

from warpsample.city.rasters.calls import attributes_of
from warpsample.city.rasters.raster_surface import on_map
from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.cluster.holdings import arrays_of, whole_chunks
from warpsample.cluster.metadata import contents_of
from warpsample.cluster.store import check_same, make_store
from warpsample.cluster.writing import put_encoded
from warpsample.host.engine import check_space

_MAP = "spatial_ref"


def begin_raster(path: Path, run: RasterRun, about: Mapping[str, Any], argument: str) -> np.ndarray:
    """Makes the store of a run without its tiles, or finds the one that it is to go on with.

    Returns:
        (tiles,) bool, which are there already, and whole.

    Raises:
        ValueError: there is one of another run; names what differs. Or it is damaged.
        WriteError: it cannot be made, or there is no space for it.
    """
    cells = run.reader.shape[0] * run.reader.shape[1]
    whole = np.zeros(run.grid[0] * run.grid[1], np.bool_)
    if path.exists():
        check_same(path, dict(about), argument)
        for name, array in arrays_of(path, run.names, argument).items():
            if (array.shape, array.chunks) != (run.reader.shape, run.sides):
                raise ValueError(f"{argument}: got {str(path)!r}, whose array {name!r} is of another shape; bake it anew")
        whole = whole_chunks(path, run.names, argument)
    check_space(path, int(cells * (1.0 - whole.mean())) * 4 * len(run.names), f"{cells:,} cells")
    if not path.exists():
        make_store(path, partial(_metadata, run, about))
    return whole


def put_tile(folder: Path, index: int, run: RasterRun, arrays: Mapping[str, np.ndarray]) -> None:
    """Writes a tile of each array, and last a record of them.

    Args:
        folder: of the call that writes the store.
        index: of the tile, row by row.
        run: what it is of.
        arrays: (rows, columns) float32, by name.

    Raises:
        WriteError: it cannot be written, or the call has ended.
    """
    row, column = divmod(index, run.grid[1])
    files = {}
    for name, tile in arrays.items():
        encoder, encoded = _encoder(folder, name, run.sides)
        encoder[: tile.shape[0], : tile.shape[1]] = tile
        files[name] = f"{name}/c/{row}/{column}", encoded.pop(f"{name}/c/0/0").to_bytes()
    put_encoded(folder, index, files)


def tiles_in(path: Path, run: RasterRun) -> Iterator[tuple[Span, dict[str, np.ndarray]]]:
    """The tiles of a finished store."""
    arrays = arrays_of(path, run.names, "store")
    return ((span, {name: array[span] for name, array in arrays.items()}) for span in run.spans())


@lru_cache(maxsize=16)
def _encoder(_: Path, name: str, sides: tuple[int, int]) -> tuple[Any, dict[str, Any]]:
    """An array in memory of one tile, and where it puts that when it is encoded."""
    encoded: dict[str, Any] = {}
    array = _add(zarr.create_group(MemoryStore(encoded)), name, sides, sides)
    return array.with_config({"write_empty_chunks": True}), encoded


def _metadata(run: RasterRun, about: Mapping[str, Any]) -> dict[str, bytes]:
    """The contents of all files of a store, but for its tiles, by their paths within it."""
    files: dict[str, Any] = {}
    outline = run.reader.outline
    laid = on_map(outline, outline.height)
    places = {name: np.asarray(values) for name, values in laid.coords.items() if name != _MAP}
    attributes = {**about, "coordinates": " ".join([*places, _MAP])}
    group = zarr.create_group(MemoryStore(files), zarr_format=3, attributes=json.loads(json.dumps(attributes)))
    for name in run.names:
        own = {**attributes_of(name, run.quantity), "grid_mapping": _MAP}
        _add(group, name, run.reader.shape, run.sides, attributes=own, dimension_names=outline.dims)
    for name, values in places.items():
        array = group.create_array(name, shape=values.shape, dtype=values.dtype, dimension_names=(name,), compressors=None)
        array[:] = values
    mapping = {key: value.item() if hasattr(value, "item") else value for key, value in laid[_MAP].attrs.items()}
    group.create_array(_MAP, shape=(), dtype=np.int64, attributes=mapping, compressors=None)[...] = 0
    return contents_of(group, files)


def _add(group: zarr.Group, name: str, shape: tuple[int, int], sides: tuple[int, int], **about: Any) -> Any:
    """An array whose chunks are tiles."""
    return group.create_array(
        name,
        shape=shape,
        chunks=sides,
        dtype=np.float32,
        fill_value=np.nan,
        compressors=[ZstdCodec(level=1), Crc32cCodec()],
        **about,
    )
