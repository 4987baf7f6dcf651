"""Files of `warpsample bake --texture`: .glb and .gltf that are read, written, joined, refused and left alone."""

import json
import re
import struct
from base64 import b64decode

import numpy as np
import pytest
from glb_files import glb
from textured_scenes import RAYS, SQUARE, TWO, array_of, baked, changed, floor_and_glass, opened, rich, with_data_outside

import warpsample as ws
from warpsample.host.json_tree import Part
from warpsample.texture import texture_points
from warpsample.texture.sets import Texels, TextureOptions
from warpsample.texture.tangents import FrameReader


def sparse(number):
    return lambda tree: tree["accessors"][number].update(sparse={"count": 1})


@pytest.mark.parametrize(
    ("change", "options", "why"),
    [
        (
            lambda tree: tree["extensionsUsed"].append("KHR_draco_mesh_compression"),
            [],
            "the file uses KHR_draco_mesh_compression",
        ),
        (lambda tree: tree["extensionsUsed"].append("EXT_mesh_gpu_instancing"), [], "the file uses EXT_mesh_gpu_instancing"),
        (
            lambda tree: tree["nodes"][0].update(extensions={"EXT_mesh_gpu_instancing": {}}),
            [],
            "the file uses EXT_mesh_gpu_instancing",
        ),
        (lambda tree: tree["extensionsUsed"].append("KHR_meshopt_compression"), [], "the file uses KHR_meshopt_compression"),
        (lambda tree: tree["materials"][0].update(occlusionTexture=3), [], r"materials\[0\].occlusionTexture: got 3, want"),
        (lambda tree: tree["materials"][1].update(alphaMode=3), [], r"materials\[1\].alphaMode: got 3, want a text"),
        (sparse(0), [], "the file has sparse accessors"),
        (sparse(9), ["--uv", "new"], "the file has sparse accessors"),
        (
            lambda tree: tree["meshes"][1]["primitives"][0].update(material=9),
            [],
            r"meshes\[1\].primitives\[0\].material: got 9",
        ),
        (lambda tree: tree["materials"].clear(), [], r"meshes\[0\].primitives\[0\].material: got 0"),
        (lambda tree: tree.update(samplers=3), [], "samplers: got 3, want a list"),
        (
            lambda tree: tree["bufferViews"][7].update(byteOffset=1.5),
            ["--uv", "new"],
            r"bufferViews\[7\].byteOffset: got 1.5, want a whole .*0$",
        ),
        (
            lambda tree: tree["accessors"][13].update(count=2),
            ["--uv", "new"],
            ".*_AGE: got 2 values, want one for each vertex",
        ),
        (
            lambda tree: tree["accessors"][12].update(type="MAT3"),
            ["--uv", "new"],
            ".*NORMAL: got an accessor of type 'MAT3'",
        ),
        (
            lambda tree: tree["materials"][0].update(extras={"a": [1, "HUGE"]}),
            [],
            r"materials\[0\].extras.a\[1\]: got a number beyond 1.8e\+308, want one that float64 holds$",
        ),
    ],
)
def test_files_that_cannot_be_edited_are_refused(call, tmp_path, change, options, why):
    path = tmp_path / "in.glb"
    path.write_bytes(changed(rich(), change).replace(b'"HUGE"', b" 1e400"))
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 32, *RAYS, *options)
    assert status == 2
    assert re.search(rf"^error: \w+: got '.*in.glb', which cannot be read as .*: {why}", err), err
    assert not (tmp_path / "out.glb").exists()


def test_a_sparse_target_that_stays_is_no_matter(call, tmp_path):
    path = tmp_path / "in.glb"
    path.write_bytes(changed(rich(), sparse(9)))
    baked(call, path)


def test_a_buffer_in_another_file_is_refused(call, tmp_path):
    path = with_data_outside(tmp_path / "in.glb")
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 32)
    assert (status, "buffers[0] is in another file" in err) == (2, True)


