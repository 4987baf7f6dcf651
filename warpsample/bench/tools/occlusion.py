"""Functions of each tool that estimate the open fraction (P,) of points from rays per point, new at each call.

Other tools use independent cosine directions, as their users do. For embreex NumPy generates the directions in float32, in
as many threads as there are cores; Mitsuba generates them in its own kernel.
"""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.mitsuba import build_mitsuba_scene
from warpsample.bench.tools.numpy_rays import build_open_fraction
from warpsample.bench.tools.tracers import build_embree_test
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints

Estimator = Callable[[int], np.ndarray]


class Occlusion:
    """Estimator that calls `ambient_occlusion` with defaults or other options."""

    def __init__(self, mesh: Mesh, points: SurfacePoints, workers: int, **options: Any) -> None:
        self.call = partial(ambient_occlusion, mesh, points, workers=workers, **options)
        self.seeds, self.last = count_from(), None

    def __call__(self, count: int) -> np.ndarray:
        """Estimate ambient occlusion with a new seed, and keep the estimate as `last`."""
        self.last: Estimate | None = self.call(count, seed=next(self.seeds))
        return self.last.value


def build_embree_estimator(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    """Build an estimator of ambient occlusion by embreex, whose rays NumPy generates in threads."""
    return build_open_fraction(mesh, points, workers, build_embree_test(mesh))


def _mitsuba(mesh: Mesh, points: SurfacePoints, workers: int) -> Estimator:
    setup, seeds = build_mitsuba_scene(mesh, points, workers), count_from()
    dr, mi = setup.dr, setup.mi

    def work(count: int) -> np.ndarray:
        limit = dr.opaque(mi.UInt32, count)

        def cast(rng: Any, hits: Any, done: Any) -> tuple[Any, Any, Any]:
            ray = setup.sample_cosine_ray(rng, setup.origins, setup.normals)
            return rng, hits + dr.select(setup.scene.ray_test(ray), mi.UInt32(1), mi.UInt32(0)), done + 1

        state = (setup.build_random(len(points), next(seeds)), dr.zeros(mi.UInt32, len(points)), mi.UInt32(0))
        _, hits, _ = dr.while_loop(state, lambda _rng, _hits, done: done < limit, cast)
        return 1.0 - np.asarray(hits) / count

    return work


ESTIMATORS = {
    "warpsample": Tool("warpsample", Occlusion),
    "warpsample, skip=False": Tool("warpsample", partial(Occlusion, skip=False)),
    "warpsample, wp.Mesh": Tool("warp-lang", partial(Occlusion, tracer="warp")),
    "Mitsuba": Tool("mitsuba", _mitsuba),
    "embreex": Tool("embreex", build_embree_estimator),
}
"""Tools by name; `make(mesh, points, threads)` returns an estimator."""
