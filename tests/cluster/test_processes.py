"""Processes of Dask's: the bits of one call, the mesh once to each, and what is left when one of them is killed."""

import os
import re
import signal
import socket
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module
from threading import Thread

import numpy as np
import psutil
import pytest
from hangs import HANGS

import warpsample as ws
from warpsample import cluster

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

distributed = pytest.importorskip("distributed")
pytest.importorskip("zarr")
xr = pytest.importorskip("xarray")
clients, holdings = (import_module(f"warpsample.cluster.{name}") for name in ("clients", "holdings"))

POINTS, RAYS, CHUNK = 400, 40, 60


@pytest.fixture(scope="module")
def client():
    with clients.computing(None, 2, None):
        yield distributed.Client.current()


@pytest.fixture(scope="module")
def right(mesh):
    return ws.ambient_occlusion(mesh, ws.sample_surface(mesh, POINTS), RAYS)


def test_a_signal_waits_until_the_processes_have_started(monkeypatch):
    """Dask ended with a traceback for each process that was only half started."""
    seen = []

    class Starting:
        def __init__(self, **_):
            signal.raise_signal(signal.SIGTERM)
            seen.append("started")

        def __enter__(self):
            return self

        def __exit__(self, *_):
            seen.append("closed")

    def end(*_):
        seen.append("heard")
        raise KeyboardInterrupt

    monkeypatch.setattr(distributed, "LocalCluster", Starting)
    before = signal.signal(signal.SIGTERM, end)
    try:
        with pytest.raises(KeyboardInterrupt), clients.computing(None, 2, None):
            pytest.fail("computed after a signal")
        assert signal.getsignal(signal.SIGTERM) is end
    finally:
        signal.signal(signal.SIGTERM, before)
    assert seen == ["started", "heard", "closed"]


def meshes(client):
    """Of each process: how many meshes arrived there, how many trees it has, and its number."""

    def look():  # travels by value: processes need not find this file
        from warpsample.host import shared_values
        from warpsample.tracing.scene import _scenes

        return len(shared_values._received), sum(bool(scene._trees) for scene in _scenes.values()), os.getpid()

    return client.run(look).values()


def assert_same(found, right):
    for name in ("value", "standard_error", "spread", "rays", "status"):
        assert np.array_equal(found[name], getattr(right, name)), name


def test_two_processes_give_the_bits_of_one_and_get_the_mesh_once(client, mesh, right, path):
    client.wait_for_workers(2)
    for chunk in (45, CHUNK):
        assert_same(cluster.ambient_occlusion(mesh, POINTS, RAYS, chunk=chunk).compute(), right)
    assert_same(cluster.ambient_occlusion(mesh, ws.sample_surface(mesh, POINTS), RAYS, chunk=CHUNK).compute(), right)
    assert_same(cluster.bake(path, "ambient_occlusion", mesh, POINTS, RAYS, chunk=CHUNK), right)
    found = meshes(client)
    assert [(sent, trees) for sent, trees, _ in found] == [(1, 1), (1, 1)]


def test_what_was_made_before_the_client_is_computed_by_it_too(client, mesh, right):
    with distributed.Client.as_current(client):
        lazy = cluster.ambient_occlusion(mesh, POINTS, RAYS, chunk=CHUNK)
    assert_same(client.gather(client.compute(lazy)), right)


def test_two_stores_of_one_run_are_both_written(client, mesh, right, tmp_path):
    client.wait_for_workers(2)
    stores = [tmp_path / "a.zarr", tmp_path / "b.zarr"]
    with ThreadPoolExecutor(2) as pool:
        made = [pool.submit(cluster.bake, one, "ambient_occlusion", mesh, POINTS, RAYS, chunk=10) for one in stores]
    for found in made:
        assert_same(found.result(), right)


def test_a_function_of_a_module_travels(client, mesh):
    integrand = import_module("weights_of_tests").upward
    folder = os.path.dirname(import_module("weights_of_tests").__file__)  # noqa: PTH120
    client.run(sys.path.append, folder)
    points = ws.sample_surface(mesh, 50)
    found = cluster.integrate(points, integrand, RAYS, mesh=mesh, chunk=20).compute()
    assert_same(found, ws.integrate(points, integrand, RAYS, mesh=mesh))