def test_a_gltf_and_its_files_become_one_file(call, tmp_path):
    """Two buffers, one of them in the JSON, and a picture of each kind: all is in the .glb, and is read as before."""
    (tmp_path / "in.glb").write_bytes(rich())
    tree, data, _ = opened(tmp_path / "in.glb")
    (tmp_path / "a b.bin").write_bytes(data)
    shown = b"\xff\xd8 a picture"
    (tmp_path / "shown.jpg").write_bytes(shown)
    (tmp_path / "new").write_bytes(b"RIFF\x10\0\0\nWEBPVP8 ")
    tree["images"] += [{"uri": "shown.jpg", "name": "seen", "extras": 1}, {"uri": "new"}]
    said = {"name": "first", "extras": [1]}
    tree["buffers"] = [
        {"uri": "data:;base64,AAECAwQ=", "byteLength": 5, **said},
        {"uri": "a%20b.bin", "byteLength": len(data)},
    ]
    for view in tree["bufferViews"]:
        view["buffer"] = 1
    path = tmp_path / "in.gltf"
    path.write_text(json.dumps(tree))
    output, _ = baked(call, path)
    made, whole, _ = opened(output)
    assert made["buffers"] == [{"byteLength": len(whole), **said}]
    assert whole[:8] == bytes([0, 1, 2, 3, 4, 0, 0, 0])
    assert made["images"][-1]["name"] == "brick occlusion"
    assert made["images"][2]["mimeType"] == "image/webp"
    image = made["images"][1]
    view = made["bufferViews"][image.pop("bufferView")]
    assert image == {"name": "seen", "extras": 1, "mimeType": "image/jpeg"}
    assert whole[view["byteOffset"] : view["byteOffset"] + view["byteLength"]] == shown
    assert made["bufferViews"][0] == {**tree["bufferViews"][0], "buffer": 0, "byteOffset": 8}
    meshes = [ws.load_mesh(tmp_path / name) for name in ("in.glb", "in.gltf", "out.glb")]
    assert all(mesh.digest == meshes[0].digest for mesh in meshes)
    (tmp_path / "shown.jpg").write_bytes(b"RIFF")
    status, _, err = call("bake", path, "-o", tmp_path / "no.glb", "--texture", 32)
    assert (status, "images[1].uri: got a picture that is none of .png .jpg .webp .ktx2" in err) == (2, True)


def test_a_gltf_holds_the_data_of_the_glb(call, tmp_path):
    """The .gltf is the .glb with its data embedded, and no other file is written."""
    path, output = tmp_path / "in.glb", tmp_path / "out put.gltf"
    whole = rich()
    path.write_bytes(whole[:8] + (len(whole) - 12).to_bytes(4, "little") + whole[12:-12])  # without a last chunk
    glb_tree, glb_data, _ = opened(baked(call, path)[0])
    before = set(tmp_path.iterdir())
    assert call("bake", path, "-o", output, "--texture", 64, *RAYS)[0] == 0
    assert set(tmp_path.iterdir()) == before | {output}
    tree = json.loads(output.read_text())
    kind, _, data = tree["buffers"][0].pop("uri").partition(",")
    assert (kind, b64decode(data), tree) == ("data:application/octet-stream;base64", glb_data, glb_tree)
    assert ws.load_mesh(output).digest == ws.load_mesh(path).digest
    assert call("bake", output, "-o", tmp_path / "again.gltf", "--texture", 64, *RAYS)[0] == 0
    path.write_bytes(whole)
    status, _, err = call("bake", path, "-o", output, "--texture", 16)
    assert (status, "the file has 12 bytes after its data, which a .gltf cannot hold" in err) == (2, True)


@pytest.mark.parametrize("length", [1, 2, 3])
def test_data_that_end_anywhere(call, tmp_path, length):
    """What is appended begins at whole 4 bytes all the same, as vertices have to."""
    path = tmp_path / "in.glb"
    path.write_bytes(rich())
    tree, data, _ = opened(path)
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    data += b"\1" * length
    head = struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A)
    path.write_bytes(head + text + struct.pack("<II", len(data), 0x004E4942) + data)
    output, _ = baked(call, path, "--uv", "new")
    made, after, _ = opened(output)
    assert after.startswith(data)
    added = made["bufferViews"][len(tree["bufferViews"]) :]
    assert {view["byteOffset"] % 4 for view in added} == {0}
    assert made["buffers"][0]["byteLength"] == len(after)
    assert len(after) % 4 == 0


