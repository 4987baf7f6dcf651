"""Odd glTF files: what cannot be used is named, and no file of another scene is lost."""

import base64
import json
import re
from types import SimpleNamespace

import numpy as np
import pytest
from glb_files import glb
from textured_scenes import SQUARE, TWO, changed, corner, opened

import warpsample as ws
from warpsample.texture.occlusion_picture import read_occlusion
from warpsample.texture.tangents import FrameReader


def two_quads(tmp_path, uv=SQUARE, **more):
    """A floor and a wall with a material each, which share texture coordinates and further attributes."""
    attributes = {name: 4 + i for i, name in enumerate(more)}
    meshes = [
        {"primitives": [{"attributes": {"POSITION": i, "TEXCOORD_0": 2, **attributes}, "indices": 3, "material": i}]}
        for i in (0, 1)
    ]
    nodes, materials = [{"mesh": 0}, {"mesh": 1}], [{"name": "ground"}, {"name": "brick"}]
    path = tmp_path / "in.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": nodes, "materials": materials}, [*corner(), uv, TWO, *more.values()]))
    return path


def as_gltf(path, change=len, head="data:;base64,"):
    """The same scene as a .gltf with embedded data."""
    tree, data, _ = opened(path)
    tree["buffers"][0]["uri"] = head + base64.b64encode(data).decode()
    change(tree)
    made = path.with_suffix(".gltf")
    made.write_text(json.dumps(tree))
    return made


@pytest.mark.parametrize("texture", [(), ("--texture", 16)])
def test_a_damaged_file_is_named(call, tmp_path, texture):
    """The message had no file in it, only "the header declares 1,444 bytes"."""
    path = two_quads(tmp_path, SQUARE)
    path.write_bytes(path.read_bytes()[:-40])
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", *texture)
    assert (status, f"mesh: got {str(path)!r}, which cannot be read as a mesh: the header declares" in err) == (2, True)


@pytest.mark.parametrize("texture", [(), ("--texture", 16)])
def test_a_file_out_of_reach_is_named(call, tmp_path, texture):
    """Names that are too long, as folders that may not be read, made Python's `is_file` raise an error of its own."""
    name = "x" * 300
    status, _, err = call("bake", tmp_path / f"{name}.glb", "-o", tmp_path / "out.glb", *texture)
    assert (status, "which is out of reach, want a mesh file" in err) == (2, True)
    for uri, why in ((name, "out of reach"), ("\ud800", "missing")):  # half of a pair of UTF-16, which JSON can hold
        path = as_gltf(two_quads(tmp_path), lambda tree, uri=uri: tree["buffers"][0].update(uri=uri))
        status, _, err = call("bake", path, "-o", tmp_path / "out.glb", *texture)
        assert (status, "buffers[0].uri: got" in err, f"which is {why}, want a file" in err) == (2, True, True)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_set_with_a_number_that_is_none_is_named(call, tmp_path, bad):
    """One of four corners: of one of the two faces, whose new coordinates are no surprise then."""
    uv = SQUARE.copy()
    uv[3, 1] = bad
    path = two_quads(tmp_path, uv)
    command = ("bake", path, "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 4)
    status, out, _ = call(*command)
    assert status == 0
    why = "(set 0 is passed over: 1 of 2 faces lack it or have no finite numbers in it)"
    assert out.count(f"new coordinates, set 1 {why}") == 2
    status, _, err = call(*command, "--uv", 0)
    assert (status, err.count("\n")) == (2, 1)
    why = "for all faces of 'ground', but 1 of 2 lack it or have no finite numbers in it; --uv new makes a set"
    assert f"--uv: got 0, want a set of texture coordinates {why}" in err


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_set_of_numbers_that_are_none_is_named(call, tmp_path, bad):
    """All corners of set 0. Set 1 is used then, and a mesh without set 0 has no sentence on it."""
    path, output = two_quads(tmp_path, np.full_like(SQUARE, bad), TEXCOORD_1=SQUARE), tmp_path / "out.glb"
    command = ("bake", path, "-o", output, "--texture", 32, "--samples", 4)
    why = "(set 0 is passed over: 2 of 2 faces lack it or have no finite numbers in it)"
    status, out, _ = call(*command)
    assert (status, out.count(f", set 1 {why}: ")) == (0, 2)
    path.write_bytes(changed(path.read_bytes(), drop_sets))
    status, out, _ = call(*command)
    assert (status, out.count(f", new coordinates, set 1 {why}: "), out.count(", new coordinates, set 0: ")) == (0, 1, 1)


@pytest.mark.parametrize("output", ["out.glb", "out.png"])
def test_a_set_that_cannot_be_read_is_named_with_the_reason(call, tmp_path, output):
    """Set 1 of both meshes is a sparse accessor. Before, all faces lacked it or had NaN in it."""
    path = two_quads(tmp_path, TEXCOORD_1=SQUARE)

    def make_sparse(tree):
        for mesh in tree["meshes"]:
            tree["accessors"][mesh["primitives"][0]["attributes"]["TEXCOORD_1"]]["sparse"] = {"count": 1}

    path.write_bytes(changed(path.read_bytes(), make_sparse))
    command = ("bake", path, "-o", tmp_path / output, "--texture", 8, "--samples", 2, "--uv")
    status, _, err = call(*command, 1)
    why = "the file has sparse accessors, want a file that stores all numbers; export it without sparse accessors"
    assert (status, err) == (2, f"error: --uv: got 1, a set that cannot be read: {why}\n")
    path.write_bytes(changed(path.read_bytes(), swap_sets))
    status, out, err = call(*command, "auto")
    assert (status, err, f"set 0 is passed over: {why}" in out) == (0, "", True)


def swap_sets(tree):
    """Swap sets 0 and 1 of both meshes."""
    for mesh in tree["meshes"]:
        attributes = mesh["primitives"][0]["attributes"]
        attributes["TEXCOORD_0"], attributes["TEXCOORD_1"] = attributes["TEXCOORD_1"], attributes["TEXCOORD_0"]


def test_coordinates_of_an_obj_that_are_no_numbers_are_named(call, tmp_path):
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt nan 0\nf 1/1 2/1 3/1\n")
    status, out, err = call("bake", path, "-o", tmp_path / "a.npz", "--texture", 16, "--samples", 4)
    why = "(set 0 is passed over: 1 of 1 faces lack it or have no finite numbers in it)"
    assert (status, err, f", new coordinates {why}: " in out) == (0, "", True)


def drop_sets(tree):
    """Remove set 1 of both meshes, and set 0 of the second mesh."""
    floor, wall = (mesh["primitives"][0]["attributes"] for mesh in tree["meshes"])
    for attributes, number in ((floor, 1), (wall, 1), (wall, 0)):
        del attributes[f"TEXCOORD_{number}"]


@pytest.mark.parametrize(
    ("view", "why"),
    [
        ({"buffer": 7, "byteLength": 1}, "bufferViews[4].buffer: got 7, want a whole number below 1"),
        ({"byteLength": 1}, "the JSON member bufferViews[4].buffer is missing"),
        ({"buffer": 0, "byteOffset": "x", "byteLength": 1}, "bufferViews[4].byteOffset: got 'x', want a whole number"),
    ],
)
def test_a_view_that_nothing_uses_is_checked_when_it_moves(call, tmp_path, view, why):
    path = as_gltf(two_quads(tmp_path), lambda tree: tree["bufferViews"].append(view))
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 16)
    assert (status, err.count("\n"), why in err) == (2, 1, True)


