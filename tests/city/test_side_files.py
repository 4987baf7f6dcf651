"""Damaged texts and masks of rasters are refused: GDAL reads 0 for what is no number, and ignores files without an end."""

import re

import numpy as np
import pytest
from raster_cases import write_tif

pytest.importorskip("rasterio")

import rasterio

from warpsample.city.rasters.sources.reading import reader_of

ALL = slice(None)
HEIGHTS = 100.0 + np.arange(12, dtype=np.float32).reshape(3, 4)
PAM = '<PAMDataset><PAMRasterBand band="1">{}</PAMRasterBand></PAMDataset>'
VRT = """<VRTDataset rasterXSize="4" rasterYSize="3"><SRS>EPSG:3794</SRS><GeoTransform>5e5, 2, 0, 5e6, 0, -2</GeoTransform>
<VRTRasterBand dataType="Float32" band="1">{}</VRTRasterBand></VRTDataset>"""
SOURCE = """<ComplexSource><SourceFilename relativeToVRT="1">dsm.tif</SourceFilename><SourceBand>1</SourceBand>{}
</ComplexSource>"""


@pytest.fixture
def dsm(tmp_path):
    return write_tif(tmp_path / "dsm.tif", HEIGHTS)


def heights_of(path):
    return reader_of(str(path)).read(ALL, ALL)


@pytest.mark.parametrize("suffix", [".aux.xml", ".AUX.XML"])
@pytest.mark.parametrize(
    ("text", "got"),
    [
        (PAM.format("<NoDataValue>none</NoDataValue>"), "with the NoDataValue 'none', want a number"),
        (PAM.format("<NoDataValue>-nan</NoDataValue>"), "with the NoDataValue '-nan', want a number"),
        (PAM.format("<NoDataValue>5,5</NoDataValue>"), "with the NoDataValue '5,5'"),
        (PAM.format("<Scale>1,5</Scale>"), "with the Scale '1,5'"),
        (PAM.format("<Offset>x</Offset>"), "with the Offset 'x'"),
        (PAM.format("<Scale>1.5</Scale>")[:-20], "next to dsm.tif{}, which is damaged"),
        ("", "next to dsm.tif{}, which is damaged"),
    ],
)
def test_a_damaged_text_next_to_a_raster_is_refused(dsm, suffix, text, got):
    dsm.with_name(f"dsm.tif{suffix}").write_text(text)
    with pytest.raises(ValueError, match="^source: got .*" + re.escape(got.format(suffix))):
        heights_of(dsm)


def test_an_undamaged_text_next_to_a_raster_counts(dsm):
    text = PAM.format("<Description>höhe</Description><NoDataValue> 105 </NoDataValue><Scale>0.5</Scale>")
    dsm.with_name("dsm.tif.aux.xml").write_text(text, "latin-1")
    assert np.array_equal(heights_of(dsm), np.where(HEIGHTS == 105.0, np.nan, 0.5 * HEIGHTS), equal_nan=True)


@pytest.mark.parametrize(
    "element",
    ["<NoDataValue>105</NoDataValue>", "<Scale>0.5</Scale>", "<Offset>2</Offset>", "<UnitType>ft</UnitType>"],
)
def test_numbers_that_gdal_does_not_read_are_refused(dsm, element):
    """GDAL ignores an .aux.xml that begins with a declaration."""
    text = dsm.with_name("dsm.tif.aux.xml")
    text.write_text(f'<?xml version="1.0"?>{PAM.format(element)}')
    with pytest.raises(
        ValueError, match=f"^source: got .* next to dsm.tif.aux.xml, whose {element[1:6]}.* GDAL does not read"
    ):
        heights_of(dsm)
    text.write_text('<?xml version="1.0"?>' + PAM.format("<Scale>1</Scale><Offset>0.0</Offset><UnitType/>"))
    assert np.array_equal(heights_of(dsm), HEIGHTS)


