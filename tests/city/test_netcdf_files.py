"""A netCDF file by its path gives the same heights as xarray, or an error: GDAL ignores units, gaps and nodata values."""

import re
from contextlib import suppress

import numpy as np
import pytest

pytest.importorskip("rasterio")

import rasterio.shutil
import xarray as xr
from affine import Affine
from raster_cases import write_tif

from warpsample.city.rasters.sources import netcdf
from warpsample.city.rasters.sources.reading import reader_of

ALL = slice(None)
HEIGHTS = (100 + np.arange(30 * 40).reshape(30, 40) % 300).astype(np.float32)
X, Y = 500000.0 + 2.0 * np.arange(40), 5000000.0 - 2.0 * np.arange(30)


def array(x=X, y=Y, unit="m", names=("y", "x"), **attributes):
    """Heights on a map of Slovenia, with the attributes of coordinates that GDAL needs."""
    about = [{"standard_name": f"projection_{axis}_coordinate", "units": unit} for axis in "yx"]
    coordinates = {name: (name, centres, one) for name, centres, one in zip(names, (y, x), about, strict=True)}
    return xr.DataArray(HEIGHTS, dims=names, coords=coordinates, name="z", attrs=attributes).rio.write_crs("EPSG:3794")


def heights_of(path, content, engine="scipy", **encoding):
    content.to_netcdf(path, engine=engine, encoding={"z": encoding} if encoding else None)
    return reader_of(str(path)).read(ALL, ALL)


def moved(centres, start):
    return centres + 20.0 * np.sign(centres[1] - centres[0]) * (np.arange(len(centres)) >= start)


@pytest.mark.parametrize(
    ("content", "got"),
    [
        (array(X / 1000.0, Y / 1000.0, "km"), "coordinates 'y' in 'km', want the unit of the CRS (1 m)"),
        (array(unit="ft"), "coordinates 'y' in 'ft', want the unit of the CRS"),
        (array(moved(X, 25)), "coordinates 'x' that are not evenly spaced, want cells of one size"),
        (array(y=moved(Y, 12)), "coordinates 'y' that are not evenly spaced"),
        (array(valid_min="none"), "attributes {'valid_min': 'none'} of '"),
        (array(valid_range=np.float32([0, 1, 2])), "attributes {'valid_range': array([0., 1., 2.]"),
        (array(y=moved(Y[::-1], 12), names=("north", "east")), "coordinates 'north' that are not evenly spaced"),
    ],
)
def test_coordinates_that_gdal_misreads_are_refused(tmp_path, content, got):
    with pytest.raises(ValueError, match="^source: got " + re.escape(got)):
        heights_of(tmp_path / "dsm.nc", content)


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
@pytest.mark.parametrize(
    ("content", "encoding", "is_none"),
    [
        (array(), {}, HEIGHTS < 0.0),
        (array(names=("northing", "easting")), {}, HEIGHTS < 0.0),
        (array(missing_value=np.float32(101)), {"_FillValue": np.float32(100)}, HEIGHTS <= 101.0),
        (array(missing_value=np.array([101.0, 103.0], np.float32)), {}, np.isin(HEIGHTS, [101.0, 103.0])),
        (array(valid_min=np.float32(103)), {}, HEIGHTS < 103.0),
        (array(valid_max=np.float32(390)), {}, HEIGHTS > 390.0),
        (array(valid_range=np.array([103, 390], np.float32)), {}, (HEIGHTS < 103.0) | (HEIGHTS > 390.0)),
    ],
)
def test_every_nodata_value_is_one(tmp_path, engine, content, encoding, is_none):
    found = heights_of(tmp_path / "dsm.nc", content, engine, **encoding)
    assert np.array_equal(found, np.where(is_none, np.nan, HEIGHTS), equal_nan=True)


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
@pytest.mark.parametrize("outside", [np.nan, np.float32(1e20), np.int32(-99999), -1e34])
def test_a_nodata_value_outside_of_the_type_is_in_no_cell(tmp_path, engine, outside):
    content = array(missing_value=outside).copy(data=HEIGHTS.astype(np.int16))
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", content, engine), HEIGHTS)
    assert np.array_equal(reader_of(content).read(ALL, ALL), HEIGHTS)
    odd = array(missing_value="none").copy(data=HEIGHTS.astype(np.int16))
    with pytest.raises(ValueError, match="dsm.nc' of attributes {'missing_value': 'none'}, want numbers"):
        heights_of(tmp_path / "dsm.nc", odd, engine)


