"""Skinned meshes of .glb files are where their joints pose them, whatever their own node says."""

import numpy as np
import pytest
from glb_files import accessor, glb

import warpsample as ws
from warpsample.mesh.files.gltf import read_corners
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import list_primitives

QUAD = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], np.float32)
TURN = {"rotation": [0.0, np.sqrt(0.5), 0.0, np.sqrt(0.5)], "translation": [5, 0, 0]}  # a quarter about y: z to x, x to -z


def skinned(path, weights, *, scale=(1, 1, 1), joints=(1, 2), inverse=None):
    """A quad with a normal of +z, whose node is far away: the nodes 1 to 3 may be its joints."""
    inverse = np.tile(np.eye(4), (2, 1, 1)) if inverse is None else inverse
    arrays = [QUAD, np.array([0, 1, 2, 0, 2, 3], np.uint16), np.tile(np.float32([0, 0, 1]), (4, 1))]
    arrays += [np.tile(np.uint8([0, 1, 7, 0]), (len(weights), 1)), np.float32(weights), np.float32(inverse).reshape(-1, 4)]
    attributes = {"POSITION": 0, "NORMAL": 2, "JOINTS_0": 3, "WEIGHTS_0": 4}
    tree = {
        "meshes": [{"primitives": [{"attributes": attributes, "indices": 1}]}],
        "nodes": [
            {"mesh": 0, "skin": 0, "translation": [0, 0, 100], "scale": list(scale)},
            {"name": "still"},
            {"children": [3], "name": "moves", "translation": [0, 2, 0]},
            {**TURN, "name": "turns"},
        ],
        "skins": [{"joints": list(joints), "inverseBindMatrices": 5}],
    }
    accessors = [accessor(number, array) for number, array in enumerate(arrays)]
    accessors[5] |= {"type": "MAT4", "count": len(inverse)}
    path.write_bytes(glb(tree | {"accessors": accessors}, arrays))
    return path


def test_joints_pose_points_and_normals(tmp_path):
    """Two corners stay; the others, bound one to the left of a joint, turn with it, about where it is."""
    bind = np.tile(np.eye(4), (2, 1, 1))
    bind[1, 3, 0] = -1.0  # of four columns, as the file has them
    weights = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 2, 0, 0], [0, 0, 0, 0]]  # of 1, of any sum, and of none
    path = skinned(tmp_path / "a.glb", weights, joints=(1, 3), inverse=bind)
    mesh = ws.load_mesh(path)
    assert np.allclose(mesh.vertices, [(0, 0, 0), (5, 2, 0), (5, 3, 0), (0, 1, 0)], atol=1e-6)  # float32 rotations
    normals = read_corners(path, "NORMAL")
    assert np.allclose(normals[0], [(0, 0, 1), (1, 0, 0), (1, 0, 0)], atol=1e-6)


def test_halves_of_two_joints_are_between_them(tmp_path):
    vertices = ws.load_mesh(skinned(tmp_path / "a.glb", np.tile([0.5, 0.5, 0, 0], (4, 1)))).vertices
    assert np.allclose(vertices, QUAD + np.array((0, 1, 0)), atol=1e-6)


def test_a_node_that_mirrors_turns_the_faces_only(tmp_path):
    """As viewers have it: the sign of the node's determinant is the winding's."""
    plain, mirrored = (
        ws.load_mesh(skinned(tmp_path / "a.glb", np.tile([1, 0, 0, 0], (4, 1)), scale=scale))
        for scale in ((1, 1, 1), (-1, 1, 1))
    )
    assert np.array_equal(plain.vertices, mirrored.vertices)
    assert np.array_equal(plain.faces[:, ::-1], mirrored.faces)


def test_the_scale_of_a_skins_node_does_not_count(tmp_path):
    """Before, its thickness was divided by the scale, which moves no vertex."""
    file = GlbFile(skinned(tmp_path / "a.glb", np.tile([1, 0, 0, 0], (4, 1)), scale=(7, 7, 7)))
    (found,) = list_primitives(file.part, file.data)
    assert found.scale == 1.0
    assert np.array_equal(found.matrix, np.tile(np.eye(3), (4, 1, 1)))


def test_joints_scale_the_lengths_of_their_mesh(tmp_path):
    """The joint of the corners 2 and 3 is bound at a fifth of its size."""
    bind = np.eye(4) * np.array([[[1]], [[5]]])
    bind[1, 3, 3] = 1.0
    weights = [[1, 0, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 0, 0]]
    path = skinned(tmp_path / "a.glb", weights, inverse=bind, scale=(7, 7, 7))
    file = GlbFile(path)
    (found,) = list_primitives(file.part, file.data)
    assert np.allclose(found.matrix, np.eye(3) * np.array([1, 1, 5, 5])[:, None, None], atol=1e-12)


@pytest.mark.parametrize(
    ("weights", "more", "why"),
    [
        ([0, 0, 1, 0], {}, r"meshes\[0\].primitives\[0\].attributes.JOINTS_0: got joint 7, want 0 to 1, as in the skin"),
        ([], {}, "the skin has joints for 0 of 4 vertices, want joints for each vertex"),
        ([1, 0, 0, 0], {"joints": (1, 9)}, r"skins\[0\].joints\[1\]: got 9, want a whole number below 4"),
        ([1, 0, 0, 0], {"joints": (1, 2, 3)}, r"skins\[0\].inverseBindMatrices: got 2 matrices, want one for each of 3"),
    ],
)
def test_skins_that_cannot_be_are_refused(tmp_path, weights, more, why):
    path = skinned(tmp_path / "a.glb", np.tile(weights, (4, 1)).reshape(-1, 4), **more)
    with pytest.raises(ValueError, match=f"a.glb', which cannot be read as a mesh: {why}"):
        ws.load_mesh(path)
