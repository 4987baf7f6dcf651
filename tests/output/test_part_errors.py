"""Errors of `bake --by part` for meshes with few faces: enough points by default, and errors of few points."""

import csv

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.city.cityjson.placing import spread_points
from warpsample.estimate.intervals import raised_errors
from warpsample.mesh.part_means import part_means


def joined(*parts):
    """Return a mesh with a part for each list of boxes, (low corner, high corner)."""
    solids = []
    for boxes in parts:
        made = [trimesh.creation.box(bounds=corners) for corners in boxes]
        solids.append(trimesh.util.concatenate(made))
    part = np.repeat(np.arange(len(solids)), [len(solid.faces) for solid in solids])
    whole = trimesh.util.concatenate(solids)
    return ws.Mesh(whole.vertices, whole.faces, part=part, parts=[f"part {number}" for number in range(len(solids))])


def two_boxes():
    floor = [((-10, -10, -1.25), (10, 10, -1.15))]
    return joined([((-1, -1, -1), (1, 1, 1))], [((2.5, -0.5, -1), (3.5, 0.5, 3))], floor)


def yard():
    along = [((-10, y, 0), (10, y + 0.5, 4)) for y in (-10, 9.5)]
    across = [((x, -9.5, 0), (x + 0.5, 9.5, 4)) for x in (-10, 9.5)]
    return joined([((-2, -1, 0), (1, 2, 3))], along + across, [((-10, -10, -0.2), (10, 10, -0.1))])


def compute_means(mesh, count, rays, seed):
    points = spread_points(mesh, mesh.face_areas, count, seed)
    found = ws.sky_view_factor(mesh, points, rays, seed=seed)
    given = (mesh.part, mesh.face_areas, points.face, found.value, found.standard_error)
    return part_means(*given, count=len(mesh.parts), least=raised_errors(found))


def test_few_faces_get_more_points_and_many_faces_the_same():
    areas = np.append(np.full(12, 1.0), 500.0)
    mesh = ws.Mesh(np.eye(3), np.tile([0, 1, 2], (13, 1)))
    each = np.bincount(spread_points(mesh, areas, None, 0).face)
    assert each.tolist() == [157] * 12 + [2000]  # 2048 // 13, and 2048 * 500 / 512
    assert np.bincount(spread_points(mesh, areas, 40, 0).face).tolist() == [2] * 12 + [39]
    for faces, least in ((682, 3), (683, 2)):
        areas = np.append(np.full(faces - 1, 1e-6), 1.0)
        mesh = ws.Mesh(np.eye(3), np.tile([0, 1, 2], (faces, 1)))
        assert np.bincount(spread_points(mesh, areas, None, 0).face).min() == least


def test_a_table_of_few_points_has_pooled_variances(call, tmp_path):
    mesh, output = two_boxes(), tmp_path / "out.csv"
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in mesh.vertices.tolist())
    for number, name in enumerate(mesh.parts):
        text += f"o {name}\n" + "".join(f"f {a} {b} {c}\n" for a, b, c in (mesh.faces[mesh.part == number] + 1).tolist())
    (tmp_path / "a.obj").write_text(text)
    given = ("--quantity", "sky", "--samples", 64, "--points", 36, "--seed", 5)
    assert call("bake", tmp_path / "a.obj", "-o", output, "--by", "part", *given)[0] == 0
    with output.open(encoding="utf-8", newline="") as file:
        errors = [float(row["sky_view_factor_error"]) for row in csv.DictReader(file)]
    assert errors == pytest.approx(compute_means(mesh, 36, 64, 5).standard_error, rel=1e-6)


@pytest.mark.thorough
@pytest.mark.parametrize("rays", [64, 1024])
@pytest.mark.parametrize("scene", [two_boxes, yard])
def test_two_errors_contain_the_sky_view_of_few_faces(scene, rays):
    """With four points per face, as before, it was 82 % of the values of the boxes, and 71 % of those of the narrow box."""
    mesh, seeds = scene(), 200
    right = compute_means(mesh, 1_000_000, 64, 99)
    runs = [compute_means(mesh, None, rays, seed) for seed in range(seeds)]
    value, error = (np.array([getattr(run, name) for run in runs]) for name in ("value", "standard_error"))
    shares = (np.abs(value - right.value) <= 2.0 * np.hypot(error, right.standard_error)).mean(axis=0)
    # The share of 200 seeds is known to 1.5 %, three of which are 4.5 %; skewed values cost up to 1 %.
    assert (shares > 0.9).all(), shares
    assert shares.mean() > 0.93, shares  # of 600 values, known to 0.9 %
