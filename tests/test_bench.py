"""The benchmark runs, says what it should, and measures what it says. No test asserts a time."""

import json
import sys

import numpy as np
import pytest
import warp as wp

from warpsample import cli
from warpsample.bench import directions, report, startup, timing


@pytest.fixture(scope="module")
def rows():
    return list(directions.measure(64, 2))


def test_every_case_is_measured(rows):
    for samples in (64, 1):
        chosen = [row for row in rows if row.samples == samples]
        assert {row.points * row.samples for row in chosen} == {4096}
        names = {row.case for row in chosen}
        assert {"fill", "built-ins"} < names
        assert {f"{s} {m}" for s in ("sobol", "independent", "fibonacci") for m in ("polar", "offset")} < names
        for row in chosen:
            assert len(row.seconds) == 2
            assert min(row.seconds) > 0.0
            assert row.of_fill[1] <= row.of_fill[0] <= row.of_fill[2]


def test_json_lines_have_their_fields(rows, capsys):
    report.show(rows, [startup.Startup("cold", 0.5, 0.1, 2.0)], as_json=True)
    records = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert set(records[0]["machine"]) == {"cpu", "cores", "python", "warpsample", "warp-lang", "numpy"}
    assert len(records) == len(rows) + 2
    assert {"case", "points", "samples", "workers", "million_per_second", "of_fill", "seconds"} <= set(records[1])
    assert records[-1]["first_directions"] == 2.0


def test_table_fits_a_terminal(rows, capsys):
    report.show(rows, [startup.Startup("cold", 0.5, 0.1, 2.0)], as_json=False)
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    assert [line for line in lines if "independent polar" in line]
    assert not [line for line in lines if "…" in line]


def test_built_ins_are_a_cosine_lobe_too():
    out = np.zeros((500, 64, 3), np.float32)
    normals = np.tile(np.array([[0, 0, 1]], np.float32), (500, 1))
    directions._builtins_case(normals, out)()
    assert abs(out[..., 2].mean() - 2 / 3) <= 0.01


def test_rounds_are_interleaved_and_each_timed_run_follows_one_of_its_kind():
    calls = []
    times = timing.interleave([lambda: calls.append("a"), lambda: calls.append("b")], 2)
    assert calls == ["a", "a", "b", "b"] * 2
    assert [len(t) for t in times] == [2, 2]
    assert timing.ratio_of([1.0, 2.0, 9.0], [1.0, 1.0, 3.0]) == (2.0, 1.0, 3.0)


def test_startup_is_measured_in_new_processes():
    cold, warm = startup.measure()
    assert (cold.kernel_cache, warm.kernel_cache) == ("cold", "warm")
    assert min(cold.import_warp, cold.import_warpsample, cold.first_directions, warm.first_directions) > 0.0


def test_command_prints_json_only(monkeypatch, capsys):
    monkeypatch.setattr(startup, "measure", list)
    monkeypatch.setattr(sys, "argv", ["warpsample", "bench", "directions", "--json", "--repeats", "1", "--points", "8"])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    assert stop.value.code == 0
    lines = capsys.readouterr().out.splitlines()
    assert all(json.loads(line) for line in lines)
    assert wp.config.log_level == wp.LOG_WARNING
