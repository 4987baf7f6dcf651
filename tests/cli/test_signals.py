"""A command that a signal ends leaves no half file, hidden cursor or process; one sentence says so, and 128 + the signal."""

import os
import pty
import re
import signal
import subprocess
import sys
import time
from contextlib import suppress

import psutil
import pytest
from child_jobs import no_end
from hangs import HANGS

from warpsample.bench.running.child import Child

SIGNALS = ["SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT"]
HIDE, SHOW = "\x1b[?25l", "\x1b[?25h"


def mostly_slow(*quick):
    """The signals for pytest; those that the same code handles are slow tests."""
    return [name if name in quick else pytest.param(name, marks=pytest.mark.slow) for name in SIGNALS]


def sentence(name):
    return f"interrupted{'' if name == 'SIGINT' else f' by {name}'}; nothing was written"


def until(condition):
    """Waits until a condition holds, and returns its value."""
    end = time.monotonic() + HANGS
    while not (found := condition()):
        assert time.monotonic() < end
        time.sleep(0.01)
    return found


def size_of(path):
    """The size of a file in bytes, and 0 for a file that is removed while it is looked at."""
    with suppress(FileNotFoundError):
        return path.stat().st_size
    return 0


def read(master, word=None):
    """The output on a terminal up to a word, or until its programs end."""
    text = b""
    with suppress(OSError):
        while (word is None or word.encode() not in text) and (part := os.read(master, 1 << 16)):
            text += part
    return text.decode()


def start(environment, *arguments, **streams):
    """The command in its own session, like the programs of a terminal."""
    command = [sys.executable, "-m", "warpsample", *map(str, arguments)]
    return subprocess.Popen(command, env={**environment, "TERM": "xterm"}, start_new_session=True, text=True, **streams)


@pytest.fixture(autouse=True)
def heard():
    """What a shell starts in the background ignores some signals, and so would all commands that it starts."""
    ignored = [number for name in SIGNALS if signal.getsignal(number := getattr(signal, name)) == signal.SIG_IGN]
    for number in ignored:
        signal.signal(number, signal.SIG_DFL)
    yield
    for number in ignored:
        signal.signal(number, signal.SIG_IGN)


@pytest.fixture
def writing(cube, tmp_path):
    """Arguments that write hundreds of megabytes, and a test whether half of them is written."""
    output = tmp_path / "d.npz"
    output.write_text("old")
    arguments = ["directions", cube, "-o", output, "--points", 500_000, "--samples", 256]
    yield arguments, lambda: max(map(size_of, tmp_path.glob(".d*")), default=0) > 1_000_000
    assert output.read_text() == "old"
    assert {path.name for path in tmp_path.iterdir()} == {"cube.ply", "d.npz"}


@pytest.mark.thorough
@pytest.mark.parametrize("name", mostly_slow("SIGTERM"))
def test_on_a_terminal_the_half_file_goes_and_the_cursor_comes_back(name, writing, child_environment):
    arguments, half = writing
    master, slave = pty.openpty()
    running = start(child_environment, *arguments, stdin=slave, stdout=slave, stderr=slave)
    os.close(slave)
    assert HIDE in read(master, HIDE)
    until(half)
    os.killpg(running.pid, getattr(signal, name))
    shown = read(master)
    os.close(master)
    assert running.wait() == 128 + getattr(signal, name)
    assert SHOW in shown
    assert re.search(
        rf"({sentence(name)}|interrupted after .* of 500,000 points; .*d.npz is as it was before)$", shown.rstrip()
    )
    assert "Traceback" not in shown


@pytest.mark.slow
def test_a_terminal_that_is_closed_leaves_no_half_file(writing, child_environment):
    """A closed terminal sends SIGHUP, and every later write to it fails."""
    arguments, half = writing
    master, slave = pty.openpty()
    running = start(child_environment, *arguments, stdin=slave, stdout=slave, stderr=slave)
    os.close(slave)
    read(master, HIDE)
    until(half)
    os.close(master)
    running.send_signal(signal.SIGHUP)
    assert running.wait(HANGS) == 128 + signal.SIGHUP


@pytest.mark.slow
def test_in_a_pipe_it_is_one_sentence(writing, child_environment):
    arguments, half = writing
    running = start(child_environment, *arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    until(half)
    running.send_signal(signal.SIGTERM)
    out, err = running.communicate(timeout=HANGS)
    assert (running.returncode, out) == (128 + signal.SIGTERM, "")
    assert [line for line in err.splitlines() if "CUDA" not in line] == [sentence("SIGTERM")]


WHILE_IMPORTING = """
import os, signal, sys

class Finder:
    def find_spec(name, path=None, target=None):
        if name == {module!r}:
            os.kill(os.getpid(), signal.{name})

sys.meta_path.insert(0, Finder)
sys.argv = ["warpsample", "info", {cube!r}]
from warpsample.cli import main
main()
"""


def end_while_importing(name, module, cube, environment, **ignored):
    script = WHILE_IMPORTING.format(name=name, module=module, cube=str(cube))
    command = [sys.executable, "-c", script]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, **ignored)


