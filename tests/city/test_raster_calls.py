"""Sky and sun of rasters as datasets: the numbers of the calls, where they belong, and what they are."""

import subprocess
import sys

import numpy as np
import pytest
from affine import Affine
from raster_cases import NORTH_UP, rough, write_tif

import warpsample as ws
from warpsample import rasters
from warpsample.city.rasters.intervals import errors_of

rasterio = pytest.importorskip("rasterio")
rioxarray = pytest.importorskip("rioxarray")
xr = pytest.importorskip("xarray")

HEIGHTS = rough()
HEIGHTS[5, 6] = np.nan
SLOVENIA = Affine(1.0, 0.0, 564000.0, 0.0, -1.0, 146000.0)
WEST = Affine(1.0, 0.0, 166000.0, 0.0, -1.0, 6690000.0)  # of UTM's zone 33, where the map's north is 5.3° off


@pytest.fixture
def path(tmp_path):
    return write_tif(tmp_path / "dsm.tif", HEIGHTS.astype(np.float32), transform=SLOVENIA)


def test_a_dataset_has_the_numbers_of_the_call_in_their_cells(path):
    found = rasters.sky_view_factor(path, 64, seed=7, max_distance=50.0, sequence="sobol")
    made = rasters.surface(path)
    points, cell = made.points()
    right = ws.sky_view_factor(made.mesh, points, 64, seed=7, max_distance=50.0, sequence="sobol")
    assert list(found) == ["value", "standard_error", "half_width"]
    for name, numbers in {"value": right.value, "standard_error": errors_of(right)[0]}.items():
        assert found[name].dtype == np.float32
        assert found[name].dims == ("y", "x")
        assert np.array_equal(found[name].values.ravel()[cell], numbers)
        assert np.isnan(found[name].values[5, 6])
        assert np.isnan(found[name].values).sum() == 1
    assert found.rio.crs.to_epsg() == 3794
    assert found.rio.transform() == SLOVENIA
    opened = rioxarray.open_rasterio(path, masked=True)[0]
    assert (opened - found.value).shape == opened.shape


def test_a_cell_draws_the_same_numbers_whatever_other_cells_have_no_height():
    heights = np.pad(np.where(np.arange(12) < 6, 0.0, 8.0)[None], ((0, 9), (0, 0)), mode="edge")
    apart = np.concatenate([heights, np.full((3, 12), -9999.0)])  # rows that are no part of the surface
    gap = np.concatenate([np.full((3, 12), -9999.0), heights])
    right = rasters.sky_view_factor((heights, NORTH_UP, None), 64, seed=1)
    found = rasters.sky_view_factor((apart, NORTH_UP, None), 64, seed=1)
    assert np.array_equal(found.value[:10], right.value)
    made = rasters.surface((gap, NORTH_UP @ Affine.translation(0.0, -3.0), None))
    points, cell = made.points()
    assert np.array_equal(points.id, cell)
    other = ws.sky_view_factor(made.mesh, points, 64, seed=1)
    assert (other.value != right.value.values.ravel()).any()


@pytest.mark.slow
def test_attributes_state_the_definition_and_all_options(path):
    found = rasters.sky_view_factor(path, 32, receiver="surface", model="block", seed=3)
    attrs = found.attrs
    assert attrs["definition"].startswith("cosine-weighted share of the sky")
    assert "the normal of the cell's surface" in attrs["definition"]
    assert {name: attrs[name] for name in ("quantity", "unit", "model", "receiver", "count", "seed", "sequence", "up")} == {
        "quantity": "sky", "unit": "1", "model": "block", "receiver": "surface", "count": 32, "seed": 3,
        "sequence": "fibonacci", "up": "0.0 0.0 1.0",
    }  # fmt: skip
    assert (attrs["source"], attrs["warpsample"], attrs["cells_without_height"]) == (
        str(path),
        ws.__version__,
        1,
    )
    assert found.value.attrs["units"] == "1"
    assert found.standard_error.attrs["long_name"] == "standard error of the sky view factor"
    visible = rasters.visible_sky((HEIGHTS, SLOVENIA, None), 32)
    assert "1 - mean of sin(h)" in visible.attrs["definition"]
    assert (visible.attrs["source"], visible.attrs["quantity"]) == ("an array, tuple", "visible-sky")


def test_files_keep_the_numbers_and_where_they_are(path, tmp_path):
    found = rasters.sky_view_factor(path, 32)
    found.to_netcdf(tmp_path / "sky.nc")
    found.to_array("band").rio.to_raster(tmp_path / "sky.tif")
    with xr.open_dataset(tmp_path / "sky.nc", decode_coords="all") as again:
        assert again.rio.crs.to_epsg() == 3794
        assert again.rio.transform() == SLOVENIA
        assert again.attrs["definition"] == found.attrs["definition"]
        assert again.value.equals(found.value)
    with rasterio.open(tmp_path / "sky.tif") as file:
        assert (file.count, file.crs.to_epsg(), file.transform) == (3, 3794, SLOVENIA)
        assert np.array_equal(file.read(2), found.standard_error, equal_nan=True)


