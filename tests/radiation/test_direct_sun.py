"""Which suns a point sees: the same as rays tell, whatever is skipped; closed forms; sums; parts."""

import numpy as np
import pytest
from meshes import CLOSED
from sun_cases import GRAZING, MESHES, at, call_of, mesh_of, mixed, plane_and, traced, unit, upright, year

import warpsample as ws
from warpsample.bench import scenes

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


@pytest.mark.parametrize("disc", [0.0, pytest.param(0.533, marks=pytest.mark.slow)])
def test_sums_are_those_of_the_array(bunny, points, disc):
    suns, rng = year(20), np.random.default_rng(1)
    some = ws.SurfacePoints(points.position[:80], points.normal[:80], points.face[:80])
    seen = ws.direct_sun(bunny, some, suns, disc=disc).astype(np.float64)
    cosine = np.maximum(0.0, unit(some.normal) @ unit(suns).T)
    for weights in (rng.uniform(0, 900, len(suns)), rng.normal(size=(len(suns), 7)), np.ones((len(suns), 1), np.int64)):
        plain, tilted = (ws.direct_sun(bunny, some, suns, weights=weights, disc=disc, cosine=c) for c in (False, True))
        assert plain.dtype == tilted.dtype == np.float64
        assert plain.shape == tilted.shape == (80, *weights.shape[1:])
        scale = np.abs(weights).sum()
        assert np.abs(plain - seen @ weights).max() <= 1e-13 * scale
        assert np.abs(tilted - (seen * cosine) @ weights).max() <= 3e-7 * scale
        again = ws.direct_sun(bunny, some, suns, weights=weights, disc=disc, skip=False, cosine=True)
        assert np.array_equal(again, tilted)


def test_irradiation_is_at_most_what_comes_in():
    mesh = scenes.city(8)
    points, suns = ws.sample_surface(mesh, 300, seed=2), year(20)
    direct = np.random.default_rng(0).uniform(0, 900, len(suns))
    received = ws.direct_sun(mesh, points, suns, weights=direct, cosine=True)
    open_sky = np.maximum(0.0, unit(points.normal) @ unit(suns).T) @ direct
    assert (received >= 0.0).all()
    assert (received <= open_sky * (1.0 + 1e-6) + 1e-9).all()
    roof = points.normal[:, 2] > 0.9
    highest = roof & (points.position[:, 2] > np.quantile(points.position[roof, 2], 0.99))
    assert np.allclose(received[highest], open_sky[highest], rtol=1e-6)


# Parts


@pytest.mark.parametrize("disc", [0.0, pytest.param(0.533, marks=pytest.mark.slow)])
def test_parts_threads_masks_and_order_change_no_bit(bunny, monkeypatch, disc):
    points, suns = ws.sample_surface(bunny, 4200, seed=1), year(40)
    weights = np.random.default_rng(0).uniform(size=(len(suns), 2))
    options = {"disc": disc, "seed": 5}
    right, total = (ws.direct_sun(bunny, points, suns, weights=w, first_point=2**40, **options) for w in (None, weights))
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    monkeypatch.setattr("warpsample.tracing.order.MANY_FACES", 1)
    for w, whole in ((None, right), (weights, total)):
        assert np.array_equal(ws.direct_sun(bunny, points, suns, weights=w, first_point=2**40, workers=3, **options), whole)
        half = ws.SurfacePoints(points.position[300:], points.normal[300:], points.face[300:])
        assert np.array_equal(ws.direct_sun(bunny, half, suns, weights=w, first_point=2**40 + 300, **options), whole[300:])
        active = np.arange(4200) % 3 == 0
        masked = ws.direct_sun(bunny, points, suns, weights=w, first_point=2**40, active=active, **options)
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
