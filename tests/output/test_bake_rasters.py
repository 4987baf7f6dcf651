"""`bake` of rasters into files: a GeoTIFF without Dask, a picture, a report, and what `info` prints."""

import os
import subprocess
import sys
from importlib import import_module
from io import BytesIO
from pathlib import Path
from types import SimpleNamespace

import city_files
import numpy as np
import pytest
from affine import Affine
from matplotlib.image import imread

import warpsample as ws
from warpsample.output.bake_table import RASTER, kind_of

rasterio = pytest.importorskip("rasterio")
raster_cases = pytest.importorskip("raster_cases")
tile_files = import_module("warpsample.output.rasters.tile_files")


@pytest.fixture
def dsm(tmp_path, monkeypatch):
    """A tower of 4 x 4 cells on level ground, and a cell without data."""
    heights = np.zeros((24, 30), np.float32)
    heights[10:14, 10:14] = 12.0
    heights[0, 0] = np.nan
    monkeypatch.chdir(tmp_path)
    return raster_cases.write_tif(tmp_path / "dsm.tif", heights)


def test_a_working_folder_that_was_removed_is_told(dsm, call, tmp_path, monkeypatch):
    """Python's words named neither a file nor an argument."""
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    status, _, err = call("bake", dsm, "-o", "sky.tif", "--quantity", "sky", "--samples", "16")
    assert (status, err.startswith("error: the working folder no longer exists")) == (2, True)


@pytest.mark.thorough
def test_a_geotiff_needs_no_dask(dsm, call, child_environment):
    hidden = "import sys; sys.modules.update(dict.fromkeys(('dask', 'distributed', 'zarr')))\n"
    script = hidden + "from warpsample.cli import main; sys.argv[0] = 'warpsample'; main()"
    given = ["bake", "dsm.tif", "-o", "alone.tif", "--quantity", "sky", "--samples", "16", "--tile", "12"]
    command = [sys.executable, "-c", script, *given]
    done = subprocess.run(command, check=False, env=child_environment, capture_output=True, text=True)
    assert (done.returncode, done.stdout[:12]) == (0, "alone.tif: s"), done.stderr
    assert call(*(name.replace("alone", "other") for name in given), "--processes", 2)[0] == 0
    assert dsm.with_name("alone.tif").read_bytes() == dsm.with_name("other.tif").read_bytes()


@pytest.mark.slow
def test_a_picture_and_a_report_show_the_cells(dsm, call, can_render):
    given = ("bake", "dsm.tif", "--quantity", "sky", "--samples", "64", "--report", "r.html")
    status, out, err = call(*given, "-o", "sky.png")
    assert (status, err) == (0, "")
    assert "sky view factor of 24 x 30 cells in 1 tile" in out
    pixels = imread(BytesIO(dsm.with_name("sky.png").read_bytes()))[..., :3]
    assert np.count_nonzero(np.ptp(pixels, axis=-1) > 0.2) > 20_000
    page = dsm.with_name("r.html").read_text()
    assert "<td>without a number: " not in page.replace("<td>without a number: ", "", 1)  # the only cell without data
    for text in ("<td>points</td><td>720</td>", "median", "<td>samples</td><td>64</td>", "data:image/png;base64,"):
        assert text in page
    assert sorted(path.name for path in dsm.parent.iterdir()) == ["dsm.tif", "r.html", "sky.png"]
    assert call(*given, "-o", "sky.tif")[0] == 0
    with rasterio.open("sky.tif") as file:
        value = file.read(1).astype(float)
    assert f"mean {np.nanmean(value):.4f}, from {np.nanmin(value):.4g} to {np.nanmax(value):.4g}; standard error" in out


@pytest.mark.parametrize("more", [("-o", "sky.png"), ("-o", "sky.tif", "--report", "r.html")])
def test_a_map_of_a_place_that_is_not_on_earth_is_refused_before_the_first_tile(dsm, call, more, can_render):
    """The error came after the last tile, and the folder of the tiles blocked the next run."""
    with rasterio.open(dsm, "r+") as file:
        file.transform = Affine(1.0, 0.0, 1e9, 0.0, -1.0, 1e9)
        file.crs = "EPSG:32633"
    status, _, err = call("bake", "dsm.tif", "--quantity", "sky", "--samples", 4, *more)
    assert (status, "which is not on Earth in WGS 84 / UTM zone 33N" in err) == (2, True)
    assert [path.name for path in dsm.parent.iterdir()] == ["dsm.tif"]


@pytest.mark.parametrize("output", ["sky.tif", "sky.zarr"])
def test_a_raster_that_is_too_large_for_one_piece_leaves_no_folder(dsm, call, monkeypatch, output):
    """The folder blocked the run in tiles that the error advises, with and without --resume."""
    pytest.importorskip("zarr")
    monkeypatch.setattr(import_module("warpsample.city.rasters.sources.reader"), "_MOST_CELLS", 500)
    given = ("bake", "dsm.tif", "-o", output, "--quantity", "sky", "--samples", 16)
    status, _, err = call(*given)
    assert (status, "24 x 30 cells, want 1 to 500; split the raster into tiles" in err) == (2, True)
    assert [path.name for path in dsm.parent.iterdir()] == ["dsm.tif"]
    assert call(*given, "--tile", 8, "--margin", 4)[0] == 0