@pytest.mark.parametrize(
    ("number", "stated", "scale"),
    [
        (np.int32(2147483647), np.int32(2147483647), np.float32(0.5)),
        (np.int32(2147483647), np.float32(2147483647), 0.5),
        (np.int32(-99999999), -99999999.0, np.float32(0.5)),
        (np.float32(-99999.9), -99999.9, None),
        (np.float32(-99999.9), -99999.9, 0.5),
        (np.int32(7), 7.4, None),
    ],
)
def test_nodata_values_that_xarray_misses_are_found(tmp_path, number, stated, scale):
    """It compares with a number of another type, or after a conversion to float32: cells had heights such as 1e9."""
    attributes = {"missing_value": stated} | ({} if scale is None else {"scale_factor": scale})
    stored = np.where(HEIGHTS > 350.0, number, HEIGHTS.astype(number.dtype))
    array(**attributes).copy(data=stored).to_netcdf(tmp_path / "dsm.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "dsm.nc", decode_coords="all") as dataset:
        found = reader_of(dataset["z"]).read(ALL, ALL)
    right = np.where((HEIGHTS > 350.0) & (stated != 7.4), np.nan, stored * (scale or 1.0))
    assert np.array_equal(found, right, equal_nan=True)


@pytest.mark.parametrize("attributes", [{}, {"scale_factor": 0.5}, {"_FillValue": np.int16(-5)}])
def test_the_fill_value_of_zarr_marks_no_cells(tmp_path, attributes):
    """Zarr fills parts that are not written with 0, and xarray masks no cell for it: ground at sea level had no value."""
    pytest.importorskip("zarr", "3")
    stored = (HEIGHTS > 350.0).astype(np.int16)
    content = array(**attributes).copy(data=stored).to_dataset(name="z")
    content.to_zarr(tmp_path / "dsm.zarr", zarr_format=3, consolidated=False)
    with xr.open_zarr(tmp_path / "dsm.zarr", consolidated=False, decode_coords="all") as dataset:
        assert dataset["z"].encoding["fill_value"] == 0
        assert np.array_equal(reader_of(dataset["z"]).read(ALL, ALL), stored * attributes.get("scale_factor", 1.0))


@pytest.mark.parametrize("name", ["_FillValue", "missing_value", "fill_value", "nodata"])
@pytest.mark.parametrize("value", [None, "NaN"])
def test_a_nodata_value_that_is_none_marks_no_cells(name, value):
    """xarray writes no such attribute for None."""
    content = array()
    content.encoding[name] = value
    assert np.array_equal(reader_of(content).read(ALL, ALL), HEIGHTS)
    assert np.array_equal(reader_of(array(**{name: value})).read(ALL, ALL), HEIGHTS)


@pytest.mark.parametrize("stated", [{}, {"_FillValue": -9999.0, "missing_value": -9999.0}, {"missing_value": [7.0, 9.0]}])
def test_a_nodata_value_that_rioxarray_has_stored_counts(stated):
    """Its accessor is not copied with the array."""
    content = array(**stated)
    content.rio.set_nodata(101.0, inplace=True)
    assert np.array_equal(np.isnan(reader_of(content).read(ALL, ALL)), HEIGHTS == 101.0)


@pytest.mark.parametrize("name", ["_FillValue", "missing_value", "fill_value", "nodata"])
@pytest.mark.parametrize("one", [np.array([101.0]), [101.0], 101, "101", np.float32(101.0)])
def test_a_nodata_value_may_be_a_list_of_one(name, one):
    assert np.array_equal(np.isnan(reader_of(array(**{name: one})).read(ALL, ALL)), HEIGHTS == 101.0)


def test_an_array_may_change_between_two_calls():
    """The accessor of rioxarray remembers the nodata value and the CRS that it has found first."""
    content = array(_FillValue=101.0)
    assert np.array_equal(np.isnan(reader_of(content).read(ALL, ALL)), HEIGHTS == 101.0)
    content.attrs["_FillValue"] = 102.0
    assert np.array_equal(np.isnan(reader_of(content).read(ALL, ALL)), HEIGHTS == 102.0)
    content.coords["spatial_ref"] = array().rio.write_crs("EPSG:32631").coords["spatial_ref"]
    assert reader_of(content).crs.to_epsg() == 32631


def test_rows_from_south_to_north_are_read_as_such(tmp_path):
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", array(y=Y[::-1])), HEIGHTS[::-1])


@pytest.mark.parametrize("dimensions", [("y", "x"), ("x", "y")])
def test_a_stale_transform_and_the_order_of_dimensions_change_no_place(tmp_path, dimensions):
    """GDAL takes the transform that rioxarray keeps in spatial_ref rather than the coordinates, and x for y."""
    place = {"crs_wkt": array().rio.crs.to_wkt(), "GeoTransform": "500000 9 0 5000000 0 -9"}
    content = array().transpose(*dimensions)[::2, ::2].assign_coords(spatial_ref=((), 0, place))
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", content), HEIGHTS[::2, ::2])
    transform = reader_of(str(tmp_path / "dsm.nc")).transform
    assert transform[:6] == (4.0, 0.0, 499998.0, 0.0, -4.0, 5000002.0)


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
def test_packed_numbers_are_unpacked(tmp_path, engine):
    """Also the lowest integers, which stand for no data in other files, unsigned ones, and coordinates.

    xarray may unpack to float32, which rounds heights up to 65.5 by 4e-6.
    """
    stored = np.linspace(-32767, 32767, 1200).astype(np.int16).reshape(30, 40)
    about = {"scale_factor": 0.001, "add_offset": 32.767, "_FillValue": np.int16(-32768)}
    found = heights_of(tmp_path / "dsm.nc", array(**about).copy(data=stored), engine)
    assert np.allclose(found, 0.001 * stored + 32.767, atol=1e-5)
    unsigned = array(_Unsigned="true", _FillValue=np.int16(-1), scale_factor=0.001).copy(data=stored)
    found = heights_of(tmp_path / "dsm.nc", unsigned, engine)
    assert np.allclose(found, np.where(stored == -1, np.nan, 0.001 * stored.view(np.uint16)), atol=1e-5, equal_nan=True)
    unsigned = array(_Unsigned="true", missing_value=np.int16(-5), valid_max=np.int16(-3)).copy(data=stored)
    found = heights_of(tmp_path / "dsm.nc", unsigned, engine)
    right = np.where(np.isin(stored, [-1, -2, -5]), np.nan, stored.view(np.uint16))
    assert np.array_equal(found, right, equal_nan=True)
    assert np.array_equal(
        reader_of(unsigned.drop_attrs().assign_attrs(_Unsigned="true")).read(ALL, ALL), stored.view(np.uint16)
    )
    packed = array()
    for name in ("x", "y"):
        packed[name] = (name, np.arange(packed[name].size), packed[name].attrs | {"scale_factor": 2.0, "add_offset": 5e5})
    heights_of(tmp_path / "dsm.nc", packed, engine)
    assert reader_of(str(tmp_path / "dsm.nc")).transform[:6] == (2.0, 0.0, 499999.0, 0.0, -2.0, 500059.0)


def test_unpacked_unsigned_numbers_may_have_the_bits_of_usual_nodata_values(tmp_path):
    stored = np.linspace(-32767, 32767, 1200).astype(np.int16).reshape(30, 40)
    array(_Unsigned="true", scale_factor=0.001).copy(data=stored).to_netcdf(tmp_path / "dsm.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "dsm.nc", decode_coords="all") as dataset:
        assert np.allclose(reader_of(dataset["z"]).read(ALL, ALL), 0.001 * stored.view(np.uint16), atol=1e-5)


def test_unsigned_numbers_that_stand_for_signed_ones_are_read_as_such(tmp_path):
    signed = (np.arange(1200) % 200 - 100).astype(np.int8).reshape(30, 40)
    content = array(_Unsigned="false", _FillValue=np.uint8(251), valid_max=np.uint8(90)).copy(data=signed.view(np.uint8))
    right = np.where((signed == -5) | (signed > 90), np.nan, signed)
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", content, "h5netcdf"), right, equal_nan=True)


@pytest.mark.parametrize(
    ("limits", "dtype", "kept"),
    [
        ([0, 100], np.int16, 10.0),
        ([0, 100], np.int32, 10.0),
        ([0.0, 10.0], np.float64, 10.0),
        ([0.0, 20.1], np.float64, 20.1),
        ([0, 201], np.int16, 20.1),
    ],
)
def test_a_valid_range_of_integers_is_in_stored_numbers(tmp_path, limits, dtype, kept):
    stored = (np.arange(1200) % 400).astype(np.int16).reshape(30, 40)
    content = array(scale_factor=0.1, valid_range=np.array(limits, dtype)).copy(data=stored)
    found = heights_of(tmp_path / "dsm.nc", content)
    assert np.array_equal(np.isnan(found), 0.1 * stored > kept + 1e-6)
    turned = array(scale_factor=-0.1, valid_range=np.array(limits, dtype)).copy(data=stored - 400)  # stored as depths
    found = heights_of(tmp_path / "dsm.nc", turned)
    is_stored = dtype != np.float64
    right = (stored - 400 < 0) if is_stored else (-0.1 * (stored - 400) > kept + 1e-6)
    assert np.array_equal(np.isnan(found), right)
    plain = array(valid_max=20.1).copy(data=np.float32(0.1) * stored)  # which float32 rounds upwards
    assert np.array_equal(np.isnan(heights_of(tmp_path / "dsm.nc", plain)), stored > 201)


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
@pytest.mark.parametrize("packing", [{"scale_factor": 0.01}, {"add_offset": 500.0}, {"scale_factor": np.float32(0.3)}])
@pytest.mark.parametrize(("dtype", "codes"), [(np.int16, [-9999, -32767]), (np.int32, [-32768, -2147483647])])
def test_undeclared_nodata_values_of_packed_numbers_are_found(tmp_path, engine, packing, dtype, codes):
    """They are compared before the conversion, as in a GeoTIFF with a scale."""
    stored = HEIGHTS.astype(dtype)
    stored[2:4, 5] = codes
    found = heights_of(tmp_path / "dsm.nc", array(**packing).copy(data=stored), engine)
    assert np.array_equal(np.isnan(found), stored < 0)
    declared = array(_FillValue=dtype(120), **packing).copy(data=stored)
    right = (stored == 120) | (stored < -2e9)  # numbers beyond the limits of int32 are never heights
    assert np.array_equal(np.isnan(heights_of(tmp_path / "dsm.nc", declared, engine)), right)


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
@pytest.mark.parametrize("dtype", [np.int16, np.int32, np.float32, np.float64])
def test_numbers_of_each_dtype_are_read(tmp_path, engine, dtype):
    """Whole numbers without nodata value and scale stay whole, and have no infinite limits."""
    content = array().copy(data=HEIGHTS.astype(dtype))
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", content, engine), HEIGHTS)
    content = content.assign_attrs(valid_max=dtype(300))
    right = np.where(HEIGHTS > 300.0, np.nan, HEIGHTS)
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", content, engine), right, equal_nan=True)


TURNED = Affine(0.8, 0.6, 500000.0, 0.6, -0.8, 5000000.0)


@pytest.mark.parametrize("transform", [TURNED, Affine(2.0, 0.0, 500000.0, 0.0, 2.0, 5000000.0)])
def test_a_file_without_coordinates_has_the_transform_that_it_states(tmp_path, transform):
    content = array().drop_vars(["x", "y"]).rio.write_transform(transform)
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", content), HEIGHTS)
    assert reader_of(str(tmp_path / "dsm.nc")).transform == transform


def test_a_turned_file_with_coordinates_is_refused(tmp_path):
    """So GDAL writes it, with coordinates of the raster as it were without the turn."""
    source = write_tif(tmp_path / "dsm.tif", HEIGHTS, transform=TURNED)
    rasterio.shutil.copy(source, tmp_path / "dsm.nc", driver="netCDF")
    with pytest.raises(ValueError, match=r"dsm.nc', which is turned and has coordinates without the turn; write it as a Ge"):
        reader_of(str(tmp_path / "dsm.nc"))


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
def test_a_damaged_file_is_refused_or_read_rightly(tmp_path, engine):
    """GDAL read missing heights as 0, and crashed on some damaged headers."""
    path, rng = tmp_path / "dsm.nc", np.random.default_rng(0)
    heights_of(path, array(), engine)
    content = path.read_bytes()
    cut = [content[: int(share * len(content))] for share in (0.1, 0.5, 0.9, 0.999)]
    for damaged in cut:
        path.write_bytes(damaged)
        with pytest.raises(ValueError, match=r"^source: got '.*dsm.nc', (which cannot be read as|whose end is missing)"):
            reader_of(str(path)).read(ALL, ALL)
    for _ in range(100 if engine == "scipy" else 0):
        changed = bytearray(content)
        changed[rng.integers(4, 2000)] = rng.integers(256)
        path.write_bytes(changed)
        with suppress(ValueError, TypeError):
            reader_of(str(path)).read(ALL, ALL)


def test_damaged_lists_of_hdf5_end(tmp_path, monkeypatch):
    """HDF5 follows some of them without an end, and crashes on others: here, one of the first sectors set to 0."""
    monkeypatch.setattr(netcdf, "_SECONDS", 1)
    path = tmp_path / "dsm.nc"
    heights_of(path, array(), "h5netcdf", chunksizes=(10, 10), zlib=True, fletcher32=True)
    content = path.read_bytes()
    for first in range(0, 8192, 512):
        path.write_bytes(content[:first] + bytes(512) + content[first + 512 :])
        with suppress(ValueError):
            reader_of(str(path)).read(ALL, ALL)


def test_damaged_and_missing_chunks_are_refused(tmp_path):
    h5netcdf, path = pytest.importorskip("h5netcdf"), tmp_path / "dsm.nc"
    with h5netcdf.File(path, "w") as file:
        file.dimensions = {"y": 60, "x": 50}
        for name, centres in (("x", np.arange(50.0)), ("y", -np.arange(60.0))):
            file.create_variable(name, (name,), data=centres).attrs["units"] = "m"
        numbers = (1 + np.arange(3000) % 700).reshape(60, 50).astype(np.int16)
        file.create_variable("z", ("y", "x"), data=numbers, chunks=(16, 16), compression="gzip", fletcher32=True)
    content = path.read_bytes()
    for first in range(6144, 8192, 512):
        path.write_bytes(content[:first] + bytes(512) + content[first + 512 :])
        with suppress(ValueError):
            assert np.array_equal(reader_of(str(path)).read(ALL, ALL), numbers)
    changed = bytearray(content)
    changed[content.index(np.array([16, 32, 0], "<u8").tobytes()) + 1] = 1  # key of a chunk, in the index
    path.write_bytes(changed)
    with pytest.raises(ValueError, match=r"dsm.nc', which cannot be read as netCDF: .*chunk"):
        reader_of(str(path)).read(ALL, ALL)
    with h5netcdf.File(path, "w") as file:
        file.dimensions = {"y": 60, "x": 50}
        file.create_variable("z", ("y", "x"), np.int16, chunks=(16, 16))[:10] = 1
    with pytest.raises(
        ValueError, match="dsm.nc', which cannot be read as netCDF: 12 chunks of 'z' are missing, with heights of 0"
    ):
        reader_of(str(path))


def test_files_with_many_chunks_and_unwritten_parts_are_read(tmp_path):
    """A search for each of 40,000 chunks took 30 s. Parts with nodata values, and other variables, may be missing."""
    h5netcdf, path = pytest.importorskip("h5netcdf"), tmp_path / "dsm.nc"
    with h5netcdf.File(path, "w") as file:
        file.dimensions = {"t": 3, "y": 1000, "x": 800}
        file.create_variable("z", ("y", "x"), np.int16, chunks=(4, 4), fillvalue=np.int16(-32767))[:900] = 1
        del file["z"].attrs["_FillValue"]
        file.create_variable("count", ("t", "y", "x"), np.int16, chunks=(1, 50, 50))[0] = 1
        file.create_variable("name", ("y", "x"), "S1", chunks=(50, 50))[0] = b"a"
        file.create_variable("other", ("y", "x"), np.float32, chunks=(50, 50))[:50] = 1
        file.create_variable("table", ("t", "y"), np.float32, chunks=(1, 50))[0] = 1
        file.create_variable("group/other", ("y", "x"), np.int16, chunks=(50, 50))[:50] = 1
        for name, centres in (("x", np.arange(800.0)), ("y", -np.arange(1000.0))):
            file.create_variable(name, (name,), data=centres).attrs["units"] = "m"
    with pytest.raises(ValueError, match=r"dsm.nc' with z, count, name, other, want one variable"):
        reader_of(str(path))
    with h5netcdf.File(path, "a") as file:
        del file._h5group["count"], file._h5group["name"], file._h5group["other"]
    found = reader_of(str(path)).read(ALL, ALL)
    assert np.isnan(found[900:]).all()
    assert (found[:900] == 1.0).all()


@pytest.mark.parametrize(("fill", "stated"), [(-9999.0, {}), (7.0, {"missing_value": 7.0}), (7.0, {})])
def test_cells_of_unwritten_chunks_are_as_their_number_says(tmp_path, fill, stated):
    h5netcdf, path = pytest.importorskip("h5netcdf"), tmp_path / "dsm.nc"
    with h5netcdf.File(path, "w") as file:
        file.dimensions = {"y": 60, "x": 50}
        for name, centres in (("x", np.arange(50.0)), ("y", -np.arange(60.0))):
            file.create_variable(name, (name,), data=centres).attrs["units"] = "m"
        heights = file.create_variable("z", ("y", "x"), np.float32, chunks=(20, 50), fillvalue=np.float32(fill))
        del heights.attrs["_FillValue"]
        heights.attrs.update(stated)
        heights[:20] = 1.0
    if fill == 7.0 and not stated:
        with pytest.raises(ValueError, match="2 chunks of 'z' are missing, with heights of 7 instead"):
            reader_of(str(path))
    else:
        assert np.isnan(reader_of(str(path)).read(ALL, ALL)[20:]).all()


def test_numbers_in_other_files_are_refused(tmp_path):
    """HDF5 reads 0 for those of missing files."""
    h5py = pytest.importorskip("h5py")
    path, layout = tmp_path / "dsm.nc", h5py.VirtualLayout((30, 40), "f4")
    layout[:] = h5py.VirtualSource(str(tmp_path / "missing.nc"), "z", (30, 40))
    heights_of(path, array(), "h5netcdf")
    with h5py.File(path, "a") as file:
        file.create_virtual_dataset("other", layout)
    with pytest.raises(ValueError, match="dsm.nc', which cannot be read as netCDF: the numbers of 'other' are in other"):
        reader_of(str(path))


def test_a_classic_file_that_is_cut_later_has_the_heights_of_the_start(tmp_path):
    """SciPy would map it, and end with a bus error."""
    array().to_netcdf(tmp_path / "dsm.nc", engine="scipy")
    reader = reader_of(str(tmp_path / "dsm.nc"))
    (tmp_path / "dsm.nc").write_bytes(b"")
    assert np.array_equal(reader.read(ALL, ALL), HEIGHTS)


def test_several_variables_are_refused_by_name(tmp_path):
    both = xr.Dataset({"z": array(), "trees": array()})
    both.to_netcdf(tmp_path / "dsm.nc", engine="scipy")
    with pytest.raises(
        ValueError, match=r"dsm.nc' with z, trees, want one variable with y and x; pass xarray.open_dataset\("
    ):
        reader_of(str(tmp_path / "dsm.nc"))
