"""How kernels are run: split into batches, by threads that are kept, which stop and fail together."""

import threading
import time
from collections import defaultdict
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp
from hangs import HANGS

import warpsample as ws
from warpsample.host import engine, sharing

CPU = wp.get_device("cpu")
MUCH = 10**9  # work, so that threads share it


@wp.kernel(enable_backward=False, grid_stride=False)
def _count(out: wp.array[wp.int32], first_task: wp.int64):
    out[wp.int32(first_task) + wp.tid()] += 1


def count(out, workers, work=MUCH):
    """Adds 1 to each number of an array, a task for each."""
    engine.run(_count, len(out), [wp.array(out, device=CPU, copy=False)], CPU, workers=workers, work=work)


@pytest.fixture
def after_each_chunk(monkeypatch):
    """Sets what the engine calls after each batch, as it does for a progress bar: (thread is the caller's) -> anything."""

    def set_to(function):
        caller = threading.current_thread()
        monkeypatch.setattr(engine, "begin", lambda *_: lambda _: function(threading.current_thread() is caller))

    return set_to


@pytest.mark.parametrize("workers", [1, 2, 5])
@pytest.mark.parametrize("tasks", [1, 7, 4096, 4097])
def test_every_task_runs_once(workers, tasks, monkeypatch):
    monkeypatch.setattr(engine, "MOST_TASKS", 1000)
    out = np.zeros(tasks, np.int32)
    count(out, workers)
    assert (out == 1).all()


@pytest.mark.parametrize(("limit", "work"), [("MOST_TASKS", 1), ("MOST_WORK", 10_000)])
def test_no_chunk_is_larger_than_its_limit(limit, work, monkeypatch):
    monkeypatch.setattr(engine, limit, 1000)
    batches = []
    monkeypatch.setattr(engine, "begin", lambda *_: batches.append)
    count(np.zeros(10_000, np.int32), 1, work)
    assert batches == [1000] * 10


@pytest.mark.parametrize("seconds", [1e-6, 1e-3, 0.15])
def test_batches_of_slow_tasks_become_small(seconds, monkeypatch):
    """Where thousands of faces met at thousands of points, a batch took minutes, and so did an interrupt."""
    now, sizes = [0.0], []

    def spend(size):
        sizes.append(size)
        now[0] += size * seconds

    monkeypatch.setattr(engine, "perf_counter", lambda: now[0])
    monkeypatch.setattr(engine, "begin", lambda *_: spend)
    out = np.zeros(20_000, np.int32)
    count(out, 1, engine.LEAST_WORK)
    assert (out == 1).all()
    assert sum(sizes) == 20_000
    assert max(sizes[2:]) <= max(1, 0.2 / seconds)  # a launch of more than 0.2 s makes the next ones smaller
    assert len(sizes) < 10 + 20_000 * seconds / 0.1  # and each takes about 0.1 s, or is a single task


def test_a_cuda_device_gets_tasks_enough_at_a_time(monkeypatch):
    """A million points by 256 rays; and by so many that a launch of all of them would not end."""
    device, commands = SimpleNamespace(is_cpu=False, alias="cuda:0"), []
    monkeypatch.setattr(engine, "_idle", defaultdict(list))
    monkeypatch.setattr(engine, "_take", lambda *_: commands.append(0))
    for rays, least, most in ((256, 1 << 18, 1 << 22), (1 << 24, 1, 1 << 5)):

        def look(parts, _, found=(least, most)):
            commands.append(found[0] <= parts[0].keywords["batch"] <= found[1])

        monkeypatch.setattr(engine, "share", look)
        engine.run(_count, 10**6, [], device, workers=8, work=64 * rays * 10**6)
    assert commands == [0, True, 0, True]  # one command each: launches queue up


def test_an_interrupt_stops_the_threads_before_the_call_returns(after_each_chunk):
    begun = threading.Event()

    def interrupt(here):
        if here:
            begun.wait(HANGS)
            raise KeyboardInterrupt
        begun.set()
        time.sleep(0.001)

    after_each_chunk(interrupt)
    out = np.zeros(100_000, np.int32)
    with pytest.raises(KeyboardInterrupt):
        count(out, 3, engine.MOST_WORK * len(out))  # a batch for each task
    done = out.sum()
    assert done < len(out)  # a minute's launches, were they not stopped
    time.sleep(0.05)
    assert out.sum() == done


def test_fewer_threads_than_asked_for_do_the_work(monkeypatch):
    """The system gives no more threads, or Python is ending."""
    refused = []

    def start(*arguments):
        refused.append(arguments)
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(sharing, "start_new_thread", start)
    out = np.zeros(10_000, np.int32)
    count(out, 1024)  # more than any other test has started
    assert (out == 1).all()
    assert len(refused) == 1


def test_an_error_in_a_worker_reaches_the_caller(after_each_chunk):
    elsewhere = threading.Event()

    def fail(here):
        if here:
            elsewhere.wait(HANGS)
        else:
            elsewhere.set()
            raise OSError("from another thread")

    after_each_chunk(fail)
    with pytest.raises(OSError, match="^from another thread$"):
        count(np.zeros(1000, np.int32), 2)


def test_threads_and_launches_are_kept(normals, monkeypatch):
    many = np.repeat(normals, 200, axis=0)
    first = ws.sample_directions(many, 16, workers=3)
    for home, name in ((wp, "launch"), (sharing, "start_new_thread")):
        monkeypatch.setattr(home, name, None)  # neither is made anew
    again = ws.sample_directions(many, 16, workers=3)
    assert np.array_equal(again.vectors, first.vectors)
