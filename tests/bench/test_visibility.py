"""The benchmark of visibility: every tool estimates the same numbers, to the RMSE asked for, and its table says it all."""

from dataclasses import replace

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

from warpsample.bench import visibility
from warpsample.bench.scenes import sample_scene
from warpsample.bench.tools.numpy_rays import build_open_fraction, measure_size
from warpsample.bench.tools.occlusion import ESTIMATORS, Occlusion, build_embree_estimator
from warpsample.bench.visibility import compute_reference

pytestmark = pytest.mark.thorough  # peers and timers, in processes of their own

TOOLS = ["warpsample", "embreex"]
BY_CHANCE = 5.0  # standard errors: of 200 points, by chance once in 8,000 runs
SETTINGS = {"scene": ["bunny"], "points": 200, "repeats": 1}


@pytest.fixture(scope="module")
def rows():
    return visibility.measure_scene("bunny", 200, 1, targets=[0.02], tools=TOOLS)


def test_every_tool_reaches_the_error(rows):
    assert [row.tool for row in rows] == TOOLS
    assert [row.failure for row in rows] == [None] * len(rows)
    for row in rows:
        assert 0.6 * 0.02 <= row.rmse <= 1.7 * 0.02  # a tool that were biased, or of another quantity, would be far off
        assert row.microseconds.median > 0.0
        assert row.cast <= row.rays
    by_tool = {row.tool: row for row in rows}
    assert by_tool["warpsample"].rays < by_tool["embreex"].rays
    assert by_tool["warpsample"].times_ours.median == 1.0


def test_a_tool_that_is_missing_says_so():
    case = {"scene": "bunny", "points": 16, "workers": 1, "target": 0.1}
    (found,) = visibility.compare(["nobody"], 1, np.ones(16), **case)
    assert found.tool == "nobody"
    assert "KeyError" in found.failure


def off_embree(mesh, at, reference, points=256, rays=1 << 14):
    """How far a reference is off independent cosine rays that embreex traces, in standard errors: at each point, and all."""
    chosen = np.linspace(0, len(at) - 1, min(points, len(at))).astype(int)
    share = build_embree_estimator(mesh, at.take(chosen), 1)(rays).astype(np.float64)
    values, errors = (array[chosen].astype(np.float64) for array in (reference.value, reference.standard_error))
    # By Laplace's rule, so that a share of all or nothing has a variance too; of both, since they should agree.
    likely = [(rays * p + 1.0) / (rays + 2.0) for p in (values, share)]
    variance = sum(p * (1.0 - p) for p in likely) / (2.0 * rays) + errors**2
    off = (values - share) / np.sqrt(variance)
    error = np.sqrt(np.sum(variance)) / len(off)
    assert error < 3e-4
    return off, np.mean(values - share) / error


def test_embree_confirms_the_reference():
    mesh, at = sample_scene("bunny", 200)
    off, mean = off_embree(mesh, at, compute_reference(mesh, at, 2))
    assert len(off) == 200
    assert max(np.abs(off).max(), abs(mean)) <= BY_CHANCE
    assert 0.7 < np.sqrt(np.mean(off**2)) < 1.3  # 200 differences in their standard errors: 1, to within 0.05 (one sigma)


@pytest.mark.parametrize("wrong", [lambda v: v + 0.002, lambda v: np.where(np.arange(len(v)) == 7, v - 0.05, v)])
def test_a_wrong_reference_is_not_confirmed(wrong):
    """All values by little, or one by much."""
    mesh, at = sample_scene("bunny", 200)
    right = compute_reference(mesh, at, 1, rays=4096)
    changed = replace(right, value=np.clip(wrong(right.value), 0.0, 1.0))
    off, mean = off_embree(mesh, at, changed)
    assert max(np.abs(off).max(), abs(mean)) > BY_CHANCE


@pytest.fixture(scope="module")
def many():
    return visibility.measure_many("bunny", 20_000, 2048)[0]


def test_memory_is_that_of_the_points(many):
    assert 50.0 < many.peak_megabytes < 700.0  # it is about 350; the directions would be another 490
    assert many.took > 0.0


def test_what_is_shown_and_drawn(rows, many, tmp_path, capsys):
    both = {"rows": rows, "many": [many]}
    text = "\n".join(lines := lines_of("visibility", SETTINGS, both, capsys))
    assert [line for line in lines if line.startswith(" bunny  20,000  2,048 ")]
    assert "bunny, to 0.02, points 200" in text
    assert sum(line.startswith(" embreex ") for line in lines) == 3
    assert "embreex 4" in text
    assert draw_pictures("visibility", both, tmp_path) == ["visibility.png"]


@pytest.mark.parametrize("tool", ["embreex", "warpsample, skip=False"])
def test_tools_estimate_the_same(tool):
    mesh, at = sample_scene("bunny", 100)
    right = Occlusion(mesh, at, 1)(4096)
    found = ESTIMATORS[tool].make(mesh, at, 1)(1024)
    assert np.abs(found - right).max() <= 5 * 0.5 / 32  # the greatest standard deviation of a ray
    assert abs(found.mean() - right.mean()) <= 5 * 0.27 / 320


def test_peers_rays_are_cosine_weighted():
    """Their mean cosine is 2/3, whatever the normal; and they start off the surface."""
    mesh, at = sample_scene("bunny", 64)
    seen = []
    share = build_open_fraction(mesh, at, 1, lambda o, d: seen.append((o, d)) or np.zeros(len(o), bool))(1000)
    assert (share == 1.0).all()
    origins, directions = (np.concatenate(arrays).reshape(64, 1000, 3) for arrays in zip(*seen, strict=True))
    cosine = np.einsum("psk,pk->ps", directions, at.normal)
    assert abs(cosine.mean() - 2 / 3) <= 0.005  # 5 of 0.236 / sqrt(64,000)
    assert np.abs(np.linalg.norm(directions, axis=2) - 1.0).max() <= 1e-5
    assert np.abs(
        np.einsum("psk,pk->ps", origins - at.position[:, None], at.normal) - 1e-5 * measure_size(mesh)
    ).max() <= 1e-6 * measure_size(mesh)
