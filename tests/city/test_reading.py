"""Rasters as people have them: what stands for no height, how they are stored, and what their CRS says."""

import re
import warnings

import numpy as np
import pyproj
import pytest
from affine import Affine
from raster_cases import ON_A_MAP as UTM
from raster_cases import write_tif

from warpsample import rasters

rasterio = pytest.importorskip("rasterio")
rioxarray = pytest.importorskip("rioxarray")
xr = pytest.importorskip("xarray")

HEIGHTS = np.array([[1.0, 2.0, 3.0, 4.0], [5.0, 0.0, 7.0, 8.0], [9.0, 10.0, 11.0, 12.0]])
GONE = HEIGHTS == 0.0
LOWEST = float(np.finfo(np.float32).min)


def heights_of(source):
    return rasters.surface(source, model="block").grid.height


def same(found, right=HEIGHTS, gone=GONE):
    assert np.array_equal(np.isnan(found), gone)
    assert np.array_equal(found[~gone], right[~gone])


@pytest.mark.parametrize(
    ("stored", "dtype", "profile"),
    [
        (-9999.0, "float32", {"nodata": -9999.0}),
        (77.0, "float64", {"nodata": 77.0}),
        (77, "uint8", {"nodata": 77}),
        (np.nan, "float32", {"nodata": np.nan}),
        (LOWEST, "float32", {"nodata": LOWEST}),  # the tag is a float64's digits of it
        (0.1, "float32", {"nodata": 0.1}),
        (np.nan, "float64", {}),
        (-9999, "int16", {}),
        (-32768, "int16", {}),
        (-(2**31), "int32", {}),  # made the extent so large that rays of all cells started too high
        (2**32 - 1, "uint32", {}),
        (-999999999, "int32", {}),
        (LOWEST, "float32", {}),
        (-LOWEST, "float32", {}),
        (-np.inf, "float32", {"nodata": -9999.0}),
        (-9999.0, "float16", {"nodata": -9999.0}),  # which float16 rounds to -10000
        (-1.7e308, "float64", {"nodata": -1.7e308}),  # which float32 does not hold
        (np.inf, "float64", {}),
        (65, "uint16", {"mask": np.where(GONE, 0, 255).astype(np.uint8)}),
    ],
)
def test_cells_without_a_height_are_known_by_whatever_stands_for_none(tmp_path, stored, dtype, profile):
    values = np.where(GONE, stored, HEIGHTS).astype(dtype)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
        path = write_tif(tmp_path / "dsm.tif", values, transform=UTM, **profile)
    same(heights_of(path))
    if "mask" not in profile:  # rioxarray leaves masks to those who ask
        same(heights_of(rioxarray.open_rasterio(path)))
        same(heights_of(rioxarray.open_rasterio(path, masked=True)))
        if not profile:
            same(heights_of((values, UTM, None)))
    same(heights_of((np.ma.masked_array(values, GONE), UTM, "EPSG:3794")))


def test_masks_of_dask_count_and_a_masked_array_may_have_none():
    dask = pytest.importorskip("dask.array")
    values = np.where(GONE, 255.0, HEIGHTS)
    same(heights_of((dask.ma.masked_equal(dask.from_array(values), 255.0), UTM, None)))
    same(heights_of((np.ma.masked_array(HEIGHTS), UTM, None)), gone=np.zeros(HEIGHTS.shape, bool))


@pytest.mark.parametrize("dtype", ["uint8", "int16", "float32"])
def test_a_band_of_transparency_is_no_band_of_heights(tmp_path, dtype):
    """GDAL makes a mask of an alpha of uint8 or uint16 alone; cells without ground had heights of 0."""
    bands = np.stack([HEIGHTS, np.where(GONE, 0.0, 255.0)]).astype(dtype)
    path = write_tif(tmp_path / "dsm.tif", bands, alpha="YES")
    same(heights_of(path))


