"""Sky matrices against quadrature, sky view factors and themselves: turned, in parts, on threads, without skipping."""

from dataclasses import replace
from math import hypot

import numpy as np
import pytest
from estimate_cases import at, same, street
from meshes import BOX, soup, turned
from sky_cases import form_factors

import warpsample as ws
from warpsample.bench import scenes
from warpsample.radiation.sky.prepared import prepare_sky

TILTS = np.array(
    [[0, 0, 1], [0, 1, 0], [1, 0, 0], [-0.3, 0.5, 0.6], [0.2, -0.9, -0.3], [0.7, 0.1, -0.7], [1, 0.3, 1e-7], [1e-4, 0, 1]]
)
FAR = ws.as_mesh(([(0, 0, -2), (1, 0, -2), (0, 1, -2)], [(0, 1, 2)]))  # below all skies


def test_open_planes_are_exact_and_cost_no_ray():
    found = ws.sky_matrix(FAR, at(np.zeros((len(TILTS), 3)), TILTS), 64)
    exact = form_factors(TILTS)
    assert np.abs(found.value - exact).max() <= 1e-6
    assert found.rays.sum() == 0
    assert (found.standard_error == 0.0).all()
    assert found.skipped.open_points == len(TILTS)
    assert found.skipped.patches_below == np.count_nonzero(found.value == 0.0)
    assert found.skipped.open_patches + found.skipped.patches_below == found.value.size
    normals = TILTS / np.linalg.norm(TILTS, axis=1, keepdims=True)
    assert np.abs(found.value.sum(axis=1, dtype=np.float64) - 0.5 * (1.0 + normals[:, 2])).max() <= 1e-6


@pytest.mark.parametrize("tested", ["mirrored", "half a patch", "over pi twice", "the ground first"])
def test_wrong_patches_would_be_seen(tested):
    """What the test above compares with, changed by each of the known mistakes, is far from what is found."""
    found = ws.sky_matrix(FAR, at(np.zeros((len(TILTS), 3)), TILTS), 64).value
    half = np.array([[np.cos(a), np.sin(a)] for a in [np.radians(6.0)]])[0]
    turn = np.array([[half[0], -half[1], 0.0], [half[1], half[0], 0.0], [0.0, 0.0, 1.0]])
    wrong = {
        "mirrored": lambda: form_factors(TILTS * [-1, 1, 1], cells=40),
        "half a patch": lambda: form_factors(TILTS @ turn, cells=40),
        "over pi twice": lambda: form_factors(TILTS, cells=40) / np.pi,
        "the ground first": lambda: np.roll(form_factors(TILTS, cells=40), 1, axis=1),
    }
    assert np.abs(found - wrong[tested]()).max() >= 1e-3


@pytest.mark.parametrize("name", ["reinhart2", "reinhart4"])
def test_finer_patches_of_open_planes(name):
    multiple = {"reinhart2": 2, "reinhart4": 4}[name]
    found = ws.sky_matrix(FAR, at(np.zeros((4, 3)), TILTS[3:7]), 64, patches=name)
    assert np.abs(found.value - form_factors(TILTS[3:7], multiple=multiple, cells=60)).max() <= 1e-6
    assert found.rays.sum() == 0


@pytest.mark.parametrize("count", [1024, 16384])
def test_a_street_by_quadrature(count):
    width, height, x = 1.0, 1.7, 0.3
    found = ws.sky_matrix(street(width, height), at((x, 0.4, 0.0), (0, 0, 1), 64), count)

    def is_sky(w):
        return w[:, 2] * np.where(w[:, 0] > 0.0, width - x, x) > height * np.abs(w[:, 0])

    exact = form_factors([0, 0, 1], is_sky, cells=200)[0]
    error = found.value - exact
    bars = np.sqrt(np.mean(np.square(found.standard_error.astype(np.float64)), axis=0) / 64)
    assert (np.abs(error.mean(axis=0)) <= 5.0 * bars + 1e-5).all()
    limit = 5e-4 * float(np.float_power(1024 / count, 0.75))  # independent rays: 1.8e-3 at 1,024
    assert np.sqrt(np.mean(error**2)) <= limit
    mean = 0.5 * (x / hypot(x, height) + (1 - x) / hypot(1 - x, height))
    assert abs(found.value.sum(axis=1, dtype=np.float64).mean() - mean) <= 4.0 * np.sqrt(np.square(bars).sum())
    assert np.array_equal(found.value[:, exact == 0.0], np.zeros((64, np.count_nonzero(exact == 0.0))))


