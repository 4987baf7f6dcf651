"""Child processes that are interrupted at random, torn from an import or forked within a call: they end, and say so."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hangs import HANGS


@pytest.mark.thorough
def test_two_thousand_interrupts_of_all_kinds_of_calls(child_environment):
    """In a process of its own, since it may crash."""
    script = Path(__file__).parents[1] / "support" / "interrupted.py"
    command = [sys.executable, "-X", "faulthandler", str(script), "2000"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=HANGS, env=child_environment, check=False)
    assert done.returncode == 0, done.stderr[-4000:]


@pytest.mark.parametrize(
    ("count", "seed"), [pytest.param(15, 1, marks=pytest.mark.slow), pytest.param(75, 2, marks=pytest.mark.thorough)]
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
