"""`warpsample bake --transmittance` and `--reflectance`: a number, a file, or by the names of parts."""

import re

import numpy as np
import pytest

import warpsample as ws
from warpsample.output.faces_option import with_optics

SHEETS = [("crown/leaf", 1.0, 0.25), ("crown/stem", 2.0, 0.0), ("pane", 3.0, 0.5)]


def sheets(where, size=1e4):
    """An .obj of two triangles for each name, all above the origin."""
    text, path = "", where / "sheets.obj"
    for name, height, _ in SHEETS:
        corners = [(-size, -size, height), (size, -size, height), (size, size, height), (-size, size, height)]
        text += f"o {name.partition('/')[0]}\ng {name.partition('/')[2]}\n"
        text += "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "f -4 -3 -2\nf -4 -2 -1\n"
    path.write_text(text)
    return path


def test_all_ways_to_tell_a_transmittance(tmp_path):
    mesh = ws.load_mesh(sheets(tmp_path))
    np.save(tmp_path / "tau.npy", np.repeat([0.25, 0.0, 0.5], 2))
    by_file = with_optics(mesh, transmittance=str(tmp_path / "tau.npy")).transmittance
    assert by_file.tolist() == [0.25, 0.25, 0.0, 0.0, 0.5, 0.5]
    assert np.array_equal(with_optics(mesh, transmittance="leaf=0.25,pane=0.5").transmittance, by_file)
    assert np.array_equal(with_optics(mesh, transmittance="crown/leaf=.25,pane=5e-1").transmittance, by_file)
    assert with_optics(mesh, transmittance="crown=0.125").transmittance.tolist() == [0.125] * 4 + [0.0] * 2
    assert with_optics(mesh, transmittance="0.1").transmittance.tolist() == [np.float32(0.1)] * 6
    assert with_optics(mesh, transmittance=None) is mesh


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (
            "much",
            "--transmittance: got 'much', want a number, NAME.npy with one number for each face, or numbers by part",
        ),
        ("1.5", "--transmittance: got 1.5, want a number from 0 to 1, or (6,) numbers, one for each face"),
        (
            "leaf=0.2,tree=0.5",
            "--transmittance: got 'tree=0.5', want NAME=NUMBER with the name of a part, one of crown/leaf, crown/stem, pane",
        ),
        ("leaf=0.2,pane=0.1,leaf=0.5", "--transmittance: got 'leaf=0.5' as a second number for 'leaf', want one number"),
        ("leaf=thin", "--transmittance: got 'leaf=thin', want a number"),
        ("none.npy", "--transmittance: got 'none.npy', which is missing"),
    ],
)
def test_what_is_no_transmittance_is_refused_in_a_sentence(value, message, tmp_path):
    with pytest.raises((ValueError, FileNotFoundError), match=re.escape(message)):
        with_optics(ws.load_mesh(sheets(tmp_path)), transmittance=value)
    corners, faces = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0, 1, 2]]
    for nameless in (ws.Mesh(corners, faces), ws.Mesh(corners, faces, part=[0], parts=[""])):  # as nodes without names
        with pytest.raises(
            ValueError, match="^--transmittance: got 'leaf=0.2' for a mesh without named parts, want a number or"
        ):
            with_optics(nameless, transmittance="leaf=0.2")


@pytest.mark.slow
def test_bake_writes_what_gets_through(call, tmp_path):
    path, output = sheets(tmp_path), tmp_path / "out.npz"
    options = ["--quantity", "ao", "--samples", "32", "--at", "faces", "--transmittance", "leaf=0.25,pane=0.5"]
    status, _, err = call("bake", path, "-o", output, *options)
    assert (status, err) == (0, "")
    with np.load(output) as file:
        mesh = ws.as_mesh(ws.load_mesh(path), transmittance=np.repeat([0.25, 0.0, 0.5], 2))
        assert np.array_equal(file["value"], ws.ambient_occlusion(mesh, ws.face_centers(mesh), 32).value)
        assert sorted(set(file["value"])) == [0.0, 0.5, 1.0]
        assert '"transmittance": "leaf=0.25,pane=0.5"' in str(file["run"])


@pytest.mark.slow
def test_refine_needs_a_reflectance(call, tmp_path):
    given = ["--quantity", "irradiation", "--weather", "athens", "--refine", "2"]
    status, _, err = call("bake", sheets(tmp_path), "-o", tmp_path / "out.csv", *given)
    assert status == 2
    assert err.startswith("error: --refine: got 2.0 without --reflectance, want both; ")
    status, _, err = call("bake", tmp_path / "no.tif", "-o", tmp_path / "out.tif", *given)
    assert status == 2
    assert err.startswith("error: --refine: got 2.0 for no.tif; the option applies only to meshes, CityJSON and textures")


def test_bake_writes_what_faces_send_back(call, tmp_path):
    path, output, picture = sheets(tmp_path), tmp_path / "out.npz", tmp_path / "even.npy"
    np.save(picture, np.ones((4, 8)))
    options = ["--quantity", "irradiance", "--environment", picture, "--samples", "32", "--at", "faces"]
    arguments = [*options, "--reflectance", "leaf=0.25,pane=0.5", "--transmittance", "stem=0.5"]
    status, _, err = call("bake", path, "-o", output, *arguments, "--refine", "inf")
    assert (status, err) == (0, "")
    mesh = ws.as_mesh(ws.load_mesh(path), reflectance=np.repeat([0.25, 0, 0.5], 2), transmittance=np.repeat([0, 0.5, 0], 2))
    found = ws.irradiance(mesh, ws.face_centers(mesh), np.ones((4, 8)), 32, refine=np.inf)
    with np.load(output) as file:
        for name in ("value", "standard_error", "reflected", "reflected_error"):
            assert np.array_equal(file[name], getattr(found, name))
        assert '"reflectance": "leaf=0.25,pane=0.5"' in str(file["run"])
    assert found.reflected.max() > 0.0
    for refused, words in (
        (["-o", output], "--reflectance: got 0.5 for ao; the option applies only to irradiance and irradiation"),
        (
            [*options, "-o", output, "--transmittance", "0.75"],
            "--reflectance: got 0.5 in face 0, whose transm",
        ),
    ):
        status, _, err = call("bake", path, *refused, "--reflectance", "0.5")
        assert status != 0
        assert words in " ".join(err.split())
