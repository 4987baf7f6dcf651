"""Benchmark of rasters: the exact values, and the reported error of a tool."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of, untracked

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

from warpsample.bench import city
from warpsample.bench.tools.rasters import RASTER_TOOLS


def test_exact_values_are_those_of_the_sheet():
    """The middle of the yard by its walls' elevation, the slope by (1 - the mean of sin h) of a plane: shared/CITY.md."""
    heights, cells, right = city.build_yard()
    assert (heights.ravel()[cells] == 0.0).all()
    assert (heights == 0.0).sum() == len(cells) == 441
    middle = right.reshape(21, 21)
    assert middle[10, 10] == middle.max()
    assert np.allclose(middle, middle.T, atol=1e-12)
    turn = np.linspace(0.0, 2.0 * np.pi, 100_001)[:-1]
    away = 10.5 / np.maximum(np.abs(np.cos(turn)), np.abs(np.sin(turn)))
    assert middle[10, 10] == pytest.approx(1.0 - (20.0 / np.hypot(20.0, away)).mean(), abs=1e-6)
    _, _, plane = city.build_slope(45.0)
    assert plane[0] == pytest.approx(1.0 - np.arctan(1.0) / np.pi, abs=1e-6)  # a wedge of 45 of 180 degrees is hidden


@pytest.mark.thorough
def test_the_deviation_of_a_tool_is_reported(monkeypatch):
    """With 64 rays the bias is within four standard errors of the mean of 441 cells; a tool that adds 0.1 has that bias."""
    heights, cells, right = city.build_yard()
    job = city.build_sky("warpsample, 64 rays", "yard", None, workers=1)
    job.work()
    report = job.report()
    assert abs(report["bias"]) < 4.0 * report["rmse"] / np.sqrt(len(cells)) + 1e-3
    assert 0.001 < report["rmse"] < 0.05
    sky = np.zeros(heights.size)
    sky[cells] = right + 0.1
    library, _, _ = RASTER_TOOLS["warpsample, 64 rays"]
    wrong = RASTER_TOOLS | {"warpsample, 64 rays": (library, lambda *_, **__: lambda: sky, True)}
    monkeypatch.setattr(city, "RASTER_TOOLS", wrong)
    job = city.build_sky("warpsample, 64 rays", "yard", None, workers=1)
    job.work()
    assert job.report()["bias"] == pytest.approx(0.1)


@pytest.mark.thorough
def test_tools_take_turns_at_each_raster(monkeypatch, capsys, tmp_path, repository):
    few = {name: tool for name, tool in RASTER_TOOLS.items() if name.endswith(" 64 rays")}
    monkeypatch.setattr(city, "RASTER_TOOLS", few)
    settings = {"raster": repository / "viz" / "data" / "tm1_564_146.tif", "repeats": 1}
    found = city.measure(untracked, **settings)
    assert [row.scene for row in found["rows"]] == ["yard"] * 2 + ["slope"] * 2 + ["tm1_564_146.tif"] * 2
    assert all(row.rmse < 0.05 and abs(row.bias) < 0.01 for row in found["rows"])
    assert [line for line in lines_of("city", settings, found, capsys) if line.startswith(" warpsample, 64 rays ")]
    assert draw_pictures("city", found, tmp_path) == ["city.png"]
