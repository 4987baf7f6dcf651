"""The same ambient occlusion by each tool, each in a process of its own: `build` makes its job.

The peers take independent cosine directions, as their users do: made by NumPy in float32, part by part, in as many threads
as there are cores where the tool lets its caller's threads trace; in Mitsuba's own kernel for Mitsuba.
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import version
from itertools import count as count_from
from typing import Any, Protocol

import numpy as np

from warpsample import sequences
from warpsample.bench.child import Job
from warpsample.bench.scaling import peak_megabytes
from warpsample.bench.scenes import SCENES
from warpsample.bench.tracers import embree_scene, open3d_scene
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.registry import look_up
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints, sample_surface

_RAYS_PER_PART = 1 << 18  # 6 MB of directions and origins
_TRIAL = 64
_OFF = 1e-5  # of the mesh's size, by which peers move points off their face
_TRIALS = 2


class Tool(Protocol):
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
        seeds = np.random.SeedSequence(next(self.seeds))
        step = max(1, _RAYS_PER_PART // count)
        starts = range(0, len(self.normal), step)
        parts = [(slice(s, s + step), seed) for s, seed in zip(starts, seeds.spawn(len(starts)), strict=True)]
        with ThreadPoolExecutor(self.threads) as pool:
            return np.concatenate(list(pool.map(lambda part: self._open(count, *part), parts)))

    def _open(self, count: int, part: slice, seed: np.random.SeedSequence) -> np.ndarray:
        n, t, b = self.normal[part], self.tangent[part], self.bitangent[part]
        u, v = np.random.default_rng(seed).random((2, len(n), count, 1), np.float32)
        r, angle = np.sqrt(u), np.float32(2.0 * np.pi) * v
        d = (r * np.cos(angle)) * t[:, None] + (r * np.sin(angle)) * b[:, None] + np.sqrt(1.0 - u) * n[:, None]
        origins = np.repeat(self.origin[part], count, axis=0)
        return 1.0 - self.trace(origins, d.reshape(-1, 3)).reshape(len(n), count).mean(axis=1)


def _tangents(n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    across = np.where(np.abs(n[:, :1]) > 0.5, np.float32([[0, 1, 0]]), np.float32([[1, 0, 0]]))
    tangent = np.cross(n, across)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    return tangent, np.cross(n, tangent)


def _embree(mesh: Mesh, points: SurfacePoints, workers: int) -> Tool:
    scene = embree_scene(mesh)
    return Peer(lambda o, d: np.asarray(scene.run(o, d, query="OCCLUDED")) >= 0, points, _size(mesh), workers)


def _trimesh(mesh: Mesh, points: SurfacePoints, workers: int) -> Tool:
    import trimesh  # noqa: PLC0415
    from trimesh.ray.ray_pyembree import RayMeshIntersector  # noqa: PLC0415

    intersector = RayMeshIntersector(trimesh.Trimesh(mesh.vertices, mesh.faces, process=False))
    return Peer(intersector.intersects_any, points, _size(mesh), workers)


def _open3d(mesh: Mesh, points: SurfacePoints, workers: int) -> Tool:
    import open3d  # noqa: PLC0415

    scene = open3d_scene(mesh)

    def trace(origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        rays = open3d.core.Tensor(np.concatenate([origins, directions], axis=1))
        return scene.test_occlusions(rays, nthreads=workers).numpy()

    return Peer(trace, points, _size(mesh), 1)


def _mitsuba(mesh: Mesh, points: SurfacePoints, workers: int) -> Tool:
    import drjit as dr  # noqa: PLC0415
    import mitsuba as mi  # noqa: PLC0415

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    shape = mi.Mesh("mesh", len(mesh.vertices), len(mesh.faces))
    parameters = mi.traverse(shape)
    parameters["vertex_positions"] = mesh.vertices.astype(np.float32).ravel()
    parameters["faces"] = mesh.faces.astype(np.uint32).ravel()
    parameters.update()
    scene = mi.load_dict({"type": "scene", "mesh": shape})
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


TOOLS: dict[str, tuple[str, Callable[[Mesh, SurfacePoints, int], Tool]]] = {
    "warpsample": ("warpsample", Ours),
    "warpsample, skip=False": ("warpsample", lambda *scene: Ours(*scene, skip=False)),
    "warpsample, wp.Mesh": ("warp-lang", lambda *scene: Ours(*scene, tracer="warp")),
    "Mitsuba": ("mitsuba", _mitsuba),
    "embreex": ("embreex", _embree),
    "trimesh + embreex": ("trimesh", _trimesh),
    "Open3D": ("open3d", _open3d),
}
"""By name: whose version is said, and what makes it of a mesh, points and threads."""


def points_of(scene: str, points: int) -> tuple[Mesh, SurfacePoints]:
    """A scene of the benchmark and points uniform on it by area, in the order of the faces; seed 0."""
    mesh = look_up(SCENES, scene, "scene")()
    found = sample_surface(mesh, points)
    order = np.argsort(found.face, kind="stable")
    return mesh, SurfacePoints(found.position[order], found.normal[order], found.face[order])


def build(tool: str, scene: str, points: int, workers: int, target: float, reference: str, open_points: bool) -> Job:
    """A tool's estimate by as many rays as take it to an RMSE; it looks for that number first.

    Args:
        tool: of TOOLS.
        scene: of SCENES.
        points: on it.
        workers: threads.
        target: the RMSE over all points.
        reference: an .npy file of the right values.
        open_points: whether, once the number is known, the points that the reference calls open are estimated, repeated.
    """
    library, make = TOOLS[tool]
    mesh, at = points_of(scene, points)
    right = np.load(reference)
    run = make(mesh, at, workers)
    rate = sequences.get("fibonacci" if library.startswith("warp") else "independent").rate
    count = _TRIAL
    for _ in range(_TRIALS):
        error = float(np.sqrt(np.mean((run(count) - right) ** 2)))
        count = max(2, round(count * float(np.float_power(error / target, 1.0 / rate))))
    if open_points:
        chosen = np.resize(np.flatnonzero(right == 1.0), points)  # as many, so that what a call costs weighs the same
        at = SurfacePoints(at.position[chosen], at.normal[chosen], at.face[chosen])
        run, right = make(mesh, at, workers), right[chosen]
    values: list[np.ndarray] = []

    def work() -> None:
        values[:] = [run(count)]

    def report() -> dict[str, Any]:
        cast = float(run.last.rays.mean()) if isinstance(run, Ours) and run.last else float(count)
        error = float(np.sqrt(np.mean((values[0] - right) ** 2)))
        told = {"version": version(library), "count": count, "cast": cast, "rmse": error, "points": len(right)}
        return {**told, "to_target": 1.0 if open_points else float(np.float_power(error / target, 1.0 / rate))}

    return Job(work, report)


def build_many(scene: str, points: int, rays: int, workers: int) -> Job:
    """Our estimate by its defaults, and the memory of all its process: Python, mesh and points included."""
    mesh, at = points_of(scene, points)
    few = SurfacePoints(at.position[:64], at.normal[:64])
    run, warm = Ours(mesh, at, workers), Ours(mesh, few, workers)
    return Job(lambda: run(rays), lambda: {"peak_megabytes": peak_megabytes()}, lambda: warm(rays))
