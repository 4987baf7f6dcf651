"""Which suns a point sees: the same as rays tell, whatever is skipped; closed forms; discs; sums; and bad input."""

import re

import numpy as np
import pytest
from meshes import CLOSED, soup
from sun_cases import mixed, traced, unit, year

import warpsample as ws
from warpsample.bench import scenes
from warpsample.host.arguments import check_seed
from warpsample.radiation.direct_sun import SunCall

GRAZING = 1e-6  # cosines whose sign float32 does not tell

MESHES = {
    "bunny": lambda: None,
    "city": lambda: scenes.city(12),
    "hostile": lambda: soup(300),
    "torus": lambda: CLOSED["torus"][0],
    "courtyard": lambda: ws.load_mesh("courtyard"),
}


def mesh_of(name, bunny):
    return bunny if name == "bunny" else MESHES[name]()


def call_of(mesh, points, suns, disc=0.0, skip=True):
    return SunCall(mesh, points, suns, None, disc, check_seed(0), 0, None, skip, 1, False)


def plane_and(*others):
    """A square of 200 about 0, z up, and other (vertices, faces)."""
    parts = [(np.array([[-100, -100, 0], [100, -100, 0], [100, 100, 0], [-100, 100, 0.0]]), [[0, 1, 2], [0, 2, 3]]), *others]
    first = np.cumsum([0, *(len(v) for v, _ in parts)])
    return ws.as_mesh(
        (
            np.concatenate([v for v, _ in parts]),
            np.concatenate([np.array(f) + i for (_, f), i in zip(parts, first, strict=False)]),
        )
    )


def upright(low, high, x=0.0):
    """A rectangle at x, from low to high in (y, z)."""
    (a, b), (c, d) = low, high
    return np.array([[x, a, b], [x, c, b], [x, c, d], [x, a, d]], float), [[0, 1, 2], [0, 2, 3]]


def at(position, normal=(0.0, 0.0, 1.0)):
    position = np.atleast_2d(np.asarray(position, float))
    return ws.SurfacePoints(position, np.broadcast_to(np.asarray(normal, float), position.shape).copy())


# The same as by rays


@pytest.mark.parametrize("name", MESHES)
def test_a_point_sees_what_its_rays_tell(bunny, name):
    mesh, rng = mesh_of(name, bunny), np.random.default_rng(3)
    some = ws.sample_surface(mesh, 60, seed=3)
    floating = ws.SurfacePoints(some.position + 0.02 * mesh.diagonal * unit(some.normal), some.normal)
    corners = ws.vertex_points(mesh)
    few = np.linspace(0, len(corners) - 1, 40).astype(int)
    for points in (some, floating, ws.SurfacePoints(corners.position[few], corners.normal[few])):
        for suns in (year(30), mixed(rng), mixed(rng).astype(np.float32), rng.normal(size=(5, 3))):
            right, cosine = traced(mesh, points, suns)
            clear = np.abs(cosine) > GRAZING
            skipping, plain = (ws.direct_sun(mesh, points, suns, skip=skip) for skip in (True, False))
            assert skipping.dtype == bool
            assert np.array_equal(skipping, plain)
            assert np.array_equal(skipping[clear], right[clear])


def test_a_side_is_that_of_the_normal_not_of_the_face(bunny):
    some = ws.sample_surface(bunny, 100, seed=4)
    suns = year(60)
    inside = ws.SurfacePoints(some.position, -some.normal, some.face)
    right, cosine = traced(bunny, inside, suns)
    got = ws.direct_sun(bunny, inside, suns)
    clear = np.abs(cosine) > GRAZING
    assert np.array_equal(got[clear], right[clear])
    bent = ws.SurfacePoints(some.position, some.normal + 0.5 * np.random.default_rng(1).normal(size=(100, 3)), some.face)
    outwards = (unit(some.normal) * bent.normal).sum(axis=1, keepdims=True) > 0.0
    right, cosine = traced(bunny, bent, suns)
    got = ws.direct_sun(bunny, bent, suns)
    both = outwards & (unit(some.normal) @ suns.T > GRAZING) & (np.abs(cosine) > GRAZING)
    assert np.array_equal(got[both], right[both])
    assert np.array_equal(got, ws.direct_sun(bunny, bent, suns, skip=False))


