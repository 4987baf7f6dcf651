"""Workers that are killed, paused, restarted or too small: what a Client gave them, it gives again, or says why not."""

import os
import signal
import time
from contextlib import suppress
from importlib import import_module
from threading import Thread

import numpy as np
import pytest
from hangs import HANGS

import warpsample as ws
from warpsample import cluster

pytestmark = pytest.mark.slow  # processes, seconds each

distributed = pytest.importorskip("distributed")
pytest.importorskip("zarr")
finishing = import_module("warpsample.cluster.finishing")

POINTS, RAYS, CHUNK = 400, 2**12, 10
OWN = {"threads_per_worker": 1, "dashboard_address": "127.0.0.1:0", "silence_logs": 50}


@pytest.fixture(scope="module")
def client():
    """Of two processes with Dask's own settings, by which one copy of a mesh is left after two idle seconds."""
    with distributed.LocalCluster(n_workers=2, host="127.0.0.1", **OWN) as own, distributed.Client(own) as found:
        yield found


@pytest.fixture
def threads():
    """A Client whose worker is a thread of this process, and small."""
    with (
        distributed.LocalCluster(n_workers=1, processes=False, memory_limit="250MiB", **OWN) as own,
        distributed.Client(own) as found,
    ):
        yield found


@pytest.fixture(scope="module")
def right(mesh):
    return ws.ambient_occlusion(mesh, ws.sample_surface(mesh, POINTS), RAYS)


def kill_all(client):
    for process in client.run(os.getpid).values():
        os.kill(process, signal.SIGKILL)


def two_again(client):
    """On a busy machine a nanny that restarts its worker as that starts may end: then the cluster makes others."""
    with suppress(TimeoutError):
        client.wait_for_workers(2, timeout=20)
    client.cluster.scale(2)


def meanwhile(path, what):
    """Does it once a chunk is there, in a thread that has begun."""

    def run():
        while not list(path.glob("value/c/*")):
            time.sleep(0.01)
        what()

    thread = Thread(target=run)
    thread.start()
    return thread


@pytest.mark.thorough
def test_a_dataset_outlives_all_workers_that_have_its_mesh(client, mesh, right):
    lazy = cluster.ambient_occlusion(mesh, POINTS, RAYS, chunk=200)
    assert np.array_equal(lazy.value, right.value)
    client.wait_for_workers(2)
    kill_all(client)
    assert np.array_equal(lazy.value, right.value)


def restart(client):
    client.restart(timeout=HANGS, wait_for_workers=False)


@pytest.mark.thorough
@pytest.mark.parametrize("end", [kill_all, restart])
def test_a_store_outlives_workers_that_are_killed_or_restarted(client, mesh, right, path, end):
    client.wait_for_workers(2)
    thread = meanwhile(path, lambda: (end(client), two_again(client)))
    found = cluster.bake(path, "ambient_occlusion", mesh, POINTS, RAYS, chunk=CHUNK)
    thread.join()
    assert np.array_equal(found.value, right.value)


def paused(client, names, fraction):
    """Lets workers pause, or go on, at a fraction of their memory."""

    def change(dask_worker):
        dask_worker.memory_manager.memory_pause_fraction = fraction

    client.run(change, workers=names)


@pytest.mark.thorough
@pytest.mark.parametrize("all_of_them", [False, True])
def test_workers_that_pause_cost_time(client, mesh, right, path, all_of_them, monkeypatch):
    monkeypatch.setattr(finishing, "_LOOK", 0.1)
    client.wait_for_workers(2)
    names = list(client.scheduler_info(n_workers=-1)["workers"])[: 2 if all_of_them else 1]

    def pause():
        paused(client, names, 1e-9)
        time.sleep(2.0)
        paused(client, names, 0.8)

    thread = meanwhile(path, pause)
    found = cluster.bake(path, "ambient_occlusion", mesh, POINTS, RAYS, chunk=CHUNK)
    thread.join()
    assert np.array_equal(found.value, right.value)


def test_workers_that_are_too_small_are_called_that(threads, mesh, path):
    said = r"^the workers have too little memory: .* may use 250 MiB, want at least 36\d MiB for each worker$"
    with pytest.raises(MemoryError, match=said):
        cluster.bake(path, "ambient_occlusion", mesh, POINTS, 2)
    assert not path.exists()
    with pytest.raises(MemoryError, match=said):
        cluster.ambient_occlusion(mesh, POINTS, 2)


def test_so_they_are_when_they_end_or_pause_at_work(threads, mesh, path, monkeypatch):
    """They came after the job had begun."""
    monkeypatch.setattr(finishing, "_LOOK", 0.1)
    look = finishing.check_workers_of
    monkeypatch.setattr(import_module("warpsample.cluster.baking"), "check_workers_of", lambda *_: None)
    monkeypatch.setattr(finishing, "check_workers_of", look)
    paused(threads, None, 1e-9)
    time.sleep(1.0)  # the worker looks at its memory five times a second
    with pytest.raises(MemoryError, match=r"may use 250 MiB, .* for each worker after 0 of 400 points; .* can be resumed$"):
        cluster.bake(path, "ambient_occlusion", mesh, POINTS, 2)


@pytest.mark.thorough
def test_a_dataset_of_a_closed_client_says_so(mesh, monkeypatch):
    said = "this dataset's mesh was sent to a Dask Client that is closed; make the dataset again"
    with distributed.LocalCluster(n_workers=1, processes=False, **OWN) as own:
        with distributed.Client(own):
            lazy = cluster.ambient_occlusion(mesh, POINTS, 2)
            assert lazy.value.compute().shape == (POINTS,)
        with pytest.raises(RuntimeError, match=said):
            lazy.compute()
        with distributed.Client(own), pytest.raises(RuntimeError, match=said):
            lazy.compute()
