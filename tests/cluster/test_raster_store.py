"""Rasters baked by the command: tiles that are whole or absent, runs that go on, and GeoTIFFs that appear at the end."""

import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from importlib import import_module

import numpy as np
import pytest
from affine import Affine
from raster_cases import SLOVENIA, heights, write_tif
from weather_files import write_epw

from warpsample import rasters
from warpsample.city.rasters.tiles import RasterRun
from warpsample.host.files import WriteError
from warpsample.output.baked import BakeRun

pytestmark = pytest.mark.slow  # seconds each

for library in ("dask", "zarr", "rioxarray"):
    pytest.importorskip(library)
rasterio = pytest.importorskip("rasterio")
xr = pytest.importorskip("xarray")
baking = import_module("warpsample.cluster.raster_baking")
raster_bake = import_module("warpsample.output.rasters.bake")
tile_files = import_module("warpsample.output.rasters.tile_files")

TILES, RAYS = 12, 32  # 15 x 15 cells of 60 x 44


@pytest.fixture
def folder(tmp_path):
    made = tmp_path / "made"
    made.mkdir()
    return made


def job(dsm, quantity="sky", **options):
    """The options of a run."""
    given = {"samples": RAYS, "tile": 15, "margin": 6, **options} if quantity == "sky" else options
    return dsm, quantity, given


def bake_job(job, output, resume=False, processes=None):
    source, quantity, given = job
    run = BakeRun.of(source, output, quantity, {"seed": 0, **given})
    if output.suffix == ".zarr":
        return raster_bake.bake_raster(run, baking.ZarrTiles(output, resume, processes))
    return raster_bake.bake_raster(run, tile_files.TileFiles(output, resume))


def bake(dsm, output, resume=False, processes=None, **options):
    return bake_job(job(dsm, **options), output, resume, processes)


def contents(store):
    """The bytes of all files of a store, by their paths."""
    return {str(path.relative_to(store)): path.read_bytes() for path in store.rglob("*") if path.is_file()}


@pytest.fixture
def computed(monkeypatch):
    """The tiles that are computed; the test may set after how many comes an interrupt."""
    ran, numbers = [], RasterRun.numbers

    def counted(run, span):
        if run.reader.shape == (2, 2):  # a check of the options
            return numbers(run, span)
        if len(ran) == counted.most:
            raise KeyboardInterrupt
        ran.append(list(run.spans()).index(span))
        return numbers(run, span)

    counted.most = -1
    monkeypatch.setattr(RasterRun, "numbers", counted)
    return ran, counted


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


def test_what_a_virtual_raster_refers_to_is_no_output(dsm, folder):
    before = dsm.read_bytes()
    rasterio.shutil.copy(dsm, folder / "dsm.vrt", driver="VRT")
    content = (folder / "dsm.vrt").read_text().replace(str(dsm), "dsm.vrt").replace('relativeToVRT="0"', 'relativeToVRT="1"')
    (folder / "of_vrt.vrt").write_text(content)  # a virtual raster of a virtual one: the raster below was replaced
    for name in ("dsm.vrt", "of_vrt.vrt"):
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
def test_an_interrupted_run_goes_on_to_the_same_bytes(dsm, folder, name, computed):
    ran, counted = computed
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
def test_an_interrupt_while_processes_start_or_end_tells_what_is_there(dsm, folder, computed, monkeypatch, late):
    _, counted = computed
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


def test_a_damaged_tile_is_computed_again_and_no_other(dsm, folder, computed):
    ran, _ = computed
    bake(dsm, folder / "sky.zarr")
    right = contents(folder / "sky.zarr")
    ran.clear()
    file = folder / "sky.zarr" / "value" / "c" / "1" / "2"
    file.write_bytes(file.read_bytes()[:-1])
    bake(dsm, folder / "sky.zarr", resume=True)
    assert ran == [5]
    assert contents(folder / "sky.zarr") == right


@pytest.mark.parametrize("damage", ["missing", "truncated", "flipped", "folder"])
def test_damaged_coordinates_are_written_again(dsm, folder, computed, damage):
    """Nobody looked at them: y was 0 in all rows of a store that was complete."""
    ran, _ = computed
    store = folder / "sky.zarr"
    bake(dsm, store)
    right = contents(store)
    ran.clear()
    file = store / "y" / "c" / "0"
    content = file.read_bytes()
    file.unlink()
    if damage == "folder":
        file.parent.rmdir()
    elif damage != "missing":
        file.write_bytes(content[:10] if damage == "truncated" else content[:20] + bytes([content[20] ^ 1]) + content[21:])
    bake(dsm, store, resume=True)
    assert ran == []
    assert contents(store) == right