def test_scaled_whole_numbers_are_heights(tmp_path):
    values = np.where(GONE, -1, 100 * (HEIGHTS + 5.0)).astype(np.int32)
    path = write_tif(tmp_path / "dsm.tif", values, nodata=-1, scale=(0.01, -5.0))
    same(np.round(heights_of(path), 9))
    same(np.round(heights_of(rioxarray.open_rasterio(path)), 9))
    same(np.round(heights_of(rioxarray.open_rasterio(path, mask_and_scale=True)), 9))


@pytest.mark.parametrize("dtype", ["int8", "uint8", "int16", "uint32", "int64", "float16", "float32", "float64"])
def test_heights_of_every_type(dtype):
    same(heights_of((HEIGHTS.astype(dtype), UTM, None)), gone=np.zeros(HEIGHTS.shape, bool))


def test_xarrays_of_every_kind_are_the_same_raster(tmp_path):
    path = write_tif(tmp_path / "dsm.tif", np.where(GONE, np.nan, HEIGHTS), transform=UTM)
    whole = rasters.surface(path)
    opened = rioxarray.open_rasterio(path)
    for array in (
        opened,
        opened.squeeze(drop=True),
        opened.squeeze().transpose("x", "y"),
        opened.chunk({"y": 2, "x": 3}),
        opened[0, ::-1],
        opened[0, :, ::-1],
        opened.drop_vars("spatial_ref").rio.write_crs("EPSG:3794"),
    ):
        found = rasters.surface(array)
        assert found.grid.crs == whole.grid.crs
        x, y, _ = found.mesh.vertices.T
        assert (x.min(), x.max(), y.min(), y.max()) == (500000.0, 500010.0, 4999992.5, 5000000.0)
        assert np.isclose(found.mesh.face_areas.sum(), whole.mesh.face_areas.sum())
        points, cell = found.points()
        laid = found.to_raster(points.position[:, 2], cell)
        apart = laid - array.squeeze(drop=True)  # xarray compares by coordinates: all cells must have a partner
        assert apart.sizes == {"y": 3, "x": 4}
        assert np.nanmax(np.abs(apart)) == 0.0


def test_a_part_of_an_array_is_where_it_was(tmp_path):
    """Its stored transform is still that of the whole."""
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS, transform=UTM)
    part = rasters.surface(rioxarray.open_rasterio(path)[:, 1:, 2:])
    assert np.array_equal(part.grid.centres(part.grid.cells)[0], [500006.25, 4999996.25, 7.0])
    assert part.to_raster(np.zeros(4), part.grid.cells).rio.bounds() == (500005.0, 4999992.5, 500010.0, 4999997.5)


@pytest.mark.parametrize("turn", [0.0, 20.0])
@pytest.mark.parametrize("scale", [(0.5, -0.25), (0.5, 0.25), (-0.5, -0.25)])
def test_results_have_the_rasters_crs_transform_and_coordinates(tmp_path, turn, scale):
    transform = Affine.translation(563999.5, 146000.25) @ Affine.rotation(turn) @ Affine.scale(*scale)
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS, transform=transform)
    surface = rasters.surface(path)
    points, cell = surface.points()
    laid = surface.to_raster(points.position[:, 0], cell)
    assert laid.rio.crs.to_epsg() == 3794
    assert laid.rio.transform(recalc=turn == 0.0).almost_equals(transform, 1e-9)
    laid.rio.to_raster(tmp_path / "out.tif", recalc_transform=False)
    with rasterio.open(tmp_path / "out.tif") as file:
        assert (file.crs.to_epsg(), file.transform) == (3794, transform)
        assert np.array_equal(file.read(1), laid)
    opened = rioxarray.open_rasterio(path)
    if turn == 0.0:
        assert laid.x.equals(opened.x)
        assert laid.y.equals(opened.y)
        assert np.array_equal(laid, np.broadcast_to(opened.x, (3, 4)))
    again = rasters.surface(opened)
    assert np.allclose(again.mesh.vertices, surface.mesh.vertices, atol=1e-9, rtol=0.0)


