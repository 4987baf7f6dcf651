"""`warpsample bake in.glb -o out.glb --texture`: right where a viewer looks, and nothing else is touched."""

import copy
import re

import numpy as np
import pytest
import trimesh
from glb_files import glb, placed_twice
from lookups import lookup, on_surface
from textured_scenes import RAYS, SQUARE, TWO, array_of, baked, changed, corner, occlusion, opened, picture, rich

import warpsample as ws
from warpsample.output.textures import bake as texture_bake
from warpsample.texture.sets import Texels


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "in.glb"
    path.write_bytes(rich())
    return path


@pytest.mark.parametrize(("uv", "texture"), [("auto", 64), ("new", 1024)])  # the floor is 2 x 80
def test_a_viewer_sees_the_occlusion_of_the_floor(call, scene, uv, texture):
    """The floor beside a wall of height 1: V = (1 + d / sqrt(d^2 + 1)) / 2 at every place, by what the material says."""
    output, _ = baked(call, scene, "--uv", uv, "--depth", "16", texture=texture)
    tree, data, _ = opened(output)
    info = occlusion(tree, 0)
    number = info.get("texCoord", 0)
    assert number == (1 if uv == "auto" else 2)
    mesh = ws.load_mesh(output)
    points, at = on_surface(mesh, ws.load_uv(output, set=number), 4000)
    floor = (points.face < 2) & (np.abs(points.position[:, 2]) < 30)  # the wall is long, but ends
    read = lookup(picture(tree, data, info["index"]), at[floor])[:, 0]
    d = points.position[floor, 0]
    error = read - (1 + d / np.hypot(d, 1)) / 2
    assert np.sqrt(np.mean(error**2)) < 0.01  # 256 rays, texels below 0.1; a flip or another set gives 0.1 and more


def test_everything_else_stays_byte_for_byte(call, scene):
    output, out = baked(call, scene)
    before, after = opened(scene), opened(output)
    assert after[1].startswith(before[1])
    assert after[2] == before[2] != b""
    tree = copy.deepcopy(after[0])
    for key in ("images", "textures", "bufferViews", "accessors", "materials"):
        added = tree[key][len(before[0][key]) :]
        assert (len(added) > 0) == (key != "accessors")
        del tree[key][len(before[0][key]) :]
    assert tree.pop("samplers") == [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}]
    tree["buffers"][0]["byteLength"] = before[0]["buffers"][0]["byteLength"]
    for material in (1, 2):
        assert tree["materials"][material].pop("occlusionTexture")["index"] == 2
    copied = after[0]["materials"][3]  # for another mesh with the floor's material, which the scene does not place
    assert tree["meshes"][2]["primitives"][0].pop("material") == 3
    assert before[0]["meshes"][2]["primitives"][0].pop("material") == 0
    assert copied == before[0]["materials"][0]
    assert tree["materials"][0].pop("occlusionTexture") == {"index": 1, "texCoord": 1}
    del before[0]["materials"][0]["occlusionTexture"]
    assert tree == before[0]
    assert "the occlusion of material 'ground' is replaced" in out


def test_new_coordinates_take_all_attributes_along(call, tmp_path):
    """Of the wall, which has none: every corner of every face has what it had, and the new set is the first."""
    path = tmp_path / "in.glb"
    path.write_bytes(rich(with_uv=False))
    output, out = baked(call, path, "--strength", 0.5)
    before, after = opened(path), opened(output)
    old, new = (read[0]["meshes"][1]["primitives"][0] for read in (before, after))
    assert set(new["attributes"]) == {*old["attributes"], "TEXCOORD_0"}
    corners = [array_of(*read[:2], part["indices"]).ravel() for read, part in ((before, old), (after, new))]
    for name, number in old["attributes"].items():
        was, is_ = array_of(*before[:2], number), array_of(*after[:2], new["attributes"][name])
        assert np.array_equal(was[corners[0]], is_[corners[1]]), name
        assert before[0]["accessors"][number].get("normalized") == after[0]["accessors"][new["attributes"][name]].get(
            "normalized"
        )
    was, is_ = (array_of(*read[:2], part["targets"][0]["POSITION"]) for read, part in ((before, old), (after, new)))
    assert np.array_equal(was[corners[0]], is_[corners[1]])
    assert {k: v for k, v in new.items() if k not in ("attributes", "indices", "targets")} == {
        k: v for k, v in old.items() if k not in ("attributes", "indices", "targets")
    }
    assert occlusion(after[0], 1) == {"index": 1 + 1, "strength": 0.5}
    assert "'brick', new coordinates, set 0" in out
    meshes = ws.load_mesh(path), ws.load_mesh(output)
    assert np.array_equal(*(mesh.vertices[mesh.faces] for mesh in meshes))
    assert after[1].startswith(before[1])


