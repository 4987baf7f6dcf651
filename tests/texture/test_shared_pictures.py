"""Which places of a mesh of a .glb share a picture, and how much memory the comparison takes."""

import gc
import tracemalloc
import weakref
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from glb_files import glb
from textured_scenes import SQUARE, TWO, changed, corner, means_of_places, opened, picture

from warpsample.output.textures import bake, comparison
from warpsample.output.textures.comparison import Digest

RAYS = ("--texture", 64, "--samples", 64)


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
    gc.freeze()  # the collections below would look at all that other tests left: 10 s

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


@pytest.mark.parametrize("length", [1.0, 3e-3])
def test_directions_of_dark_places_are_compared(length):
    """Pictures store directions, so a level of the picture is a difference of directions, also of short vectors."""
    rng, shape, mask = np.random.default_rng(0), (16, 16, 3), np.ones((16, 16), bool)

    def image_of(x):
        value = length * (np.array([x, 0.0, np.sqrt(1.0 - x * x)]) + 0.01 * rng.standard_normal(shape))
        errors = np.full(shape, 0.01 * length, np.float32)
        return comparison.Compared(value.astype(np.float32), (errors, errors), mask, mask)

    assert comparison.do_pictures_differ(image_of(0.5), image_of(-0.5), 8)
    assert not comparison.do_pictures_differ(image_of(0.5), image_of(0.5), 8)
