"""`cluster.bake`: compute a `warpsample` function at all points and write a Zarr store, chunk by chunk.

Chunks that are complete in an existing store are skipped.
"""

from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
import xarray as xr
from dask.array import Array
from dask.callbacks import Callback
from dask.highlevelgraph import HighLevelGraph

from warpsample.cluster.arrays import GIVEN_ARRAYS, blocks_of
from warpsample.cluster.chunks import CALLS, FUNCTIONS, Call, numbers, points_in
from warpsample.cluster.finishing import AT_A_TIME, check_workers_of, finished
from warpsample.cluster.job import CHUNK, Job, job_of
from warpsample.cluster.lock import locked
from warpsample.cluster.sending import current_client, shared_by_key
from warpsample.cluster.store import begin, check_store
from warpsample.cluster.writing import at_work, write_chunk, writing
from warpsample.estimate.estimating import collect_missed_tolerances
from warpsample.host.arguments import check_choice, check_flag
from warpsample.output.run_record import EMPTY, SUMMARY, RunRecord, summarize


def bake(path: Any, call: str, *arguments: Any, chunk: int = CHUNK, resume: bool = False, **options: Any) -> xr.Dataset:
    """Compute a `warpsample` function with Dask, and write the results into a Zarr store, chunk by chunk.

    The current Client computes the chunks, or without a Client the configured scheduler of Dask.

    The worker that computes a chunk also writes the chunk, so all workers must be able to reach the path.
    Each file appears complete, with a checksum.

    Args:
        path: Path of a folder that ends in .zarr.
        call: Name of a call of this module, such as "ambient_occlusion".
        *arguments: Arguments of the call.
        chunk: Number of points of a task, and of the store's files. Default: 65536.
        resume: Whether to continue a store of the same arguments, if there is one. Default: False.
        **options: Options of the call.

    Returns:
        the dataset in the store, opened lazily by `xarray.open_zarr`.

    Raises:
        TypeError, ValueError: an argument that cannot be used, or a store of another run; the message names the difference.
        OSError: a store that cannot be written, has too little disk space or is being written by another process; or a
            scheduler that no longer answers.
        MemoryError: all workers of the Client are too small; the message states the memory that each needs.

    Example:
        >>> from tempfile import TemporaryDirectory
        >>> from warpsample import cluster
        >>> with TemporaryDirectory() as folder:
        ...     sky = cluster.bake(f"{folder}/sky.zarr", "sky_view_factor", ws.load_mesh("courtyard"), 500, 32)
        ...     print(sky.value.shape)
        (500,)
    """
    mesh = options.pop("mesh", None) if call == "sample_directions" else None
    job = job_of(check_choice(call, "call", tuple(FUNCTIONS)), arguments, options, chunk, mesh)
    store = check_store(path, "path")
    bake_job(job, store, check_flag(resume, "resume"), "path", RunRecord(job.call.name))
    return xr.open_zarr(store)


def bake_job(job: Job, store: Path, resume: bool, argument: str, record: RunRecord) -> None:
    """Create or open a Zarr store, and compute and write the chunks that the store does not have yet.

    Args:
        job: Job to compute.
        store: Path of the store, as `check_store` returns it.
        resume: Whether an existing store may be continued.
        argument: Name of the path's argument, for error messages.
        record: Record that counts the points of complete chunks, and adds up the summaries of written chunks.

    Raises:
        KeyboardInterrupt: the run is interrupted; the message states how many points are done.
        ValueError, OSError, MemoryError: as for `bake`.
    """
    client = current_client()
    if client is not None:
        check_workers_of(client, job)
    with locked(store), record.count(job.total, f"{store} can be resumed"):
        try:
            whole = begin(store, job, resume, argument)
            record.skip(sum(map(job.rows_of, np.flatnonzero(whole).tolist())))
            with writing(store) as folder:
                _run(job, folder, np.flatnonzero(~whole).tolist(), record.add)
        except (ConnectionError, MemoryError) as error:
            kind = MemoryError if isinstance(error, MemoryError) else ConnectionError  # a plain type takes a message
            raise kind(f"{error} after {record.done:,} of {job.total:,} points; {store} can be resumed") from error


def _run(job: Job, folder: Path, chunks: list[int], heard: Callable[[np.void], None]) -> None:
    """Compute and write the chunks with the given numbers, using Dask; call `heard` for each finished chunk.

    Tasks are given to Dask in graphs of limited size: one graph of all tasks can take gigabytes.
    """
    if (client := current_client()) is not None:
        with closing(finished(client, job, lambda some: _tasks(job, folder, some), chunks)) as all_told:
            for told in all_told:
                heard(told)
        return
    for start in range(0, len(chunks), AT_A_TIME):
        told = _tasks(job, folder, chunks[start : start + AT_A_TIME])
        with Callback(posttask=lambda key, result, *_, name=told.name: heard(result[0]) if key[0] == name else None):
            told.compute(optimize_graph=False)  # optimization renames the tasks


def _tasks(job: Job, folder: Path, chunks: list[int]) -> Array:
    """Build the Dask tasks that compute and write the chunks, as an array; its values are summaries of the chunks.

    The tasks' names are unique to this run, because tasks of another run may write into another store.
    """
    name = f"bake-{job.call.name}-{uuid4().hex}"
    tasks, shared = shared_by_key(job)
    blocks = blocks_of(job)
    for number, i in enumerate(chunks):
        own = [[blocks[key][i] for key in keys] for keys in (job.point_arrays, job.rows)]
        start = i * job.chunk
        span = range(start, start + job.rows_of(i))
        tasks[name, number] = (bake_chunk, job.call, (str(folder), job.chunk), span, shared, own)
    graph = HighLevelGraph.from_collections(name, tasks, dependencies=[*job.point_arrays.values(), *job.rows.values()])
    return Array(graph, name, ((1,) * len(chunks),), dtype=SUMMARY)


def bake_chunk(
    call: Call, target: tuple[str, int], span: range, shared: list[Any], blocks: list[list[np.ndarray]]
) -> np.ndarray:
    """Compute the points of one chunk and write the results into the store; return counts and sums of the values.

    Args:
        call: Call to compute.
        target: (path of the writing call's folder, number of rows per chunk).
        span: Row numbers of the chunk.
        shared: Arguments that all chunks have in common, in the order of `call.shared`.
        blocks: [arrays of the chunk's points, other arrays with a row per point], for the chunk's rows.

    Raises:
        WriteError: if the writing call has ended, or a file cannot be written.
    """
    folder, chunk = Path(target[0]), target[1]
    given, rows = blocks
    with at_work(folder):
        points = points_in(call, span, shared, given)
        with collect_missed_tolerances() as missed:
            found = numbers(call, span.start, points, shared, rows)
        arrays = {name: array for name, array in found.items() if isinstance(array, np.ndarray)}
        where = {name: array for name in GIVEN_ARRAYS if (array := getattr(points, name, None)) is not None}
        index = span.start // chunk
        write_chunk(folder, index, (index,), (chunk,), where | arrays)
    rays = int(found["rays"].sum(dtype=np.int64)) if "rays" in found else 0
    if "value" in found and "standard_error" in found:
        known = found["status"] == 0 if "status" in found else None
        vectors = call.name in CALLS and CALLS[call.name].is_vector
        summary = summarize(found["value"], found["standard_error"], rays, known, vectors=vectors)
    else:
        summary = EMPTY.copy()
        summary["points"], summary["rays"] = len(span), rays
    summary["missed"] = max(missed, default="")
    return np.array([summary], SUMMARY)
