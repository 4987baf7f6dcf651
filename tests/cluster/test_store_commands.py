"""Stores at the command line: `bake`, `export`, and what they say."""

import json
import re
import shutil
import zipfile
from importlib import import_module

import numpy as np
import pytest

import warpsample as ws
from warpsample.output import run_record

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

dask = pytest.importorskip("dask")
pytest.importorskip("zarr")
current_client = import_module("warpsample.cluster.arrays").current_client
by_pictures = import_module("warpsample.radiation.sky.irradiance")

POINTS, RAYS, CHUNK = 130, 40, 50


@pytest.fixture(autouse=True)
def _in_this_thread():
    with dask.config.set(scheduler="sync"):
        yield


def test_a_store_is_exported_as_bake_would_have_written(call, tmp_path):
    for at, suffixes in (("faces", ("vtp", "ply", "glb", "csv")), ("vertices", ("vtp", "ply"))):
        options = ("--at", at, "--samples", 8, "--quantity", "sky", "--seed", 2)
        made = tmp_path / f"{at}.zarr"
        assert call("bake", "courtyard", "-o", made, *options, "--chunk", 999)[0] == 0
        for suffix in suffixes:
            output, baked = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
            status, _, err = call("export", made, "courtyard", "-o", output)
            assert (status, err) == (0, "")
            assert call("bake", "courtyard", "-o", baked, *options)[0] == 0
            assert output.read_bytes() == baked.read_bytes()
    made = tmp_path / "points.zarr"
    assert call("bake", "courtyard", "-o", made, "--points", 70, "--samples", 8)[0] == 0
    assert call("export", made, "courtyard", "-o", tmp_path / "a.npz")[0] == 0
    assert call("bake", "courtyard", "-o", tmp_path / "b.npz", "--points", 70, "--samples", 8)[0] == 0
    with zipfile.ZipFile(tmp_path / "a.npz") as one, zipfile.ZipFile(tmp_path / "b.npz") as other:
        assert one.namelist() == other.namelist()
        assert all(one.read(name) == other.read(name) for name in one.namelist() if name != "run.npy")
    one, other = (json.loads(str(np.load(tmp_path / name)["run"])) for name in ("a.npz", "b.npz"))
    assert one.keys() == other.keys()
    assert {name for name in one if one[name] != other[name]} == {"output"}


@pytest.mark.thorough
def test_faces_that_reflect_and_let_light_through(call, path, tmp_path, monkeypatch):
    """What faces send back is found once for all chunks, whose bits are those of one call; another share is another run."""
    found, find = [], by_pictures.reflections_of
    monkeypatch.setattr(by_pictures, "reflections_of", lambda *given: found.append(given) or find(*given))
    np.save(tmp_path / "even.npy", np.ones((4, 8)))
    arguments = ("--quantity", "irradiance", "--environment", tmp_path / "even.npy", "--points", POINTS, "--samples", RAYS)
    shares = (*arguments, "--transmittance", "0.25", "--reflectance", "0.5")
    with dask.config.set(scheduler="threads", num_workers=3):
        status, _, err = call("bake", "courtyard", "-o", path, *shares, "--chunk", CHUNK)
    assert (status, err, len(found)) == (0, "", 1)
    assert call("bake", "courtyard", "-o", tmp_path / "b.npz", *shares)[0] == 0
    (path / "reflected/c/1").unlink()
    assert call("export", path, "courtyard", "-o", tmp_path / "a.npz")[0] != 0
    status, _, err = call("bake", "courtyard", "-o", path, *arguments, "--reflectance", "0.5", "--resume", "--chunk", CHUNK)
    assert (status, "of the same mesh with another transmittance or reflectance" in err) == (2, True)
    assert call("bake", "courtyard", "-o", path, *shares, "--resume", "--chunk", CHUNK)[0] == 0
    assert call("export", path, "courtyard", "-o", tmp_path / "a.npz")[0] == 0
    with np.load(tmp_path / "a.npz") as one, np.load(tmp_path / "b.npz") as other:
        assert one.files == other.files
        assert all(np.array_equal(one[name], other[name]) for name in one.files if name != "run")
        assert one["reflected"].max() > 0.5