@pytest.mark.thorough
def test_a_worker_that_is_killed_costs_no_chunk(client, mesh, path):
    client.wait_for_workers(2)
    victim = next(iter(client.run(os.getpid).values()))

    def kill():
        while not list(path.glob("value/c/*")):
            time.sleep(0.01)
        os.kill(victim, signal.SIGKILL)

    thread = Thread(target=kill)
    thread.start()
    found = cluster.bake(path, "ambient_occlusion", mesh, POINTS, 2**13, chunk=10)
    thread.join()
    assert victim not in client.run(os.getpid).values()
    assert_same(found, ws.ambient_occlusion(mesh, ws.sample_surface(mesh, POINTS), 2**13))


def bake(path, *more):
    arguments = ["bake", "courtyard", "-o", path, "--points", 8_000, "--samples", 4096, "--chunk", 100, *more]
    return [sys.executable, "-m", "warpsample", *map(str, arguments)]


def whole_chunks(path):
    return holdings.whole_chunks(path, [file.parent.name for file in path.glob("[!.]*/zarr.json")])


def begun(path, chunks=3):
    end = time.monotonic() + HANGS
    while len(list(path.glob("value/c/*"))) < chunks:
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.fixture(scope="module")
def whole():
    mesh = ws.load_mesh("courtyard")
    return ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 8_000), 4096)


@pytest.mark.thorough
@pytest.mark.parametrize("where", [(), ("--processes", 2)])
@pytest.mark.parametrize("name", ["SIGINT", "SIGKILL"])
def test_a_client_that_ends_leaves_a_store_that_resumes(path, whole, child_environment, where, name):
    """The signal goes to all processes, as from a terminal; a SIGKILL to the first alone, whose others end with it."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    running = subprocess.Popen(bake(path, *where), env=child_environment, start_new_session=True, **pipes)
    begun(path)
    children = psutil.Process(running.pid).children(recursive=True)
    (os.killpg if name == "SIGINT" else os.kill)(running.pid, getattr(signal, name))
    out, err = running.communicate(timeout=HANGS)
    assert (running.returncode, out) == ((130, "") if name == "SIGINT" else (-9, ""))
    if name == "SIGINT":
        (said,) = [line for line in err.splitlines() if "CUDA" not in line]
        assert said.startswith("interrupted after")
        assert said.endswith(f"of 8,000 points; {path} can be resumed")
    assert psutil.wait_procs(children, timeout=HANGS)[1] == []
    there = whole_chunks(path)
    assert 0 < sum(there) < len(there)
    done = subprocess.run(bake(path, "--resume"), env=child_environment, capture_output=True, text=True, check=True)
    assert re.search(rf"\n  {100 * sum(there):,} of the [\d,]+ points were complete before\n", done.stdout)
    with xr.open_zarr(path) as found:
        assert_same(found, whole)


@pytest.fixture
def scheduler(tmp_path, child_environment):
    """A scheduler with one worker, and its address."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    address, start = f"tcp://127.0.0.1:{port}", [sys.executable, "-m", "dask"]
    options = {"env": child_environment, "cwd": tmp_path, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    own = ["--no-dashboard", "--host", "127.0.0.1"]
    running = subprocess.Popen([*start, "scheduler", "--port", port, *own], **options)
    patient = ["--nthreads", "1", "--death-timeout", str(round(HANGS))]
    worker = subprocess.Popen([*start, "worker", address, *patient, *own], **options)
    with distributed.Client(address, timeout=HANGS, set_as_default=False) as client:
        client.wait_for_workers(1, timeout=HANGS)
    yield running, address
    for process in (worker, running):
        process.kill()
        process.wait()


@pytest.mark.thorough
def test_a_scheduler_that_is_gone_is_a_sentence(path, whole, scheduler, child_environment):
    first, address = scheduler
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    running = subprocess.Popen(bake(path, "--cluster", address), env=child_environment, **pipes)
    begun(path)
    first.kill()
    out, err = running.communicate(timeout=HANGS)
    assert (running.returncode, out) == (2, "")
    assert [line for line in err.splitlines() if "CUDA" not in line][:1] == err.splitlines()[-1:]
    assert err.splitlines()[-1].startswith("error: the Dask scheduler no longer answers after ")
    assert err.rstrip().endswith(f"of 8,000 points; {path} can be resumed")
    subprocess.run(bake(path, "--resume"), env=child_environment, capture_output=True, check=True)
    with xr.open_zarr(path) as found:
        assert_same(found, whole)
