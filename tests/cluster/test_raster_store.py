"""Rasters baked by the command: tiles that are whole or absent, runs that go on, and GeoTIFFs that appear at the end."""

import json
import re
import resource
import signal
import subprocess
import sys
import time
from contextlib import contextmanager

import numpy as np
import pytest
from raster_cases import SLOVENIA

from warpsample import rasters
from warpsample.host.files import WriteError

pytest.importorskip("dask")
pytest.importorskip("zarr")
pytest.importorskip("rioxarray")

import rasterio
import xarray as xr
from raster_runs import RAYS, TILES, bake, baking, contents, tile_files

pytestmark = pytest.mark.slow  # seconds each


def test_a_store_has_the_numbers_of_the_call_on_the_map(dsm, folder):
    said = bake(dsm, folder / "sky.zarr")
    assert said.startswith(f"{folder / 'sky.zarr'}: sky view factor of 60 x 44 cells in {TILES} tiles")
    right = rasters.sky_view_factor(dsm, RAYS, tile=15, margin=6)
    with xr.open_zarr(folder / "sky.zarr", decode_coords="all") as found:
        for name in ("value", "standard_error", "half_width", "far_error"):
            assert np.array_equal(found[name], right[name], equal_nan=True), name
            assert found[name].dims == ("y", "x")
        assert np.array_equal(found.y, right.y)
        assert np.array_equal(found.x, right.x)
        assert found.rio.crs.to_epsg() == 3794
        assert found.rio.transform() == SLOVENIA
        assert found.attrs["definition"] == right.attrs["definition"]
        assert np.array_equal(rasters.interval(found).upper, rasters.interval(right).upper, equal_nan=True)
        assert (found.attrs["tile"], found.attrs["margin"], found.attrs["count"]) == (15, 6, RAYS)
        assert found.value.attrs["units"] == "1"
    assert [path.name for path in folder.iterdir()] == ["sky.zarr"]


def test_a_geotiff_has_bands_tags_and_the_layout(dsm, folder):
    bake(dsm, folder / "sky.tif")
    right = rasters.sky_view_factor(dsm, RAYS, tile=15, margin=6)
    with rasterio.open(folder / "sky.tif") as file:
        assert file.descriptions == ("value", "standard_error", "half_width", "far_error")
        for band, name in enumerate(file.descriptions, 1):
            assert np.array_equal(file.read(band), right[name], equal_nan=True), name
        assert (file.crs.to_epsg(), file.transform) == (3794, SLOVENIA)
        assert np.isnan(file.nodata)
        assert file.tags(ns="IMAGE_STRUCTURE")["LAYOUT"] == "COG"
        assert file.tags()["definition"] == right.attrs["definition"]
    assert [path.name for path in folder.iterdir()] == ["sky.tif"]
    bake(dsm, folder / "whole.tif", tile=None, margin=None)
    with rasterio.open(folder / "whole.tif") as file:
        assert file.descriptions == ("value", "standard_error", "half_width")


def test_a_sidecar_that_cannot_be_removed_keeps_the_old_file(dsm, folder):
    """It was removed after the old file was replaced, so that its error came too late."""
    (folder / "sky.tif").write_bytes(b"old")
    (folder / "sky.tif.ovr").mkdir()
    with pytest.raises(WriteError, match="sky.tif cannot be written"):
        bake(dsm, folder / "sky.tif")
    assert (folder / "sky.tif").read_bytes() == b"old"


@pytest.mark.filterwarnings("ignore:.*on which distances are")
def test_a_reference_system_that_no_geotiff_holds_is_refused(dsm, folder):
    """GDAL wrote it into a sidecar file, which was removed: the result had no place."""
    rasterio.shutil.copy(dsm, folder / "dsm.vrt", driver="VRT")
    text = re.sub("<SRS.*</SRS>", "<SRS>+proj=eqearth +lon_0=15</SRS>", (folder / "dsm.vrt").read_text(), flags=re.DOTALL)
    (folder / "dsm.vrt").write_text(text)
    with pytest.raises(ValueError, match="sky.tif', but a GeoTIFF cannot hold the CRS of the raster, unknown; write a"):
        bake(folder / "dsm.vrt", folder / "sky.tif")
    assert [path.name for path in folder.iterdir()] == ["dsm.vrt"]


def test_what_a_virtual_raster_refers_to_is_no_output(dsm, folder):
    before = dsm.read_bytes()
    rasterio.shutil.copy(dsm, folder / "dsm.vrt", driver="VRT")
    content = (folder / "dsm.vrt").read_text().replace(str(dsm), "dsm.vrt").replace('relativeToVRT="0"', 'relativeToVRT="1"')
    (folder / "of_vrt.vrt").write_text(content)  # a virtual raster of a virtual one: the raster below was replaced
    addresses = f"GTIFF_DIR:1:{dsm}", f"vrt://{dsm}?bands=1&amp;nogrid", f"/vsisubfile/0,{dsm}"  # so it was by these
    addresses += f"<![CDATA[vrt://{dsm}]]>", f"/vsizip/{{{dsm}}}/x.tif", f"/vsicached?file={dsm}"
    for number, address in enumerate(addresses):
        text = (folder / "dsm.vrt").read_text().replace(f">{dsm}<", f">{address}<")
        (folder / f"{number}.vrt").write_text(text)
    (folder / "tiles.geojson").write_text(json.dumps({"location": str(dsm)}))  # of an index, which names another index
    (folder / "s.gti").write_text("<GDALTileIndexDataset><IndexDataset>tiles.geojson</IndexDataset></GDALTileIndexDataset>")
    names = "dsm.vrt", "of_vrt.vrt", *(f"{number}.vrt" for number in range(len(addresses))), "s.gti", f"/vsisubfile/0,{dsm}"
    for name in names:
        with pytest.raises(ValueError, match="^--output: got .*dsm.tif', which is the input"):
            bake(folder / name, dsm)
        assert dsm.read_bytes() == before