def test_most_pairs_need_no_ray(bunny):
    for mesh, most in ((bunny, 0.12), (scenes.city(16), 0.2)):
        points, suns, tally = ws.sample_surface(mesh, 200, seed=1), year(4), np.zeros((200, 3), np.int32)
        seen = call_of(mesh, points, suns).answer(tally)
        lit, known, cast = tally.sum(axis=0) / seen.size
        assert cast <= most
        assert lit >= 0.5 * seen.mean()
        assert known > 0.0
        plain = np.zeros((200, 3), np.int32)
        assert np.array_equal(call_of(mesh, points, suns, skip=False).answer(plain), seen)
        assert plain[:, :2].sum() == 0
        assert plain[:, 2].sum() == (unit(points.normal) @ suns.T > 0.0).sum()


# Closed forms


def test_a_closed_box_is_dark(bunny):
    box = CLOSED["box"][0]
    outside = ws.sample_surface(box, 300, seed=1)
    inside = ws.SurfacePoints(outside.position, -outside.normal, outside.face)
    suns = np.concatenate([year(20), -year(20)])
    for disc in (0.0, 0.533):
        assert not ws.direct_sun(box, inside, suns, disc=disc).any()
    assert np.array_equal(ws.direct_sun(box, outside, suns), unit(outside.normal) @ suns.T > 0.0)


@pytest.mark.parametrize("normal", [(0, 0, 1), (0.3, -0.5, 0.8), (0.0, 1.0, 0.0)])
def test_an_open_plane_is_lit_by_all_that_is_in_front(normal):
    n = unit(normal)
    x = unit(np.cross(n, [0.3, 0.2, 0.9]))
    y = np.cross(n, x)
    mesh = ws.as_mesh((np.array([x + y, y - x, -x - y, x - y]), [[0, 1, 2], [0, 2, 3]]))
    rng = np.random.default_rng(1)
    points = ws.sample_surface(mesh, 50, seed=1)
    flat = rng.normal(size=(300, 1)) * x + rng.normal(size=(300, 1)) * y
    grazing = flat + 10.0 ** rng.uniform(-5.5, 0.0, (300, 1)) * rng.choice([-1.0, 1.0], (300, 1)) * n
    suns = np.concatenate([rng.normal(size=(300, 3)), grazing, [n, -n]])
    side = unit(points.normal)[0] @ n  # 1 or -1
    want = np.broadcast_to(side * (suns @ n) > 0.0, (50, len(suns)))
    assert np.array_equal(ws.direct_sun(mesh, points, suns), want)


def test_the_shadow_of_a_wall():
    mesh = plane_and(upright((-7.0, 0.0), (5.0, 4.0)))
    rng = np.random.default_rng(2)
    place = np.column_stack([rng.uniform(-12, 12, 400), rng.uniform(-12, 12, 400), np.zeros(400)])
    suns = unit(year(9))
    with np.errstate(divide="ignore"):
        t = -place[:, :1] / suns[:, 0]
    y, z = place[:, 1:2] + t * suns[:, 1], t * suns[:, 2]
    ahead = np.minimum.reduce([t, y + 7.0, 5.0 - y, 4.0 - z])  # above 0 behind the wall
    clear = np.abs(ahead) > 1e-3
    got = ws.direct_sun(mesh, at(place), suns)
    assert np.array_equal(got[clear], (ahead < 0.0)[clear])
    assert 0.02 < 1.0 - got.mean() < 0.5


