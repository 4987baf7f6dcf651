"""`bench startup`: what a new process waits for, what small calls cost, and what all threads gain, also after a pause."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import product
from time import perf_counter, sleep
from typing import Annotated

import numpy as np
import typer

from warpsample.bench.pictures import Picture
from warpsample.bench.record import SEED, Benchmark, Found, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.timing import in_turns, stopwatch
from warpsample.bench.scenes import bunny, ray_set
from warpsample.bench.tables import TableView
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers
from warpsample.tracing.trace import trace

_DIRECTIONS = """
from time import perf_counter
t0 = perf_counter()
import warp
t1 = perf_counter()
from warpsample import sample_directions
t2 = perf_counter()
import numpy
normals = numpy.array([[0.0, 0.0, 1.0]], numpy.float32)
sample_directions(normals, 64)
t3 = perf_counter()
sample_directions(normals, 64, sequence="independent")
print(t1 - t0, t2 - t1, t3 - t2, perf_counter() - t3)
"""

_ESTIMATE = """
import warpsample as ws
mesh, normals = ws.load_mesh("courtyard"), [[0.0, 0.0, 1.0]]
from time import perf_counter
start = perf_counter()
points = ws.sample_surface(mesh, 64)
ws.ambient_occlusion(mesh, points)
print(perf_counter() - start)
"""

_SCRIPTS = {
    _DIRECTIONS: ["import warp", "+ import warpsample", "first directions", "a further kernel"],
    _ESTIMATE: ["first points and their occlusion"],
}

CACHES = ("cold", "warm")
"""Kernels are compiled, or they are loaded."""

STEPS = [step for steps in _SCRIPTS.values() for step in steps]
"""What is timed."""


IN_A_ROW, PAUSED = "in a row", "after a pause"
PAUSE = 0.02
"""Seconds in which the threads fall asleep."""


@dataclass(frozen=True)
class Wait(Timed):
    """What a new process waits for."""

    step: str = column("step")
    cache: str = column("kernel cache", show="{} cache".format)
    took: Spread = column("seconds")


@dataclass(frozen=True)
class TimedCall(Timed):
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
    found = [start_processes() for _ in track(range(processes), processes)]
    taken = {(step, cache): [one[cache, step] for one in found] for step in STEPS for cache in CACHES}
    waits = [Wait(*key, Spread.of(seconds), seconds=seconds) for key, seconds in taken.items()]
    return {"waits": waits, "calls": measure_calls(repeats)}


def start_processes() -> dict[tuple[str, str], float]:
    """Seconds by (cache, step), of two processes to each script: the first finds the kernel cache cold, the second warm."""
    found = {}
    for script, steps in _SCRIPTS.items():
        with tempfile.TemporaryDirectory(prefix="warpsample-bench-") as folder:
            for cache in CACHES:
                found |= {(cache, step): t for step, t in zip(steps, _run(script, folder), strict=True)}
    return found


def _run(script: str, folder: str) -> list[float]:
    environment = {**os.environ, "WARP_CACHE_PATH": folder}
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
    return [float(x) for x in done.stdout.splitlines()[-1].split()]


def measure_calls(repeats: int) -> list[TimedCall]:
    """Each call with one worker and with all, in a row and after a pause."""
    cases = {}
    for (what, call), workers in product(_calls().items(), sorted({1, check_workers(None)})):
        cases[what, IN_A_ROW, workers] = stopwatch(partial(call, workers=workers))
        cases[what, PAUSED, workers] = _after_a_pause(partial(call, workers=workers))
    times = in_turns(cases, repeats)
    rows = []
    for (what, when, workers), seconds in times.items():
        each, gain = Spread.of([1e6 * t for t in seconds]), Spread.of_ratios(times[what, when, 1], seconds)
        rows.append(TimedCall(what, when, workers, each, gain, seconds=seconds))
    return rows


def _calls() -> dict[str, Callable[..., object]]:
    """What is called with a number of workers, by what it does."""
    mesh = bunny(0)
    return {
        "1,000 x 16 directions": _directions(1000, 16),
        "65,536 x 64 directions": _directions(65_536, 64),
        "262,144 rays to any hit": partial(trace, mesh, *ray_set(mesh, "outward", 1 << 18), any_hit=True),
    }


def _directions(points: int, count: int) -> Callable[..., object]:
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    return partial(sample_directions, normals, count, out=np.empty((points, count, 3), np.float32))


def _after_a_pause(call: Callable[[], object]) -> Callable[[], float]:
    def case() -> float:
        call()
        sleep(PAUSE)
        start = perf_counter()
        call()
        return perf_counter() - start

    return case


RECORD = Benchmark(
    name="startup",
    summary="What a new process waits for, what a small call costs, and what all threads gain, also after a pause.",
    measure=measure,
    parts={"waits": Wait, "calls": TimedCall},
    views=[
        TableView("waits", "A new process, seconds", "step", "took", across="cache"),
        TableView("calls", "Calls", "what when workers", "microseconds gain"),
    ],
    pictures=[Picture("startup", "waits", "took", y="step", series="cache", log="x")],
)
