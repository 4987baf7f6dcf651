"""What all estimates share: the checked call, and how many rays its points take."""

from dataclasses import dataclass, replace
from math import inf
from typing import Any

import numpy as np

from warpsample import sequences
from warpsample.distributions import as_spatial
from warpsample.distributions.record import Distribution
from warpsample.estimate.cells import POLAR_COSINE, cells_of
from warpsample.estimate.integrand import Integrand
from warpsample.estimate.result import Estimate
from warpsample.estimate.runner import Runner
from warpsample.estimate.tolerance import count_within
from warpsample.host.arguments import check_first_point, check_flag, check_integer, check_number, check_seed
from warpsample.host.arrays import check_active
from warpsample.host.device_memory import Memory
from warpsample.host.engine import check_memory, check_workers
from warpsample.host.neighbours import kind_told
from warpsample.host.progress import bar
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.record import Sequence
from warpsample.tracing.tracers import Tracer, tracer_of
from warpsample.tracing.triples import Triples

_MOST_RAYS = 2**24  # of a point: hits are counted in float64 and rays in int32, and one point is one task
_BYTES_PER_POINT = 132


@dataclass(frozen=True)
class Quantity:
    """The quantity that is summed over the rays of a point.

    Attributes:
        integrand: what a ray adds that meets nothing.
        reach: how far rays go, in the user's units.
        unit: what the mean of the rays is multiplied by.
        falloff: see `ambient_occlusion`; None: a ray that meets something adds nothing.
        result: the type of the estimate.
    """

    integrand: Integrand
    reach: float = inf
    unit: float = 1.0
    falloff: float | None = None
    result: type[Estimate] = Estimate


@dataclass(frozen=True)
class Plan:
    """The checked arguments of a call, apart from the quantity that is summed."""

    mesh: Mesh | None
    points: SurfacePoints
    count: int
    distribution: Distribution
    sequence: Sequence
    seed: int
    first_point: int
    active: np.ndarray | None
    tolerance: float | None
    skip: bool
    tracer: Tracer
    workers: int
    progress: bool
    memory: Memory

    @classmethod
    def of(
        cls,
        mesh: Any,
        points: Any,
        count: Any,
        sequence: str = "fibonacci",
        seed: Any = 0,
        first_point: Any = 0,
        active: Any = None,
        tolerance: Any = None,
        skip: bool = True,
        tracer: str = "auto",
        workers: int | None = None,
        progress: bool = False,
        distribution: Any = POLAR_COSINE,
        meshless: bool = False,
        device: Any = None,
    ) -> "Plan":
        """The plan of a call's arguments.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
            MemoryError: more than is free.
        """
        if meshless and not isinstance(points, SurfacePoints):
            given = Triples.of(points, "points", "(P, 3)")
            if len(given.shape) != 1:
                raise ValueError(f"points: got shape {(*given.shape, 3)}, want (P, 3)")
            normals = as_directions(given.owner)
            points = SurfacePoints(np.zeros(normals.shape, np.float32), normals)
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {kind_told(points)}, want SurfacePoints, as sample_surface gives them")
        memory = Memory.of(device)
        check_memory(_BYTES_PER_POINT * len(points), f"the numbers of {len(points):,} points", "take them in parts")
        return cls(
            None if meshless else as_mesh(mesh),
            points,
            check_integer(count, "count", 2, _MOST_RAYS),
            as_spatial(distribution),
            sequences.get(sequence),
            check_seed(seed),
            check_first_point(first_point, len(points)),
            check_active(active, len(points)),
            None if tolerance is None else check_number(tolerance, "tolerance", 1e-12, 1e12),
            check_flag(skip, "skip"),
            tracer_of(tracer, memory.device),
            check_workers(workers),
            check_flag(progress, "progress"),
            memory,
        )

    def estimate(self, quantity: Quantity) -> Estimate:
        """Runs the plan for a quantity."""
        what = "casting rays" if self.mesh else "sampling directions"
        with bar(self.progress, what), self.memory.loan() as loan:
            return self._estimate(Runner(self, quantity, loan))

    def _estimate(self, runner: Runner) -> Estimate:
        if self.tolerance is None or len(self.points) == 0:
            return runner.result(self.seed, self.count)
        count, trial = count_within(runner, self.tolerance)
        main, traced = runner.result(self.seed, count), self.mesh is not None
        saved = cells_of(self.count, traced=traced).rays - cells_of(count, traced=traced).rays
        unneeded = saved * np.count_nonzero(main.status == 0) - int(trial.sum(dtype=np.int64))
        return replace(main, rays=main.rays + trial, skipped=replace(main.skipped, unneeded_rays=max(0, unneeded)))


def reach_of(max_distance: Any) -> float:
    """How far rays go: infinitely far by default.

    Raises:
        TypeError, ValueError: not a number from 0 on.
    """
    return inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