@pytest.mark.parametrize(
    ("crs", "longitude", "latitude", "degrees"),
    [
        ("EPSG:3794", 15.840, 46.455, 0.6),
        ("EPSG:5514", 14.42, 50.08, -7.8),
        ("EPSG:2056", 8.54, 47.38, 0.75),
        ("EPSG:32633", 8.95, 60.3, -5.3),
        ("EPSG:3007", 13.0, 57.7, None),
        ("EPSG:7415", 4.36, 52.0, -0.8),
        ("EPSG:2263+6360", -74.0, 40.7, None),
    ],
)
def test_north_is_where_the_meridian_points(crs, longitude, latitude, degrees):
    """Against pyproj's own convergence of meridians: above 0 where the map's north is east of true north."""
    there = pyproj.Transformer.from_crs("EPSG:4326", crs, always_xy=True).transform(longitude, latitude)
    surface = rasters.surface((HEIGHTS, Affine(1.0, 0.0, there[0] - 2.0, 0.0, -1.0, there[1] + 1.5), crs))
    assert surface.to_raster(np.zeros(12), surface.grid.cells).rio.crs == crs
    projection = pyproj.Proj(pyproj.CRS(crs).sub_crs_list[0] if pyproj.CRS(crs).is_compound else crs)
    source = pyproj.CRS(crs).geodetic_crs.to_2d()
    place = pyproj.Transformer.from_crs("EPSG:4326", source, always_xy=True).transform(longitude, latitude)
    right = projection.get_factors(*place).meridian_convergence
    assert degrees is None or right == pytest.approx(degrees, abs=0.06)
    found = np.degrees(np.arctan2(surface.north[0], surface.north[1]))
    assert found == pytest.approx(-right, abs=2e-4)  # the shift between datums is a few metres
    assert np.hypot(*surface.north[:2]) == pytest.approx(1.0)


def test_north_is_up_the_map_without_a_crs():
    assert rasters.surface((HEIGHTS, UTM, None)).north == (0.0, 1.0, 0.0)


@pytest.mark.filterwarnings("ignore:.*on which distances are")  # the place is of one of these maps alone
@pytest.mark.parametrize(
    ("crs", "units", "factor"),
    [
        ("EPSG:3794", None, 1.0),
        ("EPSG:3794", "metre", 1.0),
        ("EPSG:3794", "ft", 0.3048),
        ("EPSG:3794", "cm", 0.01),
        ("EPSG:2263", "metre", 3937.0 / 1200.0),
        ("EPSG:2263", "US survey foot", 1.0),
        ("EPSG:2263+6360", None, 1.0),  # heights in US survey feet
        ("EPSG:2263+5703", None, 3937.0 / 1200.0),  # in metres
        ("EPSG:7415", None, 1.0),
        ("EPSG:32633+8228", None, 0.3048),  # in feet
    ],
)
def test_heights_are_converted_to_the_unit_of_the_coordinates(crs, units, factor):
    array = xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": units} if units else {}).rio.write_crs(crs)
    grid = rasters.surface(array.rio.write_transform(UTM)).grid
    assert np.allclose(grid.height, factor * HEIGHTS, rtol=1e-9)
    assert grid.metres == pytest.approx(1200.0 / 3937.0 if "2263" in crs else 1.0)


@pytest.mark.parametrize(
    ("crs", "whose", "factor"),
    [
        ("EPSG:3794", "coordinates in units of 1 m", 1.0),
        ("EPSG:3794+5703", "a CRS with heights in units of 1 m", 1.0),  # without a word before
        ("EPSG:32633+8228", "a CRS with heights in units of 0.3048 m", 0.3048),
    ],
)
def test_a_unit_that_is_not_known_is_reported(crs, whose, factor):
    array = xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": "furlong"}).rio.write_crs(crs)
    said = f"got heights in 'furlong', a unit that is not known here, and {whose}; both are taken to be the same unit"
    with pytest.warns(UserWarning, match=said):
        same(heights_of(array.rio.write_transform(UTM)), factor * HEIGHTS, np.zeros(HEIGHTS.shape, bool))


