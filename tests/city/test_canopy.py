"""Crowns over rasters: their triangles, what is seen through them in closed form, and what is refused."""

import numpy as np
import pytest
from affine import Affine
from raster_cases import NORTH_UP, flux, rough, write_tif

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

import warpsample as ws
from warpsample import rasters
from warpsample.city.rasters.intervals import errors_of
from warpsample.city.rasters.leaves import (
    check_transmittance,
    compute_irradiation_through,
    count_suns_through,
    estimate_through_crowns,
    shares_of_hours,
)
from warpsample.radiation.weather.light import light_of
from warpsample.tracing.options import RayOptions

LONG = Affine(8.0, 0.0, 0.0, 0.0, -1e4, 0.0)
"""Cells 8 wide and 10^4 long: streets, hedges and strips without end."""

RAYS = 2**16
ONE = np.ones(1)


def with_crowns(ground, canopy, transform=NORTH_UP, **options):
    """A surface of the ground's heights, and crowns of these heights above it."""
    ground, canopy = (np.atleast_2d(np.float64(a)) for a in (ground, canopy))
    return rasters.surface((ground, transform, None), canopy=(canopy, transform, None), **options)


def sky(made, cell, transmittance, count=RAYS):
    points, cells = made.points()
    some = points.take(cells == cell)
    return estimate_through_crowns(
        made.scenery, check_transmittance(transmittance), lambda mesh: ws.sky_view_factor(mesh, some, count)
    )


def assert_sky(made, cell, transmittance, exact):
    """Within 4 times its standard error, and what float32 rounds."""
    found = sky(made, cell, transmittance)
    assert abs(float(found.value[0]) - exact) <= 4.0 * float(found.standard_error[0]) + 1e-6
    assert float(found.standard_error[0]) < 1e-3


@pytest.mark.parametrize("model", ["joined", "block"])
@pytest.mark.parametrize("transform", [NORTH_UP, Affine(3.0, 0.5, 7.0, 0.2, -0.5, 0.0), Affine.scale(2.0, 3.0)])
def test_crowns_close_their_volume(model, transform):
    """A wall too many or too few, or one that faces inwards, breaks it; neighbours of the same crown have none between."""
    ground, rng = rough(), np.random.default_rng(3)
    canopy = np.where(rng.random(ground.shape) < 0.6, rng.choice([3.0, 8.0, 12.5], ground.shape), 0.0)
    ground[3, 3] = np.nan
    canopy[3, 3] = 9.0
    made = with_crowns(ground, canopy, transform, trunk=0.4, model=model)
    faces = len(made.mesh.faces)
    assert np.array_equal(made.canopy_mesh.vertices[: len(made.mesh.vertices)], made.mesh.vertices)
    assert np.array_equal(made.canopy_mesh.faces[:faces], made.mesh.faces)
    crowns = ws.as_mesh((made.canopy_mesh.vertices, made.canopy_mesh.faces[faces:]))
    volume = 0.6 * np.where(np.isnan(ground), 0.0, canopy).sum() * abs(transform.determinant)
    assert np.allclose(flux(crowns), volume * np.eye(3), atol=1e-6 * volume)
    assert np.allclose(crowns.cross_products.sum(axis=0), 0.0, atol=1e-6 * volume)
    assert (crowns.face_areas > 0.0).all()


def test_a_wood_of_one_height_is_one_prism():
    made = with_crowns(np.zeros((5, 7)), np.full((5, 7), 4.0))
    crowns = len(made.canopy_mesh.faces) - len(made.mesh.faces)
    assert crowns == 2 * (2 * 5 * 7 + 2 * (5 + 7))  # tops and undersides, and the walls around
    assert with_crowns(np.zeros((5, 7)), np.zeros((5, 7))).canopy_mesh is None


@pytest.mark.slow
def test_under_a_canopy_without_end():
    flat = np.zeros((9, 9))
    made = with_crowns(flat, flat + 4.0, Affine.scale(1e4, -1e4))
    for share in (0.0, 0.1, 1.0):
        assert float(sky(made, 40, share, 64).value[0]) == pytest.approx(share, abs=1e-6)


@pytest.mark.slow
def test_in_a_street_under_trees():
    """As wide as high, closed at the roofs."""
    transform = Affine.scale(20.0, -1e4)
    made = with_crowns([20.0, 0.0, 20.0], [0.0, 25.0, 0.0], transform, trunk=0.8, model="block")
    assert_sky(made, 1, 0.1, 0.1 * np.cos(np.arctan(2.0)))


def test_below_a_strip_of_crowns():
    """8 wide, 4 above the point: sin 45° is blocked."""
    made = with_crowns(np.zeros(5), [0.0, 0.0, 6.0, 0.0, 0.0], LONG, trunk=2.0 / 3.0)
    assert_sky(made, 2, 0.1, 1.0 - 0.9 * np.sqrt(0.5))


