"""Rays that leave together meet what each meets alone: at edges, corners, needles, from within planes and from afar."""

import numpy as np
import pytest
import warp as wp
from margin_cases import launch, on_cpu, unit
from meshes import soup

import warpsample as ws
from warpsample.bench import scenes
from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, Accelerator, set_direction, start_all
from warpsample.tracing.scene import scene_of
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.packets import first_rays, ray_set
from warpsample.tracing.sight.point import point_in, workspace_floats
from warpsample.tracing.sight.rays import first_hit, prepare_rays, rays_blocked

ORIGINS = 256
_FLOATS = workspace_floats(0, packets=True)
_hit, _blocked, _prepare = first_hit(any_hit=True), rays_blocked(), prepare_rays()


@wp.kernel(enable_backward=False, module="unique")
def _both(
    tree: Accelerator,
    origins: wp.array[wp.vec3],
    normals: wp.array[wp.vec3],
    directions: wp.array2d[wp.vec3],
    reaches: wp.array[wp.float32],
    rays: wp.array[wp.uint64],
    together: wp.array[wp.uint64],
    alone: wp.array[wp.uint64],
):
    """The rays that meet something: of the first `length` of a chunk, those in the set. Without a normal from the root."""
    i = wp.tid()
    workspace = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
    point = point_in(workspace.ptr, 0, CHUNK_FLOATS)
    point.o = origins[i]
    point.position = wp.vec3d(point.o)
    point.n = normals[i]
    point.reach = reaches[i]
    start_all(point.chunk, point.o, point.reach)
    for k in range(CHUNK):
        set_direction(point.chunk, k, directions[i, k])
    length = 1 + i % CHUNK
    seen = tree
    local = wp.int32(0)
    if wp.length(point.n) > 0.0:
        seen, local, _opened = open_around(tree, point)
    _prepare(seen, point, local, length)
    asked = rays[i] & first_rays(length)
    together[i] = _blocked(seen, point, local, asked, length)
    for k in range(length):
        distance, _face = _hit(seen, point, local, k)
        if (asked & ray_set(k)) != wp.uint64(0) and distance < wp.INF:
            alone[i] = alone[i] | ray_set(k)


def grid():
    """A square cut into right triangles whose corners are multiples of 1/4, with upright needles and walls on it."""
    x, y = np.meshgrid(np.arange(9) / 4.0 - 1.0, np.arange(9) / 4.0 - 1.0)
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(81)], axis=1)
    corner = (np.arange(8)[:, None] * 9 + np.arange(8)).ravel()
    faces = np.concatenate([corner[:, None] + [0, 1, 10], corner[:, None] + [0, 10, 9]])
    feet = np.random.default_rng(5).uniform(-1.0, 1.0, (60, 1, 3)) * [1.0, 1.0, 0.0]
    needles = feet + np.array([[0.0, 0.0, 0.0], [1e-6, 0.0, 0.0], [0.0, 1e-6, 1.0]])
    upright = np.array([[[0.5, y, 0.0], [0.5, y + 0.25, 0.0], [0.5, y, 0.5]] for y in np.arange(-4, 4) / 4.0])
    free = np.concatenate([needles, upright]).reshape(-1, 3)
    return np.concatenate([vertices, free]), np.concatenate([faces, 81 + np.arange(len(free)).reshape(-1, 3)])


def shrinking():
    """Triangles about a corner, each half as large as the last: a deep tree, and some smaller than rounding."""
    return np.concatenate([np.roll(np.eye(3), k, axis=1) * 2.0**-k for k in range(60)]), np.arange(180).reshape(-1, 3)


def scene_named(name):
    vertices, faces = {
        "grid": grid,
        "shrinking": shrinking,
        "soup": lambda: (soup().vertices, soup().faces),
        "city": lambda: (scenes.city(6).vertices, scenes.city(6).faces),
    }[name]()
    return scene_of(ws.as_mesh((vertices, faces)))


