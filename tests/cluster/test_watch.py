"""The bar of `warpsample bake` into a store: on stderr, if that is a terminal, and nowhere else."""

import io
import sys

import numpy as np
import pytest

from warpsample.output import run_record


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
    monkeypatch.setattr(run_record, "perf_counter", lambda: 1e-3)

    def watch(out, err):
        streams = Stream(out), Stream(err)
        with monkeypatch.context() as patch:
            patch.setattr(sys, "stdout", streams[0])
            patch.setattr(sys, "stderr", streams[1])
            record = run_record.RunRecord("ambient occlusion")
            record._start, record._first = 0.0, 0.0
            with record.show("reading courtyard"), record.count(100, "it can be resumed"):
                record.skip(30)
                record._first = 0.0
                record.add(np.array((50, 7000, 50, 0.5, 25.0, 0.0, 1.0, ""), run_record.SUMMARY)[()])
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


def test_parts_that_miss_the_tolerance_are_reported_once():
    """Each process would warn once itself; so a part carries the message to the command."""
    record, part = run_record.RunRecord("ambient occlusion"), run_record.EMPTY.copy()
    record.add(part, 1)
    part["missed"] = "tolerance: got 1e-06"
    with pytest.warns(UserWarning, match="^tolerance: got 1e-06$"):
        record.add(part, 1)
    record.add(part, 1)  # a second warning is an error
    record.add(run_record.EMPTY, 1)
    assert record.done == 4


@pytest.mark.slow
def test_a_store_whose_chunks_miss_the_tolerance_warns_once(call, tmp_path):
    command = ("bake", "courtyard", "-o", tmp_path / "out.zarr", "--points", 100, "--chunk", 40, "--samples", 16)
    with pytest.warns(UserWarning, match="^tolerance: got 1e-06, which is not reached with 16 rays") as heard:
        assert call(*command, "--tolerance", "1e-6")[0] == 0
    assert len(heard) == 1
