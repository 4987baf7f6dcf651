"""The benchmark of rays: its scenes and rays are what it says, all tools answer alike, and what they took is kept."""

import json

import numpy as np
import pytest
from bench_output import lines_of, not_blank, run_command

from warpsample.bench import plots, rays, report, scenes, timing, tracers

pytestmark = pytest.mark.slow  # peers and timers, in processes of their own


@pytest.fixture(scope="module")
def measured():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timing, "_WARM_UP", 0.0)
        return list(rays.measure(["bunny"], 2048, 2))


@pytest.mark.parametrize(
    ("name", "triangles"), [("bunny", 12_200), ("bunny, 4 to 1", 48_800), ("hills", 19_602), ("city", 49_154)]
)
def test_scenes_are_as_large_as_they_say(name, triangles):
    assert scenes.SCENES[name]().report.faces == triangles


def test_the_city_is_boxes_on_a_plane():
    found = scenes.city(8).report
    assert (found.boundary_edges, found.inconsistent_edges, found.nonmanifold_edges, found.degenerate_faces) == (4, 0, 0, 0)
    assert found.lower[2] == 0.0
    top = scenes.city(8).face_normals[: 12 * 64].reshape(64, 12, 3)
    assert (top[:, [1, 7]] == [0.0, 0.0, 1.0]).all()


def test_rays_are_of_their_kind():
    mesh = scenes.bunny(0)
    shapes = {kind: [array.shape for array in scenes.rays(mesh, kind, 4096)] for kind in scenes.KINDS}
    assert shapes == {
        "camera": [(3,), (4096, 3)],
        "outward": [(64, 3), (64, 64, 3)],
        "inward": [(64, 3), (64, 64, 3)],
        "random": [(4096, 3), (4096, 3)],
    }
    share = {kind: tracers.Wide(mesh, kind, 4096).hits(True, 1)().mean() for kind in scenes.KINDS}
    assert share["inward"] == 1.0  # the bunny is closed
    assert 0.03 < share["outward"] < 0.2  # its mean occlusion is 0.091
    assert 0.2 < share["camera"] < 0.5
    assert 0.3 < share["random"] < 0.6


def test_every_tool_is_measured_and_agrees(measured):
    rows = measured[0].rows
    assert {row.tool for row in rows} | set(measured[0].missing) == set(tracers.TOOLS)
    assert {row.tool for row in rows} >= {"wide", "wp.Mesh", "Embree"}
    assert {(row.kind, row.any_hit) for row in rows} == {(kind, q) for kind in scenes.KINDS for q in (True, False)}
    for row in rows:
        assert row.differ <= 1
        assert len(row.seconds) == 2
        assert row.million_per_second.median > 0.0
        assert (row.nodes is not None) == (row.tool == "wide")
    visits = {(row.kind, row.any_hit): (row.nodes, row.leaves) for row in rows if row.tool == "wide"}
    for kind in scenes.KINDS:
        assert 1.0 <= visits[kind, True][0] <= visits[kind, False][0] < 20.0
        assert 0.2 < visits[kind, True][1] <= visits[kind, False][1] < 10.0


def test_builds_are_measured(measured):
    tools = {build.tool for build in measured[0].builds}
    assert tools >= {"wide", "wide, refit", "wp.Mesh", "Embree"}
    assert all(build.milliseconds.median > 0.0 for build in measured[0].builds)


def test_a_tool_that_answers_otherwise_is_seen(monkeypatch):
    class Blind(tracers.Wide):
        def hits(self, any_hit, workers):
            return lambda: np.zeros(self.rays[1].size // 3, bool)

    monkeypatch.setattr(timing, "_WARM_UP", 0.0)
    mesh = scenes.bunny(0)
    tools = {"wide": tracers.Wide(mesh, "inward", 256), "blind": Blind(mesh, "inward", 256)}
    assert [row.differ for row in rays._compare("bunny", mesh, "inward", True, tools, [1], 1)] == [0, 256]


def test_a_missing_tool_is_a_line(monkeypatch):
    def absent(*_):
        raise ModuleNotFoundError("No module named 'embreex'")

    monkeypatch.setattr(tracers, "TOOLS", {"wide": tracers.Wide, "Embree": absent})
    monkeypatch.setattr(rays, "TOOLS", {"wide": tracers.Wide, "Embree": absent})
    missing = {}
    assert list(rays._tools(scenes.bunny(0), "camera", 64, missing)) == ["wide"]
    assert missing == {"Embree": "No module named 'embreex'; pip install embreex"}


def test_tables_and_picture(measured, capsys, tmp_path):
    part = measured[0]
    lines = lines_of(report.show_rays, capsys, part.rows, part.builds, {"Open3D": "pip install open3d"})
    for kind in scenes.KINDS:
        assert len([line for line in lines if line.startswith(f" 12,200 {kind}")]) == 2
    assert "Open3D: pip install open3d" in lines
    files = plots.save(plots.draw_rays(part.rows, "caption"), tmp_path)
    assert [file.name for file in files] == ["rays.png"]
    assert not_blank(files)


def test_the_command_keeps_every_repeat(monkeypatch, capsys, tmp_path, measured):
    monkeypatch.setattr(rays, "measure", lambda *_: iter(measured))
    file = tmp_path / "rays.json"
    assert run_command(monkeypatch, "rays", "--scene", "bunny", "--json", file, "--plot", tmp_path, "--repeats", 2) == 0
    found = json.loads(file.read_text())
    assert found["settings"] == {"scenes": ["bunny"], "rays": 131_072, "repeats": 2, "seed": 0}
    assert all(len(row["seconds"]) == 2 for row in found["rows"] + found["builds"])
    assert (tmp_path / "rays.png").is_file()
    assert run_command(monkeypatch, "rays", "--scene", "teapot") == 2
    assert "scene: got 'teapot', want one of bunny, " in capsys.readouterr().err
