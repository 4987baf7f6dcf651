"""Ambient occlusion by each tool: (rays of each point) -> the share (P,) of them that gets away, another one at each call.

The peers take independent cosine directions, as their users do: made by NumPy in float32, part by part, in as many threads
as there are cores where the tool lets its caller's threads trace; in Mitsuba's own kernel for Mitsuba.
"""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.mitsuba import mitsuba_scene
from warpsample.bench.tools.numpy_rays import CosineRays
from warpsample.bench.tools.tracers import embree_met, open3d_scene
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints

Estimator = Callable[[int], np.ndarray]


class Occlusion:
    """`ambient_occlusion`, by its defaults or with options."""

    def __init__(self, mesh: Mesh, points: SurfacePoints, workers: int, **options: Any) -> None:
        self.call = partial(ambient_occlusion, mesh, points, workers=workers, **options)
        self.seeds, self.last = count_from(), None

    def __call__(self, count: int) -> np.ndarray:
        """The estimate, which is kept as `last`."""
        self.last: Estimate | None = self.call(count, seed=next(self.seeds))
        return self.last.value


def by_embree(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    """By embreex, which leaves threads to its caller."""
    rays, met = CosineRays(mesh, points, workers), embree_met(mesh)
    return lambda count: rays.open_share(count, met)


def _trimesh(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    import trimesh
    from trimesh.ray.ray_pyembree import RayMeshIntersector

    rays = CosineRays(mesh, points, workers)
    intersector = RayMeshIntersector(trimesh.Trimesh(mesh.vertices, mesh.faces, process=False))
    return lambda count: rays.open_share(count, intersector.intersects_any)


def _open3d(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    import open3d

    scene, rays = open3d_scene(mesh), CosineRays(mesh, points, 1)

    def met(origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        tensor = open3d.core.Tensor(np.concatenate([origins, directions], axis=1))
        return scene.test_occlusions(tensor, nthreads=workers).numpy()

    return lambda count: rays.open_share(count, met)


def _mitsuba(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    known, seeds = mitsuba_scene(mesh, points, workers), count_from()
    dr, mi = known.dr, known.mi

    def work(count: int) -> np.ndarray:
        limit = dr.opaque(mi.UInt32, count)

        def cast(rng: Any, hits: Any, done: Any) -> tuple[Any, Any, Any]:
            ray = known.cosine_ray(rng, known.origins, known.normals)
            return rng, hits + dr.select(known.scene.ray_test(ray), mi.UInt32(1), mi.UInt32(0)), done + 1

        state = (known.random(len(points), next(seeds)), dr.zeros(mi.UInt32, len(points)), mi.UInt32(0))
        _, hits, _ = dr.while_loop(state, lambda _rng, _hits, done: done < limit, cast)
        return 1.0 - np.asarray(hits) / count

    return work


ESTIMATORS = {
    "warpsample": Tool("warpsample", Occlusion),
    "warpsample, skip=False": Tool("warpsample", partial(Occlusion, skip=False)),
    "warpsample, wp.Mesh": Tool("warp-lang", partial(Occlusion, tracer="warp")),
    "Mitsuba": Tool("mitsuba", _mitsuba),
    "embreex": Tool("embreex", by_embree),
    "trimesh + embreex": Tool("trimesh", _trimesh),
    "Open3D": Tool("open3d", _open3d),
}
"""By name; each makes an estimator of (mesh, points, threads)."""
