"""Each part of `bench cluster`, in processes of its own."""

from collections.abc import Iterator
from contextlib import ExitStack
from math import ceil
from typing import Any

from warpsample.bench.child import Child
from warpsample.bench.cluster.jobs import build_client, build_costs, build_way
from warpsample.bench.cluster.record import CHUNK, PLANNED, WAYS, Found, Memory, Overhead, Sent, Settings, Way
from warpsample.bench.record import Track
from warpsample.bench.timing import Spread, interleave


def measure(settings: Settings, track: Track) -> Found:
    """Each part in processes of its own; the two ways in turns.

    Raises:
        ModuleNotFoundError: Dask is missing; names the extra.
    """
    from warpsample import cluster  # noqa: PLC0415

    _ = cluster.ambient_occlusion  # says what is missing
    sizes = [(10**k, True) for k in range(3, 10) if settings.largest // 100 <= 10**k <= settings.largest]
    sizes.append((PLANNED, False))
    steps = track(range(settings.repeats + 1 + len(sizes)), settings.repeats + 1 + len(sizes))
    ways = _ways(settings, steps)
    next(steps)
    overheads, sent = _costs(settings.repeats)
    memory = []
    for points, computed in sizes:
        next(steps)
        with Child(build_client, points=points, computed=computed) as child:
            memory.append(Memory(points, ceil(points / CHUNK), computed, child.report()["peak_megabytes"]))
    for _ in steps:  # to the end of the bar
        pass
    return Found(ways, overheads, memory, sent)


def _ways(settings: Settings, steps: Iterator[Any]) -> list[Way]:
    with ExitStack() as stack:
        arguments = [{"points": settings.points, "processes": p, "threads": t} for p, t in WAYS.values()]
        children = [stack.enter_context(Child(build_way, **each)) for each in arguments]
        for child in children:
            child.wait_until_built()
        times: list[list[float]] = [[], []]
        for _ in range(settings.repeats):
            next(steps)
            for all_of_it, (seconds,) in zip(times, interleave([child.run for child in children], 1)[0], strict=True):
                all_of_it.append(seconds)
    return [
        Way(name, settings.points, Spread.of(each), Spread.of_ratios(times[0], each), each)
        for name, each in zip(WAYS, times, strict=True)
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