def test_the_command_says_what_it_did_and_goes_on(call, path, monkeypatch):
    monkeypatch.setattr(run_record, "perf_counter", lambda: 0.0)
    command = ("bake", "courtyard", "-o", path, "--points", POINTS, "--samples", RAYS, "--chunk", CHUNK)
    status, out, err = call(*command)
    assert (status, err) == (0, "")
    assert out.startswith(f"{path}: ambient occlusion of 130 points\n  mean 0.")
    rays, speed = re.search(r"([\d,]+) rays cast in 0\.00 s, ([\d.]+) million a second", out).groups()
    assert speed == f"{int(rays.replace(',', '')) * 1e3:.1f}"  # no time counts as a nanosecond
    (path / "value/c/1").unlink()
    status, out, err = call(*command, "--resume")
    assert (status, err) == (0, "")
    assert "\n  80 of the 130 points were complete before\n" in out
    status, out, err = call(*command, "--seed", 1, "--resume")
    assert (status, out) == (2, "")
    remedy = "repeat the arguments of that run, or use a new name"
    assert err == f"error: --output: got '{path}' of seed 0, want a store of seed 1; {remedy}\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("bake", "courtyard", "-o", "x.vtp", "--chunk", "9"), "--chunk: got 9 for x.vtp; the option applies only to .zarr"),
        (("bake", "courtyard", "-o", "x.vtp", "--resume"), "--resume: got True for x.vtp; the option applies only to .zarr"),
        (("bake", "courtyard", "-o", "x.zarr", "--chunk", "0"), "--chunk: got 0, want a whole number from 1"),
        (("bake", "courtyard", "-o", "x.zarr", "--processes", "0"), "--processes: got 0, want a whole number from 1"),
        (("bake", "courtyard", "-o", "x.zarr", "--processes", "2", "--workers", "2"), "--processes 2: got it together with"),
        (
            ("bake", "courtyard", "-o", "x.zarr", "--points", "9", "--at", "faces"),
            "--points: got 9 together with --at faces",
        ),
        (("bake", "courtyard", "-o", "x.zarr", "--samples", "1"), "--samples: got 1, want a whole number from 2"),
        (
            ("bake", "courtyard", "-o", "x.zarr", "--environment", "a.hdr"),
            "--environment: got a.hdr for ao; the option applies only",
        ),
        (("bake", "courtyard", "-o", "x.zarr", "--quantity", "irradiance"), "--environment: got None"),
        (("bake", "courtyard", "-o", "no/x.zarr"), "--output: got 'no/x.zarr', whose folder does not exist"),
        (
            ("bake", "courtyard", "-o", "x.zarr", "--cluster", "nowhere"),
            "--cluster: got 'nowhere', where no scheduler answers",
        ),
        (
            ("bake", "courtyard", "-o", "x.zarr", "--cluster", "inproc://a"),
            "--cluster: got 'inproc://a', which only the process that created it can reach, want HOST:PORT",
        ),
        (("export", "x.zarr", "courtyard", "-o", "x.vtp"), "store: got 'x.zarr', which is missing"),
        (("export", "x.zarr", "courtyard", "-o", "x.txt"), "--output: got 'x.txt', want a file that ends in one of"),
    ],
)
def test_bad_input_is_one_line(call, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    status, out, err = call(*arguments)
    assert (status, out) == (2, "")
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
    assert current_client() is None  # nor does one that found no scheduler stay behind,
    assert dask.config.get("scheduler") == "sync"  # by which later calls without a Client failed


def test_only_a_finished_store_of_that_mesh_is_exported(call, path, cube, tmp_path):
    assert call("bake", "courtyard", "-o", path, "--points", POINTS, "--samples", 2, "--chunk", CHUNK)[0] == 0
    for mesh, output, message in [
        (cube, "x.vtp", f"mesh: got '{cube}', which is not the mesh of"),
        ("courtyard", "x.ply", "--output: got 'x.ply' for points, want .vtp, .npz or .csv"),
    ]:
        status, _, err = call("export", path, mesh, "-o", tmp_path / output)
        assert (status, err.count("\n")) == (2, 1)
        assert err.startswith(f"error: {message}")
    (path / "value/c/1").unlink()
    status, _, err = call("export", path, "courtyard", "-o", tmp_path / "x.vtp")
    assert (status, err.count("\n")) == (2, 1)
    assert "which lacks 1 of 3 chunks, want a finished store" in err
    assert not (tmp_path / "x.vtp").exists()


def test_a_store_without_an_array_is_not_exported(call, path, tmp_path):
    assert call("bake", "courtyard", "-o", path, "--points", POINTS, "--samples", 2)[0] == 0
    kept = json.loads((path / "zarr.json").read_text())
    (path / "zarr.json").write_text(json.dumps({**kept, "consolidated_metadata": None}))
    shutil.rmtree(path / "spread")
    status, _, err = call("export", path, "courtyard", "-o", tmp_path / "x.vtp")
    assert (status, err) == (
        2,
        f"error: store: got '{path}', whose array 'spread' is missing; compute the store again under a new name\n",
    )
    (path / "zarr.json").write_text("null")
    status, _, err = call("export", path, "courtyard", "-o", tmp_path / "x.vtp")
    assert (status, err.count("\n")) == (2, 1)
    assert err.startswith(f"error: store: got '{path}', whose zarr.json cannot be read: ")


def test_a_store_read_back_shows_what_was_computed(script, tmp_path, can_render):
    module, mesh = script("baked_store"), ws.load_mesh("courtyard")
    found = module.bake(str(tmp_path), mesh, 64, 200, 3, "z")
    right = ws.sky_view_factor(mesh, ws.vertex_points(mesh), 64, up=(0, 0, 1), seed=3)
    sky, error = module.make_panels(found)
    assert np.array_equal(sky.value, right.value)
    assert np.array_equal(error.value, right.standard_error)
    module.main(samples=64, screenshot=tmp_path / "store.png", size=(900, 340))
    assert (tmp_path / "store.png").stat().st_size > 10_000
