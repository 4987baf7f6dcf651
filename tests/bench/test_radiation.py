"""The benchmark of sky and sun: every tool computes the same numbers, and the table says it all."""

from dataclasses import replace

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

from warpsample.bench import radiation
from warpsample.bench.radiation import RECORD, compute_errors, compute_sky_reference
from warpsample.bench.scenes import compute_year_of_suns, sample_clear_points
from warpsample.bench.tools.sky import OURS, SKY_TOOLS, VIEW
from warpsample.bench.tools.sun import SUN_TOOLS, TRACE

PEER = "Radiance rcontrib"
SETTINGS = {"scene": ["bunny"], "points": 32, "year_points": 64, "repeats": 1}


def test_a_year_has_its_suns():
    """The sun stands due south at 12, its altitude between 90 - 52.37 -+ 23.44 degrees; up half of the time."""
    suns = compute_year_of_suns().astype(np.float64)
    assert 4300 <= len(suns) <= 4460
    assert np.abs(np.linalg.norm(suns, axis=1) - 1.0).max() <= 1e-6
    highest = np.degrees(np.arcsin(suns[:, 2].max()))
    assert abs(highest - (90.0 - 52.37 + 23.44)) <= 0.7  # at half past, 7.5 degrees from the south
    assert abs(suns[:, 0].mean()) <= 1e-3
    assert suns[np.argmax(suns[:, 2]), 1] < -0.4


def test_errors_tell_what_is_apart():
    rng = np.random.default_rng(2)
    right = rng.random((50, 145))
    runs = right + 0.01 * rng.standard_normal((2, 50, 145))
    mse, variance, apart = compute_errors(runs, right)
    assert mse == pytest.approx(1e-4, rel=0.05)
    assert apart / variance == pytest.approx(1.0, abs=0.1)
    assert compute_errors(runs + 0.02, right)[2] / variance > radiation.MOST_ERROR_RATIO


def test_equal_errors_take_as_many_more_rays():
    """Independent rays with four times the error need sixteen times the rays; what is fixed stays."""
    ours, theirs = {"rmse": 1e-4}, {"rmse": 4e-4, "rate": 0.5, "fixed": 0.5}
    assert radiation.compare_at_equal_error([1.5], theirs, [0.1], ours).median == pytest.approx((0.5 + 16.0) / 0.1)


def test_a_tool_that_disagrees_is_wrong_and_one_that_is_missing_is_not():
    right = {
        "sky": [radiation.SkyTime("city", 1, tool=OURS, agrees=True)],
        "sun": [radiation.SunTime("city", 1, 9, tool=TRACE, failure="no")],
        "year": [],
    }
    assert not RECORD.has_disagreement(right)
    assert RECORD.has_disagreement(right | {"sky": [replace(right["sky"][0], agrees=False)]})
    assert RECORD.has_disagreement(right | {"sun": [replace(right["sun"][0], agrees=False)]})


@pytest.mark.thorough
@pytest.mark.parametrize("tool", ["Mitsuba", "Radiance rcontrib", OURS])
def test_tools_see_the_same_sky(tool):
    mesh, at = sample_clear_points("bunny", 64)
    try:
        run = SKY_TOOLS[tool].make(mesh, at, 2)
        runs = run(2048, 3)
    except (ImportError, RuntimeError) as error:
        pytest.skip(str(error))
    right = compute_sky_reference(mesh, at, 2)
    _, variance, apart = compute_errors(runs, right)
    assert apart <= radiation.MOST_ERROR_RATIO * variance
    for wrong in (right * np.pi, np.roll(right, 5, axis=1), right[:, ::-1]):
        assert compute_errors(runs, wrong)[2] > 2.0 * radiation.MOST_ERROR_RATIO * variance


@pytest.mark.thorough
def test_all_is_measured_and_shown(tmp_path, capsys):
    sky = radiation.compare_skies("bunny", 32, 1, 1, [OURS, VIEW, PEER, "nobody"])
    sun = radiation.compare_suns("bunny", 32, 1, 1, ["warpsample", TRACE])
    found = {"sky": sky, "sun": sun, "year": radiation.measure_year("bunny", 64, 1)}
    by_tool = {row.tool: row for row in sky}
    assert "KeyError" in by_tool["nobody"].failure
    assert by_tool[OURS].times_ours.median == 1.0
    assert by_tool[PEER].times_ours.median > 10.0
    assert by_tool[PEER].rmse > 3.0 * by_tool[OURS].rmse
    assert [row.agrees for row in sky if row.rmse] == [True, True]
    assert {row.tool: row.different for row in sun}["warpsample"] == 0.0
    assert [row.agrees for row in sun] == [True, True]
    assert set(SUN_TOOLS) >= {row.tool for row in sun}
    assert not RECORD.has_disagreement(found)
    (year,) = found["year"]
    assert year.fewer_seconds > 0.0
    assert year.took > 0.0
    text = "\n".join(lines_of("radiation", SETTINGS, found, capsys))
    assert "nobody did not run here: KeyError" in text
    assert "Sky matrix, 1,024 rays per point: bunny, threads 1" in text
    assert "seconds for 16 points" in text
    assert draw_pictures("radiation", found, tmp_path) == ["radiation.png"]
