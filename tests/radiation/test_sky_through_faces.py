"""Sun and sky of meshes that light goes through: products through sheets and shells, and the answers of rays."""

import glass_cases as cases
import numpy as np
import pytest
from irradiation_cases import DAY, PARTS
from sun_cases import GRAZING, unit, year

import warpsample as ws

pytestmark = pytest.mark.slow  # kernels of their own


def test_the_sun_through_sheets_is_their_product_at_any_altitude():
    sheets = cases.made_of(*((cases.sheet(1e5, height), tau) for height, tau in ((1.0, 0.5), (2.0, 0.25), (2.0, 0.75))))
    suns, points = year(20), cases.at_origin(5)
    suns = suns[suns[:, 2] > 0.01]
    lit = ws.direct_sun(sheets, points, suns)
    assert (lit.dtype, lit.shape) == (np.float32, (5, len(suns)))
    assert (lit == 0.5 * 0.25 * 0.75).all()
    assert (ws.direct_sun(sheets, points, suns, disc=0.5) == 0.5 * 0.25 * 0.75).all()
    hours = ws.direct_sun(sheets, points, suns, weights=np.arange(float(len(suns))))
    np.testing.assert_allclose(hours, lit[0, 0] * np.arange(len(suns)).sum(), rtol=1e-12)


def test_the_sun_through_a_garden_is_what_rays_tell():
    mesh, suns = cases.garden(), year(30)
    points = ws.sample_surface(mesh, 200, seed=1)
    found = ws.direct_sun(mesh, points, suns)
    assert np.array_equal(found, ws.direct_sun(mesh, points, suns, skip=False, workers=1))
    way = np.broadcast_to(suns, (200, *suns.shape)).copy()
    rays = ws.trace(mesh, points, way, any_hit=True).transmitted
    cosine = unit(points.normal) @ suns.T
    clear = np.abs(cosine) > GRAZING
    assert np.array_equal(found[clear], np.where(cosine > 0.0, rays, 0.0)[clear])
    assert len(np.unique(found)) > 3
    discs = [ws.direct_sun(mesh, points, suns, disc=2.0, skip=skip) for skip in (True, False)]
    assert np.array_equal(*discs)
    assert np.abs(discs[0] - found).mean() < 0.02
    plain = ws.as_mesh((mesh.vertices, mesh.faces))
    dark = ws.direct_sun(ws.as_mesh(plain, transmittance=0.0), points, suns)
    assert np.array_equal(dark, ws.direct_sun(plain, points, suns))
    lit = ws.direct_sun(ws.as_mesh(plain, transmittance=1.0), points, suns)
    assert np.array_equal(lit[clear], cosine[clear] > 0.0)


def test_a_sky_matrix_behind_shells_is_the_open_one_times_their_product():
    points = ws.SurfacePoints(np.zeros((3, 3)), np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.6, 0.0, 0.8]]))
    clear, dim = (ws.sky_matrix(cases.shells(*taus), points, 256) for taus in ((1.0, 1.0, 1.0), (0.5, 0.25, 0.5)))
    np.testing.assert_allclose(dim.value, 0.0625 * clear.value, rtol=1e-6)
    assert 0.0 < dim.standard_error.max() < 0.16 * 0.0145  # 0.32 of a ray, as behind a wall: a hole may be between the rays
    assert clear.rays.sum() == 0


def test_a_sky_matrix_of_a_garden_adds_up_to_the_sky_view_and_skips_without_a_bit():
    mesh = cases.garden()
    points = ws.sample_surface(mesh, 150, seed=4)
    found, plain = (ws.sky_matrix(mesh, points, 1024, skip=skip) for skip in (True, False))
    assert cases.same_bits(found, plain, "status")
    assert found.rays.sum() < 0.5 * plain.rays.sum()
    way = ws.sample_directions(points, 1024).vectors
    rays = ws.trace(mesh, points, way, any_hit=True).transmitted * (way[..., 2] > 0.0)
    view = rays.mean(axis=1, dtype=float)
    error = np.sqrt(np.square(found.standard_error).sum(axis=1) + rays.var(axis=1, dtype=float) / 1024)
    assert np.abs(np.mean((found.value.sum(axis=1) - view) / np.maximum(error, 1e-3))) < 0.5
    assert np.abs(found.value.sum(axis=1) - view).max() < 0.05


def test_irradiation_behind_shells_is_that_of_the_open_times_their_product():
    points = ws.SurfacePoints(np.zeros((2, 3)), np.array([[0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]))
    options = {"period": DAY, "patches": "tregenza", "count": 64}
    for series in (False, True):
        clear, dim = (ws.irradiation(cases.shells(tau), points, "athens", series=series, **options) for tau in (1.0, 0.25))
        assert clear.value.min(axis=-1).min() >= 0.0 < clear.value.max()
        for part in PARTS:
            np.testing.assert_allclose(getattr(dim, part), 0.25 * getattr(clear, part), rtol=2e-6, atol=1e-9)
