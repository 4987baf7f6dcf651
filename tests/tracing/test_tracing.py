"""Rays: both tracers against closed forms, brute force in float64, Embree and each other; nothing gets through an edge."""

import ctypes
import mmap
import re
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from meshes import BOX, CLOSED, SPHERE, random_rays, soup

import warpsample as ws
from warpsample.host import engine
from warpsample.proof import report
from warpsample.proof.rays import judge_mesh, rays_inside
from warpsample.tracing import order, trace
from warpsample.tracing.builtin import builtin_any_query, builtin_query, prepare_builtin
from warpsample.tracing.rays import ray_kernel
from warpsample.tracing.scene import scene_of
from warpsample.tracing.wide.layout import CHUNK
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.wide.query import wide_query

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
        assert ws.trace(TRIANGLE, [0.5, 0.5, 3.0], [[0, 0, -7.0]], limit, any_hit, tracer).face == [expected]


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


# Nothing gets through


@pytest.mark.parametrize("name", CLOSED)
def test_no_ray_leaves_a_closed_mesh(name):
    verdicts = judge_mesh(name, *CLOSED[name], 1 << 18, 100_000)
    assert [verdict for verdict in verdicts if not verdict.passed] == []
    assert {verdict.law for verdict in verdicts} <= report._SUMMARIES.keys()  # so that it has a table
    assert not re.search(r"wp.Mesh 0$", verdicts[1].note)  # so aiming at edges is a trial


def test_float32_rays_leave_no_closed_mesh_either():
    for mesh, _ in CLOSED.values():
        origins, directions = rays_inside(mesh, 1 << 16, 3)
        assert (ws.trace(mesh, origins.astype(np.float32), directions).face >= 0).all()


def test_leaks_are_found():
    """In trees with a triangle missing, and with boxes a little too small."""
    missing, small = (ws.Mesh(SPHERE.vertices, SPHERE.faces) for _ in range(2))
    scene_of(missing).tree(1).leaves[7, :12, 3] = 0.0
    scene_of(small).tree(1).nodes[:, :3] += np.float32(2e-3)
    for mesh in (missing, small):
        broken = {v.law for v in judge_mesh("damaged", mesh, (0.0, 0.0, 0.0), 1 << 18, 100_000) if not v.passed}
        assert broken >= {"rays that leave a closed mesh", "rays between two faces"}


def test_points_that_start_on_their_face_are_found(monkeypatch):
    mesh = ws.Mesh(SPHERE.vertices, SPHERE.faces)

    def not_moved(scene, rays, *_):
        """The starts, right on the faces."""
        places = np.ctypeslib.as_array((ctypes.c_double * (3 * rays.points)).from_address(rays.origins)).reshape(-1, 3)
        return np.repeat(((places - scene.centre) * scene.scale).astype(np.float32)[:, None], 2, axis=1)

    monkeypatch.setattr("warpsample.tracing.trace.starts_of", not_moved)
    broken = {v.law for v in judge_mesh("sphere", mesh, (0.0, 0.0, 0.0), 1 << 16, 64) if not v.passed}
    assert "rays that meet their own face" in broken


@tracers
@pytest.mark.parametrize("name", CLOSED)
@pytest.mark.parametrize(("scale", "offset"), [(1.0, 0.0), (1e-6, 0.0), (1e3, 5e6), (5e6, 0.0)])
def test_surface_points_start_off_their_own_face(name, scale, offset, tracer):
    """From a convex mesh all rays outward escape; inward all meet another face, at any scale and far from the origin."""
    mesh = ws.Mesh(CLOSED[name][0].vertices * scale + offset, CLOSED[name][0].faces)
    points = ws.sample_surface(mesh, 2000, seed=5)
    cosines = ws.sample_directions(points, 16, seed=6).vectors
    # Closer to the horizon a direction's own rounding decides on which side of the next face a ray passes.
    up = (cosines * points.normal[:, None]).sum(axis=2) > 1e-5
    outward, inward = (ws.trace(mesh, points, way, tracer=tracer).face for way in (cosines, -cosines))
    assert not (outward == points.face[:, None])[up].any()
    assert not (inward == points.face[:, None])[up].any()
    assert np.count_nonzero(inward[up] < 0) <= (0 if tracer == "wide" else 5)
    if name != "torus":
        assert (outward == -1)[up].all()


