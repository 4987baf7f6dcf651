"""Jobs as Dask's tasks and arrays, and these as an xarray.Dataset."""

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
"""(type, shape of a row) of points that workers make."""

GIVEN_ARRAYS: dict[str, Any] = {**POINT_ARRAYS, "id": (np.dtype(np.uint64), ()), "raised": (np.dtype(bool), ())}
"""The same of all that points may have which the caller gives."""

_SAMPLES = {"pdf", "distance", "face", "vectors"}
"""Arrays whose second axis are the samples of a point."""


def dataset_of(job: Job) -> xr.Dataset:
    """The lazy arrays of a job: a task for the numbers of a chunk, one for its points, and one that takes each array out."""
    job.check_count()
    if (client := current_client()) is not None:
        check_workers_of(client, job)
    work = f"{job.call.name}-{job.token}"
    tasks, shared = shared_by_key(job)
    blocks = blocks_of(job)
    for i in range(job.count):
        given, rows = ([blocks[name][i] for name in names] for names in (job.given, job.rows))
        start = i * job.chunk
        chunk = (job.call, range(start, start + job.rows_of(i)), shared, given)
        tasks[work, i] = (numbers_in, *chunk, rows)
        if job.call.at:
            tasks["points-" + work, i] = (points_in, *chunk)
    base = HighLevelGraph.from_collections(work, Tasks(tasks), dependencies=[*job.given.values(), *job.rows.values()])
    numbers_of = {name: _array(job, base, work, (getitem, (work,), name), kind) for name, kind in job.gives.items()}
    coordinates = {name: kind for name, kind in point_arrays_of(job).items() if name not in job.gives}
    where = {name: _array(job, base, work, (getattr, ("points-" + work,), name), kind) for name, kind in coordinates.items()}
    return xr.Dataset(_with_dimensions(numbers_of), _with_dimensions(where), job.about)


def blocks_of(job: Job) -> dict[str, list[Any]]:
    """The keys of the chunks of the arrays that a job takes."""
    return {name: list(flatten(array.__dask_keys__())) for name, array in (job.given | job.rows).items()}


def point_arrays_of(job: Job) -> dict[str, tuple[np.dtype, tuple[int, ...]]]:
    """(type, shape of a row) of the coordinates; none if there are no SurfacePoints."""
    if job.given:
        return {name: (array.dtype, GIVEN_ARRAYS[name][1]) for name, array in job.given.items()}
    return POINT_ARRAYS if job.call.at else {}


def _array(
    job: Job, base: HighLevelGraph, layer: str, task: tuple[Any, ...], kind: tuple[np.dtype, tuple[int, ...]]
) -> Array:
    """One array of what the chunks' tasks give."""
    (take, source, name), (dtype, shape) = task, kind
    own, zeros = f"{name}-{layer}", (0,) * len(shape)
    items = {(own, i, *zeros): (take, (*source, i), name) for i in range(job.count)}
    chunks = (*(job.chunk,) * (job.count - 1), job.rows_of(job.count - 1))
    graph = HighLevelGraph({**base.layers, own: items}, {**base.dependencies, own: {layer}})
    return Array(graph, own, (chunks, *((n,) for n in shape)), dtype=dtype)


def _with_dimensions(arrays: dict[str, Array]) -> dict[str, tuple[tuple[str, ...], Array]]:
    return {name: (dimensions(name, array.ndim), array) for name, array in arrays.items()}


def dimensions(name: str, count: int) -> tuple[str, ...]:
    """The names of an array's axes."""
    second = "sample" if name in _SAMPLES else "axis" if name in POINT_ARRAYS else "channel"
    return ("point", second, "axis")[:count]
