"""An output that cannot be written, or is an input, is refused before anything is read or computed."""

import json
import os
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from warpsample.cli import commands
from warpsample.mesh.files.linked_files import list_linked_files
from warpsample.output import bake, export, source
from warpsample.plotting import rendering


@pytest.fixture
def uncomputed(monkeypatch):
    """Fails every command that comes to read its mesh."""

    def load(path):
        raise AssertionError(f"{path} was read")

    for module in (source, export, commands):
        monkeypatch.setattr(module, "load_mesh", load)


@pytest.mark.parametrize("command", ["directions", "bake"])
@pytest.mark.parametrize("alias", ["itself", "another way", "symlink", "link"])
def test_an_input_is_no_output(call, cube, tmp_path, monkeypatch, uncomputed, command, alias):
    (tmp_path / "folder").mkdir()
    output = {
        "itself": cube,
        "another way": tmp_path / "folder" / ".." / "cube.ply",
        "symlink": tmp_path / "folder" / "other.ply",
        "link": tmp_path / "folder" / "other.ply",
    }[alias]
    if alias == "symlink":
        output.symlink_to(cube)
    if alias == "link":
        output.hardlink_to(cube)
    before = cube.read_bytes()
    status, out, err = call(command, cube, "-o", output)
    assert (status, out) == (2, "")
    assert err == f"error: --output: got {str(output)!r}, which is the input {str(cube)!r}, want another file\n"
    assert cube.read_bytes() == before


SQUARE_PLY = """ply
format ascii 1.0
comment TextureFile of walls.png
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
"""
SQUARE_USD = """#usda 1.0
def Mesh "m" {
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
}
def Shader "s" {
    asset inputs:file = @./of walls.png@
}
"""
SQUARE_CITY = {
    "type": "CityJSON",
    "version": "2.0",
    "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]},
    "CityObjects": {
        "b": {"type": "Building", "geometry": [{"type": "MultiSurface", "lod": "2", "boundaries": [[[0, 1, 2]]]}]}
    },
    "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
    "appearance": {"textures": [{"type": "PNG", "image": "of walls.png"}]},
}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("in.ply", SQUARE_PLY),
        ("in.usda", SQUARE_USD),
        ("in.city.json", json.dumps(SQUARE_CITY)),
        ("in.jsonl", "\n\n".join(json.dumps(SQUARE_CITY | {"type": kind}) for kind in ("CityJSON", "CityJSONFeature"))),
    ],
)
def test_nor_is_a_picture_that_a_mesh_names(call, tmp_path, uncomputed, name, content):
    """Such pictures of .ply, USD and CityJSON files were replaced."""
    mesh, picture = tmp_path / name, tmp_path / "of walls.png"
    mesh.write_text(content)
    picture.write_bytes(b"picture")
    status, _, err = call("bake", mesh, "-o", picture, *([] if "json" in name else ["--texture", 8]))
    assert (status, err) == (
        2,
        f"error: --output: got {str(picture)!r}, which is the input {str(picture)!r}, want another file\n",
    )
    assert picture.read_bytes() == b"picture"


@pytest.mark.parametrize("other", ["\u5c4b\u6839.png", "broken.usda", "inner.usda", "both.usda"])
def test_one_name_of_a_usd_file_hides_no_other(tmp_path, monkeypatch, other):
    """One that stdout could not encode did, and one of a damaged file that is no part of the scene."""
    pytest.importorskip("pxr")
    monkeypatch.setenv("PYTHONIOENCODING", "ascii")
    (tmp_path / "broken.usda").write_text('#usda 1.0\ndef Mesh "broken" { this is not usd')
    two = '#usda 1.0\ndef Scope "x" {{\n asset a = @./{}@\n asset b = @{}@\n}}\n'
    (tmp_path / "inner.usda").write_text(two.format("broken.usda", "./inner.png"))
    (tmp_path / "circle.usda").write_text(two.format("x" * 300, f"../{tmp_path.name}/circle.usda"))
    (tmp_path / "both.usda").write_text(two.format("broken.usda", "./circle.usda"))
    (tmp_path / "in.usda").write_text(two.format(other, "./walls.png"), encoding="utf-8")
    found = list_linked_files(tmp_path / "in.usda")
    assert {tmp_path / "walls.png", tmp_path / other} <= set(found)
    assert (tmp_path / "inner.png" in found) == (other == "inner.usda")


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights")
def test_names_in_a_usd_layer_that_is_a_link_are_beside_the_link(tmp_path):
    """Beside a damaged layer, they were looked up beside the link's target."""
    pytest.importorskip("pxr")
    (tmp_path / "store").mkdir()
    (tmp_path / "store" / "inner.usda").write_text('#usda 1.0\ndef Scope "x" {\n asset a = @./loop/../inner.png@\n}\n')
    (tmp_path / "inner.usda").symlink_to(tmp_path / "store" / "inner.usda")
    (tmp_path / "loop").symlink_to(tmp_path)
    (tmp_path / "broken.usda").write_text('#usda 1.0\ndef Mesh "broken" { this is not usd')
    three = "".join(f" asset a{n} = @{name}@\n" for n, name in enumerate(("broken.usda", "./inner.usda", "loop/in.usda")))
    (tmp_path / "in.usda").write_text(f'#usda 1.0\ndef Scope "x" {{\n{three}}}\n')
    assert tmp_path / "inner.png" in list_linked_files(tmp_path / "in.usda")


