"""Stores of more points than a disk or a list of chunks takes: refused at once, or begun at once in little memory."""

import shutil
import subprocess
import sys
from importlib import import_module

import pytest

import warpsample as ws
from warpsample import cluster

pytest.importorskip("dask")
pytest.importorskip("zarr")
finishing, baking = (import_module(f"warpsample.cluster.{name}") for name in ("finishing", "baking"))

ROOM = 10**15
BAKE = """
import os, resource, shutil, sys, time
from pathlib import Path
from threading import Thread

resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
path = Path(sys.argv[1])
free = shutil.disk_usage(path.parent)._replace(free=10**15)
shutil.disk_usage = lambda _: free

def watch():
    while len(list(path.glob("value/c/*"))) < 3:
        time.sleep(0.05)
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10, flush=True)
    os._exit(0)

Thread(target=watch, daemon=True).start()
from warpsample.cli import main
sys.argv[1:] = ["bake", "courtyard", "-o", str(path), "--points", sys.argv[2], "--samples", "2", "--chunk", "60000"]
main()
"""


@pytest.mark.thorough
def test_ten_thousand_million_points_begin_in_the_memory_of_a_million(tmp_path, child_environment):
    """166,667 tasks: a graph of them all would take 300 MB, and what is known of chunks takes 20."""
    peaks = []
    for points in (10**6, 10**10):
        command = [sys.executable, "-c", BAKE, str(tmp_path / f"{points}.zarr"), str(points)]
        done = subprocess.run(command, env=child_environment, capture_output=True, text=True, check=True, timeout=300)
        peaks.append(int(done.stdout))
    assert peaks[1] < peaks[0] + 150  # MiB; two runs of the same differ by some 20


@pytest.mark.slow
def test_what_no_disk_holds_is_refused_at_once(call, path):
    status, out, err = call("bake", "courtyard", "-o", path, "--points", 10**14)
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert err.startswith(f"error: {path} cannot be written: 100,000,000,000,000 points take 6,100.000 TB, and ")
    assert err.endswith("B are free\n")
    assert list(path.parent.iterdir()) == []


@pytest.mark.slow
def test_what_is_missing_must_fit_too(path, mesh, monkeypatch):
    cluster.bake(path, "ambient_occlusion", mesh, 100, 2, chunk=40)
    (path / "value/c/2").unlink()
    usage = shutil.disk_usage(path.parent)

    def resume(free):
        monkeypatch.setattr(shutil, "disk_usage", lambda _: usage._replace(free=free))
        cluster.bake(path, "ambient_occlusion", mesh, 100, 2, chunk=40, resume=True)

    with pytest.raises(OSError, match=r"cannot be written: 40 points take 2.440 kB, and 2.439 kB are free$"):
        resume(40 * 61 - 1)
    resume(40 * 61)


@pytest.mark.slow
def test_more_chunks_than_lists_hold_are_refused(path, mesh, monkeypatch):
    usage = shutil.disk_usage(path.parent)
    monkeypatch.setattr(shutil, "disk_usage", lambda _: usage._replace(free=ROOM))
    message = (
        r"^chunk: got 7 of 100,000,000 points, which makes 14,285,715 chunks, want at least 96 points per chunk, "
        r"for at most 1,048,576 chunks$"
    )
    with pytest.raises(ValueError, match=message):
        cluster.bake(path, "ambient_occlusion", mesh, 10**8, 2, chunk=7)
    with pytest.raises(ValueError, match=message):
        cluster.ambient_occlusion(mesh, 10**8, 2, chunk=7)
    assert not path.exists()


@pytest.mark.slow
def test_graphs_of_parts_make_the_same_store(path, mesh, monkeypatch):
    monkeypatch.setattr(baking, "AT_A_TIME", 3)
    found = cluster.bake(path, "ambient_occlusion", mesh, 100, 2, chunk=9)
    right = ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 100), 2)
    assert (found.value.to_numpy() == right.value).all()
