"""`warpsample bake in.glb -o out.glb --texture` beneath and inside closed bodies: boxes, rooms and a house of glass."""

import json

import numpy as np
import pytest
import trimesh
from glb_files import glb
from textured_scenes import RAYS, SQUARE, TWO, baked, changed, floor_and_glass, occlusion, opened, picture


def floor_and_box(path, side):
    """A sheet of 8 x 8 with a material, and a closed box that is about it, or stands in its middle; y is up."""
    floor = np.array([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)], np.float32)
    box = trimesh.creation.box((side, side, side))
    arrays = [floor, (SQUARE * (1, -1) + (0, 1)).astype(np.float32), TWO]
    arrays += [np.float32(box.vertices + np.array((0, 0.25 * side, 0))), np.uint16(box.faces).ravel()]
    meshes = [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}]
    meshes += [{"primitives": [{"attributes": {"POSITION": 3}, "indices": 4, "material": 1}]}]
    tree = {"meshes": meshes, "nodes": [{"mesh": 0}, {"mesh": 1}], "materials": [{"name": "floor"}, {"name": "box"}]}
    path.write_bytes(glb(tree, arrays))


@pytest.mark.parametrize(("options", "mean"), [(["--max-distance", 1], 1.0), ([], 0.0)])
def test_a_closed_body_around_all_leaves_its_numbers(call, tmp_path, options, mean):
    """As a dome has that is turned outward: a floor in it sees nothing within 1, and all that it sees is the dome."""
    floor_and_box(tmp_path / "in.glb", 64)
    output, out = baked(call, tmp_path / "in.glb", *options, texture=32)
    tree, data, _ = opened(output)
    assert np.array_equal(np.unique(picture(tree, data, occlusion(tree, 0)["index"])), [mean])
    assert f"'floor', set 0: 1,024 texels, mean {mean:.4f}; " in out
    assert "1,024 points inside closed bodies keep their values, because their whole charts are inside\n" in out


def test_what_stands_on_a_floor_does_not_darken_it(call, tmp_path):
    """Beside a closed box on a sheet: under it the floor is filled from beside it, so that no 0 is read at its foot."""
    path = tmp_path / "in.glb"
    floor_and_box(path, 2)
    output, out = baked(call, path, texture=32)
    tree, data, _ = opened(output)
    image = picture(tree, data, occlusion(tree, 0)["index"])[..., 0]
    assert image.min() > 0.4  # half of the sky at the foot of a wall
    assert "64 points inside closed bodies, filled from their charts" in out  # of 2 x 2 at 4 texels a unit
    assert "\n  with the values that are replaced: mean 0." in out
    status, kept, _ = call("bake", path, "-o", output, "--texture", 32, *RAYS, "--inside", "keep")
    tree, data, _ = opened(output)
    assert (status, picture(tree, data, occlusion(tree, 0)["index"]).min(), "closed bodies" in kept) == (0, 0.0, False)
    status, _, err = call("bake", path, "-o", tmp_path / "small.glb", "--texture", 8)
    said = "error: --texture: got 8, want a larger image: 6 charts with a padding of 4 "
    assert (status, " ".join(err.split())[: len(said)]) == (2, said)


@pytest.mark.parametrize("is_far_first", [False, True])
def test_texels_too_small_at_any_place_are_reported_and_refused(call, tmp_path, is_far_first):
    """Only the first place was looked at: a crate 1,000 km away had texels off by 0.87, without a word."""
    square = np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
    nodes = [{"mesh": 0}, {"mesh": 0, "translation": [1e6, 0, 0]}][:: -1 if is_far_first else 1]
    nodes += [{"mesh": 1, "translation": [3 * i, 0, 0]} for i in range(40)]
    tree = {"meshes": [{"primitives": [{**one, "material": i}]} for i in (0, 1)], "nodes": nodes}
    tree["materials"] = [{"name": "far"}, {"name": "near"}]
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    path.write_bytes(glb(tree, [square, SQUARE, TWO]))
    place = "" if is_far_first else " at place 2"
    said = f"'far': rays resolve lengths above 1.9{place}, and 1,024 points have texels less than 4 times that"
    options = ("--texture", 32, *RAYS, "--uv", 0)
    status, out, _ = call("bake", path, "-o", output, *options)
    assert (status, f"\n  {said}" in out) == (0, True)
    status, _, err = call("bake", path, "-o", output, *options, "--strict")
    assert (status, err.startswith(f"error: --strict: got {said}")) == (2, True)


