"""When a Client's scheduler or its workers are given up: by what they tell, without any process."""

import signal
from importlib import import_module
from itertools import repeat
from types import SimpleNamespace

import pytest

pytest.importorskip("dask")
distributed = pytest.importorskip("distributed")
finishing = import_module("warpsample.cluster.finishing")

MIB = 1 << 20


def finished(monkeypatch, client, attempts):
    """What is told of five chunks if each attempt finishes so many and is then forgotten; and how many there were."""
    results, begun, attempts = [], [], iter(attempts)

    def forgetful(client, job, tasks, chunks):
        begun.append(chunks)
        yield from [(chunk, -chunk) for chunk in chunks[: next(attempts)]]
        raise distributed.CancelledError("lost")

    monkeypatch.setattr(finishing, "_finished", forgetful)
    try:
        results.extend(finishing.finished(client, None, None, list(range(5))))
    except ConnectionError as error:
        results.append(str(error))
    return results, len(begun)


@pytest.mark.parametrize(
    ("attempts", "right"),
    [
        ((0, 0, 5), ([0, -1, -2, -3, -4], 3)),
        ((2, 0, 1, 0, 2), ([0, -1, -2, -3, -4], 5)),
        (repeat(0), (["the Dask scheduler repeatedly lost the tasks (lost)"], 3)),
    ],
)
def test_a_scheduler_that_forgets_thrice_without_a_task_finished_is_given_up(monkeypatch, attempts, right):
    assert finished(monkeypatch, SimpleNamespace(status="running"), attempts) == right


def test_one_that_is_gone_is_not_asked_again(monkeypatch):
    assert finished(monkeypatch, SimpleNamespace(status="closed"), repeat(0)) == (
        ["the Dask scheduler no longer answers"],
        1,
    )


def test_a_deadline_is_no_word_of_the_scheduler(monkeypatch):
    """A handler's TimeoutError is not one of distributed's, after which the tasks are sent again."""
    begun = []

    def hear(*_):
        raise TimeoutError("mine")

    def late(*_):
        begun.append(1)
        signal.raise_signal(signal.SIGALRM)
        yield

    monkeypatch.setattr(finishing, "_finished", late)
    before = signal.signal(signal.SIGALRM, hear)
    try:
        with pytest.raises(TimeoutError, match="^mine$"):
            list(finishing.finished(SimpleNamespace(status="running"), None, None, [0]))
    finally:
        signal.signal(signal.SIGALRM, before)
    assert begun == [1]


@pytest.mark.parametrize("error", [KeyboardInterrupt, TimeoutError, ValueError, None])
def test_tasks_are_cancelled_however_it_ends(monkeypatch, error):
    """Whether an error comes while it waits, or to who is told: then it is closed."""
    cancelled, futures = [], [Sent(0), Sent(1)]

    def next_batch(block):
        if error:
            raise error
        return [(futures[0], [7])]

    done = SimpleNamespace(update=lambda _: None, next_batch=next_batch)
    monkeypatch.setattr(distributed, "as_completed", lambda **_: done)
    monkeypatch.setattr(distributed, "futures_of", lambda _: futures)
    client = SimpleNamespace(status="running", nthreads=dict, persist=lambda _: None, cancel=cancelled.append)
    results = finishing._finished(client, None, lambda _: None, [0, 1])
    if error:
        with pytest.raises(error):
            next(results)
    else:
        assert next(results) == (0, 7)
        results.close()
    assert cancelled == [futures if error else futures[1:]]


class Sent:
    """A future of a task; what it gave was told before a restart of the workers forgot it."""

    status = "lost"

    def __init__(self, place):
        self.key = "bake", place


def check(limits):
    """Checks workers a and b that may use so many MiB."""
    workers = {name: {"memory_limit": limit and limit * MIB} for name, limit in zip("ab", limits, strict=False)}
    client = SimpleNamespace(scheduler_info=lambda **_: {"workers": workers})
    finishing.check_workers_of(client, SimpleNamespace(shared={}))


@pytest.mark.parametrize("limits", [(), (0,), (None,), (361,), (300, 361), (300, 0), (300, None)])
def test_one_worker_that_is_large_enough_or_without_a_limit_will_do(limits):
    check(limits)


@pytest.mark.parametrize("limits", [(300,), (200, 300), (359, 1)])
def test_workers_that_are_all_too_small_are_refused_by_the_largest(limits):
    """A process takes 288 MiB at least, and a worker pauses at 0.8 of its memory."""
    largest = f"{'ab'[limits.index(max(limits))]} may use {max(limits)} MiB"
    with pytest.raises(
        MemoryError, match=f"^the workers have too little memory: {largest}, want at least 360 MiB for each worker$"
    ):
        check(limits)
