"""Calls that are interrupted leave nothing behind: no thread at work, no lock taken, no launch half-changed."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import warp as wp
from hangs import HANGS
from warp._src.context import pack_arg

import warpsample as ws
from warpsample.host import engine
from warpsample.host.arguments import naming_file
from warpsample.host.interrupts import uninterrupted
from warpsample.host.locks import making, once

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


@pytest.fixture(autouse=True)
def handlers_as_before():
    """Nor is an event loop told of signals that another test left: nobody reads its pipe, which some hundreds fill."""
    before, pipe = signal.signal(signal.SIGINT, signal.default_int_handler), signal.set_wakeup_fd(-1)
    yield
    signal.signal(signal.SIGINT, before)
    signal.set_wakeup_fd(pipe, warn_on_full_buffer=False)


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


def send_one():
    """Python calls the handler before the function ends."""
    signal.raise_signal(signal.SIGINT)


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


def test_what_is_made_once_is_made_to_its_end():
    made = []

    @once
    def twice(x):
        send_one()
        made.append(x)
        return 2 * x

    with pytest.raises(KeyboardInterrupt):
        twice(3)
    assert made == [3]
    assert twice(3) == 6
    assert made == [3]
    free = []
    other = threading.Thread(target=lambda: free.append(making.acquire(blocking=False) and not making.release()))
    other.start()
    other.join()
    assert free == [True]


def test_a_users_handler_is_called_at_once_and_put_back():
    heard, stopped = [], []

    def handler(number, frame):
        heard.append(frame.f_code.co_name)
        if len(heard) > 1:
            raise TimeoutError(len(heard))

    def work():
        for _ in range(3):
            send_one()
        return len(heard), len(stopped)

    signal.signal(signal.SIGINT, handler)
    with pytest.raises(TimeoutError, match="2"):
        uninterrupted(work, stop=lambda: stopped.append(True))
    assert heard == ["send_one"] * 3
    assert stopped == [True] * 2
    assert signal.getsignal(signal.SIGINT) is handler
    heard.clear()
    assert uninterrupted(send_one) is None  # a handler that raises nothing interrupts nothing
    assert signal.getsignal(signal.SIGINT) is handler


def test_what_a_handler_raises_may_count_as_false():
    class Problems(Exception):
        def __len__(self):
            return 0

    def handler(*_):
        raise Problems

    signal.signal(signal.SIGINT, handler)
    with pytest.raises(Problems):
        uninterrupted(send_one)


def test_a_handler_that_another_one_has_set_stays():
    def handler(*_):
        signal.signal(signal.SIGINT, signal.SIG_IGN)

    signal.signal(signal.SIGINT, handler)
    uninterrupted(send_one)
    assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN


def test_an_error_of_the_work_is_not_lost():
    def work():
        send_one()
        raise OSError("no room")

    with pytest.raises(KeyboardInterrupt) as interrupt:
        uninterrupted(work)
    assert str(interrupt.value.__context__) == "no room"


@pytest.mark.thorough
def test_two_thousand_interrupts_of_all_kinds_of_calls(child_environment):
    """In a process of its own, since it may crash."""
    script = Path(__file__).parents[1] / "support" / "interrupted.py"
    command = [sys.executable, "-X", "faulthandler", str(script), "2000"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=HANGS, env=child_environment, check=False)
    assert done.returncode == 0, done.stderr[-4000:]


@pytest.mark.parametrize(
    ("count", "seed"), [pytest.param(30, 1, marks=pytest.mark.slow), pytest.param(75, 2, marks=pytest.mark.thorough)]
)
def test_random_interrupts_leave_no_thread_and_no_half_file(count, seed, child_environment):
    """Directions, occlusion, view factors, a file and a store are interrupted; see the script."""
    script = Path(__file__).parents[1] / "support" / "random_interrupts.py"
    command = [sys.executable, "-X", "faulthandler", str(script), str(count), str(seed)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=HANGS, env=child_environment, check=False)
    assert done.returncode == 0, done.stderr[-4000:]


FORK = """
import os, threading
from warpsample.host import sharing

begun, go, parent, children = threading.Event(), threading.Event(), os.getpid(), []

def own():
    begun.wait()
    children.append(os.fork())  # as a signal's handler may; the child goes on within the call
    go.set()

def other():
    begun.set()
    go.wait()

try:
    sharing.share([own, other], stop=lambda: None)
except RuntimeError as error:
    os._exit(7 if os.getpid() != parent and "forked during a call" in str(error) else 1)
print(os.waitstatus_to_exitcode(os.waitpid(children[0], 0)[1]))
"""


IMPORTED = """
import os, signal, sys, threading
import warpsample as ws

class Stop(Exception):
    pass

class Finder:
    def find_spec(self, name, *rest):
        if name == sys.argv[1] and at.pop(0):
            arrived()

def stop(number, frame):
    raise Stop

at = [True, *100 * [False]]
signal.signal(signal.SIGALRM, stop)
sys.meta_path.insert(0, Finder())
"""
"""A child in which `arrived` is called as a module of a name begins to be imported."""
STOPPED = """
def arrived():
    signal.raise_signal(signal.SIGALRM)

stopped = 0
try:
    ws.load_mesh("courtyard")
    ws.face_centers(ws.load_mesh("courtyard"))
except Stop as error:
    stopped = 1 + (error.__context__ is not None)
print(stopped, len(ws.face_centers(ws.load_mesh("courtyard"))), file=sys.stderr)
"""
FORKED = """
def arrived():
    begun.set()
    forked.wait(2.0)  # which it is only where no fork waits for imports
    logging.getLogger("imported")  # takes a lock that a fork takes, too

import logging
begun, forked = threading.Event(), threading.Event()
thread = threading.Thread(target=lambda: ws.load_mesh)
thread.start()
begun.wait()
child = os.fork()
if child == 0:
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(int(sys.argv[2]))
    os._exit(len(ws.load_mesh("courtyard").faces) % 251)
forked.set()
thread.join()
print(os.waitpid(child, 0)[1] >> 8, file=sys.stderr)
"""


def says(code, environment, *arguments):
    command = [sys.executable, "-c", IMPORTED + code, *arguments]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return done.stderr.splitlines()[-1]


@pytest.mark.slow
@pytest.mark.parametrize("module", ["numpy.linalg", "warp._src.types", "warpsample.mesh.mesh", "warpsample.mesh.surface"])
def test_an_import_is_not_torn_apart(module, child_environment):
    """NumPy and Warp cannot be imported again where they were torn; what a handler raises comes out as it is."""
    assert says(STOPPED, child_environment, module) == "1 2080"


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_fork_waits_for_an_import(child_environment):
    assert says(FORKED, child_environment, "warpsample.mesh.mesh", str(int(HANGS))) == str(2080 % 251)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_child_that_is_forked_within_a_call_says_so(child_environment):
    """The threads that have a part of the call are not there: it would wait for them forever, or miss what they did."""
    command = [sys.executable, "-W", "ignore", "-c", FORK]
    said = subprocess.run(command, env=child_environment, capture_output=True, text=True, check=True, timeout=HANGS)
    assert said.stdout == "7\n"


def test_a_deadline_is_no_damaged_file(tmp_path):
    file = tmp_path / "large.ply"
    file.write_text("ply")

    def late(*_):
        raise TimeoutError("my deadline")

    signal.signal(signal.SIGINT, late)
    with pytest.raises(TimeoutError, match="^my deadline$"), naming_file("path", file, "a mesh"):
        send_one()
    with pytest.raises(ValueError, match="line 4"), naming_file("path", file, "a mesh"):
        raise ValueError("line 4")
