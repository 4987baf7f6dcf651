"""Nodes of a .glb that KHR_node_visibility hides: no faces, no points and no shadows, and a count in each report."""

import numpy as np
import pytest
from glb_files import glb
from textured_scenes import SQUARE, TWO, opened

import warpsample as ws
from warpsample.mesh.files.gltf import read_corners

FLOOR = np.float32([(0, 0, 1), (1, 0, 1), (1, 0, 0), (0, 0, 0)])


def lid_and_floor(path, **hidden):
    """A floor, and above it a lid that is the child of a hidden node; and a hidden node with another lid."""
    state = {"extensions": {"KHR_node_visibility": {"visible": False} | hidden}}
    mesh = {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 2}, "indices": 1, "material": 0}]}
    tree = {
        "meshes": [{"name": "floor", **mesh}, {"name": "lid", **mesh}],
        "materials": [{"name": "stone"}],
        "nodes": [
            {"mesh": 0},
            {"children": [2], **state},
            {"mesh": 1, "translation": [0, 0.1, 0], "extensions": {"KHR_node_visibility": {"visible": True}}},
            {"mesh": 0, "translation": [0, 0.2, 0], **state},
        ],
        "extensionsUsed": ["KHR_node_visibility"],
    }
    path.write_bytes(glb(tree, [FLOOR, TWO, SQUARE]))
    return path


def test_invisible_nodes_have_no_faces(tmp_path):
    path = lid_and_floor(tmp_path / "a.glb")
    assert np.array_equal(ws.load_mesh(path).vertices, FLOOR)
    assert read_corners(path, "TEXCOORD_0").shape == (2, 3, 2)
    assert len(ws.load_mesh(lid_and_floor(path, visible=True)).faces) == 6


def test_a_state_that_is_no_flag_is_refused(tmp_path):
    path = lid_and_floor(tmp_path / "a.glb", visible="no")
    with pytest.raises(ValueError, match=r"nodes\[1\].extensions.KHR_node_visibility.visible: got 'no', want True or False"):
        ws.load_mesh(path)


@pytest.mark.parametrize(
    ("suffix", "command", "options"),
    [
        (".glb", "bake", ("--samples", 8)),
        (".glb", "bake", ("--samples", 8, "--texture", 8)),
        (".npz", "directions", ("--samples", 8)),
        (".npz", "view-factors", ("--count", 64)),
    ],
)
def test_reports_count_invisible_meshes(call, tmp_path, suffix, command, options):
    path, output = lid_and_floor(tmp_path / "a.glb"), tmp_path / f"out{suffix}"
    status, out, err = call(command, path, "-o", output, *options)
    assert (status, err, out.count("2 invisible meshes are left out (KHR_node_visibility)")) == (0, "", 1)
    if command == "bake":
        assert "mean 1.0000" in out
        assert opened(output)[0]["nodes"] == opened(path)[0]["nodes"]
    assert "2 invisible meshes" in call("info", path)[1]
