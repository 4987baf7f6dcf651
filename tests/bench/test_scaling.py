"""The benchmark of size: its cases, and that a stream computes every direction."""

import pytest
from bench_output import draw_pictures, lines_of, untracked

from warpsample.bench import scaling


def test_scaling_covers_points_samples_and_workers():
    found = scaling.list_cases(100_000_000)
    assert [p for axis, p, _, _ in found if axis == "points"] == [10**k for k in range(3, 9)]
    assert [s for axis, _, s, _ in found if axis == "samples"] == [4**k for k in range(7)]
    assert next(w for axis, _, _, w in found if axis == "workers") == 1


def test_a_stream_computes_every_direction(monkeypatch):
    seen = []
    monkeypatch.setattr(scaling, "sample_directions", lambda n, s, first_point, **_: seen.append((first_point, len(n), s)))
    job = scaling.build_stream(("points", 10, 16, 1), part=64)
    job.work()
    assert seen == [(0, 4, 16), (4, 4, 16), (8, 2, 16)]
    assert job.report()["peak_megabytes"] > 10.0


@pytest.mark.thorough
def test_each_case_is_measured_in_a_process_of_its_own(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(scaling, "list_cases", lambda _: [("points", 1000, 16, 1), ("points", 4000, 16, 1)])
    settings = {"largest": 4000, "repeats": 2}
    found = scaling.measure(untracked, **settings)
    assert [(row.points, len(row.seconds)) for row in found["rows"]] == [(1000, 2), (4000, 2)]
    assert all(row.nanoseconds.median > 0.0 and row.peak_megabytes > 50.0 for row in found["rows"])
    assert [line for line in lines_of("scaling", settings, found, capsys) if line.startswith(" points  4,000 ")]
    assert draw_pictures("scaling", found, tmp_path) == ["scaling.png"]
