"""Each benchmark runs, says what it should, and measures what it says. No test asserts a time."""

import json
import re
import sys
from itertools import chain
from time import sleep

import numpy as np
import pytest
from bench_output import lines_of, not_blank, run_command
from scipy.stats import norm

import warpsample as ws
from warpsample.bench import child, directions, error, machine, peer_jobs, peers, plots, report, scaling, startup, timing
from warpsample.bench.integrands import INTEGRANDS, evaluate
from warpsample.bench.timing import Spread

pytestmark = pytest.mark.slow  # peers and timers, in processes of their own

STARTS = [startup.Startup("cold", 0.5, 0.1, 2.0, 0.5)]


# Timing


def test_rounds_are_interleaved_and_each_timed_run_follows_one_of_its_kind(monkeypatch):
    monkeypatch.setattr(timing, "_WARM_UP", 0.0)
    calls = []
    cases = [timing.stopwatch(lambda: calls.append("a")), timing.stopwatch(lambda: calls.append("b"), warm=lambda: None)]
    times, beside = timing.interleave(cases, 2, reference=lambda: calls.append("r") or 1.0)
    assert calls == ["a", "a", "r", "b", "r"] * 2
    assert [len(t) for t in times] == [2, 2]
    assert beside == [[1.0, 1.0]] * 2


def test_short_work_is_warmed_up_for_a_while(monkeypatch):
    monkeypatch.setattr(timing, "_WARM_UP", 0.01)
    calls = []
    assert 0.0 < timing.stopwatch(lambda: calls.append(sleep(0.001)))() < 1.0
    assert 2 <= len(calls) <= 11


def test_beyond_the_budget_three_rounds_are_enough():
    times, beside = timing.interleave([lambda: 1.0], 9, budget=-1.0)
    assert (times, beside) == ([[1.0] * 3], [[]])


def test_a_spread_is_the_median_and_the_middle_half():
    assert Spread.of([5.0, 1.0, 2.0, 100.0, 3.0]) == Spread(3.0, 2.0, 5.0)
    assert Spread.of([4.0]) == Spread(4.0, 4.0, 4.0)
    assert Spread.of_ratios([1.0, 4.0, 9.0], [1.0, 2.0, 3.0]) == Spread(2.0, 1.5, 2.5)


# Directions


@pytest.fixture(scope="module")
def rows():
    groups = directions.groups(64, 2)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timing, "_WARM_UP", 0.0)
        return list(chain.from_iterable(group() for group in (groups[0], groups[-6], groups[-2])))


def test_every_distribution_method_sequence_and_count_is_measured():
    names = {case.name for case in directions.maps()}
    assert names == set(ws.distributions.names())
    assert {case.method for case in directions.maps() if case.name == "cosine_hemisphere"} == {
        *("polar", "concentric", "inversion", "offset")
    }
    assert len(directions.groups(64, 2)) == len(directions.maps()) + len(directions.COUNTS)


def test_rows_say_what_was_measured(rows):
    assert {row.points * row.samples for row in rows} == {4096}
    polar = [row for row in rows if row.distribution == "CosineHemisphere(method='polar')" and row.table == "maps"]
    assert {(row.workers, row.pdf) for row in polar} >= {(1, False), (1, True)}
    assert {row.sequence for row in rows if row.table == "sequences"} == {"", *ws.sequences.names()}
    assert {row.samples for row in rows} == {64}
    for row in rows:
        assert len(row.seconds) == len(row.fill_seconds) == 2
        assert min(row.seconds) > 0.0
        assert row.of_fill.low <= row.of_fill.median <= row.of_fill.high


@pytest.mark.parametrize("case", [ws.CosineHemisphere("offset"), ws.UniformDisk()], ids=str)
def test_worst_errors_are_those_of_the_world_too(case):
    worst = directions.worst_errors(case)
    assert set(worst) == ({"angle", "pdf"} if case.width == 2 else {"length", "angle", "pdf"})
    # The offset method's errors are those of its sum of two vectors, which its local map does not have.
    assert (5e-7 < worst["angle"] <= 1.3e-5) if case.width == 3 else (5e-8 < worst["angle"] <= 3e-7)


