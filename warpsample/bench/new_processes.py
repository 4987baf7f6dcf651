"""New processes: the import, the first directions and the first estimate, with a cold and a warm kernel cache."""

import os
import subprocess
import sys
import tempfile

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
