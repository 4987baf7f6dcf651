"""Computation of a raster's tiles by several processes, or into a Zarr store."""

from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, closing, nullcontext
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from uuid import uuid4

import numpy as np
from dask.array import Array
from dask.highlevelgraph import HighLevelGraph

from warpsample.city.rasters.tiles import RasterRun
from warpsample.cluster.clients import check_processes, computing
from warpsample.cluster.finishing import finished
from warpsample.cluster.holdings import about_of
from warpsample.cluster.lock import locked
from warpsample.cluster.raster_store import begin_raster, tiles_in, write_tile
from warpsample.cluster.sending import current_client
from warpsample.cluster.store import check_new, check_store
from warpsample.cluster.writing import at_work, store_of, writing
from warpsample.host.files import read_arrays, write_bytes
from warpsample.output.rasters.bake import RasterJob, Tiles, read_unchanging, summarize_tile
from warpsample.output.rasters.tile_files import ABOUT, DIGESTS, TileFiles, read_about, write_digests, write_tile_file
from warpsample.output.run_record import SUMMARY

WriteTile = Any
"""Function (folder, index of the tile, run, arrays of the tile) that writes a tile."""


class ProcessTiles(TileFiles):
    """Folder of tile files, which several processes compute and write."""

    def __init__(self, output: Path, resume: bool, processes: int) -> None:
        """Prepare the folder of tiles for an output file, for `processes` processes with one thread each."""
        check_processes(processes)
        super().__init__(output, resume)
        self.processes = processes

    def compute(self, job: RasterJob, digests: Mapping[str, np.ndarray], tiles: list[int]) -> Iterator[np.void]:
        """Compute and write tiles on the processes, and yield a SUMMARY for each in order of completion."""
        write_digests(self.path, digests)
        with computing(None, self.processes, None), closing(_compute(job, self.path, tiles, write_tile_file)) as found:
            yield from found


class ZarrTiles:
    """Zarr store with one chunk per tile of a raster; the store is the output.

    Attributes:
        path: Path of the store.
        resume: Whether to continue an existing store.
        processes: Number of local processes with one thread each. None: one tile after another, each with all threads.
    """

    def __init__(self, output: Path, resume: bool, processes: int | None) -> None:
        """Check the path and the number of processes."""
        check_processes(processes)
        self.path = check_store(output, "--output")
        self.resume, self.processes = resume, processes

    def locked(self) -> AbstractContextManager[None]:
        """Keep other processes from writing the store, within a `with` statement."""
        return locked(self.path)

    def begin(self, run: RasterRun, about: dict[str, Any]) -> np.ndarray:
        """Create the store, or check an existing one; return the mask of the complete tiles."""
        check_new(self.path, self.resume, "--output")
        return begin_raster(self.path, run, about, "--output")

    def compute(self, job: RasterJob, digests: Mapping[str, np.ndarray], tiles: list[int]) -> Iterator[np.void]:
        """Compute the given tiles, write each tile into the store, and yield a summary of each (dtype SUMMARY)."""
        with computing(None, self.processes, None) if self.processes else nullcontext(), writing(self.path) as folder:
            write_bytes(folder / ABOUT, (self.path / "zarr.json").read_bytes())
            write_digests(folder, digests)
            with closing(_compute(job, folder, tiles, write_tile)) as found:
                yield from found

    def tiles(self, run: RasterRun) -> Tiles:
        """Yield the row and column range and the arrays of each tile of the finished store."""
        return tiles_in(self.path, run)

    def about(self) -> dict[str, Any]:
        """Return the attributes of the store, which identify the run."""
        return about_of(self.path, "--output")

    def remove(self) -> None:
        """Do nothing: the store is the output and is not removed at the end of the run."""


def _compute(job: RasterJob, folder: Path, tiles: list[int], write: WriteTile) -> Iterator[np.void]:
    """Compute and write tiles on the Client's workers, or one by one in this process, and yield a SUMMARY for each tile."""
    if (client := current_client()) is not None:
        yield from finished(client, SimpleNamespace(shared={}), lambda some: _tasks(job, folder, some, write), tiles)
        return
    for index in tiles:
        yield bake_tile(job, str(folder), index, None, write)[0]


def _tasks(job: RasterJob, folder: Path, tiles: list[int], write: WriteTile) -> Array:
    """Build a Dask array whose blocks compute and write one tile each, and return SUMMARY records."""
    name = f"raster-{uuid4().hex}"
    tasks = {(name, number): (bake_tile, job, str(folder), index, 1, write) for number, index in enumerate(tiles)}
    return Array(HighLevelGraph.from_collections(name, tasks), name, ((1,) * len(tiles),), dtype=SUMMARY)


def bake_tile(job: RasterJob, folder: str, index: int, workers: int | None, write: WriteTile) -> np.ndarray:
    """Compute one tile, write it, and return its SUMMARY of shape (1,).

    Args:
        job: Computation to run.
        folder: Path of the folder with the attributes and digests of the run.
        index: Number of the tile, row by row.
        workers: Number of threads. None: all.
        write: Function that writes the tile.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    with at_work(Path(folder)):
        run, spans = _run_of(job, Path(folder), workers, write)
        arrays = run.numbers(spans[index])
        write(Path(folder), index, run, arrays)
    return np.array([summarize_tile(arrays)], SUMMARY)


@lru_cache(maxsize=1)
def _run_of(job: RasterJob, folder: Path, workers: int | None, write: WriteTile) -> tuple[RasterRun, list[Any]]:
    """Return this process's run object for a job and the spans of all tiles, cached so that the far field is computed once.

    The run raises an error if the rasters change after the call began.
    """
    kept = read_about(folder)
    store = store_of(folder) if write is write_tile else folder
    run = read_unchanging(job, kept.get("attributes", kept), store, read_arrays(folder / DIGESTS))
    run.options["workers"] = workers
    return run, list(run.spans())