def tree_of(scene):
    """The argument of the kernel; the scene keeps what it names."""
    given, tree = scene.tree(1).accelerator(), Accelerator()
    tree.nodes, tree.leaves, tree.start, tree.starts = given.nodes, given.leaves, given.start, given.starts
    return tree


def size_of_sets(sets):
    return int(np.unpackbits(sets.view(np.uint8)).sum())


def targets_of(rng, corners):
    """(ORIGINS, CHUNK, 3) places: corners of triangles, places on their sides and in them, or anywhere."""
    weights = rng.dirichlet([1.0, 1.0, 1.0], (ORIGINS, CHUNK))
    weights[:, ::4] = [1.0, 0.0, 0.0]
    weights[:, 1::4, 2] = 0.0
    weights[:, 1::4, 1] = 1.0 - weights[:, 1::4, 0]
    chosen = corners[rng.integers(len(corners), size=(ORIGINS, CHUNK))]
    places = (weights[..., None] * chosen).sum(axis=2)
    places[:, 3::8] = rng.uniform(-1.0, 1.0, places[:, 3::8].shape)
    return places


def origins_of(rng, corners):
    """(ORIGINS, 3) float32: anywhere near, at corners, in planes and on sides of triangles, at 6, the most."""
    origins = rng.uniform(-1.0, 1.0, (ORIGINS, 3))
    some = corners[rng.integers(len(corners), size=ORIGINS)].astype(np.float64)
    origins[1::5] = some[1::5, 0]
    origins[2::5] = (3.0 * some[:, 0] - some[:, 1] - some[:, 2])[2::5]  # in the plane, beside it
    origins[3::5] = some.mean(axis=1)[3::5]
    origins[4::5] *= 6.0
    return np.clip(origins, -6.0, 6.0).astype(np.float32)


@pytest.mark.parametrize("opened", [False, True])
@pytest.mark.parametrize("name", ["grid", "shrinking", "soup", "city"])
@pytest.mark.filterwarnings("ignore:mesh. got faces of size:UserWarning")  # "shrinking"
def test_rays_meet_together_what_each_meets_alone(name, opened):
    scene, rng = scene_named(name), np.random.default_rng(7)
    corners = scene.vertices[scene.faces]
    origins, targets = origins_of(rng, corners), targets_of(rng, corners)
    normals = unit(targets[:, 0] - origins + 1e-3) if opened else np.zeros((ORIGINS, 3), np.float32)
    ways = targets - origins[:, None] + 1e-12 * rng.normal(size=targets.shape)
    distances = np.linalg.norm(ways, axis=2)
    ways = unit(ways)
    if opened:
        ways = np.where(np.einsum("ijk,ik->ij", ways, normals)[..., None] >= 2.0**-12, ways, normals[:, None])
    reaches = np.full(ORIGINS, np.inf, np.float32)
    reaches[::3] = np.median(distances, axis=1)[::3]
    reaches[1::3] = distances[1::3, 0] * (1.0 + rng.choice([-1e-7, 0.0, 1e-7], len(distances[1::3])))  # that of a target
    sets = wp.array(rng.integers(1 << 63, size=ORIGINS, dtype=np.uint64) * np.uint64(2) + np.uint64(1), device="cpu")
    inputs = [tree_of(scene), on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3), on_cpu(ways, wp.vec3)]
    outputs = [wp.zeros(ORIGINS, wp.uint64, device="cpu") for _ in range(2)]
    together, alone = launch(_both, ORIGINS, [*inputs, on_cpu(reaches), sets], *outputs)
    assert np.array_equal(together, alone)
    first = np.uint64(2**64 - 1) >> (CHUNK - 1 - np.arange(ORIGINS) % CHUNK).astype(np.uint64)
    asked = size_of_sets(sets.numpy() & first)
    assert 0.05 * asked <= size_of_sets(alone) <= 0.95 * asked
