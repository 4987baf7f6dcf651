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
from warpsample.estimate.estimating import collect_missed_tolerances
from warpsample.host.files import read_arrays, write_bytes
from warpsample.output.rasters.bake import Tiles, summarize_tile
from warpsample.output.rasters.job import RasterJob, read_unchanging
from warpsample.output.rasters.tile_files import ABOUT, DIGESTS, TileFiles, read_about, write_digests, write_tile_file
from warpsample.output.run_record import SUMMARY

WriteTile = Any
"""Function (folder, index of the tile, run, arrays of the tile) that writes a tile."""


class ProcessTiles(TileFiles):
    """Storage of raster tiles as files in a folder, computed by several processes."""

    def __init__(self, output: Path, resume: bool, processes: int) -> None:
        """Set the output file, next to which the folder of tiles is created, and the number of processes."""
        check_processes(processes)
        super().__init__(output, resume)
        self.processes = processes

    def compute(self, job: RasterJob, digests: Mapping[str, np.ndarray], tiles: list[int]) -> Iterator[np.void]:
        """Compute and write tiles in several processes; yield counts and sums of each tile as soon as it is complete."""
        write_digests(self.path, digests)
        with computing(None, self.processes, None), closing(_compute(job, self.path, tiles, write_tile_file)) as found:
            yield from found


class ZarrTiles:
    """Storage of raster tiles as chunks of the Zarr store that is the output.

    Attributes:
        path: Path of the store.
        resume: Whether to continue an existing store.
        processes: Number of local processes with one thread each. None: one tile after another, each with all threads.
    """

    def __init__(self, output: Path, resume: bool, processes: int | None) -> None:
        """Check the path of the store and the number of processes, and set both."""
        check_processes(processes)
        self.path: Path = check_store(output, "--output")
        self.resume, self.processes = resume, processes

    def locked(self) -> AbstractContextManager[None]:
        """Keep other processes from writing the store, within a `with` statement."""
        return locked(self.path)

    def begin(self, run: RasterRun, about: dict[str, Any]) -> np.ndarray:
        """Create the store, or check that an existing one can be resumed; return the mask of complete tiles."""
        check_new(self.path, self.resume, "--output")
        return begin_raster(self.path, run, about, "--output")

    def compute(self, job: RasterJob, digests: Mapping[str, np.ndarray], tiles: list[int]) -> Iterator[np.void]:
        """Compute the given tiles, write each into the store, and yield counts and sums of its values."""
        with computing(None, self.processes, None) if self.processes else nullcontext(), writing(self.path) as folder:
            write_bytes(folder / ABOUT, (self.path / "zarr.json").read_bytes())
            write_digests(folder, digests)
            with closing(_compute(job, folder, tiles, write_tile)) as found:
                yield from found

    def tiles(self, run: RasterRun) -> Tiles:
        """Yield the range of rows and columns and the arrays of each tile in the finished store."""
        return tiles_in(self.path, run)

    def about(self) -> dict[str, Any]:
        """Return the attributes of the store, which identify the run."""
        return about_of(self.path, "--output")

    def remove(self) -> None:
        """Do nothing: the store is the output and is not removed at the end of the run."""


def _compute(job: RasterJob, folder: Path, tiles: list[int], write: WriteTile) -> Iterator[np.void]:
    """Compute and write tiles on a Dask Client's workers or in this process; yield counts and sums of each tile."""
    if (client := current_client()) is not None:
        yield from finished(client, SimpleNamespace(shared={}), lambda some: _tasks(job, folder, some, write), tiles)
        return
    for index in tiles:
        yield bake_tile(job, str(folder), index, None, write)[0]


def _tasks(job: RasterJob, folder: Path, tiles: list[int], write: WriteTile) -> Array:
    """Build the Dask tasks that compute and write one tile each, as an array of summaries."""
    name = f"raster-{uuid4().hex}"
    tasks = {(name, number): (bake_tile, job, str(folder), index, 1, write) for number, index in enumerate(tiles)}
    return Array(HighLevelGraph.from_collections(name, tasks), name, ((1,) * len(tiles),), dtype=SUMMARY)


def bake_tile(job: RasterJob, folder: str, index: int, workers: int | None, write: WriteTile) -> np.ndarray:
    """Compute one raster tile and write it to the folder or store; return counts and sums of its values.

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
        with collect_missed_tolerances() as missed:
            arrays = run.numbers(spans[index])
        write(Path(folder), index, run, arrays)
    summary = summarize_tile(arrays)
    summary["missed"] = max(missed, default="")
    return np.array([summary], SUMMARY)


@lru_cache(maxsize=1)
def _run_of(job: RasterJob, folder: Path, workers: int | None, write: WriteTile) -> tuple[RasterRun, list[Any]]:
    """Return the computation of a raster job and the ranges of its tiles; cached, as preparing distant terrain is slow.

    The run raises an error if the rasters change after the call began.
    """
    kept = read_about(folder)
    store = store_of(folder) if write is write_tile else folder
    run = read_unchanging(job, kept.get("attributes", kept), store, read_arrays(folder / DIGESTS))
    run.options["workers"] = workers
    return run, list(run.spans())