def test_the_same_command_gives_the_same_bytes(call, scene):
    first = baked(call, scene, "--supersample", 4, "--uv", "new", "--workers", 1)[0].read_bytes()
    assert baked(call, scene, "--supersample", 4, "--uv", "new", "--workers", 2)[0].read_bytes() == first


def test_an_interrupt_leaves_the_old_file(call, scene, monkeypatch):
    """As the second of two pictures is encoded."""
    output = baked(call, scene)[0]
    whole, png = output.read_bytes(), texture_bake.encode_png
    made = []

    def once(image, depth):
        made.append(1)
        if len(made) == 2:
            raise KeyboardInterrupt
        return png(image, depth)

    monkeypatch.setattr(texture_bake, "encode_png", once)
    status, _, _ = call("bake", scene, "-o", output, "--texture", 32, *RAYS)
    assert (status, len(made)) == (130, 2)
    assert output.read_bytes() == whole
    assert sorted(path.name for path in scene.parent.iterdir()) == ["in.glb", "out.glb"]


def test_overlaps_are_named_and_refused_or_unwrapped(call, tmp_path):
    """Two quads of a material on one place of the image."""
    floor, wall = corner()
    arrays = [floor, wall, SQUARE, TWO]
    meshes = [{"primitives": [{"attributes": {"POSITION": i, "TEXCOORD_0": 2}, "indices": 3}]} for i in (0, 1)]
    path = tmp_path / "in.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": [{"mesh": 0, "name": "a"}, {"mesh": 1, "name": "b"}]}, arrays))
    said = "overlapping texels, which show one of several faces: 4,096 ('a', 'b')"
    output, out = baked(call, path, "--uv", "0")
    assert said in out
    assert "occlusionTexture" in opened(output)[0]["materials"][0]
    status, _, err = call("bake", path, "-o", tmp_path / "no.glb", "--texture", 64, "--uv", "0", "--strict")
    assert (status, err) == (2, f"error: --strict: got 'in.glb' with {said}\n")
    assert not (tmp_path / "no.glb").exists()
    output, out = baked(call, path, "--strict")
    why = r"faces overlap in 4,096 of [\d,]+ texels \((9\d|100)\.\d\d%\), and auto accepts none; --uv 0 takes it"
    assert re.search(rf", new coordinates, set 1 \(set 0 is passed over: {why}\): ", out), out
    tree = opened(output)[0]
    assert occlusion(tree, 0) == occlusion(tree, 1) == {"index": 0, "texCoord": 1}
    for mesh in meshes:
        mesh["primitives"][0]["attributes"] |= {"TEXCOORD_1": 2, "TEXCOORD_2": 2}
    path.write_bytes(glb({"meshes": meshes, "nodes": [{"mesh": 0}, {"mesh": 1}]}, arrays))
    out = baked(call, path)[1]
    assert re.search(r"set 2 is passed over: [^;]* auto accepts none\): ", out), out  # --uv has no choice 2
    assert re.findall(r"--uv (\d) takes it", out) == ["0", "1"]


