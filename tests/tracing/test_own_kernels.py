"""Rays in kernels of a user's own: the answers of `trace`, bit for bit, wherever rays come from."""

import gc
import subprocess
import sys
import weakref
from pathlib import Path

import numpy as np
import pytest
import warp as wp
from meshes import CLOSED, random_rays, soup

import warpsample as ws
from warpsample import funcs
from warpsample.proof.rays import rays_inside
from warpsample.tracing.scene import scene_of

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

wp.set_module_options({"enable_backward": False})


@wp.kernel
def ask(
    tree: funcs.Tree,
    origins: wp.array[wp.vec3d],
    directions: wp.array[wp.vec3],
    limit: float,
    distance: wp.array[wp.float32],
    face: wp.array[wp.int32],
    met: wp.array[wp.int32],
):
    i = wp.tid()
    near, which = funcs.nearest_hit(tree, origins[i], directions[i], limit)
    distance[i] = near
    face[i] = which
    met[i] = wp.where(funcs.any_hit(tree, origins[i], directions[i], limit), 1, 0)


def ask_all(tree, origins, directions, limit=np.inf):
    count = len(directions)
    found = [wp.zeros(count, dtype=kind, device="cpu") for kind in (wp.float32, wp.int32, wp.int32)]
    origins = wp.array(np.ascontiguousarray(origins, np.float64), dtype=wp.vec3d, device="cpu")
    directions = wp.array(np.ascontiguousarray(directions, np.float32), dtype=wp.vec3, device="cpu")
    wp.launch(ask, count, inputs=[tree, origins, directions, limit], outputs=found, device="cpu")
    return [array.numpy() for array in found]


