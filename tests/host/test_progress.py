"""Bars of long calls are shown where they are asked for and can be seen, and change no bit of a result."""

import os
import pty
import re
import subprocess
import sys
import threading
from contextlib import suppress
from io import StringIO

import numpy as np
import pytest
from hangs import HANGS
from rich.console import Console
from rich.progress import Progress

import warpsample as ws
from warpsample.host import engine, progress

MESH = ws.load_mesh("courtyard")
POINTS = ws.face_centers(MESH)
CALLS = {
    "ambient_occlusion": lambda **more: ws.ambient_occlusion(MESH, POINTS, 32, tolerance=0.1, **more).value,
    "sky_view_factor": lambda **more: ws.sky_view_factor(MESH, POINTS, 32, **more).value,
    "bent_normals": lambda **more: ws.bent_normals(MESH, POINTS, 32, **more).value,
    "irradiance": lambda **more: ws.irradiance(MESH, POINTS, np.ones((4, 8)), 32, **more).value,
    "trace": lambda **more: ws.trace(MESH, POINTS, np.array(POINTS.normal), **more).distance,
    "sample_directions": lambda **more: ws.sample_directions(POINTS, 32, **more).vectors,
}


@pytest.mark.parametrize("name", CALLS)
def test_nothing_is_printed_unless_asked_and_seen_and_no_bit_changes(name, capfd):
    plain = CALLS[name]()
    assert np.array_equal(CALLS[name](progress=True), plain)  # here there is no terminal
    assert capfd.readouterr() == ("", "")
    with pytest.raises(TypeError, match="^progress: got 1, want True or False"):
        CALLS[name](progress=1)


class Display:
    """Takes the place of rich's display and records what a bar is told."""

    live = property(lambda self: self)

    def stop(self):
        pass

    def __init__(self):
        self.total, self.done, self.runs = 0, 0, 0

    def __call__(self, *columns, **options):
        return self

    def __enter__(self):
        return self

    def __exit__(self, *error):
        pass

    def add_task(self, what, total):
        return what

    def reset(self, task, total):
        assert self.done == self.total
        self.total, self.done, self.runs = total, 0, self.runs + 1

    def advance(self, task, done):
        assert done > 0
        self.done += done


@pytest.mark.parametrize("workers", [1, 3])
@pytest.mark.parametrize("name", CALLS)
def test_a_bar_counts_all_work_whichever_thread_does_it(name, workers, monkeypatch):
    monkeypatch.setattr(progress, "LEAST_WORK", 1)
    monkeypatch.setattr(engine, "LEAST_WORK", 1)
    display = Display()
    monkeypatch.setattr("rich.progress.Progress", display)
    CALLS[name](workers=workers, progress=True)
    assert display.runs >= 1
    assert display.done == display.total > 0
    assert progress.begin(10, 10**9) is None


class Terminal:
    """Takes the place of stderr, and tells when something is written to it."""

    def __init__(self, is_terminal):
        self.isatty, self.text, self.written = lambda: is_terminal, "", threading.Event()

    def write(self, text):
        self.text += text
        self.written.set()

    def flush(self):
        pass


def test_a_terminal_shows_what_is_awaited(monkeypatch):
    terminal = Terminal(True)
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(progress, "_PATIENCE", 0.001)
    with progress.awaited("compiling"):
        assert terminal.written.wait(HANGS)
    assert terminal.text == "warpsample: compiling\n"


def test_what_ends_in_time_is_not_reported(monkeypatch):
    terminal, threads = Terminal(True), set(threading.enumerate())
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(progress, "_PATIENCE", HANGS)
    with progress.awaited("compiling"):
        (timer,) = set(threading.enumerate()) - threads
    timer.join(HANGS)
    assert not timer.is_alive()
    assert terminal.text == ""


@pytest.mark.parametrize("closed", [None, Terminal(False)])
def test_only_a_terminal_shows_it(closed, monkeypatch):
    threads = set(threading.enumerate())
    monkeypatch.setattr(sys, "stderr", closed)
    with progress.awaited("compiling"):
        assert set(threading.enumerate()) == threads


@pytest.mark.parametrize("notebook", [True, False])
def test_a_notebook_is_informed_where_a_bar_is_shown(notebook, monkeypatch):
    terminal, threads = Terminal(False), set(threading.enumerate())
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(progress, "_PATIENCE", 0.001)
    monkeypatch.setattr("rich.progress.Progress", Display())
    monkeypatch.setattr("rich.console._is_jupyter", lambda: notebook)
    with progress.bar(True, "casting rays"), progress.awaited("compiling"):
        assert terminal.written.wait(HANGS) if notebook else set(threading.enumerate()) == threads
    assert terminal.text == ("warpsample: compiling\n" if notebook else "")


@pytest.mark.slow
def test_a_terminal_shows_what_is_compiled_and_that_it_is_once(child_environment, tmp_path):
    code = """
from warpsample.host import progress
progress._PATIENCE = 0.0
import warpsample as ws
ws.sample_square("sobol", 1, 1)
"""
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path)}
    said = [on_a_terminal(code, environment) for _ in range(2)]
    assert re.fullmatch(r"warpsample: compiling the kernel square_blocks, once: it is kept in \S+\s+", said[0])
    assert str(tmp_path) in said[0]
    assert said[1] == ""


def on_a_terminal(code, environment):
    """What a Python program writes to a terminal."""
    master, slave = pty.openpty()
    running = subprocess.Popen([sys.executable, "-c", code], env=environment, stdin=slave, stdout=slave, stderr=slave)
    os.close(slave)
    text = b""
    with suppress(OSError):
        while part := os.read(master, 1 << 16):
            text += part
    os.close(master)
    assert running.wait() == 0
    return text.decode()


@pytest.mark.slow
def test_on_a_terminal_the_share_that_is_done_is_shown(child_environment):
    code = """
import rich.progress
import warp as wp, warpsample as ws
from warpsample.host import engine, progress
def advance_and_draw(self, task, done, advance=rich.progress.Progress.advance):
    advance(self, task, done)
    self.refresh()  # rich draws ten times a second, and how much is done in that time is the machine's
rich.progress.Progress.advance = advance_and_draw
wp.config.log_level = wp.LOG_WARNING
mesh = ws.load_mesh("courtyard")
points = ws.face_centers(mesh)
ws.ambient_occlusion(mesh, points, 256, workers=1)
print("quiet", flush=True)
engine.MOST_WORK, progress.LEAST_WORK = 1 << 17, 1
ws.ambient_occlusion(mesh, points, 8192, workers=1, skip=False, progress=True)
"""
    text = on_a_terminal(code, {**child_environment, "TERM": "xterm", "COLUMNS": "100"})
    before, after = text.split("quiet")
    assert "casting rays" not in before
    assert "casting rays" in after
    shares = {int(share) for share in re.findall(r"(\d+)%", after)}
    assert len(shares - {0, 100}) >= 3
    assert after.rindex("\x1b[?25h") > after.rindex("\x1b[?25l")


def test_a_bar_that_is_interrupted_while_it_starts_is_drawn_no_more():
    """Its thread drew it below the last message."""

    class Interrupted(Progress):
        def start(self):
            super().start()
            raise KeyboardInterrupt

    before, bar = set(threading.enumerate()), Interrupted(console=Console(file=StringIO(), force_terminal=True))
    with pytest.raises(KeyboardInterrupt), progress.run_display(bar):
        pytest.fail("the bar has started")
    for thread in set(threading.enumerate()) - before:
        thread.join(HANGS)
    assert set(threading.enumerate()) <= before
