"""The benchmark of view factors: its meshes, and that every tool computes the same numbers."""

from dataclasses import replace

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

import warpsample as ws
from warpsample.bench import view_factors
from warpsample.bench.tools.blocks import build_blocks, build_boxes, build_mesh
from warpsample.bench.tools.view_factors import (
    EMBREE,
    FACTOR_TOOLS,
    OURS,
    PAIRS,
    TRACE,
    EmbreeFactors,
    PyViewFactor,
    compute_normals,
    sample_rays,
)
from warpsample.bench.view_factors import RECORD

SETTINGS = {"side": 1, "rays": 256, "repeats": 1}


def outward(mesh):
    """(F, 3) float64, of twice a face's area."""
    a, b, c = (mesh.vertices[mesh.faces[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


@pytest.mark.thorough
def test_a_city_has_faces_of_one_size_and_no_other_gap_than_its_border():
    mesh = build_blocks(2)
    assert np.ptp(mesh.face_areas) <= 1e-9
    n = outward(mesh)
    assert (n[:, 2] > 0.0).sum() == 2 * 10 * 10  # roofs and streets are the plan
    assert (n[:, 2] >= 0.0).all()
    assert np.abs(n.sum(axis=0)[:2]).max() <= 1e-9
    edges = np.sort(mesh.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, times = np.unique(edges, axis=0, return_counts=True)
    assert (times == 1).sum() == 4 * 10
    v = ws.view_factors(mesh, 64)
    assert v.behind.max() == 0.0
    assert len(build_mesh("city 2").faces) == len(mesh.faces)


@pytest.mark.thorough
def test_boxes_are_closed_and_the_inner_one_sees_the_outer_alone():
    """A convex body in another: the inner's factor to the outer is 1, the outer's to the inner the ratio of areas."""
    mesh = build_boxes(4)
    inner = np.arange(len(mesh.faces)) >= 6 * 16 * 2
    v = ws.view_factors(mesh, 1024, groups=inner.astype(int))
    assert v.areas == pytest.approx([54.0, 6.0])
    assert v.outside.max() == v.behind.max() == 0.0
    assert v.matrix.toarray()[1] == pytest.approx([1.0, 0.0])
    assert v.matrix.toarray()[0, 1] == pytest.approx(1.0 / 9.0, abs=5.0 * v.standard_error.toarray()[0, 1])


def test_peers_rays_are_uniform_on_faces_and_cosine_weighted():
    mesh = build_boxes(1)
    faces = np.array([0, 7, 20])
    origins, directions = sample_rays(mesh, faces, 20_000, np.random.default_rng(3))
    o, d = (array.reshape(3, -1, 3).astype(np.float64) for array in (origins, directions))
    centre = mesh.vertices[mesh.faces[faces]].mean(axis=1)
    assert np.abs(o.mean(axis=1) - centre).max() <= 5.0 * 3.0 * 0.24 / np.sqrt(20_000)
    cosine = np.einsum("frk,fk->fr", d, compute_normals(mesh, faces).astype(np.float64))
    assert np.abs(cosine.mean(axis=1) - 2.0 / 3.0).max() <= 0.009  # 5 of 0.236 / sqrt(20,000)
    assert np.abs(np.linalg.norm(d, axis=2) - 1.0).max() <= 1e-5


@pytest.mark.thorough
@pytest.mark.parametrize("make", [EmbreeFactors, PyViewFactor])
def test_tools_compute_the_same(make):
    """The two small boxes have few enough faces that a ray between centroids says little: these are free of obstacles."""
    pytest.importorskip("embreex" if make is EmbreeFactors else "pyviewfactor")
    mesh = ws.Mesh(build_boxes(2).vertices, build_boxes(2).faces[: 6 * 4 * 2])  # the outer box alone
    right = ws.view_factors(mesh, 16_384).matrix.toarray()
    tool = make(mesh, 2)
    tool.run(4096)
    faces = np.array([0, 5, 47])
    found = tool.rows(faces)
    assert found.shape == (3, 48)
    assert np.abs(found - right[faces]).max() <= 5.0 * np.sqrt(0.25 / 4096) * right.max() ** 0.5
    assert found.sum(axis=1) == pytest.approx(1.0, abs=1e-3)
    assert np.abs(found - right[faces]).max() < 0.3 * np.abs(np.roll(right, 1, axis=1) - right).max()


def test_equal_errors_take_more_rays_or_fewer_of_ours():
    ours = {"rmse": 1e-4, "rate": 0.625}

    def judged(times, tool, **changes):
        row = {"rmse": 2e-4, "due": 1.0, "relative": 0.1} | changes
        return view_factors.judge(tool, row, ours, times, [1.0])

    rays = judged([3.0], EMBREE)
    assert rays["times_ours"].median == pytest.approx(12.0)
    assert rays["agrees"]
    exact = judged([3.0], PAIRS, due=None)
    assert exact["times_ours"].median == pytest.approx(3.0 * 2.0**1.6)
    assert exact["agrees"]
    assert not judged([3.0], EMBREE, due=2.0)["agrees"]
    assert not judged([1.0], PAIRS, due=None, relative=0.4)["agrees"]


def test_a_tool_that_disagrees_is_wrong_and_one_that_is_missing_is_not():
    missing, right = (view_factors.FactorTime("city 1", 104, 1, tool=OURS, failure=failure) for failure in ("no", None))
    assert not RECORD.has_disagreement({"rows": [missing, replace(right, agrees=True)]})
    assert RECORD.has_disagreement({"rows": [missing, replace(right, agrees=False)]})


@pytest.mark.thorough
def test_all_is_measured_and_shown(tmp_path, capsys):
    rows = view_factors.compare("city 1", 1, [*FACTOR_TOOLS, TRACE, "nobody"], 1, 256)
    by_tool = {row.tool: row for row in rows}
    assert "KeyError" in by_tool["nobody"].failure
    ran = [row for row in rows if not row.failure]
    assert all(row.took.median > 0.0 and row.traces.median > 0.0 for row in ran)
    assert [row.agrees for row in ran if row.rmse] == [True] * (len(ran) - 1)
    assert by_tool[OURS].times_ours.median == 1.0
    assert by_tool["embreex"].rmse > by_tool[OURS].rmse
    assert 50.0 < by_tool[OURS].peak_megabytes < 700.0
    found = {"rows": rows}
    assert not RECORD.has_disagreement(found)
    text = "\n".join(lines_of("view-factors", SETTINGS, found, capsys))
    assert "city 1, faces 104, threads 1" in text
    assert "nobody did not run here: KeyError" in text
    assert draw_pictures("view-factors", found, tmp_path) == ["view_factors.png"]