@pytest.mark.skipif(sys.platform == "win32", reason="no named pipes")
def test_libraries_of_an_obj_may_have_backslashes_and_are_no_pipes(tmp_path):
    """The first was replaced; reading the second never ended."""
    (tmp_path / "in.obj").write_text("mtllib in.mtl\nmtllib pipe.mtl\n")
    (tmp_path / "in.mtl").write_text("newmtl a\nmap_Kd of\\walls.png\n")
    os.mkfifo(tmp_path / "pipe.mtl")
    found = list_linked_files(tmp_path / "in.obj")
    assert {tmp_path / name for name in ("in.mtl", "pipe.mtl", "of/walls.png")} <= set(found)


@pytest.mark.parametrize("end", ["\n", "\r", "\r\n"])
@pytest.mark.parametrize(
    ("library", "picture"),
    [
        ("mtllib in.mtl", "map_Kd of walls.png"),
        ("mtllib in.mtl # mine", "map_Kd -s 1 1 1 of walls.png # all"),
        ("mtllib \\{end}in.mtl", "map_Kd \\{end}  of walls.png"),
        ('mtllib "in.mtl"', 'aniso "of walls.png"'),
        ("mtllib .\\in.mtl", "map_Kd .\\of walls.png"),
        ("mtllib a.mtl in.mtl b.mtl", "map_Kd of walls.png -s 1 1 1"),
        ("# of C:\\{end}mtllib in.mtl", "newmtl C:\\x\\{end}map_Kd of walls.png"),
    ],
)
def test_every_spelling_of_a_name_in_an_obj_is_found(tmp_path, library, picture, end):
    """Names before a comment, after a joined line, or in lines that end with a carriage return were not found."""
    (tmp_path / "in.obj").write_text(f"v 0 0 0{end}{library.format(end=end)}{end}", newline="")
    (tmp_path / "in.mtl").write_text(f"newmtl a{end}{picture.format(end=end)}{end}", newline="")
    assert {tmp_path / "in.mtl", tmp_path / "of walls.png"} <= set(list_linked_files(tmp_path / "in.obj"))


@pytest.mark.parametrize(
    ("tile", "names"), [("<UDIM>", ("1001", "1012")), ("<udim>", ("1001",)), ("<UVTILE>", ("u1_v1", "u10_v2"))]
)
def test_tiles_of_a_picture_in_an_mtl_are_found(tmp_path, tile, names):
    (tmp_path / "in.obj").write_text("mtllib in.mtl")
    (tmp_path / "in.mtl").write_text(f"map_Kd walls[1].{tile}.png")
    paths = {tmp_path / f"walls[1].{name}.png" for name in names}
    for path in (*paths, tmp_path / "walls[1].old.png"):
        path.touch()
    found = set(list_linked_files(tmp_path / "in.obj"))
    assert paths <= found
    assert tmp_path / "walls[1].old.png" not in found


def test_a_folder_of_tiles_that_cannot_be_read_hides_no_other_picture(tmp_path, monkeypatch):
    """Up to Python 3.12, looking into a folder of another user is an error."""

    def glob(folder, pattern):
        raise PermissionError(folder, pattern)

    monkeypatch.setattr(Path, "glob", glob)
    (tmp_path / "in.obj").write_text("mtllib in.mtl")
    (tmp_path / "in.mtl").write_text("map_Kd walls.<UDIM>.png\nmap_Ks other.png")
    assert tmp_path / "other.png" in list_linked_files(tmp_path / "in.obj")


@pytest.mark.parametrize("name", ["my  walls.png", "of\u3000walls.png", "caf\xe9.png"])
def test_blanks_of_a_name_in_an_mtl_stay(tmp_path, name):
    (tmp_path / "in.obj").write_text("mtllib in.mtl")
    for encoding in ("utf-8", "latin-1"):
        (tmp_path / "in.mtl").write_bytes(f"map_Kd -bm 1 {name}".encode(encoding, "ignore"))
        if "\u3000" not in name or encoding == "utf-8":
            assert tmp_path / name in list_linked_files(tmp_path / "in.obj")


