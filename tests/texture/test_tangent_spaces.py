"""MikkTSpace works in the space of a mesh, as in viewers, and nodes and joints then place the tangents."""

import numpy as np
import pytest
from glb_files import accessor, glb

import warpsample as ws
from warpsample.mesh.files.gltf import opened
from warpsample.mesh.tangents import compute_tangents
from warpsample.texture.primitives import list_primitives
from warpsample.texture.tangents import FrameReader

SIDE = 5
TURN = [0.5, 0.5, 0.5, 0.5]  # x to y, y to z, z to x


def waves():
    """Points, normals, texture coordinates, and triangles of a wavy sheet with irregular coordinates."""
    x, y = (a.ravel() for a in np.meshgrid(np.linspace(0, 1, SIDE), np.linspace(0, 1, SIDE)))
    points = np.stack([x, y, 0.3 * np.sin(4 * x) * np.cos(3 * y)], axis=1)
    normals = np.stack([-1.2 * np.cos(4 * x) * np.cos(3 * y), 0.9 * np.sin(4 * x) * np.sin(3 * y), np.ones(len(x))], axis=1)
    uv = np.stack([x + 0.4 * y, 1 - y], axis=1) + np.random.default_rng(3).uniform(-0.03, 0.03, (len(x), 2))
    first = np.add.outer(np.arange(SIDE - 1) * SIDE, np.arange(SIDE - 1)).ravel()
    faces = np.concatenate([first[:, None] + (0, 1, SIDE + 1), first[:, None] + (0, SIDE + 1, SIDE)])
    unit = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    return points.astype("f4"), unit.astype("f4"), uv.astype("f4"), faces.astype("u2")


def sheet(path, nodes, *, skinned=False, own=False):
    """The sheet at a node, perhaps with joints, or with the tangents of MikkTSpace in its mesh."""
    points, normals, uv, faces = waves()
    share = np.stack([1 - points[:, 0], points[:, 0], 0 * points[:, 0], 0 * points[:, 0]], axis=1).astype("f4")
    found = compute_tangents(points[faces].astype(float), normals[faces].astype(float), uv[faces].astype(float))
    tangents = np.zeros((len(points), 4), np.float32)
    tangents[faces] = found
    assert np.allclose(tangents[faces], found, atol=1e-6)  # one tangent for each vertex
    arrays = [points, normals, uv, faces.ravel(), tangents, np.tile(np.uint8([0, 1, 0, 0]), (len(points), 1)), share]
    attributes = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2} | ({"TANGENT": 4} if own else {})
    attributes |= {"JOINTS_0": 5, "WEIGHTS_0": 6} if skinned else {}
    accessors = [accessor(number, array) for number, array in enumerate(arrays)]
    del accessors[5]["normalized"]
    tree = {"meshes": [{"primitives": [{"attributes": attributes, "indices": 3}]}], "nodes": nodes, "accessors": accessors}
    path.write_bytes(glb(tree | ({"skins": [{"joints": [1, 2]}]} if skinned else {}), arrays))
    return path


def frames(path, *, in_group):
    """The tangents of all corners, for the picture of a scene or of the whole file."""
    with opened(path) as (tree, data):
        group = list_primitives(tree, data) if in_group else ()
    return FrameReader(path, ws.load_mesh(path)).frames(ws.load_uv(path), group=group)


@pytest.mark.parametrize("in_group", [False, True])
@pytest.mark.parametrize(
    ("nodes", "skinned"),
    [
        ([{"mesh": 0, "scale": [1, 4, 1], "rotation": TURN, "translation": [1, 2, 3]}], False),
        ([{"mesh": 0, "scale": [-1, 4, 0.5], "rotation": TURN}], False),  # mirrored
        ([{"mesh": 0, "skin": 0}, {"translation": [0, 0, 1]}, {"rotation": TURN, "scale": [1, 2, 1]}], True),
    ],
)
def test_tangents_are_those_of_the_mesh_placed_by_its_node(tmp_path, nodes, skinned, in_group):
    """Before, they were computed from the placed mesh, and 21 degrees off at a scale of (1, 4, 1)."""
    options = {"nodes": nodes, "skinned": skinned}
    made = frames(sheet(tmp_path / "made.glb", **options), in_group=in_group).tangents
    read = frames(sheet(tmp_path / "read.glb", **options, own=True), in_group=in_group).tangents
    assert np.array_equal(made[..., 3], read[..., 3])
    assert np.abs(made - read).max() < 2e-5  # float32 of the file, and of the placed normals


def test_a_place_without_distortion_has_the_tangents_of_the_placed_mesh(tmp_path):
    """Computed in the scene, where they are the same but for rounding: their bits stay."""
    path = sheet(tmp_path / "a.glb", [{"mesh": 0, "scale": [2, 2, -2], "rotation": TURN}])
    mesh, uv, found = ws.load_mesh(path), ws.load_uv(path), frames(path, in_group=True)
    read = frames(sheet(path, [{"mesh": 0, "scale": [2, 2, -2], "rotation": TURN}], own=True), in_group=True)
    assert np.array_equal(found.tangents, compute_tangents(mesh.vertices[mesh.faces], found.normals, uv))
    assert np.abs(found.tangents - read.tangents).max() < 2e-5


def test_a_flattened_place_keeps_finite_tangents(tmp_path):
    found = frames(sheet(tmp_path / "a.glb", [{"mesh": 0, "scale": [1, 2, 0], "rotation": TURN}]), in_group=True)
    assert np.isfinite(found.tangents).all()
