"""`warpsample bake` of a raster: compute tile by tile into a store that can be resumed, and from there a GeoTIFF."""

import shutil
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing, contextmanager, nullcontext
from dataclasses import dataclass
from functools import lru_cache, partial
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from types import SimpleNamespace
from typing import Any
from uuid import uuid4

import numpy as np
from dask.array import Array
from dask.highlevelgraph import HighLevelGraph

from warpsample.city.rasters.calls import run_of
from warpsample.city.rasters.cog import check_sidecars, write_cog
from warpsample.city.rasters.content import digests_of, place_of, unchanging
from warpsample.city.rasters.reading import files_read
from warpsample.city.rasters.tiles import RasterRun
from warpsample.cluster.baking import DONE
from warpsample.cluster.clients import computing
from warpsample.cluster.finishing import finished
from warpsample.cluster.holdings import about_of
from warpsample.cluster.job import STREAMS_OF, VERSIONS
from warpsample.cluster.lock import locked
from warpsample.cluster.raster_store import begin_raster, put_tile, tiles_in
from warpsample.cluster.sending import current_client
from warpsample.cluster.store import SUFFIX, check_new, check_store
from warpsample.cluster.writing import at_work, store_of, writing
from warpsample.host.arguments import check_integer, told
from warpsample.host.files import WriteError, check_output, complete_or_absent, read_arrays, write_arrays
from warpsample.host.interrupts import uninterrupted
from warpsample.host.known import digest_of
from warpsample.output.quantities import quantity_of
from warpsample.output.terminal_bar import terminal_bar
from warpsample.radiation.weather.weather import read_weather
from warpsample.sequences.record import STREAMS

_DIGESTS = "digests.npz"
"""File in the folder of a writing call with the digests of the input rasters' blocks."""

_COG = "cog"
"""Folder in a temporary store in which the GeoTIFF is created; removed with the store."""

_MAKING = "making"
"""Attribute of a temporary store: name of the GeoTIFF that is created from the store."""


@dataclass(frozen=True)
class RasterJob:
    """A raster computation on files; each process reads the files itself.

    Attributes:
        source: Path of the raster of heights.
        quantity: Name of the quantity on the command line.
        model: Surface model, as for `rasters`.
        receiver: Receiver, as for `rasters`.
        options: Further arguments of the call of `rasters`, sorted (name, value).
    """

    source: str
    quantity: str
    model: str
    receiver: str
    options: tuple[tuple[str, Any], ...]

    @property
    def files(self) -> list[Path]:
        """Paths of all input files: rasters and weather."""
        rasters = [self.source, *(value for name, value in self.options if name in ("canopy", "trunk", "far"))]
        weather = [Path(value) for name, value in self.options if name == "weather"]
        return [file for path in rasters if isinstance(path, str) for file in files_read(path)] + weather

    def run(self) -> tuple[RasterRun, dict[str, Any]]:
        """Return the checked run, and the attributes that identify the run without the heights, which are not read yet."""
        how = {"model": self.model, "receiver": self.receiver}
        run, about = run_of(quantity_of(self.quantity), self.source, dict(self.options), **how)
        about.pop("workers", None)
        for name, raster in run.rasters.items():
            about |= {f"{name}_{what}": told for what, told in place_of(raster).items()}
        if "weather" in run.options:
            weather = run.options["weather"] = read_weather(run.options["weather"])
            about["weather_content"] = weather.digest
        return run, about | {STREAMS_OF: STREAMS, **{name: version(name) for name in VERSIONS}}


def bake_raster(job: RasterJob, output: Path, processes: int | None, resume: bool) -> str:
    """Compute a quantity on a raster into a .zarr store, or through a temporary store into a GeoTIFF.

    Args:
        job: Computation to run.
        output: Path ending in .zarr, .tif or .tiff. A GeoTIFF has a hidden store next to it until the GeoTIFF is complete.
        processes: Number of local processes with one thread each. None: one tile after another, each with all threads.
        resume: Whether to continue an existing store.

    Returns:
        a report for the terminal, in lines.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, before anything is computed; or an
            input file that has changed since the run began.
        KeyboardInterrupt: the run is interrupted; the message states how many tiles are done.
        OSError: the output cannot be written, or another process is writing it.
    """
    if processes is not None:
        check_integer(processes, "--processes", 1, 1024)
    is_store = output.suffix == SUFFIX
    if not is_store:
        check_output(output, "--output", *job.files)
        check_sidecars(output, "--output")
    store = check_store(output if is_store else output.with_name(f".{output.name}.making{SUFFIX}"), "--output")
    run, about = job.run()
    run.check()
    start = perf_counter()
    with locked(store):
        check_new(store, resume, "--output")
        digests = {name: digests_of(raster) for name, raster in run.rasters.items()}
        about |= _heights(digests)
        whole = begin_raster(store, run, about if is_store else about | {_MAKING: output.name}, "--output")
        with _counting(run.quantity.title, store, whole) as heard:
            with computing(None, processes, None) if processes else nullcontext():
                _compute(job, store, np.flatnonzero(~whole).tolist(), digests, heard)
            _check_unchanged(store, job)
            removed: list[Path] = []
            if not is_store:
                removed = write_cog(output, run, about, partial(tiles_in, store, run), store / _COG)
                uninterrupted(partial(shutil.rmtree, store))
    rows, columns = run.reader.shape
    total, there = len(whole), int(whole.sum())
    lines = [
        f"{output}: {run.quantity.title} of {rows:,} x {columns:,} cells in {total:,} {'tile' if total == 1 else 'tiles'}"
    ]
    lines += [f"{there:,} of them were there already"] if there else []
    names = ", ".join(file.name for file in removed)
    lines += [f"removed {names}: overviews, masks or statistics of the file that was replaced"] if removed else []
    return "\n  ".join([*lines, f"took {perf_counter() - start:.2f} s"])