_SPELLED = {
    "text": lambda name: name.encode(),
    "bytes of Windows": lambda name: name.encode("cp1252"),
    "backslashes": lambda name: name.replace("/", "\\").encode(),
    "both": lambda name: name.replace("/", "\\").encode("cp1252"),
    "address": lambda name: b"file:" + name.encode(),
}


@pytest.mark.parametrize("library", _SPELLED)
@pytest.mark.parametrize("picture", _SPELLED)
def test_names_of_materials_and_pictures_may_be_spelled_differently(tmp_path, library, picture):
    (tmp_path / "t\xfcr").mkdir()
    (tmp_path / "in.obj").write_bytes(b"mtllib " + _SPELLED[library]("t\xfcr/caf\xe9.mtl"))
    (tmp_path / "t\xfcr" / "caf\xe9.mtl").write_bytes(b"map_Kd " + _SPELLED[picture]("a \u2013/w\xe4nde.png"))
    assert tmp_path / "t\xfcr" / "a \u2013/w\xe4nde.png" in list_linked_files(tmp_path / "in.obj")


def test_pictures_of_materials_in_another_folder_may_be_relative_to_either_file(tmp_path):
    (tmp_path / "mats").mkdir()
    (tmp_path / "in.obj").write_text("mtllib mats/in.mtl")
    (tmp_path / "mats" / "in.mtl").write_text("map_Kd walls.png")
    assert {tmp_path / "walls.png", tmp_path / "mats" / "walls.png"} <= set(list_linked_files(tmp_path / "in.obj"))


def test_a_damaged_item_of_a_gltf_hides_no_other(tmp_path):
    images = [{"uri": None}, None, 7, {"uri": "\ud800/<UDIM>.png"}, {"uri": "walls.png"}, {"uri": "t.png%3Fx"}]
    (tmp_path / "in.gltf").write_text(json.dumps({"asset": {"version": "2.0"}, "images": images}))
    assert list_linked_files(tmp_path / "in.gltf") == [tmp_path / "walls.png", tmp_path / "t.png?x"]


def test_a_name_in_a_comment_is_none(tmp_path):
    (tmp_path / "in.obj").write_text("mtllib in.mtl")
    (tmp_path / "in.mtl").write_text("map_Kd b.png # instead of a.png")
    found = list_linked_files(tmp_path / "in.obj")
    assert tmp_path / "b.png" in found
    assert tmp_path / "a.png" not in found


@pytest.mark.parametrize("uri", ["of%20walls.png?x=1", "of%20walls.png#f", "file:of%20walls.png", "of%A0walls.png"])
def test_an_address_in_a_gltf_leads_to_its_file(tmp_path, uri):
    (tmp_path / "in.gltf").write_text(json.dumps({"asset": {"version": "2.0"}, "images": [{"uri": uri}]}))
    assert tmp_path / ("of\xa0walls.png" if "%A0" in uri else "of walls.png") in list_linked_files(tmp_path / "in.gltf")


def test_nor_are_a_light_or_a_mesh_that_is_looked_at(call, cube, tmp_path, uncomputed, can_render, script, capsys):
    light, picture = tmp_path / "light.npy", tmp_path / "picture.png"
    np.save(light, np.ones((2, 4, 3)))
    npz = tmp_path / "light.npz"
    npz.hardlink_to(light)
    options = ["--quantity", "irradiance", "--environment", light]
    status, _, err = call("bake", cube, "-o", npz, *options)
    assert (status, err.partition(", which")[2]) == (2, f" is the input {str(light)!r}, want another file\n")
    picture.hardlink_to(cube)
    status, _, err = call("view", cube, "--screenshot", picture)
    assert (status, err.partition(", which")[2]) == (2, f" is the input {str(cube)!r}, want another file\n")
    with pytest.raises(SystemExit):
        script("occlusion").main(mesh=cube, screenshot=picture)
    assert "which is the input" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("command", "option"),
    [("bake", "--transmittance"), ("bake --texture 8", "--transmittance"), ("view", "--arrays")],
)
def test_nor_are_arrays_of_faces_and_lobes(call, cube, tmp_path, uncomputed, can_render, command, option):
    """An output that linked to one of them replaced it."""
    array, output = tmp_path / "in.npy", tmp_path / ("out.png" if command == "view" else "out.npz")
    np.save(array, np.full(12, 0.5))
    output.symlink_to(array)
    status, _, err = call(*command.split(), cube, option, array, "--screenshot" if command == "view" else "-o", output)
    assert (status, err.partition(", which")[2]) == (2, f" is the input {str(array)!r}, want another file\n")


