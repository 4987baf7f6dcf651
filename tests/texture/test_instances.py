"""Meshes in several places of a .glb: what each place shows, their coordinates, and what of the file is copied."""

import numpy as np
import pytest
import trimesh
from glb_files import glb
from textured_scenes import SQUARE, TWO, changed, means_of_places, opened

import warpsample as ws

RAYS = ("--texture", 64, "--samples", 64)


def rooms(path, count=3):
    """Sheets of a mesh of two primitives: the first in a closed box, the others in the open; the box has no material."""
    floor = np.array([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)], np.float32)
    box = trimesh.creation.box((64, 64, 64))
    arrays = [floor, SQUARE, TWO, np.float32(box.vertices), np.uint16(box.faces).ravel(), floor + np.float32([0, 9, 0])]
    sheets = [{"attributes": {"POSITION": at, "TEXCOORD_0": 1}, "indices": 2, "material": i} for i, at in enumerate((0, 5))]
    tree = {
        "meshes": [{"name": "sheets", "primitives": sheets}, {"primitives": [{"attributes": {"POSITION": 3}, "indices": 4}]}]
    }
    tree["nodes"] = [{"mesh": 0, "translation": [x, 0, 0]} for x in (0, 400, -400)[:count]] + [{"mesh": 1}]
    tree["materials"] = [{"name": "lower", "extras": {"kept": 1}}, {"name": "upper"}]
    path.write_bytes(glb(tree, arrays))
    return path


def test_a_place_in_the_open_does_not_get_the_0_of_its_twin_in_a_closed_box(call, tmp_path):
    path, output = rooms(tmp_path / "in.glb"), tmp_path / "out.glb"
    status, out, err = call("bake", path, "-o", output, *RAYS, "--strict")
    assert (status, err) == (0, "")
    assert "\n  the 3 places of 'sheets' show 2 pictures, by copies of meshes and materials\n" in out
    shown = means_of_places(output)
    assert [value for node, _, value in shown if node == "nodes[0]"] == [0.0, 0.0]
    below = [value for node, name, value in shown if node in ("nodes[1]", "nodes[2]") and name == "lower"]
    assert below[0] == below[1]
    assert 0.5 < below[0] < 1.0  # beneath the upper sheet
    assert [value for node, name, value in shown if node in ("nodes[1]", "nodes[2]") and name == "upper"] == [1.0, 1.0]
    before, after = opened(path)[0], opened(output)[0]
    assert [node["mesh"] for node in after["nodes"]] == [0, 2, 2, 1]
    assert [(one["name"], one.get("extras")) for one in after["materials"]][:2] == [("lower", {"kept": 1}), ("upper", None)]
    assert len(after["meshes"]) == 3
    geometry = [[(one["attributes"], one["indices"]) for one in mesh["primitives"]] for mesh in after["meshes"]]
    assert geometry[0] == geometry[2] == [(one["attributes"], one["indices"]) for one in before["meshes"][0]["primitives"]]
    made, given = ws.load_mesh(output), ws.load_mesh(path)
    assert np.array_equal(made.vertices[made.faces], given.vertices[given.faces])


def test_the_mean_of_all_places_is_one_picture(call, tmp_path):
    path, output = rooms(tmp_path / "in.glb", 2), tmp_path / "out.glb"
    status, out, _ = call("bake", path, "-o", output, *RAYS, "--instances", "mean")
    assert status == 0
    assert "\n  the 2 places of 'sheets' share one picture\n" in out
    assert {value for _, name, value in means_of_places(output) if name == "upper"} == {0.5}
    assert len(opened(output)[0]["meshes"]) == 2
    status, _, err = call("bake", path, "-o", output, *RAYS, "--instances", "mean", "--strict")
    assert (status, err[:69]) == (2, "error: --strict: got --instances mean for 'sheets' in several places,")
    status, _, err = call("bake", path, "-o", tmp_path / "out.npz", *RAYS, "--instances", "mean")
    assert (status, "--instances: got mean for out.npz; the option applies only to .glb and .gltf" in err) == (2, True)


