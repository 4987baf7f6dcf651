"""Lobes of many points whose directions are made in parts: how much memory they take beside their inputs."""

import pickle
import tracemalloc

import numpy as np
import pytest

import warpsample as ws
from warpsample.distributions.by_point import rows

POINTS, SAMPLES, PART = 400_000, 16, 4096


def inputs(points=POINTS, seed=4):
    """Normals, roughnesses and views to a camera, as float32."""
    rng = np.random.default_rng(seed)
    normal, view = rng.normal(size=(2, points, 3)).astype(np.float32)
    view[:, 2] = np.abs(view[:, 2])
    return normal, rng.uniform(0.05, 0.6, points).astype(np.float32), view


def shiny(rough, view):
    return ws.Reflection(ws.VisibleGGX(rough, view=view), view=view)


def in_slices(normal, lobe):
    """Sum of the heights of all directions, made in slices of the points."""
    total, out = 0.0, np.empty((PART, SAMPLES, 3), np.float32)
    for first in range(0, len(normal), PART):
        part = slice(first, min(first + PART, len(normal)))
        d = ws.sample_directions(
            normal[part],
            SAMPLES,
            distribution=lobe.take(part),
            first_point=first,
            pdf=True,
            out=out[: part.stop - first],
        )
        total += d.vectors[..., 2].sum(dtype=np.float64)
    return total


def over_dask(normal, lobe):
    """The same sum, over Dask."""
    cluster = pytest.importorskip("warpsample.cluster")
    found = cluster.sample_directions(normal, SAMPLES, distribution=lobe, pdf=True, chunk=PART)
    return float(found.vectors[..., 2].sum(dtype=np.float64).compute(num_workers=2))


@pytest.mark.parametrize(
    ("stream", "most"),
    [
        (in_slices, 0.75),  # the lobe takes 4/7 of the inputs: roughness and view once, although two lobes have the view
        pytest.param(over_dask, 1.6, marks=pytest.mark.slow),  # and a copy of the normals, 3/7; chunks of two threads, 2/5
    ],
)
def test_streamed_directions_take_little_memory_beside_their_inputs(stream, most, monkeypatch):
    """10^7 points took 2.1 times the inputs in slices of 2^16 points, and 2.6 times over Dask, inputs included.

    Directions and densities of all points would take nine times the inputs.
    """
    monkeypatch.setattr(rows, "_PART", PART)  # 2^16 rows, of which 10^7 points have many
    normal, rough, view = inputs()
    expected = stream(normal[:PART], shiny(rough[:PART], view[:PART]))  # kernels, modules
    assert np.isfinite(expected)
    tracemalloc.start()
    try:
        stream(normal, shiny(rough, view))
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < most * (normal.nbytes + rough.nbytes + view.nbytes)


def test_lobes_share_the_memory_of_equal_views(monkeypatch):
    """Views are compared in parts: a difference in the first, the last or in a row that is NaN must be found."""
    monkeypatch.setattr(rows, "_PART", 64)
    _, rough, view = inputs(200)
    view[[3, 150], 2] = -1.0
    lobe = shiny(rough, view)
    assert lobe.view is lobe.lobe.view
    assert not lobe.view.flags.writeable
    assert lobe.take(slice(10, 60)) == shiny(rough[10:60], view[10:60])
    assert pickle.loads(pickle.dumps(lobe)) == lobe
    for row in (0, 63, 64, 199, 150):
        other = view.copy()
        other[row] = (0.0, 0.6, 0.8)
        mixed = ws.Reflection(ws.VisibleGGX(rough, view=other), view=view)
        assert mixed.view is not mixed.lobe.view
        assert mixed.view.tobytes() == lobe.view.tobytes()
        assert mixed.lobe.view.tobytes() == ws.VisibleGGX(rough, view=other).view.tobytes()
    below = ws.RoughDielectric(ws.VisibleGGX(rough, view=view), view=view)  # a view from below is valid here
    assert np.array_equal(np.isnan(below.view[:, 0]), np.zeros(200, bool))
    assert np.array_equal(below.view[[3, 150], 2] < 0.0, [True, True])