def test_the_head_of_embedded_data_may_be_in_capitals(tmp_path):
    path = two_quads(tmp_path)
    assert ws.load_mesh(as_gltf(path, head="DATA:;BASE64,")).digest == ws.load_mesh(path).digest


@pytest.mark.parametrize("row", [(0, 0, 0, 1), (np.nan, 1, 0, 1), (1, 0, 0, np.nan)])
def test_a_tangent_that_is_none_is_computed_as_a_whole(tmp_path, row):
    """Also its sign, here -1 for the mirrored coordinates of both quads, and not the sign of the file."""
    paths = [two_quads(tmp_path)]
    mesh, uv = ws.load_mesh(paths[0]), ws.load_uv(paths[0])
    found = [FrameReader(paths[0], mesh).frames(uv).tangents]
    paths.append(two_quads(tmp_path, TANGENT=np.tile(np.float32(row), (4, 1))))
    found.append(FrameReader(paths[1], mesh).frames(uv).tangents)
    assert np.array_equal(*found)
    assert (found[0][..., 3] == -1).all()


def test_too_few_normals_are_refused_by_file_and_place(call, tmp_path):
    path = two_quads(tmp_path, NORMAL=np.zeros((3, 3), np.float32))
    status, _, err = call("bake", path, "-o", tmp_path / "out.png", "--texture", 8, "--uv", 0, "--normals", "smooth")
    why = "meshes[0].primitives[0].attributes.NORMAL: got 3 values, want one for each of 4 positions"
    assert (status, err) == (2, f"error: mesh: got {str(path)!r}, which cannot be read as a glTF file to be edited: {why}\n")


