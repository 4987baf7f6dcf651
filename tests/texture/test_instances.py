"""Meshes in several places of a .glb: what each place shows, and what of the file is copied for it."""

import gc
import tracemalloc
import weakref
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from glb_files import glb
from textured_scenes import SQUARE, TWO, changed, corner, opened, picture

import warpsample as ws
from warpsample.mesh.files.gltf import iterate_primitives
from warpsample.output.textures import bake, comparison
from warpsample.output.textures.comparison import Digest
from warpsample.texture.glb_file import GlbFile

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


def means_of_places(path):
    """The mean of the occlusion that each place of each primitive shows, by node and material's name."""
    tree, data, _ = opened(path)
    found = []
    for one in iterate_primitives(GlbFile(path).part):
        material = tree["materials"][tree["meshes"][one.mesh]["primitives"][one.number]["material"]]
        info = material["occlusionTexture"]
        found.append((one.node.path, material["name"], picture(tree, data, info["index"]).mean().round(2)))
    return found


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


@pytest.mark.parametrize(("uv", "texture"), [("0", 128), ("new", 512)])  # charts of 2 x 80 fill a corner of the latter
def test_places_that_look_alike_share_a_picture(call, tmp_path, uv, texture):
    """A floor beside a wall, and its mirror image far away: by either coordinates texels are at the same places of both."""
    arrays = [*corner(), SQUARE, TWO]
    meshes = [{"primitives": [{"attributes": {"POSITION": i, "TEXCOORD_0": 2}, "indices": 3} for i in (0, 1)]}]
    tree = {"meshes": meshes, "nodes": [{"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1], "translation": [-1e3, 0, 0]}]}
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    path.write_bytes(changed(glb(tree, arrays), lambda tree: tree["meshes"][0]["primitives"][1].update(material=0)))
    path.write_bytes(changed(path.read_bytes(), lambda tree: tree.update(materials=[{}])))
    status, out, err = call("bake", path, "-o", output, "--texture", texture, "--samples", 16, "--uv", uv)
    assert (status, err) == (0, "")
    assert out.count("share one picture") == 2
    assert len(opened(output)[0]["meshes"]) == 1


def test_places_that_differ_clearly_are_compared_by_their_digests(call, tmp_path, monkeypatch):
    """Each pair was compared texel by texel: with 400 places of 512 x 512 texels for 46 minutes. The files are equal."""
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    turn = (0.0, np.sin(0.3), 0.0, np.cos(0.3))
    nodes = [
        {"mesh": 0, "translation": [0, 1 + i % 3, 2.2 * i], "rotation": turn if i % 2 else (0, 0, 0, 1)} for i in range(7)
    ]
    one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
    meshes = [{"primitives": [{**one, "material": 0}]}, {"primitives": [{**one, "material": 1}]}]
    nodes.append({"mesh": 1, "translation": [0, 4, 6], "scale": [1, 1, 6]})
    tree = {"meshes": meshes, "materials": [{}, {}], "nodes": nodes}
    (tmp_path / "in.glb").write_bytes(glb(tree, [square, SQUARE, TWO]))
    full, seen, files = comparison.do_pictures_differ, [], []
    monkeypatch.setattr(comparison, "do_pictures_differ", lambda *pair: seen.append(pair) or full(*pair))
    for differ in (Digest.differ, lambda *_: False):
        monkeypatch.setattr(Digest, "differ", differ)
        command = ("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", "--texture", 32, "--samples", 256, "--uv", "0")
        assert call(*command)[0] == 0
        files.append(((tmp_path / "out.glb").read_bytes(), len(seen)))
    assert files[0][0] == files[1][0]
    assert files[0][1] < 5  # of 20
    assert files[1][1] > 20


def lids(path, heights, materials=1):
    """Squares in a row, as places of one mesh or as meshes of their own material, below a lid at the given heights."""
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
    meshes = [{"primitives": [{**one, "material": number}]} for number in range(materials + 1)]
    nodes = [{"mesh": i % materials, "translation": [9 * i, 0, 0]} for i in range(len(heights))]
    nodes += [{"mesh": materials, "translation": [9 * i, height, 0]} for i, height in enumerate(heights)]
    tree = {"meshes": meshes, "nodes": nodes, "materials": [{"name": f"m{number}"} for number in range(materials + 1)]}
    path.write_bytes(glb(tree, [square, SQUARE, TWO]))
    return path


@pytest.mark.parametrize("materials", [1, 8])
@pytest.mark.parametrize("instances", ["split", "mean"])
def test_images_and_points_are_held_for_few_pictures(call, tmp_path, monkeypatch, materials, instances):
    """Those of all pictures were held until the file was written: 24 materials of 2048 x 2048 texels took 3.4 GB."""
    fill, alive, seen = bake.fill_texture, weakref.WeakSet(), []

    def filled(job, points, **more):
        found = fill(job, points, **more)
        alive.update([points, found[1]])
        gc.collect()
        seen.append(len(alive))
        return found

    monkeypatch.setattr(bake, "fill_texture", filled)
    monkeypatch.setattr(comparison, "_HELD", 1)
    path = lids(tmp_path / "in.glb", [0.2 + 0.2 * i for i in range(8)], materials)
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", *RAYS, "--uv", 0, "--instances", instances)
    assert (status, err) == (0, "")
    assert len(seen) >= 16
    assert max(seen) <= 4


def test_a_picture_to_compare_with_holds_little_memory():
    """Parts of arrays of a digest were views that held whole arrays: 31 bytes per texel in place of 14."""
    side, rng = 512, np.random.default_rng(0)
    known, everywhere = comparison.KnownPictures(8), np.ones((side, side), np.bool_)
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    for number in range(4):
        value, errors = rng.random((side, side), np.float32), np.full((2, side, side), 0.01, np.float32)
        points = SimpleNamespace(covered=everywhere.copy())
        found = known.find_or_add(SimpleNamespace(value=value, noise=(*errors,), own=everywhere.copy(), points=points))
        assert found == number
    del value, errors, points
    held = (tracemalloc.get_traced_memory()[0] - before) / (4 * side**2)
    tracemalloc.stop()
    assert 14.0 < held < 17.0  # bytes per texel


def test_places_share_a_picture_among_the_last_that_memory_holds(call, tmp_path, monkeypatch):
    """Of places a b a a, memory for one picture lets the last two share; each place shows its own occlusion."""
    path, output = lids(tmp_path / "in.glb", [0.1, 1.5, 0.1, 0.1]), tmp_path / "out.glb"
    shown = []
    for held, pictures in ((1 << 30, 2), (1, 3)):
        monkeypatch.setattr(comparison, "_HELD", held)
        status, out, _ = call("bake", path, "-o", output, *RAYS, "--uv", 0)
        assert (status, f"show {pictures} pictures, by copies" in out) == (0, True)
        shown.append([(node, value) for node, name, value in means_of_places(output) if name.startswith("m0")])
    assert shown[0] == shown[1]
    assert shown[0][0][1] + 0.2 < shown[0][1][1]


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


def test_whole_pictures_with_few_rays_that_differ_are_distinguished(call, tmp_path):
    """Floors in the open and beneath a distant sheet, with 2 rays a texel: blocks differ by less than their errors."""
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    floor = np.array([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)], np.float32)
    arrays = [floor, SQUARE, TWO, floor + np.float32([400, 15, 0])]
    sheets = [{"attributes": {"POSITION": at, "TEXCOORD_0": 1}, "indices": 2, "material": 0} for at in (0, 3)]
    del sheets[1]["material"]
    tree = {"meshes": [{"name": "floor", "primitives": sheets[:1]}, {"primitives": sheets[1:]}]}
    tree |= {"nodes": [{"mesh": 0}, {"mesh": 0, "translation": [400, 0, 0]}, {"mesh": 1}], "materials": [{"name": "floor"}]}
    path.write_bytes(glb(tree, arrays))
    status, out, _ = call("bake", path, "-o", output, "--texture", 64, "--samples", 2)
    assert (status, "show 2 pictures" in out) == (0, True)
    tree["nodes"][1]["translation"] = [-400, 0, 0]  # in the open, too
    path.write_bytes(glb(tree, arrays))
    status, out, _ = call("bake", path, "-o", output, "--texture", 64, "--samples", 2)
    assert (status, "share one picture" in out) == (0, True)


def floors_with_plates(path, plates, box_at=None):
    """One floor of 32 x 32, in rows of a scene, each with a plate of 1.2 x 1.2 just above it at the given x, or none.

    At place number `box_at`, the plate is the top of a box that reaches through the floor.
    """
    square = np.array([(-16, 0, 16), (16, 0, 16), (16, 0, -16), (-16, 0, -16)], np.float32)
    tree = {"meshes": [{"name": "floor", "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}]}]}
    tree["meshes"][0]["primitives"][0]["material"] = 0
    tree["meshes"] += [{"primitives": [{"attributes": {"POSITION": 3}, "indices": 2}]}]
    tree |= {"nodes": [{"mesh": 0, "translation": [200 * k, 0, 0]} for k in range(len(plates))], "materials": [{}]}
    tree["nodes"] += [{"mesh": 1, "translation": [200 * k + x, 0.3, 2.5]} for k, x in enumerate(plates) if x is not None]
    arrays = [square, SQUARE, TWO, np.float32(0.6 / 16) * square]
    if box_at is not None:
        box = trimesh.creation.box((1.2, 0.6, 1.2)).apply_translation([0, -0.3, 0])
        arrays += [np.float32(box.vertices), np.uint16(box.faces).ravel()]
        tree["meshes"] += [{"primitives": [{"attributes": {"POSITION": 4}, "indices": 5}]}]
        tree["nodes"][len(plates) + box_at]["mesh"] = 2
    path.write_bytes(glb(tree, arrays))
    return path


@pytest.mark.parametrize(
    ("plates", "options", "pictures"),
    [
        ((1.5, 4.5), (256,), 2),  # in one block of 8 x 8 texels: its mean stays
        ((None, 1.5), (256,), 2),
        ((1.5, 1.5, 1.5), (256,), 1),
        ((None, 2.0), (64, "--supersample", 4), 2),  # above halves of two texels, whose values vary from 0 to 1
        ((2.0, 2.0), (64, "--supersample", 4), 1),
    ],
)
def test_shadows_that_move_within_a_block_are_seen(call, tmp_path, plates, options, pictures):
    path = floors_with_plates(tmp_path / "in.glb", plates)
    status, out, _ = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 32, "--samples", *options)
    found = "share one picture" if pictures == 1 else f"show {pictures} pictures"
    assert (status, f"the {len(plates)} places of 'floor' {found}" in out) == (0, True)


@pytest.mark.parametrize("box_at", [0, 1])
def test_a_texel_inside_a_body_at_one_place_is_compared(call, tmp_path, box_at):
    """A box covers one texel at one place. A sheet of the same outline at the other place makes it dark, but visible."""
    path, output = floors_with_plates(tmp_path / "in.glb", (1.5, 1.5), box_at), tmp_path / "out.glb"
    status, out, _ = call("bake", path, "-o", output, "--texture", 32, "--samples", 32)
    assert (status, "the 2 places of 'floor' show 2 pictures" in out) == (0, True)
    tree, data, _ = opened(output)
    shown = []
    for node in tree["nodes"][:2]:
        material = tree["materials"][tree["meshes"][node["mesh"]]["primitives"][0]["material"]]
        shown.append(picture(tree, data, material["occlusionTexture"]["index"])[13, 17, 0])
    assert shown[box_at] > 0.7  # that of its neighbours
    assert shown[1 - box_at] < 0.3


@pytest.mark.parametrize("sheet", [0.0, 2.0])  # within the thin box of one place, or above it
def test_exact_numbers_are_compared_by_the_levels_of_the_picture(call, tmp_path, sheet):
    """Half of a thickness of 0.006 is missing beside a thickness of 3: less than a level of 8 bits."""
    thin = trimesh.creation.box((0.4, 0.006, 0.4)).apply_translation([5, 0, 0])
    both = trimesh.util.concatenate([trimesh.creation.box((1, 3, 2)), thin])
    arrays = [np.float32(both.vertices), np.uint16(both.faces).ravel(), TWO]
    arrays += [np.float32([(4.7, 0, 0.3), (5.3, 0, 0.3), (5.3, 0, -0.3), (4.7, 0, -0.3)])]
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}]
    meshes += [{"primitives": [{"attributes": {"POSITION": 3}, "indices": 2}]}]
    nodes = [{"mesh": 0}, {"mesh": 0, "translation": [20, 0, 0]}, {"mesh": 1, "translation": [20, sheet, 0]}]
    volume = {"extensions": {"KHR_materials_volume": {}}}
    path = tmp_path / "in.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": nodes, "materials": [volume]}, arrays))
    options = ("--texture", 64, "--quantity", "thickness", "--uv", "new")
    for depth, differs in ((8, False), (16, sheet == 0.0)):
        status, out, _ = call("bake", path, "-o", tmp_path / "out.glb", *options, "--depth", depth)
        assert (status, "show 2 pictures" in out, "share one picture" in out) == (0, differs, not differs)