@pytest.mark.parametrize(("share", "exact"), [(0.03, 0.24932), (0.2, 0.38088)])
def test_below_a_square_crown(share, exact):
    """10 x 10, 3 above the point; the exact value has five digits."""
    canopy = np.zeros((3, 3))
    canopy[1, 1] = 12.0
    assert_sky(with_crowns(np.zeros((3, 3)), canopy, Affine.scale(10.0, -10.0), trunk=0.25), 4, share, exact)


def test_beside_a_hedge():
    """6 high, 10 away, without end; two hedges keep no more light off than the higher one."""
    transform = Affine.scale(20.0, -1e4)
    exact = 1.0 - 0.9 * 0.5 * (1.0 - 1.0 / np.sqrt(1.36))
    for hedges in ([0.0, 6.0, 0.0, 0.0], [0.0, 6.0, 0.0, 6.0]):
        assert_sky(with_crowns(np.zeros(4), hedges, transform, trunk=0.0), 0, 0.1, exact)


def test_a_point_within_a_crown_sees_through_it_alone():
    made = with_crowns(np.zeros((3, 3)), np.full((3, 3), 4.0), trunk=0.0)
    assert float(sky(made, 4, 0.3, 64).value[0]) == pytest.approx(0.3, abs=1e-6)


@pytest.mark.slow
def test_the_trunk_zone_lets_the_sun_pass():
    """From 10 in front of a crown from 2 to 6 high and 20 wide, towards it: under it, through it, over it."""
    transform = Affine.scale(20.0, -1e4)
    made = with_crowns(np.zeros(2), [0.0, 6.0], transform, trunk=1.0 / 3.0)
    points, cells = made.points()
    altitude = np.radians([3.0, 20.0, 45.0])
    suns = np.stack([np.cos(altitude), 0.0 * altitude, np.sin(altitude)], axis=1)
    some = points.take(cells == 0)
    for k, lit in enumerate((1.0, 0.25, 1.0)):
        assert count_suns_through(made.scenery, some, suns[k : k + 1], 0.25 * ONE)[0] == pytest.approx(lit, abs=1e-12)
    assert count_suns_through(made.scenery, some, suns, np.array([0.5, 0.25, 0.1]))[0] == pytest.approx(2.25, abs=1e-12)


def test_trunks_and_crowns_come_in_rasters_and_as_elevations(tmp_path):
    ground = rough()
    canopy = np.where(np.arange(ground.size).reshape(ground.shape) % 3 == 0, 7.0, 0.0)
    trunk = np.where(canopy > 0.0, 2.0, 0.0)
    right = with_crowns(ground, canopy, trunk=(trunk, NORTH_UP, None)).canopy_mesh
    assert np.allclose(right.vertices, with_crowns(ground, canopy, trunk=2.0 / 7.0).canopy_mesh.vertices, atol=1e-12)
    above = np.where(canopy > 0.0, ground + canopy, np.nan), np.where(canopy > 0.0, ground + trunk, np.nan)
    found = with_crowns(ground, above[0], trunk=(above[1], NORTH_UP, None), relative=False).canopy_mesh
    assert np.array_equal(found.vertices, right.vertices)
    moved = Affine.translation(5e5, 1e5) @ NORTH_UP
    file = write_tif(tmp_path / "canopy.tif", canopy.astype(np.float32), transform=moved)
    read = rasters.surface((ground, moved, "EPSG:3794"), canopy=file, trunk=2.0 / 7.0)
    assert np.allclose(read.canopy_mesh.vertices - [5e5, 1e5, 0.0], right.vertices, atol=1e-9)


@pytest.mark.parametrize("metres", [1.0, 1200.0 / 3937.0])
def test_what_differs_from_the_ground_by_rounding_is_no_crown(metres):
    """Elevations in feet or in steps of a centimetre made flat slabs on slopes: sky views were 0.07 too low."""
    ground = np.add.outer(np.arange(8.0), np.arange(8.0)) / metres
    canopy = ground + np.where(np.arange(8) % 2 == 0, 0.008, 1e-6) / metres
    canopy[3, 3] = ground[3, 3] + 0.02 / metres
    crs = "EPSG:2263+5703" if metres == 1.0 else "EPSG:2263+6360"
    where = Affine.translation(9e5, 2e5) @ NORTH_UP, crs
    made = rasters.surface((ground, *where), canopy=(canopy, *where), relative=False)
    assert len(made.canopy_mesh.faces) - len(made.mesh.faces) == 12  # of one crown


