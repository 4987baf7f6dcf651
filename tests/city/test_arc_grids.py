"""Damaged Arc ASCII grids (.asc) are refused, and every spelling of a number in them is read."""

import numpy as np
import pytest

pytest.importorskip("rasterio")

import warpsample as ws
from warpsample.city.rasters.sources import arc_grid


@pytest.mark.parametrize(
    ("text", "got"),
    [
        ("1 2 3\n4 5\n", "with 5 heights, want 6, 2 rows of 3"),
        ("1 2 3\n4 5 6 7\n", "with 7 heights, want 6"),
        ("1 2 3\n4 x 6\n", "with 'x' among its heights, want numbers"),
        ("1 2 3\n4 5 6-7\n", "with '6-7' among"),
        ("1 2 3\n4 5 6e\n", "with '6e' among"),
        ("1 2 3\n4 \x115 6\n", r"with '\\x115' among"),
        ("1 2 3\n4\x1a5 6\n", r"with '4\\x1a5' among"),
        ("1 2 3\n4 nan 6\n", "with 'nan' among its heights, want integers below 2\\^31, as the others are, and -9999"),
        ("1 2 3\n4 4294967295 6\n", "with '4294967295' among its heights, want integers below 2"),
        ("1 2 3\n4 inf 6\n", "with 'inf' among its heights, want integers"),
        ("1 2 3\n4 <NA> 6\n", "with '<NA>' among"),
        *(
            (f"1 2 3\n4 {text} 6\n", f"with '{text}' among")
            for text in ("NA", "-nan", "1,234.5", "1.2.3", "1e2.5", "n", "D5", "5.nan", ".", "1,234,567")
        ),
    ],
)
def test_a_damaged_arc_grid_is_refused(tmp_path, text, got):
    """GDAL reads 0 in place of what is missing or no number."""
    path = tmp_path / "dsm.asc"
    path.write_text("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n" + text)
    with pytest.raises(ValueError, match=f"^source: got '.*dsm.asc' {got}.*the file is damaged$"):
        ws.rasters.surface(path)


@pytest.mark.parametrize(
    ("line", "want"),
    [
        *(
            (f"NODATA_value {text}", "want a number")
            for text in ("-nan", "1.#IND", "none", "NA", "n/a", "-99x", "null", "1d3", "0x10", "-1_0")
        ),
        ("cellsize -1", "want a length above 0"),
        ("cellsize 1x", "want a number"),
        ("xllcorner 5x", "want a number"),
        ("dy 0", "want a length above 0"),
    ],
)
def test_a_value_of_an_arc_header_that_is_no_number_is_refused(tmp_path, line, want):
    """GDAL reads 0 or the first digits, so that level ground became cells without data."""
    lines = {"ncols": "ncols 3", "nrows": "nrows 2", "xllcorner": "xllcorner 0", "yllcorner": "yllcorner 0"}
    lines |= {"dx": "dx 1", "dy": "dy 1"} if line[0] == "d" else {"cellsize": "cellsize 1"}
    name, value = line.split()
    path = tmp_path / "dsm.asc"
    path.write_text("\n".join([*(lines | {name: line}).values(), "1 2 3", "4 5 6", ""]))
    with pytest.raises(ValueError, match=f"^source: got '.*dsm.asc' with {name} '{value}', {want}$"):
        ws.rasters.surface(path)


@pytest.mark.parametrize("place", ["xllcorner 9", "xllcorner 9\nyllcenter 9", "xllcorner 9\nyllcorner 9\nxllcorner 8"])
def test_an_arc_header_without_one_place_is_refused(tmp_path, place):
    """GDAL puts such a raster at (0, 0), or takes the first of two places."""
    path = tmp_path / "dsm.asc"
    path.write_text("\n".join(["ncols 3", "nrows 1", *place.splitlines(), "cellsize 1", "1 2 3", ""]))
    with pytest.raises(ValueError, match="^source: got '.*dsm.asc' with ncols, .* in its header, want xllcorner"):
        ws.rasters.surface(path)


@pytest.mark.parametrize(
    ("lines", "got"),
    [
        ("NODATA_value nan\nnan\n2\n3", "with 'nan' alone in the first line of heights, which GDAL takes for the header"),
        ("  dx 1\n1\n2\n3", "with 'dx' among its heights"),
        ("nodata_value\n-9\n1\n2\n3", "with 'nodata_value' alone in the first line"),
    ],
)
def test_an_arc_header_that_gdal_divides_otherwise_is_refused(tmp_path, lines, got):
    """Heights moved by a cell, or words of the header were heights."""
    path = tmp_path / "dsm.asc"
    path.write_text(f"ncols 1\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n{lines}\n")
    with pytest.raises(ValueError, match=f"^source: got '.*dsm.asc' {got}"):
        ws.rasters.surface(path)


@pytest.mark.parametrize("text", ["-9999", "7", "7,0", "+7.", "0.7e1", "nan", "1.#QNAN"])
def test_a_number_is_a_nodata_value_of_an_arc_grid(tmp_path, text):
    """With a decimal comma, too, which GDAL reads in heights as well."""
    path, gone = tmp_path / "dsm.asc", "7" if "7" in text else text
    path.write_text(f"ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1,0\nNODATA_value {text}\n0 {gone} 2,5\n")
    with pytest.warns(UserWarning, match="without a CRS"):
        heights = ws.rasters.surface(path, model="block").grid.height
    assert np.array_equal(heights, [[0.0, np.nan, 2.5]], equal_nan=True)


@pytest.mark.parametrize("chunk", [7, 1 << 24])
def test_every_spelling_of_a_number_in_an_arc_grid_is_one(tmp_path, monkeypatch, chunk):
    """Without a value for no data, with all sorts of spaces, and in chunks that end within numbers."""
    monkeypatch.setattr(arc_grid, "_CHUNK", chunk)
    path = tmp_path / "dsm.asc"
    header = b"NCOLS 4\r\nnrows 2\r\nXLLCENTER 0\r\nyllcenter 0\r\ncellsize 1\r\n"
    path.write_bytes(header + b" 1.5\t-2 +3e0 .5\n\n5E-1 6. nan\n-7.0e+01")
    with pytest.warns(UserWarning, match="without a CRS"):
        heights = ws.rasters.surface(path, model="block").grid.height
    assert np.allclose(heights, [[1.5, -2.0, 3.0, 0.5], [0.5, 6.0, np.nan, -70.0]], equal_nan=True)
