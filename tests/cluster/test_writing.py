"""Calls that end early: nothing is at work for them afterwards, nothing is written, and what a handler raises comes out."""

import shutil
import signal
import threading
import time
from importlib import import_module

import numpy as np
import pytest

import warpsample as ws
from warpsample import cluster
from warpsample.host.files import WriteError
from warpsample.host.progress import asking, begin

dask = pytest.importorskip("dask")
pytest.importorskip("zarr")
baking, holdings, job, lock, metadata, store, writing = (
    import_module(f"warpsample.cluster.{name}")
    for name in ("baking", "holdings", "job", "lock", "metadata", "store", "writing")
)

POINTS = ws.SurfacePoints(np.zeros((30, 3)), np.tile(np.float32([0, 0, 1]), (30, 1)))


class Deadline(Exception):
    """What a user's handler raises."""


class Interrupt:
    """A signal, whose handler raises an error once."""

    def __init__(self, kind):
        self.kind, self.heard = kind, False

    def hear(self, *_):
        if not self.heard:
            self.heard = True
            raise self.kind("mine")

    def __call__(self):
        self.heard = False
        signal.raise_signal(signal.SIGALRM)

    def send(self):
        """Sends it to the main thread until that has heard it: one that comes as a thread goes to sleep does not wake it."""
        while not self.heard:
            signal.pthread_kill(threading.main_thread().ident, signal.SIGALRM)
            time.sleep(0.01)


@pytest.fixture(params=[KeyboardInterrupt, Deadline, TimeoutError, ValueError])
def interrupt(request):
    """Lets a handler raise one of several kinds."""
    found = Interrupt(request.param)
    before = signal.signal(signal.SIGALRM, found.hear)
    yield found
    signal.signal(signal.SIGALRM, before)


interrupt_said = pytest.raises((KeyboardInterrupt, Deadline, TimeoutError, ValueError), match="^mine$")


@pytest.fixture
def a_job(mesh):
    """Directions at points uniform by area: of three chunks."""
    return job.job_of("sample_directions", (30, 4), {}, 10, mesh)


def rows(fill):
    """What is written of a chunk."""
    return {"vectors": np.full((10, 4, 3), fill, np.float32)}


def files_of(path):
    """The content of all files, by their paths."""
    return {file.relative_to(path): file.read_bytes() for file in path.rglob("*") if file.is_file()}


def interrupting(monkeypatch, home, name, interrupt):
    """Lets an interrupt come when a function is called, the first time."""
    usual, left = getattr(home, name), [interrupt]

    def call(*arguments, **named):
        if left:
            left.pop()()
        return usual(*arguments, **named)

    monkeypatch.setattr(home, name, call)


def test_a_chunk_is_written_while_its_call_goes_on(path, a_job):
    store.begin(path, a_job, False, "path")
    with writing.writing(path) as folder:
        writing.write_chunk(folder, 1, (1,), (10,), rows(7.0))
        assert holdings.whole_chunks(path, ["vectors"]).tolist() == [False, True, False]
    assert list((path / ".run").glob("*-*")) == []
    with pytest.raises(WriteError, match=r"out\.zarr cannot be written: the call has ended, or the store was removed"):
        writing.write_chunk(folder, 2, (2,), (10,), rows(7.0))
    with pytest.raises(WriteError, match="the call has ended"), writing.at_work(folder):
        pass
    assert holdings.whole_chunks(path, ["vectors"]).tolist() == [False, True, False]


def test_a_store_that_is_made_in_the_place_of_another_gets_none_of_its_chunks(path, a_job):
    store.begin(path, a_job, False, "path")
    with writing.writing(path) as folder:
        shutil.rmtree(path)
        with pytest.raises(WriteError, match="the store was removed"):
            writing.write_chunk(folder, 0, (0,), (10,), rows(7.0))
        assert not path.exists()
        store.begin(path, a_job, False, "path")
        before = files_of(path)
        with writing.writing(path) as other:
            with pytest.raises(WriteError, match="the store was removed"):
                writing.write_chunk(folder, 0, (0,), (10,), rows(7.0))
            assert files_of(path) == before
            writing.write_chunk(other, 0, (0,), (10,), rows(8.0))
    assert holdings.whole_chunks(path, ["vectors"]).tolist() == [True, False, False]


def test_kernels_ask_after_each_batch_whether_they_are_wanted():
    asked = []
    with asking(lambda: asked.append(1)):
        done = begin(10, 10)
        done(1)
        done(2)
    assert asked == [1, 1]
    assert begin(10, 10) is None


@pytest.fixture
def ends(monkeypatch, interrupt):
    """How the computations of chunks began and ended: none does before its call has ended, which an interrupt does."""
    events = {"begun": [], "ended": []}

    def endless(*_):
        events["begun"].append(1)
        try:
            done = begin(1, 1)
            while True:
                interrupt.heard = False
                interrupt.send()
                for _ in range(1000):  # for seconds; then again, since a callback of a future's may have lost it
                    done(1)
                    time.sleep(0.002)
        except BaseException as error:
            events["ended"].append(type(error))
            raise

    monkeypatch.setattr(baking, "numbers", endless)
    return events


@pytest.mark.parametrize("threads", [1, 2])
def test_no_thread_is_at_work_when_a_call_has_ended(path, mesh, ends, threads):
    with dask.config.set(scheduler="threads", num_workers=threads), pytest.raises(BaseException) as caught:  # noqa: PT011
        cluster.bake(path, "sample_directions", 30, 4, mesh=mesh, chunk=10)
    assert str(caught.value) in ("mine", f"interrupted after 0 of 30 points; {path} can be resumed")
    assert writing._at_work == []
    assert set(ends["ended"]) == {WriteError}
    assert len(ends["ended"]) == len(ends["begun"]) <= threads
    assert not any(path.glob("*/c/*"))
    assert [file for file in path.parent.iterdir() if file != path] == []


def test_what_a_handler_raises_while_a_store_is_made_comes_out_and_nothing_is_left(path, a_job, monkeypatch, interrupt):
    interrupting(monkeypatch, store, "metadata_of", interrupt)
    with interrupt_said:
        store.begin(path, a_job, False, "path")
    assert list(path.parent.iterdir()) == [path]
    assert not holdings.whole_chunks(path, ["vectors"]).any()
    shutil.rmtree(path)
    with monkeypatch.context() as patch:
        interrupting(patch, lock, "_lock", interrupt)
        with interrupt_said, lock.locked(path):
            pass
    assert list(path.parent.iterdir()) == []


@pytest.mark.parametrize(
    ("home", "name"), [(holdings, "checksum_of"), (metadata.xr, "open_zarr"), (holdings.zarr, "open_group")]
)
@pytest.mark.parametrize("interrupt", [KeyboardInterrupt], indirect=True)
def test_an_interrupt_while_a_store_is_read_says_nothing_of_the_store(path, a_job, monkeypatch, interrupt, home, name):
    store.begin(path, a_job, False, "path")
    with writing.writing(path) as folder:
        for start in (0, 10, 20):
            writing.write_chunk(folder, start // 10, (start // 10,), (10,), {**rows(7.0), **others(start)})
    interrupting(monkeypatch, home, name, interrupt)
    with interrupt_said:
        store.begin(path, a_job, True, "path")
    assert store.begin(path, a_job, True, "path").all()


def others(start):
    """All arrays of a chunk but the vectors."""
    places = {"position": np.zeros((10, 3)), "normal": np.zeros((10, 3), np.float32), "face": np.zeros(10, np.int32)}
    return {**places, "status": np.zeros(10, np.uint8)}