def test_a_wall_shades_the_patches_before_it():
    """A wall as high as it is far away, east of the point: it hides what is in the east, and below its edge."""
    wall = ws.as_mesh(([(1, -50, -1), (1, 50, -1), (1, 50, 1), (1, -50, 1)], [(0, 1, 2), (0, 2, 3)]))
    normal = (0.2, 0.3, 1.0)
    found = ws.sky_matrix(wall, at((0, 0, 0), normal, 32), 2048)
    exact = form_factors(normal, lambda w: w[:, 2] > w[:, 0], cells=200)[0]
    bars = np.sqrt(np.mean(np.square(found.standard_error.astype(np.float64)), axis=0) / 32)
    assert (np.abs(found.value.mean(axis=0) - exact) <= 5.0 * bars + 1e-5).all()
    assert found.skipped.closed_patches > 0
    assert found.skipped.open_patches > 32 * 50


@pytest.mark.parametrize("name", ["city", "bunny"])
def test_rows_sum_to_the_sky_view_factor(bunny, name):
    mesh = bunny if name == "bunny" else scenes.city(8)
    points = ws.sample_surface(mesh, 400, seed=3)
    up = (0.2, -0.1, 1.0)
    view = ws.sky_view_factor(mesh, points, 16384, up=up)
    for patches, count in (("tregenza", 64), ("tregenza", 1024), ("reinhart2", 512)):
        found = ws.sky_matrix(mesh, points, count, patches=patches, up=up, north=(1, 1, 0))
        sums = found.value.sum(axis=1, dtype=np.float64)
        bars = np.square(found.standard_error.astype(np.float64)).sum(axis=1) + np.square(
            view.standard_error, dtype=np.float64
        )
        # No bar is told by few differences: all points together, and each by what is rare among them.
        assert abs((sums - view.value).mean()) <= 4.0 * np.sqrt(bars.sum()) / 400
        assert np.mean(np.square(sums - view.value)) <= 1.5 * bars.mean()
        assert (found.rays <= count + 2 * len(found.patches)).all()


def test_skipping_threads_parts_and_masks_change_no_bit(bunny, monkeypatch):
    meshes = (bunny, scenes.city(8), soup(200), BOX)
    for mesh in meshes:
        points = ws.sample_surface(mesh, 150, seed=3)
        for count, patches in ((40, "tregenza"), (1024, "reinhart2")):
            options = {"up": (0.1, 0.2, 1.0), "north": (1.0, 1.0, 0.0), "seed": 5}
            right = ws.sky_matrix(mesh, points, count, patches=patches, **options)
            plain = ws.sky_matrix(mesh, points, count, patches=patches, **options, skip=False)
            assert same(right, plain)
            assert (plain.rays >= right.rays).all()
            assert plain.skipped.open_patches == plain.skipped.closed_patches == 0
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    monkeypatch.setattr("warpsample.tracing.order.MANY_FACES", 1)
    monkeypatch.setattr("warpsample.tracing.order._FEW_POINTS", 1)
    points = ws.sample_surface(bunny, 150, seed=3)
    right = ws.sky_matrix(bunny, points, 300, seed=7, first_point=2**40)
    assert same(ws.sky_matrix(bunny, points, 300, seed=7, first_point=2**40, workers=3), right)
    half = ws.SurfacePoints(points.position[50:], points.normal[50:], points.face[50:])
    part = ws.sky_matrix(bunny, half, 300, seed=7, first_point=2**40 + 50)
    assert np.array_equal(part.value, right.value[50:])
    active = np.arange(150) % 3 == 0
    masked = ws.sky_matrix(bunny, points, 300, seed=7, first_point=2**40, active=active)
    assert np.array_equal(masked.value, np.where(active[:, None], right.value, 0.0))
    assert masked.counts() == {ws.PointStatus.OK: 50, ws.PointStatus.INACTIVE: 100}
    assert masked.skipped.points == 100
    assert not same(ws.sky_matrix(bunny, points, 300, seed=8, first_point=2**40), right)


def test_wrong_shafts_would_be_seen(bunny, monkeypatch):
    def shifted(sky):
        own = prepare_sky(sky)
        return replace(own, shafts=np.roll(own.shafts, 7, axis=0), group_shafts=np.roll(own.group_shafts, 7, axis=0))

    points = ws.sample_surface(bunny, 100, seed=3)
    right = ws.sky_matrix(bunny, points, 300)
    assert same(ws.sky_matrix(bunny, points, 300), right)
    monkeypatch.setattr("warpsample.radiation.sky.sky_matrix.prepare_sky", shifted)
    assert not same(ws.sky_matrix(bunny, points, 300), right)


def test_turning_everything_turns_nothing():
    mesh, q = scenes.city(4), turned(3)
    points = ws.sample_surface(mesh, 60, seed=2)
    there = ws.Mesh(mesh.vertices @ q.T, mesh.faces)
    moved = ws.SurfacePoints(points.position @ q.T, points.normal.astype(np.float64) @ q.T, points.face)
    right = ws.sky_matrix(mesh, points, 4096)
    found = ws.sky_matrix(there, moved, 4096, up=q @ [0, 0, 1], north=q @ [0, 1, 0])
    # The same rays, but for those that pass an edge within rounding.
    assert np.mean(np.abs(found.value - right.value) > 1e-6) <= 1e-3
    assert np.abs(found.value - right.value).mean(dtype=np.float64) <= 1e-6
    assert found.rays.sum() > 0


