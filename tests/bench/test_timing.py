"""Timings are interleaved and warmed up; children run jobs; the machine is known. No test asserts a time."""

import platform
import re
import subprocess
from time import sleep

import child_jobs
import pytest
import warp as wp

import warpsample
from warpsample.bench.rows import Spread
from warpsample.bench.running import timing
from warpsample.bench.running.child import Child
from warpsample.bench.running.machine import describe_machine, find_commit, measure_peak_megabytes


def test_rounds_are_interleaved_and_each_timed_run_follows_one_of_its_kind(monkeypatch):
    monkeypatch.setattr(timing, "WARM_UP", 0.0)
    calls = []
    cases = {
        "a": timing.build_stopwatch(lambda: calls.append("a")),
        "b": timing.build_stopwatch(lambda: calls.append("b"), warm=lambda: None),
    }
    seconds = timing.run_interleaved(cases, 2)
    assert calls == ["a", "a", "b"] * 2
    assert [(case, len(t)) for case, t in seconds.items()] == [("a", 2), ("b", 2)]


def test_short_work_is_warmed_up_for_a_while(monkeypatch):
    monkeypatch.setattr(timing, "WARM_UP", 0.01)
    calls = []
    assert timing.build_stopwatch(lambda: calls.append(sleep(0.001)))() >= 0.001
    assert 2 <= len(calls) <= 11  # once is enough if it takes long


def test_beyond_the_budget_three_rounds_are_enough():
    assert timing.run_interleaved({"a": lambda: 1.0}, 9, budget=-1.0) == {"a": [1.0] * 3}


def test_a_spread_is_the_median_and_the_middle_half():
    assert Spread.of([5.0, 1.0, 2.0, 100.0, 3.0]) == Spread(3.0, 2.0, 5.0)
    assert Spread.of([4.0]) == Spread(4.0, 4.0, 4.0)
    assert Spread.of_ratios([1.0, 4.0, 9.0], [1.0, 2.0, 3.0]) == Spread(2.0, 1.5, 2.5)


@pytest.mark.thorough
def test_a_child_runs_its_job_and_reports():
    with Child(child_jobs.loud) as one:
        assert one.wait_until_built() is None
        assert one.run() >= 0.0
        assert one.report() == {"answer": 42}


@pytest.mark.thorough
def test_a_child_without_a_job_says_why():
    with Child(child_jobs.hopeless) as one:
        assert one.wait_until_built() == "not installed: pip install no_such_library"
        with pytest.raises(RuntimeError, match="no_such_library"):
            one.run()
    with Child(child_jobs.elsewhere) as one:
        assert one.wait_until_built() == "not installed: pip install xarray-spatial"
    with Child(child_jobs.dying) as one:
        assert one.wait_until_built() == "its process ended with status 3"
    with Child(child_jobs.mortal) as one:
        assert one.wait_until_built() is None
        with pytest.raises(RuntimeError, match="child_jobs:mortal: its process ended with status 4"):
            one.run()


def test_the_commit_is_that_of_the_checkout_or_unknown(tmp_path):
    assert re.fullmatch(r"[0-9a-f]{12}(\+changes)?|unknown", describe_machine().commit)
    copy = tmp_path / "warpsample"
    copy.mkdir()
    (copy / "a.py").touch()
    assert find_commit(copy) == "unknown"  # no checkout
    git = ["git", "-C", tmp_path, "-c", "user.name=x", "-c", "user.email=x@example.org"]
    subprocess.run([*git, "init", "-q"], check=True)
    subprocess.run([*git, "add", "."], check=True)
    subprocess.run([*git, "commit", "-q", "-m", "x"], check=True)
    assert re.fullmatch("[0-9a-f]{12}", find_commit(copy))
    (copy / "bench" / "results").mkdir(parents=True)
    (copy / "bench" / "results" / "a.json").touch()
    assert re.fullmatch("[0-9a-f]{12}", find_commit(copy))  # what is measured is not what measures
    (copy / "a.py").write_text("changed")
    assert find_commit(copy).endswith("+changes")
    installed = tmp_path / "venv" / "warpsample"
    installed.mkdir(parents=True)
    (installed / "b.py").touch()
    assert find_commit(installed) == "unknown"  # within a checkout of something else


def test_the_machine_is_known():
    machine = describe_machine()
    assert machine.warpsample == warpsample.__version__
    assert machine.instructions == machine.instructions.lower()
    assert machine.cores >= 1
    assert str(machine).startswith(machine.cpu)
    assert measure_peak_megabytes() > 50.0


def test_what_the_compiler_is_denied_is_none_of_the_instructions(monkeypatch):
    monkeypatch.setattr(wp.config, "cpu_compiler_flags", "-march=native -target-feature -avx512f -target-feature -avx2")
    assert describe_machine().instructions == platform.machine().lower()