def test_points_that_are_float32_themselves_are_moved_off_further():
    mesh = ws.Mesh(SPHERE.vertices * 1e3 + 5e6, SPHERE.faces)
    exact = ws.sample_surface(mesh, 2000, seed=5)
    points = ws.SurfacePoints(exact.position.astype(np.float32), exact.normal)  # off by up to 0.25
    cosines = ws.sample_directions(points, 16, seed=6).vectors
    up = (cosines * points.normal[:, None]).sum(axis=2) > 1e-2
    assert (ws.trace(mesh, points, cosines).face == -1)[up].all()


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
    origins, directions = rays_inside(bunny, 1 << 14, 8)
    shuffled = np.random.default_rng(0).permutation(len(origins))
    origins, directions = origins[shuffled], directions[shuffled]
    want = ws.trace(bunny, origins, directions, any_hit=any_hit, workers=1)
    monkeypatch.setattr("warpsample.host.engine._LEAST_WORK", 1)
    flat = ws.trace(bunny, np.repeat(origins, 64, axis=0), directions.reshape(-1, 3), any_hit=any_hit, workers=3)
    monkeypatch.setattr(trace, "MANY_FACES", 1)
    monkeypatch.setattr(order, "_FEW_POINTS", 1)
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
    monkeypatch.setattr(order, "_FEW_POINTS", 1)
    grid = np.stack(np.meshgrid(*3 * [np.linspace(-0.9, 0.9, 8)]), axis=-1).reshape(-1, 3)
    grid = np.random.default_rng(1).permutation(grid).astype(np.float32)
    start, way = trace.Triples.of(grid, "a"), trace.Triples.of(np.ones((512, 8, 3), np.float32), "b")
    distance, face = way.empty(np.float32), way.empty(np.int32)
    found = order.order_of(trace.job_of(scene_of(BOX), start, way, 1.0, distance, face), 1)
    assert sorted(found) == list(range(512))
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
    """From 1e9 radii away in float64, where a float32 direction alone would miss by 60 radii."""
    target = SPHERE.vertices[SPHERE.faces].mean(axis=1)[::50]
    way = np.random.default_rng(5).normal(size=target.shape)
    way *= -np.sign((way * target).sum(axis=1, keepdims=True)) / np.linalg.norm(way, axis=1, keepdims=True)
    aimed = np.abs((way * target).sum(axis=1)) > 0.1
    for tracer in ("wide", "warp"):
        hits = ws.trace(SPHERE, target - 1e9 * way, way, tracer=tracer)
        assert np.array_equal(hits.face[aimed], np.arange(0, len(SPHERE.faces), 50)[aimed])
        assert np.abs(hits.distance[aimed] - 1e9).max() <= 64.0  # float32's spacing there
    assert (ws.trace(SPHERE, target + 1e9 * way, way).face == -1).all()


# What is no ray


@tracers
@queries
def test_what_is_no_ray_is_counted(tracer, any_hit):
    origins, directions = np.tile([[0.5, 0.5, 3.0]], (7, 1)), np.tile([[0.0, 0.0, -1.0]], (7, 1))
    directions[1], directions[2, 1], directions[3, 0] = 0.0, np.nan, np.inf
    origins[4, 2], origins[5, 0] = np.nan, -np.inf
    for dtype in (np.float32, np.float64):
        hits = ws.trace(TRIANGLE, origins.astype(dtype), directions.astype(dtype), any_hit=any_hit, tracer=tracer)
        assert hits.face.tolist() == [0, -1, -1, -1, -1, -1, 0]
        assert np.isnan(hits.distance).tolist() == [False, True, True, True, True, True, False]
        assert hits.invalid == 5


