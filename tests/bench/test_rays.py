"""The benchmark of rays: its scenes and rays are what it says, all tools answer alike, and what they took is kept."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of, untracked

from warpsample.bench import rays, scenes
from warpsample.bench.running import timing
from warpsample.bench.tools import tracers

pytestmark = pytest.mark.slow  # peers and timers, in processes of their own


SETTINGS = {"scene": ["bunny"], "rays": 2048, "repeats": 2}


@pytest.fixture(scope="module")
def measured():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timing, "WARM_UP", 0.0)
        return rays.measure(untracked, **SETTINGS)


@pytest.mark.thorough
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
    shapes = {kind: [array.shape for array in scenes.build_rays(mesh, kind, 4096)] for kind in scenes.KINDS}
    assert shapes == {
        "camera": [(3,), (4096, 3)],
        "outward": [(64, 3), (64, 64, 3)],
        "inward": [(64, 3), (64, 64, 3)],
        "random": [(4096, 3), (4096, 3)],
    }
    share = {kind: tracers.build_wide_tool(mesh, kind, 4096)(True, 1)().mean() for kind in scenes.KINDS}
    assert share["inward"] == 1.0  # the bunny is closed
    assert 0.03 < share["outward"] < 0.2  # its mean occlusion is 0.091
    assert 0.2 < share["camera"] < 0.5
    assert 0.3 < share["random"] < 0.6


def test_every_tool_is_measured_and_agrees(measured):
    rows = measured["rows"]
    assert {row.tool for row in rows} | {missing.tool for missing in measured["missing"]} == set(tracers.TRACERS)
    assert {row.tool for row in rows} >= {"wide", "wp.Mesh", "Embree"}
    assert {(row.kind, row.any_hit) for row in rows} == {(kind, q) for kind in scenes.KINDS for q in (True, False)}
    for row in rows:
        assert row.differ <= 1
        assert len(row.seconds) == 2
        assert row.million_per_second.median > 0.0
        assert (row.nodes is not None) == (row.ours is None) == (row.tool == "wide")
        assert row.gain.median > 0.0
    visits = {(row.kind, row.any_hit): (row.nodes, row.leaves) for row in rows if row.tool == "wide"}
    for kind in scenes.KINDS:
        assert 1.0 <= visits[kind, True][0] <= visits[kind, False][0] < 20.0
        assert 0.2 < visits[kind, True][1] <= visits[kind, False][1] < 10.0


def test_builds_are_measured(measured):
    tools = {build.tool for build in measured["builds"]}
    assert tools >= {"wide", "wide, refit", "wp.Mesh", "Embree"}
    assert all(build.milliseconds.median > 0.0 for build in measured["builds"])


def test_a_tool_that_answers_otherwise_is_seen(monkeypatch):
    monkeypatch.setattr(timing, "WARM_UP", 0.0)
    mesh = scenes.bunny(0)
    tools = {"wide": tracers.build_wide_tool(mesh, "inward", 256), "blind": lambda *_: lambda: np.zeros(256, bool)}
    visited = {"nodes": 1.0, "leaves": 1.0}
    case = {"scene": "bunny", "triangles": 12_200, "kind": "inward", "any_hit": True}
    assert [row.differ for row in rays.compare(tools, [1], 1, visited, **case)] == [256, 256]


def test_a_missing_tool_is_a_line(monkeypatch):
    def absent(*_):
        raise ModuleNotFoundError("No module named 'embreex'")

    monkeypatch.setitem(tracers.TRACERS, "Embree", tracers.TRACERS["Embree"]._replace(make=absent))
    missing = {}
    assert "Embree" not in rays.build_tracers(scenes.bunny(0), "camera", 64, missing)
    assert missing["Embree"] == "No module named 'embreex'; pip install embreex"


def test_tables_and_picture(measured, capsys, tmp_path):
    lines = lines_of("rays", SETTINGS, measured | {"missing": [rays.MissingTool("Open3D", "pip install open3d")]}, capsys)
    for kind in scenes.KINDS:
        assert len([line for line in lines if line.startswith(f" 12,200     {kind}")]) == 2
    assert "Open3D did not run here: pip install open3d." in lines
    assert draw_pictures("rays", measured, tmp_path) == ["rays.png"]


def test_an_unknown_scene_is_refused():
    with pytest.raises(ValueError, match="^scene: got 'teapot', want one of bunny, "):
        scenes.check_scenes(["bunny", "teapot"])
