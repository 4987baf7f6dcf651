"""Calls that are interrupted leave nothing behind: no thread at work, no launch half-changed."""

import signal
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import warp as wp
from hangs import HANGS, send_one
from warp._src.context import pack_arg

import warpsample as ws
from warpsample.host import engine

pytestmark = pytest.mark.usefixtures("handlers_as_before")

CPU = wp.get_device("cpu")
MUCH = 10**9  # work, so that threads share it
TASKS = 12
HOST = str(Path(engine.__file__).parent)


@wp.kernel(enable_backward=False, grid_stride=False)
def _count(out: wp.array[wp.int32], first_task: wp.int64):
    out[wp.int32(first_task) + wp.tid()] += 1


@wp.kernel(enable_backward=False, grid_stride=False)
def _add(out: wp.array[wp.int32], step: wp.uint64, first_task: wp.int64):
    out[wp.int32(first_task) + wp.tid()] += wp.int32(step)


def count(out, workers, work=MUCH):
    """Adds 1 to each number of an array, a task for each."""
    engine.run(_count, len(out), [wp.array(out, device=CPU, copy=False)], CPU, workers=workers, work=work)


class Interrupter:
    """Lets one exception come up in a call, after so many steps of the functions that are watched."""

    def __init__(self, watched, steps, interrupt, at):
        self.watched, self.steps, self.interrupt, self.left = watched, steps, interrupt, at

    def run(self, call):
        """Whether there were that many steps; else the call went through."""
        before = sys.gettrace()
        try:
            sys.settrace(self.enter)
            call()
        except KeyboardInterrupt:
            assert self.left < 0
        finally:
            sys.settrace(before)
        return self.left < 0

    def enter(self, frame, _event, _value):
        if not self.watched(frame.f_code):
            return None
        frame.f_trace_lines, frame.f_trace_opcodes = self.steps == "line", self.steps == "opcode"
        return self.step

    def step(self, _frame, event, _value):
        if event == self.steps:
            self.left -= 1
            if self.left == -1:
                self.interrupt()
        return self.step


def raise_one():
    raise KeyboardInterrupt


def ours(code):
    return code.co_filename.startswith(HOST)


def ours_but_deferral(code):
    """Deferral of signals is for what handlers raise."""
    return ours(code) and not code.co_filename.endswith("interrupts.py")


@pytest.mark.parametrize(("interrupt", "watched"), [(raise_one, ours_but_deferral), (send_one, ours)])
@pytest.mark.parametrize("steps", ["line", pytest.param("opcode", marks=pytest.mark.slow)])
def test_at_whatever_step_it_is_interrupted_a_call_outlasts_its_threads(steps, interrupt, watched, monkeypatch):
    """The threads write to arrays that may no longer exist after the call."""
    caller, helped, late = threading.current_thread(), [], []
    state = {"ended": True}

    def done(_):
        if threading.current_thread() is not caller and not state["ended"]:
            time.sleep(0.002)
            (late if state["ended"] else helped).append(threading.get_ident())

    monkeypatch.setattr(engine, "begin", lambda *_: done)
    reached, at = True, 0
    while reached:
        state["ended"] = False
        reached = Interrupter(watched, steps, interrupt, at).run(lambda: count(np.zeros(TASKS, np.int32), 3))
        state["ended"] = True
        time.sleep(0.003)  # for a thread that is still at work
        out = np.zeros(TASKS, np.int32)
        count(out, 3)
        assert (out == 1).all()
        at += 1
    assert late == []
    assert len(helped) > 1
    assert at > 50
    with pytest.raises(KeyboardInterrupt):
        send_one()


def test_however_often_it_is_interrupted_a_call_outlasts_its_threads(monkeypatch):
    begun, ended = threading.Event(), []
    main = threading.main_thread()

    def done(_):
        if threading.current_thread() is main:
            begun.wait(HANGS)
        else:
            begun.set()
            for _ in range(50):
                signal.pthread_kill(main.ident, signal.SIGINT)
                time.sleep(0.001)
            ended.append(True)

    monkeypatch.setattr(engine, "begin", lambda *_: done)
    with pytest.raises(KeyboardInterrupt):
        count(np.zeros(TASKS, np.int32), 2)
    assert ended == [True]


def test_a_launch_that_was_interrupted_while_it_changed_is_not_used_again():
    """It would be of another size than it says, and write beyond the arrays."""
    many, few = np.zeros(1000, np.int32), 3
    reached, at = True, 0
    while reached:
        count(many, 1)
        interrupter = Interrupter(lambda code: code is wp.Launch.set_dim.__code__, "line", raise_one, at)
        reached = interrupter.run(lambda: count(many[:few], 1))
        many[:] = 0
        count(many[:few], 1)
        assert (many[:few] == 1).all()
        assert not many[few:].any()
        at += 1
    assert at > 5


def test_what_a_handler_raises_while_a_launch_is_made_comes_out_as_it_is():
    """Warp makes a RuntimeError of whatever is raised while it packs an argument."""

    def late(*_):
        raise TimeoutError("mine")

    def call():
        try:
            engine.run(_add, TASKS, [wp.zeros(TASKS, wp.int32, device=CPU), 3], CPU, workers=1, work=TASKS)
        except TimeoutError:
            raise KeyboardInterrupt from None  # as `Interrupter` expects it

    signal.signal(signal.SIGINT, late)
    packing = {wp.Launch.set_param_at_index.__code__, pack_arg.__code__}
    reached, at = True, 0
    while reached:
        reached = Interrupter(packing.__contains__, "line", send_one, at).run(call)
        at += 1
    assert at > 10


@pytest.mark.parametrize("kind", ["vec", "array"])
def test_an_interrupt_while_an_argument_is_made_is_a_keyboard_interrupt(kind):
    """ctypes makes a RuntimeError of any exception that is raised while it makes a vector of a tuple."""

    def call():
        if kind == "vec":
            ws.view_factors(mesh, 4, up=(0.0, 0.0, 1.0), workers=1)
        else:
            ws.sample_surface(mesh, 4, spacing="blue", workers=1)

    mesh = ws.as_mesh((np.eye(3), [[0, 1, 2]]))
    call()
    made = {"vec": type(wp.vec3()).__init__.__code__, "array": wp.array._init_from_data.__code__}[kind]
    reached, at = True, 0
    while reached:
        reached = Interrupter(made.__eq__, "line", send_one, at).run(call)
        at += 1
    assert at > 5


# What is not interrupted
