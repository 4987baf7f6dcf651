"""Which way is up: +y in glTF, what a USD file says, z in all others; told where it is not z, and never changed if given."""

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.output.quantities import quantity_of
from warpsample.output.upward import with_up

SIDE = trimesh.creation.box((2.0, 2.0, 2.0))
SAID = "  up is +y, as {} has it; --up 0 0 1 is for +z"


def upper(path, axis):
    """The mean sky view of the faces whose normals point along an axis."""
    with np.load(path) as file:
        return file["value"][file["normal"][:, axis] > 0.9].mean()


@pytest.mark.parametrize("texture", [[], ["--texture", 64]])
def test_the_sky_of_a_glb_is_along_y(call, tmp_path, texture):
    path, output = tmp_path / "in.glb", tmp_path / "out.npz"
    SIDE.export(path)
    at = texture or ["--at", "faces"]
    for options, axis in (([], 1), (["--up", 0, 0, 1], 2)):
        status, out, _ = call("bake", path, "-o", output, "--quantity", "sky", "--samples", 64, *at, *options)
        assert status == 0
        assert (SAID.format("glTF") in out.splitlines()) == (not options)
        if not texture:
            assert upper(output, axis) == 1.0
            assert upper(output, 3 - axis) == pytest.approx(0.5, abs=0.05)
    assert call("bake", path, "-o", output, "--samples", 64)[1].count("\n  up") == 0  # occlusion has none


@pytest.mark.parametrize("name", ["in.glb", "in.ply"])
def test_north_of_y_up_is_along_z_also_if_up_is_given(tmp_path, name):
    """North along +y, as for +z up, was refused."""
    SIDE.export(tmp_path / name)
    found, said = with_up(tmp_path / name, quantity_of("irradiation"), {"up": (0.0, 1.0, 0.0)})
    assert (found["north"], said) == ((0.0, 0.0, -1.0), "north is -z")
    given = {"up": (0.0, 1.0, 0.0), "north": (1.0, 0.0, 0.0)}
    assert with_up(tmp_path / name, quantity_of("irradiation"), given) == (given, "")


@pytest.mark.parametrize("up", [(0, 0, 1), (0, -1, 0), (3, 0, 4)])
def test_a_glb_that_is_written_stands_upright(call, tmp_path, up):
    """A step far from the origin: baked anew, by the format's own up, it sees as much of the sky."""
    lengths = np.array([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0], [2, 0, 1], [2, 3, 1]]) + 500
    mesh = trimesh.Trimesh(lengths, [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]], process=False)
    mesh.export(tmp_path / "in.ply")
    command = ("--quantity", "sky", "--samples", 1024, "--at", "faces")
    for source, output, options in (
        ("in.ply", "a.npz", ["--up", *up]),
        ("in.ply", "out.glb", ["--up", *up]),
        ("out.glb", "b.npz", []),
    ):
        assert call("bake", tmp_path / source, "-o", tmp_path / output, *command, *options)[0] == 0
    before, after = (np.load(tmp_path / name)["value"] for name in ("a.npz", "b.npz"))
    assert np.abs(before - after).max() < 0.02  # of 1,024 other rays; by another axis it is 0.1 and more
    assert np.ptp(before) > 0.1


def test_a_usd_file_says_its_own(tmp_path):
    from pxr import Usd, UsdGeom

    sky = quantity_of("sky")
    for axis in ("Y", "Z"):
        path = tmp_path / f"{axis}.usda"
        stage = Usd.Stage.CreateNew(str(path))
        UsdGeom.SetStageUpAxis(stage, axis)
        stage.GetRootLayer().Save()
        options, said = with_up(path, sky, {"samples": 8})
        assert options == ({"samples": 8, "up": (0.0, 1.0, 0.0)} if axis == "Y" else {"samples": 8})
        assert said == (SAID.format("this USD file").strip() if axis == "Y" else "")


def test_a_damaged_usd_file_is_named(tmp_path):
    """The error was "line 2:15: Expected }", and "line 2:15" stood for the path."""
    path = tmp_path / "damaged.usda"
    path.write_text('#usda 1.0\ndef Mesh "m" {{\n}\n')
    with pytest.raises(ValueError, match=r"^path: got '.*damaged.usda', which cannot be read as a mesh: line 2:15: "):
        with_up(path, quantity_of("sky"), {})


@pytest.mark.slow
def test_north_follows_and_what_is_given_stays(tmp_path):
    """Turned upright, what was north of a map is -z; other files and quantities are left alone."""
    path = tmp_path / "in.glb"
    SIDE.export(path)
    matrix = quantity_of("sky-matrix")
    assert with_up(path, matrix, {})[0] == {"up": (0.0, 1.0, 0.0), "north": (0.0, 0.0, -1.0)}
    assert with_up(path, matrix, {"north": (1, 0, 0)})[0] == {"up": (0.0, 1.0, 0.0), "north": (1, 0, 0)}
    assert with_up(path, matrix, {"up": (0, 0, 1)}) == ({"up": (0, 0, 1)}, "")
    assert with_up(path, quantity_of("ao"), {}) == ({}, "")
    assert with_up(tmp_path / "in.ply", matrix, {}) == ({}, "")
    assert with_up(tmp_path / "missing.glb", matrix, {}) == ({}, "")
    mesh = ws.as_mesh(SIDE)
    ws.sky_matrix(mesh, ws.face_centers(mesh), 145, **with_up(path, matrix, {})[0])  # the two are at a right angle