@pytest.mark.slow
def test_the_sun_stands_by_true_north():
    pytest.importorskip("pvlib")
    pytest.importorskip("pyradiance")
    heights = np.pad(rough(), 3, constant_values=0.0)
    for call, receiver in (("sun_hours", "surface"), ("irradiation", "horizontal")):
        given = {"period": ("03-20", "03-25")} | ({"patches": "tregenza", "count": 64} if call == "irradiation" else {})
        found = getattr(rasters, call)((heights, WEST, "EPSG:32633"), "athens", receiver=receiver, **given)
        made = rasters.surface((heights, WEST, "EPSG:32633"))
        assert np.degrees(np.arctan2(*made.north[:2])) == pytest.approx(5.3, abs=0.1)
        points, _ = made.points(receiver)
        direct = ws.irradiation if call == "irradiation" else sun_hours_of()
        right = direct(made.mesh, points, "athens", north=made.north, **given)
        wrong = direct(made.mesh, points, "athens", **given)
        assert np.array_equal(found.value.values.ravel(), right.value)
        assert (right.value != wrong.value).mean() > 0.1
        assert found.value.attrs["units"] == {"sun_hours": "h", "irradiation": "kWh m-2"}[call]
        assert found.attrs["north"] == " ".join(str(item) for item in made.north)
        assert found.attrs["period"] == "03-20 03-25"
        assert "refine" not in found.attrs  # an option for reflected light, and cells reflect nothing
        assert ("the normal of the receiver is up" in found.attrs["definition"]) == (receiver == "horizontal")


def sun_hours_of():
    from warpsample.radiation.quantities.sun_hours import sun_hours

    return sun_hours


def test_wrong_options_are_named_before_anything_is_read():
    for call, given, kind, message in (
        (
            rasters.sky_view_factor,
            {"up": (0, 0, 1)},
            TypeError,
            "up: got an argument that sky_view_factor does not take, want one of",
        ),
        (
            rasters.sky_view_factor,
            {"rays": 3},
            TypeError,
            "rays: got an argument that sky_view_factor does not take, want one of source, count",
        ),
        (
            rasters.visible_sky,
            {"receiver": "surface"},
            TypeError,
            "receiver: got an argument that visible_sky does not take, want one of",
        ),
        (
            rasters.irradiation,
            {"weather": "athens", "refine": 1.0},  # cells reflect nothing
            TypeError,
            "refine: got an argument that irradiation does not take, want one of",
        ),
        (rasters.sky_view_factor, {"model": "mesh"}, ValueError, "model: got 'mesh', want one of joined, block, tin"),
        (rasters.sky_view_factor, {"receiver": "tilted"}, ValueError, "receiver: got 'tilted', want one of horizontal"),
    ):
        with pytest.raises(kind, match=f"^{message}"):
            call("missing.tif", **given)
    with pytest.raises(ValueError, match="^count: got 1, want a whole number from 2"):
        rasters.sky_view_factor((HEIGHTS, NORTH_UP, None), 1)


@pytest.mark.parametrize("line", ["from warpsample import rasters", "import warpsample.rasters as rasters"])
def test_what_is_missing_is_reported_with_the_extra(child_environment, line):
    code = f"import sys; sys.modules['rioxarray'] = None; {line}; print(type(rasters).__name__); rasters.sky_view_factor"
    done = subprocess.run([sys.executable, "-c", code], env=child_environment, capture_output=True, text=True, check=False)
    assert done.stdout == "module\n"
    wanted = "ModuleNotFoundError: warpsample.rasters needs rioxarray: pip install '.[city]'"
    assert done.stderr.splitlines()[-1] == wanted


def test_the_calls_are_reported_and_others_are_not_there():
    assert set(rasters.__all__) <= set(dir(rasters))
    with pytest.raises(AttributeError, match="no attribute 'hillshade'"):
        rasters.hillshade  # noqa: B018


@pytest.mark.slow
def test_sun_hours_and_irradiation_through_crowns():
    pytest.importorskip("pvlib")
    pytest.importorskip("pyradiance")
    flat = np.zeros((5, 5)), Affine.scale(4.0, -4.0), None
    canopy = np.eye(5) * 6.0, Affine.scale(4.0, -4.0), None
    for call, own in (
        (ws.rasters.sun_hours, {}),
        (ws.rasters.irradiation, {"patches": "tregenza", "count": 64}),
    ):
        given = {"period": ("06-01", "06-10"), **own}
        dated = [0.0] * 5 + [0.4] + [0.0] * 6
        one, other = (call(flat, "athens", canopy=canopy, transmittance=share, **given) for share in (0.4, dated))
        assert np.allclose(one.value, other.value, rtol=1e-5)
        assert np.allclose(one.standard_error, other.standard_error, rtol=1e-3, atol=1e-6)
        without_crowns = call(flat, "athens", **given).value
        assert (one.value <= without_crowns).all()
        assert one.value[2, 2] < 0.9 * without_crowns[2, 2]  # below a crown