@pytest.mark.parametrize("crs", ["EPSG:3794", "EPSG:3794+5703"])
@pytest.mark.parametrize(
    ("units", "metres"),
    [("centimeters", 0.01), ("Kilometres", 1000.0), ("U.S. survey feet", 1200.0 / 3937.0), ("foot (US)", 1200.0 / 3937.0)],
)
def test_units_are_known_by_several_names(crs, units, metres):
    """With heights in the CRS, they were taken for metres without a word."""
    array = xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": units}).rio.write_crs(crs)
    assert np.allclose(heights_of(array.rio.write_transform(UTM)), metres * HEIGHTS, rtol=1e-9)


def test_heights_without_a_map_are_converted_to_metres(tmp_path):
    """Coordinates are metres there; heights in feet beside them made shadows 3.3 times too long."""
    array = xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": "ft"}).rio.write_transform(UTM)
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS, crs=None, units="ft")
    for source in (array, path):
        with pytest.warns(UserWarning, match="without a CRS; its coordinates are taken as metres"):
            assert np.allclose(heights_of(source), 0.3048 * HEIGHTS, rtol=1e-6)


def test_a_unit_that_is_not_known_is_reported_without_a_map():
    array = xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": "furlong"}).rio.write_transform(UTM)
    with (
        pytest.warns(UserWarning, match="without a CRS"),
        pytest.warns(UserWarning, match="got heights in 'furlong', a unit that is not known here, and coordinates in units"),
    ):
        same(heights_of(array), gone=np.zeros(HEIGHTS.shape, bool))


@pytest.mark.parametrize(
    "attributes",
    [
        ({"units": "degrees_north"}, {"units": "degrees_east"}),
        ({"units": "Degrees"}, {}),
        ({"standard_name": "latitude"}, {"standard_name": "longitude"}),
        ({"units": "radian"}, {"units": "radian"}),
        ({"units": "degree_N"}, {"units": "degree_E"}),
    ],
)
def test_coordinates_whose_attributes_state_degrees_are_refused(attributes):
    """Also of level land, which no relief betrays."""
    centres = {"y": 47.4 - 0.025 * np.arange(4), "x": 8.5 + 0.025 * np.arange(5)}
    array = xr.DataArray(np.zeros((4, 5)), centres, ("y", "x"))
    for name, attribute in zip("yx", attributes, strict=True):
        array[name].attrs.update(attribute)
    with pytest.raises(ValueError, match="^source: got coordinates 'y' in '.*', want lengths, as heights are; reproject it"):
        rasters.surface(array)


def test_coordinates_of_float32_are_evenly_spaced_but_for_their_rounding():
    centres = {"x": np.float32(564000.5 + np.arange(200)), "y": np.float32(146000.5 - np.arange(50))}
    array = xr.DataArray(np.zeros((50, 200)), centres, ("y", "x")).rio.write_crs("EPSG:3794")
    assert np.allclose(rasters.surface(array).grid.transform[:6], (1.0, 0.0, 564000.0, 0.0, -1.0, 146001.0), atol=0.03)
    fine = xr.DataArray(np.zeros((400, 2)), {"y": 5123000.5 - 0.3 * np.arange(400), "x": [0.0, 0.3]}, ("y", "x"))
    rounded = fine.assign_coords(y=fine.y.astype(np.float32)).rio.write_crs("EPSG:3794")  # rounded to 0.5
    assert np.allclose(rasters.surface(rounded).grid.transform[4], -0.3, atol=0.002)
    with pytest.raises(ValueError, match="rounded to 0.5, too coarse for cells of about 0.29"):
        rasters.surface(rounded[:50])


@pytest.mark.parametrize("version", ["1.0", "1.1"])
def test_the_unit_of_a_compound_crs_is_read(tmp_path, version):
    """GDAL leaves out the CRS of heights in GeoTIFF 1.0."""
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS, transform=UTM, crs="EPSG:32633+6360", GEOTIFF_VERSION=version)
    assert np.allclose(heights_of(path), 1200.0 / 3937.0 * HEIGHTS)


def test_the_unit_of_a_band_is_read(tmp_path):
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS, units="ft")
    assert np.allclose(heights_of(path), 0.3048 * HEIGHTS)


