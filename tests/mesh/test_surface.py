"""Points on a mesh are uniform by area, lie on their face and have its normal."""

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.proof.laws import uniform_p_value
from warpsample.proof.stress import judge_meshes
from warpsample.statistics.histogram import histogram_test

CUBE = trimesh.creation.box()


def test_faces_get_their_share_of_the_area(bunny_path, plausible):
    mesh = ws.load_mesh(bunny_path)
    count = 1_000_000
    points = ws.sample_surface(mesh, count, seed=1)
    observed = np.bincount(points.face, minlength=len(mesh.faces))
    plausible(histogram_test(observed, count * mesh.face_areas / mesh.face_areas.sum()).p_value)


def test_points_are_uniform_on_their_triangle(plausible):
    points = ws.sample_surface(([(0, 0, 0), (2, 0, 0), (0, 3, 0)], [(0, 1, 2)]), 200_000, barycentric=True)
    a, b, c = points.barycentric.T
    assert points.barycentric.min() > 0.0
    assert np.abs(points.barycentric.sum(axis=1) - 1.0).max() <= 3e-16
    for weight in (a, b, c):
        plausible(uniform_p_value((1.0 - weight) ** 2))  # P(weight > t) = (1 - t)^2
    plausible(uniform_p_value(b / (b + c)))


def test_points_lie_on_their_face_with_its_normal(bunny_path):
    mesh = ws.load_mesh(bunny_path)
    points = ws.sample_surface(mesh, 10_000, barycentric=True)
    rebuilt = np.einsum("pk,pkd->pd", points.barycentric, mesh.vertices[mesh.faces[points.face]])
    assert np.abs(rebuilt - points.position).max() <= 1e-15
    assert np.array_equal(points.normal, mesh.face_normals[points.face])
    assert ws.sample_surface(mesh, 10).barycentric is None


def test_same_points_in_parts_and_threads(monkeypatch):
    whole = ws.sample_surface(CUBE, 10_000, seed=3, first_point=2**32 - 5000, workers=1)
    part = ws.sample_surface(CUBE, 4000, seed=3, first_point=2**32 - 1000)
    assert np.array_equal(whole.position[4000:8000], part.position)
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    assert np.array_equal(
        whole.position, ws.sample_surface(CUBE, 10_000, seed=3, first_point=2**32 - 5000, workers=3).position
    )
    assert not np.array_equal(whole.position, ws.sample_surface(CUBE, 10_000, seed=4).position)


@pytest.mark.slow
def test_hostile_meshes():
    """Tiny, far away, degenerate, slivers, and 10^7 faces, of which float32 would give the last one 1.7 % of all points."""
    found = judge_meshes()
    assert len(found) == 6
    assert [verdict for verdict in found if not verdict.passed] == []


@pytest.mark.parametrize("offset", [0.0, 5e6])
def test_positions_keep_float64(offset):
    points = ws.sample_surface((CUBE.vertices + offset, CUBE.faces), 1000, seed=5)
    local = ws.sample_surface(CUBE, 1000, seed=5)
    assert points.position.dtype == np.float64
    assert np.abs(points.position - offset - local.position).max() <= 2e-9  # float64 at 5e6: an ulp is 9e-10


def test_face_centers():
    points = ws.face_centers(CUBE)
    assert np.allclose(points.position, CUBE.triangles_center)
    assert np.allclose(points.normal, CUBE.face_normals)
    assert points.face.tolist() == list(range(12))
    flat = ws.face_centers(([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 1, 1)]))
    assert flat.normal.tolist() == [[0, 0, 1], [0, 0, 0]]
    assert ws.sample_directions(flat, 4).counts() == {ws.Status.OK: 1, ws.Status.ZERO_NORMAL: 1}


def test_vertex_normals_are_weighted_by_area():
    # A right angle between a triangle of area 2 and one of area 1/2.
    v = [(0, 0, 0), (1, 0, 0), (0, 4, 0), (0, 0, 1), (7, 7, 7)]
    points = ws.vertex_points((v, [(0, 1, 2), (0, 3, 1)]))
    assert np.allclose(points.normal[0], np.array([0, 0.5, 2]) / np.hypot(0.5, 2))
    assert np.allclose(points.normal[2], (0, 0, 1))
    assert points.normal[4].tolist() == [0, 0, 0]
    sphere = trimesh.creation.icosphere(3)
    assert (ws.vertex_points(sphere).normal * sphere.vertices).sum(axis=1).min() >= 0.999


