"""Images of textures: .png, .exr and .npz hold the same numbers; a file is whole or absent."""

import json
import subprocess
import sys

import numpy as np
import pytest
from lookups import lookup, on_surface
from PIL import Image
from textured_scenes import changed, opened, rich

import warpsample as ws

SQUARE = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 4 0 1\nv 4 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"


def run(call, path, output, *options):
    status, out, err = call("bake", path, "-o", output, "--texture", "64x32", "--samples", 64, "--uv", "0", *options)
    assert (status, err) == (0, "")
    return out


@pytest.fixture
def floor(tmp_path):
    path = tmp_path / "floor.obj"
    path.write_text(f"{SQUARE}f 1/1 2/2 3/3 4/4\no wall\nf 2/1 3/1 6/1 5/1\n")
    return path


def exr(path):
    import OpenEXR

    with OpenEXR.File(str(path)) as file:
        return {name: channel.pixels.copy() for name, channel in file.channels().items()}


def test_all_files_hold_the_same_numbers(call, floor, tmp_path):
    """The floor is lit from the left: the columns rise from the wall on, at the right, and rows are as in the file."""
    for suffix in (".png", ".exr", ".npz"):
        run(call, floor, tmp_path / f"a{suffix}", "--supersample", 4)
    run(call, floor, tmp_path / "deep.png", "--supersample", 4, "--depth", "16")
    with np.load(tmp_path / "a.npz") as file:
        value, error, uv, options = (file[name] for name in ("value", "standard_error", "uv", "run"))
    assert value.shape == error.shape == (32, 64)
    assert value[:, 0].min() > 0.95 > value[:, -1].max()
    assert 0.0 < np.sqrt(np.mean(error**2)) < 0.1
    layers = exr(tmp_path / "a.exr")
    assert np.array_equal(layers["Y"], value)
    assert np.array_equal(layers["standard_error.Y"], error)
    for name, white in (("a.png", 255), ("deep.png", 65535)):
        assert np.abs(np.array(Image.open(tmp_path / name)) / white - value).max() <= 0.5001 / white  # and float32
    assert np.array_equal(uv, ws.load_uv(floor))
    with np.load(tmp_path / "a.npz") as file:
        assert file["covered"].all()
    options = json.loads(str(options))
    assert (options["texture_size"], options["texture_samples"], options["samples"]) == ("(64, 32)", "4", "64")


