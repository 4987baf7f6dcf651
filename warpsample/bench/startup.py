"""`bench startup`: seconds that a new Python process takes to its first results."""

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from typing import Annotated

import typer

from warpsample.bench.record import Benchmark, Picture, RowsByPart, TableView, Track
from warpsample.bench.rows import Spread, Timed, column

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

CACHES = ("cold", "warm")  # a cold cache compiles kernels, a warm cache loads them
STEPS = [step for steps in _SCRIPTS.values() for step in steps]


@dataclass(frozen=True)
class Wait(Timed):
    """Row of `bench startup`: seconds that a new Python process takes for one step."""

    step: str = column("step")
    cache: str = column("kernel cache", show="{} cache".format)
    took: Spread = column("seconds")


def measure(
    track: Track,
    *,
    repeats: Annotated[int, typer.Option(help="Number of new processes for each script and cache.", min=1)] = 5,
) -> RowsByPart:
    """Measure how long new Python processes take for their first steps; return the rows."""
    runs = [start_processes() for _ in track(range(repeats), repeats)]
    seconds_by_case = {(step, cache): [one[cache, step] for one in runs] for step in STEPS for cache in CACHES}
    return {"waits": [Wait(*key, Spread.of(seconds), seconds=seconds) for key, seconds in seconds_by_case.items()]}


def start_processes() -> dict[tuple[str, str], float]:
    """Run each script in two new processes and return the seconds keyed by (cache, step).

    The first process of a script has a cold kernel cache.
    """
    seconds = {}
    for script, steps in _SCRIPTS.items():
        with tempfile.TemporaryDirectory(prefix="warpsample-bench-") as folder:
            for cache in CACHES:
                seconds |= {(cache, step): t for step, t in zip(steps, _run(script, folder), strict=True)}
    return seconds


def _run(script: str, folder: str) -> list[float]:
    environment = {**os.environ, "WARP_CACHE_PATH": folder}
    process = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
    return [float(x) for x in process.stdout.splitlines()[-1].split()]


RECORD = Benchmark(
    name="startup",
    summary="Measure the seconds until a new process has its first results, with compiled kernels and without.",
    measure=measure,
    parts={"waits": Wait},
    views=[TableView("waits", "Seconds of each step in a new process", "step", "took", across="cache")],
    pictures=[Picture("startup", "waits", "took", y="step", series="cache", log="x")],
)