@pytest.mark.parametrize("crs", ["EPSG:2263", None])
def test_heights_of_crowns_and_far_terrain_in_feet_keep_their_unit_without_a_crs(tmp_path, crs):
    """They were converted to metres, and then taken as feet of the map."""
    where = Affine.translation(9e5, 2e5) @ NORTH_UP
    heights = np.kron(np.eye(3), np.full((4, 4), 20.0)).astype(np.float32)
    ground = write_tif(tmp_path / "dsm.tif", heights, transform=where, crs="EPSG:2263", units="US survey foot")
    other = write_tif(tmp_path / "other.tif", heights, transform=where, crs=crs, units="US survey foot")
    crowns = rasters.surface(ground, canopy=other).canopy_mesh.vertices
    assert np.ptp(crowns[:, 2]) == pytest.approx(40.0, abs=1e-3)
    around = rasters.sky_view_factor(ground, 64, far=other, tile=4, margin=1)
    assert np.allclose(around.value, rasters.sky_view_factor(ground, 64, far=ground, tile=4, margin=1).value)


@pytest.mark.parametrize("argument", ["canopy", "far"])
def test_crowns_and_far_terrain_in_feet_are_refused_beside_heights_in_feet_without_a_crs(tmp_path, argument):
    """The heights were converted to metres, those of the crowns or the far terrain kept in feet."""
    where = Affine.translation(9e5, 2e5) @ NORTH_UP
    ground, other = (
        write_tif(tmp_path / f"{name}.tif", np.eye(3), transform=where, crs=crs, units="US survey foot")
        for name, crs in (("dsm", None), ("other", "EPSG:2263"))
    )
    with (
        pytest.warns(UserWarning, match="without a CRS"),
        pytest.raises(ValueError, match=rf"^{argument}: got coordinates of NAD83 .*, in units of 0.304801 m, want metres"),
    ):
        rasters.sky_view_factor(ground, 4, **{argument: other})


def test_errors_are_those_of_both_runs():
    made = with_crowns(np.zeros((3, 3)), np.eye(3) * 6.0)
    points, _ = made.points()
    below, above = (ws.sky_view_factor(mesh, points, 256) for mesh in (made.canopy_mesh, made.mesh))
    found = estimate_through_crowns(
        made.scenery, check_transmittance(0.3), lambda mesh: ws.sky_view_factor(mesh, points, 256)
    )
    assert np.allclose(found.value, 0.7 * below.value + 0.3 * above.value, rtol=1e-6)
    errors = 0.7 * errors_of(below)[0] + 0.3 * errors_of(above)[0]
    assert np.allclose(found.standard_error, errors, rtol=1e-6)
    assert np.array_equal(found.rays, below.rays + above.rays)
    assert found.rays.dtype == np.int32
    without_crowns = rasters.surface((np.zeros((3, 3)), NORTH_UP, None))
    alone = estimate_through_crowns(
        without_crowns.scenery, check_transmittance(0.3), lambda mesh: ws.sky_view_factor(mesh, points, 256)
    )
    assert np.array_equal(alone.value, above.value)


def test_shares_by_date():
    hours = np.array(["1998-01-31T23", "2003-02-01T00", "2004-12-31T23"], "datetime64[m]")  # as typical years have them
    assert shares_of_hours(check_transmittance(np.arange(12) / 12.0), hours).tolist() == [0.0, 1.0 / 12.0, 11.0 / 12.0]
    assert shares_of_hours(check_transmittance(np.arange(365) / 365.0), hours).tolist() == [30 / 365, 31 / 365, 364 / 365]
    assert shares_of_hours(check_transmittance(0.5), hours).tolist() == [0.5] * 3


@pytest.mark.parametrize(
    ("canopy", "options", "message"),
    [
        (-np.eye(3), {}, "canopy: got heights from -1 to 0, want heights above the ground, 0 where there are no crowns"),
        (np.ones((2, 3)), {}, "canopy: got 2 x 3 cells, want 3 x 3, as in the raster of heights"),
        (np.ones(3), {}, r"canopy: got an array of shape \(3,\), want \(rows, columns\)"),
        (np.eye(3), {"trunk": 1.5}, "trunk: got 1.5, want a number from 0 to 1"),
        (np.eye(3), {"trunk": (np.ones((4, 3)), NORTH_UP, None)}, "trunk: got 4 x 3 cells, want 3 x 3"),
        (np.eye(3), {"relative": "no"}, "relative: got 'no', want True or False"),
    ],
)
def test_bad_crowns_are_named(canopy, options, message):
    with pytest.raises((TypeError, ValueError), match="^" + message):
        rasters.surface((np.zeros((3, 3)), NORTH_UP, None), canopy=(canopy, NORTH_UP, None), **options)


@pytest.mark.parametrize(
    ("options", "got"), [({"trunk": 0.5}, "0.5"), ({"trunk": "t.tif"}, "'t.tif'"), ({"relative": False}, "False")]
)
def test_what_is_said_of_crowns_without_any_is_refused(options, got):
    argument = next(iter(options))
    with pytest.raises(ValueError, match=f"^{argument}: got {got} without canopy, want canopy, the raster of"):
        rasters.surface((np.zeros((3, 3)), NORTH_UP, None), **options)