@pytest.mark.parametrize("nodes", [[{}, {"translation": [40, 0, 0]}], [{"scale": [0, 1, 0]}, {}, {"scale": [0, 0, 0]}]])
def test_a_place_without_values_has_no_part_in_the_mean(call, tmp_path, nodes):
    """It counted as 0: with a finer mesh at one of two places, a free square was half black."""
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    tree = {"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}]}
    tree |= {"nodes": [{"mesh": 0, **node} for node in nodes], "materials": [{"name": "square"}]}
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    path.write_bytes(glb(tree, [square, SQUARE, TWO]))
    fine = trimesh.Trimesh(square + np.float32([0, 0.01, 0]), TWO.reshape(2, 3), process=False)
    fine.export(tmp_path / "fine.ply")
    options = ("--instances", "mean", "--high", tmp_path / "fine.ply", "--cage", 0.1, "--uv", "0")
    status, out, err = call("bake", path, "-o", output, *RAYS, *options)
    assert (status, err) == (0, "")
    assert "mean 1.0000; standard error" in out
    assert {value for _, _, value in means_of_places(output)} == {1.0}


@pytest.mark.parametrize("uv", ["auto", "new"])
def test_a_first_place_of_scale_0_hides_no_other_place(call, tmp_path, uv):
    """The second place is beneath a sheet, the third one, of scale 0, again shows nothing."""
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    floor = np.array([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)], np.float32)
    arrays = [floor, SQUARE, TWO, 10 * floor + np.float32([400, 9, 0])]
    sheets = [{"attributes": {"POSITION": at, "TEXCOORD_0": 1}, "indices": 2, "material": 0} for at in (0, 3)]
    nodes = [{"mesh": 0, "scale": [0, 0, 0]}, {"mesh": 0, "translation": [400, 0, 0]}, {"mesh": 1}]
    nodes.append({"mesh": 0, "scale": [0, 0, 0]})
    tree = {"meshes": [{"name": "floor", "primitives": sheets[:1]}, {"primitives": sheets[1:]}], "nodes": nodes}
    tree["meshes"][1]["primitives"][0]["material"] = 1
    tree["materials"] = [{"name": "floor"}, {"name": "roof"}]
    path.write_bytes(glb(tree, arrays))
    options = (*RAYS, "--uv", uv, "--instances", "mean", "--strict")  # one visible place is not several
    status, out, err = call("bake", path, "-o", output, *options)
    assert (status, err) == (0, "")
    assert "without an area" not in out
    shown = {(node, name): value for node, name, value in means_of_places(output)}
    assert 0.0 < shown["nodes[1]", "floor"] < 0.1  # a roof 80 wide at a height of 9
    assert shown["nodes[2]", "roof"] == 1.0


@pytest.mark.parametrize("height", [0.0, 1e-9, 5e-5, 1e-3])
@pytest.mark.parametrize("is_first", [False, True])
def test_a_flattened_place_does_not_decide_about_coordinates(call, tmp_path, height, is_first):
    """The sides of a crate had no texels, or a strip of one texel, if the crate's first place was its shadow."""
    box = trimesh.creation.box()
    mesh = {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}
    nodes = [{"mesh": 0, "scale": [1, height, 1], "translation": [5, 0, 0]}, {"mesh": 0}][:: 1 if is_first else -1]
    corners = np.float32(box.vertices[box.faces]).reshape(-1, 3)
    flat = np.full((12, 3, 2), 0.5, np.float32)  # its sides have no area
    flat[np.abs(box.face_normals[:, 1]) > 0.5] = [[0.1, 0.1], [0.9, 0.1], [0.1, 0.9]]
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    arrays = [corners, flat.reshape(-1, 2), np.arange(36, dtype=np.uint16)]
    path.write_bytes(glb({"meshes": [mesh], "materials": [{}], "nodes": nodes}, arrays))
    status, _, err = call("bake", path, "-o", output, "--texture", 64, "--samples", 4, "--uv", 0, "--strict")
    assert (status, "faces without an area in the image: 8" in err) == (2, True)
    status, out, _ = call("bake", path, "-o", output, "--texture", 128, "--samples", 4)
    assert (status, "set 0 is passed over" in out) == (0, True)
    uv = ws.load_uv(output, set=1)[:12]
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    areas = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    assert areas.min() > 0.8 * areas.max()


