"""Skipping changes no bit of an estimate, under any weight and on any mesh; nor do threads, parts, order or masks."""

import numpy as np
import pytest
from estimate_cases import at, same
from meshes import CLOSED, soup

import warpsample as ws
from warpsample.bench import scenes
from warpsample.estimate.strata import strata_of

RAYS = 65_536

MESHES = {"city": lambda: scenes.city(12), "hostile": lambda: soup(300), "torus": lambda: CLOSED["torus"][0]}


@pytest.mark.parametrize("name", [pytest.param("bunny", marks=pytest.mark.slow), *MESHES])
def test_skipping_changes_no_bit(bunny, name):
    mesh = bunny if name == "bunny" else MESHES[name]()
    size = np.ptp(mesh.vertices, axis=0).max()
    above = ws.sample_surface(mesh, 300, seed=3)
    floating = ws.SurfacePoints(above.position + 0.02 * size * above.normal, above.normal)
    cast = skipped = 0
    for where in (above, ws.vertex_points(mesh), ws.face_centers(mesh), floating):
        for count, reach in ((40, None), (300, 0.1 * size), (500, None)):
            with_skipping, without = (
                ws.ambient_occlusion(mesh, where, count, max_distance=reach, skip=skip) for skip in (True, False)
            )
            assert same(with_skipping, without)
            cast, skipped = cast + int(without.rays.sum()), skipped + with_skipping.skipped.empty_rays
            assert with_skipping.rays.sum(dtype=np.int64) + with_skipping.skipped.empty_rays == without.rays.sum()
    assert skipped >= 0.05 * cast


@pytest.mark.parametrize("name", MESHES)
def test_rays_together_meet_what_each_meets_alone(name):
    """With a falloff of nearly 0 the nearest hit is asked for, ray by ray, and counts as any hit does."""
    mesh = MESHES[name]()
    size = np.ptp(mesh.vertices, axis=0).max()
    corners, surface = ws.vertex_points(mesh), ws.sample_surface(mesh, 200, seed=3)
    afar = ws.SurfacePoints(surface.position + 40.0 * size * np.array([0.0, 0.0, 1.0]), -surface.normal)
    for where in (surface, corners, afar):
        for count, reach in ((2, size), (16, 0.2 * size), (144, 100.0 * size), (500, 0.1 * size)):
            together, alone = (
                ws.ambient_occlusion(mesh, where, count, max_distance=reach, falloff=falloff) for falloff in (None, 1e-30)
            )
            assert np.array_equal(together.value, alone.value)
            assert np.array_equal(together.rays, alone.rays)
    assert 0.0 < together.value.mean() <= 1.0


def test_a_wrong_shaft_would_be_seen(bunny, points, monkeypatch):
    strata = strata_of(500)
    turned = type(strata)(strata.bands, strata.sectors, strata.samples_per_stratum, np.roll(strata.shafts, 1, axis=0))
    right = ws.ambient_occlusion(bunny, points, 500)
    monkeypatch.setattr("warpsample.estimate.runner.strata_of", lambda *_, **__: turned)
    assert not same(ws.ambient_occlusion(bunny, points, 500), right)


def test_skipping_under_other_weights(bunny, points):
    up = (0.3, 1.0, 0.2)
    for count in (300, 500):
        skipping, plain = (ws.sky_view_factor(bunny, points, count, up=up, skip=skip) for skip in (True, False))
        assert same(skipping, plain)
        assert skipping.skipped.weightless_rays > 0
        total = len(points) * strata_of(count).rays
        assert skipping.rays.sum() + skipping.skipped.empty_rays + skipping.skipped.weightless_rays == total
        shaded = [
            ws.ambient_occlusion(bunny, points, count, max_distance=0.3, falloff=1.5, skip=skip) for skip in (True, False)
        ]
        assert same(*shaded)
        assert shaded[0].rays.sum() < 0.8 * shaded[1].rays.sum()


def test_obscurance_lies_between_what_it_blends(bunny, points):
    near, open_far = (ws.ambient_occlusion(bunny, points, 512, max_distance=reach).value for reach in (0.3, None))
    blended = ws.ambient_occlusion(bunny, points, 512, max_distance=0.3, falloff=1.0).value
    assert (blended >= near - 1e-6).all()
    assert (near >= open_far).all()
    assert blended.mean() > near.mean() + 0.01
    ground = at((0.5, 0.5, 0.0), (0, 0, 1))
    # A ceiling at h over all of the lobe within reach r: a hit at t = h/cos counts 1 - t/r.
    ceiling = ws.as_mesh((np.array([(-1, -1, 0.1), (3, -1, 0.1), (-1, 3, 0.1)]) * [99, 99, 1], [(0, 2, 1)]))
    h, r = 0.1, 0.4
    exact = (1.0 - (h / r) ** 2) - 2.0 * (h / r) * (1.0 - h / r)
    found = ws.ambient_occlusion(ceiling, ground, RAYS, max_distance=r, falloff=1.0)
    assert abs(1.0 - found.value[0] - exact) <= 4.0 * found.standard_error[0] + 1e-5


def test_threads_parts_order_and_masks_change_no_bit(bunny, monkeypatch):
    points = ws.sample_surface(bunny, 4200, seed=1)  # so many that their order is looked at
    right = ws.ambient_occlusion(bunny, points, 40, seed=7, first_point=2**40)
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    monkeypatch.setattr("warpsample.tracing.order.MANY_FACES", 1)
    sorts = []
    monkeypatch.setattr(np, "argsort", lambda *args, real=np.argsort, **how: sorts.append(1) or real(*args, **how))
    assert same(ws.ambient_occlusion(bunny, points, 40, seed=7, first_point=2**40, workers=3), right)
    assert sorts == [1]
    half = ws.SurfacePoints(points.position[300:], points.normal[300:], points.face[300:])
    part = ws.ambient_occlusion(bunny, half, 40, seed=7, first_point=2**40 + 300)
    assert np.array_equal(part.value, right.value[300:])
    active = np.arange(4200) % 3 == 0
    masked = ws.ambient_occlusion(bunny, points, 40, seed=7, first_point=2**40, active=active)
    assert np.array_equal(masked.value, np.where(active, right.value, 0.0))
    assert masked.counts() == {ws.PointStatus.OK: 1400, ws.PointStatus.INACTIVE: 2800}
    assert masked.rays[~active].sum() == 0
    assert masked.skipped.points == 2800
