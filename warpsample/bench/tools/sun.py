"""Functions of each tool that test which points see which suns, (P, T) bool."""

from collections.abc import Callable

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.mitsuba import build_mitsuba_scene
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sun.direct_sun import direct_sun
from warpsample.tracing.trace import trace

SunTool = Callable[[], np.ndarray]


def _ours(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    return lambda: direct_sun(mesh, points, suns, workers=workers)


def _trace(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    """Build the test that traces a ray for each pair of point and sun; pairs with a sun behind become False afterwards."""
    directions = np.array(np.broadcast_to(suns, (len(points), *suns.shape)))
    facing = points.normal @ suns.T > 0.0
    return lambda: (trace(mesh, points, directions, any_hit=True, workers=workers).face < 0) & facing


def _mitsuba(mesh: Mesh, points: SurfacePoints, suns: np.ndarray, workers: int) -> SunTool:
    """Build Mitsuba's test, one lane for each pair of point and sun; pairs with a sun behind are masked."""
    setup = build_mitsuba_scene(mesh, points, workers)
    dr, mi = setup.dr, setup.mi
    towards = mi.Vector3f(np.ascontiguousarray(suns.T))

    def work() -> np.ndarray:
        lane, columns = dr.arange(mi.UInt32, len(points) * len(suns)), dr.opaque(mi.UInt32, len(suns))
        point = lane // columns
        d = dr.gather(mi.Vector3f, towards, lane - point * columns)
        facing = dr.dot(mi.Vector3f(dr.gather(mi.Normal3f, setup.normals, point)), d) > 0.0
        ray = mi.Ray3f(dr.gather(mi.Point3f, setup.origins, point), d)
        return np.asarray(facing & ~setup.scene.ray_test(ray, facing)).reshape(len(points), len(suns))

    return work


TRACE = "ws.trace, all pairs"
SUN_TOOLS = {
    "warpsample": Tool("warpsample", _ours),
    TRACE: Tool("warpsample", _trace),
    "Mitsuba": Tool("mitsuba", _mitsuba),
}
"""Tools by name; `make(mesh, points, suns, threads)` returns a function that computes the lit pairs."""
