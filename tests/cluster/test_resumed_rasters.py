"""Runs that write a raster, continued: damage is computed again, and another run, other files or metadata are refused."""

import os
import shutil

import numpy as np
import pytest
from affine import Affine
from raster_cases import SLOVENIA, heights, write_tif
from weather_files import write_epw

from warpsample.city.rasters.tiles import RasterRun

pytest.importorskip("dask")
pytest.importorskip("zarr")
pytest.importorskip("rioxarray")

import rasterio
import xarray as xr
from raster_runs import TILES, bake, bake_job, contents, job

pytestmark = pytest.mark.slow  # seconds each


def test_a_damaged_tile_is_computed_again_and_no_other(dsm, folder, computed_tiles):
    ran, _ = computed_tiles
    bake(dsm, folder / "sky.zarr")
    right = contents(folder / "sky.zarr")
    ran.clear()
    file = folder / "sky.zarr" / "value" / "c" / "1" / "2"
    file.write_bytes(file.read_bytes()[:-1])
    bake(dsm, folder / "sky.zarr", resume=True)
    assert ran == [5]
    assert contents(folder / "sky.zarr") == right


@pytest.mark.parametrize("damage", ["missing", "truncated", "flipped", "folder"])
def test_damaged_coordinates_are_written_again(dsm, folder, computed_tiles, damage):
    """Nobody looked at them: y was 0 in all rows of a store that was complete."""
    ran, _ = computed_tiles
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
def test_what_files_say_is_compared_not_their_size_and_age(dsm, folder, computed_tiles):
    _, counted = computed_tiles
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


def test_what_is_not_our_working_folder_stays(dsm, folder, computed_tiles):
    _, counted = computed_tiles
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
    counted.most = -1
    (folder / "other.npz").write_bytes(b"other")
    (hidden / "tile-5.npz").symlink_to(folder / "other.npz")
    with pytest.raises(ValueError, match="which holds links, want another output name"):
        bake(dsm, folder / "sky.tif", resume=True)
    assert (folder / "other.npz").read_bytes() == b"other"  # a tile replaced it
    (hidden / "tile-5.npz").unlink()
    (hidden / "cog").mkdir()
    own = ["cog/thesis.txt", "thesis.txt", "tile-mine.npz"]  # at the end, they were removed with the tiles
    for name in own:
        (hidden / name).write_text("own")
    bake(dsm, folder / "sky.tif", resume=True)
    assert sorted(path.relative_to(hidden).as_posix() for path in hidden.rglob("*") if path.is_file()) == own


def test_a_damaged_tile_file_is_computed_again_and_no_other(dsm, folder, computed_tiles):
    ran, counted = computed_tiles
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
