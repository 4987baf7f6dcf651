"""Ray tracers of each tool, as functions (any_hit, workers) that return a function to time.

The timed function returns (R,) bool, True for a ray with a hit.
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import pairwise, starmap
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.scenes import build_rays
from warpsample.host.arrays import cpu
from warpsample.mesh.mesh import Mesh
from warpsample.tracing.given_rays import rays_of
from warpsample.tracing.placement import make_placement
from warpsample.tracing.rays import build_hit_writer, launch_rays, ray_kernel, trace_rays
from warpsample.tracing.scene import Scene, scene_of
from warpsample.tracing.trace import Hits, trace
from warpsample.tracing.tracers import BUILTIN, WIDE
from warpsample.tracing.triples import Triples

Hit = Callable[[], np.ndarray]
RayTool = Callable[[bool, int], Hit]
"""(whether any hit is query for, workers) -> the work."""

_PARTS = 8  # parts of the rays per thread, for a tool without threads of its own


def build_wide_tool(mesh: Mesh, kind: str, count: int) -> RayTool:
    """Build the ray tracer of warpsample's 16-wide tree, called by `trace`."""
    rays = build_rays(mesh, kind, count)
    return lambda any_hit, workers: (
        lambda: trace(mesh, *rays, any_hit=any_hit, tracer="wide", workers=workers).face.ravel() >= 0
    )


def count_visits(mesh: Mesh, kind: str, count: int, any_hit: bool) -> tuple[float, float]:
    """Return the mean numbers of (nodes, leaves) of the 16-wide tree that a ray visits."""
    scene = scene_of(mesh)
    start, way = (Triples.of(array, "rays") for array in build_rays(mesh, kind, count))
    # A name keeps the arrays alive while `query` holds their addresses.
    hits = Hits(way.empty(np.float32), way.empty(np.int32), "wide")
    query = rays_of(make_placement(scene, start, np.inf), way, hits)
    counts = np.zeros((*way.shape, 2), np.int32)
    query.visits = counts.ctypes.data
    trace_rays(scene, query, tracer=WIDE, any_hit=any_hit, device=way.device, workers=1)
    nodes, leaves = counts.reshape(-1, 2).mean(axis=0)
    return float(nodes), float(leaves)


def _warp_mesh(mesh: Mesh, kind: str, count: int) -> RayTool:
    """Build the ray tracer of wp.Mesh: the nearest-hit query by `trace`, or the any-hit query in a kernel.

    The any-hit query returns no face.
    """
    scene, rays = scene_of(mesh), build_rays(mesh, kind, count)

    def hits(any_hit: bool, workers: int) -> Hit:
        if not any_hit:
            return lambda: trace(mesh, *rays, tracer="warp", workers=workers).face.ravel() >= 0
        start, way = (Triples.of(array, "rays") for array in rays)
        accelerator = scene.builtin(way.device)
        kernel = ray_kernel(BUILTIN.prepare, build_hit_writer(BUILTIN.distance_query(True)))

        def work() -> np.ndarray:
            hits = Hits(way.empty(np.float32), way.empty(np.int32), "warp")
            launch_rays(kernel, accelerator, rays_of(make_placement(scene, start, np.inf), way, hits), way.device, workers)
            return hits.face.ravel() >= 0

        return work

    return hits


def _embree(mesh: Mesh, kind: str, count: int) -> RayTool:
    """Build the function to time that traces rays with embreex, the Python interface of Embree.

    Threads trace parts of the rays, because embreex leaves threads to the caller.
    """
    scene, (origins, directions) = build_embree_scene(mesh), _flatten(*build_rays(mesh, kind, count))

    def hits(any_hit: bool, workers: int) -> Hit:
        query = "OCCLUDED" if any_hit else "INTERSECT"
        edges = np.linspace(0, len(origins), (1 if workers == 1 else workers * _PARTS) + 1, dtype=np.int64)
        parts = list(starmap(slice, pairwise(edges)))

        def run(part: slice) -> np.ndarray:
            return np.asarray(scene.run(origins[part], directions[part], query=query)) >= 0

        return lambda: run(parts[0]) if len(parts) == 1 else np.concatenate(list(_get_threads(workers).map(run, parts)))

    return hits


def _open3d(mesh: Mesh, kind: str, count: int) -> RayTool:
    """Build the ray tracer of Open3D's RaycastingScene, which is Embree with a thread pool."""
    import open3d

    scene, rays = build_open3d_scene(mesh), open3d.core.Tensor(np.hstack(_flatten(*build_rays(mesh, kind, count))))
    return lambda any_hit, workers: (
        (lambda: scene.test_occlusions(rays, nthreads=workers).numpy())
        if any_hit
        else (lambda: np.isfinite(scene.cast_rays(rays, nthreads=workers)["t_hit"].numpy()))
    )


def build_embree_scene(mesh: Mesh) -> Any:
    """Build the Embree scene of a mesh; tracing one ray makes embreex commit it."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    scene = EmbreeScene()
    TriangleMesh(scene, mesh.vertices[mesh.faces].astype(np.float32))
    scene.run(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32))
    return scene


def build_embree_test(mesh: Mesh) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """Build a function from origins and directions, (R, 3) each, to (R,) bool: True for a ray with a hit."""
    scene = build_embree_scene(mesh)
    return lambda origins, directions: np.asarray(scene.run(origins, directions, query="OCCLUDED")) >= 0


def build_open3d_scene(mesh: Mesh) -> Any:
    """Build the Open3D scene of a mesh; tracing one ray makes Open3D commit it."""
    import open3d

    scene = open3d.t.geometry.RaycastingScene()
    tensor = open3d.core.Tensor
    scene.add_triangles(tensor(mesh.vertices.astype(np.float32)), tensor(mesh.faces.astype(np.uint32)))
    scene.cast_rays(tensor(np.ones((1, 6), np.float32)))
    return scene


TRACERS = {
    "wide": Tool("warpsample", build_wide_tool),
    "wp.Mesh": Tool("warp-lang", _warp_mesh),
    "Embree": Tool("embreex", _embree),
    "Open3D": Tool("open3d", _open3d),
}
"""Tools by name, with `make(mesh, kind of rays, count)`."""


def list_builds(mesh: Mesh, workers: int) -> dict[str, Callable[[], object]]:
    """Return functions that build each tool's scene from a mesh.

    The argument `workers` is for warpsample; the other tools use their defaults.
    """
    scene = scene_of(mesh)
    scene.tree(workers)
    return {
        "wide": lambda: Scene(mesh).tree(workers),
        "wide, refit": lambda: scene.with_vertices(mesh).tree(workers),
        "wp.Mesh": lambda: Scene(mesh).builtin(cpu()),
        "Embree": lambda: build_embree_scene(mesh),
        "Open3D": lambda: build_open3d_scene(mesh),
    }


def _flatten(origins: np.ndarray, directions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the rays' origins and directions as (R, 3), for tools that take one direction per origin."""
    if directions.ndim == 3:
        origins = np.repeat(origins, directions.shape[1], axis=0)
    return np.array(np.broadcast_to(origins, (directions.size // 3, 3))), directions.reshape(-1, 3)


@cache
def _get_threads(workers: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(workers)
