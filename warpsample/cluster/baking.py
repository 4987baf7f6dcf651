"""`bake`: a call's chunks into a store, each by one task, and those that are there already left alone."""

from collections.abc import Callable
from itertools import compress
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
import xarray as xr
from dask.array import Array
from dask.callbacks import Callback
from dask.highlevelgraph import HighLevelGraph

from warpsample.cluster.arrays import PLACES, blocks_of, current_client, shared_by_key, starts_of
from warpsample.cluster.chunks import FUNCTIONS, Call, numbers, points_in
from warpsample.cluster.job import CHUNK, Job, job_of
from warpsample.cluster.store import begin, check_store, locked, put, whole_chunks
from warpsample.host.arguments import check_choice, check_flag

DONE = np.dtype([("points", np.int64), ("rays", np.int64), ("squared_error", np.float64)])
"""What a task tells of its chunk: how many points, rays cast, and the sum of the squares of their standard errors."""


def bake(path: Any, call: str, *arguments: Any, chunk: int = CHUNK, resume: bool = False, **options: Any) -> xr.Dataset:
    """Computes a call into a Zarr store, chunk by chunk; what is interrupted goes on where it was.

    By the Client that is there, else by Dask's threads or the scheduler that is configured. A chunk is written once, whole,
    with a checksum, by the worker that has computed it: all workers must reach the path. Little comes back here.

    Args:
        path: of a folder that ends in .zarr.
        call: "ambient_occlusion" or another of this room.
        arguments: as the call takes them.
        chunk: points of a task, and of the store's files.
        resume: whether to go on with a store of the same arguments, if there is one.
        options: as the call takes them, by name.

    Returns:
        what is in the store, lazily, as `xarray.open_zarr` has it.

    Raises:
        TypeError, ValueError: an argument that cannot be used; or a store of another run, and what differs.
        OSError: it cannot be written, or another process is writing it; or the scheduler is gone.
    """
    mesh = options.pop("mesh", None) if call == "sample_directions" else None
    job = job_of(check_choice(call, "call", tuple(FUNCTIONS)), arguments, options, chunk, mesh)
    store = check_store(path, "path")
    bake_job(job, store, check_flag(resume, "resume"), "path", lambda _: None)
    return xr.open_zarr(store)


def bake_job(job: Job, store: Path, resume: bool, argument: str, heard: Callable[[np.void], None]) -> None:
    """Makes the store, or finds it, and computes what is missing.

    Args:
        job: what to compute.
        store: a checked path.
        resume: whether there may be a store already.
        argument: what messages call the path.
        heard: is told a DONE: first of all chunks that are there already, then of each as it is written.

    Raises:
        KeyboardInterrupt: with a sentence that says how far it was.
        ValueError, OSError: as `bake`.
    """
    total, points = sum(job.chunks), 0

    def count(told: np.void) -> None:
        nonlocal points
        points += int(told["points"])
        heard(told)

    with locked(store):
        begin(store, job, resume, argument)
        try:
            whole = whole_chunks(store)
            count(np.array((sum(compress(job.chunks, whole)), 0, 0.0), DONE)[()])
            _run(job, store, [i for i, there in enumerate(whole) if not there], count)
        except KeyboardInterrupt as interrupt:  # raised again itself: it may stand for another signal
            interrupt.args = (f"interrupted after {points:,} of {total:,} points; {store} can be resumed",)
            raise
        except ConnectionError as error:
            raise ConnectionError(f"{error} after {points:,} of {total:,} points; {store} can be resumed") from error


def _run(job: Job, store: Path, chunks: list[int], heard: Callable[[np.void], None]) -> None:
    """Bakes these chunks, a task each."""
    if not chunks:
        return
    name = f"bake-{job.call.name}-{uuid4().hex}"  # no run's tasks are another's, who writes elsewhere
    tasks, shared = shared_by_key(job)
    blocks, starts = blocks_of(job), starts_of(job)
    for place, i in enumerate(chunks):
        given, rows = [blocks[key][i] for key in job.given], [blocks[key][i] for key in job.rows]
        tasks[name, place] = (bake_chunk, job.call, str(store), starts[i], job.chunks[i], shared, given, rows)
    graph = HighLevelGraph.from_collections(name, tasks, dependencies=[*job.given.values(), *job.rows.values()])
    told = Array(graph, name, ((1,) * len(chunks),), dtype=DONE)
    client = current_client()
    if client is not None:
        _by_client(client, told, heard)
        return
    with Callback(posttask=lambda key, result, *_: heard(result[0]) if key[0] == name else None):
        told.compute(optimize_graph=False)  # which would rename the tasks


def _by_client(client: Any, told: Array, heard: Callable[[np.void], None]) -> None:
    """The chunks as the workers of a Client finish them.

    Raises:
        ConnectionError: the scheduler is gone, or a chunk ended several workers.
    """
    from distributed import CancelledError, as_completed, futures_of  # noqa: PLC0415
    from distributed.comm import CommClosedError  # noqa: PLC0415
    from distributed.scheduler import KilledWorker  # noqa: PLC0415

    futures = futures_of(client.persist(told))
    try:
        for _, result in as_completed(futures, with_results=True):
            if isinstance(result, BaseException):  # of a scheduler that is gone it comes so
                raise result
            heard(result[0])
    except (CancelledError, CommClosedError, KilledWorker, TimeoutError) as error:
        reason = str(error).splitlines()[0] if isinstance(error, KilledWorker) else "the scheduler is gone"
        raise ConnectionError(reason) from error
    except KeyboardInterrupt:
        client.cancel(futures)
        raise


def bake_chunk(
    call: Call, store: str, start: int, count: int, shared: list[Any], given: list[np.ndarray], rows: list[np.ndarray]
) -> np.ndarray:
    """One task: computes a chunk and writes it."""
    points = points_in(call, start, start + count, shared, given)
    found = numbers(call, start, points, shared, rows)
    arrays = {name: array for name, array in found.items() if isinstance(array, np.ndarray)}
    places = {} if points is None else {name: getattr(points, name) for name in PLACES}
    put(Path(store), start, places | arrays)
    rays = int(found["rays"].sum(dtype=np.int64)) if "rays" in found else 0
    error = np.square(found["standard_error"], dtype=np.float64) if "standard_error" in found else np.zeros(1)
    return np.array([(count, rays, error.reshape(len(error), -1).mean(axis=1).sum())], DONE)