def test_nor_is_a_report_an_input(call, cube, tmp_path, uncomputed):
    """Reports were compared with the mesh and the output alone."""
    array, report = tmp_path / "in.npy", tmp_path / "report.html"
    np.save(array, np.full(12, 0.5))
    report.hardlink_to(array)
    status, _, err = call("bake", cube, "-o", tmp_path / "out.csv", "--transmittance", array, "--report", report)
    said = f"error: --report: got {str(report)!r}, which is the input {str(array)!r}, want another file\n"
    assert (status, err) == (2, said)


def test_a_report_is_not_the_output_by_a_link_to_what_is_not_there_yet(call, cube, tmp_path, uncomputed):
    output, report = tmp_path / "out.csv", tmp_path / "report.html"
    report.symlink_to(output)
    status, _, err = call("bake", cube, "-o", output, "--report", report)
    assert (status, err.partition(", which is the ")[0]) == (2, f"error: --report: got {str(report)!r}")


def test_nor_is_an_output_a_raster_below_the_terrain_of_a_city(call, tmp_path, uncomputed):
    pytest.importorskip("rasterio")
    city, terrain, virtual = (tmp_path / name for name in ("in.city.json", "terrain.csv", "terrain.vrt"))
    city.write_text(json.dumps(SQUARE_CITY))
    terrain.write_text("0.5 0.5 1\n1.5 0.5 1\n0.5 1.5 1\n1.5 1.5 1\n")
    source = '<SimpleSource><SourceFilename relativeToVRT="1">terrain.csv</SourceFilename></SimpleSource>'
    virtual.write_text(f'<VRTDataset rasterXSize="2" rasterYSize="2"><VRTRasterBand>{source}</VRTRasterBand></VRTDataset>')
    status, _, err = call("bake", city, "-o", terrain, "--context", virtual)
    assert (status, err.partition(", which")[2]) == (2, f" is the input {str(terrain)!r}, want another file\n")


UNWRITABLE = {  # what is said of each
    "missing": "whose folder does not exist",
    "file": "whose folder does not exist",
    "dangling": "whose folder does not exist",
    "folder": "which is a folder, want a file",
    "pipe": "which is not an ordinary file",
    "circle": "which cannot be written: Too many levels of symbolic links",
    "long": "which cannot be written: File name too long",
    "read-only": "which cannot be written: ",
}


def unwritable(tmp_path, kind, name):
    """A path of that name where nothing can be written."""
    path = tmp_path / name
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "dangling":
        path.symlink_to(tmp_path / "no" / "file")
    elif kind == "circle":
        path.symlink_to(path)
    elif kind == "file":
        (tmp_path / "file").touch()
    elif kind == "long":
        path = tmp_path / (300 * "o" + name)
    return {"missing": tmp_path / "no" / name, "file": tmp_path / "file" / name, "read-only": Path("/proc") / name}.get(
        kind, path
    )  # /proc is read-only for root, too


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="/proc, pipes and links")
@pytest.mark.parametrize("kind", UNWRITABLE)
def test_what_cannot_be_written_is_refused_before_anything_is_computed(call, cube, tmp_path, uncomputed, can_render, kind):
    for i, (command, suffix, option) in enumerate(
        [
            *((["directions", cube], suffix, "--output") for suffix in export.SUFFIXES),
            *((["bake", cube], suffix, "--output") for suffix in bake.SUFFIXES),
            *((["view", cube], suffix, "--screenshot") for suffix in rendering.SCENE_SUFFIXES),
            (["bench", "error"], ".json", "--json"),
        ]
    ):
        path = unwritable(tmp_path, kind, f"{i}{suffix}")
        before = set(tmp_path.iterdir())
        status, out, err = call(*command, option, path)
        assert (status, out) == (2, "")
        assert err.startswith(f"error: {option}: got {str(path)!r}, {UNWRITABLE[kind]}"), err
        assert err.count("\n") == 1
        assert set(tmp_path.iterdir()) == before


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names")
@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".obj"])
def test_a_pipe_as_a_mesh_is_refused_unread(call, tmp_path, suffix):
    """Who reads it waits for a writer: here one comes at once, so that the test ends in either case."""
    pipe, opened = tmp_path / f"in{suffix}", threading.Event()
    os.mkfifo(pipe)

    def feed():
        os.close(os.open(pipe, os.O_WRONLY))  # waits for a reader
        opened.set()

    writer = threading.Thread(target=feed, daemon=True)
    writer.start()
    status, _, err = call("bake", pipe, "-o", tmp_path / "out.ply")
    assert (status, err) == (2, f"error: path: got {str(pipe)!r}, which is no ordinary file, want a mesh file\n")
    assert not opened.is_set()
    os.close(os.open(pipe, os.O_RDONLY | os.O_NONBLOCK))
    writer.join()
