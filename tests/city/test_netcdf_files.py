"""A netCDF file by its path gives the same heights as xarray, or an error: GDAL ignores units, gaps and nodata values."""

import re

import numpy as np
import pytest

pytest.importorskip("rasterio")

import xarray as xr

from warpsample.city.rasters.sources.reading import reader_of

ALL = slice(None)
HEIGHTS = (100 + np.arange(30 * 40).reshape(30, 40) % 300).astype(np.float32)
X, Y = 500000.0 + 2.0 * np.arange(40), 5000000.0 - 2.0 * np.arange(30)


def array(x=X, y=Y, unit="m", names=("y", "x"), **attributes):
    """Heights on a map of Slovenia, with the attributes of coordinates that GDAL needs."""
    about = [{"standard_name": f"projection_{axis}_coordinate", "units": unit} for axis in "yx"]
    coordinates = {name: (name, centres, one) for name, centres, one in zip(names, (y, x), about, strict=True)}
    return xr.DataArray(HEIGHTS, dims=names, coords=coordinates, name="z", attrs=attributes).rio.write_crs("EPSG:3794")


def heights_of(path, content, **encoding):
    content.to_netcdf(path, engine="scipy", encoding={"z": encoding} if encoding else None)
    return reader_of(str(path)).read(ALL, ALL)


def moved(centres, start):
    return centres + 20.0 * np.sign(centres[1] - centres[0]) * (np.arange(len(centres)) >= start)


@pytest.mark.parametrize(
    ("content", "got"),
    [
        (array(X / 1000.0, Y / 1000.0, "km"), "coordinates 'x' in 'km', want the unit of the CRS (1 m)"),
        (array(unit="ft"), "coordinates 'x' in 'ft', want the unit of the CRS"),
        (array(moved(X, 25)), "coordinates 'x' that are not evenly spaced, want cells of one size"),
        (array(y=moved(Y, 12)), "coordinates 'y' that are not evenly spaced"),
        (array(y=moved(Y[::-1], 12), names=("north", "east")), "coordinates 'north' that are not evenly spaced"),
    ],
)
def test_coordinates_that_gdal_misreads_are_refused(tmp_path, content, got):
    with pytest.raises(ValueError, match="^source: got " + re.escape(got)):
        heights_of(tmp_path / "dsm.nc", content)


@pytest.mark.parametrize(
    ("content", "encoding", "is_none"),
    [
        (array(), {}, HEIGHTS < 0.0),
        (array(names=("northing", "easting")), {}, HEIGHTS < 0.0),
        (array(missing_value=np.float32(101)), {"_FillValue": np.float32(100)}, HEIGHTS <= 101.0),
        (array(missing_value=np.array([101.0, 103.0], np.float32)), {}, np.isin(HEIGHTS, [101.0, 103.0])),
        (array(valid_min=np.float32(103)), {}, HEIGHTS < 103.0),
        (array(valid_max=np.float32(390)), {}, HEIGHTS > 390.0),
        (array(valid_min="none"), {}, HEIGHTS < 0.0),
    ],
)
def test_every_nodata_value_is_one(tmp_path, content, encoding, is_none):
    found = heights_of(tmp_path / "dsm.nc", content, **encoding)
    assert np.array_equal(found, np.where(is_none, np.nan, HEIGHTS), equal_nan=True)


def test_rows_from_south_to_north_are_read_as_such(tmp_path):
    assert np.array_equal(heights_of(tmp_path / "dsm.nc", array(y=Y[::-1])), HEIGHTS[::-1])
