"""`trace` agrees with closed forms, brute force in float64, Embree and the other tracer, however it is called."""

import numpy as np
import pytest
import warp as wp
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from meshes import BOX, SPHERE, random_rays, soup

import warpsample as ws
from warpsample.proof.rays import rays_inside
from warpsample.tracing import order
from warpsample.tracing.placement import make_placement
from warpsample.tracing.scene import scene_of
from warpsample.tracing.triples import Triples

TRIANGLE = ws.as_mesh(([(0, 0, 0), (2, 0, 0), (0, 2, 0)], [(0, 1, 2)]))
tracers = pytest.mark.parametrize("tracer", ["wide", "warp"])
queries = pytest.mark.parametrize("any_hit", [False, True], ids=["nearest", "any"])


def brute_force(mesh, origins, directions):
    """(distance, whether it is clear) of the nearest, by Moeller and Trumbore in float64; near an edge or grazing is not."""
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    d = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    p = np.cross(d[:, None], c - a)
    det = np.einsum("fk,rfk->rf", b - a, p)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = origins[:, None] - a
        u = np.einsum("rfk,rfk->rf", s, p) / det
        q = np.cross(s, b - a)
        v = np.einsum("rk,rfk->rf", d, q) / det
        t = np.einsum("fk,rfk->rf", c - a, q) / det
        inner = np.nan_to_num(np.minimum(np.minimum(u, v), 1.0 - u - v), nan=-1.0)
    height = np.abs(det) / (np.linalg.norm(b - a, axis=1) * np.linalg.norm(c - a, axis=1) + 1e-300)
    ahead = t > 0.0
    distance = np.where((inner >= 0.0) & ahead, t, np.inf).min(axis=1)
    near = (np.abs(inner) < 1e-3) | (height < 1e-3) | (np.abs(t) < 1e-4)
    return distance, ~(near & (t < distance[:, None] + 1e-3) & (inner > -1e-2)).any(axis=1)


# What the answers are


@tracers
@queries
def test_a_triangle(tracer, any_hit):
    origins = np.array(
        [[0.5, 0.5, 3.0], [0.5, 0.5, -3.0], [0.5, 0.5, 3.0], [1.5, 1.5, 3.0], [-1.0, 0.5, 0.0], [0.5, 0.5, 3.0]]
    )
    directions = np.array([[0, 0, -1.0], [0, 0, 1e-20], [0, 0, 1.0], [0, 0, -1.0], [1.0, 0, 0], [-0.3, 0, -3e20]])
    hits = ws.trace(TRIANGLE, origins, directions, any_hit=any_hit, tracer=tracer)
    assert hits.distance.tolist() == [3.0, 3.0, np.inf, np.inf, np.inf, 3.0]
    assert hits.face.tolist() == [0, 0, -1, -1, -1, 0]
    assert (hits.distance.dtype, hits.face.dtype, hits.tracer, hits.invalid) == (np.float32, np.int32, tracer, 0)


@tracers
@queries
def test_only_what_is_nearer_than_max_distance(tracer, any_hit):
    for limit, expected in ((3.01, 0), (2.99, -1), (0.0, -1), (0, -1), (np.inf, 0), (None, 0)):
        assert ws.trace(
            TRIANGLE, [0.5, 0.5, 3.0], [[0, 0, -7.0]], max_distance=limit, any_hit=any_hit, tracer=tracer
        ).face == [expected]


@queries
def test_max_distance_is_kept_to_the_last_bit(any_hit):
    """What is met is not met within just that distance, and is within the next float32: also where float32 cannot tell."""
    origins, directions = random_rays(300, 5)
    distances = ws.trace(SPHERE, origins, directions).distance
    assert np.isfinite(distances).sum() >= 30
    for o, d, distance in zip(origins, directions, distances, strict=True):
        if np.isfinite(distance):
            assert ws.trace(SPHERE, o, d[None], max_distance=float(distance), any_hit=any_hit).face[0] == -1
            next_one = float(np.nextafter(distance, np.float32(np.inf)))
            assert ws.trace(SPHERE, o, d[None], max_distance=next_one, any_hit=any_hit).face[0] >= 0


