"""The benchmark of the kernel API: all ways to a result give that result."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of, untracked
from meshes import soup

import warpsample as ws
from warpsample.bench import kernels


@pytest.mark.thorough
def test_ways_to_a_mean_agree(monkeypatch):
    monkeypatch.setattr(kernels, "_TOTAL", 1 << 14)
    fused, directions, summed = (work() for work in kernels.build_means(256).values())
    assert directions.shape == (64, 256, 3)
    assert np.abs(fused.value - summed).max() <= 6.0 * fused.standard_error.max() + 1e-3


@pytest.mark.thorough
def test_ways_to_occlusion_agree(monkeypatch):
    """The user's kernel has a point's own 256 rays, each 0 or 1: its error is at most that of independent ones."""
    monkeypatch.setitem(kernels.SCENES, "bunny", soup)
    own, cast, skipped = (work() for work in kernels.build_occlusions("bunny", 64).values())
    assert np.array_equal(cast.value, skipped.value)
    assert 0.01 < cast.value.mean() < 0.99
    assert np.abs(own.numpy() - cast.value).max() <= 5.3 * np.sqrt(0.25 / 256 + cast.standard_error.max() ** 2)


@pytest.mark.thorough
def test_all_is_measured_and_shown(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(kernels, "_TOTAL", 1 << 14)
    monkeypatch.setattr(kernels, "SCENES", {"city": lambda: ws.load_mesh("courtyard")})
    settings = {"points": 64, "repeats": 2}
    found = kernels.measure(untracked, **settings)
    assert len(found["rows"]) == 3 * len(kernels.COUNTS) + 3
    assert all(row.nanoseconds.median > 0.0 and row.ours.median > 0.0 and len(row.seconds) == 2 for row in found["rows"])
    lines = lines_of("kernels", settings, found, capsys)
    assert [line for line in lines if line.startswith(" city ") and "ambient_occlusion, skip=False" in line]
    assert draw_pictures("kernels", found, tmp_path) == ["kernels.png"]