def test_a_tile_that_is_too_large_is_refused_before_any_is_computed(dsm, call, monkeypatch):
    """The tile between two others has margins on both sides; those at the corners, 17 x 17 cells, are small enough."""
    monkeypatch.setattr(import_module("warpsample.city.rasters.sources.reader"), "_MOST_CELLS", 300)
    given = ("bake", "dsm.tif", "-o", "sky.tif", "--quantity", "sky", "--samples", 16, "--margin", 4)
    status, _, err = call(*given, "--tile", 12)
    assert (status, "17 x 22 cells, want 1 to 300; take smaller tiles or margins" in err) == (2, True)
    assert [path.name for path in dsm.parent.iterdir()] == ["dsm.tif"]
    assert call(*given, "--tile", 4)[0] == 0
    status, _, err = call(*given, "--tile", 4, "--margin", 10**9)
    assert (status, "--margin: got 1000000000, want a whole number from 1 to 65536" in err) == (2, True)
    (dsm.parent / "sky.tif").unlink()
    status, _, err = call(*given, "--tile", 4, "--margin", 65536, "--far", "dsm.tif")
    assert (status, "cells of a margin of 65,536 cells with far terrain need" in err) == (2, True)
    assert [path.name for path in dsm.parent.iterdir()] == ["dsm.tif"]


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have no such names")
def test_a_tif_whose_folder_is_not_in_utf8_is_refused_before_it_is_computed(dsm, call):
    """GDAL cannot write it: all tiles were computed first."""
    folder = dsm.parent / "caf\udce9"
    folder.mkdir()
    status, _, err = call("bake", "dsm.tif", "-o", folder / "sky.tif", "--quantity", "sky", "--samples", 16)
    assert (status, "whose name or folder is not in UTF-8, as GDAL needs" in err, list(folder.iterdir())) == (2, True, [])


def test_info_describes_rasters_cities_and_parts(dsm, call, monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")
    status, out, err = call("info", "dsm.tif")
    assert (status, err) == (0, "")
    rows = {cells[1].strip(): cells[2].strip() for line in out.splitlines() if len(cells := line.split("│")) == 5}
    assert (rows["cells"], rows["heights from, to"], rows["cells without data"]) == ("24 x 30", "0, 12", "1")
    assert "Slovene" in rows["reference system"]
    city_files.written(dsm.with_name("a.city.json"), city_files.house())
    out = call("info", "a.city.json")[1]
    assert all(text in out for text in ("type RoofSurface", "surfaces, 96 m2", "surfaces, 240 m2"))
    lines = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "o a[/b]", "f 1 2 3", "o rest", "f 1 3 2"]
    dsm.with_name("parts.obj").write_text("\n".join(lines))
    out = call("info", "parts.obj")[1]
    assert all(text in out for text in ("named parts", "part a[/b]", "part rest", "faces, 0.5 square units"))


@pytest.mark.parametrize("model", ["joined", "block", "tin"])
def test_each_model_is_computed(dsm, call, model):
    """The trial of the options was on one cell, of which the model "tin" makes no triangle."""
    raster_cases.write_tif("crowns.tif", np.eye(24, 30, dtype=np.float32))
    given = ("--quantity", "sky", "--samples", "4", "--receiver", "surface", "--tile", "24", "--canopy", "crowns.tif")
    status, _, err = call("bake", "dsm.tif", "-o", "sky.tif", "--model", model, "--far", "dsm.tif", *given)
    assert (status, err) == (0, "")
    with rasterio.open("sky.tif") as file:
        assert np.isnan(file.read(1)).sum() == 1


@pytest.mark.slow
def test_crowns_transmit_another_fraction_in_each_month(dsm, call):
    """A message named 12 fractions, which the command could not take."""
    pytest.importorskip("pvlib")
    crowns = raster_cases.write_tif("crowns.tif", 6.0 * np.eye(24, 30, dtype=np.float32))
    months = [month / 20 for month in range(12)]
    given = ("bake", "dsm.tif", "-o", "sun.tif", "--quantity", "sun-hours", "--weather", "athens", "--canopy", crowns)
    assert call(*given, "--transmittance", ",".join(map(str, months)))[0] == 0
    right = ws.rasters.sun_hours("dsm.tif", "athens", canopy=crowns, transmittance=months).value
    with rasterio.open("sun.tif") as file:
        assert np.array_equal(file.read(1), right.astype(np.float32), equal_nan=True)
        tag = file.tags()["transmittance"]
    assert tag == " ".join(map(str, months))
    assert call(*given, "-o", "again.tif", "--transmittance", tag)[0] == 0  # as the tag and the error of --resume name them
    with rasterio.open("again.tif") as file:
        assert np.array_equal(file.read(1), right.astype(np.float32), equal_nan=True)
    refused = {"0.5,0.2": (0.5, 0.2), "0.5 0.2": (0.5, 0.2), " 0.5, 0.2 ": (0.5, 0.2), "0.5,,0.2": "0.5,,0.2"}
    for text, value in (refused | {"-1": -1.0, "my 5 leaves.npy": "my 5 leaves.npy", "": ""}).items():
        status, _, said = call(*given, "--transmittance", text)
        assert (status, said.split(", want")[0]) == (2, f"error: --transmittance: got {value!r}")