@pytest.mark.filterwarnings("ignore:Consolidated metadata")
def test_a_store_that_others_wrote_anew_is_refused_and_keeps_its_bytes(dsm, folder):
    """Its coordinates are compressed: those of this run, not compressed, were written before the refusal."""
    store = folder / "sky.zarr"
    bake(dsm, store)
    xr.open_zarr(store).load().drop_encoding().to_zarr(store, mode="w")
    right = contents(store)
    with pytest.raises(ValueError, match="^--output: got .* new name$"):
        bake(dsm, store, resume=True)
    assert contents(store) == right


@pytest.mark.parametrize("content", [b"", b'{"attributes": {}, "zarr_format": 3, "node_type": 0}'])
def test_the_metadata_of_records_are_checked(dsm, folder, content):
    bake(dsm, folder / "sky.zarr")
    (folder / "sky.zarr" / ".run" / "zarr.json").write_bytes(content)
    with pytest.raises(
        ValueError, match=r"^--output: got .*sky\.zarr', whose \.run/zarr\.json (is damaged|has another 'node_type')"
    ):
        bake(dsm, folder / "sky.zarr", resume=True)


@pytest.mark.parametrize("file", ["zarr.json", "spatial_ref/zarr.json"])
def test_another_reference_system_in_a_store_is_named(dsm, folder, file):
    bake(dsm, folder / "sky.zarr")
    path = folder / "sky.zarr" / file
    path.write_bytes(b"Sloveni".join(path.read_bytes().rsplit(b"Slovene", 1)))
    with pytest.raises(ValueError, match=rf"whose {file} has another 'attributes' than"):
        bake(dsm, folder / "sky.zarr", resume=True)


@pytest.mark.parametrize(
    ("options", "what"),
    [
        ({"tile": 20}, "tile 15"),
        *(
            pytest.param(*case, marks=pytest.mark.thorough)
            for case in (({"margin": 7}, "margin 6"), ({"seed": 1}, "seed 0"), ({"samples": 64}, "count"))
        ),
        ({"receiver": "surface"}, "definition .the normal n is up.*want .* definition .the normal n is the normal of"),
    ],
)
def test_a_store_of_another_run_is_refused(dsm, folder, options, what):
    bake(dsm, folder / "sky.zarr")
    right = contents(folder / "sky.zarr")
    with pytest.raises(ValueError, match=f"of {what}"):
        bake(dsm, folder / "sky.zarr", resume=True, **options)
    assert contents(folder / "sky.zarr") == right


def rewritten(path, change):
    """Lets a file have other contents of the same size, at the same time of change."""
    before = path.stat()
    change(path)
    assert path.stat().st_size == before.st_size
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))


def raised(path):
    with rasterio.open(path, "r+") as file:
        file.write(file.read(1) + np.float32(0.5), 1)


def warmer(path):
    """A year in which the sun of one hour is stronger."""
    lines = path.read_bytes().split(b"\n")
    row = next(i for i, line in enumerate(lines) if line.split(b",")[1:4] == [b"6", b"21", b"12"])
    fields = lines[row].split(b",")
    fields[14] = b"%d" % (int(fields[14]) + 1)
    path.write_bytes(b"\n".join([*lines[:row], b",".join(fields), *lines[row + 1 :]]))


