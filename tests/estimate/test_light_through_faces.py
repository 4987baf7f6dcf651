"""Numbers per point of meshes that light goes through: closed forms, limits, and that nothing that is skipped matters."""

import glass_cases as cases
import numpy as np
import pytest

import warpsample as ws

BITS = ("spread", "degrees_of_freedom", "status")


def irradiance(mesh, points, count, **options):
    return ws.irradiance(mesh, points, np.ones((4, 8)), count, **options)


@pytest.mark.slow
@pytest.mark.parametrize(
    "call", [ws.ambient_occlusion, pytest.param(ws.sky_view_factor, marks=pytest.mark.thorough), irradiance]
)
def test_shells_of_glass_let_the_product_through_without_noise(call):
    """Quantities are those of the open sky, times 0.5 x 0.25 x 0.5."""
    points = cases.at_origin(3)
    open_sky = call(ws.as_mesh(cases.shells(1.0)), points, 64)
    assert (open_sky.value > 0.99).all()
    found = call(cases.shells(0.5, 0.25, 0.5), points, 64)
    np.testing.assert_allclose(found.value, 0.0625 * open_sky.value, rtol=1e-6)  # sums of float32 weights
    assert (found.standard_error <= 1e-7).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", cases.CASES)
def test_closed_forms_of_sheets_and_crowns(name):
    mesh, right = cases.CASES[name]
    found = ws.ambient_occlusion(mesh, cases.at_origin(64), 1024, seed=1)
    error = np.sqrt(np.mean(np.square(found.standard_error.astype(float))) / 64)
    assert abs(found.value.mean() - right) < 4.0 * error + 6e-6  # digits of the table
    assert error < 1e-3
    lower, upper = found.interval(0.99)
    assert np.mean((lower <= right + 6e-6) & (right - 6e-6 <= upper)) > 0.9


@pytest.mark.slow
def test_clear_faces_are_absent_and_dark_ones_opaque():
    points = ws.sample_surface(cases.garden(), 300, seed=2)
    opaque = ws.as_mesh((cases.garden().vertices, cases.garden().faces))
    dark = ws.as_mesh(opaque, transmittance=0.0)
    assert cases.same_bits(ws.ambient_occlusion(opaque, points, 64), ws.ambient_occlusion(dark, points, 64), *BITS)
    clear = ws.ambient_occlusion(ws.as_mesh(opaque, transmittance=1.0), points, 64)
    assert (clear.value == 1.0).all()
    assert (clear.standard_error == 0.0).all()
    assert clear.rays.sum() == 0


@pytest.mark.slow
def test_a_crown_that_rays_cross_once_dims_linearly():
    """B + psi (A - B): A without the crown, B with an opaque one; to the rounding of the sums."""
    points = ws.sample_surface(cases.garden(), 300, seed=2)
    dark, half, clear = (ws.ambient_occlusion(cases.garden(psi), points, 256).value for psi in (0.0, 0.25, 1.0))
    assert np.abs(clear - dark).max() > 0.2
    np.testing.assert_allclose(half, dark + 0.25 * (clear - dark), rtol=0.0, atol=2e-7)


@pytest.mark.slow
def test_skipping_and_threads_change_no_bit_with_glass():
    mesh = cases.garden()
    points = ws.sample_surface(mesh, 300, seed=3)
    for limit in (None, 6.0):
        found = ws.ambient_occlusion(mesh, points, 512, max_distance=limit)
        plain = ws.ambient_occlusion(mesh, points, 512, max_distance=limit, skip=False, workers=1)
        assert cases.same_bits(found, plain, *BITS)
        assert found.rays.sum() < 0.5 * plain.rays.sum()
    assert (ws.ambient_occlusion(cases.CASES["sheet"][0], cases.at_origin(2), 64, max_distance=2.9).value == 1.0).all()


@pytest.mark.slow
def test_a_point_on_glass_does_not_look_through_its_own_face():
    pane = cases.made_of((cases.sheet(1.0, 0.0), 0.5), (cases.sheet(1e4, 2.0), 0.5))
    points = ws.face_centers(pane)
    up = ws.ambient_occlusion(pane, points, 64)
    assert set(up.value) == {0.5, 1.0}  # below the upper one, and on it
    assert np.array_equal(up.value == 1.0, points.position[:, 2] > 1.0)


@pytest.mark.thorough
@pytest.mark.parametrize("count", [64, 256, 1024])
@pytest.mark.parametrize("name", ["sheet", "two sheets", "box crown", "box aside"])
def test_bars_are_as_wide_as_errors_with_glass(name, count):
    mesh, right = cases.CASES[name]
    found = ws.ambient_occlusion(mesh, cases.at_origin(4000), count, seed=5)
    right = right if count < 1024 else found.value.astype(float).mean()  # of so many, nearer to the truth than the table
    ratio = np.mean(np.square(found.value.astype(float) - right)) / np.mean(np.square(found.standard_error.astype(float)))
    assert 0.8 < ratio < 1.2
    lower, upper = found.interval(0.95)
    assert np.mean((lower <= right) & (right <= upper)) > 0.9


@pytest.mark.slow
@pytest.mark.parametrize("call", [ws.mean_distance, ws.ambient_occlusion])
def test_parts_of_a_ray_end_where_faces_stop_them(call):
    """Of sheets of 0.5 and 0.25 before a dark one, each ends its share: the mean of as many runs with one dark sheet."""
    points, falloff = cases.at_origin(40), {} if call is ws.mean_distance else {"falloff": 2.0}

    def run(*taus):
        sheets = zip(taus, (3.0, 1.0, 2.0), strict=True)  # in no order
        mesh = cases.made_of(*((cases.sheet(8.0, height), tau) for tau, height in sheets))
        return call(mesh, points, 64, max_distance=5.0, **falloff)

    near, middle, far = (run(*taus).value.astype(float) for taus in ((1.0, 0.0, 1.0), (1.0, 1.0, 0.0), (0.0, 1.0, 1.0)))
    assert (near < middle).all()
    assert (middle < far).all()
    found = run(0.0, 0.5, 0.25)
    np.testing.assert_allclose(found.value, 0.5 * near + 0.375 * middle + 0.125 * far, rtol=2e-6)
    assert np.mean(found.standard_error > 0.0) > 0.3
    garden = cases.garden()
    points = ws.sample_surface(garden, 100, seed=3)
    seen, plain = (call(garden, points, 64, max_distance=9.0, skip=skip, **falloff) for skip in (True, False))
    assert cases.same_bits(seen, plain, *BITS)


def test_tracers_that_know_no_glass_refuse_it():
    with pytest.raises(ValueError, match="^tracer: got 'warp' for a mesh that transmits light, want 'wide' on the CPU$"):
        ws.sky_view_factor(cases.shells(0.5), cases.at_origin(2), 64, tracer="warp")