def test_directions_tables_and_pictures(rows, capsys, tmp_path):
    lines = lines_of(report.show_directions, capsys, rows, STARTS)
    assert [line for line in lines if line.startswith(" CosineHemisphere(polar)") and line.count("e-07") == 3]
    assert [line for line in lines if line.startswith(" independent")]
    assert [line for line in lines if line.startswith("ceiling: NumPy's out.fill(0)")]
    files = plots.save(plots.draw_directions(rows, "caption"), tmp_path / "new")
    assert [file.name for file in files] == ["maps.png", "sequences.png"]
    assert not_blank(files)


def test_startup_is_measured_in_new_processes():
    cold, warm = startup.measure()
    assert (cold.kernel_cache, warm.kernel_cache) == ("cold", "warm")
    for start in (cold, warm):
        assert min(start.import_warp, start.import_warpsample, start.first_directions, start.further_kernel) > 0.0


# Error


@pytest.mark.parametrize("integrand", INTEGRANDS, ids=lambda i: i.name)
def test_known_means_are_right(integrand, plausible):
    """By 2^22 independent directions and, to 1e-4, by Sobol'."""
    w = ws.CosineHemisphere().sample(ws.sample_square("independent", 1 << 16, 64, seed=5))
    values = evaluate(integrand, w).astype(np.float64)
    plausible(2.0 * norm.sf(abs(values.mean() - integrand.mean) / values.std() * np.sqrt(values.size)))
    w = ws.CosineHemisphere().sample(ws.sample_square("sobol", 4, 1 << 18, seed=5))
    assert abs(evaluate(integrand, w).astype(np.float64).mean() - integrand.mean) <= 1e-4


@pytest.mark.parametrize("sequence", ["sobol", "stratified"])
@pytest.mark.parametrize("count", [4, 100])
def test_fused_means_are_those_of_the_directions(sequence, count):
    sky = next(i for i in INTEGRANDS if i.name == "sky gradient")
    got = error.estimates(sky, sequence, count, 50, seed=3, workers=2)
    w = ws.CosineHemisphere().sample(ws.sample_square(sequence, 50, count, seed=3))
    assert np.abs(got - evaluate(sky, w).astype(np.float64).mean(axis=1)).max() <= 2e-7  # the frame about +z rounds


@pytest.fixture
def curves(monkeypatch):
    monkeypatch.setattr(error, "INTEGRANDS", INTEGRANDS[2:3])
    monkeypatch.setattr(error, "_LEAST_WORK", 0)
    monkeypatch.setattr(timing, "_WARM_UP", 0.0)
    (group,) = error.groups(1024, 1, 64)
    return group()


def test_curves_have_the_slopes_of_their_sequences(curves, capsys, tmp_path):
    found = {curve.sequence: curve for curve in curves}
    assert set(found) == set(ws.sequences.names())
    assert [p.count for p in found["sobol"].points] == [4, 16, 64]
    # An RMSE of 1,024 estimates is within 2.2 % (one sigma), a slope over a factor of 4 within 0.023.
    assert abs(found["independent"].slope + 0.5) <= 0.15
    assert found["sobol"].slope <= -1.0
    assert found["independent"].efficiency == 1.0
    assert found["sobol"].reaching(0.02)[1] is False
    assert found["independent"].reaching(1e-3)[1] is True
    lines = lines_of(report.show_error, capsys, curves, 1e-3)
    assert [line for line in lines if line.startswith(" independent") and " ~" in line]
    assert [line for line in lines if line.startswith(" sky gradient") and re.search(" (sobol|fibonacci) *$", line)]
    assert not_blank(plots.save(plots.draw_error(curves, "caption"), tmp_path))


def test_a_time_to_an_error_lies_on_the_line_between_its_neighbours():
    points = [error.Point(n, 64, e, Spread(t, t, t), [t]) for n, e, t in ((4, 1e-1, 1.0), (16, 1e-2, 4.0), (64, 1e-3, 16.0))]
    curve = error.Curve("f", "smooth", 0.5, "sobol", error.slope(points), points, 1.0)
    assert curve.reaching(10**-2.5) == (pytest.approx(8.0), False)
    assert curve.reaching(1e-4) == (pytest.approx(64.0), True)
    assert curve.reaching(0.5) == (1.0, True)
    flat = error.Curve("f", "smooth", 0.5, "sobol", None, points, 1.0)
    assert flat.reaching(1e-4) is None