def test_heights_of_an_unknown_unit_on_a_map_in_feet_are_taken_as_feet_with_a_warning():
    with pytest.warns(UserWarning, match=r"no unit of its heights, and coordinates in units of 0\.304801 m"):
        same(heights_of((HEIGHTS, UTM, "EPSG:2263")), gone=np.zeros(HEIGHTS.shape, bool))


@pytest.mark.parametrize(("crs", "x", "y"), [("EPSG:5513", 1.1e6, 6e5), ("+proj=utm +zone=33 +axis=wnu", -5e5, 5e6)])
def test_a_map_that_mirrors_the_ground_has_no_north(crs, x, y):
    """Or morning and evening change places: on Krovak's own map x is south, and y is west."""
    mirrored = rasters.surface((HEIGHTS, Affine(1.0, 0.0, x, 0.0, -1.0, y), crs))
    with pytest.raises(ValueError, match="on which east is to the left of north, want a map that does not mirror"):
        _ = mirrored.north


def test_a_map_that_pyproj_cannot_leave_has_no_north():
    petrels = rasters.surface((HEIGHTS, Affine(1.0, 0.0, 2e5, 0.0, -1.0, 2e6), "EPSG:2985"))
    with pytest.raises(ValueError, match="which is not on Earth in Petrels"):
        _ = petrels.north


def test_a_raster_outside_of_its_crs_has_no_north():
    far = rasters.surface((HEIGHTS, Affine(1.0, 0.0, 9e9, 0.0, -1.0, 9e9), "EPSG:32633"))
    with pytest.raises(ValueError, match="which is not on Earth in WGS 84 / UTM zone 33N"):
        _ = far.north


@pytest.mark.parametrize(
    ("crs", "x", "y", "ratios"),
    [
        ("EPSG:3857", 1.65e6, 5e6, ["1.33"]),
        ("EPSG:4087", 1.65e6, 6.68e6, ["1.00 to 2.01"]),
        ("EPSG:6933", 1.65e6, 5e6, ["0.84 to 1.18"]),
        ("EPSG:3035", 2.9e6, 1.6e6, []),
        ("EPSG:3031", 0.0, 0.0, []),
        ("EPSG:3857", 20037500.0, 5e6, ["1.33"]),
        ("EPSG:32633", 5e5, 5e6, []),
        ("EPSG:27572", 6e5, 2.428e6, []),
    ],
)
def test_a_map_that_stretches_the_ground_is_warned_of(crs, x, y, ratios):
    """Web Mercator by 1 / cos(latitude), here of 41 degrees; a map of degrees in metres to the east alone, here at 60.

    Also at the edge of the map. Not maps of Europe at Lisbon, of the South Pole at the pole, or in grads, of Paris.
    """
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        rasters.surface((HEIGHTS, Affine(2.5, 0.0, x, 0.0, -2.5, y), crs))
    found = (
        re.search(r"on which distances are ([\d. to]+) times as long as on the ground", str(one.message)) for one in heard
    )
    assert [match[1] for match in found if match] == ratios


@pytest.mark.parametrize("x", [20037500.0, 20037509.0, 20038000.0, 21e6, -20037510.0])
def test_a_raster_at_the_edge_of_a_map_of_the_world_has_a_north(x):
    """The step to the east led to the other edge of the map, or started there, so the map counted as mirrored."""
    with pytest.warns(UserWarning, match="on which distances are 1.33 times as long"):
        surface = rasters.surface((HEIGHTS, Affine(2.5, 0.0, x, 0.0, -2.5, 5e6), "EPSG:3857"))
    assert surface.north == pytest.approx((0.0, 1.0, 0.0), abs=1e-6)


def test_a_map_with_an_odd_unit_of_angles_has_a_north():
    """Its latitudes were beyond both poles, so that a length was 0."""
    damaged = pyproj.CRS.from_epsg(25832).to_wkt("WKT1_ESRI").replace("0.0174532925199433", "0.01199433")
    source = HEIGHTS, Affine(2.5, 0.0, 5e5, 0.0, -2.5, 5.5e6), damaged
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        assert np.isfinite(rasters.surface(source).north).all()
    assert not heard