def test_positions_far_from_the_origin_keep_their_digits(call, tmp_path):
    """At 4.5e6, the spacing of float32 is half a unit: 32 columns of texels had three different positions."""
    path, start = tmp_path / "far.obj", 4.5e6 + 0.123

    def bake(output, start):
        vertices = [f"v {start + x} {start + y} 0\n" for x, y in ((0, 0), (1, 0), (0, 1))]
        path.write_text("".join(vertices) + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n")
        command = ("bake", path, "-o", tmp_path / output, "--quantity", "position", "--uv", "0", "--texture", 32)
        status, out, err = call(*command)
        assert (status, err) == (0, "")
        return out

    assert "rounded" not in bake("far.npz", start)
    with np.load(tmp_path / "far.npz") as file:
        row = file["value"][31, :, 0]
        assert (row.dtype, file["standard_error"].dtype) == (np.float64, np.float32)
    assert np.abs(row - (start + (np.arange(32) + 0.5) / 32)).max() < 2e-9
    note = "positions are rounded to multiples of 0.5, because an .exr holds float32, and the smallest texels are 0.031 wide"
    assert f"  {note}: an .npz holds float64\n" in bake("far.exr", start)
    assert "rounded" not in bake("near.exr", 0.0)


@pytest.mark.slow
def test_three_channels(call, floor, tmp_path):
    """The bent normals of the floor: away from the wall, and of length 2/3 far from it."""
    for suffix in (".exr", ".npz"):
        run(call, floor, tmp_path / f"b{suffix}", "--quantity", "bent-normals")
    with np.load(tmp_path / "b.npz") as file:
        value = file["value"]
    assert value.shape == (32, 64, 3)
    assert value[16, 2] == pytest.approx((0.0, 0.0, 2 / 3), abs=0.05)
    assert value[16, -2, 0] < -0.1
    assert np.array_equal(exr(tmp_path / "b.exr")["RGB"], value)


def test_new_coordinates_are_in_an_npz(call, tmp_path):
    """By them its image gives back what is at each place of the mesh: AO of a body on which nothing falls is 1."""
    import trimesh

    path = tmp_path / "ball.stl"
    trimesh.creation.icosphere(2).export(path)
    status, _, err = call("bake", path, "-o", tmp_path / "a.png", "--texture", 64)
    said = "without texture coordinates that can be used, want .npz, which holds new ones, or .glb for a glTF file"
    assert (status, err) == (2, f"error: --output: got a .png for 'ball.stl' {said}\n")
    status, _, err = call("bake", path, "-o", tmp_path / "a.npz", "--texture", 64, "--samples", 16)
    assert (status, err) == (0, "")
    with np.load(tmp_path / "a.npz") as file:
        value, uv = file["value"], file["uv"]
    _, at = on_surface(ws.load_mesh(path), uv, 1000)
    assert np.array_equal(lookup(value[..., None], at), np.ones((1000, 1)))


@pytest.mark.parametrize("library", ["PIL.Image", "OpenEXR", "xatlas"])
def test_what_is_missing_is_named_before_the_work(call, floor, tmp_path, library, monkeypatch):
    from warpsample.host.locks import imported

    monkeypatch.setitem(sys.modules, library, None)
    imported.cache_clear()
    suffix, new = {"PIL.Image": (".png", []), "OpenEXR": (".exr", []), "xatlas": (".npz", ["--uv", "new"])}[library]
    status, _, err = call("bake", floor, "-o", tmp_path / f"a{suffix}", "--texture", 64, *new)
    imported.cache_clear()
    assert status == 2
    assert err.endswith("pip install '.[texture]'\n")
    assert [path.name for path in tmp_path.iterdir()] == ["floor.obj"]


# Each output whole, then on a disk that has room for half of it. Python ignores SIGXFSZ.
LIMITED = """
import os, resource, sys
from pathlib import Path
from warpsample import cli

for suffix in (".glb", ".png", ".exr", ".npz"):
    def call():
        sys.argv = ["warpsample", "bake", "in.glb", "-o", f"out{suffix}", "--texture", "64", "--samples", "16"]
        sys.argv += [] if suffix == ".glb" else ["--uv", "0"]
        try:
            cli.main()
        except SystemExit as stop:
            return stop.code
    assert call() == 0
    whole = Path(f"out{suffix}").read_bytes()
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(whole) // 2, resource.RLIM_INFINITY))
    assert call() == 1, suffix
    resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    assert Path(f"out{suffix}").read_bytes() == whole
assert sorted(os.listdir()) == ["in.glb", "out.exr", "out.glb", "out.npz", "out.png"], os.listdir()
"""


@pytest.mark.slow
def test_a_full_disk_leaves_the_old_file(tmp_path, child_environment):
    (tmp_path / "in.glb").write_bytes(rich())
    done = subprocess.run(
        [sys.executable, "-c", LIMITED], env=child_environment, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    said = [line for line in done.stderr.splitlines() if line]
    assert [line.split(":")[0] for line in said] == ["error"] * 4
    assert all("cannot be written" in line for line in said)


def test_what_the_inputs_need_is_not_replaced(call, floor, tmp_path):
    """Pictures of an .obj and of a .gltf, and those of a finer mesh."""
    (tmp_path / "in.glb").write_bytes(changed(rich()[:-12], len))  # with its length updated
    tree, data, _ = opened(tmp_path / "in.glb")
    (tmp_path / "part").mkdir()
    (tmp_path / "part" / "m.mtl").write_text("newmtl a\nmap_Kd -s 1 1 1 of walls.png\n")
    floor.write_text("mtllib part/m.mtl\n" + floor.read_text())
    tree["images"].append({"uri": "of%20glass.png"})
    tree["buffers"][0]["uri"] = "data.bin"
    path, finer = tmp_path / "in.gltf", ["--high", tmp_path / "in.gltf", "--cage", 1]
    path.write_text(json.dumps(tree))
    wanted = {"part/of walls.png": b"1", "of glass.png": b"\x89PNG", "data.bin": data}
    for name, content in wanted.items():
        (tmp_path / name).write_bytes(content)
    for mesh, output, options, needed in (
        (floor, "part/of walls.png", [], "part/of walls.png"),
        (path, "of glass.png", [], "of glass.png"),
        (tmp_path / "in.glb", "of glass.png", ["--uv", "0", *finer], "of glass.png"),
    ):
        status, _, err = call("bake", mesh, "-o", tmp_path / output, "--texture", 16, *options)
        name = repr(str(tmp_path / needed))
        assert (status, err) == (2, f"error: --output: got {name}, which is the input {name}, want another file\n")
    status, _, err = call("bake", floor, "-o", tmp_path / "part/of walls.png", "--at", "faces")
    assert (status, "which is the input" in err) == (2, True)
    assert all((tmp_path / name).read_bytes() == content for name, content in wanted.items())


@pytest.mark.skipif(sys.platform == "win32", reason="no limits on a file's size")
@pytest.mark.parametrize("short", [10, 1500])
def test_an_exr_that_cannot_be_written_leaves_the_old_one(call, floor, tmp_path, short):
    """A disk that lacks a few bytes: OpenEXR reports no error if the last buffer of a file cannot be written."""
    import resource

    output = tmp_path / "out.exr"
    arguments = ["bake", floor, "-o", output, "--texture", 32, "--quantity", "position"]
    assert call(*arguments)[0] == 0
    whole = output.read_bytes()
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(whole) - short, limits[1]))
    try:
        status, _, err = call(*arguments)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert (status, err) == (1, f"error: {output} cannot be written: File too large\n")
    assert output.read_bytes() == whole
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.skipif(sys.platform == "win32", reason="no limits on a file's size")
def test_a_gltf_that_cannot_be_written_leaves_the_old_one(call, tmp_path):
    import resource

    path, output = tmp_path / "in.glb", tmp_path / "out.gltf"
    path.write_bytes(changed(rich()[:-12], lambda tree: tree.update(extras="x" * 100_000)))  # without its last part
    arguments = ["bake", path, "-o", output, "--samples", 4, "--texture"]
    assert call(*arguments, 32)[0] == 0
    whole = output.read_bytes()
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, limits[1]))
    try:
        status, _, err = call(*arguments, 16)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert (status, err) == (1, f"error: {output} cannot be written: File too large\n")
    assert output.read_bytes() == whole
    assert len(list(tmp_path.iterdir())) == 2


def test_the_example_mesh_has_textures(call, tmp_path):
    """It is no file, whose size was read all the same."""
    output = tmp_path / "a.npz"
    assert call("bake", "courtyard", "-o", output, "--texture", 64, "--samples", 4)[0] == 0
    with np.load(output) as file:
        assert 0.5 < file["value"][file["covered"]].mean() < 0.8
