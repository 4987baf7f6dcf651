"""Seconds of new processes, and of calls that one thread or all of them work on, in a row or after a pause."""

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import chain
from time import perf_counter, sleep
from typing import Annotated

import numpy as np
import typer

from warpsample.bench.record import SEED, Repeats, Track
from warpsample.bench.scenes import bunny, ray_set
from warpsample.bench.startup.processes import CACHES, STEPS, start_processes
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers
from warpsample.tracing.trace import trace

IN_A_ROW, PAUSED = "in a row", "after a pause"
PAUSE = 0.02
"""Seconds in which the threads fall asleep."""

_ROUND = 10  # repeats between two signs of progress


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    processes: Annotated[int, typer.Option(help="New processes of each kind.", min=1)] = 5
    repeats: Repeats = 50


@dataclass(frozen=True)
class Wait:
    """What a new process waits for.

    Attributes:
        step: what it does.
        cache: the kernel cache, "cold" (kernels are compiled) or "warm" (they are loaded).
        took: seconds.
        seconds: of each process; none where they were not kept.
    """

    step: str
    cache: str
    took: Spread
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Call:
    """A call, over and over.

    Attributes:
        what: it does.
        when: IN_A_ROW, or PAUSED: after 20 ms in which nothing was done.
        workers: threads at most.
        microseconds: of it.
        gain: how many times as fast as with one worker, within each round.
        seconds: of each repeat; none where they were not kept.
    """

    what: str
    when: str
    workers: int
    microseconds: Spread
    gain: Spread
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Found:
    """Of every step and call."""

    waits: list[Wait]
    calls: list[Call]


def measure(settings: Settings, track: Track) -> Found:
    """The processes one after the other, then all calls in turns."""
    cases = calls()
    rounds = [min(left, _ROUND) for left in range(settings.repeats, 0, -_ROUND)]
    jobs = [start_processes] * settings.processes
    jobs += [lambda times=times: interleave(list(cases.values()), times)[0] for times in rounds]
    done = [job() for job in track(jobs, len(jobs))]
    found, times = done[: settings.processes], done[settings.processes :]
    each = {(step, cache): [one[cache, step] for one in found] for step in STEPS for cache in CACHES}
    waits = [Wait(*key, Spread.of(seconds), seconds) for key, seconds in each.items()]
    return Found(waits, _rows({case: [*chain(*parts)] for case, *parts in zip(cases, *times, strict=True)}))


def calls() -> dict[tuple[str, str, int], Callable[[], float]]:
    """What times each call, by (what, when, workers)."""
    timed = {}
    for what, (work, pauses) in _works().items():
        for workers in sorted({1, check_workers(None)}):
            call = lambda work=work, workers=workers: work(workers)  # noqa: E731
            timed[what, IN_A_ROW, workers] = stopwatch(call)
            if pauses:
                timed[what, PAUSED, workers] = _after_a_pause(call)
    return timed


def _works() -> dict[str, tuple[Callable[[int], object], bool]]:
    """(the call with so many workers, whether it is also to be timed after a pause) by what it does."""
    mesh = bunny(0)
    origins, towards = ray_set(mesh, "outward", 1 << 18)
    return {
        "1,000 x 16 directions": (_directions(1000, 16), False),
        "65,536 x 64 directions": (_directions(65_536, 64), True),
        "262,144 rays to any hit": (lambda workers: trace(mesh, origins, towards, any_hit=True, workers=workers), True),
    }


def _directions(points: int, count: int) -> Callable[[int], object]:
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.empty((points, count, 3), np.float32)
    return lambda workers: sample_directions(normals, count, out=out, workers=workers)


def _after_a_pause(call: Callable[[], object]) -> Callable[[], float]:
    def case() -> float:
        call()
        sleep(PAUSE)
        start = perf_counter()
        call()
        return perf_counter() - start

    return case


def _rows(times: dict[tuple[str, str, int], list[float]]) -> list[Call]:
    return [
        Call(
            what,
            when,
            workers,
            Spread.of([1e6 * t for t in seconds]),
            Spread.of_ratios(times[what, when, 1], seconds),
            seconds,
        )
        for (what, when, workers), seconds in times.items()
    ]
