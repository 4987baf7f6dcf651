"""The jobs of `bench cluster`: clients of two processes, or of two threads of their own."""

import atexit
import pickle
import tempfile
from collections.abc import Callable
from contextlib import ExitStack
from functools import cache, update_wrapper
from math import ceil
from pathlib import Path
from time import perf_counter
from typing import Any

from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import peak_megabytes
from warpsample.bench.scenes import bunny
from warpsample.mesh import known
from warpsample.mesh import mesh as meshes
from warpsample.mesh.mesh import Mesh
from warpsample.tracing import scene as scenes

RAYS = 256
"""Rays of a point."""
CHUNK = 65_536
"""Points of a task."""
FEW, MANY = 8, 264
"""Chunks of the same points, from whose times follows what one costs."""
MOST = 1 << 20
"""More chunks than there are."""
FEWEST = 2
"""Rays of a point, where work is to be next to nothing."""

_SMALL = 8448  # points of both


def _within(processes: int | None, threads: int | None) -> None:
    """Computes by these from now to the end of this process."""
    from warpsample.cluster.clients import computing

    stack = ExitStack()
    atexit.register(stack.close)
    stack.enter_context(computing(None, processes, threads))


@cache
def _mesh() -> Mesh:
    return bunny(0)


def _call(points: int, chunk: int, rays: int) -> tuple[Any, Callable[[], float]]:
    """A lazy call, and its mean: what comes back is one number, which one task makes of those of all chunks."""
    from warpsample import cluster

    lazy = cluster.ambient_occlusion(_mesh(), points, rays, chunk=chunk)
    return lazy, lambda: float(lazy.value.data.mean(split_every=MOST).compute())


def build_way(points: int, processes: int | None, threads: int | None) -> ChildJob:
    """Ambient occlusion by so many processes, or so many threads of this one, in chunks that both are given evenly."""
    _within(processes, threads)
    even = ceil(points / (2 * ceil(points / CHUNK / 2)))
    _, work = _call(points, even, RAYS)
    _, warm = _call(_SMALL, _SMALL // FEW, RAYS)
    warm()
    return ChildJob(work, report=dict, warm=warm)


def build_client(points: int, computed: bool) -> ChildJob:
    """A client of two processes, and its memory."""
    _within(2, None)
    _, compute = _call(points, CHUNK, FEWEST)
    return ChildJob(compute if computed else lambda: None, report=lambda: {"peak_megabytes": peak_megabytes()})


def build_costs() -> ChildJob:
    """What chunks cost beside the same points, and what is sent to two processes; counted from their start."""
    from warpsample.cluster.arrays import current_client

    _within(2, None)
    client = current_client()
    client.wait_for_workers(2)
    size, transfer = len(pickle.dumps(_mesh())) / 1e6, _transfer(client)
    client.run(_count)
    kept, first = _call(_SMALL, _SMALL // FEW, FEWEST)
    first()
    about = {"kept": kept, "calls": 1, "milliseconds": {}}  # what is kept keeps the mesh where it is

    def work() -> None:
        with tempfile.TemporaryDirectory() as folder:
            for name, run in (("computed", _computed), ("into a store", _stored)):
                times = [run(Path(folder), chunks) for chunks in (FEW, MANY)]
                about["milliseconds"][name] = 1e3 * (times[1] - times[0]) / (MANY - FEW)
            stored = sum(f.stat().st_size for f in Path(folder, f"{FEW}.zarr").rglob("c/**/*") if f.is_file()) / _SMALL
        about["calls"] += 4
        chunks = FEW + about["calls"] // 4 * 2 * (FEW + MANY)
        counts = client.run(_counted).values()
        about["sent"] = [(about["calls"], chunks, *each, size, transfer, stored) for each in counts]

    return ChildJob(work, report=lambda: {name: about[name] for name in ("milliseconds", "sent")}, warm=lambda: None)


def _transfer(client: Any) -> float:
    """Seconds until all workers have a mesh of this size, the second time."""
    for shift in (1.0, 2.0):
        start = perf_counter()
        client.scatter(Mesh(_mesh().vertices + shift, _mesh().faces), broadcast=True)
        seconds = perf_counter() - start
    return seconds


def _computed(_: Path, chunks: int) -> float:
    start = perf_counter()
    _call(_SMALL, _SMALL // chunks, FEWEST)[1]()
    return perf_counter() - start


def _stored(folder: Path, chunks: int) -> float:
    from warpsample import cluster

    start = perf_counter()
    cluster.bake(folder / f"{chunks}.zarr", "ambient_occlusion", _mesh(), _SMALL, FEWEST, chunk=_SMALL // chunks)
    return perf_counter() - start


_counts = {"meshes": 0, "trees": 0, "tree_seconds": 0.0}


def _count() -> None:
    """On a worker: counts from now on what arrives and what is built."""

    def arrived(*given: Any) -> Any:
        _counts["meshes"] += 1
        return arrives(*given)

    def build(*given: Any) -> Any:
        start = perf_counter()
        made = builds(*given)
        _counts["trees"] += 1
        _counts["tree_seconds"] += perf_counter() - start
        return made

    arrives, builds = known.arrived, scenes.build
    known.arrived = meshes.arrived = update_wrapper(arrived, arrives)  # the one that a worker sends meshes on by
    scenes.build = build


def _counted() -> list[float]:
    return list(_counts.values())
