"""The tools that trace rays: each is built from a mesh and then says which rays meet something."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from importlib.metadata import version
from itertools import pairwise, starmap
from typing import Any, Protocol

import numpy as np

from warpsample.bench.scenes import ray_set
from warpsample.host.arrays import cpu
from warpsample.mesh.mesh import Mesh
from warpsample.tracing.placement import placed
from warpsample.tracing.rays import launch_rays, ray_kernel, trace_rays
from warpsample.tracing.scene import Scene, scene_of
from warpsample.tracing.trace import Hits, rays_of, trace
from warpsample.tracing.tracers import BUILTIN, WIDE
from warpsample.tracing.triples import Triples

_PARTS = 8  # of the rays, for each thread of a peer that leaves threads to its caller


class Tracer(Protocol):
    """Something that traces."""

    version: str

    def hits(self, any_hit: bool, workers: int) -> Callable[[], np.ndarray]:
        """Work that says of each ray whether it meets something, (R,) bool."""


class Wide:
    """Ours."""

    def __init__(self, mesh: Mesh, kind: str, count: int) -> None:
        """Of a mesh and its rays."""
        self.mesh, self.rays = mesh, ray_set(mesh, kind, count)
        self.version = version("warpsample")

    def hits(self, any_hit: bool, workers: int) -> Callable[[], np.ndarray]:
        """By `trace`."""
        return lambda: trace(self.mesh, *self.rays, any_hit=any_hit, tracer="wide", workers=workers).face.ravel() >= 0

    def visits(self, any_hit: bool) -> tuple[float, float]:
        """(nodes, leaves) that a ray visits, on average."""
        scene = scene_of(self.mesh)
        start, way = (Triples.of(array, "rays") for array in self.rays)
        hits = Hits(way.empty(np.float32), way.empty(np.int32), "wide")
        asked = rays_of(placed(scene, start, np.inf), way, hits)
        counts = np.zeros((*way.shape, 2), np.int32)
        asked.visits = counts.ctypes.data
        trace_rays(scene, asked, tracer=WIDE, any_hit=any_hit, device=way.device, workers=1)
        nodes, leaves = counts.reshape(-1, 2).mean(axis=0)
        return float(nodes), float(leaves)


class Builtin:
    """wp.Mesh, by its nearest-hit or its any-hit query, in the frame of our kernel."""

    def __init__(self, mesh: Mesh, kind: str, count: int) -> None:
        """Of a mesh and its rays."""
        self.scene, self.rays = scene_of(mesh), ray_set(mesh, kind, count)
        self.mesh, self.version = mesh, version("warp-lang")

    def hits(self, any_hit: bool, workers: int) -> Callable[[], np.ndarray]:
        """By `trace`, or with the query that tells no face."""
        if not any_hit:
            return lambda: trace(self.mesh, *self.rays, tracer="warp", workers=workers).face.ravel() >= 0
        start, way = (Triples.of(array, "rays") for array in self.rays)
        accelerator = self.scene.builtin(way.device)
        kernel = ray_kernel(BUILTIN.prepare, BUILTIN.distance_query(True))

        def work() -> np.ndarray:
            hits = Hits(way.empty(np.float32), way.empty(np.int32), "warp")
            asked = rays_of(placed(self.scene, start, np.inf), way, hits)
            launch_rays(kernel, accelerator, asked, way.device, workers)
            return hits.face.ravel() >= 0

        return work


class Embree:
    """By embreex, which leaves threads to its caller."""

    def __init__(self, mesh: Mesh, kind: str, count: int) -> None:
        """Of a mesh and its rays."""
        self.scene, self.version = embree_scene(mesh), version("embreex")
        self.origins, self.directions = _flat(*ray_set(mesh, kind, count))

    def hits(self, any_hit: bool, workers: int) -> Callable[[], np.ndarray]:
        """Parts of the rays in threads: embreex releases the interpreter's lock."""
        query = "OCCLUDED" if any_hit else "INTERSECT"
        edges = np.linspace(0, len(self.origins), (1 if workers == 1 else workers * _PARTS) + 1, dtype=np.int64)
        parts = list(starmap(slice, pairwise(edges)))

        def work() -> np.ndarray:
            def run(part: slice) -> np.ndarray:
                return np.asarray(self.scene.run(self.origins[part], self.directions[part], query=query))

            found = [run(parts[0])] if len(parts) == 1 else _threads(workers).map(run, parts)
            return np.concatenate(list(found)) >= 0

        return work


class Open3D:
    """Its RaycastingScene, which is Embree too, with a thread pool of its own."""

    def __init__(self, mesh: Mesh, kind: str, count: int) -> None:
        """Of a mesh and its rays."""
        import open3d  # noqa: PLC0415

        self.scene, self.version = open3d_scene(mesh), version("open3d")
        self.rays = open3d.core.Tensor(np.hstack(_flat(*ray_set(mesh, kind, count))))

    def hits(self, any_hit: bool, workers: int) -> Callable[[], np.ndarray]:
        """By cast_rays or test_occlusions."""
        if any_hit:
            return lambda: self.scene.test_occlusions(self.rays, nthreads=workers).numpy()
        return lambda: np.isfinite(self.scene.cast_rays(self.rays, nthreads=workers)["t_hit"].numpy())


def embree_scene(mesh: Mesh) -> Any:
    """Built: embreex commits at the first ray."""
    from embreex.mesh_construction import TriangleMesh  # noqa: PLC0415
    from embreex.rtcore_scene import EmbreeScene  # noqa: PLC0415

    scene = EmbreeScene()
    TriangleMesh(scene, mesh.vertices[mesh.faces].astype(np.float32))
    scene.run(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32))
    return scene


def open3d_scene(mesh: Mesh) -> Any:
    """Built: Open3D commits at the first ray."""
    import open3d  # noqa: PLC0415

    scene = open3d.t.geometry.RaycastingScene()
    tensor = open3d.core.Tensor
    scene.add_triangles(tensor(mesh.vertices.astype(np.float32)), tensor(mesh.faces.astype(np.uint32)))
    scene.cast_rays(tensor(np.ones((1, 6), np.float32)))
    return scene


TRACERS: dict[str, Callable[[Mesh, str, int], Tracer]] = {
    "wide": Wide,
    "wp.Mesh": Builtin,
    "Embree": Embree,
    "Open3D": Open3D,
}

REMEDIES = {"Embree": "embreex", "Open3D": "open3d"}
"""What pip installs for a tool that may be missing."""


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
    """(R, 3) both, as tools want that know no n rays from a point."""
    if directions.ndim == 3:
        origins = np.repeat(origins, directions.shape[1], axis=0)
    return np.array(np.broadcast_to(origins, (directions.size // 3, 3))), directions.reshape(-1, 3)


@cache
def _threads(workers: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(workers)
