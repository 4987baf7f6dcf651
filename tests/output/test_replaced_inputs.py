"""Inputs that another program replaces while a command reads them several times: an error, and the output stays."""

import numpy as np
import pytest
import trimesh

from warpsample.cli import commands
from warpsample.output import bake, export
from warpsample.output.textures import images


def written(path, height=1.0):
    trimesh.creation.box((1.0, height, 1.0)).export(path)
    return path


def replacing(monkeypatch, module, name, path, other):
    """`module.name` first replaces the file, as a program that exports it again does."""
    first = getattr(module, name)

    def replaced(*arguments, **options):
        if other.exists():
            other.replace(path)
        return first(*arguments, **options)

    monkeypatch.setattr(module, name, replaced)


@pytest.mark.parametrize(
    ("module", "name", "command", "output"),
    [
        (bake, "compute_parts", ("bake", "--quantity", "ao", "--samples", 4, "--at", "vertices"), "out.glb"),
        (images, "compute_parts", ("bake", "--quantity", "bent-normals", "--samples", 4, "--texture", 64), "out.glb"),
        (images, "compute_parts", ("bake", "--quantity", "ao", "--samples", 4, "--texture", 64), "out.npz"),
        (export, "points_on", ("directions", "--at", "faces", "--samples", 4), "out.npz"),
        (export, "points_on", ("directions", "--at", "faces", "--samples", 4), "out.ply"),
    ],
)
def test_an_input_that_is_replaced_meanwhile_is_an_error(module, name, command, output, tmp_path, call, monkeypatch):
    path, other, out = written(tmp_path / "box.glb"), written(tmp_path / "other.glb", 3.0), tmp_path / output
    arguments = (command[0], path, "-o", out, *command[1:])
    assert call(*arguments)[0] == 0
    before = out.read_bytes()
    replacing(monkeypatch, module, name, path, other)
    status, _, said = call(*arguments)
    assert status == 2
    assert (
        f"error: mesh: got {str(path)!r}, changed since the run began, want files that stay the same until its end" in said
    )
    assert out.read_bytes() == before


def test_a_layer_of_usd_that_is_replaced_meanwhile_is_an_error(tmp_path, call, monkeypatch):
    """Each read of USD is a process of its own, so that seconds pass between positions and coordinates."""
    layer, other, path, out = (tmp_path / name for name in ("layer.usda", "other.usda", "root.usda", "out.npz"))
    for where, height in ((layer, 1.0), (other, 3.0)):
        where.write_text(
            '#usda 1.0\ndef Mesh "m" {\nint[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\n'
            f"point3f[] points = [(0, 0, 0), (1, 0, 0), (0, {height}, 0)]\n"
            'texCoord2f[] primvars:st = [(0, 0), (1, 0), (0, 1)] (interpolation = "vertex")\n}\n'
        )
    path.write_text("#usda 1.0\n(\nsubLayers = [@./layer.usda@]\n)\n")
    replacing(monkeypatch, images, "compute_parts", layer, other)
    status, _, said = call("bake", path, "-o", out, "--quantity", "position", "--texture", 8)
    assert (status, out.exists()) == (2, False)
    assert f"error: mesh: got {str(path)!r}, changed since the run began" in said


def test_a_baked_file_that_is_replaced_while_it_is_shown_is_an_error(can_render, tmp_path, call, monkeypatch):
    """The mesh, the pictures and the coordinates are read one after the other."""
    path, other, out = written(tmp_path / "box.glb"), written(tmp_path / "other.glb", 3.0), tmp_path / "view.png"
    replacing(monkeypatch, commands, "read_occlusion", path, other)
    status, _, said = call("view", path, "--screenshot", out)
    assert (status, out.exists()) == (2, False)
    assert f"error: mesh: got {str(path)!r}, changed since the run began" in said


def test_an_array_that_is_replaced_meanwhile_is_an_error(tmp_path, call, monkeypatch):
    path, out = written(tmp_path / "box.ply"), tmp_path / "out.npz"
    array, other = tmp_path / "array.npz", tmp_path / "other.npz"
    for file, alpha in ((array, 0.1), (other, 0.9)):
        np.savez(file, rough=np.full(12, alpha))
    replacing(monkeypatch, export, "carry_to_points", array, other)
    lobe = ("--distribution", "ggx(alpha=@rough)", "--arrays", array)
    status, _, said = call("directions", path, "-o", out, "--at", "faces", "--samples", 4, *lobe)
    assert (status, out.exists()) == (2, False)
    assert f"{str(array)!r}, changed since the run began" in said


def test_an_input_that_is_read_once_may_change(tmp_path, call, monkeypatch):
    path, other, out = written(tmp_path / "box.ply"), written(tmp_path / "other.ply", 3.0), tmp_path / "out.ply"
    arguments = ("bake", path, "-o", out, "--quantity", "ao", "--samples", 4, "--at", "faces")
    assert call(*arguments)[0] == 0
    before = out.read_bytes()
    replacing(monkeypatch, bake, "compute_parts", path, other)
    assert call(*arguments)[0] == 0
    assert out.read_bytes() == before
