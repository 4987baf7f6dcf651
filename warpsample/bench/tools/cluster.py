"""Work that `bench cluster` times, with a Dask client of two processes or two threads."""

import atexit
import tempfile
from collections.abc import Callable
from contextlib import ExitStack
from functools import cache
from math import ceil
from pathlib import Path
from typing import Any

from warpsample.bench.running.child import ChildJob
from warpsample.bench.scenes import bunny

RAYS = 256
"""Rays per point."""
CHUNK = 65_536
"""Points of a chunk, which is one task."""
FEW_CHUNKS, MANY = 8, 264
"""Numbers of chunks for the same points; the cost of a chunk follows from the difference of the times."""
WAYS: dict[str, Any] = {"one process of two threads": (None, 2), "two processes of one thread": (2, None)}
"""(processes, threads) by name; the first is the baseline."""
COMPUTED, STORED = "computed", "into a store"

_ALL_AT_ONCE = 1 << 20  # more than the number of chunks
_FEWEST = 2  # rays per point of a run with almost no work
_SMALL = 8448  # points of the runs with few and with many chunks
_load_bunny = cache(bunny)  # one object, so that Dask sends it once


def _use_workers(processes: int | None, threads: int | None) -> None:
    """Set the number of worker processes and threads for the rest of this process."""
    from warpsample.cluster.clients import computing

    stack = ExitStack()
    atexit.register(stack.close)
    stack.enter_context(computing(None, processes, threads))


def _build_mean(points: int, chunk: int, rays: int) -> Callable[[], object]:
    """Build a function that computes the mean of a lazy Dask call; one task reduces all chunks to one number."""
    from warpsample import cluster

    lazy = cluster.ambient_occlusion(_load_bunny(0), points, rays, chunk=chunk)
    return lazy.value.data.mean(split_every=_ALL_AT_ONCE).compute


def build_way(tool: str, points: int) -> ChildJob:
    """Prepare ambient occlusion with two threads, or with two processes, and return the work to time.

    The chunks divide evenly between two workers.
    """
    _use_workers(*WAYS[tool])
    warm = _build_mean(_SMALL, _SMALL // FEW_CHUNKS, RAYS)
    warm()
    return ChildJob(_build_mean(points, ceil(points / (2 * ceil(points / CHUNK / 2))), RAYS), report=dict, warm=warm)


def build_chunks(tool: int, end: str) -> ChildJob:
    """Prepare the computation of a few points in `tool` chunks on two processes, and return the work to time.

    The argument `end` states whether the result is computed or written into a store.
    """
    from warpsample import cluster

    _use_workers(2, None)
    mesh, chunk = _load_bunny(0), _SMALL // tool

    def store() -> None:
        with tempfile.TemporaryDirectory() as folder:
            cluster.bake(Path(folder, "a.zarr"), "ambient_occlusion", mesh, _SMALL, _FEWEST, chunk=chunk)

    return ChildJob(_build_mean(_SMALL, chunk, _FEWEST) if end == COMPUTED else store, report=dict)