def test_what_a_file_needs_beside_it_and_what_shows_no_occlusion_is_reported(call, tmp_path):
    def change(tree):
        tree["images"].append({"uri": "a%20b.png"})
        tree["materials"][1]["extensions"] = {"KHR_materials_unlit": {}}

    path, folder = tmp_path / "in.glb", tmp_path / "other folder"
    path.write_bytes(changed(rich(), change))
    folder.mkdir()
    for output, reports in ((tmp_path / "out.glb", False), (folder / "out.glb", True)):
        status, out, _ = call("bake", path, "-o", output, "--texture", 8, "--samples", 2)
        assert status == 0
        assert "viewers show no occlusion on unlit materials: 'brick'" in out
        assert "morph targets are left out, though the file sets their weights: 'Wånd'" in out
        assert ("out.glb needs these files in its folder: 'a%20b.png'" in out) == reports
        status, out, _ = call("bake", path, "-o", output, "--at", "vertices", "--samples", 2)
        assert (status, "out.glb needs these files in its folder: 'a%20b.png'" in out) == (0, reports)
        assert opened(output)[0]["images"][1] == {"uri": "a%20b.png"}


def test_a_suffix_in_upper_case_is_refused_by_name(call, tmp_path):
    path = floor_and_glass(tmp_path / "in.glb")
    for name in ("out.GLB", "out.GLTF"):
        status, _, err = call("bake", path, "-o", tmp_path / name, "--texture", 8)
        assert (status, err.endswith(", in lower case\n")) == (2, True)


def test_data_that_the_old_file_names_stay(call, tmp_path):
    """A scene in another folder may name the data of the old out.gltf, too."""
    path, output, data = floor_and_glass(tmp_path / "in.glb"), tmp_path / "out.gltf", tmp_path / "out.bin"
    tree, held, _ = opened(path)
    tree["buffers"][0]["uri"] = data.name
    output.write_text(json.dumps(tree))
    data.write_bytes(held)
    tree["buffers"][0]["uri"] = f"../{tmp_path.name}/{data.name}"
    other = tmp_path.with_name(tmp_path.name + " other") / "scene.gltf"
    other.parent.mkdir()
    other.write_text(json.dumps(tree))
    assert call("bake", path, "-o", output, "--texture", 32, "--samples", 2)[0] == 0
    assert (data.read_bytes(), sorted(tmp_path.iterdir())) == (held, [path, data, output])