@pytest.mark.parametrize("content", [b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n", b"GIF89a" + bytes(20), b""])
def test_a_picture_of_a_format_outside_of_gltf_is_refused(tmp_path, content):
    """PostScript is a program, which Pillow would run."""

    def change(tree):
        shown = "data:image/png;base64," + base64.b64encode(content).decode()
        tree |= {"images": [{"uri": shown}], "textures": [{"source": 0}]}
        tree["materials"][0]["occlusionTexture"] = {"index": 0}

    with pytest.raises(ValueError, match=r"images\[0\]: got a picture that is none of PNG, JPEG, WEBP, want one of these$"):
        read_occlusion(as_gltf(two_quads(tmp_path), change))


@pytest.mark.parametrize("version", [1, 3])
def test_a_glb_of_another_version_is_refused_by_its_version(tmp_path, version):
    path = two_quads(tmp_path)
    content = path.read_bytes()
    path.write_bytes(content[:4] + version.to_bytes(4, "little") + content[8:])
    with pytest.raises(
        ValueError, match=f"the file is a .glb of version {version}, want version 2; export the file as glTF 2"
    ):
        ws.load_mesh(path)


@pytest.mark.parametrize("bad", ["nan", pytest.param("inf", marks=pytest.mark.thorough)])
def test_coordinates_of_usd_that_are_no_numbers_are_named(call, tmp_path, bad):
    """Set 1 is used then. Before, the set counted as missing, without a sentence, and hid the sets after it."""
    path, command = write_usd(tmp_path, f"({bad}, {bad}), " * 3, "(0, 0), (1, 0), (0, 1)"), ("--texture", 16, "--samples", 4)
    why = "(set 0 is passed over: 1 of 1 faces lack it or have no finite numbers in it)"
    status, out, err = call("bake", path, "-o", tmp_path / "a.npz", *command)
    assert (status, err, f", set 1 {why}: " in out) == (0, "", True)
    status, out, err = call("bake", write_usd(tmp_path), "-o", tmp_path / "a.npz", *command)
    assert (status, err, ", new coordinates: " in out) == (0, "", True)
    refusal = f"without texture coordinates that can be used {why}, want .npz"
    for suffix in (".png", ".exr"):  # they hold no new coordinates
        output = tmp_path / f"a{suffix}"
        status, _, err = call("bake", write_usd(tmp_path, f"({bad}, {bad}), " * 3), "-o", output, *command)
        assert (status, err.count("\n"), refusal in err) == (2, 1, True)


def test_a_set_of_usd_that_cannot_be_read_is_named(call, tmp_path):
    path = write_usd(tmp_path, "(0, 0)")
    status, out, err = call("bake", path, "-o", tmp_path / "a.npz", "--texture", 16, "--samples", 4)
    assert (status, err) == (0, "")
    assert ", new coordinates (set 0 is passed over: the primvar /m.primvars:st0 has 1 texture coordinates, want 3): " in out


def write_usd(folder, *sets):
    """Write a triangle with sets of texture coordinates st0, st1 ..., one at each vertex; return the path."""
    lines = [
        f'texCoord2f[] primvars:st{number} = [{values}] (interpolation = "vertex")' for number, values in enumerate(sets)
    ]
    path = folder / "a.usda"
    path.write_text(
        '#usda 1.0\ndef Mesh "m" {\npoint3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n'
        "int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\n" + "\n".join(lines) + "\n}\n"
    )
    return path


def test_a_sliver_by_rounding_is_no_flaw_of_a_set(call, tmp_path):
    """Vertices along the edges of a panel: float32 gives their faces an area on the mesh, and none in the image."""
    along = np.arange(3) / 3
    border = [(along, 0 * along), (1 + 0 * along, along), (1 - along, 1 + 0 * along), (0 * along, 1 - along)]
    flat = np.concatenate([np.column_stack(side) for side in border])
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    fan = np.array([(0, i, i + 1) for i in range(1, 11)], np.uint16)
    arrays = [(3 * flat @ turn[:2]).astype(np.float32), (0.1 + 0.8 * flat).astype(np.float32), fan.ravel()]
    attributes = {"POSITION": 0, "TEXCOORD_0": 1}
    meshes = [{"primitives": [{"attributes": attributes, "indices": 2, "material": 0}]}]
    path = tmp_path / "in.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": [{"mesh": 0}], "materials": [{}]}, arrays))
    areas = ws.load_mesh(path).face_areas
    assert ((areas > 0) & (areas < 1e-3)).any()
    status, out, err = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 4, "--strict")
    assert (status, err, ", set 0: " in out) == (0, "", True)
    assert re.search(r"\n  slivers of the mesh without an area in the image: \d+", out)
    assert "faces without an area" not in out


@pytest.mark.parametrize("quantity", ["position", "ao"])
def test_images_larger_than_the_free_memory_are_an_error(call, tmp_path, monkeypatch, quantity):
    """The images of values need several times the memory of the texels, and the system killed the process."""
    path, output = two_quads(tmp_path), tmp_path / "out.npz"
    monkeypatch.setattr("warpsample.host.engine._ALWAYS_FREE", 0)
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=4_500_000))
    status, _, err = call("bake", path, "-o", output, "--texture", 256, "--uv", 0, "--quantity", quantity)
    assert status != 0
    assert err.endswith("error: values of 256 x 256 texels need 0.0 GB and 0.0 GB are free; take fewer texels\n")
    assert not output.exists()
