"""Calls that SIGINT ends at random moments: a script, since it may crash. Arguments: the number of interrupts and a seed.

After each interrupt the call must have raised KeyboardInterrupt or returned the complete result; no thread and no half file
may be left; and the next call must give the right bits. Exit status 1 means that something else happened.
"""

import os
import random
import shutil
import signal
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np
import psutil

import warpsample as ws
from warpsample.output.bake import bake
from warpsample.output.baked import BakeRun
from warpsample.output.run_record import RunRecord
from warpsample.output.source import read_source

try:
    from warpsample import cluster

    cluster.bake  # noqa: B018  (raises the error if Zarr, Dask or xarray is missing)
except ModuleNotFoundError:  # Zarr needs Python 3.11
    cluster = None

STOPS = 10.0
"""Seconds for threads to stop after their call: a thread that a call has left at work runs on."""

POOLS = "asyncio_", "zarr_pool_", "ThreadPoolExecutor-"
"""Beginnings of the names of threads in the pools of Zarr and Dask."""

_state = {"armed": False}


def build_calls(folder):
    """Return functions without arguments, by name, each of which returns arrays; two write a file or a store before."""
    mesh = ws.load_mesh("courtyard")
    points = ws.sample_surface(mesh, 4000, seed=1)
    file, store = folder / "out.npz", folder / "out.zarr"
    np.savetxt(folder / "mesh.obj", mesh.vertices, "v %.17g %.17g %.17g")
    with (folder / "mesh.obj").open("a") as text:
        np.savetxt(text, mesh.faces + 1, "f %d %d %d")

    def bake_file():
        options = {"samples": 64, "seed": 3}
        run = BakeRun(mesh=folder / "mesh.obj", output=file, quantity="ao", at=None, points=4000, options=options)
        bake(read_source(run), RunRecord("ambient occlusion"))
        return read_file(file)

    def bake_store():
        return read_store(cluster.bake(store, "ambient_occlusion", mesh, 4000, 64, chunk=1000, resume=True, seed=3))

    calls = {
        "directions": lambda: [ws.sample_directions(points, 128, pdf=True, workers=2).vectors],
        "occlusion": lambda: [ws.ambient_occlusion(mesh, points, 128, workers=2).value],
        "view factors": lambda: [ws.view_factors(mesh, 128, workers=2).matrix.toarray()],
        "file": bake_file,
    }
    return calls | ({"store": bake_store} if cluster else {})


def read_file(path):
    """Return all arrays of an .npz file."""
    with np.load(path) as content:
        return [content[name] for name in sorted(content.files)]


def read_store(dataset):
    """Return the arrays of a store."""
    return [dataset[name].values for name in sorted(dataset.data_vars)]


def hear(*_):
    """Interrupt the call, not the checks between calls."""
    if _state["armed"]:
        raise KeyboardInterrupt


def interrupt(call, delay):
    """Call and send SIGINT after a delay in seconds; return the result, or None after a KeyboardInterrupt."""
    timer = threading.Timer(delay, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    try:
        try:
            _state["armed"] = True
            return call()
        finally:
            _state["armed"] = False
    except KeyboardInterrupt:
        return None
    finally:
        timer.cancel()
        timer.join()


def is_same(result, right):
    """Return whether two lists of arrays are equal, bit by bit."""
    return len(result) == len(right) and all(
        a.dtype == b.dtype and a.tobytes() == b.tobytes() for a, b in zip(result, right, strict=True)
    )


def count_threads():
    """Return the number of threads without those of Zarr's pools, which grow up to a fixed size when they are used."""
    return psutil.Process().num_threads() - sum(thread.name.startswith(POOLS) for thread in threading.enumerate())


def has_threads_of(before):
    """Wait until the process has at most as many threads as before; return whether it has."""
    end = time.monotonic() + STOPS
    while count_threads() > before and time.monotonic() < end:
        time.sleep(0.01)
    return count_threads() <= before


def find_flaws(call, result, right, folder, threads):
    """Return descriptions of all that is wrong after an interrupt, and after the next call."""
    flaws = [] if result is None or is_same(result, right) else ["a result that is not complete"]
    flaws += [] if has_threads_of(threads) else [f"{count_threads()} threads, {threads} before"]
    left = {path.name for path in folder.iterdir()} - {"mesh.obj", "out.npz", "out.zarr"}
    flaws += [f"files {left}"] if left else []
    file = folder / "out.npz"  # of the call that writes one
    flaws += ["half a file"] if file.exists() and not is_same(read_file(file), right) else []
    return flaws + ([] if is_same(call(), right) else ["other bits in the next call"])


def run(count, seed):
    """Interrupt calls until `count` of them have raised KeyboardInterrupt; return whether nothing was wrong."""
    rng, heard, flaws = random.Random(seed), 0, []
    signal.signal(signal.SIGINT, hear)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        calls = build_calls(folder)
        right, seconds = {}, {}
        for key, call in calls.items():
            right[key] = call()
            clear(folder)
            start = time.perf_counter()
            call()
            seconds[key] = time.perf_counter() - start
        threads = count_threads()
        while heard < count and not flaws:
            key = rng.choice(list(calls))
            clear(folder)
            result = interrupt(calls[key], rng.uniform(0.0, seconds[key]))
            heard += result is None
            flaws += [f"{key}: {flaw}" for flaw in find_flaws(calls[key], result, right[key], folder, threads)]
    sys.stderr.write(f"{heard} interrupts; wrong: {flaws}\n")
    return not flaws


def clear(folder):
    """Remove the outputs."""
    (folder / "out.npz").unlink(missing_ok=True)
    if (folder / "out.zarr").exists():
        shutil.rmtree(folder / "out.zarr")


if __name__ == "__main__":
    sys.exit(0 if run(int(sys.argv[1]), int(sys.argv[2])) else 1)
