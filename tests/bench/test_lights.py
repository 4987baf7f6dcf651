"""The benchmark of lights: its picture, the errors of three ways, and a tool with another mean that is called wrong."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

from warpsample.bench import lights
from warpsample.bench.running.turns import ToolRuns
from warpsample.bench.tools.lights import BOTH, COSINE, DRAWS, LIGHTS, build_picture


@pytest.fixture
def ours(monkeypatch):
    """Leave out Mitsuba, which the tests do not have."""
    for tools in (DRAWS, LIGHTS):
        for name in [name for name, tool in tools.items() if tool.library == "mitsuba"]:
            monkeypatch.delitem(tools, name)


@pytest.mark.parametrize(("degrees", "least"), [(0.1, 1), (3.0, 12)])
def test_the_sun_covers_its_pixels_40_degrees_from_the_zenith(degrees, least):
    picture = build_picture(128, degrees)
    rows, columns = np.nonzero(picture > 1.0)
    assert least <= len(rows) <= 2 * least
    assert abs((rows.mean() + 0.5) * 180 / 128 - 40.0) < 1.0
    assert abs(columns.mean() - 64) <= 1.0


@pytest.mark.thorough
def test_rays_towards_the_sun_beat_rays_of_the_cosine_lobe(ours, capsys, tmp_path):
    rows = {"draws": lights.compare_draws(64, 2), "irradiance": lights.compare_irradiance(1.0, 64, 2)}
    assert all(row.agrees for part in rows.values() for row in part if row.tool != COSINE)
    rmse = {row.tool: row.rmse for row in rows["irradiance"]}
    assert rmse[COSINE] > 5.0 * rmse[BOTH] > 0.0
    assert [line for line in lines_of("lights", {}, rows, capsys) if BOTH in line]
    assert draw_pictures("lights", rows, tmp_path) == ["lights.png"]


def test_a_tool_with_another_mean_is_called_wrong(monkeypatch):
    found = {BOTH: 2.0, "near": 2.04, "far": 2.07}
    reports = {tool: {"version": "1", "rmse": 0.1, "mean": mean} for tool, mean in found.items()}
    monkeypatch.setattr(lights, "run_tools", lambda *_, **__: ToolRuns(dict.fromkeys(found, (1.0, 2.0)), reports, {}))
    assert [row.agrees for row in lights.compare_irradiance(1.0, 64, 2)] == [True, True, False]