@queries
def test_faces_collapsed_to_points_are_not_met(any_hit):
    points = np.random.default_rng(6).uniform(-1.0, 1.0, (300, 3))
    mesh = ws.as_mesh((points, np.repeat(np.arange(300), 3).reshape(-1, 3)))
    origins = np.repeat(random_rays(20, 7)[0], 300, axis=0)
    assert (ws.trace(mesh, origins, np.tile(points, (20, 1)) - origins, any_hit=any_hit).face == -1).all()


@tracers
def test_against_brute_force_in_float64(tracer):
    mesh = soup()
    origins, directions = random_rays(3000)
    distance, clear = brute_force(mesh, origins, directions)
    assert clear.mean() > 0.9
    assert 0.3 < np.isfinite(distance).mean() < 0.97
    hits = ws.trace(mesh, origins, directions, tracer=tracer)
    # Coordinates of about 2 are rounded to 1e-7 of that; rays within 1e-3 of an edge or of a grazing face are left out.
    both = clear & np.isfinite(distance)
    assert np.array_equal(np.isfinite(hits.distance[clear]), np.isfinite(distance[clear]))
    assert np.abs(hits.distance[both] - distance[both]).max() <= 1e-4
    assert np.median(np.abs(hits.distance[both] - distance[both])) <= 2e-7
    some = ws.trace(mesh, origins, directions, any_hit=True, tracer=tracer)
    assert np.array_equal(some.face[clear] >= 0, np.isfinite(distance[clear]))
    assert (some.distance[both] >= hits.distance[both]).all()


def test_tracers_and_embree_agree_on_the_bunny(bunny):
    points = ws.sample_surface(bunny, 4096, seed=1)
    size = np.ptp(bunny.vertices, axis=0).max()
    scene = EmbreeScene()
    TriangleMesh(scene, bunny.vertices[bunny.faces].astype(np.float32))
    for side in (1.0, -1.0):
        origins = (points.position + side * 1e-4 * size * points.normal).astype(np.float32)
        directions = side * ws.sample_directions(points, 64, seed=2).vectors
        wide = ws.trace(bunny, origins, directions)
        warp = ws.trace(bunny, origins, directions, tracer="warp")
        flat = np.repeat(origins, 64, axis=0), directions.reshape(-1, 3)
        embree = np.asarray(scene.run(*flat, query="INTERSECT")).reshape(wide.face.shape)
        # None of 10^7 rays differed in whether they hit; 3 of 5 million in the face, at an edge within 6e-7 of its length.
        assert np.count_nonzero((wide.face >= 0) != (embree >= 0)) <= 1
        assert np.count_nonzero((wide.face >= 0) != (warp.face >= 0)) <= 1
        assert np.count_nonzero(wide.face != embree) <= 3
        same = (wide.face == warp.face) & (wide.face >= 0)
        assert np.abs(wide.distance[same] - warp.distance[same]).max() <= 3e-5 * size
        assert np.array_equal(ws.trace(bunny, origins, directions, any_hit=True).face >= 0, wide.face >= 0)


# The same answers however they are asked for


@tracers
def test_scale_and_place_do_not_matter(bunny, tracer):
    origins, directions = rays_inside(bunny, 1 << 14, 7)
    size = np.ptp(bunny.vertices, axis=0).max()
    plain = ws.trace(bunny, origins, directions, tracer=tracer)
    doubled = ws.trace(ws.Mesh(bunny.vertices * 2.0**20, bunny.faces), origins * 2.0**20, directions, tracer=tracer)
    assert np.array_equal(doubled.face, plain.face)
    assert np.array_equal(doubled.distance, plain.distance * 2.0**20)
    for scale, offset in ((1e-6, 0.0), (1e4, 5e6)):
        mesh = ws.Mesh(bunny.vertices * scale + offset, bunny.faces)
        moved = ws.trace(mesh, origins * scale + offset, directions, tracer=tracer)
        # Rounded otherwise: a ray in some 10^4 passes an edge on the other side, or grazes.
        same = moved.face == plain.face
        assert same.mean() > 0.999
        assert np.quantile(np.abs(moved.distance[same] / scale - plain.distance[same]), 0.99) <= 1e-6 * size


