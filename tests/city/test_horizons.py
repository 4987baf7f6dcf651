"""The sky by the horizon to each azimuth: the values of rays all over it, with honest bars, and with less noise."""

import numpy as np
import pytest
from raster_cases import NORTH_UP, rough

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

import warpsample as ws
from warpsample import rasters
from warpsample.city.rasters.horizons import azimuths_and_rays, finds_horizons, sky_by_horizons
from warpsample.estimate.quantities.ambient_occlusion import RECORD as OCCLUSION
from warpsample.estimate.quantities.sky_view_factor import RECORD as SKY
from warpsample.estimate.quantities.visible_sky import RECORD as VISIBLE_SKY

SEEDS = 12


@pytest.fixture(scope="module")
def cliffs():
    """A mesh of walls and slopes, points on it with level and with tilted normals, and what they see by very many rays."""
    made = rasters.surface((np.pad(rough(10, 12, seed=8), 3, constant_values=9.0), NORTH_UP, None))
    cases = []
    for quantity, receiver in ((SKY, "horizontal"), (SKY, "surface"), (VISIBLE_SKY, "horizontal")):
        points, _ = made.points(receiver)
        cases.append((quantity, points, quantity.call(made.mesh, points, 16384, seed=1000)))
    return made.mesh, cases


@pytest.mark.parametrize("case", range(3))
@pytest.mark.parametrize("count", [16, 100, 600])
def test_the_mean_and_its_bar_are_right(cliffs, case, count):
    """Over cells and seeds the error's mean is 0 within four of its own, and its square about that of the bars.

    Bars are what jumps between horizons let expect. The error's squares are 0.35 to 1.1 of those of bars, and down to 0.2 of
    visible skies: lumps of this surface count as narrow objects, and its deep cells see little. The reference's own error is
    taken off.
    """
    mesh, cases = cliffs
    quantity, points, right = cases[case]
    found = [sky_by_horizons(quantity, mesh, points, {"count": count, "seed": seed}) for seed in range(SEEDS)]
    off = np.array([one.value.astype(np.float64) - right.value for one in found])
    bar = np.array([one.standard_error for one in found], np.float64)
    known = np.mean(right.standard_error.astype(np.float64) ** 2)
    means = off.mean(axis=1)
    assert abs(means.mean()) < 4.5 * np.hypot(means.std(ddof=1) / np.sqrt(SEEDS), np.sqrt(known / len(points)))
    assert (0.15 if quantity is VISIBLE_SKY else 0.3) < ((off**2).mean() - known) / (bar**2).mean() < 1.4
    azimuths, rays = azimuths_and_rays(count)
    assert {int(n) for n in found[0].rays} <= {0, azimuths * rays}
    assert azimuths * rays <= count


def test_one_ray_an_azimuth_is_either_free_or_not(cliffs):
    mesh, cases = cliffs
    _, points, right = cases[0]
    value = sky_by_horizons(SKY, mesh, points, {"count": 2}).value
    assert set(np.unique(value)) == {0.0, 0.5, 1.0}
    assert value.mean() == pytest.approx(right.value.mean(), abs=4.0 * 0.5 / np.sqrt(len(points)))


def test_no_bit_depends_on_threads_or_on_what_is_skipped(cliffs):
    mesh, cases = cliffs
    for quantity, points, _ in cases:
        first, *others = (
            sky_by_horizons(quantity, mesh, points, {"count": 64, "seed": 3, "workers": workers, "skip": skip})
            for workers, skip in ((1, True), (2, True), (1, False))
        )
        for other in others:
            assert np.array_equal(first.value, other.value)
            assert np.array_equal(first.standard_error, other.standard_error)
        part = sky_by_horizons(quantity, mesh, points.take(np.arange(7, 50)), {"count": 64, "seed": 3})
        assert np.array_equal(part.value, first.value[7:50])
        assert not np.array_equal(first.value, sky_by_horizons(quantity, mesh, points, {"count": 64, "seed": 4}).value)


def test_what_is_below_a_tilted_receiver_hides_nothing_that_is_above_it():
    """Rays below its plane are not cast: what they would meet may be left out of the tree around the point."""
    row, column = np.mgrid[:30, :30]
    heights = 6.0 * np.sin(column / 3.0) + 5.0 * np.cos(row / 4.0 + column / 7.0)
    made = rasters.surface((heights, NORTH_UP, None))
    points, _ = made.points("surface")
    for reach in (5.0, None):
        skipped, plain = (
            sky_by_horizons(SKY, made.mesh, points, {"count": 64, "max_distance": reach, "skip": skip})
            for skip in (True, False)
        )
        assert np.array_equal(skipped.value, plain.value)
        assert np.array_equal(skipped.standard_error, plain.standard_error)
        right = ws.sky_view_factor(made.mesh, points, 4096, max_distance=reach, seed=5)
        off = skipped.value.astype(np.float64) - right.value
        bar = skipped.standard_error.astype(np.float64)
        assert 0.15 < (off**2).mean() / (bar**2).mean() < 1.2  # smooth horizons, by 15 azimuths: the bars are too wide