# Peers


def hopeless():
    """A job whose library is missing."""
    import no_such_library  # noqa: F401


def dying():
    """A job whose process ends."""
    import os

    os._exit(3)


def mortal():
    """A job that works once."""
    import os

    runs = []

    def work():
        runs.append(1)
        if len(runs) > 1:
            os._exit(4)

    return child.Job(work, dict)


def loud():
    """A job that prints."""
    return child.Job(lambda: sys.stdout.write("noise\n"), lambda: {"answer": 42})


@pytest.fixture
def own_jobs(monkeypatch, repository):
    monkeypatch.setenv("PYTHONPATH", str(repository / "tests"))


def test_a_child_runs_its_job_and_reports(own_jobs):
    with child.Child("test_bench:loud") as one:
        assert one.failure is None
        assert one.run() >= 0.0
        assert one.report() == {"answer": 42}


def test_a_child_without_a_job_says_why(own_jobs):
    with child.Child("test_bench:hopeless") as one:
        assert one.missing == "no_such_library"
        assert "No module named" in one.failure
    with child.Child("test_bench:dying") as one:
        assert one.failure == "its process ended with status 3"
    with child.Child("test_bench:mortal") as one:
        assert one.failure is None
        with pytest.raises(RuntimeError, match="test_bench:mortal: its process ended with status 4"):
            one.run()


@pytest.fixture(scope="module")
def peer_rows():
    """Those whose libraries the tests have, and one that may be missing."""
    chosen = [
        "warpsample independent",
        "warpsample sobol",
        "Warp built-ins, polar",
        "NumPy",
        "SciPy Sobol'",
        "Numba",
        "fill",
    ]
    surface = ["warpsample surface", "trimesh surface"]
    return [*peers.measure("directions", 4096, 2, chosen), *peers.measure("surface", 10_000, 2, surface)]


def test_peers_have_the_same_means(peer_rows):
    for row in peer_rows:
        if row.peer == "fill":
            assert row.agrees is None
        elif row.failure is None:
            assert row.agrees, row
            assert row.ours.median > 0.0
        else:
            assert re.match("not installed: pip install |numba does not work here: ", row.failure)
    assert sum(row.failure is None for row in peer_rows) >= 7


def test_a_peer_with_another_mean_is_called_wrong():
    means = {i.name: [i.mean, 1e-3] for i in INTEGRANDS}
    seconds = {"NumPy": [1.0], "warpsample independent": [0.5]}
    right = peers._row("directions", "NumPy", 1, 2, seconds, {"library": "", "means": means})
    assert right.agrees is True
    assert right.ours.median == 2.0
    means["cosine"][0] += 5e-3
    wrong = peers._row("directions", "NumPy", 1, 2, seconds, {"library": "", "means": means})
    assert wrong.agrees is False
    means["cosine"][0] = means["half-space"][0] = np.nan
    assert peers._row("directions", "NumPy", 1, 2, seconds, {"library": "", "means": means}).agrees is False
    means["cosine"][0] = 2.0 / 3.0
    assert peers._row("directions", "NumPy", 1, 2, seconds, {"library": "", "means": means}).agrees is False


def test_peer_tables_targets_and_pictures(peer_rows, capsys, tmp_path, monkeypatch):
    monkeypatch.setattr(peers, "_RANDOMISATIONS", 64)
    monkeypatch.setattr(peers, "_MOST", 1 << 12)
    targets = peers.time_to_error(peer_rows, 1)
    assert [t.integrand for t in targets] == ["sky gradient", "half-space"]
    for t in targets:
        assert t.samples < t.independent_samples / 5
        assert t.ratio == t.peer_microseconds / t.microseconds.median
    lines = lines_of(report.show_peers, capsys, peer_rows, targets)
    assert [line for line in lines if line.startswith(" NumPy")]
    assert [line for line in lines if line.startswith(" half-space")]
    files = plots.save(plots.draw_peers(peer_rows, "caption"), tmp_path)
    assert [file.name for file in files] == ["peers_directions.png", "peers_surface.png"]
    assert not_blank(files)