@queries
def test_workers_order_and_layout_change_no_bit(bunny, any_hit, monkeypatch):
    origins, directions = rays_inside(bunny, 1 << 15, 8)
    origins, directions = np.repeat(origins, 8, axis=0), directions.reshape(-1, 8, 3)
    shuffled = np.random.default_rng(0).permutation(len(origins))  # 4,096 points: so many that their order is looked at
    origins, directions = origins[shuffled], directions[shuffled]
    want = ws.trace(bunny, origins, directions, any_hit=any_hit, workers=1)
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    flat = ws.trace(bunny, np.repeat(origins, 8, axis=0), directions.reshape(-1, 3), any_hit=any_hit, workers=3)
    monkeypatch.setattr(order, "MANY_FACES", 1)
    sorts = []
    monkeypatch.setattr(np, "argsort", lambda *args, real=np.argsort, **how: sorts.append(1) or real(*args, **how))
    ordered = ws.trace(bunny, origins, directions, any_hit=any_hit, workers=3)
    assert sorts == [1]
    for got in (flat, ordered):
        assert np.array_equal(got.distance.ravel(), want.distance.ravel())
        assert np.array_equal(got.face.ravel(), want.face.ravel())


def test_one_origin_serves_all_directions(bunny):
    directions = np.random.default_rng(3).normal(size=(100, 3))
    origin = bunny.vertices.mean(axis=0)
    one = ws.trace(bunny, origin, directions)
    assert one.face.shape == (100,)
    assert np.array_equal(one.distance, ws.trace(bunny, np.tile(origin, (100, 1)), directions).distance)


def test_points_are_visited_cell_by_cell(monkeypatch):
    grid = np.stack(np.meshgrid(*3 * [np.linspace(-0.9, 0.9, 16)]), axis=-1).reshape(-1, 3)
    grid = np.random.default_rng(1).permutation(grid).astype(np.float32)
    monkeypatch.setattr(order, "MANY_FACES", 1)
    scene = scene_of(BOX)
    found = order.visiting_order(scene, make_placement(scene, Triples.of(grid, "a"), 1.0), 8, 1)
    assert sorted(found) == list(range(4096))
    assert (
        np.linalg.norm(np.diff(grid[found], axis=0), axis=1).mean()
        < 0.5 * np.linalg.norm(np.diff(grid, axis=0), axis=1).mean()
    )


@tracers
def test_kinds_of_arrays(tracer):
    origins, directions = random_rays(200)
    want = ws.trace(SPHERE, origins.astype(np.float32), directions.astype(np.float32), tracer=tracer)
    for dtype, vector in ((np.float32, wp.vec3), (np.float64, wp.vec3d)):
        arrays = [a.astype(dtype) for a in (origins, directions)]
        strided = [np.repeat(a, 2, axis=0)[::2] for a in arrays]
        vectors = [wp.array(a, dtype=vector, device="cpu") for a in arrays]
        numbers = [wp.array(a, device="cpu") for a in arrays]
        for o, d in (arrays, strided, [a.tolist() for a in arrays], vectors, numbers):
            got = ws.trace(SPHERE, o, d, tracer=tracer)
            distance, face = (a.numpy() if isinstance(a, wp.array) else a for a in (got.distance, got.face))
            assert isinstance(got.face, wp.array) == isinstance(o, wp.array)
            assert np.array_equal(face, want.face)
            assert np.allclose(distance, want.distance, rtol=0.0, atol=3e-6)


def test_origins_far_away_lose_no_digits():
    """Origins are 1e9 radii away in float64, from where a float32 direction alone would miss by 60 radii."""
    target = SPHERE.vertices[SPHERE.faces].mean(axis=1)[::50]
    way = np.random.default_rng(5).normal(size=target.shape)
    way *= -np.sign((way * target).sum(axis=1, keepdims=True)) / np.linalg.norm(way, axis=1, keepdims=True)
    aimed = np.abs((way * target).sum(axis=1)) > 0.1
    for tracer in ("wide", "warp"):
        hits = ws.trace(SPHERE, target - 1e9 * way, way, tracer=tracer)
        assert np.array_equal(hits.face[aimed], np.arange(0, len(SPHERE.faces), 50)[aimed])
        assert np.abs(hits.distance[aimed] - 1e9).max() <= 64.0  # float32's spacing there
    assert (ws.trace(SPHERE, target + 1e9 * way, way).face == -1).all()