def cases():
    origins, directions = random_rays(4000)
    yield "soup", soup(), origins, directions, np.inf
    yield "soup, short", soup(), origins, directions, 0.5
    yield "soup, from far away", soup(), origins * 1e5, -origins, np.inf
    scale = np.geomspace(1e30, 1e39, len(origins))[:, None]
    yield (
        "soup, farther away than float32 tells",
        ws.Mesh(1e30 * soup().vertices, soup().faces),
        scale * origins,
        -origins,
        np.inf,
    )
    for name, (mesh, _) in CLOSED.items():
        inside, ways = rays_inside(mesh, 64, 40)
        yield name, mesh, np.repeat(inside, ways.size // inside.size, axis=0), ways.reshape(-1, 3), np.inf
    shift = np.array([5e6, -4e6, 100.0])
    moved = ws.Mesh(soup().vertices + shift, soup().faces)
    yield "soup on a map", moved, origins + shift, directions, np.inf


@pytest.mark.parametrize(("mesh", "origins", "directions", "limit"), [pytest.param(*c[1:], id=c[0]) for c in cases()])
def test_answers_are_those_of_trace(mesh, origins, directions, limit):
    directions = directions.astype(np.float32)
    distance, face, met = ask_all(ws.tree(mesh), origins, directions, limit)
    for any_hit in (False, True):
        hits = ws.trace(mesh, origins, directions, max_distance=None if limit == np.inf else limit, any_hit=any_hit)
        assert np.array_equal(met == 1, hits.face >= 0)
        if not any_hit:
            assert np.array_equal(face, hits.face)
            assert np.array_equal(distance, hits.distance, equal_nan=True)
    assert np.count_nonzero(met) > 0


def test_invalid_rays(bunny):
    bad = np.float32([(0, 0, 0), (np.nan, 0, 1), (0, np.inf, 0), (0, 0, 1)])
    origins = np.float64([(0, 0, 0)] * 3 + [(np.nan, 0, 0)])
    distance, face, met = ask_all(ws.tree(bunny), origins, bad)
    assert np.isnan(distance).all()
    assert face.tolist() == [-1] * 4
    assert met.tolist() == [0] * 4
    triangle = ws.as_mesh(([(0, 0, 0), (2, 0, 0), (0, 2, 0)], [(0, 1, 2)]))
    shortest = np.float32([(0, 0, -1e-45), (0, 0, -1e-40), (0, 0, -3e38)])
    distance, face, met = ask_all(ws.tree(triangle), np.float64([(0.5, 0.5, 3.0)] * 3), shortest)
    assert (distance.tolist(), face.tolist(), met.tolist()) == ([3.0] * 3, [0] * 3, [1] * 3)


def test_the_tree_keeps_its_memory(bunny):
    """The mesh may go, and its own tree with it."""
    mesh = ws.Mesh(bunny.vertices, bunny.faces)
    origins, directions = rays_inside(mesh, 500, 4)
    origins, directions = np.repeat(origins, directions.size // origins.size, axis=0), directions.reshape(-1, 3)
    expected = ws.trace(mesh, origins, directions.astype(np.float32)).distance
    tree = ws.tree(mesh)
    del mesh
    gc.collect()
    filler = [np.full(10**6, np.nan, np.float32) for _ in range(8)]
    assert np.array_equal(ask_all(tree, origins, directions)[0], expected)
    assert len(filler) == 8


@wp.struct
class Holder:
    tree: funcs.Tree


def test_a_struct_that_holds_a_tree_keeps_its_memory(bunny):
    """That of a device too, which no array of the tree is in: a struct in a struct is a copy."""
    mesh, holder = ws.Mesh(bunny.vertices, bunny.faces), Holder()
    scene = weakref.ref(scene_of(mesh))
    holder.tree = ws.tree(mesh)
    del mesh
    gc.collect()
    assert scene() is not None
    del holder
    gc.collect()
    assert scene() is None


@wp.kernel
def occlusion(
    tree: funcs.Tree,
    position: wp.array[wp.vec3d],
    normal: wp.array[wp.vec3],
    count: int,
    out: wp.array[wp.float32],
):
    p = wp.tid()
    n = wp.normalize(normal[p])
    frame = funcs.frame_about(n)
    origin = funcs.offset_origin(tree, position[p], n)
    for j in range(count):
        u = funcs.fibonacci(wp.uint64(0), wp.uint64(p), wp.uint32(j), wp.uint32(count))
        w = funcs.to_world(frame, funcs.square_to_cosine_hemisphere(u))
        if not funcs.any_hit(tree, origin, w, wp.INF):
            out[p] += 1.0 / float(count)


def test_occlusion_in_ten_lines(bunny, points):
    out = wp.zeros(len(points), dtype=wp.float32, device="cpu")
    position = wp.array(points.position.astype(np.float64), dtype=wp.vec3d, device="cpu")
    normal = wp.array(points.normal, dtype=wp.vec3, device="cpu")
    wp.launch(occlusion, len(points), inputs=[ws.tree(bunny), position, normal, 512], outputs=[out], device="cpu")
    built_in = ws.ambient_occlusion(bunny, points, 4096)
    error = out.numpy() - built_in.value
    # An edge through 512 points of a lattice is off by about 0.5 * 512^(-3/4) = 0.005, and several edges by some of that.
    assert np.abs(error).max() <= 0.03
    assert abs(error.mean()) <= 4.0 * error.std() / np.sqrt(len(points)) + 1e-4


def test_a_wrong_device_is_named(bunny):
    with pytest.raises(ValueError, match="^device: got 'cuda:7', want one of cpu"):
        ws.tree(bunny, device="cuda:7")
    with pytest.raises(TypeError, match="^device: got 7, want one of cpu"):
        ws.tree(bunny, device=7)


def test_a_tape_takes_the_answers_as_constants(child_environment):
    """In a child process: a backward pass through the memory of the tree gave NaN, or, in a larger mesh, crashed."""
    script = Path(__file__).parents[1] / "support" / "tape_of_rays.py"
    done = subprocess.run([sys.executable, script], env=child_environment, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.skipif(wp.is_cuda_available(), reason="a CUDA device")
def test_a_missing_device_is_named_by_one_error_alone(bunny, capfd):
    """Warp would print its driver's to stderr."""
    with pytest.raises(ValueError, match="^device: got 'cuda', want one of cpu$"):
        ws.tree(bunny, device="cuda")
    assert capfd.readouterr().err == ""