def test_both_triangles_of_a_wall_and_the_gap_between_two():
    """Suns along the diagonal of a wall, through a slit, and beside an edge: what groups must not be proven across."""
    slit = 1e-3
    mesh = plane_and(upright((-50.0, 0.0), (-slit, 30.0), 5.0), upright((slit, 0.0), (50.0, 30.0), 5.0))
    rng = np.random.default_rng(5)
    to = np.column_stack([np.full(800, 5.0), rng.normal(0, 0.02, 800), rng.uniform(0.5, 29.0, 800)])
    for place in ((0.0, 0.0, 0.0), (-3.0, 0.0, 1.0), (0.0, 1e-4, 0.0)):
        suns = to - np.array(place)
        through = (np.abs(to[:, 1]) < slit) & (to[:, 2] > place[2])
        clear = np.abs(np.abs(to[:, 1]) - slit) > 1e-5
        got = ws.direct_sun(mesh, at(place), suns)[0]
        assert np.array_equal(got[clear], through[clear])
        assert 10 < through.sum() < 790


def test_suns_at_the_edge_of_what_blocks_them():
    """Within rounding of an edge, in groups: known triangles are as exact as the rays that found them."""
    rng = np.random.default_rng(6)
    for _ in range(6):
        corners = np.array([0.0, 0.0, 40.0]) + rng.uniform(-20, 20, (3, 3))
        mesh, place = plane_and((corners, [[0, 1, 2]])), np.append(rng.uniform(-9, 9, 2), 5.0)
        suns = (corners[0] + rng.uniform(0.0, 1.0, (600, 1)) * (corners[1] - corners[0]) - place).astype(np.float32)
        right, _ = traced(mesh, at(place), suns)
        assert np.array_equal(ws.direct_sun(mesh, at(place), suns), right)
        assert 50 < right.sum() < 550


def test_suns_just_above_the_horizon_are_lit():
    """All of a group, by less than what is left for rounding."""
    rng = np.random.default_rng(7)
    angle = rng.uniform(0.0, 1e-3, 64)
    suns = np.column_stack([np.cos(angle), np.sin(angle), rng.uniform(1e-6, 3.5e-6, 64)])
    mesh = plane_and()
    assert ws.direct_sun(mesh, at(np.zeros((3, 3))), suns).all()
    assert not ws.direct_sun(mesh, at(np.zeros((3, 3))), suns * [1.0, 1.0, -1.0]).any()


# Sums


@pytest.mark.parametrize("disc", [0.0, 0.533])
def test_sums_are_those_of_the_array(bunny, points, disc):
    suns, rng = year(20), np.random.default_rng(1)
    some = ws.SurfacePoints(points.position[:80], points.normal[:80], points.face[:80])
    seen = ws.direct_sun(bunny, some, suns, disc=disc).astype(np.float64)
    cosine = np.maximum(0.0, unit(some.normal) @ unit(suns).T)
    for weights in (rng.uniform(0, 900, len(suns)), rng.normal(size=(len(suns), 7)), np.ones((len(suns), 1), np.int64)):
        plain, tilted = (ws.direct_sun(bunny, some, suns, weights, disc, cosine=c) for c in (False, True))
        assert plain.dtype == tilted.dtype == np.float64
        assert plain.shape == tilted.shape == (80, *weights.shape[1:])
        scale = np.abs(weights).sum()
        assert np.abs(plain - seen @ weights).max() <= 1e-13 * scale
        assert np.abs(tilted - (seen * cosine) @ weights).max() <= 3e-7 * scale
        again = ws.direct_sun(bunny, some, suns, weights, disc, skip=False, cosine=True)
        assert np.array_equal(again, tilted)


