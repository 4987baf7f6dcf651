"""Work for threads and processes, run as a script by test_threads.py, since it may crash. Exit status 1 means failure."""

import multiprocessing
import os
import signal
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import trimesh
import warp as wp
from hangs import HANGS

import warpsample as ws

THREADS = 8
TORUS = trimesh.creation.torus(2.0, 0.5)


def torus(seed=0):
    """A mesh without any cached values."""
    return ws.Mesh(TORUS.vertices + np.random.default_rng(seed).normal(0.0, 0.01, TORUS.vertices.shape), TORUS.faces)


def answers(mesh, first=0, last=None):
    """The results for some faces of a mesh by every kind of call: sampled, traced, estimated."""
    centers = ws.face_centers(mesh)
    rows = slice(first, last)
    points = ws.SurfacePoints(centers.position[rows], centers.normal[rows], centers.face[rows])
    directions = ws.sample_directions(points, 16, distribution="beckmann(alpha=0.5)", first_point=first, pdf=True)
    hits = ws.trace(mesh, points, directions.vectors)
    occlusion = ws.ambient_occlusion(mesh, points, 64, first_point=first)
    blocked = ws.trace(mesh, points.position, points.normal, any_hit=True, tracer="warp").face >= 0
    return directions.vectors, directions.pdf, hits.distance, hits.face, occlusion.value, occlusion.standard_error, blocked


def same(found, right):
    return all(np.array_equal(a, b) for a, b in zip(found, right, strict=True))


def by_slices(mesh):
    """`answers` of all faces, a slice for each thread, all at once."""
    bounds = np.linspace(0, len(mesh.faces), THREADS + 1).astype(int)
    barrier = threading.Barrier(THREADS)

    def part(k):
        barrier.wait()
        return answers(mesh, bounds[k], bounds[k + 1])

    with ThreadPoolExecutor(THREADS) as threads:
        return [np.concatenate(parts) for parts in zip(*threads.map(part, range(THREADS)), strict=True)]


def first_use():
    """Kernels that no thread has loaded yet, and a mesh without a tree."""
    mesh = torus()
    return same(by_slices(mesh), answers(mesh))


def new_meshes():
    """Kernels are loaded already, and one new mesh follows the other."""
    answers(torus())
    return all(same(by_slices(torus(seed)), answers(torus(seed))) for seed in range(30))


def debugged():
    """Kernels that Warp builds for debugging crash when two threads run them at once."""
    wp.config.mode = "debug"
    up = np.tile(np.float32([0.0, 0.0, 1.0]), (1 << 14, 1))
    right = ws.sample_directions(up, 64, workers=1).vectors
    return all(np.array_equal(ws.sample_directions(up, 64, workers=2).vectors, right) for _ in range(50))


def refits():
    """Threads that bend one mesh, each in its own way, while others trace it."""
    mesh = torus()

    def bent(k):
        return answers(ws.refit(mesh, mesh.vertices * (1.0 + 0.1 * k)) if k % 2 else mesh)

    with ThreadPoolExecutor(THREADS) as threads:
        return all(same(found, bent(k)) for k, found in enumerate(threads.map(bent, range(THREADS))))


def in_child(seed):
    """More than 2^17 directions, enough for the threads of the pool, and estimates."""
    mesh = torus(seed)
    return (ws.sample_directions(ws.face_centers(mesh), 256, workers=2).vectors, *answers(mesh))


def processes(method):
    """A pool of processes after this one has used its threads."""
    right = [in_child(seed) for seed in range(3)]
    with multiprocessing.get_context(method).Pool(2) as pool:
        found = pool.map_async(in_child, range(3)).get(timeout=HANGS)
    return all(same(a, b) for a, b in zip(found, right, strict=True))


def slices():
    """A Pool by fork, after threads were used; its processes get the mesh with each slice, and make one tree of it."""
    mesh = torus()
    points = ws.face_centers(mesh)
    right = ws.ambient_occlusion(mesh, points, 64).value
    parts = np.array_split(np.arange(len(points)), 8)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        sent = [(mesh, ws.SurfacePoints(points.position[p], points.normal[p], points.face[p]), int(p[0])) for p in parts]
        found = pool.starmap_async(occlusion_and_mesh, sent, chunksize=1).get(timeout=HANGS)
    value, meshes = np.concatenate([part[0] for part in found]), {part[1:] for part in found}
    return np.array_equal(value, right) and len(meshes) == len({process for process, _ in meshes})


