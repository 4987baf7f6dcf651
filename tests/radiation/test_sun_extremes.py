"""Suns over meshes of any scale and shape, from afar, and from points that are none; and bad input."""

import re

import numpy as np
import pytest
from sun_cases import GRAZING, at, call_of, mixed, traced, unit, year

import warpsample as ws
from warpsample.bench import scenes
from warpsample.radiation.sun.direct_sun import SunCall

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too


@pytest.mark.parametrize("scale", [1e-28, 1e-3, 1e6, 1e34])
def test_scale_changes_nothing(scale):
    vertices, faces = ws.load_mesh("courtyard").vertices, ws.load_mesh("courtyard").faces
    scale = 2.0 ** np.round(np.log2(scale))
    suns = year(40)
    answers = []
    for size in (1.0, scale):
        mesh = ws.as_mesh((size * vertices, faces))
        points = ws.face_centers(mesh)
        some = slice(None, None, 9)
        answers.append(
            ws.direct_sun(mesh, ws.SurfacePoints(points.position[some], points.normal[some], points.face[some]), suns)
        )
    assert np.array_equal(*answers)
    assert 0.05 < answers[0].mean() < 0.95


def test_far_from_the_origin_and_far_from_the_mesh():
    city = scenes.city(6)
    suns = year(40)
    moved = ws.as_mesh((city.vertices + np.array([500_000.0, 5_400_000.0, 0.0]), city.faces))
    points = ws.sample_surface(moved, 200, seed=1)
    right, cosine = traced(moved, points, suns)
    clear = np.abs(cosine) > GRAZING
    assert np.array_equal(ws.direct_sun(moved, points, suns)[clear], right[clear])
    rng = np.random.default_rng(3)
    for distance in (1e4, 1e6, 1e9):
        way = unit(rng.normal(size=(60, 3)))
        away = at(120.0 + distance * way, -way)
        suns = -way[:40] + 30.0 / distance * rng.normal(size=(40, 3))
        right, cosine = traced(city, away, suns)
        clear = np.abs(cosine) > GRAZING
        assert np.array_equal(ws.direct_sun(city, away, suns)[clear], right[clear])
        assert (~right[clear]).any()
        skipping, plain = (ws.direct_sun(city, away, suns, disc=1.0, skip=skip) for skip in (True, False))
        assert np.array_equal(skipping, plain)


@pytest.mark.parametrize("shape", [(1.0, 1.0, 1e6), (1e-6, 1.0, 1.0)])
def test_needles(bunny, shape):
    mesh = ws.as_mesh((bunny.vertices * shape, bunny.faces))
    points, suns = ws.sample_surface(mesh, 60, seed=5), np.concatenate([year(60), mixed(np.random.default_rng(4), 100)])
    right, cosine = traced(mesh, points, suns)
    got = ws.direct_sun(mesh, points, suns)
    clear = np.abs(cosine) > GRAZING
    assert np.array_equal(got[clear], right[clear])
    assert np.array_equal(got, ws.direct_sun(mesh, points, suns, skip=False))


def test_points_without_a_normal_or_a_place_are_dark(bunny, points):
    position, normal = points.position[:6].copy(), points.normal[:6].astype(np.float64)
    normal[1], normal[2], position[3], normal[4] = 0.0, np.nan, np.inf, [np.inf, 0, 0]
    broken = ws.SurfacePoints(position, normal, points.face[:6])
    suns = np.concatenate([year(50), -year(50)])
    for disc in (0.0, 0.533):
        got = ws.direct_sun(bunny, broken, suns, disc=disc)
        assert not got[1:5].any()
        assert got[[0, 5]].any(axis=1).all()
    assert np.array_equal(ws.direct_sun(bunny, broken, suns, weights=np.ones(len(suns)))[1:5], np.zeros(4))


def test_no_points(bunny):
    none = ws.SurfacePoints(np.zeros((0, 3)), np.zeros((0, 3)))
    suns = np.eye(3)
    assert ws.direct_sun(bunny, none, suns).shape == (0, 3)
    assert ws.direct_sun(bunny, none, suns, disc=1.0).dtype == np.float32
    assert ws.direct_sun(bunny, none, suns, weights=np.ones(3)).shape == (0,)
    assert ws.direct_sun(bunny, none, suns, weights=np.ones((3, 2))).shape == (0, 2)


# Bad input

UP = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 1.0]])


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"directions": np.zeros((0, 3))}, "directions: got shape (0, 3), want (T, 3), T from 1 to 16777216"),
        ({"directions": np.array([0.0, 0.0, 1.0])}, "directions: got shape (3,), want (T, 3), T from 1 to 16777216"),
        ({"directions": np.ones((2, 4))}, "directions: got shape (2, 4), want (T, 3), T from 1 to 16777216"),
        (
            {"directions": UP * [[1.0], [0.0]]},
            "directions: got [0.0, 0.0, 0.0] in row 1, want finite numbers, not all 0",
        ),
        (
            {"directions": np.array([[0.0, np.nan, 1.0]])},
            "directions: got [0.0, nan, 1.0] in row 0, want finite numbers, not all 0",
        ),
        (
            {"directions": np.array([[np.inf, 0.0, 1.0]])},
            "directions: got [inf, 0.0, 1.0] in row 0, want finite numbers, not all 0",
        ),
        ({"weights": np.ones(3)}, "weights: got shape (3,), want (2,) or (2, M), a row for each direction"),
        ({"weights": np.ones((3, 2))}, "weights: got shape (3, 2), want (2,) or (2, M), a row for each direction"),
        ({"weights": np.ones((2, 0))}, "weights: got shape (2, 0), want (2,) or (2, M), a row for each direction"),
        ({"weights": np.array([1.0, np.nan])}, "weights: got NaN or infinity, want finite numbers"),
        ({"disc": -0.5}, "disc: got -0.5, want a number from 0 to 45"),
        ({"disc": 180.0}, "disc: got 180.0, want a number from 0 to 45"),
        ({"disc": float("nan")}, "disc: got nan, want a number from 0 to 45"),
        (
            {"cosine": True},
            "cosine: got True without weights, want weights for the cosine to multiply; or pass cosine=False",
        ),
        ({"points": np.ones((2, 3))}, "points: got a NumPy array, want SurfacePoints, such as the result of sample_surface"),
    ],
)
def test_bad_input_is_named(bunny, points, monkeypatch, wrong, said):
    monkeypatch.setattr(SunCall, "answer", lambda *_: pytest.fail("work has started"))
    with pytest.raises((TypeError, ValueError), match=f"^{re.escape(said)}$"):
        ws.direct_sun(**{"mesh": bunny, "points": points, "directions": UP, **wrong})


def test_more_than_fits_is_refused_first(bunny, points, monkeypatch):
    many = at(np.broadcast_to(points.position[:1], (10**6, 3)))
    suns = np.broadcast_to(UP[:1], (10**7, 3))
    with pytest.raises(
        MemoryError, match=r"^10,000,000 suns of 1,000,000 points need .* are free; pass fewer points at a time$"
    ):
        call_of(bunny, many, suns).answer()