def test_irradiation_is_at_most_what_comes_in():
    mesh = scenes.city(8)
    points, suns = ws.sample_surface(mesh, 300, seed=2), year(20)
    direct = np.random.default_rng(0).uniform(0, 900, len(suns))
    received = ws.direct_sun(mesh, points, suns, direct, cosine=True)
    open_sky = np.maximum(0.0, unit(points.normal) @ unit(suns).T) @ direct
    assert (received >= 0.0).all()
    assert (received <= open_sky * (1.0 + 1e-6) + 1e-9).all()
    roof = points.normal[:, 2] > 0.9
    highest = roof & (points.position[:, 2] > np.quantile(points.position[roof, 2], 0.99))
    assert np.allclose(received[highest], open_sky[highest], rtol=1e-6)


# Discs


def test_half_of_a_disc_behind_an_edge():
    mesh = plane_and(upright((-90.0, 0.0), (0.0, 90.0), 40.0))  # its edge is at y = 0
    place = np.column_stack([np.zeros(600), np.zeros(600), np.linspace(0.0, 0.5, 600)])
    sun = unit([[40.0, 0.0, 10.0]])
    shares = ws.direct_sun(mesh, at(place), sun, disc=0.533)
    assert shares.dtype == np.float32
    assert abs(shares.mean(dtype=np.float64) - 0.5) < 4.0 * 0.022 / np.sqrt(600)
    assert np.sqrt(np.mean((shares.astype(np.float64) - 0.5) ** 2)) < 0.04
    assert not np.array_equal(shares, ws.direct_sun(mesh, at(place), sun, disc=0.533, seed=1))


def test_a_disc_cut_anywhere():
    mesh = plane_and(upright((-90.0, 0.0), (0.0, 90.0), 40.0))
    radius, h = np.radians(5.0), np.linspace(-1.3, 1.3, 27)  # in radii, to the side that is free
    up, free = unit([40.0, 0.0, 10.0]), np.array([0.0, 1.0, 0.0])
    suns = np.cos(h * radius)[:, None] * up + np.sin(h * radius)[:, None] * free
    shares = ws.direct_sun(mesh, at(np.zeros((400, 3))), suns, disc=10.0).astype(np.float64)
    x = np.clip(-h, -1.0, 1.0)
    area = (np.arccos(x) - x * np.sqrt(1.0 - x * x)) / np.pi  # of a flat disc: the cap's differs by the square of its radius
    error = shares - area
    assert np.abs(error.mean(axis=0)).max() < 4.0 * 0.022 / np.sqrt(400) + radius**2 / 4.0
    assert np.sqrt(np.mean(np.square(error[:, np.abs(h) < 1.0]))) < 0.03
    assert (shares[:, h > 1.01] == 1.0).all()
    assert (shares[:, h < -1.01] == 0.0).all()


def test_what_of_a_disc_is_below_the_horizon_is_dark():
    mesh = plane_and()
    angle = np.radians([-0.1, 1e-3, 0.1, 0.26, 0.27, 10.0])
    suns = np.column_stack([np.cos(angle), np.zeros(6), np.sin(angle)])
    shares = ws.direct_sun(mesh, at(np.zeros((300, 3))), suns, disc=0.533).astype(np.float64)
    assert (shares[:, 0] == 0.0).all()
    x = -np.degrees(angle[1:4]) / 0.2665
    area = (np.arccos(x) - x * np.sqrt(1.0 - x * x)) / np.pi
    assert np.abs(shares[:, 1:4].mean(axis=0) - area).max() < 4.0 * 0.022 / np.sqrt(300)
    assert (shares[:, 4:] == 1.0).all()


@pytest.mark.parametrize("name", ["city", "hostile"])
def test_discs_are_the_same_without_skipping(bunny, name):
    mesh, suns = mesh_of(name, bunny), np.concatenate([year(40), mixed(np.random.default_rng(8), 60)])
    points = ws.sample_surface(mesh, 60, seed=5)
    sharp = ws.direct_sun(mesh, points, suns)
    for disc in (1e-6, 0.533, 20.0):
        skipping, plain = (ws.direct_sun(mesh, points, suns, disc=disc, skip=skip) for skip in (True, False))
        assert np.array_equal(skipping, plain)
        assert (skipping >= 0.0).all()
        assert (skipping <= 1.0).all()
        if disc < 1.0:
            assert np.abs(skipping.astype(np.float64) - sharp).mean() < 0.02
            assert ((skipping > 0.0) & (skipping < 1.0)).mean() < 0.05