@pytest.mark.parametrize("element", ["<NoDataValue>7</NoDataValue>", "<Scale>0.1</Scale>", "<UnitType>ft</UnitType>"])
def test_so_are_those_that_count_before_the_values_of_a_geotiff(tmp_path, element):
    """The values of the file itself were used, which the .aux.xml corrects: heights of 29 m for 29 feet."""
    path = write_tif(tmp_path / "dsm.tif", HEIGHTS, nodata=-9999.0)
    with rasterio.open(path, "r+") as file:
        file.scales, file.units = (0.5,), ("m",)
    text = tmp_path / "dsm.tif.aux.xml"
    text.write_text('<?xml version="1.0"?>' + PAM.format(element))
    for address in (path, f"file://{path}", f"file:{path}"):
        with pytest.raises(ValueError, match=f"^source: got .*, whose {element[1:6]}.* GDAL does not read"):
            heights_of(address)
    own = "<NoDataValue>-9999</NoDataValue><Scale>0.5</Scale><UnitType> m </UnitType>"
    text.write_text('<?xml version="1.0"?>' + PAM.format(own))
    assert np.array_equal(heights_of(path), 0.5 * HEIGHTS)


@pytest.mark.parametrize("share", [0.0, 0.05, 0.3, 0.9])
def test_a_damaged_mask_is_refused(tmp_path, share):
    """GDAL ignored it, so that masked cells had heights."""
    masked = np.full((3, 4), 255, np.uint8)
    masked[1] = 0
    with rasterio.Env(GDAL_TIFF_INTERNAL_MASK=False):
        path = write_tif(tmp_path / "dsm.tif", HEIGHTS, mask=masked)
    assert np.array_equal(np.isnan(heights_of(path)), masked == 0)
    mask = tmp_path / "dsm.tif.msk"
    mask.write_bytes(mask.read_bytes()[: int(share * mask.stat().st_size)])
    with pytest.raises(
        ValueError, match=r"^source: got '.*dsm\.tif'(, which cannot be read| next to dsm\.tif\.msk, whose mask)"
    ):
        heights_of(path)


@pytest.mark.parametrize(
    ("band", "got"),
    [
        ("<Scale>1,5</Scale>" + SOURCE.format(""), "with the Scale '1,5', want a number"),
        (SOURCE.format("<ScaleRatio>abc</ScaleRatio>"), "with the ScaleRatio 'abc'"),
        (SOURCE.format("<ScaleOffset>1,5</ScaleOffset>"), "with the ScaleOffset '1,5'"),
        (SOURCE.format("<NODATA>abc</NODATA>"), "with the NODATA 'abc'"),
        (SOURCE.format("<LUT>0:0,1000:abc</LUT>"), "with the LUT '0:0,1000:abc'"),
    ],
)
def test_a_virtual_raster_with_a_typing_error_is_refused(dsm, band, got):
    path = dsm.with_name("dsm.vrt")
    path.write_text(VRT.format(SOURCE.format("<LUT>0:0, 1000:2e3</LUT><NODATA>nan</NODATA>")))
    assert np.allclose(heights_of(path), 2.0 * HEIGHTS)
    path.write_text(VRT.format(band))
    with pytest.raises(ValueError, match=f"^source: got '.*dsm.vrt' {got}"):
        heights_of(path)
    of_it = dsm.with_name("of_it.vrt")
    of_it.write_text(VRT.format(SOURCE.format("")).replace("dsm.tif", "dsm.vrt"))
    with pytest.raises(ValueError, match=f"^source: got '.*dsm.vrt' {got}"):
        heights_of(of_it)


def test_the_height_unit_in_a_prj_counts_where_gdal_reads_it(dsm):
    """The .prj of another file next to a GeoTIFF did, and an upper-case .PRJ of an .asc did not."""
    text = 'Projection UTM\nZone 33\nDatum WGS84\nUnits METERS\n Zunits "FEET"\nXshift 0.0\nParameters\n'
    dsm.with_suffix(".prj").write_text(text)
    assert np.array_equal(heights_of(dsm), HEIGHTS)
    grid = dsm.with_name("grid.asc")
    grid.write_text("ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n100 10\n")
    grid.with_suffix(".PRJ").write_text(text)
    assert np.allclose(heights_of(grid), [[30.48, 3.048]])