@pytest.mark.parametrize(
    ("name", "module"), [*((name, "warp") for name in SIGNALS), ("SIGINT", "numpy"), ("SIGINT", "typer")]
)
def test_in_the_first_second_it_is_one_sentence(name, module, cube, child_environment):
    """At that time only the module that hears signals is imported."""
    done = end_while_importing(name, module, cube, child_environment)
    assert (done.returncode, done.stdout, done.stderr) == (128 + getattr(signal, name), "", sentence(name) + "\n")


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["SIGHUP", pytest.param("SIGINT", marks=pytest.mark.thorough)])
def test_what_the_parent_ignores_stays_ignored(name, cube, child_environment):
    """`nohup` and the background jobs of a shell rely on this."""
    number = getattr(signal, name)
    done = end_while_importing(
        name, "warp", cube, child_environment, preexec_fn=lambda: signal.signal(number, signal.SIG_IGN)
    )
    assert done.returncode == 0
    assert "12" in done.stdout


def listen(body, environment):
    script = f"import os, signal, time\nfrom warpsample.cli.signals import listening\nwith listening():\n{body}"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=HANGS)
    return done.returncode, done.stdout, done.stderr


def test_a_second_signal_does_not_break_the_cleaning_up(child_environment):
    body = """
    try:
        os.kill(os.getpid(), signal.SIGTERM)
    finally:
        for again in (signal.SIGINT, signal.SIGTERM, signal.SIGQUIT):
            os.kill(os.getpid(), again)
            time.sleep(0.3)
        print("cleaned")
"""
    assert listen(body, child_environment) == (143, "cleaned\n", sentence("SIGTERM") + "\n")


@pytest.mark.slow
def test_a_signal_after_the_output_is_complete_says_that_it_was_written(child_environment, tmp_path):
    """The sentence was that nothing was written, while a report was computed."""
    body = f"""
    from warpsample.host.files import write_bytes
    from pathlib import Path
    write_bytes(Path({str(tmp_path / "a.ply")!r}), b"new")
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep({HANGS})
"""
    assert listen(body, child_environment) == (143, "", f"interrupted by SIGTERM; {tmp_path / 'a.ply'} was written\n")


def test_one_that_python_drops_is_raised_again(child_environment):
    """Python drops an exception raised while an object is deleted, or in a callback of VTK."""
    body = f"""
    class Dropping:
        def __del__(self):
            os.kill(os.getpid(), signal.SIGTERM)
            time.sleep(0.01)
    Dropping()
    time.sleep({HANGS})
    print("unheard")
"""
    status, out, err = listen(body, child_environment)
    assert (status, out) == (143, "")
    assert err.endswith(sentence("SIGTERM") + "\n")


@pytest.mark.parametrize("name", SIGNALS)
def test_while_a_window_is_open_a_signal_ends_it_at_once(name, child_environment):
    """VTK's event loop runs no Python while idle; afterwards signals are handled as before."""
    body = f"""
    from warpsample.cli.signals import at_once
    with at_once():
        {{}}
    os.kill(os.getpid(), signal.{name})
"""
    number = getattr(signal, name)
    assert listen(body.format(f"os.kill(os.getpid(), signal.{name})"), child_environment) == (-number, "", "")
    assert listen(body.format("pass"), child_environment) == (128 + number, "", sentence(name) + "\n")


@pytest.mark.thorough
@pytest.mark.parametrize(
    "name", ["SIGTERM", *(pytest.param(other, marks=pytest.mark.thorough) for other in ("SIGINT", "SIGHUP"))]
)
def test_the_processes_of_verify_end_with_it(name, child_environment):
    """The signal goes to the whole group, as from a terminal, or to the parent alone; no child may print anything."""
    running = start(child_environment, "verify", stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    children = until(lambda: psutil.Process(running.pid).children())
    send = running.send_signal if name == "SIGTERM" else lambda number: os.killpg(running.pid, number)
    time.sleep(0.3)
    send(getattr(signal, name))
    out, err = running.communicate(timeout=HANGS)
    assert (running.returncode, out) == (128 + getattr(signal, name), "")
    assert [line for line in err.splitlines() if "CUDA" not in line] == [sentence(name)]
    _, alive = psutil.wait_procs(children, timeout=HANGS)
    assert alive == []


def test_a_benchmarks_child_ends_when_the_parent_is_interrupted(tmp_path):
    """The child is then in the middle of its work."""
    child = Child(no_end, at_work=str(tmp_path / "at work"))
    until((tmp_path / "at work").exists)
    running = psutil.Process(child.process.pid)
    child.__exit__(KeyboardInterrupt, KeyboardInterrupt(), None)
    assert not running.is_running()