# Parts


@pytest.mark.parametrize("disc", [0.0, 0.533])
def test_parts_threads_masks_and_order_change_no_bit(bunny, monkeypatch, disc):
    points, suns = ws.sample_surface(bunny, 4200, seed=1), year(40)
    weights = np.random.default_rng(0).uniform(size=(len(suns), 2))
    options = {"disc": disc, "seed": 5}
    right, total = (ws.direct_sun(bunny, points, suns, w, first_point=2**40, **options) for w in (None, weights))
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    monkeypatch.setattr("warpsample.tracing.order.MANY_FACES", 1)
    for w, whole in ((None, right), (weights, total)):
        assert np.array_equal(ws.direct_sun(bunny, points, suns, w, first_point=2**40, workers=3, **options), whole)
        half = ws.SurfacePoints(points.position[300:], points.normal[300:], points.face[300:])
        assert np.array_equal(ws.direct_sun(bunny, half, suns, w, first_point=2**40 + 300, **options), whole[300:])
        active = np.arange(4200) % 3 == 0
        masked = ws.direct_sun(bunny, points, suns, w, first_point=2**40, active=active, **options)
        assert np.array_equal(masked, np.where(active[:, None], whole, 0))


def test_suns_in_parts_and_in_another_order_are_the_same(bunny, points):
    suns = year(15)
    whole = ws.direct_sun(bunny, points, suns)
    turned = np.random.default_rng(0).permutation(len(suns))
    assert np.array_equal(ws.direct_sun(bunny, points, suns[turned]), whole[:, turned])
    for count in (1, 2, 15, 16, 17, 33):
        assert np.array_equal(ws.direct_sun(bunny, points, suns[:count]), whole[:, :count])
    strided = np.repeat(suns, 2, axis=0)[::2]
    assert np.array_equal(ws.direct_sun(bunny, points, strided.tolist()), whole)


# Extremes


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
        assert np.array_equal(ws.direct_sun(city, away, suns)[np.abs(cosine) > GRAZING], right[np.abs(cosine) > GRAZING])
        assert not right[np.abs(cosine) > GRAZING].all()
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
    assert np.array_equal(ws.direct_sun(bunny, broken, suns, np.ones(len(suns)))[1:5], np.zeros(4))


def test_no_points(bunny):
    none = ws.SurfacePoints(np.zeros((0, 3)), np.zeros((0, 3)))
    suns = np.eye(3)
    assert ws.direct_sun(bunny, none, suns).shape == (0, 3)
    assert ws.direct_sun(bunny, none, suns, disc=1.0).dtype == np.float32
    assert ws.direct_sun(bunny, none, suns, np.ones(3)).shape == (0,)
    assert ws.direct_sun(bunny, none, suns, np.ones((3, 2))).shape == (0, 2)


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
        ({"weights": np.array([1.0, np.nan])}, "weights: got one that is not finite, want finite numbers"),
        ({"disc": -0.5}, "disc: got -0.5, want a number from 0 to 45"),
        ({"disc": 180.0}, "disc: got 180.0, want a number from 0 to 45"),
        ({"disc": float("nan")}, "disc: got nan, want a number from 0 to 45"),
        ({"cosine": True}, "cosine: got True without weights, want weights, which it multiplies"),
        ({"points": np.ones((2, 3))}, "points: got a NumPy array, want SurfacePoints, as sample_surface gives them"),
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
        MemoryError, match=r"^10,000,000 suns of 1,000,000 points need .* are free; take the points in parts$"
    ):
        call_of(bunny, many, suns).answer()