@pytest.mark.filterwarnings("ignore:Dataset has no geotransform")
def test_what_files_say_is_compared_not_their_size_and_age(dsm, folder, computed):
    _, counted = computed
    counted.most = 0
    given = dsm.parent
    for name in ("crowns.tif", "bases.tif", "alps.tif"):
        write_tif(given / name, np.full((60, 44), 2.0 + len(name), np.float32), transform=SLOVENIA)
    write_tif(given / "bare.tif", heights(), transform=None)
    (given / "bare.tfw").write_text("1.0\n0.0\n0.0\n-1.0\n564000.5\n145999.5\n")
    rasterio.shutil.copy(dsm, given / "dsm.vrt", driver="VRT")
    year = given / "year.epw"
    write_epw(year)
    trees = {"canopy": str(given / "crowns.tif"), "trunk": str(given / "bases.tif"), "far": str(given / "alps.tif")}
    sun = {"weather": year, "period": ("06-21", "06-21"), "tile": 15}
    jobs = {
        "sky": job(dsm, **trees),
        "vrt": job(given / "dsm.vrt"),
        "bare": job(given / "bare.tif"),
        "sun": job(dsm, "sun-hours", **sun),
    }
    for name, one in jobs.items():
        with pytest.raises(KeyboardInterrupt):
            bake_job(one, folder / f"{name}.zarr")
    cases = [
        ("sun", year, warmer, "weather_content"),
        (
            "bare",
            given / "bare.tfw",
            lambda path: path.write_text(path.read_text().replace("0.5", "1.5")),
            "source_transform",
        ),
        ("sky", given / "alps.tif", raised, "far_heights"),
        ("sky", given / "bases.tif", raised, "trunk_heights"),
        ("sky", given / "crowns.tif", raised, "canopy_heights"),
        ("vrt", dsm, raised, "source_heights"),
        ("sky", dsm, raised, "source_heights"),
    ]
    for name, file, change, what in cases:
        rewritten(file, change)
        advice = f"the heights of the raster '{what[:-8]}' have changed" if "_heights" in what else "repeat the arguments"
        with pytest.raises(ValueError, match=f"of {what} '.*; {advice}"):
            bake_job(jobs[name], folder / f"{name}.zarr", resume=True)


def moved(path):
    write_tif(path, heights(), transform=SLOVENIA @ Affine.scale(1.5))


@pytest.mark.parametrize(
    ("change", "when", "there"),
    [
        (raised, 4, 5),
        pytest.param(raised, TILES - 1, TILES, marks=pytest.mark.thorough),
        pytest.param(moved, 4, TILES, marks=pytest.mark.thorough),
    ],
)
def test_a_file_that_changes_meanwhile_puts_no_number_into_the_store(dsm, folder, monkeypatch, change, when, there):
    before, numbers = dsm.read_bytes(), RasterRun.numbers

    def changing(run, span):
        found = numbers(run, span)
        if run.reader.shape != (2, 2) and list(run.spans()).index(span) == when:
            change(dsm)
        return found

    bake(dsm, folder / "right.tif")
    monkeypatch.setattr(RasterRun, "numbers", changing)
    with pytest.raises(ValueError, match="source: got .* (changed since|when) the run began.* resume"):
        bake(dsm, folder / "sky.tif")
    assert not (folder / "sky.tif").exists()
    monkeypatch.undo()
    dsm.write_bytes(before)
    assert f"{there} of the {TILES} tiles were complete before" in bake(dsm, folder / "sky.tif", resume=True)
    assert (folder / "sky.tif").read_bytes() == (folder / "right.tif").read_bytes()


def test_what_is_not_our_working_folder_stays(dsm, folder, computed):
    _, counted = computed
    hidden = folder / ".sky.tif.tiles"
    hidden.mkdir()
    (hidden / "thesis.txt").write_text("own")
    with pytest.raises(ValueError, match="which holds other files, want another output name"):
        bake(dsm, folder / "sky.tif", resume=True)
    assert [path.name for path in hidden.iterdir()] == ["thesis.txt"]
    shutil.rmtree(hidden)
    counted.most = 3
    with pytest.raises(KeyboardInterrupt):
        bake(dsm, folder / "sky.tif")
    with pytest.raises(ValueError, match="sky.tif.tiles' of seed 0, want tiles of seed 1"):
        bake(dsm, folder / "sky.tif", resume=True, seed=1)


def test_a_damaged_tile_file_is_computed_again_and_no_other(dsm, folder, computed):
    ran, counted = computed
    bake(dsm, folder / "right.tif")
    ran.clear()
    counted.most = 7
    with pytest.raises(KeyboardInterrupt):
        bake(dsm, folder / "sky.tif")
    file = folder / ".sky.tif.tiles" / "tile-2.npz"
    content = bytearray(file.read_bytes())
    content[content.index(b"value.npy") + 300] ^= 1  # a number of the tile
    file.write_bytes(content)
    ran.clear()
    counted.most = -1
    bake(dsm, folder / "sky.tif", resume=True)
    assert ran == [2, *range(7, TILES)]
    assert (folder / "sky.tif").read_bytes() == (folder / "right.tif").read_bytes()


def test_two_runs_do_not_write_one_geotiff(dsm, folder):
    store = tile_files.TileFiles(folder / "sky.tif", False)
    with store.locked(), pytest.raises(WriteError, match="another process is writing it"):
        bake(dsm, folder / "sky.tif")
    assert list(folder.iterdir()) == []
