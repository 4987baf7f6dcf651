"""Progress bars of long calls: shown if requested and visible, without changing a bit of the result."""

import os
import pty
import re
import subprocess
import sys
from contextlib import suppress

import numpy as np
import pytest

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
    """Records the steps of a bar."""

    def __init__(self):
        self.total, self.done, self.runs = 0, 0, 0

    def reset(self, task, total):
        assert self.done == self.total
        self.total, self.done, self.runs = total, 0, self.runs + 1

    def advance(self, task, done):
        assert done > 0
        self.done += done


@pytest.mark.parametrize("workers", [1, 3])
@pytest.mark.parametrize("name", CALLS)
def test_a_bar_is_told_of_all_work_whichever_thread_does_it(name, workers, monkeypatch):
    monkeypatch.setattr(progress, "_LEAST_WORK", 1)
    monkeypatch.setattr(engine, "_LEAST_WORK", 1)
    display = Display()
    token = progress._shown.set((display, 0))
    try:
        CALLS[name](workers=workers)
    finally:
        progress._shown.reset(token)
    assert display.runs >= 1
    assert display.done == display.total > 0
    assert progress.begin(10, 10**9) is None


@pytest.mark.slow
def test_on_a_terminal_the_share_that_is_done_is_shown(child_environment):
    code = """
import warp as wp, warpsample as ws
from warpsample.host import engine
from warpsample.host import progress
wp.config.log_level = wp.LOG_WARNING
mesh = ws.load_mesh("courtyard")
points = ws.face_centers(mesh)
ws.ambient_occlusion(mesh, points, 256, workers=1)
print("quiet", flush=True)
engine._MOST_WORK, progress._LEAST_WORK = 1 << 17, 1
for _ in range(5):
    ws.ambient_occlusion(mesh, points, 8192, workers=1, skip=False, progress=True)
"""
    master, slave = pty.openpty()
    environment = {**child_environment, "TERM": "xterm", "COLUMNS": "100"}
    running = subprocess.Popen([sys.executable, "-c", code], env=environment, stdin=slave, stdout=slave, stderr=slave)
    os.close(slave)
    text = b""
    with suppress(OSError):
        while part := os.read(master, 1 << 16):
            text += part
    os.close(master)
    assert running.wait() == 0
    before, after = text.decode().split("quiet")
    assert "casting rays" not in before
    assert "casting rays" in after
    shares = {int(share) for share in re.findall(r"(\d+)%", after)}
    assert len(shares - {0, 100}) >= 3
    assert after.rindex("\x1b[?25h") > after.rindex("\x1b[?25l")
