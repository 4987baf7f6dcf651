"""`to_frame`: the numbers of every result, beside where their points are and what they are on."""

import builtins

import numpy as np
import pytest
import trimesh

import warpsample as ws

BOX = trimesh.creation.box((2.0, 2.0, 2.0))
PART = np.repeat([1, -1, 0], 4)
NAMES = ["a", "b"]
HEAD = ["id", "part", "area", "face", "x", "y", "z", "normal_x", "normal_y", "normal_z"]


@pytest.fixture(scope="module")
def box():
    mesh = ws.Mesh(BOX.vertices, BOX.faces, PART, NAMES)
    centers = ws.face_centers(mesh)
    face = centers.face.copy()
    face[3] = -1
    return mesh, ws.SurfacePoints(centers.position, centers.normal, face)


def test_what_is_known_of_each_point(box):
    mesh, points = box
    found = ws.sky_view_factor(mesh, points, 32)
    table = ws.to_frame(found, points, mesh, first_point=2**64 - 12)
    assert list(table) == [
        *HEAD,
        "value",
        "standard_error",
        "spread",
        "degrees_of_freedom",
        "rays",
        "status",
        "below_horizon",
    ]
    assert list(table["id"]) == list(range(2**64 - 12, 2**64))
    own = ws.SurfacePoints(points.position, points.normal, points.face, id=np.arange(12) ** 2)
    assert list(ws.to_frame(found, own)["id"]) == [number**2 for number in range(12)]
    assert list(table["part"]) == ["b"] * 3 + [""] * 5 + ["a"] * 4
    assert np.array_equal(table["area"], np.where(np.arange(12) == 3, np.nan, 2.0), equal_nan=True)
    assert np.array_equal(np.column_stack([table[axis] for axis in "xyz"]), points.position)
    assert np.array_equal(np.column_stack([table[f"normal_{axis}"] for axis in "xyz"]), points.normal)
    assert np.array_equal(table["value"], found.value)


@pytest.mark.slow
def test_results_of_every_kind(box):
    mesh, points = box
    bent = ws.bent_normals(mesh, points, 32)
    table = ws.to_frame(bent, points)
    assert list(table)[:2] == ["id", "face"]
    assert np.array_equal(table["value_2"], bent.value[:, 2])
    hits = ws.trace(mesh, points.position + 3.0, -points.normal)
    assert np.array_equal(ws.to_frame(hits, points, mesh)["distance"], hits.distance)
    sky = ws.sky_matrix(mesh, points, 64)
    assert np.array_equal(ws.to_frame(sky, points)["value_144"], sky.value[:, 144])
    drawn = ws.sample_directions(points, 4)
    assert list(ws.to_frame(drawn, points))[-1] == "status"  # and no vectors, (P, 4, 3)
    plain = ws.Mesh(mesh.vertices, mesh.faces)
    assert "part" not in ws.to_frame(hits, points, plain)


def test_without_pandas_it_is_arrays(box, monkeypatch):
    mesh, points = box
    with_pandas = ws.to_frame(points, points, mesh)
    known = builtins.__import__
    none = {"name": "pandas"}

    def without(name, *arguments, **named):
        if name == "pandas":
            raise ModuleNotFoundError(**none)
        return known(name, *arguments, **named)

    monkeypatch.setattr(builtins, "__import__", without)
    table = ws.to_frame(points, points, mesh)
    assert type(table) is dict
    assert list(table) == list(with_pandas)
    assert all(np.array_equal(table[name], with_pandas[name], equal_nan=name == "area") for name in table)


def test_bad_arguments(box):
    mesh, points = box
    found = ws.ambient_occlusion(mesh, points, 32)
    few = ws.SurfacePoints(points.position[:5], points.normal[:5])
    far = ws.SurfacePoints(points.position, points.normal, np.full(12, 99))
    for arguments, named, message in (
        ((found, few), {}, r"found: got arrays of shape value \(12,\), .*, want one row for each of the 5 points$"),
        ((found, far, mesh), {}, "points: got the face 99, want faces of the mesh, which has 12$"),
        ((found, points.position), {}, "points: got a NumPy array, want SurfacePoints$"),
        ((3.0, points), {}, "found: got 3.0, want the result of a call at points, such as sky_view_factor$"),
        ((found, points), {"first_point": -1}, "first_point: got -1, want"),
        ((found, points, "mesh.ply"), {}, "mesh: got 'mesh.ply', want a mesh"),
    ):
        with pytest.raises((TypeError, ValueError), match=f"^{message}"):
            ws.to_frame(*arguments, **named)
