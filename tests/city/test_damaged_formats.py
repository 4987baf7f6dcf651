"""A raster file without its end is refused, warned of by its format, or read rightly: GDAL reads some as heights of 0."""

import warnings

import numpy as np
import pytest
from raster_cases import SLOVENIA, write_tif

pytest.importorskip("rasterio")

import rasterio
import rasterio.shutil
from rasterio._err import CPLE_BaseError

from warpsample.city.rasters.sources import reading

ALL = slice(None)
HEIGHTS = {kind: (np.random.default_rng(0).random((40, 50)) * 50 + 100).astype(kind) for kind in ("float32", "int16")}
SUFFIXES = {"AAIGrid": "asc", "EHdr": "bil", "ENVI": "img", "HFA": "img", "XYZ": "xyz", "PCRaster": "map", "netCDF": "nc"}
SUFFIXES |= {"GSAG": "grd", "ERS": "ers", "JP2OpenJPEG": "jp2", "ROI_PAC": "dem", "ISCE": "isce", "HF2": "hf2"}
WARNED = "format; where parts of it are missing or damaged, GDAL may read heights of 0"


def written(folder, driver, kind="float32", **options):
    """A raster in a format of GDAL, or None if GDAL cannot write this kind of numbers in it."""
    source = write_tif(folder / "source.tif", HEIGHTS[kind], transform=SLOVENIA)
    path = folder / f"dsm.{SUFFIXES.get(driver, driver.lower())}"
    try:
        rasterio.shutil.copy(source, path, driver=driver, **options)
    except (rasterio.errors.RasterioError, CPLE_BaseError):
        return None
    return path if path.is_file() else None


def outcome(path):
    """How a raster is read: its heights, or the message of an error; and whether its format is warned of."""
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        try:
            found = reading.reader_of(str(path)).read(ALL, ALL)
        except ValueError as error:
            found = str(error)
    return found, any(WARNED in str(one.message) for one in heard)


def is_right(found, heights, driver):
    """Whether heights were read as written, or at no cell at all."""
    error = {"JP2OpenJPEG": 4.0, "HF2": 0.0101, "SIGDEM": 1e-5, "GRIB": 1e-3}.get(driver, 0.0)  # of lossy formats
    return found.shape == heights.shape and bool(np.all((np.abs(found - heights) <= error) | np.isnan(found)))


def silent_formats(folder, kind):
    """The formats that GDAL can write, and those of them whose damaged files are read wrong without a warning."""
    with rasterio.Env() as environment:
        drivers = sorted(environment.drivers())
    tested, silent = set(), set()
    for driver in drivers:
        place = folder / driver
        place.mkdir()
        path = written(place, driver, kind)
        if path is None or isinstance(outcome(path)[0], str):
            continue
        tested.add(driver)
        content = path.read_bytes()
        for share in (0.99, 0.9, 0.6, 0.3, 0.05):
            path.write_bytes(content[: int(share * len(content))])
            found, is_warned = outcome(path)
            if not (is_warned or isinstance(found, str) or is_right(found, HEIGHTS[kind], driver)):
                silent.add(driver)
    return tested, silent


@pytest.mark.parametrize("kind", HEIGHTS)
def test_no_format_without_its_end_gives_wrong_heights_without_a_word(tmp_path, kind):
    tested, silent = silent_formats(tmp_path, kind)
    assert tested >= {"GTiff", "AAIGrid", "ENVI", "EHdr", "HFA", "netCDF", "XYZ"}
    assert not silent


def test_without_the_checks_some_formats_do(tmp_path, monkeypatch):
    monkeypatch.setattr(reading, "check_undamaged", lambda *_: None)
    assert silent_formats(tmp_path, "float32")[1] >= {"ENVI", "EHdr", "GPKG"}


@pytest.mark.parametrize("address", ["{}", "vrt://{}"])
def test_files_of_a_virtual_raster_are_checked(tmp_path, address):
    path = written(tmp_path, "AAIGrid")
    path.write_text(path.read_text().replace("1", "x", 40))
    whole = write_tif(tmp_path / "whole.tif", HEIGHTS["float32"], transform=SLOVENIA)
    rasterio.shutil.copy(whole, tmp_path / "dsm.vrt", driver="VRT")
    virtual = tmp_path / "dsm.vrt"
    virtual.write_text(virtual.read_text().replace(whole.name, path.name))
    found, is_warned = outcome(address.format(virtual))
    assert found.startswith(f"source: got {str(path)!r} with ")
    assert not is_warned


