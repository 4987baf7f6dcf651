"""What all estimates share: the checked call, and its run."""

from dataclasses import dataclass, field, replace
from math import inf
from typing import Any

import numpy as np
import warp as wp

from warpsample import sequences
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.estimate.cells import Cells, cells_of
from warpsample.estimate.job import Job
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.result import Estimate, Skipped
from warpsample.estimate.slots import Slots
from warpsample.estimate.weights import WeightsJob
from warpsample.host.arguments import check_first_point, check_flag, check_integer, check_number, check_seed
from warpsample.host.arrays import as_directions, check_active, cpu, kind_told
from warpsample.host.engine import check_memory, check_workers, run
from warpsample.host.progress import bar
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.record import Sequence
from warpsample.tracing.builtin import builtin_any_query, builtin_query, prepare_builtin
from warpsample.tracing.order import order_of
from warpsample.tracing.rays import Job as RayJob
from warpsample.tracing.scene import scene_of
from warpsample.tracing.starts import starts_of
from warpsample.tracing.trace import (
    MANY_FACES,
    RAY_WORK,
    Triples,
    check_tracer,
    faces_and_normals,
    job_of,
    widen_lift,
)
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.wide.query import wide_query

_MOST_RAYS = 2**24  # of a point: hits are counted in float64 and rays in int32, and one point is one task
_BYTES_PER_POINT = 132
_MOST_REACH = 2.0**60  # of the scene's size: what is in it is at no distance at all from there on
_TRIAL = 1 << 63  # of the seed
_TRIAL_RAYS = 64
_FEWEST_RAYS = 32
_UNSEEN = 0.6  # rays' worth of error that a trial may not have seen: with less, points that look easy spoil the RMSE


@dataclass(frozen=True)
class Quantity:
    """What is summed.

    Attributes:
        weigh: what a ray adds that meets nothing, of `estimate.weights`.
        constant: whether that is 1 in all directions.
        binary: whether it is 1 or 0.
        channels: how many numbers it is, 1 or 3.
        weights: what `weigh` takes after the direction.
        reach: how far rays go, in the user's units.
        unit: what the mean of the rays is multiplied by.
        falloff: see `ambient_occlusion`; None: a ray that meets something adds nothing.
    """

    weigh: wp.Function
    constant: bool = False
    binary: bool = False
    channels: int = 1
    weights: WeightsJob = field(default_factory=WeightsJob)
    reach: float = inf
    unit: float = 1.0
    falloff: float | None = None


@dataclass(frozen=True)
class Plan:
    """A checked call, but for what is summed."""

    mesh: Mesh
    points: SurfacePoints
    count: int
    sequence: Sequence
    seed: int
    first_point: int
    active: np.ndarray | None
    tolerance: float | None
    skip: bool
    tracer: str
    workers: int
    progress: bool

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
    ) -> "Plan":
        """The plan of a call's arguments.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
            MemoryError: more than is free.
        """
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {kind_told(points)}, want SurfacePoints, as sample_surface gives them")
        check_memory(_BYTES_PER_POINT * len(points), f"the numbers of {len(points):,} points", "take them in parts")
        return cls(
            as_mesh(mesh),
            points,
            check_integer(count, "count", 2, _MOST_RAYS),
            sequences.get(sequence),
            check_seed(seed),
            check_first_point(first_point, len(points)),
            check_active(active, len(points)),
            None if tolerance is None else check_number(tolerance, "tolerance", 1e-12, 1e12),
            check_flag(skip, "skip"),
            check_tracer(tracer, cpu()),
            check_workers(workers),
            check_flag(progress, "progress"),
        )

    def estimate(self, quantity: Quantity) -> Estimate:
        """The numbers."""
        with bar(self.progress, "casting rays"):
            return self._estimate(quantity)

    def _estimate(self, quantity: Quantity) -> Estimate:
        runner = _Runner(self, quantity)
        if self.tolerance is None or len(self.points) == 0:
            return runner.result(self.seed, np.full(len(self.points), self.count))
        trial = runner.result(self.seed ^ _TRIAL, np.full(len(self.points), min(_TRIAL_RAYS, self.count)))
        needed = self._needed(trial, self.tolerance)
        main = runner.result(self.seed, needed)
        saved = np.maximum(cells_of(self.count).rays - rays_of(needed), 0)[main.status == 0].sum() - trial.rays.sum()
        return replace(main, rays=main.rays + trial.rays, skipped=replace(main.skipped, unneeded_rays=max(0, int(saved))))

    def _needed(self, trial: Estimate, tolerance: float) -> np.ndarray:
        """(P,) how many rays each point takes to the tolerance, by the error of a trial; a power of two, or the count.

        None of the trial's rays is used again, so that what they happened to meet does not sway the result.
        """
        rays = min(_TRIAL_RAYS, self.count)
        error = trial.standard_error.reshape(len(self.points), -1).max(axis=1)
        error += np.where(trial.rays > 0, _UNSEEN / rays, 0.0)
        needed = rays * np.float_power(error / tolerance, 1.0 / self.sequence.rate)  # in float64
        # A power of two is its own: a logarithm's last digit, which depends on the processor, must not double the rays.
        half, steps = np.frexp(np.clip(needed, _FEWEST_RAYS, self.count))
        return np.minimum(2 ** (steps.astype(np.int64) - (half == 0.5)), self.count)