def test_in_a_closed_box_it_is_dark():
    outside = ws.sample_surface(BOX, 200)
    inside = ws.SurfacePoints(outside.position, -outside.normal, outside.face)
    for skip in (True, False):
        found = ws.sky_matrix(BOX, inside, 64, skip=skip)
        assert not found.value.any()
        # Rays do not prove that the box has no hole: 0.32 of a ray, of at least two in a patch of at most 0.0145.
        assert 0.0 < found.standard_error.max() < 0.16 * 0.0145


def test_error_bars_are_honest(bunny):
    """The mean of squared bars, over runs and patches, is 1 to 1.6 times the variance between the runs.

    It is more than 1, because an edge may pass between rays that agree, and in most patches none does.
    """
    for mesh in (bunny, scenes.city(8)):
        points = ws.sample_surface(mesh, 200, seed=9)
        for count, patches in ((128, "tregenza"), (1024, "tregenza")):
            runs = [ws.sky_matrix(mesh, points, count, patches=patches, seed=s) for s in range(24)]
            between = np.var([run.value.astype(np.float64) for run in runs], axis=0, ddof=1).mean()
            estimated = np.mean([np.square(run.standard_error.astype(np.float64)).mean() for run in runs])
            assert 0.9 * between <= estimated <= 1.7 * between


def test_a_fold_is_the_matrix_times_skies(bunny, monkeypatch):
    points = ws.sample_surface(bunny, 150, seed=3)
    points.normal[7] = 0.0
    matrix = ws.sky_matrix(bunny, points, 200, seed=2)
    skies = np.random.default_rng(1).uniform(-1.0, 2.0, (145, 70))
    exact = matrix.value.astype(np.float64) @ skies
    bars = np.sqrt(np.square(matrix.standard_error.astype(np.float64)) @ np.square(skies))
    right = ws.sky_matrix(bunny, points, 200, fold=skies, seed=2)
    assert np.abs(right.value - exact).max() <= 1e-6
    assert np.abs(right.standard_error - bars).max() <= 1e-7
    assert np.array_equal(right.rays, matrix.rays)
    assert right.skipped == matrix.skipped
    assert not right.value[7].any()
    monkeypatch.setattr("warpsample.radiation.sky.sky_matrix._BLOCK_BYTES", 8 * 145 * 37)
    assert same(ws.sky_matrix(bunny, points, 200, fold=skies, seed=2, workers=1), right)
    alone = ws.sky_matrix(bunny, points, 200, fold=skies[:, 3], seed=2)
    assert alone.value.shape == (150,)
    assert np.array_equal(alone.value, right.value[:, 3])
    assert np.array_equal(alone.standard_error, right.standard_error[:, 3])


def test_points_far_off_and_nowhere():
    mesh = scenes.city(4)
    points = at(
        [(1e6, 0, 0), (60, 60, 1e5), (np.nan, 0, 0), (1e6, 0, 0)], [(0, 0, 1), (0, 0, -1), (0, 0, 1), (np.inf, 0, 0)]
    )
    found = ws.sky_matrix(mesh, points, 64)
    assert found.counts() == {
        ws.PointStatus.OK: 2,
        ws.PointStatus.NONFINITE_NORMAL: 1,
        ws.PointStatus.NONFINITE_POSITION: 1,
    }
    assert np.abs(found.value[0] - form_factors([0, 0, 1], cells=80)[0]).max() <= 1e-6
    assert not found.value[1:].any()
    none = ws.sky_matrix(mesh, at(np.zeros((0, 3)), np.zeros((0, 3))), 64)
    assert none.value.shape == (0, 145)
    assert ws.sky_matrix(mesh, at(np.zeros((0, 3)), np.zeros((0, 3))), 64, fold=np.ones((145, 3))).value.shape == (0, 3)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"patches": "klems"}, r"patches: got 'klems', want one of tregenza, reinhart2, reinhart4"),
        ({"north": (0, 0, 2)}, r"north: got \(0, 0, 2\), which is along up"),
        (
            {"fold": np.ones(146)},
            r"fold: got shape \(146,\), want numbers from -1e37 to 1e37 of shape \(145,\) or \(145, T\)",
        ),
        ({"fold": np.ones((145, 2, 2))}, r"fold: got shape \(145, 2, 2\), want"),
        ({"fold": np.full(145, np.nan)}, r"fold: got NaN or a number beyond 1e\+37, want"),
        ({"fold": np.full(145, 1e300)}, r"fold: got NaN or a number beyond 1e\+37, want"),  # infinite in float32
        ({"count": 1}, r"count: got 1, want"),
    ],
)
def test_bad_input_is_refused(options, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        ws.sky_matrix(FAR, at((0, 0, 0), (0, 0, 1)), **{"count": 64, **options})
