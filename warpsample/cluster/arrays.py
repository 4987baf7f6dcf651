"""Jobs as Dask's tasks and arrays, and these as an xarray.Dataset."""

import sys
from collections import deque
from operator import getitem
from typing import Any
from weakref import WeakValueDictionary

import numpy as np
import xarray as xr
from dask.array import Array
from dask.base import flatten, tokenize
from dask.highlevelgraph import HighLevelGraph

from warpsample.cluster.chunks import numbers_in, points_in
from warpsample.cluster.job import Job

PLACES = {"position": (np.dtype(np.float64), (3,)), "normal": (np.dtype(np.float32), (3,)), "face": (np.dtype(np.int32), ())}
"""(type, shape of a row) of points that workers make."""

_SAMPLES = {"pdf", "distance", "face", "vectors"}
"""Arrays whose second axis are the samples of a point."""

_KEPT = 4  # of what was sent: a scheduler that hears of the end of one only after it was sent again loses that too
_sent: WeakValueDictionary[tuple[str, str], Any] = WeakValueDictionary()
_last_sent: deque[Any] = deque(maxlen=_KEPT)


def current_client() -> Any | None:
    """The Client that computes in this place, if there is one; one that found no scheduler is none."""
    if "distributed" not in sys.modules:
        return None
    from distributed import Client  # noqa: PLC0415

    try:
        client = Client.current()
    except ValueError:
        return None
    return client if client.status == "running" else None


def shared_by_key(job: Job) -> tuple[dict[str, Any], list[Any]]:
    """Tasks that are the large arguments, and what other tasks call them by.

    With a Client they are sent to each of its workers, the last few once for all; else they are part of the graph.
    """
    client = current_client()
    if client is None:
        tasks = {f"{name}-{tokenize(value)}": value for name, value in job.shared.items()}
        return tasks, list(tasks)
    called = []
    for value in job.shared.values():
        key = client.id, tokenize(value)
        future = _sent.get(key)
        if future is None or future.status != "finished":
            future = _sent[key] = client.scatter(value, broadcast=True, hash=True)
            _last_sent.append(future)
        called.append(future)
    return {}, called


def dataset_of(job: Job) -> xr.Dataset:
    """The lazy arrays of a job: a task for the numbers of a chunk, one for its points, and one that takes each array out."""
    work = f"{job.call.name}-{job.token}"
    tasks, shared = shared_by_key(job)
    blocks = blocks_of(job)
    for i, start in enumerate(starts_of(job)):
        given, rows = ([blocks[name][i] for name in names] for names in (job.given, job.rows))
        chunk = (job.call, start, start + job.chunks[i], shared, given)
        tasks[work, i] = (numbers_in, *chunk, rows)
        if job.call.at:
            tasks["points-" + work, i] = (points_in, *chunk)
    base = HighLevelGraph.from_collections(work, tasks, dependencies=[*job.given.values(), *job.rows.values()])
    numbers_of = {name: _array(job, base, work, (getitem, (work,), name), kind) for name, kind in job.gives.items()}
    places = {name: kind for name, kind in places_of(job).items() if name not in job.gives}
    where = {name: _array(job, base, work, (getattr, ("points-" + work,), name), kind) for name, kind in places.items()}
    return xr.Dataset(_with_dimensions(numbers_of), _with_dimensions(where), job.about)


def starts_of(job: Job) -> list[int]:
    """The first row of each chunk."""
    return np.cumsum((0, *job.chunks[:-1])).tolist()


def blocks_of(job: Job) -> dict[str, list[Any]]:
    """The keys of the chunks of the arrays that a job takes."""
    return {name: list(flatten(array.__dask_keys__())) for name, array in (job.given | job.rows).items()}


def places_of(job: Job) -> dict[str, tuple[np.dtype, tuple[int, ...]]]:
    """(type, shape of a row) of the coordinates; none if there are no SurfacePoints."""
    made = {name: (job.given[name].dtype, kind[1]) if job.given else kind for name, kind in PLACES.items()}
    return made if job.call.at else {}


def _array(
    job: Job, base: HighLevelGraph, layer: str, task: tuple[Any, ...], kind: tuple[np.dtype, tuple[int, ...]]
) -> Array:
    """One array of what the chunks' tasks give."""
    (take, source, name), (dtype, shape) = task, kind
    own, zeros = f"{name}-{layer}", (0,) * len(shape)
    items = {(own, i, *zeros): (take, (*source, i), name) for i in range(len(job.chunks))}
    graph = HighLevelGraph({**base.layers, own: items}, {**base.dependencies, own: {layer}})
    return Array(graph, own, (job.chunks, *((n,) for n in shape)), dtype=dtype)


def _with_dimensions(arrays: dict[str, Array]) -> dict[str, tuple[tuple[str, ...], Array]]:
    return {name: (dimensions(name, array.ndim), array) for name, array in arrays.items()}


def dimensions(name: str, count: int) -> tuple[str, ...]:
    """The names of an array's axes."""
    second = "sample" if name in _SAMPLES else "axis" if name in PLACES else "channel"
    return ("point", second, "axis")[:count]
