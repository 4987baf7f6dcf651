"""Names in a file do not steer the terminal, and do not forge lines of a report."""

import pytest
from glb_files import glb
from textured_scenes import SQUARE, TWO, corner

NAME = "wall\x1b[2J\x9b1m\u202e\n  mean 1.0000"
ESCAPED = r"wall\x1b[2J\x9b1m"


@pytest.fixture
def scene(tmp_path):
    """A floor and a wall with the same texture coordinates and material; node, mesh and material have an odd name."""
    primitives = [{"attributes": {"POSITION": i, "TEXCOORD_0": 2}, "indices": 3, "material": 0} for i in (0, 1)]
    tree = {
        "meshes": [{"name": NAME, "primitives": [one]} for one in primitives],
        "nodes": [{"mesh": 0, "name": NAME}, {"mesh": 1, "name": NAME}],
        "materials": [{"name": NAME, "doubleSided": True}],
    }
    path = tmp_path / "in.glb"
    path.write_bytes(glb(tree, [*corner(), SQUARE, TWO]))
    return path


@pytest.mark.parametrize(
    ("command", "options"),
    [
        ("info", ()),
        ("bake", ("--texture", 16, "--samples", 2, "--uv", "0")),
        ("bake", ("--texture", 16, "--samples", 2, "--uv", "0", "--strict")),
        ("bake", ("--samples", 2, "--transmittance", "roof=0.5")),
    ],
)
def test_names_are_escaped(call, scene, command, options, tmp_path):
    output = () if command == "info" else ("-o", tmp_path / "out.glb")
    status, out, err = call(command, scene, *output, *options)
    assert status in (0, 2)
    assert ESCAPED in out + err
    assert all(line.isprintable() for line in (out + err).split("\n"))
    assert err.count("\n") == (status == 2)
