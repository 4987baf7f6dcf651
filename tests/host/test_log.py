"""What the environment sets for all calls, and what is logged of them."""

import logging
import subprocess
import sys

import numpy as np
import pytest

import warpsample as ws
from warpsample.city.rasters import tiles
from warpsample.host import engine


@pytest.mark.parametrize(("said", "count"), [("3", 3), (" 1 ", 1), ("1024", 1024), ("", None)])
def test_the_environment_says_how_many_threads(said, count, monkeypatch):
    cores = engine.check_workers(None)
    monkeypatch.setenv("WARPSAMPLE_WORKERS", said)
    assert engine.check_workers(None) == (count or cores)
    assert engine.check_workers(2) == 2  # what a call says counts for it


@pytest.mark.parametrize("said", ["0", "two", "-1", "1025", "2.5"])
def test_an_environment_without_sense_is_reported(said, monkeypatch):
    monkeypatch.setenv("WARPSAMPLE_WORKERS", said)
    with pytest.raises(
        (TypeError, ValueError), match=rf"WARPSAMPLE_WORKERS: got '?{said}'?, want a whole number from 1 to 1024"
    ):
        ws.sample_directions(np.eye(3, dtype=np.float32), 4)


@pytest.mark.slow
def test_a_tolerance_tells_its_count(caplog, points, bunny):
    with caplog.at_level(logging.INFO, "warpsample"):
        found = ws.ambient_occlusion(bunny, points, 4096, tolerance=0.05)
    assert {record.name for record in caplog.records} == {"warpsample"}
    (line,) = [message for message in caplog.messages if message.startswith("tolerance 0.05: ")]  # others are of kernels
    assert line.endswith(" of at most 4096 rays of each point")
    assert found.rays.max() < 4096


def test_tiles_are_reported(caplog):
    run = object.__new__(tiles.RasterRun)
    with caplog.at_level(logging.INFO, "warpsample"), pytest.raises(AttributeError):
        run.numbers((slice(0, 10), slice(20, 30)))  # of a run that has nothing
    assert caplog.messages == ["tile of rows 0 to 9, columns 20 to 29"]


@pytest.mark.thorough
def test_compiled_kernels_are_logged_and_nothing_is_heard_by_default(tmp_path, child_environment):
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path)}
    call = "import warpsample as ws, numpy as np; ws.sample_directions(np.eye(3, dtype=np.float32), 4)"
    heard = "import logging; logging.basicConfig(level='INFO', format='%(name)s %(message)s'); "
    given = {"env": environment, "capture_output": True, "text": True}
    first = subprocess.run([sys.executable, "-c", heard + call], **given, check=True).stderr
    assert "warpsample compiled the kernel direction_blocks for cpu in " in first
    assert subprocess.run([sys.executable, "-c", heard + call], **given, check=True).stderr == ""  # it is in the cache
    other = call.replace("4)", "4, distribution='ggx(alpha=0.5)')")
    assert subprocess.run([sys.executable, "-c", other], **given, check=True).stderr == ""


def test_help_says_what_the_package_is_for(call):
    status, out, _ = call("--help")
    assert status == 0
    assert "Sample directions at points of 3D models" in " ".join(out.split())
