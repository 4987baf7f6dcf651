"""Calls of all kinds, interrupted at random times until so many interrupts were heard: a script, since it may crash.

Exit status 1 means that a thread was at work after a call, or that a later call gave other bits than before.
"""

import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np
import trimesh
import warp as wp

import warpsample as ws
from warpsample.host import engine

TORUS = trimesh.creation.torus(2.0, 0.5)
COLD = [
    (kind, sequence) for kind in (ws.GGX, ws.UniformSphere, ws.OffsetBall) for sequence in ("sobol", "r2", "independent")
]
"""Distributions and sequences whose kernels are compiled when an interrupt comes."""

_state = {"armed": False, "in_call": False, "late": 0}


def torus(scale=1.0):
    """A mesh without any cached values."""
    return ws.Mesh(scale * TORUS.vertices, TORUS.faces)


mesh = torus()
points = ws.sample_surface(mesh, 2000, seed=1)


def some(k):
    """Fewer points for greater k, so that launches change their sizes."""
    rows = slice(0, len(points.position) // (k + 1))
    return ws.SurfacePoints(points.position[rows], points.normal[rows], points.face[rows])


def directions_of(k):
    """A few or many directions, and their densities."""
    return ws.sample_directions(some(k), (256, 64, 16)[k], pdf=True, workers=3).vectors


CALLS = {
    "directions": directions_of,
    "trace": lambda k: ws.trace(mesh, some(k), directions_of(k), workers=3).distance,
    "warp": lambda k: ws.trace(torus(), some(k), some(k).normal, tracer="warp", workers=3).distance,
    "occlusion": lambda k: ws.ambient_occlusion(mesh, some(k), 128, workers=3).value,
    "tolerance": lambda k: ws.sky_view_factor(mesh, some(k), 128, tolerance=0.02, workers=3).value,
    "sky matrix": lambda k: ws.sky_matrix(mesh, some(k + 1), 128, workers=3).value,
    "view factors": lambda k: ws.view_factors(mesh, 256 >> k, workers=3).matrix.toarray(),
    "refit": lambda k: ws.ambient_occlusion(ws.refit(mesh, mesh.vertices * (1.1 + k), workers=3), some(k), 64).value,
    "new mesh": lambda k: ws.ambient_occlusion(torus(1.0 + k), some(k), 64, workers=3).value,
}


def cold(kind, sequence):
    """Directions by a kernel that no other call has."""
    return ws.sample_directions(np.eye(3), 20, distribution=kind.cases()[0], sequence=sequence).vectors


def write_cold(path):
    """Runs in a process that nothing interrupts, with the usual cache."""
    np.savez(path, *(cold(*key) for key in COLD))


def begin(*_):
    """Stands in for the engine's: counts the threads that end a batch while no call is running."""
    main = threading.main_thread()

    def done(_):
        if threading.current_thread() is not main and not _state["in_call"]:
            _state["late"] += 1

    return done


def hear(*_):
    """Interrupts the call, not what this script does between calls."""
    if _state["armed"]:
        raise KeyboardInterrupt


def interrupted(call, first, every):
    """Whether a call was interrupted; by a timer that strikes again until it was."""
    _state["in_call"] = True
    try:
        signal.setitimer(signal.ITIMER_REAL, first, every)
        try:
            _state["armed"] = True
            call()
        finally:
            _state["armed"] = _state["in_call"] = False
    except KeyboardInterrupt:
        return True
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
    return False


def seconds(call):
    """How long a call takes."""
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def run(wanted, seed=31):
    """Interrupts the first calls of cold kernels, then warm calls."""
    rng = random.Random(seed)
    signal.signal(signal.SIGALRM, hear)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "cold.npz")
        subprocess.run([sys.executable, __file__, "--write", path], check=True)
        wp.config.kernel_cache_dir = str(Path(folder, "cache"))
        with np.load(path) as right:
            heard, wrong = run_cold(rng, [right[name] for name in right.files])
    cases = {(name, k): (lambda f=f, k=k: f(k)) for name, f in CALLS.items() for k in range(3)}
    right = {key: call() for key, call in cases.items()}
    took = {key: seconds(call) for key, call in cases.items()}
    engine.begin = begin
    while heard < wanted:
        key = rng.choice(list(cases))
        if interrupted(cases[key], rng.uniform(1e-5, took[key]), rng.choice((0.0, 0.0, 0.001))):
            heard += 1
            time.sleep(0.001)  # for a thread that is still at work
            _state["in_call"] = True
            wrong += [again for again in (key, rng.choice(list(cases))) if not np.array_equal(cases[again](), right[again])]
            _state["in_call"] = False
    sys.stderr.write(f"{heard} interrupts, other bits: {wrong}, batches after their call: {_state['late']}\n")
    return not wrong and not _state["late"]


def run_cold(rng, right):
    """The interrupts that were heard, and the kernels with other results."""
    heard, wrong = 0, []
    for key, expected in zip(COLD, right, strict=True):
        for _ in range(4):
            heard += interrupted(lambda key=key: cold(*key), rng.uniform(0.0, 0.4), 0.0)
        if not np.array_equal(cold(*key), expected):
            wrong.append(key)
    return heard, wrong


if __name__ == "__main__":
    if sys.argv[1] == "--write":
        write_cold(sys.argv[2])
    else:
        sys.exit(0 if run(int(sys.argv[1])) else 1)
