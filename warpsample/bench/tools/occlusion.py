"""Ambient occlusion by each tool: (rays of each point) -> the share (P,) of them that gets away, another one at each call.

The peers take independent cosine directions, as their users do: for embreex made by NumPy in float32, part by part, in as
many threads as there are cores; by Mitsuba in its own kernel.
"""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.mitsuba import mitsuba_scene
from warpsample.bench.tools.numpy_rays import open_share
from warpsample.bench.tools.tracers import embree_met
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
    return open_share(mesh, points, workers, embree_met(mesh))


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
}
"""By name; each makes an estimator of (mesh, points, threads)."""
