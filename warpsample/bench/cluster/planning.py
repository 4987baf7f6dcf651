"""What `bench cluster` found as tables, a picture, and the plan for 10^9 points."""

from dataclasses import dataclass
from math import ceil
from typing import TYPE_CHECKING

from warpsample.bench.cluster.record import CHUNK, PLANNED, RAYS, Found, Memory
from warpsample.bench.pictures import OURS, THEIRS
from warpsample.bench.report import SPREAD, Table, digits, spread
from warpsample.bench.result import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MACHINES, CORES = 64, 16
"""Of the plan."""


@dataclass(frozen=True)
class Plan:
    """10^9 points by 256 rays on 64 machines of 16 cores, a process each, from what was measured here.

    Attributes:
        chunks: of it.
        chunk_seconds: one thread's work of one.
        overhead_seconds: what one costs the client, its scheduler and the workers together.
        transfer_seconds: until all machines have the mesh, one after the other.
        tree_seconds: of all builds, which are at once.
        stored_gigabytes: of the store.
    """

    chunks: int
    chunk_seconds: float
    overhead_seconds: float
    transfer_seconds: float
    tree_seconds: float
    stored_gigabytes: float

    @property
    def at_most(self) -> int:
        """Threads beyond which the scheduler hands out chunks more slowly than they are computed."""
        return max(1, int(self.chunk_seconds / self.overhead_seconds))

    def hours(self, threads: int) -> float:
        """From the first byte to the last: chunks in whole rounds, or as fast as the scheduler hands them out."""
        work = ceil(self.chunks / threads) * self.chunk_seconds
        return (self.transfer_seconds + self.tree_seconds + max(work, self.chunks * self.overhead_seconds)) / 3600.0


def plan(found: Found) -> Plan:
    """By the medians of two processes of one thread."""
    way, sent = found.ways[-1], found.sent
    return Plan(
        chunks=ceil(PLANNED / CHUNK),
        chunk_seconds=2 * way.duration.median * CHUNK / way.points,
        overhead_seconds=max(1e-6, found.overheads[-1].milliseconds.median / 1e3),
        transfer_seconds=sent[0].transfer_seconds / len(sent) * MACHINES,
        tree_seconds=max(row.tree_seconds / max(1, row.trees) for row in sent),
        stored_gigabytes=sent[0].stored_bytes * PLANNED / 1e9,
    )


def tables(result: Result) -> list[Table | str]:
    """A table for each part, and the plan."""
    return [f"Ambient occlusion of the bunny, {RAYS} rays a point: {SPREAD}.", *_tables(result.found), *_told(result.found)]


def readme(result: Result) -> list[Table | str]:
    """Two processes, memory, and the plan."""
    ways, _, memory, _ = _tables(result.found)
    return [
        f"Ambient occlusion of the bunny over Dask, {RAYS} rays a point, and the client's memory, scheduler included:",
        ways,
        memory,
        *_told(result.found),
    ]


def _tables(found: Found) -> list[Table]:
    ways = [[row.way, f"{row.points:,}", spread(row.duration), spread(row.speed)] for row in found.ways]
    overheads = [[row.chunk, spread(row.milliseconds)] for row in found.overheads]
    memory = [
        [f"{row.points:,}{'' if row.computed else ', made only'}", f"{row.chunks:,}", _megabytes(row)]
        for row in found.memory
    ]
    sent = [
        [str(row.worker), f"{row.calls}, of {row.chunks:,} chunks", str(row.meshes), str(row.trees)] for row in found.sent
    ]
    return [
        Table("Processes and threads", ["way", "points", "s", "times as fast"], ways),
        Table("One more chunk", ["chunk", "ms"], overheads),
        Table("Memory of the client", ["points", "chunks", "peak memory, MB"], memory),
        Table("What a worker gets", ["worker", "calls", "meshes", "trees"], sent),
    ]


def _told(found: Found) -> list[str]:
    """What a chunk costs beside its work, and the plan, in words."""
    of, sent = plan(found), found.sent[0]
    everyone = MACHINES * CORES
    narrow, wide = of.at_most < everyone, ceil(everyone / of.at_most)
    neck = (
        f"the scheduler is the bottleneck from {of.at_most:,} threads on: take chunks of {wide} times as many points"
        if narrow
        else f"the work is the bottleneck, up to {of.at_most:,} threads, where it becomes the scheduler"
    )
    counts = sorted({row.meshes for row in found.sent})
    return [
        (
            f"A chunk of {CHUNK:,} points is {digits(of.chunk_seconds)} s of one thread's work; its overhead is "
            + " and ".join(f"{digits(row.milliseconds.median)} ms {row.chunk}" for row in found.overheads)
            + f". In {sent.calls} calls of {sent.chunks:,} chunks a worker gets {' or '.join(map(str, counts))} mesh"
            f"{'' if counts == [1] else 'es'} of {digits(sent.mesh_megabytes)} MB."
        ),
        (
            f"The plan for {PLANNED:,} points on {MACHINES} machines of {CORES} such cores: {of.chunks:,} chunks; transfer "
            f"of the mesh {digits(of.transfer_seconds)} s, if networks are as fast as this machine's loopback; trees "
            f"{digits(of.tree_seconds)} s, all at once; chunk overhead {digits(of.chunks * of.overhead_seconds)} s in all; "
            f"{digits(of.stored_gigabytes)} GB stored; {digits(of.hours(everyone))} hours, of {digits(of.hours(1))} on one "
            f"core. Of {everyone:,} threads {neck}."
        ),
    ]


def _megabytes(row: Memory) -> str:
    return "–" if row.peak_megabytes is None else f"{row.peak_megabytes:.0f}"


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """The hours of the plan against threads, and the client's memory against points."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure, of = Figure(figsize=(10.0, 4.5), layout="constrained"), plan(found)
    left, right = figure.subplots(1, 2)
    threads = [2**k for k in range(15)]
    left.plot(threads, [of.hours(t) for t in threads], "o-", color=OURS, linewidth=0.8)
    left.axvline(of.at_most, color=THEIRS, linestyle="--")
    left.set_xlabel("threads; dashed: what one scheduler can keep busy")
    left.set_ylabel(f"hours for {PLANNED:,} points")
    left.set_yscale("log")
    right.plot([row.points for row in found.memory], [row.peak_megabytes or 0.0 for row in found.memory], "o-", color=OURS)
    right.set_xlabel("points")
    right.set_ylabel("peak memory of the client [MB]")
    right.set_ylim(0.0, 1.1 * right.get_ylim()[1])
    for axes in (left, right):
        axes.set_xscale("log")
        axes.grid(alpha=0.3)
    figure.supxlabel(caption, fontsize=9)
    return {"cluster": figure}
