"""Bent normals as pictures: in the frames that viewers have, by the file's tangents or by MikkTSpace."""

import io

import numpy as np
import pytest
from glb_files import glb
from PIL import Image
from textured_scenes import SQUARE, TWO, changed, opened, picture, rich

from warpsample.texture.pictures import encode_png
from warpsample.texture.tangents import Frames, compute_tangents

HIGH = 1000.0  # of the wall, which is as good as endless beside a floor of 2
BENT = ("--quantity", "bent-normals", "--texture", 8, "--uv", "0")
REFERENCE = [
    [0.0, 0.0, -1.0, 1.0, 0.998, 0.0, 0.055, 1.0, 0.997, -0.081, 0.0, 1.0],
    [0.998, 0.0, 0.055, 1.0, 0.0, -0.196, 0.981, 1.0, 0.997, -0.081, 0.0, 1.0],
    [0.0, -0.447, 0.894, 1.0, 0.832, 0.0, 0.555, 1.0, 0.949, -0.316, 0.0, 1.0],
    [0.707, 0.0, -0.707, 1.0, 0.0, 0.0, -1.0, 1.0, 0.997, -0.081, 0.0, 1.0],
    [0.999, 0.0, -0.047, -1.0, 0.0, -0.707, 0.707, -1.0, 0.999, -0.052, 0.0, -1.0],
    [0.0, 0.514, -0.857, -1.0, 0.999, 0.0, -0.047, -1.0, 0.999, -0.052, 0.0, -1.0],
    [0.447, 0.0, 0.894, 1.0, 0.0, -0.832, 0.555, 1.0, 0.316, -0.949, 0.0, 1.0],
    [-0.196, -0.784, 0.588, -1.0, -0.196, -0.784, 0.588, -1.0, -0.196, -0.784, 0.588, -1.0],
]
"""Tangents of corners by faces, to three digits."""


def floor_and_wall(path, uv=SQUARE * (1, -1) + (0, 1), tangent=None, scale=(1, 1, 1)):
    """A floor of 2 x 2 with coordinates, or tangents too, beside a high wall without any."""
    floor = np.array([(0, 0, 1), (2, 0, 1), (2, 0, -1), (0, 0, -1)], np.float32)
    wall = np.array([(0, 0, HIGH), (0, 0, -HIGH), (0, HIGH, -HIGH), (0, HIGH, HIGH)], np.float32)
    arrays = [floor, np.float32(uv), TWO, wall, np.tile(np.float32([(0, 1, 0)]), (4, 1))]
    attributes = {"POSITION": 0, "TEXCOORD_0": 1, "NORMAL": 4}
    if tangent is not None:
        arrays.append(np.tile(np.float32([tangent]), (4, 1)))
        attributes["TANGENT"] = 5
    meshes = [{"primitives": [{"attributes": attributes, "indices": 2, "material": 0}]}]
    meshes += [{"primitives": [{"attributes": {"POSITION": 3, "TEXCOORD_0": 1}, "indices": 2, "material": 1}]}]
    tree = {"meshes": meshes, "nodes": [{"mesh": 0, "scale": list(scale)}, {"mesh": 1}]}
    path.write_bytes(glb(tree | {"materials": [{"name": "floor"}, {"name": "wall"}]}, arrays))
    return path


@pytest.mark.parametrize(
    ("made", "x", "y"),
    [
        ({}, 1, 0),
        ({"uv": SQUARE * (-1, -1) + (1, 1)}, -1, 0),  # mirrored
        ({"uv": SQUARE[:, ::-1]}, 0, -1),  # v points away from the wall, downward
        ({"tangent": (0, 0, 1, 1)}, 0, 1),  # the bitangent is N x T = x
        ({"tangent": (0, 0, 1, -1)}, 0, -1),
        ({"tangent": (0, 0, 1, 1), "scale": (-1, 1, 1)}, 0, 1),  # a node that mirrors turns it along, and the wall is on +x
    ],
)
def test_a_high_wall_bends_them_by_32_degrees(call, tmp_path, made, x, y):
    """b = (2 / (3 pi), 0, 1 / 3), the wall on the side of -x: the bytes 196, 128, 235 where the tangent is x."""
    path, output = floor_and_wall(tmp_path / "in.glb", **made), tmp_path / "out.glb"
    status, _, err = call("bake", path, "-o", output, *BENT, "--samples", 4096)
    assert (status, err) == (0, "")
    tree, data, _ = opened(output)
    info = tree["materials"][0]["extras"]["bentNormalTexture"]
    assert tree["images"][info["index"]]["name"] == "floor map of bent normals"
    read = 255 * picture(tree, data, info["index"])
    assert read.shape == (8, 8, 3)
    assert np.abs(read - 127.5 - 127.5 * np.array([0.53702 * x, 0.53702 * y, 0.84356])).max() < 1.5
    # half a step of rounding; the noise of 4,096 rays and what the wall leaves open, 0.002, are below half a step
    assert tree["materials"][0].keys() == {"name", "extras"}


