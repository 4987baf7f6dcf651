"""Ambient occlusion by each tool: (rays of each point) -> an estimate.

The peers take independent cosine directions, as their users do: made by NumPy in float32, part by part, in as many threads
as there are cores where the tool lets its caller's threads trace; in Mitsuba's own kernel for Mitsuba.
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import count as count_from
from typing import Any, Protocol

import numpy as np

from warpsample.bench.tracers import embree_scene, open3d_scene
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints

_RAYS_PER_PART = 1 << 18  # 6 MB of directions and origins
_OFF = 1e-5  # of the mesh's size, by which peers move points off their face


class Estimator(Protocol):
    """What estimates: (rays of each point) -> (P,) share of them that gets away."""

    def __call__(self, count: int) -> np.ndarray:
        """The estimate; another one at each call."""


class Ours:
    """`ambient_occlusion`."""

    def __init__(self, mesh: Mesh, points: SurfacePoints, workers: int, **options: Any) -> None:
        """Of a mesh and its points."""
        self.call, self.seeds = (mesh, points, workers, options), count_from()
        self.last: Estimate | None = None

    def __call__(self, count: int) -> np.ndarray:
        """By its defaults, or with the options."""
        mesh, points, workers, options = self.call
        self.last = ambient_occlusion(mesh, points, count, seed=next(self.seeds), workers=workers, **options)
        return self.last.value


class Peer:
    """A tool that traces rays which NumPy makes."""

    def __init__(
        self, trace: Callable[[np.ndarray, np.ndarray], np.ndarray], points: SurfacePoints, size: float, threads: int
    ):
        """`trace`: (origins, directions), (R, 3) each -> (R,) bool, met."""
        self.trace, self.threads, self.seeds = trace, threads, count_from()
        self.normal = points.normal
        self.origin = (points.position + _OFF * size * points.normal).astype(np.float32)
        self.tangent, self.bitangent = _tangents(points.normal)

    def __call__(self, count: int) -> np.ndarray:
        """Part by part."""
        return np.concatenate(self.parts(count, lambda o, d, n: 1.0 - self.trace(o, d).reshape(n, count).mean(axis=1)))

    def parts(self, count: int, judge: Callable[[np.ndarray, np.ndarray, int], np.ndarray]) -> list[np.ndarray]:
        """Of each part of the points `judge` (origins, directions, points), those of a point one after the other."""
        seeds = np.random.SeedSequence(next(self.seeds))
        step = max(1, _RAYS_PER_PART // count)
        starts = range(0, len(self.normal), step)
        parts = [(slice(s, s + step), seed) for s, seed in zip(starts, seeds.spawn(len(starts)), strict=True)]
        with ThreadPoolExecutor(self.threads) as pool:
            return list(pool.map(lambda part: judge(*self._rays(count, *part)), parts))

    def _rays(self, count: int, part: slice, seed: np.random.SeedSequence) -> tuple[np.ndarray, np.ndarray, int]:
        n, t, b = self.normal[part], self.tangent[part], self.bitangent[part]
        u, v = np.random.default_rng(seed).random((2, len(n), count, 1), np.float32)
        r, angle = np.sqrt(u), np.float32(2.0 * np.pi) * v
        d = (r * np.cos(angle)) * t[:, None] + (r * np.sin(angle)) * b[:, None] + np.sqrt(1.0 - u) * n[:, None]
        return np.repeat(self.origin[part], count, axis=0), d.reshape(-1, 3), len(n)


def _tangents(n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    across = np.where(np.abs(n[:, :1]) > 0.5, np.float32([[0, 1, 0]]), np.float32([[1, 0, 0]]))
    tangent = np.cross(n, across)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    return tangent, np.cross(n, tangent)


def by_embree(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    """By embreex, which leaves threads to its caller."""
    scene = embree_scene(mesh)
    return Peer(lambda o, d: np.asarray(scene.run(o, d, query="OCCLUDED")) >= 0, points, _size(mesh), workers)


def _trimesh(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    import trimesh  # noqa: PLC0415
    from trimesh.ray.ray_pyembree import RayMeshIntersector  # noqa: PLC0415

    intersector = RayMeshIntersector(trimesh.Trimesh(mesh.vertices, mesh.faces, process=False))
    return Peer(intersector.intersects_any, points, _size(mesh), workers)


def _open3d(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    import open3d  # noqa: PLC0415

    scene = open3d_scene(mesh)

    def trace(origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        rays = open3d.core.Tensor(np.concatenate([origins, directions], axis=1))
        return scene.test_occlusions(rays, nthreads=workers).numpy()

    return Peer(trace, points, _size(mesh), 1)


def mitsuba_scene(mesh: Mesh, workers: int) -> tuple[Any, Any, Any]:
    """(drjit, mitsuba, the mesh as its scene), with so many threads."""
    import drjit as dr  # noqa: PLC0415
    import mitsuba as mi  # noqa: PLC0415

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    shape = mi.Mesh("mesh", len(mesh.vertices), len(mesh.faces))
    parameters = mi.traverse(shape)
    parameters["vertex_positions"] = mesh.vertices.astype(np.float32).ravel()
    parameters["faces"] = mesh.faces.astype(np.uint32).ravel()
    parameters.update()
    return dr, mi, mi.load_dict({"type": "scene", "mesh": shape})


def _mitsuba(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    dr, mi, scene = mitsuba_scene(mesh, workers)
    origin = mi.Point3f((points.position + _OFF * _size(mesh) * points.normal).astype(np.float32).T)
    normal = mi.Normal3f(np.ascontiguousarray(points.normal.T))
    seeds = count_from()

    def work(count: int) -> np.ndarray:
        rng = mi.PCG32(len(points), initstate=dr.opaque(mi.UInt64, next(seeds)))
        frame, limit = mi.Frame3f(normal), dr.opaque(mi.UInt32, count)

        def cast(rng: Any, hits: Any, done: Any) -> tuple[Any, Any, Any]:
            u = mi.Point2f(rng.next_float32(), rng.next_float32())
            ray = mi.Ray3f(origin, frame.to_world(mi.warp.square_to_cosine_hemisphere(u)))
            return rng, hits + dr.select(scene.ray_test(ray), mi.UInt32(1), mi.UInt32(0)), done + 1

        state = (rng, dr.zeros(mi.UInt32, len(points)), mi.UInt32(0))
        _, hits, _ = dr.while_loop(state, lambda _rng, _hits, done: done < limit, cast)
        return 1.0 - np.asarray(hits) / count

    return work


def _size(mesh: Mesh) -> float:
    return float(np.ptp(mesh.vertices, axis=0).max())


ESTIMATORS: dict[str, tuple[str, Callable[[Mesh, SurfacePoints, int], Estimator]]] = {
    "warpsample": ("warpsample", Ours),
    "warpsample, skip=False": ("warpsample", lambda *scene: Ours(*scene, skip=False)),
    "warpsample, wp.Mesh": ("warp-lang", lambda *scene: Ours(*scene, tracer="warp")),
    "Mitsuba": ("mitsuba", _mitsuba),
    "embreex": ("embreex", by_embree),
    "trimesh + embreex": ("trimesh", _trimesh),
    "Open3D": ("open3d", _open3d),
}
"""By name: whose version is said, and what makes it of a mesh, points and threads."""
