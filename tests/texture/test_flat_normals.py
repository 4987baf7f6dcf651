"""Normals of .glb files without NORMAL: viewers use flat normals and ignore tangents (glTF 2.0, 3.7.2.1)."""

import numpy as np
import pytest
from glb_files import glb
from textured_scenes import opened, picture

import warpsample as ws

ROOF = np.float32([(-1, 0, 0), (-1, 2, 0), (0, 0, 1), (0, 2, 1), (1, 0, 0), (1, 2, 0)])
FACES = np.array([(0, 2, 1), (1, 2, 3), (2, 4, 3), (3, 4, 5)], np.uint16)
UV = np.float32([(0, 1), (0, 0), (0.5, 1), (0.5, 0), (1, 1), (1, 0)])
SIZE = 16


def roof(path, *, tangent=False, beside=False):
    """A roof whose faces share their vertices, perhaps with tangents, or beside a roof with normals."""
    arrays = [ROOF, UV, FACES.ravel(), np.tile(np.float32([0.6, 0.8, 0, -1]), (6, 1)), ROOF + np.float32([90, 0, 0])]
    arrays.append(np.tile(np.float32([0, 0, 1]), (6, 1)))
    attributes = {"POSITION": 0, "TEXCOORD_0": 1} | ({"TANGENT": 3} if tangent else {})
    other = {"attributes": {"POSITION": 4, "TEXCOORD_0": 1, "NORMAL": 5}, "indices": 2, "material": 1}
    primitives = [{"attributes": attributes, "indices": 2, "material": 0}, *([other] if beside else [])]
    tree = {"meshes": [{"name": "roof", "primitives": primitives}], "nodes": [{"mesh": 0}], "materials": [{}, {}]}
    path.write_bytes(glb(tree, arrays))
    return path


def bake(call, path, quantity, *options):
    """The bytes of the roof's picture, (H, W, 3), and the report."""
    command = ("bake", path, "-o", path.with_name("out.glb"), "--texture", SIZE, "--uv", 0, "--quantity", quantity)
    status, out, err = call(*command, *options)
    assert (status, err) == (0, "")
    tree, data, _ = opened(path.with_name("out.glb"))
    holder = tree["materials"][0] if quantity == "normals" else tree["materials"][0]["extras"]
    info = holder["normalTexture" if quantity == "normals" else "bentNormalTexture"]
    return 255 * picture(tree, data, info["index"]), out


@pytest.mark.parametrize("more", [{}, {"tangent": True}, {"beside": True}])
@pytest.mark.parametrize(("quantity", "options"), [("normals", ()), ("bent-normals", ("--samples", 4096))])
def test_the_frame_is_that_of_flat_normals(call, tmp_path, quantity, options, more):
    """A roof is convex: the mean open direction of a face is the normal of the face. Before, up to 61 degrees from it."""
    read, out = bake(call, roof(tmp_path / "in.glb", **more), quantity, *options)
    assert np.abs(read - (128, 128, 255)).max() <= 1  # by the noise of 4,096 rays
    assert "without NORMAL, and so baked for the flat normals of viewers: 'roof'" in out


@pytest.mark.parametrize("beside", [False, True])
def test_smooth_normals_decode_in_the_flat_frame(call, tmp_path, beside):
    path = roof(tmp_path / "in.glb", beside=beside)
    read, _ = bake(call, path, "normals", "--normals", "smooth")
    mesh = ws.Mesh(ROOF, FACES)
    t = ws.texture_points(mesh, UV[FACES], SIZE, normals="smooth")
    normal = mesh.face_normals[t.points.face]
    tangent = np.cross([0.0, 1.0, 0.0], normal)
    parts = (read / 127.5 - 1.0).reshape(-1, 3, 1)[t.texel]
    decoded = parts[:, 0] * tangent + parts[:, 1] * np.cross(normal, tangent) + parts[:, 2] * normal
    assert (t.points.normal * normal).sum(axis=1).min() < 0.8  # the smooth normals are not the flat ones
    assert np.abs(decoded - t.points.normal).max() < 1.5 * np.sqrt(3.0) / 255  # the rounding of bytes, and of lengths


@pytest.mark.parametrize(("options", "is_flat"), [((), True), (("--normals", "smooth"), False)])
def test_a_finer_mesh_without_normals_is_flat_unless_smooth_is_asked_for(call, tmp_path, options, is_flat):
    path = roof(tmp_path / "in.glb")
    read, _ = bake(call, path, "normals", "--high", path, "--cage", 0.3, *options)
    assert (np.abs(read - (128, 128, 255)).max() <= 1) == is_flat
