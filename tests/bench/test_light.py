"""The benchmark of light between and through faces: every tool finds the same irradiance, and the table says it."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

from warpsample.bench import light
from warpsample.bench.radiation import compute_errors
from warpsample.bench.tools.light import LIGHT_TOOLS, OURS, list_kinds

PEER = "Radiance rtrace -ab 8"
SETTINGS = {"side": 2, "points": 64, "rays": 256, "repeats": 1}


def test_kinds_of_faces():
    reflecting, _ = light.build_lit_city("reflection", 2, 16)
    clear, at = light.build_lit_city("transmission", 2, 16)
    kinds, kind = list_kinds(clear)
    assert kinds.tolist() == [[0.0, 0.0], [0.0, 0.3]]
    assert np.array_equal(np.float32(kinds[kind, 1]), clear.transmittance)
    assert 0.2 < kind.mean() < 0.45
    assert list_kinds(reflecting)[0].tolist() == [[0.4, 0.0]]
    assert len(at) == 16


@pytest.mark.thorough
@pytest.mark.parametrize("task", light.TASKS)
@pytest.mark.parametrize("tool", ["Mitsuba", PEER])
def test_tools_find_the_same_light(tool, task):
    mesh, at = light.build_lit_city(task, 2, 128)
    try:
        runs = LIGHT_TOOLS[tool].make(mesh, at, 2)(1024, 3)
    except (ImportError, RuntimeError) as error:
        pytest.skip(str(error))
    right = LIGHT_TOOLS[OURS].make(mesh, at, 2)(1 << 14, 2).mean(axis=0, dtype=float)
    most = light._MOST_RMSE**2
    assert compute_errors(runs, right)[2] < most
    for wrong in (right / np.pi, 0.9 * right, right[::-1]):
        assert compute_errors(runs, wrong)[2] > 4.0 * most


@pytest.mark.thorough
def test_all_is_measured_and_shown(tmp_path, capsys):
    case = {"side": 2, "points": 64, "rays": 256, "workers": 1}
    rows = light.compare("reflection", [OURS, PEER, "nobody"], 1, **case)
    by_tool = {row.tool: row for row in rows}
    assert "KeyError" in by_tool["nobody"].failure
    assert by_tool[OURS].times_ours.median == 1.0
    assert by_tool[PEER].rmse < 0.05
    text = "\n".join(lines_of("light", SETTINGS, {"rows": rows}, capsys))
    assert "nobody did not run here: KeyError" in text
    assert draw_pictures("light", {"rows": rows}, tmp_path) == ["light.png"]