def test_meshes_of_one_material_in_different_numbers_of_places_are_each_counted(call, tmp_path):
    """The report had "the 5 places of" both."""
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    meshes = [
        {"name": "ab"[i], "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1 + i}, "indices": 3, "material": 0}]}
        for i in (0, 1)
    ]
    nodes = [{"mesh": i, "translation": [3 * k, 0, 9 * i]} for i, count in ((0, 2), (1, 5)) for k in range(count)]
    arrays = [square, 0.4 * np.float32(SQUARE), 0.5 + 0.4 * np.float32(SQUARE), TWO]
    path = tmp_path / "in.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": nodes, "materials": [{}]}, arrays))
    _, out, _ = call("bake", path, "-o", tmp_path / "out.glb", *RAYS, "--uv", 0)
    assert "\n  the 2 places of 'a' and the 5 places of 'b' share one picture\n" in out


def test_flaws_of_coordinates_count_at_all_places(call, tmp_path):
    """Of a cube as a floor and as a wall, with two sides that have no area in the file's coordinates."""
    box = trimesh.creation.box()
    corners, uv = np.float32(box.vertices[box.faces]).reshape(-1, 3), np.full((12, 3, 2), 0.5, np.float32)
    cells = np.arange(12).reshape(-1, 1) // np.array([4, 1]) % np.array([3, 4])
    has_area = np.abs(box.face_normals[:, 0]) < 0.5
    uv[has_area] = (cells[:, None] / 4 + np.array([[0.01, 0.01], [0.2, 0.01], [0.01, 0.2]]))[has_area]
    mesh = {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}
    nodes = [{"mesh": 0, "scale": [2, 5e-5, 2]}, {"mesh": 0, "scale": [5e-5, 2, 2], "translation": [9, 0, 0]}]
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    arrays = [corners, uv.reshape(-1, 2), np.arange(36, dtype=np.uint16)]
    path.write_bytes(glb({"meshes": [mesh], "materials": [{}], "nodes": nodes}, arrays))
    options = ("--texture", 64, "--samples", 4)
    status, _, err = call("bake", path, "-o", output, *options, "--uv", 0, "--strict")
    assert (status, "with faces without an area in the image: 4" in err) == (2, True)
    status, out, _ = call("bake", path, "-o", output, *options)
    assert (status, "set 0 is passed over: faces have no area in it" in out) == (0, True)
    status, out, _ = call("bake", path, "-o", output, *options, "--uv", 0, "--instances", "mean")
    assert (status, out.count("faces without an area in the image: 4")) == (0, 1)


@pytest.mark.parametrize("instances", ["split", "mean"])
@pytest.mark.parametrize("uv", ["0", "new"])
def test_a_mesh_hidden_at_all_its_places_stops_nothing(call, tmp_path, instances, uv):
    """By a scale of 0, as of animations; with the material of a visible mesh, the bake ended with a message of NumPy."""
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    nodes = [{"mesh": 0}, *({"mesh": 1, "translation": [x, 0, 0], "scale": [0, 0, 0]} for x in (3, 6))]
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    tree = {"meshes": [{"primitives": [one]}, {"primitives": [one]}], "materials": [{"name": "a"}], "nodes": nodes}
    path.write_bytes(glb(tree, [square, SQUARE, TWO]))
    status, out, err = call("bake", path, "-o", output, *RAYS, "--uv", uv, "--instances", instances)
    assert (status, err, "in one picture" in out) == (0, "", True)
    assert [value for _, _, value in means_of_places(output)] == [1.0, 1.0, 1.0]