def test_extensions_that_number_vertices_are_left_out_with_new_coordinates(call, tmp_path):
    """Before, they kept the old numbers, so that outlines joined other vertices. Unknown ones are named."""
    outline = {"indices": 3}

    def extend(tree):
        for mesh in tree["meshes"]:
            mesh["extensions"] = {"EXT_mesh_manifold": {"mergeIndices": 3}}
            more = {"CESIUM_primitive_outline": outline, "EXT_nobody_knows": {}}
            mesh["primitives"][0]["extensions"] = mesh["primitives"][0].get("extensions", {}) | more
        tree["extensionsUsed"] += ["CESIUM_primitive_outline", "EXT_mesh_manifold", "KHR_mesh_quantization"]

    (tmp_path / "in.glb").write_bytes(changed(rich(), extend))
    command = ("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 4)
    status, out, err = call(*command, "--uv", "new")
    assert (status, err) == (0, "")
    start = "new coordinates renumber the vertices of 'floor', 'Wånd'"
    for name in ("CESIUM_primitive_outline", "EXT_mesh_manifold"):
        assert out.count(f"{start}, and so {name} is left out\n") == 1
    assert out.count(f"{start}; EXT_nobody_knows is kept, and may have old numbers\n") == 1
    floor, wall, spare = opened(tmp_path / "out.glb")[0]["meshes"]
    assert "extensions" not in {**floor, **wall}
    assert floor["primitives"][0]["extensions"] == {"EXT_nobody_knows": {}}
    assert wall["primitives"][0]["extensions"].keys() == {"KHR_materials_variants", "EXT_nobody_knows"}
    assert spare["primitives"][0]["extensions"]["CESIUM_primitive_outline"] == outline  # outside the scene
    assert {"CESIUM_primitive_outline", "EXT_mesh_manifold"} <= set(opened(tmp_path / "out.glb")[0]["extensionsUsed"])

    (tmp_path / "in.glb").write_bytes(changed(rich(), extend))
    assert "new coordinates" not in call(*command, "--uv", "0")[1]
    assert opened(tmp_path / "out.glb")[0]["meshes"][0]["primitives"][0]["extensions"]["CESIUM_primitive_outline"] == outline


def test_a_primitive_whose_variants_alone_have_materials_gets_one(call, tmp_path):
    """Its default material had no picture, so that viewers showed none until a variant was chosen."""

    def bare(tree):
        del tree["meshes"][1]["primitives"][0]["material"]

    (tmp_path / "in.glb").write_bytes(changed(rich(), bare))
    command = ("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 4)
    assert call(*command)[0] == 0
    tree = opened(tmp_path / "out.glb")[0]
    wall = tree["meshes"][1]["primitives"][0]
    variants = [mapping["material"] for mapping in wall["extensions"]["KHR_materials_variants"]["mappings"]]
    assert wall["material"] not in variants
    assert all("occlusionTexture" in tree["materials"][number] for number in (wall["material"], *variants))


@pytest.mark.parametrize("are_alike", [True, False])
def test_many_meshes_are_each_looked_at_a_few_times(call, tmp_path, monkeypatch, are_alike):
    """All meshes were listed for each mesh: 2,000 took 50 s before the first ray, and 20,000 hours; so with materials."""
    made, seen = Part.parts, []

    def counted(self, key):
        found = made(self, key)
        seen.append(len(found))
        return found

    monkeypatch.setattr(Part, "parts", counted)
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
    counts = []
    for number in (40, 80):
        nodes = [{"mesh": i, "translation": [0, 9 * i, 0]} for i in range(number)]
        meshes = [{"primitives": [{**one, "material": 0 if are_alike else i}]} for i in range(number)]
        tree = {"meshes": meshes, "materials": [{} for _ in range(number)], "nodes": nodes}
        (tmp_path / "in.glb").write_bytes(glb(tree, [square, SQUARE, TWO]))
        seen.clear()
        command = ("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 8, "--samples", 4, "--uv", 0)
        assert call(*command)[0] == 0
        counts.append(sum(seen))
    assert counts[1] < 2.2 * counts[0]


@pytest.mark.parametrize("kind", ["materials", "places"])
@pytest.mark.parametrize("quantity", ["ao", "normals"])
def test_each_picture_is_made_from_its_own_faces_alone(call, tmp_path, monkeypatch, kind, quantity):
    """Each looked at all faces: 120 materials took 4.1 GB where 4 took 0.8, and 400 places of 320 faces 85 s."""
    flaws, tangents, seen = texture_points.find_face_flaws, FrameReader.frames, []

    def counted(uv):
        seen.append(len(uv))
        return flaws(uv)

    def framed(self, uv, faces, group):
        seen.append(len(uv))
        return tangents(self, uv, faces, group)

    monkeypatch.setattr(texture_points, "find_face_flaws", counted)
    monkeypatch.setattr(FrameReader, "frames", framed)
    number = 20
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
    meshes = [{"primitives": [{**one, "material": i}]} for i in range(number if kind == "materials" else 1)]
    nodes = [{"mesh": i % len(meshes), "translation": [0, 9 * i, 0]} for i in range(number)]
    tree = {"meshes": meshes, "materials": [{} for _ in meshes], "nodes": nodes}
    (tmp_path / "in.glb").write_bytes(glb(tree, [square, SQUARE, TWO]))
    options = ("--texture", 8, "--quantity", quantity, *(RAYS if quantity == "ao" else ()))
    assert call("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", *options)[0] == 0
    assert set(seen) == {2}
    assert number <= len(seen) <= 3 * number  # texels to plan, those to compute, and frames


def test_the_picture_of_some_faces_is_the_same_as_with_all_others_left_out(tmp_path):
    """Points of the second of two materials, by its own rows of faces, and by NaN for the faces of the first."""
    (tmp_path / "in.glb").write_bytes(rich())
    mesh, uv = ws.load_mesh(tmp_path / "in.glb"), ws.load_uv(tmp_path / "in.glb")
    for normals in ("face", "smooth", "lifted"):
        how = TextureOptions((32, 16), samples=3, normals=normals)
        own = Texels(tmp_path / "in.glb", mesh, how, None).points([(slice(2, 4), uv[2:4])])
        uv[:2] = np.nan
        whole = ws.texture_points(mesh, uv, (32, 16), samples=3, normals=normals)
        assert (own.report.covered, own.report.mirrored) == (whole.report.covered, whole.report.mirrored) != (0, 0)
        for name in ("id", "position", "normal", "barycentric", "face"):
            assert np.array_equal(getattr(own.points, name), getattr(whole.points, name))
        assert np.array_equal(own.image(own.points.position), whole.image(whole.points.position))


def test_extensions_that_the_output_no_longer_has_are_not_listed_as_used(call, tmp_path):
    """Outlines number vertices, and the picture replaces one with a transform. Names without an object are kept."""
    others = ["KHR_materials_variants", "EXT_nobody_knows", "KHR_mesh_quantization"]

    def extend(tree):
        del tree["meshes"][2], tree["nodes"][3]  # the mesh outside the scene
        tree["scenes"] = [{"nodes": [0, 1, 2, 3]}]
        tree["skins"][0]["joints"] = [2, 3]
        for mesh in tree["meshes"]:
            mesh["primitives"][0].setdefault("extensions", {})["CESIUM_primitive_outline"] = {"indices": 3}
        tree["extensionsUsed"] = [*others, "CESIUM_primitive_outline", "KHR_texture_transform"]
        tree["extensionsRequired"] = ["CESIUM_primitive_outline"]

    (tmp_path / "in.glb").write_bytes(changed(rich(), extend))
    command = ("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 4, "--uv", "new")
    assert call(*command)[::2] == (0, "")
    tree = opened(tmp_path / "out.glb")[0]
    assert "CESIUM_primitive_outline" not in json.dumps(tree)
    assert tree["extensionsUsed"] == others
    assert "extensionsRequired" not in tree


@pytest.mark.parametrize("uv", ["0", "new"])
def test_an_accessor_without_a_view_is_of_zeros(call, tmp_path, uv):
    """Before, the message named sparse accessors, which the file does not have."""

    def of_zeros(tree):
        tree["accessors"][9] = {"componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}

    (tmp_path / "in.glb").write_bytes(changed(rich(), of_zeros))
    command = ("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 4)
    assert call(*command, "--uv", uv)[::2] == (0, "")
    tree, data, _ = opened(tmp_path / "out.glb")
    number = tree["meshes"][1]["primitives"][0]["targets"][0]["POSITION"]
    assert (number == 9) == (uv == "0")
    assert uv == "0" or not array_of(tree, data, number).any()


def test_an_accessor_of_more_zeros_than_memory_is_refused(call, tmp_path):
    def of_zeros(tree):
        tree["accessors"][0] = {"componentType": 5126, "count": 10**15, "type": "VEC3"}

    (tmp_path / "in.glb").write_bytes(changed(rich(), of_zeros))
    status, _, err = call("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 32)
    assert (status, "accessors[0], 1,000,000,000,000,000 VEC3 of zeros, need" in err) == (2, True)
