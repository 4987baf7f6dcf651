"""Which of many suns points see, by each tool: () -> (P, T) bool."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from warpsample.bench.radiation.scene import lifted
from warpsample.bench.tracers import embree_scene
from warpsample.bench.visibility.tools import mitsuba_scene
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sun.direct_sun import direct_sun
from warpsample.tracing.trace import trace

SunTool = Callable[[], np.ndarray]

_PARTS = 8  # of the points, for each thread that embreex leaves to its caller


def _ours(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    return lambda: direct_sun(mesh, points, suns, workers=workers)


def _trace(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    """A ray for each pair; averted pairs are made dark afterwards."""
    directions = np.array(np.broadcast_to(suns, (len(points), *suns.shape)))
    facing = points.normal @ suns.T > 0.0
    return lambda: (trace(mesh, points, directions, any_hit=True, workers=workers).face < 0) & facing


def _embree(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    """A ray for each pair that faces, which NumPy picks."""
    scene, origins = embree_scene(mesh), lifted(mesh, points)
    parts = np.array_split(np.arange(len(points)), min(len(points), workers * _PARTS))

    def part(rows: np.ndarray) -> np.ndarray:
        lit = points.normal[rows] @ suns.T > 0.0
        point, sun = np.nonzero(lit)
        hit = scene.run(origins[rows][point], suns[sun], query="OCCLUDED")
        lit[point, sun] = np.asarray(hit) < 0
        return lit

    def work() -> np.ndarray:
        with ThreadPoolExecutor(workers) as pool:
            return np.concatenate(list(pool.map(part, parts)))

    return work


def _mitsuba(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    """A lane for each pair; averted ones are masked."""
    dr, mi, scene = mitsuba_scene(mesh, workers)
    origins, normals = mi.Point3f(lifted(mesh, points).T), mi.Vector3f(np.ascontiguousarray(points.normal.T))
    towards = mi.Vector3f(np.ascontiguousarray(suns.T))

    def work() -> np.ndarray:
        lane, columns = dr.arange(mi.UInt32, len(points) * len(suns)), dr.opaque(mi.UInt32, len(suns))
        point = lane // columns
        d = dr.gather(mi.Vector3f, towards, lane - point * columns)
        facing = dr.dot(dr.gather(mi.Vector3f, normals, point), d) > 0.0
        lit = facing & ~scene.ray_test(mi.Ray3f(dr.gather(mi.Point3f, origins, point), d), facing)
        return np.asarray(lit).reshape(len(points), len(suns))

    return work


TRACE = "ws.trace, all pairs"
SUN_TOOLS: dict[str, tuple[str, Callable[[Mesh, SurfacePoints, np.ndarray, int], SunTool]]] = {
    "warpsample": ("warpsample", _ours),
    TRACE: ("warpsample", _trace),
    "Mitsuba": ("mitsuba", _mitsuba),
    "embreex": ("embreex", _embree),
}
"""By name: whose version is said, and what makes it of a mesh, points, suns and threads."""