@pytest.mark.parametrize("instances", ["split", "mean"])
def test_places_without_a_texel_show_the_picture_of_their_material(call, tmp_path, instances):
    """A face outside the image at two places, with the material of a floor, ended the bake with a message of Python."""
    square, beyond = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]), np.float32(SQUARE) + 3.0
    meshes = [
        {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": uv}, "indices": 3, "material": 0}]} for uv in (1, 2)
    ]
    tree = {"meshes": meshes, "materials": [{}], "nodes": [{"mesh": 0}]}
    tree["nodes"] += [{"mesh": 1, "translation": [0, height, 0]} for height in (50, 90)]
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    path.write_bytes(glb(tree, [square, np.float32(SQUARE), beyond, TWO]))
    status, _, err = call("bake", path, "-o", output, *RAYS, "--uv", 0, "--instances", instances)
    assert (status, err) == (0, "")
    assert len(opened(output)[0]["materials"]) == 1


@pytest.mark.parametrize("instances", ["split", "mean"])
def test_a_chart_that_is_mostly_inside_a_body_at_one_place_is_reported(call, tmp_path, instances):
    """A slab, too low to shade the floor, covers more than half of the floor at the second place."""
    floor = np.array([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)], np.float32)
    slab = trimesh.creation.box((6.5, 2e-3, 6.5))
    arrays = [floor, SQUARE, TWO, np.float32(slab.vertices), np.uint16(slab.faces).ravel()]
    meshes = [
        {"name": "floor", "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}
    ]
    meshes += [{"primitives": [{"attributes": {"POSITION": 3}, "indices": 4}]}]
    nodes = [{"mesh": 0}, {"mesh": 0, "translation": [40, 0, 0]}, {"mesh": 1, "translation": [40, 0, 0]}]
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": nodes, "materials": [{}]}, arrays))
    command = ("bake", path, "-o", output, "--texture", 32, "--samples", 16, "--instances", instances)
    status, out, err = call(*command)
    assert (status, err, "the 2 places of 'floor' share one picture" in out) == (0, "", True)
    assert "676 points inside closed bodies, filled" in out  # 26 x 26 texels
    warning = "one chart is more than half inside closed bodies and filled: if a body is a room, pass --inside keep"
    assert warning in out
    status, _, err = call(*command, "--strict")
    assert (status, err.startswith("error: --strict: got"), warning in err) == (2, True, instances == "split")


def test_animations_of_a_material_reach_its_copies(call, tmp_path):
    """KHR_animation_pointer names materials by number: copies go to other places, and to a mesh outside the scene.

    Only the material outside the scene keeps its occlusion texture, and so the animation of the texture transform.
    """
    path, output = rooms(tmp_path / "in.glb", 2), tmp_path / "out.glb"
    offset = "occlusionTexture/extensions/KHR_texture_transform/offset"

    def pointing(to):
        return {"sampler": 0, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": to}}}}

    def share_materials(tree):
        tree["meshes"].append({"primitives": tree["meshes"][0]["primitives"]})
        named = "/materials/0/emissiveFactor", "/meshes/0/weights", "/materials/10/alphaCutoff"
        nodes = {"sampler": 0, "target": {"node": 0, "path": "scale"}}
        channels = [*map(pointing, named), nodes, pointing(f"/materials/0/{offset}")]
        tree["animations"] = [{"channels": channels, "samplers": [{"input": 0, "output": 0}]}]
        tree["materials"][0]["occlusionTexture"] = {"index": 0, "extensions": {"KHR_texture_transform": {}}}
        tree |= {"textures": [{"source": 0}], "images": [{"uri": "data:image/png;base64,iVBORw0KGgo="}]}
        tree["extensionsUsed"] = ["KHR_texture_transform", "KHR_animation_pointer"]

    path.write_bytes(changed(path.read_bytes(), share_materials))
    status, out, err = call("bake", path, "-o", output, *RAYS, "--strict")
    assert (status, err) == (0, "")
    assert out.count("the animation of the occlusion of material 'lower' is left out") == 1
    tree = opened(output)[0]
    used = [[one["material"] for one in mesh["primitives"]] for mesh in tree["meshes"]]
    assert (used[0], [mesh for mesh in range(4) if 0 in used[mesh]]) == ([0, 1], [0])
    assert ["occlusionTexture" in tree["materials"][number] for number in used[2]] == [True, False]  # outside the scene
    assert ["occlusionTexture" in tree["materials"][number] for number in used[3]] == [True, True]  # the other place
    assert tree["nodes"][1]["mesh"] == 3
    channels = tree["animations"][0]["channels"]
    copies = [used[mesh][used[0].index(0)] for mesh in (2, 3)]
    copied = ["/meshes/3/weights", f"/materials/{used[2][0]}/{offset}"]
    copied += [f"/materials/{number}/emissiveFactor" for number in copies]
    assert sorted(map(str, channels[4:])) == sorted(str(pointing(to)) for to in copied)
