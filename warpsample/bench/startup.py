"""`bench startup`: what a new process waits for, what small calls cost, and what all threads gain, also after a pause."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import chain
from time import perf_counter, sleep
from typing import Annotated

import numpy as np
import typer

from warpsample.bench.new_processes import CACHES, STEPS, start_processes
from warpsample.bench.pictures import Picture
from warpsample.bench.record import SEED, Benchmark, Found, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.scenes import bunny, ray_set
from warpsample.bench.tables import View
from warpsample.bench.timing import interleave, stopwatch
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers
from warpsample.tracing.trace import trace

IN_A_ROW, PAUSED = "in a row", "after a pause"
PAUSE = 0.02
"""Seconds in which the threads fall asleep."""

_ROUND = 10  # repeats between two signs of progress


@dataclass(frozen=True)
class Wait(Timed):
    """What a new process waits for."""

    step: str = column("step")
    cache: str = column("kernel cache", show="{} cache".format)
    took: Spread = column("seconds")


@dataclass(frozen=True)
class Call(Timed):
    """A call, over and over."""

    what: str = column("call")
    when: str = column("when", f"after a pause of {1000 * PAUSE:.0f} ms, in which nothing is done, or without")
    workers: int = column("workers")
    microseconds: Spread = column("µs")
    gain: Spread = column("times as fast as one worker", "within each round")


def measure(
    track: Track,
    *,
    processes: Annotated[int, typer.Option(help="New processes of each kind.", min=1)] = 5,
    repeats: Repeats = 50,
) -> Found:
    """The processes one after the other, then all calls in turns."""
    cases = calls()
    rounds = [min(left, _ROUND) for left in range(repeats, 0, -_ROUND)]
    jobs = [start_processes] * processes
    jobs += [lambda times=times: interleave(list(cases.values()), times)[0] for times in rounds]
    done = [job() for job in track(jobs, len(jobs))]
    found, times = done[:processes], done[processes:]
    taken = {(step, cache): [one[cache, step] for one in found] for step in STEPS for cache in CACHES}
    waits = [Wait(*key, Spread.of(seconds), seconds=seconds) for key, seconds in taken.items()]
    by_call = {case: [*chain(*parts)] for case, *parts in zip(cases, *times, strict=True)}
    return {"waits": waits, "calls": [_call(by_call, *case) for case in by_call]}


def calls() -> dict[tuple[str, str, int], Callable[[], float]]:
    """What times each call, by (what, when, workers)."""
    timed = {}
    for what, (work, pauses) in _works().items():
        for workers in sorted({1, check_workers(None)}):
            call = _with(work, workers)
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


def _with(work: Callable[[int], object], workers: int) -> Callable[[], object]:
    return lambda: work(workers)


def _after_a_pause(call: Callable[[], object]) -> Callable[[], float]:
    def case() -> float:
        call()
        sleep(PAUSE)
        start = perf_counter()
        call()
        return perf_counter() - start

    return case


def _call(times: dict[tuple[str, str, int], list[float]], what: str, when: str, workers: int) -> Call:
    seconds = times[what, when, workers]
    each, gain = Spread.of([1e6 * t for t in seconds]), Spread.of_ratios(times[what, when, 1], seconds)
    return Call(what, when, workers, each, gain, seconds=seconds)


RECORD = Benchmark(
    name="startup",
    summary="What a new process waits for, what a small call costs, and what all threads gain, also after a pause.",
    measure=measure,
    parts={"waits": Wait, "calls": Call},
    views=[
        View("waits", "A new process, seconds", "step", "took", across="cache"),
        View("calls", "Calls", "what when workers", "microseconds gain"),
    ],
    pictures=[
        Picture("startup_processes", "waits", x="took", series="step", panels="cache"),
        Picture("startup_calls", "calls", x="microseconds", series="what when", panels="workers"),
    ],
)
