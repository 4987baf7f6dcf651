"""`bench cluster`: processes against threads, what a chunk and a mesh cost over Dask, and the plan for 10^9 points."""

from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from math import ceil
from typing import Annotated, Any

import typer

from warpsample.bench.pictures import Picture
from warpsample.bench.record import Benchmark, Found, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column, digits
from warpsample.bench.running.child import Child
from warpsample.bench.running.timing import interleave
from warpsample.bench.tables import TableView
from warpsample.bench.tools.cluster import CHUNK, RAYS, build_client, build_costs, build_way

WAYS = {"one process of two threads": (None, 2), "two processes of one thread": (2, None)}
"""(processes, threads); the second is compared with the first."""
PLANNED = 10**9
"""Points of the plan."""
MACHINES, CORES = 64, 16
"""What the plan is for."""


@dataclass(frozen=True)
class WayTime(Timed):
    """One way of two threads, on ambient occlusion of the bunny by 256 rays a point."""

    way: str = column("way")
    points: int = column("points")
    duration: Spread = column("s")
    speed: Spread = column("times as fast", "as the first way, within each round")


@dataclass(frozen=True)
class Overhead:
    """What one more chunk costs the whole run, on two processes: client, scheduler and workers."""

    chunk: str = column("chunk")
    milliseconds: Spread = column("ms")


@dataclass(frozen=True)
class ClientMemory:
    """Memory of the client, its scheduler included; the points are computed by other processes."""

    points: int = column("points")
    chunks: int = column("chunks")
    computed: bool = column("computed", "or its graph was made, and nothing more")
    peak_megabytes: float | None = column("peak memory, MB", show=".0f")


@dataclass(frozen=True)
class Sent:
    """What each worker process gets and makes once."""

    worker: int = column("worker")
    calls: int = column("calls", "over which was counted")
    chunks: int = column("chunks", "of these calls, all workers together")
    meshes: int = column("meshes", "that arrived there")
    trees: int = column("trees", "built there")
    tree_seconds: float = column("s for trees", show=digits)
    mesh_megabytes: float = column("MB of a mesh", show=digits)
    transfer_seconds: float = column("s to send it", "to all workers", show=digits)
    stored_bytes: float = column("bytes stored", "of a point", show=digits)


@dataclass(frozen=True)
class BillionPlan:
    """10^9 points by 256 rays on 64 machines of 16 cores, a process each, from what was measured here."""

    chunks: int = column("chunks")
    chunk_seconds: float = column("s of a chunk", "one thread's work", show=digits)
    overhead_seconds: float = column("s over", "that one costs client, scheduler and workers together", show=digits)
    transfer_seconds: float = column("s to send", "until all machines have the mesh, one after the other", show=digits)
    tree_seconds: float = column("s for trees", "all at once", show=digits)
    stored_gigabytes: float = column("GB stored", show=digits)

    @property
    def at_most(self) -> int:
        """Threads beyond which the scheduler hands out chunks more slowly than they are computed."""
        return max(1, int(self.chunk_seconds / self.overhead_seconds))

    def hours(self, threads: int) -> float:
        """From the first byte to the last: chunks in whole rounds, or as fast as the scheduler hands them out."""
        work = ceil(self.chunks / threads) * self.chunk_seconds
        return (self.transfer_seconds + self.tree_seconds + max(work, self.chunks * self.overhead_seconds)) / 3600.0


@dataclass(frozen=True)
class PlannedHours:
    """How long the plan takes by so many threads."""

    threads: int = column("threads")
    hours: float = column("hours", show=digits)
    bottleneck: str = column("bottleneck")


def plan(found: Found) -> BillionPlan:
    """The plan by the medians of two processes of one thread."""
    way, sent = found["ways"][-1], found["sent"]
    return BillionPlan(
        chunks=ceil(PLANNED / CHUNK),
        chunk_seconds=2 * way.duration.median * CHUNK / way.points,
        overhead_seconds=max(1e-6, found["overheads"][-1].milliseconds.median / 1e3),
        transfer_seconds=sent[0].transfer_seconds / len(sent) * MACHINES,
        tree_seconds=max(row.tree_seconds / max(1, row.trees) for row in sent),
        stored_gigabytes=sent[0].stored_bytes * PLANNED / 1e9,
    )


