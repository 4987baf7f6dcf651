"""`warpsample bake` of a raster: tile by tile into a store that resumes, and from there into a GeoTIFF."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import closing, nullcontext
from dataclasses import dataclass
from functools import lru_cache
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
from warpsample.city.rasters.cog import write_cog
from warpsample.city.rasters.tiles import RasterRun
from warpsample.cluster.baking import DONE
from warpsample.cluster.clients import computing
from warpsample.cluster.finishing import finished
from warpsample.cluster.job import STREAMS_OF, VERSIONS
from warpsample.cluster.lock import locked
from warpsample.cluster.raster_store import begin_raster, put_tile, tiles_in
from warpsample.cluster.sending import current_client
from warpsample.cluster.store import SUFFIX, check_store
from warpsample.cluster.writing import at_work, writing
from warpsample.host.arguments import check_integer
from warpsample.host.files import check_output
from warpsample.output.quantities import quantity_of
from warpsample.output.terminal_bar import terminal_bar
from warpsample.sequences.record import STREAMS


@dataclass(frozen=True)
class RasterJob:
    """A call on files, which each process reads for itself.

    Attributes:
        source: the path of the heights.
        quantity: its name on the command line.
        model, receiver: see `surface`.
        options: further arguments of the call of `rasters`, sorted (name, value).
    """

    source: str
    quantity: str
    model: str
    receiver: str
    options: tuple[tuple[str, Any], ...]

    def run(self) -> tuple[RasterRun, dict[str, Any]]:
        """The checked run, and what tells it from others: its arguments, and how large and how old its files are."""
        how = {"model": self.model, "receiver": self.receiver}
        run, about = run_of(quantity_of(self.quantity), self.source, dict(self.options), **how)
        given = {
            "source": self.source,
            **{name: value for name, value in self.options if name in ("canopy", "trunk", "far")},
        }
        for name, path in given.items():
            if isinstance(path, str) and Path(path).is_file():
                found = Path(path).stat()
                about[f"{name}_file"] = f"{found.st_size} bytes of {found.st_mtime_ns} ns"
        about.pop("workers", None)
        return run, about | {STREAMS_OF: STREAMS, **_versions()}


def bake_raster(job: RasterJob, output: Path, processes: int | None, resume: bool) -> str:
    """Computes a raster's numbers into a .zarr store, or by one into a GeoTIFF.

    Args:
        job: what to compute.
        output: of a name that ends in .zarr, .tif or .tiff. Beside a GeoTIFF is a store until it is complete.
        processes: of this machine, a thread each; by default the tiles are computed one by one, by all threads.
        resume: whether to go on with the store, if there is one.

    Returns:
        a report in sentences.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; before anything is computed.
        KeyboardInterrupt: with a sentence that says how far it was.
        OSError: it cannot be written, or another process is writing it.
    """
    if processes is not None:
        check_integer(processes, "--processes", 1, 1024)
    is_store = output.suffix == SUFFIX
    if not is_store:
        check_output(output, "--output", Path(job.source))
    store = check_store(output if is_store else output.with_name(f"{output.name}{SUFFIX}"), "--output")
    run, about = job.run()
    start = perf_counter()
    with locked(store):
        total = run.grid[0] * run.grid[1]
        with terminal_bar() as bar, computing(None, processes, None) if processes else nullcontext():
            task = bar.add_task(run.quantity.title, total=total, told="")
            there = _compute(
                job, store, resume, lambda done: bar.update(task, completed=done, told=f"{done} of {total} tiles")
            )
        if not is_store:
            write_cog(output, run, about, tiles_in(store, run))
            shutil.rmtree(store)
    rows, columns = run.reader.shape
    lines = [
        f"{output}: {run.quantity.title} of {rows:,} x {columns:,} cells in {total:,} {'tile' if total == 1 else 'tiles'}"
    ]
    lines += [f"{there:,} of them were there already"] if there else []
    return "\n  ".join([*lines, f"took {perf_counter() - start:.2f} s"])


def _compute(job: RasterJob, store: Path, resume: bool, heard: Callable[[int], None]) -> int:
    """Computes what is missing of a store; how many tiles were there."""
    run, about = job.run()
    whole = begin_raster(store, run, about, resume, "--output")
    there = done = int(whole.sum())
    heard(done)
    try:
        with writing(store) as folder, closing(_told(job, folder, np.flatnonzero(~whole).tolist())) as all_told:
            for _ in all_told:
                done += 1
                heard(done)
    except KeyboardInterrupt as interrupt:  # raised again itself: it may stand for another signal
        interrupt.args = (f"interrupted after {done:,} of {len(whole):,} tiles; {store} can be resumed",)
        raise
    return there


def _told(job: RasterJob, folder: Path, tiles: list[int]) -> Iterator[Any]:
    """Something for each tile that is computed: by the Client that is there, or one by one."""
    if (client := current_client()) is not None:
        yield from finished(client, SimpleNamespace(shared={}), lambda some: _tasks(job, folder, some), tiles)
        return
    for index in tiles:
        yield bake_tile(job, str(folder), index, None)


def _tasks(job: RasterJob, folder: Path, tiles: list[int]) -> Array:
    """The DONEs of these tiles, lazily."""
    name = f"raster-{uuid4().hex}"
    tasks = {(name, number): (bake_tile, job, str(folder), index, 1) for number, index in enumerate(tiles)}
    return Array(HighLevelGraph.from_collections(name, tasks), name, ((1,) * len(tiles),), dtype=DONE)


def bake_tile(job: RasterJob, folder: str, index: int, workers: int | None) -> np.ndarray:
    """One task: computes a tile and writes it, unless the call that has the folder ends before."""
    run, span = _run_of(job, workers)
    with at_work(Path(folder)):
        put_tile(Path(folder), index, run, run.numbers(span[index]))
    return np.zeros(1, DONE)


@lru_cache(maxsize=1)
def _run_of(job: RasterJob, workers: int | None) -> tuple[RasterRun, list[Any]]:
    """The run of a job in this process, whose far field is read once."""
    run, _ = job.run()
    run.options["workers"] = workers
    return run, list(run.spans())


def _versions() -> dict[str, str]:
    return {name: version(name) for name in VERSIONS}