@pytest.mark.filterwarnings("ignore:mesh. got faces of size")  # it is of most faces; this is of the texels
@pytest.mark.parametrize(("distance", "reports"), [(200, False), (20_000, True)])
def test_texels_too_small_for_float32_are_reported_and_refused(call, tmp_path, distance, reports):
    """A crate of 5 cm and a sheet 20 km away, with a quarter of all corners: what is within 2 cm counts as touching."""
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    floor_and_box(path, 0.05)

    def change(tree):
        tree["nodes"][0]["scale"] = [0.05] * 3
        tree["meshes"].append({"primitives": [{"attributes": {"POSITION": 0}, "indices": 2}]})
        tree["nodes"].append({"mesh": 2, "translation": [distance, 0, 0], "scale": [0.05] * 3})
        tree["scenes"][0]["nodes"].append(2)

    path.write_bytes(changed(path.read_bytes(), change))
    _, out = baked(call, path, "--uv", "new")
    assert ("\n  'floor': rays resolve lengths above 0.019, and 4,096 points have texels less than" in out) == reports
    status, _, err = call("bake", path, "-o", output, "--texture", 64, *RAYS, "--uv", "new", "--strict")
    assert (status, err.startswith("error: --strict: got 'floor': rays resolve")) == ((2, True) if reports else (0, False))


def test_texels_finer_than_float64_positions_are_reported(call, tmp_path):
    """A floor of 2 m at 10^15 m, where neighbouring positions are 0.125 m apart."""
    path = tmp_path / "in.glb"
    floor_and_box(path, 2)

    def move(tree):
        for node in tree["nodes"]:
            node["translation"] = [1e15, 0, 0]

    path.write_bytes(changed(path.read_bytes(), move))
    _, out = baked(call, path)
    assert "rays resolve lengths above 0.12, and 4,096 points have texels less than" in out


def test_positions_under_a_closed_body_are_its_own(call, tmp_path):
    """They are known without rays, so that nothing of them is filled."""
    path, output = tmp_path / "in.glb", tmp_path / "out.npz"
    floor_and_box(path, 2)
    for quantity in ("position", "normals"):
        status, out, err = call("bake", path, "-o", output, "--texture", 32, "--quantity", quantity)
        assert (status, err) == (0, "")
        assert "closed" not in "".join(out.splitlines()[1:])  # the first line names the file
    with np.load(output) as baked_file:
        assert json.loads(str(baked_file["run"]))["texture_inside"] == "fill"


def test_a_floor_that_reaches_out_of_a_room_is_doubtful(call, tmp_path):
    """The box may be a room or a solid: its faces are the same."""
    path, output = floor_and_glass(tmp_path / "in.glb"), tmp_path / "out.glb"
    said = "one chart is more than half inside closed bodies and filled: if a body is a room, pass --inside keep"
    options = ("-o", output, "--texture", 32, "--samples", 16, "--max-distance", 1)
    status, _, err = call("bake", path, *options, "--strict")
    assert (status, err) == (2, f"error: --strict: got 'floor': {said}\n")
    assert not output.exists()
    assert f"\n  {said}\n" in call("bake", path, *options)[1]
    status, out, _ = call("bake", path, *options, "--strict", "--inside", "keep")
    assert (status, said in out) == (0, False)
    status, out, _ = call("bake", floor_and_glass(path, 0.5), *options, "--strict")
    assert (status, said in out, "points inside closed bodies, filled" in out) == (0, False, True)


def test_a_floor_in_a_glass_house_keeps_its_numbers(call, tmp_path):
    """Each ray from the floor crosses one pane, which passes 20 % of its light; and the sentence names the part."""
    path, output = floor_and_glass(tmp_path / "in.glb", 0.5), tmp_path / "out.glb"
    options = ("-o", output, "--texture", 32, "--samples", 16)
    status, out, _ = call("bake", path, *options, "--transmittance", "box=0.2")
    assert (status, "inside closed bodies" in out) == (0, False)
    assert "\n  faces of 'glass' pass 20 % of the light" in out
    tree, data, _ = opened(output)
    shown = picture(tree, data, occlusion(tree, 0)["index"])[10:22, 10:22]
    assert np.abs(shown - 0.2).max() < 1 / 255
    out = call("bake", path, *options, "--transmittance", "floor=0.2")[1]
    said = "transparent materials block all light, since --transmittance does not name their parts 'box': 'glass'"
    assert out.rstrip().endswith(said)