def rays_of(counts: np.ndarray) -> np.ndarray:
    """How many rays `cells_of` makes of each count."""
    known, where = np.unique(counts, return_inverse=True)
    return np.array([cells_of(int(count)).rays for count in known])[where]


class _Runner:
    """The arrays of a plan and a quantity, ready to be run with any numbers of rays."""

    def __init__(self, plan: Plan, quantity: Quantity) -> None:
        self.plan, self.quantity, self.scene = plan, quantity, scene_of(plan.mesh)
        self.position = Triples.of(plan.points.position, "points.position")
        self.normal = as_directions(Triples.of(plan.points.normal, "points.normal").owner)
        self.face, self.side = faces_and_normals(plan.mesh, plan.points, "points")
        self.rays = self._rays() if len(plan.points) else None

    def result(self, seed: int, counts: np.ndarray) -> Estimate:
        """The estimate by counts[i] rays from the i-th point."""
        points, channels = len(counts), self.quantity.channels
        shape = (points,) if channels == 1 else (points, channels)
        value, error, spread, degrees = (np.zeros(shape, np.float32) for _ in range(4))
        cast, empty, status = (np.zeros(points, kind) for kind in (np.int32, np.int32, np.uint8))
        for count in np.unique(counts):
            job = self._job(cells_of(int(count)), seed)
            job.value, job.error, job.spread, job.degrees = (array.ctypes.data for array in (value, error, spread, degrees))
            job.cast, job.empty, job.status = (array.ctypes.data for array in (cast, empty, status))
            self._run(job, counts == count)
        total = np.where(status == 0, rays_of(counts), 0) if points else counts
        skipped = Skipped(
            points=int(np.count_nonzero(status)),
            open_points=int(np.count_nonzero((empty == total) & (total > 0))),
            empty_rays=int(empty.sum(dtype=np.int64)),
            weightless_rays=int((total - cast - empty).sum()),
        )
        unit = np.float32(self.quantity.unit)
        return Estimate(unit * value, unit * error, unit * spread, degrees, cast, status, skipped)

    def _rays(self) -> RayJob:
        """From where the rays of all points start; without their number."""
        plan, quantity = self.plan, self.quantity
        rays = job_of(self.scene, self.position, self.position, quantity.reach, self.position.owner, self.position.owner)
        rays.normals = self.side.ctypes.data
        if quantity.falloff is not None:  # is relative to the reach, so that must be a float32
            rays.reach = min(rays.reach, _MOST_REACH)
        if plan.tracer == "wide":
            tree = self.scene.tree(plan.workers).accelerator()
            self.starts = starts_of(self.scene, rays, self.face, self.normal, tree, plan.workers)
            rays.starts = self.starts.ctypes.data
        return rays

    def _job(self, cells: Cells, seed: int) -> Job:
        plan, quantity = self.plan, self.quantity
        self.rays.count = cells.rays
        return Job(
            rays=self.rays,
            seed=seed,
            first_point=plan.first_point,
            normals=self.normal.ctypes.data,
            active=0 if plan.active is None else plan.active.ctypes.data,
            each=cells.each,
            bands=cells.bands,
            sectors=cells.sectors,
            beams=cells.beams.ctypes.data if cells.beams.size and plan.skip else 0,
            skip=plan.skip,
            falloff=quantity.falloff or 0.0,
            edge=plan.sequence.edge_variance(cells.each),
            weights=quantity.weights,
        )

    def _run(self, job: Job, chosen: np.ndarray) -> None:
        plan, quantity = self.plan, self.quantity
        wide, any_hit = plan.tracer == "wide", quantity.falloff is None
        order = order_of(job.rays, plan.workers) if len(plan.mesh.faces) >= MANY_FACES else None
        rows = np.flatnonzero(chosen) if order is None else order[chosen[order]]
        job.rays.order = rows.ctypes.data
        if wide:
            slots, accelerator = (
                (prepare_wide, wide_query(any_hit, several=True)),
                self.scene.tree(plan.workers).accelerator(),
            )
        else:
            query = builtin_any_query if any_hit else builtin_query
            slots, accelerator = (prepare_builtin, query), self.scene.builtin(cpu())
            widen_lift(job.rays)
        about = CosineHemisphere("polar").about()
        what = (quantity.weigh, quantity.constant, quantity.binary and any_hit, quantity.channels)
        kernel = estimate_kernel(Slots(plan.sequence, about, *what, *slots, any_hit, wide))
        run(kernel, len(rows), [job, accelerator], cpu(), plan.workers, RAY_WORK * len(rows) * job.rays.count)