def test_no_rays_at_all():
    hits = ws.trace(TRIANGLE, np.empty((0, 3)), np.empty((0, 3)))
    assert (hits.distance.shape, hits.face.shape, hits.invalid) == ((0,), (0,), 0)
    assert ws.trace(TRIANGLE, np.empty((5, 3)), np.empty((5, 0, 3))).face.shape == (5, 0)


# Bad input


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"mesh": 3}, TypeError, "mesh: got a value of type int"),
        ({"mesh": (np.eye(3), np.empty((0, 3), int))}, ValueError, "faces: got shape"),
        (
            {"mesh": (np.eye(3) * np.nan, [[0, 1, 2]])},
            ValueError,
            "vertices: got coordinates that are not finite, the first in row 0",
        ),
        ({"mesh": (np.eye(3), [[0, 1, 3]])}, ValueError, "faces: got indices from 0 to 3, the first wrong one in face 0"),
        ({"origins": [[0, 0, 1]]}, TypeError, "origins: got dtype int64, want float32 or float64"),
        ({"origins": np.zeros((1, 2))}, ValueError, r"origins: got shape \(1, 2\), want \(P, 3\) or \(3,\)"),
        ({"directions": 0.5}, ValueError, r"directions: got shape \(\), want \(P, 3\) or \(P, n, 3\)"),
        ({"directions": np.ones((2, 3))}, ValueError, r"directions: got shape \(2, 3\), want \(1, 3\) or \(1, 'n', 3\)"),
        ({"directions": np.ones((1, 2, 2, 3))}, ValueError, r"directions: got shape \(1, 2, 2, 3\), want"),
        (
            {"directions": wp.zeros(1, dtype=wp.vec3, device="cpu")},
            ValueError,
            "directions: got a wp.array on cpu, want a NumPy array",
        ),
        ({"directions": wp.zeros(3, dtype=wp.int32, device="cpu")}, TypeError, "directions: got a wp.array of int32"),
        ({"directions": wp.zeros((2, 2), dtype=wp.vec3, device="cpu")[:, 0]}, ValueError, "directions: .* not contiguous"),
        ({"max_distance": -1.0}, ValueError, "max_distance: got -1.0, want a number from 0 to inf"),
        ({"max_distance": np.nan}, ValueError, "max_distance: got nan, want"),
        ({"max_distance": "far"}, TypeError, "max_distance: got 'far', want"),
        ({"tracer": "embree"}, ValueError, "tracer: got 'embree', want one of auto, wide, warp"),
        ({"workers": 0}, ValueError, "workers: got 0, want"),
    ],
)
def test_bad_input_is_named(arguments, error, message):
    good = {"mesh": TRIANGLE, "origins": np.zeros((1, 3)), "directions": np.ones((1, 3))}
    with pytest.raises(error, match=message):
        ws.trace(**{**good, **arguments})


@pytest.mark.parametrize("face", [1, 2**31 - 1])
def test_points_of_another_mesh_are_refused(face):
    point = ws.SurfacePoints(np.zeros((1, 3)), np.float32([[0.0, 0.0, 1.0]]), np.int32([face]))
    with pytest.raises(ValueError, match=f"origins: got points on faces {face} to {face}, want -1 .none. to 0"):
        ws.trace(TRIANGLE, point, np.ones((1, 3)))


def test_too_many_hits_for_the_memory(monkeypatch):
    directions = np.zeros((1 << 22, 3), np.float32)
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=10**7))
    with pytest.raises(
        MemoryError, match=r"the hits of 4,194,304 rays need 0.0 GB and 0.0 GB are free; trace them in parts"
    ):
        ws.trace(TRIANGLE, [0.0, 0.0, 0.0], directions)


def reserved(dtype, count):
    """An array that takes memory only where it is written to."""
    flags = mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | getattr(mmap, "MAP_NORESERVE", 0x4000)
    return np.frombuffer(mmap.mmap(-1, count * np.dtype(dtype).itemsize, flags=flags), dtype, count)