@pytest.mark.skipif(tile_files.fcntl is None, reason="Windows does not lock folders")
def test_of_two_runs_that_start_together_one_keeps_its_folder(tmp_path):
    first, second = (tile_files.TileFiles(tmp_path / "sky.tif", resume=False) for _ in range(2))
    with first.locked():
        with pytest.raises(tile_files.WriteError, match="another process is writing it"), second.locked():
            pass
        assert first.path.is_dir()
        (first.path / "tile-0.npz").write_bytes(b"")
        with pytest.raises(tile_files.WriteError, match="another process is writing it"), second.locked():
            pass
        first.remove()
        with second.locked():  # a run that starts when the output is complete
            pass
        first.path.mkdir()
    assert first.path.is_dir()  # the folder of yet another run


def test_a_run_that_is_killed_while_it_removes_its_folder_can_be_resumed(tmp_path, monkeypatch):
    """The attributes, which tell that the folder is ours, are removed last."""
    store = tile_files.TileFiles(tmp_path / "sky.tif", resume=True)
    (store.path / "cog").mkdir(parents=True)
    names = (tile_files.ABOUT, tile_files.DIGESTS, "tile-0.npz", "tile-1.npz", "cog/plain.tif")
    for name in names:
        (store.path / name).write_bytes(b"")
    unlink, left = os.unlink, 0

    def unlink_some(*arguments, **options):
        nonlocal left
        if left == 0:
            raise OSError("killed")
        left -= 1
        unlink(*arguments, **options)

    monkeypatch.setattr(os, "unlink", unlink_some)
    for _ in names:  # the first run removes nothing, and each later one a file
        with pytest.raises(OSError, match="killed"):
            store.remove()
        with store.locked():
            assert (store.path / tile_files.ABOUT).is_file()
        left = 1
    store.remove()
    assert not store.path.exists()


def test_exchanged_tiles_and_pipes_are_no_complete_tiles(dsm, tmp_path):
    """Exchanged tiles of one shape were taken, and a pipe was read for ever."""
    store = tile_files.TileFiles(tmp_path / "sky.tif", resume=True)
    store.path.mkdir()
    run = SimpleNamespace(grid=(2, 2), names=("value",), reader=SimpleNamespace(shape=(2, 2)))
    for index in range(3):
        tile_files.write_tile_file(store.path, index, run, {"value": np.full((1, 1), index, np.float32)})
    first, second = (tile_files.tile_file(store.path, index) for index in (0, 1))
    content = first.read_bytes()
    first.write_bytes(second.read_bytes())
    second.write_bytes(content)
    os.mkfifo(tile_files.tile_file(store.path, 3))
    assert store.begin(run, {}).tolist() == [False, False, True, False]


@pytest.mark.parametrize("content", [b"", b"[]", b'{"count'])
def test_a_folder_whose_attributes_are_damaged_is_named(tmp_path, content):
    """As a machine that lost its power may leave it: an empty file gave JSON's message alone, and [] a traceback."""
    store = tile_files.TileFiles(tmp_path / "sky.tif", resume=True)
    store.path.mkdir()
    (store.path / tile_files.ABOUT).write_bytes(content)
    match = r"^--output: got '.*\.sky\.tif\.tiles', whose about\.json is damaged"
    with store.locked(), pytest.raises(ValueError, match=match):
        store.about()


@pytest.mark.parametrize("resume", [False, True])
def test_a_file_in_the_place_of_the_tiles_is_kept(tmp_path, resume):
    store = tile_files.TileFiles(tmp_path / "sky.tif", resume)
    store.path.write_text("thesis")
    with (
        pytest.raises(ValueError, match=r"--output: got '.*\.sky\.tif\.tiles', which is a file, want another"),
        store.locked(),
    ):
        pass
    assert store.path.read_text() == "thesis"


@pytest.mark.parametrize("target", ["nowhere", "."])
def test_a_link_in_the_place_of_the_tiles_is_kept(tmp_path, target):
    """The tiles behind a link to a folder were computed, but could not be removed at the end."""
    store = tile_files.TileFiles(tmp_path / "sky.tif", resume=False)
    store.path.symlink_to(tmp_path / target)
    with pytest.raises(ValueError, match="which is a link, want another"), store.locked():
        pass
    assert store.path.is_symlink()


@pytest.mark.parametrize("suffix", [".nc", ".NC4", ".img", ".jp2", ".bil", ".asc", ".vrt"])
@pytest.mark.parametrize("output", ["sky.png", "sky.zarr", "sky.tif"])
def test_a_usual_raster_is_one_by_its_suffix(suffix, output):
    """Some were rasters only if the output was a .tif."""
    assert kind_of(Path(f"dsm{suffix}"), Path(output), None) == RASTER
