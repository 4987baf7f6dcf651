"""The benchmark of lobes by point: constant and by-point lobes run, and a tool with another lobe is called wrong."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

from warpsample.bench import lobes
from warpsample.bench.running.turns import Tool, ToolRuns
from warpsample.bench.tools.lobes import BY_POINT, CONSTANT, LOBES, MITSUBA, WAYS, build_surface


@pytest.fixture
def ours(monkeypatch):
    """Leave out Mitsuba, which the tests do not have."""
    monkeypatch.delitem(WAYS, MITSUBA)


def test_the_surface_has_a_roughness_and_a_view_above_it_at_each_point():
    surface = build_surface(1000)
    assert len(np.unique(surface.alpha)) == len(np.unique(surface.view[:, 2])) == 1000
    assert np.allclose(np.linalg.norm(surface.view, axis=1), 1.0, atol=1e-6)
    assert surface.view[:, 2].min() >= 0.1


@pytest.mark.thorough
@pytest.mark.parametrize("lobe", LOBES)
def test_lobes_of_one_roughness_and_of_many_are_timed(lobe, ours, capsys, tmp_path):
    rows = lobes.compare(64, lobe, 64, 2)
    assert {row.tool for row in rows if row.failure is None} == {CONSTANT, BY_POINT}
    assert all(len(row.seconds) == 2 and row.nanoseconds.median > 0.0 for row in rows)
    assert [line for line in lines_of("lobes", {}, {"rows": rows}, capsys) if CONSTANT in line]
    assert draw_pictures("lobes", {"rows": rows}, tmp_path) == ["lobes.png"]


def test_a_tool_with_another_lobe_is_called_wrong(monkeypatch):
    """A mean cosine off by 5 standard errors, from a tool whose run does nothing."""
    off = {BY_POINT: 0.0, CONSTANT: 0.3, "right": 0.0, "wrong": 5.0}
    found = {name: {"version": "1", "mean": 0.5 + each * 2e-3 * 2**0.5, "error": 2e-3} for name, each in off.items()}
    runs = ToolRuns({name: [1.0, 2.0] for name in off}, found, {})
    monkeypatch.setattr(lobes, "run_tools", lambda *_, **__: runs)
    assert [row.agrees for row in lobes.compare(64, "GGX", 64, 2)] == [None, None, True, False]


def test_each_tool_names_the_package_to_install():
    assert all(isinstance(tool, Tool) and tool.library for tool in WAYS.values())