def test_a_virtual_raster_of_plain_numbers_is_read(tmp_path):
    """Its band has the name of a file, and no source."""
    (tmp_path / "dsm.raw").write_bytes(HEIGHTS["float32"].astype("<f4").tobytes())
    band = '<VRTRasterBand dataType="Float32" band="1" subClass="VRTRawRasterBand">{}</VRTRasterBand>'
    file = '<SourceFilename relativeToVRT="1">dsm.raw</SourceFilename><ByteOrder>LSB</ByteOrder>'
    place = "<GeoTransform>5e5, 2, 0, 5e6, 0, -2</GeoTransform>"
    text = f'<VRTDataset rasterXSize="50" rasterYSize="40">{place}{band.format(file)}</VRTDataset>'
    (tmp_path / "dsm.vrt").write_text(text)
    found, is_warned = outcome(tmp_path / "dsm.vrt")
    assert np.array_equal(found, HEIGHTS["float32"])
    assert is_warned  # without its end, it has heights of 0


def test_parts_of_a_virtual_raster_are_warned_of_once(tmp_path):
    for number in range(3):
        (tmp_path / f"{number}").mkdir()
    parts = [written(tmp_path / f"{number}", driver) for number, driver in enumerate(("XYZ", "XYZ", "GSAG"))]
    rasterio.shutil.copy(parts[0], tmp_path / "dsm.vrt", driver="VRT")
    text = (tmp_path / "dsm.vrt").read_text()
    begin, end = text.index("<SimpleSource"), text.index("</SimpleSource>") + len("</SimpleSource>")
    sources = [text[begin:end].replace("0/dsm.xyz", f"{number}/{part.name}") for number, part in enumerate(parts)]
    (tmp_path / "dsm.vrt").write_text(text[:begin] + "".join(sources) + text[end:])
    with pytest.warns(UserWarning, match=r"^source: got '.*dsm.vrt' in GSAG, XYZ format; ") as heard:
        reading.reader_of(str(tmp_path / "dsm.vrt"))
    assert len([one for one in heard if WARNED in str(one.message)]) == 1


@pytest.mark.parametrize(
    ("driver", "options", "is_expected"),
    [
        ("XYZ", {}, True),
        ("GSAG", {}, True),
        *(("netCDF", {"FORMAT": name}, False) for name in ("NC", "NC2", "NC4", "NC4C")),
    ],
)
def test_formats_of_text_are_warned_of_and_netcdf_files_are_not(tmp_path, driver, options, is_expected):
    """GDAL reads a damaged number of these texts as 0."""
    found, is_warned = outcome(written(tmp_path, driver, **options))
    assert np.allclose(found, HEIGHTS["float32"])
    assert is_warned is is_expected


@pytest.mark.parametrize("options", [{}, {"BIGTIFF": "YES"}, {"ENDIANNESS": "BIG"}, {"BIGTIFF": "YES", "ENDIANNESS": "BIG"}])
def test_a_geotiff_without_the_values_of_its_tags_is_refused(tmp_path, options):
    """GDAL writes them last, and reads a file without them as one without scale, unit, nodata value or mask."""
    path, cut = write_tif(tmp_path / "dsm.tif", HEIGHTS["int16"], **options), tmp_path / "cut.tif"
    with rasterio.open(path, "r+") as file:
        file.scales, file.units, file.nodata = (0.25,), ("ft",), 105
    whole = path.read_bytes()
    assert np.isfinite(reading.reader_of(path).heights(slice(0, 40), slice(0, 50))).sum() < 2000
    for missing in (1, 10, 100, 200, 300, 500, 1000, 4000, len(whole) - 5):
        cut.write_bytes(whole[: len(whole) - missing])
        with pytest.raises(ValueError, match="whose end is missing; copy or download it again|cannot be read as a raster"):
            reading.reader_of(cut)
    for address in (
        f"file://{cut}",
        f"FILE://{cut}",
        f"file:{cut}",
        f"GTIFF_DIR:1:{cut}",
        f"gtiff_dir:+1:{cut}",
        f"GTIFF_RAW:{cut}",
    ):
        cut.write_bytes(whole[:-10])
        with pytest.raises(ValueError, match="whose end is missing; copy or download it again"):
            reading.reader_of(address)


def test_a_geotiff_with_a_damaged_crs_is_refused_in_a_sentence(tmp_path):
    """The error was GDAL's own, with a traceback."""
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS["float32"].astype(float), crs="EPSG:32633")
    with rasterio.open(path, "r+") as file:
        file.nodata = 777.125
    content = path.read_bytes()
    damaged = 0
    for missing in range(200, 240):
        path.write_bytes(content[:-missing] + bytes(missing))  # as of a download that reserves its space
        try:
            reading.reader_of(path)
        except ValueError as error:
            damaged += "which cannot be read as a raster" in str(error)
    assert damaged


def test_an_arc_grid_is_read_by_its_address(tmp_path):
    path = tmp_path / "dsm.asc"
    path.write_text("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n")
    found = reading.reader_of(f"file://{path}").heights(slice(0, 2), slice(0, 2))
    assert np.array_equal(found, [[1.0, 2.0], [3.0, 4.0]])
