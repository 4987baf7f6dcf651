"""Rays by each tool: of a mesh and its rays, what says by so many workers which of them meet something, (R,) bool."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import pairwise, starmap
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.scenes import ray_set
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
"""(whether any hit is asked for, workers) -> the work."""

_PARTS = 8  # of the rays, for each thread of a peer that leaves threads to its caller


def wide_tree(mesh: Mesh, kind: str, count: int) -> RayTool:
    """Our wide tree, by `trace`."""
    rays = ray_set(mesh, kind, count)
    return lambda any_hit, workers: (
        lambda: trace(mesh, *rays, any_hit=any_hit, tracer="wide", workers=workers).face.ravel() >= 0
    )


def visits(mesh: Mesh, kind: str, count: int, any_hit: bool) -> tuple[float, float]:
    """(nodes, leaves) of our wide tree that a ray visits, on average."""
    scene = scene_of(mesh)
    start, way = (Triples.of(array, "rays") for array in ray_set(mesh, kind, count))
    hits = Hits(way.empty(np.float32), way.empty(np.int32), "wide")  # named, so that it outlives the addresses in `asked`
    asked = rays_of(make_placement(scene, start, np.inf), way, hits)
    counts = np.zeros((*way.shape, 2), np.int32)
    asked.visits = counts.ctypes.data
    trace_rays(scene, asked, tracer=WIDE, any_hit=any_hit, device=way.device, workers=1)
    nodes, leaves = counts.reshape(-1, 2).mean(axis=0)
    return float(nodes), float(leaves)


def _warp_mesh(mesh: Mesh, kind: str, count: int) -> RayTool:
    """wp.Mesh, by its nearest-hit query in `trace`; or in our kernel by its any-hit query, which tells no face."""
    scene, rays = scene_of(mesh), ray_set(mesh, kind, count)

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
    """Parts of the rays in threads by embreex, which leaves these to its caller and releases the interpreter's lock."""
    scene, (origins, directions) = embree_scene(mesh), _flat(*ray_set(mesh, kind, count))

    def hits(any_hit: bool, workers: int) -> Hit:
        query = "OCCLUDED" if any_hit else "INTERSECT"
        edges = np.linspace(0, len(origins), (1 if workers == 1 else workers * _PARTS) + 1, dtype=np.int64)
        parts = list(starmap(slice, pairwise(edges)))

        def run(part: slice) -> np.ndarray:
            return np.asarray(scene.run(origins[part], directions[part], query=query)) >= 0

        return lambda: run(parts[0]) if len(parts) == 1 else np.concatenate(list(_threads(workers).map(run, parts)))

    return hits


def _open3d(mesh: Mesh, kind: str, count: int) -> RayTool:
    """Its RaycastingScene, which is Embree too, with a thread pool of its own."""
    import open3d

    scene, rays = open3d_scene(mesh), open3d.core.Tensor(np.hstack(_flat(*ray_set(mesh, kind, count))))
    return lambda any_hit, workers: (
        (lambda: scene.test_occlusions(rays, nthreads=workers).numpy())
        if any_hit
        else (lambda: np.isfinite(scene.cast_rays(rays, nthreads=workers)["t_hit"].numpy()))
    )


def embree_scene(mesh: Mesh) -> Any:
    """Embree's scene of a mesh, built: embreex commits at the first ray."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    scene = EmbreeScene()
    TriangleMesh(scene, mesh.vertices[mesh.faces].astype(np.float32))
    scene.run(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32))
    return scene


def embree_met(mesh: Mesh) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """What says of origins and directions, (R, 3) each, which rays meet something, (R,) bool."""
    scene = embree_scene(mesh)
    return lambda origins, directions: np.asarray(scene.run(origins, directions, query="OCCLUDED")) >= 0


def open3d_scene(mesh: Mesh) -> Any:
    """Open3D's scene of a mesh, built: it commits at the first ray."""
    import open3d

    scene = open3d.t.geometry.RaycastingScene()
    tensor = open3d.core.Tensor
    scene.add_triangles(tensor(mesh.vertices.astype(np.float32)), tensor(mesh.faces.astype(np.uint32)))
    scene.cast_rays(tensor(np.ones((1, 6), np.float32)))
    return scene


TRACERS = {
    "wide": Tool("warpsample", wide_tree),
    "wp.Mesh": Tool("warp-lang", _warp_mesh),
    "Embree": Tool("embreex", _embree),
    "Open3D": Tool("open3d", _open3d),
}
"""By name; each is made of (mesh, kind of rays, count)."""


def builds(mesh: Mesh, workers: int) -> dict[str, Callable[[], object]]:
    """Work that builds what each tool needs; ours by so many workers, the others as they are used to."""
    known = scene_of(mesh)
    known.tree(workers)
    return {
        "wide": lambda: Scene(mesh).tree(workers),
        "wide, refit": lambda: known.moved(mesh).tree(workers),
        "wp.Mesh": lambda: Scene(mesh).builtin(cpu()),
        "Embree": lambda: embree_scene(mesh),
        "Open3D": lambda: open3d_scene(mesh),
    }


def _flat(origins: np.ndarray, directions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Both as (R, 3), for tools that know no n rays from a point."""
    if directions.ndim == 3:
        origins = np.repeat(origins, directions.shape[1], axis=0)
    return np.array(np.broadcast_to(origins, (directions.size // 3, 3))), directions.reshape(-1, 3)


@cache
def _threads(workers: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(workers)