def test_every_peer_names_the_package_to_install():
    for job in peers.JOBS:
        assert peers.OURS[job] in peer_jobs.names(job)
        assert all(peer_jobs.library_of(peer) for peer in peer_jobs.names(job))
    assert set(peer_jobs.names("directions")) >= peer_jobs.SINGLE_THREADED - {"trimesh surface", "Open3D surface"}


# Scaling


def test_scaling_covers_points_samples_and_workers():
    found = scaling.cases(100_000_000)
    assert [p for axis, p, _, _ in found if axis == "points"] == [10**k for k in range(3, 9)]
    assert [s for axis, _, s, _ in found if axis == "samples"] == [4**k for k in range(7)]
    assert next(w for axis, _, _, w in found if axis == "workers") == 1


def test_a_stream_computes_every_direction(monkeypatch):
    seen = []
    monkeypatch.setattr(scaling, "_PART", 64)
    monkeypatch.setattr(scaling, "sample_directions", lambda n, s, first_point, **_: seen.append((first_point, len(n), s)))
    job = scaling.stream(10, 16, 1)
    job.work()
    assert seen == [(0, 4, 16), (4, 4, 16), (8, 2, 16)]
    assert job.report()["peak_megabytes"] > 10.0


# The command


def test_commands_keep_every_repeat(monkeypatch, capsys, tmp_path, rows, curves, peer_rows):
    monkeypatch.setattr(directions, "groups", lambda *_: [lambda: rows])
    monkeypatch.setattr(startup, "measure", lambda: STARTS)
    monkeypatch.setattr(error, "groups", lambda *_: [lambda: curves])
    monkeypatch.setattr(peers, "measure", lambda job, *_: [row for row in peer_rows if row.job == job])
    monkeypatch.setattr(peers, "time_to_error", lambda *_: [])
    monkeypatch.setattr(scaling, "cases", lambda _: [("points", 1000, 1, 1), ("points", 4000, 1, 1)])
    kept = {"directions": "rows", "error": "curves", "peers": "rows", "scaling": "rows"}
    for command, name in kept.items():
        file = tmp_path / f"{command}.json"
        assert run_command(monkeypatch, command, "--json", file, "--plot", tmp_path, "--repeats", 1) == 0
        out = capsys.readouterr()
        assert "\r" not in out.out
        found = json.loads(file.read_text())
        assert found["command"] == f"bench {command}"
        assert set(found["machine"]) == {*("cpu", "cores", "system", "python", "warpsample", "warp-lang", "numpy", "commit")}
        assert "repeats" in found["settings"]
        one = found[name][0]["points"][0] if command == "error" else found[name][0]
        assert all(second > 0.0 for second in one["seconds"])
    pictures = {"maps", "sequences", "error", "peers_directions", "peers_surface", "scaling"}
    assert {file.stem for file in tmp_path.glob("*.png")} == pictures
    assert not list(tmp_path.glob("*.part"))


def test_what_cannot_be_written_is_refused_before_any_work(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(directions, "groups", None)
    (tmp_path / "file").touch()
    assert run_command(monkeypatch, "directions", "--json", tmp_path / "no" / "a.json") == 2
    assert "--json: got" in capsys.readouterr().err
    assert run_command(monkeypatch, "directions", "--plot", tmp_path / "file") == 2
    assert "which is a file, want a folder" in capsys.readouterr().err
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert run_command(monkeypatch, "directions", "--plot", tmp_path) == 2
    assert "pip install matplotlib" in capsys.readouterr().err


def test_the_commit_is_that_of_the_checkout_or_unknown(monkeypatch, tmp_path):
    assert re.fullmatch(r"[0-9a-f]{12}(\+changes)?|unknown", machine.commit())
    monkeypatch.setattr(machine, "_git", lambda *_: str(tmp_path))  # a checkout of something else
    assert machine.commit() == "unknown"