@pytest.mark.parametrize(
    ("canopy", "message"),
    [
        (
            (np.eye(3), Affine.translation(0.5, 0.0) @ NORTH_UP, None),
            "canopy: got cells that are 0.5 away from the cells of the heights",
        ),
        ((np.eye(3), NORTH_UP, "EPSG:32633"), "canopy: got coordinates of WGS 84 / UTM zone 33N, want Slovenia"),
        ("missing.tif", "canopy: got 'missing.tif', which is missing"),
        (None, None),
    ],
)
def test_crowns_of_another_map_are_refused(canopy, message):
    source = np.zeros((3, 3)), NORTH_UP, "EPSG:3794"
    if message is None:
        assert rasters.surface(source, canopy=(np.eye(3), NORTH_UP, "EPSG:3794")).canopy_mesh is not None
        return
    with pytest.raises((ValueError, FileNotFoundError), match="^" + message):
        rasters.surface(source, canopy=canopy)


def test_crowns_without_height_are_reported():
    with pytest.warns(UserWarning, match=r"^trunk: got undersides at or above the tops of 2 crowns, which are left out$"):
        made = with_crowns(np.zeros((3, 3)), np.eye(3) * 5.0, trunk=(np.diag([5.0, 1.0, 9.0]), NORTH_UP, None))
    assert len(made.canopy_mesh.faces) - len(made.mesh.faces) == 12


def test_crowns_without_a_trunk_height_are_reported():
    with pytest.warns(UserWarning, match=r"^trunk: got no height for 1 crowns, which then reach down to the ground$"):
        with_crowns(np.zeros((3, 3)), np.eye(3) * 5.0, trunk=(np.diag([1.0, np.nan, 1.0]), NORTH_UP, None))


@pytest.mark.parametrize("value", [-0.1, 1.1, np.nan, [0.5] * 3, "half"])
def test_other_shares_are_refused(value):
    with pytest.raises((TypeError, ValueError), match="^transmittance: got"):
        check_transmittance(value)


@pytest.mark.parametrize("tiles", [{}, {"tile": 3, "margin": 1}], ids=["whole", "tiles"])
def test_nights_have_no_sun_hours_below_leaves_of_each_month(tiles):
    """A period without sun was refused as wrong `directions`, which no one had given."""
    pytest.importorskip("pvlib")
    given = {"canopy": (np.eye(6) * 5.0, NORTH_UP, None), "transmittance": np.linspace(0.0, 1.0, 12), **tiles}
    found = rasters.sun_hours((np.zeros((6, 6)), NORTH_UP, None), "athens", period=("12-21T20", "12-21T23"), **given)
    assert (found.value == 0.0).all()


@pytest.mark.slow
def test_a_year_of_leaves_is_the_sum_of_its_months():
    """At no further ray: light of each hour is dimmed before it is summed. Sums of float32 differ by some roundings."""
    pytest.importorskip("pvlib")
    pytest.importorskip("pyradiance")
    made = with_crowns(np.zeros((5, 5)), np.eye(5) * 6.0, Affine.scale(4.0, -4.0))
    points, _ = made.points()
    shares = np.linspace(0.0, 1.0, 12)

    def received(transmittance, *period):
        options = RayOptions.of(len(points), seed=3).replace()
        given = {"ground_albedo": 0.2, "patches": "tregenza", "up": (0, 0, 1), "north": made.north}
        light = light_of("athens", period=period, **given)
        return compute_irradiation_through(
            made.scenery, points, light, check_transmittance(transmittance), count=64, options=options
        )

    whole = received(shares, "05-20", "07-10")
    parts = [
        received(shares[month], first, last)
        for month, first, last in ((4, "05-20", "05-31"), (5, "06-01", "06-30"), (6, "07-01", "07-10"))
    ]
    for name in ("value", "direct", "diffuse", "ground"):
        found = getattr(whole, name)
        assert np.allclose(found, sum(getattr(part, name) for part in parts), rtol=1e-5, atol=1e-6), name
        assert name == "ground" or (found > 0.0).all()
    assert (whole.direct[12] < 0.8 * whole.direct.max()).all()  # below a crown
    assert np.array_equal(whole.rays, parts[0].rays)
    clear, dark = received(1.0, "06-01", "06-30"), received(0.0, "06-01", "06-30")
    mixed = received(0.25, "06-01", "06-30")
    assert np.allclose(mixed.value, 0.25 * clear.value + 0.75 * dark.value, rtol=1e-5)
    assert np.allclose(mixed.standard_error, 0.25 * clear.standard_error + 0.75 * dark.standard_error, rtol=1e-4, atol=1e-6)