@pytest.mark.parametrize("number", [0, 1])
def test_a_set_that_has_no_place_for_some_faces_is_not_taken(call, tmp_path, number):
    """One face of two has no area, in the first set or in that of an occlusion; one that has none in space is no matter."""
    wall = corner()[1]
    good = SQUARE.copy()
    flat = good.copy()
    flat[3] = good[0]  # two corners of the second face
    arrays = [wall, flat, np.append(TWO, [0, 0, 1]).astype(np.uint16), good]
    names = {f"TEXCOORD_{number}": 1, **({"TEXCOORD_0": 1} if number else {})}
    occluded = {"occlusionTexture": {"index": 0, "texCoord": 1}} if number else {}
    primitive = {"attributes": {"POSITION": 0, **names}, "indices": 2, "material": 0}
    tree = {"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}], "materials": [occluded]}
    path = tmp_path / "in.glb"
    path.write_bytes(glb(tree, arrays))
    passed = "; ".join(f"set {i} is passed over: faces have no area in it" for i in range(number, -1, -1))
    assert f"new coordinates, set {number + 1} ({passed}): " in baked(call, path)[1]
    primitive["attributes"]["TEXCOORD_0"] = 3
    path.write_bytes(glb(tree, arrays))
    assert re.search(", set 0( .set 1 is passed over: [^)]*.)?: ", baked(call, path)[1])


def test_a_set_with_u_wrapped_from_1_to_0_is_not_taken(call, tmp_path):
    """A strip of four quads of 0.5 m, the last one 6e-8 wide in the image, as by rounding to float32 before u is wrapped.

    Such a set was taken: one column of texels had all values of the last quad.
    """
    x = np.arange(5, dtype=np.float32)
    wall = np.stack([np.repeat(0.5 * x, 2), np.tile(np.float32([0, 1]), 5), np.zeros(10, np.float32)], axis=1)
    u = np.float32([0, 0.3, 0.6, 1 - 2**-24, 1])
    uv = np.stack([np.repeat(u, 2), np.tile(np.float32([0, 1]), 5)], axis=1)
    faces = np.concatenate([[i, i + 2, i + 3, i, i + 3, i + 1] for i in range(0, 8, 2)]).astype(np.uint16)
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    tree = {"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}], "materials": [{}]}
    path = tmp_path / "in.glb"
    path.write_bytes(glb(tree, [wall, uv, faces]))
    why = "2 faces more than eight texels wide on the mesh are less than one wide in it"
    assert f"new coordinates, set 1 (set 0 is passed over: {why}): " in baked(call, path)[1]


@pytest.mark.parametrize(("times", "why"), [(1.0, r"with 12 times the area of the image"), (3.0, "24 faces reach beyond")])
def test_a_set_of_a_tiling_picture_is_passed_over_at_once(call, tmp_path, times, why, monkeypatch):
    """Its faces each fill the image: the texels of thousands of them took hours, for a set that is not taken."""
    floor = np.float32([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    walls = np.concatenate([floor + np.float32([0, 0, i]) for i in range(12)])
    uv = np.tile(np.float32([(0, 0), (times, 0), (times, times), (0, times)]), (12, 1))
    faces = np.concatenate([np.array([0, 1, 2, 0, 2, 3]) + 4 * i for i in range(12)]).astype(np.uint16)
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    path = tmp_path / "in.glb"
    path.write_bytes(
        glb({"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}], "materials": [{}]}, [walls, uv, faces])
    )
    monkeypatch.setattr(Texels, "points_by_set", lambda *_: pytest.fail("texels of a set that is not taken"))
    assert re.search(rf"set 1 \(set 0 is passed over: [^;]*{why}", baked(call, path)[1])


def test_a_set_that_only_chooses_a_colour_is_not_taken(call, tmp_path):
    """All faces of a box on one tiny place of a palette."""
    box = trimesh.creation.box()
    corners = np.float32(box.vertices[box.faces].reshape(-1, 3))
    uv = np.float32([0.3, 0.3]) + np.tile(np.float32([(0, 0), (3e-4, 0), (0, 3e-4)]), (12, 1))
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}
    path = tmp_path / "in.glb"
    tree = {"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}], "materials": [{}]}
    path.write_bytes(glb(tree, [corners, uv]))
    why = r"faces overlap in 1 of 4 texels \(25.00%\), and auto accepts none; --uv 0 takes it"
    assert re.search(rf", new coordinates, set 1 \(set 0 is passed over: {why}\): ", baked(call, path)[1])


@pytest.mark.parametrize("material", [0, 1])
@pytest.mark.parametrize("uv", ["auto", "new"])
def test_a_primitive_without_an_area_or_a_face_gets_no_picture(call, tmp_path, uv, material):
    """A line as a quad, and a strip of two vertices, beside a good wall, with a material of their own or with its.

    No primitive shows a picture by coordinates that it has not.
    """
    wall = corner()[1]
    arrays = [wall, SQUARE, TWO, wall * np.float32([0, 1, 0]), np.array([0, 1], np.uint16)]
    primitives = [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]
    primitives += [{"attributes": {"POSITION": 3}, "indices": 2, "material": material}]
    primitives += [{"attributes": {"POSITION": 0}, "indices": 4, "mode": 5, "material": 2 * material}]
    tree = {"meshes": [{"primitives": [one]} for one in primitives], "materials": [{}, {}, {}]}
    tree["nodes"] = [{"mesh": i, "name": str(i)} for i in range(3)]
    path = tmp_path / "in.glb"
    path.write_bytes(glb(tree, arrays))
    output, out = baked(call, path, "--uv", uv)
    made = opened(output)[0]
    assert ("new coordinates" in out) == (uv == "new")
    number = 0 if uv == "auto" else 1
    parts = [mesh["primitives"][0] for mesh in made["meshes"]]
    shown = [made["materials"][one["material"]].get("occlusionTexture") for one in parts]
    assert shown[0]["index"] == 0
    assert shown[0].get("texCoord", 0) == number
    fits = [info is None or f"TEXCOORD_{number}" in one["attributes"] for info, one in zip(shown, parts, strict=True)]
    assert all(fits)
    assert shown[2] is None
    assert ("\n  without an area, and so left without a picture: 'meshes[1]', 'meshes[2]'" in out) == bool(material)
    if material:
        assert made["meshes"][1:] == tree["meshes"][1:]


def test_odd_members_stay_as_they_are(call, tmp_path):
    """Extras 400 deep, limits beside a number that is none, and a second set without a first, which new ones leave."""
    wall, deep = corner()[1], 1
    for _ in range(400):
        deep = [deep]
    arrays = [wall, SQUARE, TWO, np.float32([1, np.nan, 2, 3])]
    primitives = [{"attributes": {"POSITION": 0, "TEXCOORD_1": 1, "_T": 3}, "indices": 2, "material": 0}]
    tree = {"meshes": [{"primitives": primitives}], "nodes": [{"mesh": 0}], "materials": [{"extras": deep}], "extras": deep}
    path = tmp_path / "in.glb"
    path.write_bytes(changed(glb(tree, arrays), lambda tree: tree["accessors"][3].update(min=[1], max=[3])))
    made, data, _ = opened(baked(call, path, "--uv", "new")[0])
    attributes = made["meshes"][0]["primitives"][0]["attributes"]
    assert made["extras"] == made["materials"][0]["extras"] == deep
    assert "min" not in made["accessors"][attributes["_T"]]
    assert set(np.unique(array_of(made, data, attributes["TEXCOORD_1"]))) == {0.0, 1.0}
    assert made["materials"][0]["occlusionTexture"] == {"index": 0}


def test_an_occlusion_is_by_the_set_that_its_transform_names(call, tmp_path):
    transform = {"KHR_texture_transform": {"texCoord": 1}}
    attributes = {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 1}
    tree = {"meshes": [{"primitives": [{"attributes": attributes, "indices": 2, "material": 0}]}], "nodes": [{"mesh": 0}]}
    tree["materials"] = [{"occlusionTexture": {"index": 0, "extensions": transform}}]
    path = tmp_path / "in.glb"
    path.write_bytes(glb(tree, [corner()[1], SQUARE, TWO]))
    assert ", set 1: " in baked(call, path)[1]


@pytest.mark.parametrize(
    ("options", "key", "containers"),
    [
        (["--samples", 4], "occlusionTexture", []),
        (["--samples", 4, "--quantity", "bent-normals"], "bentNormalTexture", ["extras"]),
        (["--quantity", "thickness"], "thicknessTexture", ["extensions", "KHR_materials_volume"]),
    ],
)
def test_a_replaced_texture_reference_keeps_its_extras(call, tmp_path, options, key, containers):
    """But no extensions, such as the texture transform of the replaced picture. The other material has no extras."""
    materials = [
        {key: {"index": 0, "extensions": {"KHR_texture_transform": {}}, "extras": {"kept": 1}}},
        {key: {"index": 0}},
    ]
    for container in reversed(containers):
        materials = [{container: material} for material in materials]
    attributes = {"POSITION": 0, "TEXCOORD_0": 1}
    primitives = [{"attributes": attributes, "indices": 2, "material": number} for number in (0, 1)]
    tree = {"meshes": [{"primitives": primitives[:1]}, {"primitives": primitives[1:]}], "materials": materials}
    tree["nodes"] = [{"mesh": 0}, {"mesh": 1, "translation": [0, 9, 0]}]
    path = tmp_path / "in.glb"
    path.write_bytes(glb(tree, [corner()[1], SQUARE, TWO]))
    assert call("bake", path, "-o", tmp_path / "out.glb", "--texture", 8, *options)[0] == 0
    made = opened(tmp_path / "out.glb")[0]["materials"]
    for container in containers:
        made = [material[container] for material in made]
    assert [{**material[key], "index": None} for material in made] == [
        {"index": None, "extras": {"kept": 1}},
        {"index": None},
    ]


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--texture", "big"], "--texture: got 'big', want a size in texels, such as 1024 or 1024x512"),
        (["--texture", 0], "--texture: got 0, want a whole number from 1"),
        (
            ["--texture", 64, "--points", 5],
            "--points: got 5 for --texture; the option applies only to meshes and CityJSON",
        ),
        (["--texture", 64, "--supersample", 0], "--supersample: got 0, want"),
        (["--texture", 64, "--gutter", "some"], "--gutter: got 'some', want 'all' or a whole number"),
        (["--texture", 64, "--strength", 2], "--strength: got 2.0, want a number from 0 to 1"),
        (["--texture", 64, "--uv", "1"], "--uv: got 1, want a set of texture coordinates for all faces of 'brick'"),
        (["--texture", "64x32", "--uv", "new"], "--texture: got 64x32 for new texture coordinates, want a square"),
        (
            ["--texture", 64, "--quantity", "mean-distance"],
            "--output: got '{}/out.glb' for mean-distance, want a file",
        ),
        (["--texture", 64, "--processes", 2], "--processes: got 2 for"),
        (
            ["--texture", 64, "--report", "r.html"],
            "--report: got r.html for --texture; the option applies only to meshes, CityJSON and rasters",
        ),
        (["--uv", "new"], "--uv: got new for in.glb; the option applies only to textures (--texture)"),
        (["--strict"], "--strict: got True for in.glb; the option applies only to textures (--texture)"),
    ],
)
def test_wrong_options_are_named(call, scene, options, why):
    status, _, err = call("bake", scene, "-o", scene.with_name("out.glb"), *options)
    why = why.format(scene.parent)
    assert (status, err.splitlines()[-1][: len(why) + 7]) == (2, f"error: {why}")
    assert [path.name for path in scene.parent.iterdir()] == ["in.glb"]


def test_strips_without_indices_in_two_places_and_glass(call, tmp_path):
    """New coordinates of a strip that a node mirrors and of one that none does; and what is said of the materials."""
    quad = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)], np.float32)
    path = tmp_path / "in.glb"
    placed_twice(path, quad)
    content = changed(path.read_bytes(), lambda tree: tree.update(materials=[{"alphaMode": "BLEND", "doubleSided": True}]))
    path.write_bytes(
        changed(content, lambda tree: [p.update(material=0) for mesh in tree["meshes"] for p in mesh["primitives"]])
    )
    output, out = baked(call, path, "--uv", "new")
    assert "\n  the 2 places of 'meshes[0]' share one picture\n" in out
    assert "\n  two-sided materials show the numbers of the front on both sides: 'materials[0]'\n" in out
    said = "\n  transparent materials block all light, since --transmittance gives them no share: 'materials[0]'\n"
    assert out.endswith(said)
    whole = baked(call, path, "--uv", "new", "--transmittance", "0.25")[1]
    assert (whole.endswith("\n  faces of 'materials[0]' pass 25 % of the light\n"), "block all" in whole) == (True, False)
    np.save(tmp_path / "share.npy", np.linspace(0.1, 0.6, len(ws.load_mesh(path).faces)))
    by_face = baked(call, path, "--uv", "new", "--transmittance", tmp_path / "share.npy")[1]
    assert "\n  faces of 'materials[0]' pass 10 to " in by_face
    baked(call, path, "--uv", "new")
    before, after = ws.load_mesh(path), ws.load_mesh(output)
    assert np.array_equal(before.vertices[before.faces], after.vertices[after.faces])
    uv = ws.load_uv(output, set=2)
    assert np.isfinite(uv).all()
    assert np.array_equal(ws.load_uv(output, set=1)[4:], uv[4:])  # the strip had one set, and is to have no gap
    assert np.array_equal(ws.load_uv(output)[:4], ws.load_uv(path)[:4])
    t = ws.texture_points(after, uv, 64)
    mirrored_once = np.where(np.arange(6)[:, None, None] < 4, np.nan, uv)
    assert ws.texture_points(after, mirrored_once, 64).report.overlapped == 0
    assert t.report.outside == 0


def test_quantised_positions_and_coordinates(call, tmp_path):
    """KHR_mesh_quantization: 16-bit positions that a node scales, 8-bit normals, 16-bit coordinates; all go along."""
    floor = np.array([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    arrays = [(floor * 32767).astype(np.int16), (SQUARE * 65535).astype(np.uint16), TWO]
    arrays.append(np.tile(np.int8([[0, 127, 0]]), (4, 1)))
    padded = [np.pad(arrays[0], ((0, 0), (0, 1))), arrays[1], TWO, np.pad(arrays[3], ((0, 0), (0, 1)))]
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "NORMAL": 3}, "indices": 2}
    tree = {"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0, "scale": [3, 3, 3]}]}
    tree |= {"extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"]}
    path = tmp_path / "in.glb"

    def as_quantised(tree):
        for number, stride in ((0, 8), (3, 4)):
            tree["accessors"][number].update(type="VEC3", normalized=True)
            tree["bufferViews"][number]["byteStride"] = stride

    path.write_bytes(changed(glb(tree, padded), as_quantised))
    for uv in ("auto", "new"):
        output, out = baked(call, path, "--uv", uv, "--normals", "smooth")
        meshes = ws.load_mesh(path), ws.load_mesh(output)
        assert np.array_equal(*(mesh.vertices[mesh.faces] for mesh in meshes))
        assert "mean 1.0000" in out
    made = opened(output)[0]
    attributes = made["meshes"][0]["primitives"][0]["attributes"]
    accessor = made["accessors"][attributes["NORMAL"]]
    assert (accessor["normalized"], accessor["componentType"]) == (True, 5120)
    assert made["bufferViews"][accessor["bufferView"]]["byteStride"] == 4
