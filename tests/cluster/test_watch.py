"""The bar of `warpsample bake` into a store: on stderr, if that is a terminal, and nowhere else."""

import io
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from warpsample.output.baked import BakeRun

pytest.importorskip("dask")
pytest.importorskip("zarr")
DONE = import_module("warpsample.cluster.baking").DONE
runs = import_module("warpsample.cluster.runs")

RUN = BakeRun(Path("courtyard"), Path("out.zarr"), "ao", None, 100, {"samples": 8, "up": (0.0, 0.0, 1.0)})


class Stream(io.StringIO):
    """What is written to a terminal, or to a file."""

    def __init__(self, terminal):
        super().__init__()
        self.terminal = terminal

    def isatty(self):
        return self.terminal


@pytest.fixture
def written(monkeypatch):
    """What a run of 100 points writes to stdout and stderr, each a terminal or not: 30 were there, 50 are made."""
    for name in ("FORCE_COLOR", "NO_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "200")
    monkeypatch.setattr(runs._Watch, "_seconds", lambda _: 1e-3)

    def watch(out, err):
        streams = Stream(out), Stream(err)
        with monkeypatch.context() as patch:
            patch.setattr(sys, "stdout", streams[0])
            patch.setattr(sys, "stderr", streams[1])
            with runs._Watch(RUN, 100) as watch:
                for told in ((30, 0, 0.0), (50, 7000, 0.5)):
                    watch.hear(np.array(told, DONE)[()])
        return [stream.getvalue() for stream in streams]

    return watch


def test_on_a_terminal_a_bar_tells_speed_and_error(written):
    out, err = written(out=False, err=True)
    assert out == ""
    assert "ambient occlusion" in err
    assert "7.0 million rays/s, standard error 0.1" in err  # 7,000 rays in a millisecond; the root of 0.5 / 50


@pytest.mark.parametrize("out", [False, True])
def test_elsewhere_nothing_is_written(written, out):
    assert written(out=out, err=False) == ["", ""]