def test_own_points():
    points = ws.SurfacePoints(np.zeros((5, 3)), np.ones((5, 3)))
    assert len(points) == 5
    assert points.face.tolist() == [-1] * 5
    assert points.barycentric is None
    assert points.id is None


def test_some_points_keep_what_belongs_to_them():
    points = ws.sample_surface(CUBE, 10, barycentric=True)
    id, raised = np.arange(10) + 2**40, np.arange(10) % 3 > 0
    owned = ws.SurfacePoints(points.position, points.normal, points.face, points.barycentric, id, raised)
    assert owned.id.dtype == np.uint64
    for rows in ([7, 2, 2], slice(None, None, -3), np.arange(10) % 4 == 1):
        for name in ("position", "normal", "face", "barycentric", "id", "raised"):
            assert np.array_equal(getattr(owned.take(rows), name), getattr(owned, name)[rows]), name
    assert points.take([3]).id is None
    assert points.take([3]).raised is None
    assert np.array_equal(owned.take(np.arange(10) % 2 == 0).to_polydata().point_data["id"], owned.id[::2])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((np.zeros(3), np.zeros(3)), r"position: got shape \(3,\), want \(P, 3\)"),
        ((np.zeros((2, 3)), np.zeros((3, 3))), r"normal: got shape \(3, 3\), want \(2, 3\), one row for each position"),
        ((np.zeros((2, 3)), np.zeros((2, 3)), [0]), r"face: got shape \(1,\), want \(2,\)"),
        (
            (np.zeros((2, 3)), np.zeros((2, 3)), [0, 0], np.zeros((2, 2))),
            r"barycentric: got shape \(2, 2\), want \(2, 3\)",
        ),
        ((np.zeros((2, 3)), np.zeros((2, 3)), None, None, [1]), r"id: got shape \(1,\), want \(2,\)"),
        ((np.zeros((2, 3)), np.zeros((2, 3)), None, None, [1, -1]), "id: got -1, want whole numbers of at least 0"),
        ((np.zeros((2, 3)), np.zeros((2, 3)), None, None, None, [True]), r"raised: got shape \(1,\), want \(2,\)"),
    ],
)
def test_bad_own_points_are_named(arguments, message):
    with pytest.raises(ValueError, match="^" + message):
        ws.SurfacePoints(*arguments)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((CUBE, 0), ValueError, "count: got 0, want a whole number from 1"),
        ((CUBE, 2**31), ValueError, "count: got 2147483648"),
        ((CUBE, 1.0), TypeError, "count: got 1.0"),
        ((CUBE, 1, {"seed": -1}), ValueError, "seed: got -1"),
        (("cube", 1), TypeError, "mesh: got .cube., want a mesh"),
        (((np.zeros((3, 3)), [(0, 1, 2)]), 1), ValueError, "mesh: got a mesh whose faces have no area"),
    ],
)
def test_bad_arguments_are_named(arguments, error, message):
    mesh, count, *options = arguments
    with pytest.raises(error, match="^" + message):
        ws.sample_surface(mesh, count, **dict(*options))


def test_no_rows_are_no_points_and_ids_that_round_are_refused_with_what_to_give():
    owned = ws.SurfacePoints(np.eye(3), np.eye(3), id=[7, 8, 9])
    for none in ([], (), np.zeros(0), np.zeros(3, bool)):
        assert owned.take(none).position.shape == (0, 3)
        assert owned.take(none).id.shape == (0,)
    for ids in ([1, 2, 2**64], np.array([1, 2, 3], object), np.array([1.0, 2.0, 3.0])):
        with pytest.raises(TypeError, match=r"^id: got dtype \w+, want .* such as numpy.array\(id, numpy.uint64\)"):
            ws.SurfacePoints(np.eye(3), np.eye(3), id=ids)
    with pytest.raises(TypeError, match="^id: got a masked array, want an array without a mask"):
        ws.SurfacePoints(np.eye(3), np.eye(3), id=np.ma.array([1, 2, 3], mask=[0, 1, 0]))
    with pytest.raises(TypeError, match="^raised: got dtype int64, want bool"):
        ws.SurfacePoints(np.eye(3), np.eye(3), raised=np.array([1, 0, 1], np.int64))
