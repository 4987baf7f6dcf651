"""Lazy xarray datasets, built from Dask task graphs, for functions computed in chunks of points."""

from operator import getitem
from typing import Any

import numpy as np
import xarray as xr
from dask.array import Array
from dask.base import flatten
from dask.highlevelgraph import HighLevelGraph

from warpsample.cluster.chunks import numbers_in, points_in
from warpsample.cluster.finishing import check_workers_of
from warpsample.cluster.job import Job
from warpsample.cluster.sending import Tasks, current_client, shared_by_key

POINT_ARRAYS: dict[str, Any] = {
    "position": (np.dtype(np.float64), (3,)),
    "normal": (np.dtype(np.float32), (3,)),
    "face": (np.dtype(np.int32), ()),
}
"""(dtype, shape of a row) of each field of points made by workers."""

GIVEN_ARRAYS: dict[str, Any] = {
    **POINT_ARRAYS,
    "id": (np.dtype(np.uint64), ()),
    "raised": (np.dtype(bool), ()),
    "tangent": (np.dtype(np.float32), (4,)),
}
"""(dtype, shape of a row) of each field of points given by the caller."""

_SECOND = {**dict.fromkeys(("pdf", "distance", "face", "vectors"), "sample"), "tangent": "component"}
"""Name of the second dimension, by array, where the name is neither "axis" nor "channel"."""


def dataset_of(job: Job) -> xr.Dataset:
    """Build the lazy xarray Dataset of the results of a function over chunks of points; nothing is computed yet.

    Each chunk has one task for its result, one for its points, and one for each array taken out of the result.

    Raises:
        ValueError: if the job has too many chunks.
        MemoryError: if every worker of the current Client is too small.
    """
    job.check_count()
    if (client := current_client()) is not None:
        check_workers_of(client, job)
    work = f"{job.call.name}-{job.token}"
    tasks, shared = shared_by_key(job)
    blocks = blocks_of(job)
    for i in range(job.count):
        given, rows = ([blocks[name][i] for name in names] for names in (job.point_arrays, job.rows))
        start = i * job.chunk
        chunk = (job.call, range(start, start + job.rows_of(i)), shared, given)
        tasks[work, i] = (numbers_in, *chunk, rows)
        if job.call.at:
            tasks["points-" + work, i] = (points_in, *chunk)
    base = HighLevelGraph.from_collections(work, Tasks(tasks), dependencies=[*job.point_arrays.values(), *job.rows.values()])
    numbers_of = {name: _array(job, base, work, (getitem, (work,), name), kind) for name, kind in job.gives.items()}
    coordinates = {name: kind for name, kind in point_arrays_of(job).items() if name not in job.gives}
    where = {name: _array(job, base, work, (getattr, ("points-" + work,), name), kind) for name, kind in coordinates.items()}
    return xr.Dataset(_with_dimensions(numbers_of), _with_dimensions(where), job.about)


def blocks_of(job: Job) -> dict[str, list[Any]]:
    """Return the Dask keys of the chunks of each input array, as lists keyed by array name."""
    return {name: list(flatten(array.__dask_keys__())) for name, array in (job.point_arrays | job.rows).items()}


def point_arrays_of(job: Job) -> dict[str, tuple[np.dtype, tuple[int, ...]]]:
    """Return (dtype, shape of a row) of each array of the points ("position", "normal", ...), keyed by name."""
    if job.point_arrays:
        return {name: (array.dtype, GIVEN_ARRAYS[name][1]) for name, array in job.point_arrays.items()}
    return POINT_ARRAYS if job.call.at else {}


def _array(
    job: Job, base: HighLevelGraph, layer: str, task: tuple[Any, ...], kind: tuple[np.dtype, tuple[int, ...]]
) -> Array:
    """Build the Dask array of one result from the tasks that compute all results of a chunk as a dictionary.

    Args:
        job: The job.
        base: Graph of the tasks that compute the chunks.
        layer: Name of the layer in `base`.
        task: (function that takes the item, first part of the source's key, name of the item).
        kind: (dtype, shape of a row) of the array.
    """
    (take, source, name), (dtype, shape) = task, kind
    own, zeros = f"{name}-{layer}", (0,) * len(shape)
    items = {(own, i, *zeros): (take, (*source, i), name) for i in range(job.count)}
    chunks = (*(job.chunk,) * (job.count - 1), job.rows_of(job.count - 1))
    graph = HighLevelGraph({**base.layers, own: items}, {**base.dependencies, own: {layer}})
    return Array(graph, own, (chunks, *((n,) for n in shape)), dtype=dtype)


def _with_dimensions(arrays: dict[str, Array]) -> dict[str, tuple[tuple[str, ...], Array]]:
    """Pair each array with the names of its dimensions, as `xarray.Dataset` expects."""
    return {name: (dimensions(name, array.ndim), array) for name, array in arrays.items()}


def dimensions(name: str, count: int) -> tuple[str, ...]:
    """Return the names of the first `count` dimensions of a result array, for example ("point", "axis")."""
    second = _SECOND.get(name, "axis" if name in POINT_ARRAYS else "channel")
    return ("point", second, "axis")[:count]