def test_open_ground_sees_all_of_the_sky():
    """To the bit where it is level; tilted, all that is above its plane, and never more."""
    flat = np.zeros((9, 9)), NORTH_UP, None
    for call in (rasters.sky_view_factor, rasters.visible_sky):
        found = call(flat, 64)
        assert (found.value == 1.0).all()
        assert (found.standard_error == 0.0).all()
        assert found.attrs["method"] == "horizons"
    column = np.arange(41) * np.ones((41, 1))
    found = rasters.sky_view_factor((0.7 * column, NORTH_UP, None), 4096, receiver="surface")
    right = 0.5 + 0.5 / np.hypot(1.0, 0.7)
    error = float(found.standard_error[20, 20])
    assert error < 5e-4  # long runs of equal intervals count more: 3e-4
    assert float(found.value[20, 20]) == pytest.approx(right, abs=4.0 * error + 1e-5)
    assert rasters.sky_view_factor((0.05 * column, NORTH_UP, None), 64, receiver="surface").value.max() < 1.0


def test_a_tilted_plane_is_right_by_few_rays_and_never_above_one():
    """The azimuths are evenly spaced, so that what one sees too much an opposite one does not see."""
    plane = np.arange(41) * np.ones((41, 1))
    made = rasters.surface((plane, NORTH_UP, None))
    points, _ = made.points("surface")
    middle = points.take((np.arange(15, 26)[:, None] * 41 + np.arange(5, 36)).ravel())
    right = 0.5 + np.sqrt(0.125)
    for count in (2, 3, 8, 16, 64):
        found = sky_by_horizons(SKY, made.mesh, middle, {"count": count})
        assert found.value.max() <= 1.0
        off = found.value.astype(np.float64) - right
        assert abs(off.mean()) < 4.0 * off.std() / np.sqrt(len(off)) + 1e-6  # float32
        assert (np.abs(off) <= 3.0 * found.standard_error).all()


def test_on_terrain_it_is_worth_many_times_as_many_rays():
    """Half of the error at least; a fourth is usual."""
    row, column = np.mgrid[:60, :60]
    heights = 6.0 * np.sin(row / 9.0) * np.cos(column / 7.0)
    made = rasters.surface((heights, NORTH_UP, None))
    points, _ = made.points()
    points = points.take(np.arange(0, 3600, 7))
    right = ws.sky_view_factor(made.mesh, points, 16384, seed=9).value
    by_rays = ws.sky_view_factor(made.mesh, points, 64, seed=1).value - right
    by_horizons = sky_by_horizons(SKY, made.mesh, points, {"count": 64, "seed": 1}).value - right
    assert np.sqrt(np.mean(by_horizons**2)) < 0.5 * np.sqrt(np.mean(by_rays**2))


def test_how_far_rays_go():
    """A wall beyond the reach of all rays is not there; one within the reach of the level ones hides what is low."""
    heights = np.where(np.arange(60) < 30, 0.0, 20.0) * np.ones((60, 1))
    near, far = (rasters.visible_sky((heights, NORTH_UP, None), 256, max_distance=reach).value for reach in (5.0, 200.0))
    assert (near[:, :24] == 1.0).all()
    assert float(far[30, 20]) < 0.95
    assert float(near[30, 29]) == pytest.approx(float(far[30, 29]), abs=0.05)  # half a cell from the wall


@pytest.mark.slow
def test_what_is_found_otherwise(cliffs):
    """Crowns let rays pass below them; other sequences, devices and tolerances are of rays all over the sky."""
    assert finds_horizons(SKY, {"count": 64, "seed": 2, "max_distance": 9.0, "tolerance": None})
    for options in ({"tolerance": 0.1}, {"sequence": "sobol"}, {"tracer": "warp"}, {"device": "cpu"}):
        assert not finds_horizons(SKY, options)
    assert not finds_horizons(OCCLUSION, {})
    street = np.zeros((9, 9)), NORTH_UP, None
    crown = np.pad(np.full((3, 3), 4.0), 3), NORTH_UP, None
    for options in ({"canopy": crown}, {"tolerance": 0.1}):
        assert rasters.sky_view_factor(street, 64, **options).attrs["method"] == "rays"


@pytest.mark.parametrize("sequence", ["fibonacci", pytest.param("sobol", marks=pytest.mark.slow)])
@pytest.mark.parametrize("model", ["block", "joined", "tin"])
def test_cells_without_data_are_shafts_in_solid_ground(model, sequence):
    """By horizons and by rays, a house behind a strip without data hides the sky; before, rays passed below its roof.

    Values were off by up to 0.2. In `tin`, the wall of a shaft leans over 1 % of a cell.
    """
    roof = np.zeros((30, 30))
    roof[12:17] = 10.0
    gone = np.zeros(roof.shape, bool)
    gone[10:12], gone[17:19] = True, True
    holes, shafts = (
        rasters.sky_view_factor((np.where(gone, depth, roof), NORTH_UP, None), 1024, model=model, sequence=sequence).value
        for depth in (np.nan, -1e3)
    )
    assert np.array_equal(np.isnan(holes), gone)
    assert float(np.abs(holes - shafts).max()) < (0.005 if sequence == "fibonacci" else 0.03)  # the last rays
    assert float(holes[9, 14]) < 0.7  # half of the sky, but for what is above the house


@pytest.mark.parametrize(
    ("count", "expected"),
    [(2, (2, 1)), (3, (3, 1)), (4, (3, 1)), (8, (7, 1)), (16, (7, 2)), (64, (15, 4)), (1024, (203, 5))],
)
def test_how_rays_are_shared_out(count, expected):
    assert azimuths_and_rays(count) == expected
