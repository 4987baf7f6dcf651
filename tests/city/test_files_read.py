"""Every file that a raster is read from is an input, also one that only an address of GDAL names."""

import json
import sqlite3
from contextlib import closing
from xml.sax.saxutils import escape

import numpy as np
import pytest
from raster_cases import write_tif

pytest.importorskip("rasterio")

import rasterio

from warpsample.city.rasters.sources import inputs
from warpsample.city.rasters.sources.inputs import files_read

VRT = """<VRTDataset rasterXSize="4" rasterYSize="3"><GeoTransform>5e5, 2, 0, 5e6, 0, -2</GeoTransform>
<VRTRasterBand dataType="Float32" band="1"><SimpleSource>
<SourceFilename relativeToVRT="0">{}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>
</VRTRasterBand></VRTDataset>"""

NAMES = "d.tif", "é.tif", "my dsm, 1.tif", "d(1).tif", "d[1]{2}.tif", "a=b;c:d|e&f.tif", "d'1.tif", "(1).tif", "5.0.tif"


@pytest.mark.parametrize("is_relative", [True, False])
@pytest.mark.parametrize("address", ["{}", "vrt://{}?bands=1", "GTIFF_DIR:1:{}", "GTIFF_RAW:{}", "/vsisubfile/0,{}"])
@pytest.mark.parametrize("name", NAMES)
def test_a_file_in_an_address_is_found(tmp_path, monkeypatch, name, address, is_relative):
    """Relative names after :// and names with spaces or punctuation were not found."""
    monkeypatch.chdir(tmp_path)
    write_tif(tmp_path / name, np.ones((3, 4)))
    address = address.format(name if is_relative else tmp_path / name)
    (tmp_path / "dsm.vrt").write_text(VRT.format(escape(address)), "utf-8")
    with rasterio.open("dsm.vrt") as file:
        assert file.read(1).all()  # GDAL finds it
    for path in (str(tmp_path / "dsm.vrt"), address):
        assert tmp_path / name in {one.absolute() for one in files_read(path)}


@pytest.mark.parametrize("name", ["dsm.tif", "dsm é.tif", "sub/dsm.tif"])
def test_a_tile_of_an_index_is_found(tmp_path, monkeypatch, name):
    """Indexes in a GeoPackage and in a shapefile are binary, and JSON escapes letters and strokes."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sub").mkdir()
    write_tif(tmp_path / name, np.ones((3, 4)))
    (tmp_path / "a.geojson").write_text(json.dumps({"location": name}).replace("/", r"\/"))
    with closing(sqlite3.connect("b.gti.gpkg")) as index, index:
        index.execute("CREATE TABLE tiles (number INTEGER, location TEXT)")
        index.execute("INSERT INTO tiles VALUES (1, ?)", (name,))
    (tmp_path / "c.shp").write_bytes(b"\0\0\x27\x0a")
    columns = [name.encode(), b"EPSG:3794"]  # as wide as the longest text
    widths = b"".join(
        f"COLUMN{k}".encode().ljust(16, b"\0") + bytes([len(text)]).ljust(16, b"\0") for k, text in enumerate(columns)
    )
    sizes = (32 + len(widths) + 1).to_bytes(2, "little") + (1 + len(b"".join(columns))).to_bytes(2, "little")
    (tmp_path / "c.dbf").write_bytes((b"\x03\0\0\0\1\0\0\0" + sizes).ljust(32, b"\0") + widths + b"\r " + b"".join(columns))
    for index in ("GTI:a.geojson", "GTI:b.gti.gpkg", "b.gti.gpkg", "GTI:c.shp"):
        assert tmp_path / name in {one.absolute() for one in files_read(index)}
    assert len(list(tmp_path.glob("b.*"))) == 1


def test_a_name_in_a_long_command_is_found(tmp_path, monkeypatch):
    """Texts with more than 32 places where a name may begin were passed over."""
    monkeypatch.chdir(tmp_path)
    write_tif(tmp_path / "t 0.tif", np.ones((3, 4)))
    command = (
        "gdal raster pipeline ! read t 0.tif ! reproject -d EPSG:3794 " + "! scale --src-min 0 --src-max 9 " * 9 + "! write"
    )
    (tmp_path / "dsm.gdalg.json").write_text(json.dumps({"type": "gdal_streamed_alg", "command_line": command}))
    assert tmp_path / "t 0.tif" in {one.absolute() for one in files_read("dsm.gdalg.json")}


def test_an_archive_and_a_link_to_it_are_inputs(tmp_path):
    archive = tmp_path / "dsm.zip"
    archive.write_bytes(b"PK")
    assert archive in files_read(f"/vsizip/{archive}/sub/dsm.tif")


def test_heights_and_places_in_a_text_are_no_names(tmp_path, monkeypatch):
    """Each part of such a line was looked for on the disk, which took minutes."""
    looked, is_file = [], inputs.Path.is_file
    monkeypatch.setattr(inputs.Path, "is_file", lambda self: looked.append(self) or is_file(self))
    (tmp_path / "dsm.asc").write_text("1.5 2e3 -7\n" * 1000)
    place = {"coordinates": [[[5e5 + k, 5e6] for k in range(9)]]}
    (tmp_path / "index.geojson").write_text(json.dumps([{"geometry": place, "location": f"{k}.tif"} for k in range(9000)]))
    (tmp_path / "8999.tif").write_bytes(b"\0")
    assert tmp_path / "8999.tif" in files_read(f"GTI:{tmp_path}/index.geojson")  # behind the first million bytes
    assert len(looked) < 20_000
    looked.clear()
    files_read(str(tmp_path / "dsm.asc"))
    assert len(looked) < 20