def test_a_full_disk_keeps_the_tiles(dsm, folder):
    bake(dsm, folder / "right.tif")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, limits[1]))  # between a store's files and the GeoTIFF
        with pytest.raises(WriteError, match=r"sky.tif cannot be written: .*\.sky\.tif\.tiles can be resumed$"):
            bake(dsm, folder / "sky.tif")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert sorted(path.name for path in folder.iterdir()) == [".sky.tif.tiles", "right.tif"]
    assert f"{TILES} of the {TILES} tiles were complete before" in bake(dsm, folder / "sky.tif", resume=True)
    assert (folder / "sky.tif").read_bytes() == (folder / "right.tif").read_bytes()


@pytest.mark.parametrize("name", ["sky.zarr", "sky.tif"])
def test_an_interrupted_run_goes_on_to_the_same_bytes(dsm, folder, name, computed_tiles):
    ran, counted = computed_tiles
    bake(dsm, folder / f"right_{name}")
    assert ran == list(range(TILES))
    ran.clear()
    counted.most = 5
    store = folder / (name if name.endswith(".zarr") else f".{name}.tiles")
    with pytest.raises(KeyboardInterrupt, match=f"interrupted after 5 of {TILES} tiles; {store} can be resumed"):
        bake(dsm, folder / name)
    assert not (folder / "sky.tif").exists()
    counted.most = -1
    with pytest.raises(ValueError, match=r"which exists already, want a new name, or .*--resume\)? to continue the run"):
        bake(dsm, folder / name)
    said = bake(dsm, folder / name, resume=True)
    assert f"5 of the {TILES} tiles were complete before\n  for the other tiles: mean 0." in said
    assert ran == list(range(TILES))
    if name == "sky.tif":
        assert (folder / name).read_bytes() == (folder / f"right_{name}").read_bytes()
    else:
        assert contents(folder / name) == contents(folder / f"right_{name}")
    assert sorted(path.name for path in folder.iterdir()) == sorted([name, f"right_{name}"])


@pytest.mark.parametrize("late", [False, True])
def test_an_interrupt_while_processes_start_or_end_tells_what_is_there(dsm, folder, computed_tiles, monkeypatch, late):
    _, counted = computed_tiles
    counted.most = 5
    with pytest.raises(KeyboardInterrupt):
        bake(dsm, folder / "sky.zarr")
    counted.most = -1

    @contextmanager
    def interrupted(*_):
        if late:
            yield
        raise KeyboardInterrupt

    monkeypatch.setattr(baking, "computing", interrupted)
    with pytest.raises(KeyboardInterrupt, match=f"interrupted after {TILES if late else 5} of {TILES} tiles"):
        bake(dsm, folder / "sky.zarr", resume=True, processes=2)


@pytest.mark.thorough
def test_a_killed_run_goes_on_to_the_same_bytes(dsm, folder, child_environment):
    bake(dsm, folder / "right.zarr")
    command = [sys.executable, "-m", "warpsample", "bake", str(dsm), "-o", str(folder / "sky.zarr"), "--quantity", "sky"]
    command += ["--samples", str(RAYS), "--tile", "15", "--margin", "6"]
    child = subprocess.Popen(command, env=child_environment, cwd=folder)
    records = folder / "sky.zarr" / ".run" / "chunks"
    waited = time.monotonic() + 300.0
    while not (records.is_dir() and len(list(records.iterdir())) >= 2):
        assert child.poll() is None, "it ended before it was killed"
        assert time.monotonic() < waited, "it hangs"
        time.sleep(0.001)
    child.send_signal(signal.SIGKILL)
    child.wait()
    there = len(list(records.iterdir()))
    subprocess.run([*command, "--resume"], env=child_environment, cwd=folder, check=True)
    assert 2 <= there <= TILES
    assert contents(folder / "sky.zarr") == contents(folder / "right.zarr")


@pytest.mark.thorough
def test_processes_write_the_same_bytes_and_warn_once(dsm, folder):
    for name, processes in (("right.zarr", None), ("sky.zarr", 2)):
        with pytest.warns(UserWarning, match="^tolerance: got 1e-06, which is not reached with 32 rays") as heard:
            bake(dsm, folder / name, processes=processes, tolerance=1e-6)
        assert len(heard) == 1
    assert contents(folder / "sky.zarr") == contents(folder / "right.zarr")


def test_two_runs_do_not_write_one_geotiff(dsm, folder):
    store = tile_files.TileFiles(folder / "sky.tif", False)
    with store.locked(), pytest.raises(WriteError, match="another process is writing it"):
        bake(dsm, folder / "sky.tif")
    assert list(folder.iterdir()) == []