def planned_hours(of: BillionPlan) -> list[PlannedHours]:
    """The plan by 1 to 16,384 threads, a power of two each."""
    return [PlannedHours(threads, of.hours(threads), _bottleneck(of, threads)) for threads in (2**k for k in range(15))]


def _bottleneck(of: BillionPlan, threads: int) -> str:
    if threads <= of.at_most:
        return f"the work, up to {of.at_most:,} threads"
    return f"the scheduler: take chunks of {ceil(threads / of.at_most)} times as many points"


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Points of the timed call.", min=1000)] = 262_144,
    largest: Annotated[int, typer.Option(help="Points against which the client's memory is shown.", min=1000)] = 10_000_000,
    repeats: Repeats = 3,
) -> Found:
    """Each part in processes of its own; the two ways in turns.

    Raises:
        ModuleNotFoundError: Dask is missing; names the extra.
    """
    from warpsample import cluster

    _ = cluster.ambient_occlusion  # says what is missing
    sizes = [(10**k, True) for k in range(3, 10) if largest // 100 <= 10**k <= largest]
    sizes.append((PLANNED, False))
    steps = track(range(repeats + 1 + len(sizes)), repeats + 1 + len(sizes))
    ways = _ways(points, repeats, steps)
    next(steps)
    overheads, sent = _costs(repeats)
    memory = []
    for size, computed in sizes:
        next(steps)
        with Child(build_client, points=size, computed=computed) as child:
            memory.append(ClientMemory(size, ceil(size / CHUNK), computed, child.report()["peak_megabytes"]))
    for _ in steps:  # to the end of the bar
        pass
    return {"ways": ways, "overheads": overheads, "memory": memory, "sent": sent}


def _ways(points: int, repeats: int, steps: Iterator[Any]) -> list[WayTime]:
    with ExitStack() as stack:
        arguments = [{"points": points, "processes": p, "threads": t} for p, t in WAYS.values()]
        children = [stack.enter_context(Child(build_way, **each)) for each in arguments]
        for child in children:
            child.wait_until_built()
        times: list[list[float]] = [[], []]
        for _ in range(repeats):
            next(steps)
            for all_of_it, (seconds,) in zip(times, interleave([child.run for child in children], 1)[0], strict=True):
                all_of_it.append(seconds)
    return [
        WayTime(name, points, Spread.of(seconds), Spread.of_ratios(times[0], seconds), seconds=seconds)
        for name, seconds in zip(WAYS, times, strict=True)
    ]


def _costs(repeats: int) -> tuple[list[Overhead], list[Sent]]:
    rounds = []
    with Child(build_costs) as child:
        for _ in range(repeats):
            child.run()
            rounds.append(child.report())
    overheads = [
        Overhead(name, Spread.of([each["milliseconds"][name] for each in rounds])) for name in rounds[0]["milliseconds"]
    ]
    return overheads, [Sent(worker, *found) for worker, found in enumerate(rounds[-1]["sent"], 1)]


def _few_threads(rows: list[PlannedHours]) -> list[PlannedHours]:
    return [row for row in rows if row.threads in (1, 64, MACHINES * CORES)]


_SENT = "meshes trees tree_seconds mesh_megabytes transfer_seconds stored_bytes"
_PLAN = "chunk_seconds overhead_seconds transfer_seconds tree_seconds stored_gigabytes"

RECORD = Benchmark(
    name="cluster",
    summary="Processes against threads over Dask, what a chunk and a mesh cost, and the plan for 10^9 points.",
    measure=measure,
    parts={"ways": WayTime, "overheads": Overhead, "memory": ClientMemory, "sent": Sent},
    derived=lambda found, _: {"plan": [plan(found)], "hours": planned_hours(plan(found))},
    views=[
        TableView("ways", f"Processes and threads, {RAYS} rays a point", "way points", "duration speed"),
        TableView("overheads", "One more chunk", "chunk", "milliseconds"),
        TableView("memory", "Memory of the client", "points chunks computed", "peak_megabytes"),
        TableView("sent", "What a worker gets", "worker calls chunks", _SENT),
        TableView("plan", f"The plan for {PLANNED:,} points on {MACHINES} machines of {CORES} cores", "chunks", _PLAN),
        TableView("hours", "Its hours", "threads", "hours bottleneck", brief=_few_threads),
    ],
    pictures=[
        Picture("cluster_plan", "hours", "threads", y="hours", series="", log="xy"),
        Picture("cluster_memory", "memory", "points", y="peak_megabytes", series="", log="x"),
    ],
)
