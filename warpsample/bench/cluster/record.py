"""What `bench cluster` finds: a row for each way, chunk, client and worker."""

from dataclasses import dataclass, field
from typing import Annotated

import typer

from warpsample.bench.record import Repeats
from warpsample.bench.timing import Spread

RAYS = 256
"""Of a point."""
CHUNK = 65_536
"""Points of a task."""
WAYS = {"one process of two threads": (None, 2), "two processes of one thread": (2, None)}
"""(processes, threads); the second is compared with the first."""
PLANNED = 10**9
"""Points of the plan."""


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    points: Annotated[int, typer.Option(help="Points of the timed call.", min=1000)] = 262_144
    largest: Annotated[int, typer.Option(help="Points against which the client's memory is shown.", min=1000)] = 10_000_000
    repeats: Repeats = 3


@dataclass(frozen=True)
class Way:
    """The same points by as many threads.

    Attributes:
        way: of `WAYS`.
        points: of the call, by 256 rays each.
        duration: of the call, in seconds.
        speed: how many times as fast as the first way, within each round.
        seconds: of each repeat.
    """

    way: str
    points: int
    duration: Spread
    speed: Spread
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Overhead:
    """What one more chunk costs the whole run, on two processes: client, scheduler and workers.

    Attributes:
        chunk: computed alone, or written into a store too.
        milliseconds: of one.
    """

    chunk: str
    milliseconds: Spread


@dataclass(frozen=True)
class Memory:
    """Of the client, its scheduler included; the points are computed by other processes.

    Attributes:
        points: of the call.
        chunks: of the call.
        computed: whether it was; else its graph was made, and nothing more.
        peak_megabytes: greatest resident memory; None where unknown.
    """

    points: int
    chunks: int
    computed: bool
    peak_megabytes: float | None


@dataclass(frozen=True)
class Sent:
    """What each worker process gets and makes once.

    Attributes:
        worker: which one.
        calls: over which was counted.
        chunks: of these calls, all workers together.
        meshes: times that one arrived there.
        trees: built there.
        tree_seconds: of these builds.
        mesh_megabytes: of one, as it travels.
        transfer_seconds: until all workers have it.
        stored_bytes: of a point in a store.
    """

    worker: int
    calls: int
    chunks: int
    meshes: int
    trees: int
    tree_seconds: float
    mesh_megabytes: float
    transfer_seconds: float
    stored_bytes: float


@dataclass(frozen=True)
class Found:
    """Of every part."""

    ways: list[Way]
    overheads: list[Overhead]
    memory: list[Memory]
    sent: list[Sent]
