"""The parts of an interval: the variance that edges lead to, one stratum by hand, finite numbers, no change by skipping."""

from math import pi

import numpy as np
import pytest
from estimate_cases import irradiance
from scipy.stats import t
from streams import fibonacci_stream

import warpsample as ws


@pytest.mark.parametrize("name", ws.sequences.names())
@pytest.mark.parametrize("count", [4, 8, 16, 32])
def test_an_edge_leaves_the_variance_that_a_sequence_says(name, count):
    """Random straight edges cross the unit square; the variance is half of the count to the power of `edge`."""
    rng = np.random.default_rng(0)
    angle, offset = rng.uniform(0, 2 * pi, 20_000), rng.uniform(-0.75, 0.75, 20_000)
    normal = np.stack([np.cos(angle), np.sin(angle)], axis=1)[:, None]
    sets = [ws.sample_square(name, points=20_000, count=count, seed=seed).astype(np.float64) - 0.5 for seed in (1, 2)]
    beyond = np.array([((u * normal).sum(axis=2) > offset[:, None]).sum(axis=1) for u in sets])
    free = beyond.sum(axis=0)
    mixed = (free > 0) & (free < 2 * count)
    binomial = free * (2 * count - free) / (2 * count - 1)
    expected = np.minimum(binomial, ws.sequences.get(name).edge_variance(count))[mixed].mean()
    # The law is a power for all counts at once: within a quarter, which widens an interval by an eighth.
    assert abs((np.diff(beyond, axis=0)[0, mixed] ** 2).mean() / expected - 1.0) <= 0.25


def test_one_cell_by_hand(bunny, points):
    """Below 32 rays there is one stratum: other calls count its replicates' free rays, and NumPy computes the posterior."""
    count, seed = 30, 5
    found = ws.ambient_occlusion(bunny, points, count, seed=seed)
    ways = [fibonacci_stream(points.normal, 15, seed, stream)[1] for stream in (0, 1)]
    first, second = ((ws.trace(bunny, points, way, any_hit=True).face < 0).sum(axis=1) for way in ways)
    free = first + second
    mixed = (free > 0) & (free < count)
    binomial = np.minimum(free * (count - free) / (count - 1), 0.5 * 15**0.25)
    unseen = np.where(np.minimum(free, count - free) == 1, 3.85, 0.6)
    edges = np.where(mixed, binomial + unseen, 1.64**2)
    squares = (first - second) ** 2
    worth = np.where(mixed, 16.0, 9.0) / np.maximum(squares / edges, 1.0) ** 2
    assert np.abs(found.degrees_of_freedom - (worth + mixed)).max() <= 1e-5  # float32 of numbers up to 17
    spread = np.sqrt((worth * edges + mixed * squares) / (worth + mixed)) / count
    assert np.abs(found.spread - spread).max() <= 1e-7  # float32 of numbers below 1
    half = t.ppf(0.9, found.degrees_of_freedom) * found.spread
    lower, upper = found.interval(0.8)
    assert np.abs(upper - np.minimum(found.value + half, 1.0)).max() <= 1e-6
    assert np.abs(lower - np.maximum(found.value - half, 0.0)).max() <= 1e-6


def _estimates(mesh, where, **options):
    yield ws.ambient_occlusion(mesh, where, 500, **options)
    yield ws.ambient_occlusion(mesh, where, 300, max_distance=0.3, falloff=1.5, **options)
    yield ws.sky_view_factor(mesh, where, 300, up=(0.3, 1.0, 0.2), **options)
    yield ws.bent_normals(mesh, where, 300, **options)
    yield irradiance(mesh, where, 40, **options)


@pytest.mark.slow
def test_skipping_and_threads_change_no_interval(bunny, points):
    away = points.position + 0.01 * points.normal
    where = ws.SurfacePoints(np.concatenate([points.position, away]), np.concatenate([points.normal, points.normal]))
    with_skipping = list(_estimates(bunny, where))
    for others in (_estimates(bunny, where, skip=False), _estimates(bunny, where, workers=1)):
        for found, other in zip(with_skipping, others, strict=True):
            for mine, its in zip(found.interval(), other.interval(), strict=True):
                assert np.array_equal(mine, its)
            assert found.spread.shape == found.degrees_of_freedom.shape == found.value.shape


@pytest.mark.slow
def test_every_number_is_finite(bunny, points):
    for found in _estimates(bunny, points):
        lower, upper = found.interval(0.9999)
        assert np.isfinite(lower).all()
        assert (lower < upper).all()
        assert (found.degrees_of_freedom >= 1.0).all()
    nowhere = ws.SurfacePoints([[0, 0, 0], [np.nan, 0, 0]], np.float32([[0, 0, 0], [0, 0, 1]]))
    for found in _estimates(bunny, nowhere):
        for end in found.interval():
            assert (end == 0.0).all()
    dark = ws.irradiance(bunny, points, np.zeros((2, 2)), 64).interval()
    assert (dark.lower == 0.0).all()
    assert (dark.upper == 0.0).all()
    none = ws.ambient_occlusion(bunny, ws.SurfacePoints(np.zeros((0, 3)), np.zeros((0, 3), np.float32)), 64)
    assert none.interval().lower.shape == (0,)


@pytest.mark.slow
def test_intervals_follow_the_result(bunny, points):
    """They follow it through a tolerance's run, a picture's one channel and its unit, and widen with the level."""
    with pytest.warns(UserWarning, match="tolerance: got 1e-09"):
        tolerant = ws.ambient_occlusion(bunny, points, 512, tolerance=1e-9)
    plain = ws.ambient_occlusion(bunny, points, 512)
    assert np.array_equal(tolerant.interval().upper, plain.interval().upper)
    grey = ws.irradiance(bunny, points, np.ones((2, 2)), 256).interval()
    assert grey.lower.shape == (600,)
    width = np.subtract(grey.upper, grey.lower)
    occlusion = ws.ambient_occlusion(bunny, points, 256).interval()
    # The same rays, times pi; the expectation of weights is worth less than that of counts, so its quantile is larger.
    ratio = width.mean() / np.subtract(occlusion.upper, occlusion.lower).mean()
    assert pi <= ratio <= 1.4 * pi
    widths = [np.subtract(*plain.interval(level)[::-1]).mean() for level in (0.5, 0.9, 0.99)]
    assert widths == sorted(set(widths))


@pytest.mark.parametrize("level", [0.0, 1.0, -1, 95, float("nan"), "0.95", None, True, [0.9]])
def test_bad_levels_are_named(bunny, points, level):
    found = ws.ambient_occlusion(bunny, points, 2)
    with pytest.raises((TypeError, ValueError), match="^level: got .*, want a number from"):
        found.interval(level)