@contextmanager
def _counting(title: str, store: Path, whole: np.ndarray) -> Iterator[Callable[[int], None]]:
    """Show a progress bar of tiles for the body of a `with` statement, and yield a function that counts more tiles as done.

    Errors that interrupt the body get a note that the store can be resumed.
    """
    done, total = int(whole.sum()), len(whole)
    with terminal_bar() as bar:
        task = bar.add_task(title, total=total, told="")

        def heard(more: int) -> None:
            nonlocal done
            done += more
            bar.update(task, completed=done, told=f"{done} of {total} tiles")

        heard(0)
        try:
            yield heard
        except KeyboardInterrupt as interrupt:  # the same exception is raised again: it may represent another signal
            interrupt.args = (f"interrupted after {done:,} of {total:,} tiles; {store} can be resumed",)
            raise
        except WriteError as error:
            raise WriteError(f"{error}; {store} can be resumed") from error


def _compute(
    job: RasterJob, store: Path, tiles: list[int], digests: Mapping[str, np.ndarray], heard: Callable[[int], None]
) -> None:
    """Compute and write tiles of a store, and call `heard` with 1 for each."""
    with writing(store) as folder:
        with complete_or_absent(folder / _DIGESTS) as stream:
            write_arrays(stream, digests)
        with closing(_told(job, folder, tiles)) as all_told:
            for _ in all_told:
                heard(1)


def _heights(digests: Mapping[str, np.ndarray]) -> dict[str, str]:
    """Return the digests of whole rasters as attributes of the store, from the digests of their blocks."""
    return {f"{name}_heights": digest_of(found) for name, found in digests.items()}


def _check_unchanged(store: Path, job: RasterJob, digests: Mapping[str, np.ndarray] | None = None) -> RasterRun:
    """Return a job's run, after a check that its input files are the same as when the store's run began.

    Args:
        store: Path of the store.
        job: Computation of the store.
        digests: Digests of the blocks of each raster when the run began, by name. Default: None, read the rasters again.

    Raises:
        ValueError: if an input file has changed; the message names the input.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # warnings about the rasters were shown before the first tile
        run, about = job.run()
    about |= _heights(digests or {name: digests_of(raster) for name, raster in run.rasters.items()})
    kept = about_of(store, "--output")
    for name, now in about.items():
        if kept.get(name) != now:
            raise ValueError(
                f"{name.rpartition('_')[0] or name}: got {name} {told(now)}, which was {told(kept.get(name))} when the run "
                f"began; with what it was {store} can be resumed"
            )
    return run


def _told(job: RasterJob, folder: Path, tiles: list[int]) -> Iterator[Any]:
    """Compute tiles, and yield once for each: on the current Client's workers, or one after another in this process."""
    if (client := current_client()) is not None:
        yield from finished(client, SimpleNamespace(shared={}), lambda some: _tasks(job, folder, some), tiles)
        return
    for index in tiles:
        yield bake_tile(job, str(folder), index, None)


def _tasks(job: RasterJob, folder: Path, tiles: list[int]) -> Array:
    """Build a Dask array whose blocks compute and write the tiles."""
    name = f"raster-{uuid4().hex}"
    tasks = {(name, number): (bake_tile, job, str(folder), index, 1) for number, index in enumerate(tiles)}
    return Array(HighLevelGraph.from_collections(name, tasks), name, ((1,) * len(tiles),), dtype=DONE)


def bake_tile(job: RasterJob, folder: str, index: int, workers: int | None) -> np.ndarray:
    """Compute one tile and write it into the store.

    Args:
        job: Computation to run.
        folder: Path of the writing call's folder.
        index: Number of the tile, row by row.
        workers: Number of threads. None: all.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    with at_work(Path(folder)):
        run, span = _run_of(job, Path(folder), workers)
        put_tile(Path(folder), index, run, run.numbers(span[index]))
    return np.zeros(1, DONE)


@lru_cache(maxsize=1)
def _run_of(job: RasterJob, folder: Path, workers: int | None) -> tuple[RasterRun, list[Any]]:
    """Return (run, spans of the tiles) of a call in this process; cached, so that the far field is computed once.

    The run raises an error if the rasters change after the call began.
    """
    digests = read_arrays(folder / _DIGESTS)
    run = _check_unchanged(store_of(folder), job, digests)
    run = run.reading({name: unchanging(raster, digests[name], name) for name, raster in run.rasters.items()})
    run.options["workers"] = workers
    return run, list(run.spans())
