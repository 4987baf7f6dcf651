"""What a new process waits for: the import, and its first directions with a cold and a warm kernel cache."""

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass

_CHILD = """
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


@dataclass(frozen=True)
class Startup:
    """Seconds in a new process.

    Attributes:
        kernel_cache: "cold" (kernels are compiled) or "warm" (they are loaded).
        import_warp: `import warp`.
        import_warpsample: what `from warpsample import sample_directions` adds.
        first_directions: the first `sample_directions` after that, with its kernel.
        further_kernel: the next one, which needs another kernel.
    """

    kernel_cache: str
    import_warp: float
    import_warpsample: float
    first_directions: float
    further_kernel: float


def measure_startup() -> list[Startup]:
    """Two new processes with a kernel cache of their own: the first finds it cold, the second warm."""
    with tempfile.TemporaryDirectory(prefix="warpsample-bench-") as cache:
        environment = {**os.environ, "WARP_CACHE_PATH": cache}
        return [Startup(state, *_run_child(environment)) for state in ("cold", "warm")]


def _run_child(environment: dict[str, str]) -> list[float]:
    command = [sys.executable, "-c", _CHILD]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return [float(x) for x in done.stdout.split()[-4:]]