def occlusion_and_mesh(mesh, points, first):
    """The numbers of a slice, the process, and which of its meshes, so which of its trees, they are by."""
    _kept.append(mesh)
    return ws.ambient_occlusion(mesh, points, 64, first_point=first).value, os.getpid(), id(mesh)


_kept = []


def fork_while_making():
    """Forks again and again while another thread builds trees and loads kernels."""
    stop = threading.Event()

    def make():
        seed = 0
        while not stop.is_set():
            seed += 1
            answers(torus(seed))

    thread = threading.Thread(target=make)
    thread.start()
    right = in_child(1)
    pool = multiprocessing.get_context("fork")
    try:
        for _ in range(10):
            with pool.Pool(1) as one:
                if not same(one.apply_async(in_child, (1,)).get(timeout=HANGS), right):
                    return False
    finally:
        stop.set()
        thread.join()
    return True


def fork_while_multiplying():
    """Forks while another thread finds sky patches, by a matrix product: OpenBLAS ends its threads at a fork."""
    from warpsample.radiation.sky.patches import patches_at

    sky, directions, stop = ws.sky_patches("tregenza"), np.tile(np.float32([[0.0, 0.0, 1.0]]), (300_000, 1)), False

    def multiply():
        while not stop:
            patches_at(sky, directions)

    thread = threading.Thread(target=multiply)
    thread.start()
    try:
        for _ in range(20):
            child = os.fork()
            if child == 0:
                signal.alarm(int(HANGS))
                os._exit(0 if (patches_at(sky, directions) == len(sky) - 1).all() else 3)
            if os.waitpid(child, 0)[1] != 0:
                return False
    finally:
        stop = True
        thread.join()
    return True


def faces_changed():
    """The caller's own faces of points, changed between their check and their use, as by another thread."""
    from warpsample.tracing import placed_points

    mesh = torus()
    points = ws.sample_surface(mesh, 1000)
    right = ws.ambient_occlusion(mesh, points, 40).value, ws.trace(mesh, points, points.normal).distance
    good, set_starts = points.face.copy(), placed_points.set_starts

    def changed_first(*arguments, **how):
        points.face[:] = 2**30
        return set_starts(*arguments, **how)

    placed_points.set_starts = changed_first
    occlusion = ws.ambient_occlusion(mesh, points, 40).value
    points.face[:] = good
    return same((occlusion, ws.trace(mesh, points, points.normal).distance), right)


def stress(seconds=60.0, threads=16):
    """Mixed calls from many threads, on shared meshes and on their own; every result is that of one thread."""
    shared = [torus(seed) for seed in range(4)]
    moved = [1.5 * mesh.vertices for mesh in shared]
    end = time.monotonic() + seconds
    jobs = {
        "shared": lambda k: answers(shared[k]),
        "own": lambda k: answers(torus(k)),
        "refit": lambda k: answers(ws.refit(shared[k], moved[k])),
        "surface": lambda k: (ws.sample_surface(torus(k), 1000, seed=k).position,),
        "sky": lambda k: (ws.sky_view_factor(shared[k], ws.vertex_points(shared[k]), 40).value,),
        "cold": lambda k: (
            ws.sample_directions(np.eye(3), 20, distribution=KINDS[k].cases()[0], sequence=SEQUENCES[k]).vectors,
        ),
    }

    def work(thread):
        rng = np.random.default_rng(thread)
        done = []
        while time.monotonic() < end:
            name, k = rng.choice(list(jobs)), int(rng.integers(4))
            done.append((name, k, jobs[name](k)))
            done = done[-20:]
        return done

    with ThreadPoolExecutor(threads) as pool:
        done = [item for part in pool.map(work, range(threads)) for item in part]
    right = {(name, k): jobs[name](k) for name, k, _ in done}
    return len(done) >= threads and all(same(found, right[name, k]) for name, k, found in done)


KINDS = (ws.GGX, ws.UniformSphere, ws.OffsetBall, ws.VonMisesFisher)
SEQUENCES = ("sobol", "r2", "independent", "stratified")

if __name__ == "__main__":
    task, *rest = sys.argv[1:]
    sys.exit(0 if globals()[task](*rest) else 1)
