"""Every hit of rays: the same as by brute force, each crossing once, also of rays aimed at edges and corners."""

import numpy as np
import pytest
import trimesh
import warp as wp
from crossings import crossings
from meshes import BOX, TORUS, aimed, centred, icosphere, loose, planes, random_rays, soup

import warpsample as ws


def lattice():
    """A closed body whose coordinates are small multiples of 1/2: every edge function that can be 0 is exactly 0."""
    made = trimesh.creation.box((2, 2, 2)).subdivide().subdivide()
    return ws.Mesh(made.vertices, made.faces)


def compare(mesh, origins, directions):
    found = ws.trace_all(mesh, origins, directions)
    rays, faces, distances, exact = crossings(mesh, origins, directions)
    ray = np.repeat(np.arange(len(directions)), np.diff(found.first))
    order = np.lexsort((found.face, ray))
    assert np.array_equal(ray[order], rays)
    assert np.array_equal(found.face[order], faces)
    np.testing.assert_allclose(found.distance[order], distances, rtol=1e-6)  # some roundings of float32
    in_order = np.lexsort((found.face, found.distance, ray))
    assert np.array_equal(in_order, np.arange(len(ray)))
    return np.diff(found.first), exact


MESHES = {
    "icosphere": icosphere,
    "loose icosphere": lambda: loose(icosphere()),
    "torus": lambda: centred(TORUS),
    "lattice": lattice,
    "box": lambda: loose(centred(BOX)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", MESHES)
def test_all_hits_are_those_of_brute_force_and_even_outside(name):
    mesh = MESHES[name]()
    origins, directions = aimed(mesh, 2000)
    counts, exact = compare(mesh, origins, directions)
    outside = np.abs(origins).max(axis=1) > np.abs(mesh.vertices).max()
    assert outside.sum() > 200
    assert (counts[outside] % 2 == 0).all()
    assert name != "lattice" or exact > 200  # edges that float64 does not decide


@pytest.mark.thorough
@pytest.mark.parametrize(("name", "calls"), [("box", 5), ("lattice", 3), ("icosphere", 1), ("torus", 1)])
def test_all_hits_of_a_million_rays_are_those_of_brute_force(name, calls):
    mesh = MESHES[name]()
    for seed in range(calls):
        compare(mesh, *aimed(mesh, 100_000, seed))


@pytest.mark.slow
def test_a_soup_of_slivers_and_degenerate_triangles_is_as_by_brute_force():
    compare(soup(), *random_rays(2000))


@pytest.mark.slow
def test_crossings_have_the_numbers_that_geometry_says():
    """Icosphere: from inside 1, through it 2; planes: as many as there are; each aimed at corners and edges as well."""
    sphere = icosphere()
    at = np.concatenate([sphere.vertices, sphere.vertices[sphere.faces].mean(axis=1), 0.5 * _edges(sphere).sum(axis=1)])
    inward = ws.trace_all(sphere, 3.0 * at, -at)
    assert (np.diff(inward.first) == 2).all()
    assert (np.diff(ws.trace_all(sphere, np.zeros(3), at).first) == 1).all()
    pile = planes(1000)
    x, y = np.meshgrid(np.linspace(-0.9, 0.9, 7), np.linspace(-0.9, 0.9, 7))
    down = np.stack([x.ravel(), y.ravel(), np.full(49, 2.0)], axis=1)  # those with x = y go along the diagonals
    found = ws.trace_all(pile, down, np.broadcast_to([0.0, 0.0, -1.0], (49, 3)))
    assert (np.diff(found.first) == 1000).all()
    assert (np.diff(found.distance.reshape(49, 1000)) > 0.0).all()
    assert np.array_equal(found.face.reshape(49, 1000) // 2, np.broadcast_to(np.arange(1000)[::-1], (49, 1000)))


def _edges(mesh):
    """(E, 2, 3) ends of the edges, each as often as faces have it."""
    return mesh.vertices[mesh.faces[:, [0, 1, 1, 2, 2, 0]]].reshape(-1, 2, 3)


@pytest.mark.slow
def test_hits_agree_with_those_of_trace_and_end_at_max_distance():
    mesh = soup()
    origins, directions = random_rays(3000)
    found, nearest = ws.trace_all(mesh, origins, directions), ws.trace(mesh, origins, directions)
    some = np.diff(found.first) > 0
    assert np.array_equal(found.distance[found.first[:-1][some]], nearest.distance[some])
    assert (nearest.face[~some] == -1).all()
    near = ws.trace_all(mesh, origins, directions, max_distance=0.75, workers=1)
    kept = found.distance < 0.75
    assert 0 < kept.sum() < len(kept)
    assert np.array_equal(near.distance, found.distance[kept])
    assert np.array_equal(near.face, found.face[kept])
    points = ws.sample_surface(mesh, 500, seed=1)
    on_them = ws.trace_all(mesh, points, directions[:1500].reshape(500, 3, 3))
    first = ws.trace(mesh, points, directions[:1500].reshape(500, 3, 3)).distance.ravel()
    some = np.diff(on_them.first) > 0
    assert np.array_equal(on_them.distance[on_them.first[:-1][some]], first[some])


@pytest.mark.slow
def test_coincident_faces_are_all_met_and_rays_that_are_none_have_none():
    corners = np.array([[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0]])
    mesh = ws.as_mesh(
        (np.concatenate([corners, corners + np.array([0.0, 0.0, 2.0])]), [[0, 1, 2], [3, 4, 5], [2, 1, 0], [1, 2, 0]])
    )
    origins = np.ones((5, 3)) * [1.0, 1.0, 0.0]
    directions = np.array([[0, 0, 1], [0, 0, 0], [0, 0, -1], [0, 0, np.nan], [0, 0, 7]], np.float64)
    found = ws.trace_all(mesh, origins, directions)
    assert (found.first.tolist(), found.invalid) == ([0, 4, 4, 4, 4, 8], 2)
    assert found.face.tolist() == [0, 2, 3, 1] * 2
    assert found.distance.tolist() == [1.0, 1.0, 1.0, 3.0] * 2
    none = ws.trace_all(mesh, origins[:0], directions[:0])
    assert (none.first.tolist(), len(none.distance), none.invalid) == ([0], 0, 0)
    warped = ws.trace_all(mesh, *(wp.array(array, dtype=wp.vec3d, device="cpu") for array in (origins, directions)))
    for name in ("first", "distance", "face"):
        assert np.array_equal(getattr(warped, name).numpy(), getattr(found, name))


@pytest.mark.slow
def test_hits_that_memory_does_not_hold_are_refused_before_they_are_written(monkeypatch):
    asked = []
    monkeypatch.setattr("warpsample.tracing.trace_all.check_memory", lambda size, what, _: asked.append((size, what)))
    ws.trace_all(planes(20), np.array([0.1, 0.2, 2.0]), np.array([[0.0, 0.0, -1.0]]))
    assert asked == [(16, "the numbers of hits of 1 rays"), (8 * 20, "the 20 hits of 1 rays")]