@pytest.mark.parametrize("options", [(16,), (64, "--supersample", 2), (64, "--quantity", "bent-normals")])
def test_turned_places_share_a_picture(call, tmp_path, options):
    """Floors below crates: texels that are filled with one neighbour's value have one error together.

    The axes of tangents turn with the places, and those of the errors do not.
    """
    floor = np.array([(-2, 0, 2), (2, 0, 2), (2, 0, -2), (-2, 0, -2)], np.float32)
    crate = trimesh.creation.box((1, 1, 1)).apply_translation([-0.8, 0.45, -0.5])
    arrays = [floor, SQUARE, TWO, np.float32(crate.vertices), np.uint16(crate.faces).ravel()]
    meshes = [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}]
    meshes += [{"primitives": [{"attributes": {"POSITION": 3}, "indices": 4}]}]
    half = np.array([0.0, 0.7, np.pi / 2, 2.1]) / 2
    places = [{"translation": [300 * k, 0, 0], "rotation": [0, np.sin(a), 0, np.cos(a)]} for k, a in enumerate(half)]
    nodes = [{"mesh": mesh, **place} for place in places for mesh in (0, 1)]
    path = tmp_path / "in.glb"
    path.write_bytes(glb({"meshes": meshes, "nodes": nodes, "materials": [{}]}, arrays))
    status, out, _ = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 64, "--samples", *options)
    assert (status, out.count("the 4 places of"), out.count("share one picture")) == (0, 2, 2)


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
