"""`warpsample bake dsm.tif`: options that are refused, files that are never overwritten, and the commands of the README."""

import re
import subprocess
import sys

import numpy as np
import pytest
from affine import Affine
from raster_cases import SLOVENIA, heights, write_tif

pytestmark = pytest.mark.slow  # seconds each

for library in ("dask", "zarr", "rioxarray"):
    pytest.importorskip(library)
rasterio = pytest.importorskip("rasterio")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["-o", "sky.exr"], "--output: got 'sky.exr' for rasters, want a file that ends in one of .tif .tiff .png .zarr"),
        (["-o", "sky.tif", "--points", "5"], "--points: got 5 for dsm.tif; the option applies only to meshes and CityJSON"),
        (["-o", "sky.tif", "--margin", "5"], "--margin: got 5 without tile, want tile, the number"),
        (["-o", "sky.tif", "--canopy", "none.tif"], "--canopy: got 'none.tif', which is missing"),
        (["-o", "sky.tif", "--tile", "0"], "--tile: got 0, want a whole number from 1 to 2147483647"),
        (["-o", "sky.tif", "--processes", "0"], "--processes: got 0, want a whole number from 1 to 1024"),
        (["-o", "dsm.tif"], "--output: got 'dsm.tif'"),
        (
            ["-o", "sky.tif", "--weather", "athens"],
            "--weather: got athens for sky; the option applies only to irradiation and sun-hours",
        ),
        (["-o", "sky.tif", "--quantity", "irradiation"], "--weather: got None for irradiation, want an EPW weather file"),
        (
            ["-o", "sky.tif", "--quantity", "sky-matrix"],
            "--quantity: got 'sky-matrix' for rasters, want one of ao",
        ),
        (
            ["-o", "sky.tif", "--texture", "64"],
            "--texture: got 64 for dsm.tif; the option applies only to textures (--texture)",
        ),
        (["-o", "sky.tif", "--strict"], "--strict: got True for dsm.tif; the option applies only to textures (--texture)"),
        (
            ["-o", "sky.tif", "--up", "0", "0", "1"],
            "--up: got (0.0, 0.0, 1.0) for dsm.tif; the option applies only to meshes",
        ),
        (
            ["-o", "sky.tif", "--quantity", "visible-sky", "--receiver", "surface"],
            "--receiver: got 'surface' for the visible sky, want 'horizontal'",
        ),
        (["-o", "no/sky.tif"], "--output: got 'no/sky.tif'"),
        (["-o", "sky.tif", "--seed", "-1"], "--seed: got -1, want"),
        (["-o", "sky.tif", "--samples", "1"], "--samples: got 1, want"),
        (["-o", "sky.tif", "--sequence", "nope"], "--sequence: got 'nope', want"),
        (["-o", "sky.zarr", "--max-distance", "-1"], "--max-distance: got -1"),
    ],
)
def test_bad_input_is_one_sentence_and_leaves_nothing(dsm, arguments, said, call, monkeypatch):
    monkeypatch.chdir(dsm.parent)
    before = dsm.read_bytes()
    status, out, err = call("bake", "dsm.tif", "--quantity", "sky", *arguments)
    assert (status, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
    assert [path.name for path in dsm.parent.iterdir()] == ["dsm.tif"]
    assert dsm.read_bytes() == before


@pytest.mark.parametrize("output", ["sky.tif", "sky.zarr"])
def test_a_raster_without_heights_leaves_nothing(dsm, output, call, monkeypatch):
    monkeypatch.chdir(dsm.parent)
    with rasterio.open(dsm, "r+") as file:
        file.write(np.full(file.shape, np.nan, np.float32), 1)
    status, _, err = call("bake", "dsm.tif", "-o", output, "--quantity", "sky", "--tile", "15")
    assert status == 2
    assert "cells without any height, want at least one" in err
    assert [path.name for path in dsm.parent.iterdir()] == ["dsm.tif"]


@pytest.mark.parametrize("option", ["canopy", "far"])
def test_no_input_is_overwritten(dsm, option, call, monkeypatch):
    monkeypatch.chdir(dsm.parent)
    other = dsm.with_name("other.tif")
    other.write_bytes(dsm.read_bytes())
    status, _, said = call("bake", "dsm.tif", "-o", "other.tif", f"--{option}", "other.tif")
    assert status == 2
    assert said.startswith("error: --output: got 'other.tif', which is")
    assert other.read_bytes() == dsm.read_bytes()


@pytest.mark.thorough
def test_a_new_file_is_not_read_with_the_masks_of_an_older_one(dsm, child_environment):
    """And what a user has at names like ours stays."""
    folder = dsm.parent
    older = [folder / f"sky.tif{suffix}" for suffix in ("", ".msk", ".ovr", ".aux.xml")]
    own = folder / ".sky.tif.making" / "thesis.txt"
    own.parent.mkdir()
    for path in (*older, own):
        path.write_text("old")
    command = [sys.executable, "-m", "warpsample", "bake", "dsm.tif", "-o", "sky.tif", "--quantity", "sky", "--samples", "4"]
    done = subprocess.run(command, check=True, env=child_environment, cwd=folder, capture_output=True, text=True)
    assert "removed sky.tif.msk, sky.tif.ovr, sky.tif.aux.xml: overviews, masks or statistics of the file" in " ".join(
        done.stdout.split()
    )
    assert sorted(path.name for path in folder.iterdir()) == [".sky.tif.making", "dsm.tif", "sky.tif"]
    assert own.read_text() == "old"
    stray = folder / "new.tif.ovr"
    stray.write_text("overviews of a file that is gone")
    command[command.index("sky.tif")] = "new.tif"
    done = subprocess.run(command, check=False, env=child_environment, cwd=folder, capture_output=True, text=True)
    assert (done.returncode, stray.read_text()) == (2, "overviews of a file that is gone")
    assert "next to new.tif.ovr, which GDAL would read as part of it" in done.stderr
    assert not (folder / "new.tif").exists()


@pytest.mark.parametrize("option", ["source", "canopy", "far"])
@pytest.mark.parametrize("suffix", [".ovr", ".msk", ".aux.xml"])
def test_no_input_is_removed_with_the_masks_of_an_older_file(dsm, option, suffix, call, monkeypatch):
    monkeypatch.chdir(dsm.parent)
    older, used = dsm.with_name("sky.tif"), dsm.with_name(f"sky.tif{suffix}")
    for path in (older, used):
        path.write_bytes(dsm.read_bytes())
    inputs = [used.name] if option == "source" else [dsm.name, f"--{option}", used.name]
    status, _, said = call("bake", *inputs, "-o", older.name, "--quantity", "sky", "--samples", 4)
    assert status == 2
    assert f"error: --output: got 'sky.tif' next to {used.name}, which GDAL would read as part of it" in said
    assert used.read_bytes() == older.read_bytes() == dsm.read_bytes()


@pytest.mark.parametrize("name", ["sky.tif.OVR", "SKY.TIF.msk", "sky.aux", "sky.tif.Aux"])
def test_sidecars_in_other_case_and_of_erdas_are_refused(dsm, name, call, monkeypatch):
    """GDAL read them as part of the result: all cells were masked. They may belong to another file, so they stay."""
    monkeypatch.chdir(dsm.parent)
    (dsm.parent / name).write_bytes(b"EHFA_HEADER_TAG")
    for old in (False, True):
        if old:
            (dsm.parent / "sky.tif").write_bytes(b"old")
        status, _, said = call("bake", dsm.name, "-o", "sky.tif", "--quantity", "sky", "--samples", 4)
        assert status == 2
        assert f"error: --output: got 'sky.tif' next to {name}, which GDAL would read as part of it" in said
    (dsm.parent / name).rename(dsm.parent / "sky.tif.tex")
    (dsm.parent / "sky.aux").write_text("\\relax")  # of LaTeX
    assert call("bake", dsm.name, "-o", "sky.tif", "--quantity", "sky", "--samples", 4)[0] == 0


def test_overviews_beside_the_target_of_a_link_are_removed(dsm, call, monkeypatch):
    """And those beside the link: GDAL finds the former when the target is opened, and the latter when the link is."""
    monkeypatch.chdir(dsm.parent)
    target, link = dsm.parent / "data/sky.tif", dsm.parent / "link.tif"
    target.parent.mkdir()
    older = [target, target.with_name("sky.tif.ovr"), dsm.parent / "link.tif.msk"]
    for path in older:
        path.write_text("old")
    link.symlink_to(target)
    status, said, _ = call("bake", "dsm.tif", "-o", link.name, "--quantity", "sky", "--samples", 4)
    assert (status, [path.exists() for path in older]) == (0, [True, False, False])
    assert "removed link.tif.msk, sky.tif.ovr: overviews, masks or statistics of the file" in " ".join(said.split())


def test_options_of_rasters_are_refused_for_meshes(tmp_path, call):
    status, _, said = call("bake", "courtyard", "-o", tmp_path / "a.ply", "--tile", "9")
    assert (status, said) == (2, "error: --tile: got 9 for courtyard; the option applies only to rasters\n")


def test_the_commands_of_the_readme_run(dsm, repository, call, monkeypatch):
    monkeypatch.chdir(dsm.parent)
    text = (repository / "warpsample" / "city" / "README.md").read_text()
    lines = re.search(r"```sh\n(.*?)```", text, flags=re.DOTALL)[1].splitlines()
    assert len(lines) == 2
    write_tif(dsm.parent / "alps_25m.tif", np.zeros((40, 40), np.float32), transform=SLOVENIA @ Affine.scale(25.0))
    for line in lines:
        assert call(*line.split()[1:])[0] == 0
        with rasterio.open(dsm.parent / "svf.tif") as file:
            assert np.array_equal(np.isnan(file.read(1)), np.isnan(heights()))
