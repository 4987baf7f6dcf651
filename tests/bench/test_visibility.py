"""The benchmark of visibility: every tool estimates the same numbers, to the RMSE asked for, and its table says it all."""

import json

import numpy as np
import pytest
from bench_output import lines_of, not_blank, run_command

from warpsample.bench import plots, report, visibility, visibility_jobs

pytestmark = pytest.mark.slow  # peers and timers, in processes of their own

TOOLS = ["warpsample", "trimesh + embreex"]


@pytest.fixture(scope="module")
def rows():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(visibility, "TARGETS", {0.02: TOOLS})
        patch.setattr(visibility, "OURS", ["warpsample"])
        return next(iter(visibility.measure(["bunny"], 200, 1)))


def test_every_tool_reaches_the_error(rows):
    all_points = [row for row in rows if not row.open_points]
    assert [row.tool for row in all_points] == TOOLS
    assert [row.failure for row in rows] == [None] * len(rows)
    for row in all_points:
        assert 0.6 * 0.02 <= row.rmse <= 1.7 * 0.02  # a tool that were biased, or of another quantity, would be far off
        assert row.microseconds.median > 0.0
        assert row.cast <= row.rays
    by_tool = {row.tool: row for row in all_points}
    assert by_tool["warpsample"].rays < by_tool["trimesh + embreex"].rays
    assert by_tool["warpsample"].times_ours.median == 1.0
    sky = [row for row in rows if row.open_points]
    assert [(row.tool, row.rmse) for row in sky] == [("warpsample", 0.0)]
    assert sky[0].cast < 0.8 * sky[0].rays


def test_a_tool_that_is_missing_says_so(tmp_path):
    np.save(tmp_path / "right.npy", np.ones(16))
    (found,) = visibility._compare("bunny", 16, 1, 0.1, tmp_path / "right.npy", 1, ["nobody"], False)
    assert found.tool == "nobody"
    assert "KeyError" in found.failure


@pytest.fixture(scope="module")
def many():
    return visibility.measure_many("bunny", 20_000, 2048)


def test_memory_is_that_of_the_points(many):
    assert 50.0 < many.peak_megabytes < 700.0  # it is about 350; the directions would be another 490
    assert many.seconds > 0.0


def test_what_is_shown_and_drawn(rows, many, tmp_path, capsys):
    lines = lines_of(report.show_visibility, capsys, rows, many)
    assert any(line.startswith("bunny, 20,000 points x 2048 rays: ") and "MB at most" in line for line in lines)
    text = "\n".join(lines)
    assert "bunny, 200 points" in text
    assert "only points that see nothing but sky" in text
    assert sum("trimesh + embreex (" in line for line in lines) == 1
    assert not_blank(plots.save(plots.draw_visibility(rows, "caption"), tmp_path))


def test_the_command_keeps_every_repeat(monkeypatch, tmp_path, rows, many):
    monkeypatch.setattr(visibility, "measure", lambda *_: iter([rows]))
    monkeypatch.setattr(visibility, "measure_many", lambda *_: many)
    json_file = tmp_path / "v.json"
    assert run_command(monkeypatch, "visibility", "--scene", "bunny", "--json", json_file) == 0
    kept = json.loads(json_file.read_text())
    assert kept["command"] == "bench visibility"
    assert [len(row["seconds"]) for row in kept["rows"]] == [1] * len(rows)
    assert kept["many"][0]["points"] == 20_000


@pytest.mark.parametrize("tool", ["embreex", "trimesh + embreex", "warpsample, skip=False"])
def test_tools_estimate_the_same(tool):
    mesh, at = visibility_jobs.points_of("bunny", 100)
    right = visibility_jobs.Ours(mesh, at, 1)(4096)
    found = visibility_jobs.TOOLS[tool][1](mesh, at, 1)(1024)
    assert np.abs(found - right).max() <= 5 * 0.5 / 32  # the greatest standard deviation of a ray
    assert abs(found.mean() - right.mean()) <= 5 * 0.27 / 320


def test_peers_rays_are_cosine_weighted():
    """Their mean cosine is 2/3, whatever the normal; and they start off the surface."""
    _, at = visibility_jobs.points_of("bunny", 64)
    seen = []
    peer = visibility_jobs.Peer(lambda o, d: seen.append((o, d)) or np.zeros(len(o), bool), at, 1.0, 1)
    assert (peer(1000) == 1.0).all()
    origins, directions = (np.concatenate(arrays).reshape(64, 1000, 3) for arrays in zip(*seen, strict=True))
    cosine = np.einsum("psk,pk->ps", directions, at.normal)
    assert abs(cosine.mean() - 2 / 3) <= 0.005  # 5 of 0.236 / sqrt(64,000)
    assert np.abs(np.linalg.norm(directions, axis=2) - 1.0).max() <= 1e-5
    assert np.abs(np.einsum("psk,pk->ps", origins - at.position[:, None], at.normal) - 1e-5).max() <= 1e-6
