"""`bench cluster`: processes compared with threads, the cost of a chunk over Dask, and a plan for 10^9 points."""

from dataclasses import dataclass
from functools import partial
from math import ceil
from typing import Annotated

import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, TableView, Track
from warpsample.bench.rows import Spread, Timed, column, format_digits
from warpsample.bench.running.turns import run_tools
from warpsample.bench.tools.cluster import (
    CHUNK,
    COMPUTED,
    FEW_CHUNKS,
    MANY,
    RAYS,
    STORED,
    WAYS,
    build_chunks,
    build_way,
)

PLANNED = 10**9
"""Number of points of the plan."""


@dataclass(frozen=True)
class WayTime(Timed):
    """Row of `bench cluster`: time of ambient occlusion of the bunny on two cores, by two threads or two processes.

    Each point casts 256 rays.
    """

    way: str = column("way")
    points: int = column("points")
    duration: Spread = column("seconds")
    speed: Spread = column("speed / first way", "speed over that of the first way, in the same round")


@dataclass(frozen=True)
class Overhead:
    """Row of `bench cluster`: cost of one more chunk of work over Dask with two processes.

    The cost includes the client, the scheduler and the workers.
    """

    chunk: str = column("chunk")
    milliseconds: Spread = column("ms")


@dataclass(frozen=True)
class PlannedHours:
    """Row of `bench cluster`: planned hours for 10^9 points with 256 rays each, extrapolated from the other rows."""

    threads: int = column("threads")
    hours: float = column("hours", show=format_digits)
    bottleneck: str = column("bottleneck")


def plan_hours(rows: RowsByPart) -> list[PlannedHours]:
    """Compute the planned hours for 10^9 points with 1 to 16,384 threads.

    The hours follow from whole rounds of chunks and from the scheduler's rate.
    """
    way, overhead = rows["ways"][-1], max(1e-6, rows["overheads"][-1].milliseconds.median / 1e3)
    chunks, chunk_seconds = ceil(PLANNED / CHUNK), 2 * way.duration.median * CHUNK / way.points
    at_most = max(1, int(chunk_seconds / overhead))

    def bottleneck(threads: int) -> str:
        if threads <= at_most:
            return f"the work, up to {at_most:,} threads"
        return f"the scheduler: take chunks of {ceil(threads / at_most)} times as many points"

    def hours(threads: int) -> float:
        return max(ceil(chunks / threads) * chunk_seconds, chunks * overhead) / 3600.0

    return [PlannedHours(threads, hours(threads), bottleneck(threads)) for threads in (2**k for k in range(15))]


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Number of points of the timed call.", min=1000)] = 262_144,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure run times and the overhead of Dask, each in separate processes with alternating runs; return the rows.

    Raises:
        ModuleNotFoundError: Dask is missing; names the extra.
    """
    from warpsample import cluster

    _ = cluster.ambient_occlusion  # raise the error that names a missing package
    jobs = [("ways", partial(_measure_ways, points, repeats))]
    jobs += [("overheads", partial(_measure_overhead, end, repeats)) for end in (COMPUTED, STORED)]
    rows: RowsByPart = {"ways": [], "overheads": []}
    for part, job in track(jobs, len(jobs)):
        rows[part] += job()
    return rows | {"hours": plan_hours(rows)}


def _measure_ways(points: int, repeats: int) -> list[WayTime]:
    times = run_tools(build_way, WAYS, repeats, points=points).require_all()
    first = next(iter(times.values()))
    return [WayTime(name, points, Spread.of(t), Spread.of_ratios(first, t), seconds=t) for name, t in times.items()]


def _measure_overhead(end: str, repeats: int) -> list[Overhead]:
    times = run_tools(build_chunks, (FEW_CHUNKS, MANY), repeats, end=end).require_all()
    each = [1e3 * (many - few) / (MANY - FEW_CHUNKS) for few, many in zip(times[FEW_CHUNKS], times[MANY], strict=True)]
    return [Overhead(end, Spread.of(each))]


def _select_few_threads(rows: list[PlannedHours]) -> list[PlannedHours]:
    return [row for row in rows if row.threads in (1, 64, 1024)]


RECORD = Benchmark(
    name="cluster",
    summary="Compare processes with threads over Dask, measure the cost of a chunk, and plan a run of 10^9 points.",
    measure=measure,
    parts={"ways": WayTime, "overheads": Overhead, "hours": PlannedHours},
    views=[
        TableView("ways", f"Processes and threads, {RAYS} rays per point", "way points", "duration speed"),
        TableView("overheads", "Cost of one more chunk", "chunk", "milliseconds"),
        TableView("hours", f"Plan for {PLANNED:,} points", "threads", "hours bottleneck", page_rows=_select_few_threads),
    ],
    pictures=[Picture("cluster", "hours", "threads", y="hours", series="", log="xy")],
)