@pytest.mark.parametrize("per_point", [1, 2**31 + 2**20])
def test_beyond_two_to_the_31_rays(per_point):
    """The last of 2^31 + 2^20 rays, of as many points or of one."""
    rays = 2**31 + 2**20
    try:
        directions, distance, face = reserved(np.float32, 3 * rays), reserved(np.float32, rays), reserved(np.int32, rays)
        origins = reserved(np.float32, 3 * rays // per_point)
    except OSError:
        pytest.skip("this machine does not hand out address space that it has no memory for")
    directions[-3:], origins[-3:] = [0.0, 0.0, -1.0], [0.5, 0.5, 3.0]
    scene = scene_of(TRIANGLE)
    start, way = (trace.Triples.of(a.reshape(-1, 3), "rays") for a in (origins, directions))
    start = start if per_point == 1 else trace.Triples.of(origins, "one")
    job = trace.job_of(scene, start, way, np.inf, distance, face)
    job.block, tasks = CHUNK, -(-rays // CHUNK)
    kernel = ray_kernel(prepare_wide, wide_query(False))
    command = engine._take(kernel, [job, scene.tree(1).accelerator()], wp.get_device("cpu"))
    engine._run_chunks(command, iter([tasks - 10]), 10, tasks)
    assert (distance[-1], face[-1]) == (3.0, 0)
    assert np.isnan(distance[-10 * CHUNK : -1]).all()  # of zero directions


# Fast, and portable

_REMARKS = """
import sys
import warp as wp
wp.config.log_level = wp.LOG_WARNING
wp.config.cpu_compiler_flags += " -Rpass=loop-vectorize -Rpass-missed=loop-vectorize"
import warpsample as ws
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.slots import Slots
from warpsample.estimate.weights import everywhere
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.rays import ray_kernel
from warpsample.tracing.wide.query import wide_query
estimate = (ws.sequences.get("fibonacci"), ws.CosineHemisphere("polar").about(), everywhere, True, True, 1)
for kernel in (
    ray_kernel(prepare_wide, wide_query(False)),
    ray_kernel(prepare_wide, wide_query(True)),
    estimate_kernel(Slots(*estimate, prepare_wide, wide_query(True, several=True), True, True)),
):
    print("@@", file=sys.stderr, flush=True)
    wp.load_module(kernel.module, device="cpu")
"""


@pytest.mark.slow
def test_the_hot_loops_are_vectorised(tmp_path, child_environment):
    """By the compiler's own remarks.

    Of rays: those over a node's boxes, a leaf's triangles, and a chunk's rays (two). Of an estimate: boxes, triangles and
    preparation; start, variates and directions of a cell's rays; children and triangles above the horizon; a beam's planes,
    boxes and triangles.
    """
    script = tmp_path / "remarks.py"
    script.write_text(_REMARKS)
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / "cache")}
    done = subprocess.run([sys.executable, script], env=environment, capture_output=True, text=True, check=True)
    _, *compiled = done.stderr.split("@@")
    for remarks, loops in zip(compiled, (4, 4, 11), strict=True):
        hot = re.findall(
            r"\.cpp:(\d+):\d+: remark: vectorized loop \(vectorization width: (\d+).*\n.*goto end_while_", remarks
        )
        assert len({line for line, _ in hot}) == loops, remarks
        assert min(int(width) for _, width in hot) >= 4  # lanes of SSE, the narrowest
        assert not re.search(r"loop not vectorized.*\n.*goto end_while_", remarks), remarks


KERNELS = {
    "wide": (prepare_wide, wide_query(False)),
    "warp": (prepare_builtin, builtin_query),
    "warp, any": (prepare_builtin, builtin_any_query),
}


@pytest.mark.parametrize("name", KERNELS)
def test_both_tracers_compile_for_cuda(name, tmp_path):
    kernel = ray_kernel(*KERNELS[name])
    (ptx,) = wp.compile_aot_module(kernel.module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
    assert ".visible .entry" in ptx.read_text()