def test_an_open_surface_is_the_normal_in_any_file(call, tmp_path):
    """A .png of a mesh without tangents; and where nothing is open, the normal stands in."""
    path = tmp_path / "in.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n")
    assert call("bake", path, "-o", tmp_path / "out.png", *BENT, "--samples", 4096)[0] == 0
    assert np.abs(np.array(Image.open(tmp_path / "out.png"), int) - (128, 128, 255)).max() <= 1  # by the noise of rays
    nothing = np.array(Image.open(io.BytesIO(encode_png(np.zeros((1, 1, 3)), 8))))
    assert nothing.tolist() == [[[128, 128, 255]]]


def test_the_set_of_the_occlusion_serves(call, tmp_path):
    """A material that has one already is baked by the same set, if there is no other reason."""

    def of_equal_sets(tree):
        attributes = tree["meshes"][0]["primitives"][0]["attributes"]
        attributes["TEXCOORD_0"] = attributes["TEXCOORD_1"]
        del tree["materials"][0]["occlusionTexture"]["extensions"]  # whose transform names the other set

    (tmp_path / "in.glb").write_bytes(changed(rich(), of_equal_sets))
    status, out, _ = call("bake", tmp_path / "in.glb", "-o", tmp_path / "out.glb", *BENT[:4], "--samples", 2)
    assert (status, "'ground', set 1" in out) == (0, True)
    materials = opened(tmp_path / "out.glb")[0]["materials"]
    assert materials[0]["extras"] == {"bentNormalTexture": {"index": 1, "texCoord": 1}}
    assert materials[0]["occlusionTexture"]["index"] == 0


@pytest.mark.parametrize(
    ("options", "change", "why"),
    [
        (["--depth", 16], {}, "--depth: got 16 for bent-normals, want 8, or an .exr"),
        (["--strength", 0.5], {}, "--strength: got 0.5 for bent-normals; the option applies only to occlusion in a .glb"),
        ([], {"extras": [1]}, "mesh: got "),
    ],
)
def test_what_has_no_place_for_them_is_refused(call, tmp_path, options, change, why):
    path = floor_and_wall(tmp_path / "in.glb")
    path.write_bytes(changed(path.read_bytes(), lambda tree: tree["materials"][1].update(change)))
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", *BENT, *options)
    assert (status, err[: 7 + len(why)]) == (2, f"error: {why}")
    assert not change or "materials[1].extras: got [1], want an object" in err


def test_tangents_are_those_of_the_reference():
    """Of an octahedron, mirrored in part, with a hard edge and a chart of its own, by mikktspace 1.1.1: Mikkelsen's code.

    That package of npm gave those of FlightHelmet's 94,722 faces, too, to 3e-5.
    """
    corners = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    faces = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
    uv = np.array([(0.9, 0.5), (0.1, 0.6), (0.4, 0.1), (0.6, 0.8), (0.5, 0.5), (0.3, 0.9)])[faces]
    uv[2, :, 0] += 0.25
    normal = corners[faces]
    normal[7] = np.array([1, -1, -1]) / np.sqrt(3.0)
    found = compute_tangents(corners[faces], normal, uv)
    assert np.abs(found - np.array(REFERENCE).reshape(8, 3, 4)).max() < 5.1e-4  # three digits


def test_frames_stand_in_where_there_are_none():
    """Faces that the image has no area of: some tangent across the normal, so that lengths and the normal's part stay."""
    normals = np.array([[(0.0, 0.6, 0.8)] * 3])
    for tangent in (np.zeros(4), np.full(4, np.nan), np.array([0.0, 0.6, 0.8, 1.0])):
        frames = Frames(normals, np.broadcast_to(tangent, (1, 3, 4)))
        found = frames.to_components(np.eye(3), np.zeros(3, int), np.full((3, 3), 1 / 3))
        assert np.allclose(found @ found.T, np.eye(3), atol=1e-6)
        assert np.allclose(found[:, 2], (0.0, 0.6, 0.8), atol=1e-6)
