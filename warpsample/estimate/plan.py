"""What all estimates share: the checked call, its run on a device, and what comes of it."""

from dataclasses import dataclass, field, fields, replace
from enum import IntEnum
from math import inf
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import warp as wp

from warpsample import sequences
from warpsample.arguments import check_first_point, check_integer, check_number, check_seed
from warpsample.directions import Status
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.engine import check_memory, check_workers, run
from warpsample.estimate.cells import Cells, cells_of
from warpsample.estimate.intervals import Interval, interval_of
from warpsample.estimate.job import NONFINITE_POSITION, Job
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.weights import WeightsJob
from warpsample.mesh import Mesh, as_mesh
from warpsample.sequences.record import Sequence
from warpsample.surface import SurfacePoints
from warpsample.tracing.builtin import builtin_any_query, builtin_query, prepare_builtin
from warpsample.tracing.intersect import prepare_wide
from warpsample.tracing.order import order_of
from warpsample.tracing.scene import scene_of
from warpsample.tracing.trace import (
    MANY_FACES,
    RAY_WORK,
    Triples,
    check_tracer,
    job_of,
    surface_normals,
    widen_lift,
)
from warpsample.tracing.wide import wide_query

if TYPE_CHECKING:
    from pyvista import PolyData

_MOST_RAYS = 2**24  # of a point: hits are counted in float64 and rays in int32, and one point is one task
_BYTES_PER_POINT = 120
_TRIAL = 1 << 63  # of the seed
_TRIAL_RAYS = 64
_FEWEST_RAYS = 32
_UNSEEN = 0.6  # rays' worth of error that a trial may not have seen: with less, points that look easy spoil the RMSE


class PointStatus(IntEnum):
    """Why a point has a number or not."""

    OK = Status.OK
    INACTIVE = Status.INACTIVE
    ZERO_NORMAL = Status.ZERO_NORMAL
    NONFINITE_NORMAL = Status.NONFINITE_NORMAL
    NONFINITE_POSITION = NONFINITE_POSITION


@dataclass(frozen=True)
class Skipped:
    """What was not done, and did not have to be.

    Attributes:
        points: without a number: inactive, without a normal, nowhere.
        open_points: that no ray was cast from, since nothing is where it would go.
        empty_rays: in parts of the lobe that meet nothing, of `open_points` or others; their answer is known.
        weightless_rays: below the sky's horizon, or where the radiance is 0.
        unneeded_rays: that `tolerance` saved, less those of the trial that told so.
    """

    points: int = 0
    open_points: int = 0
    empty_rays: int = 0
    weightless_rays: int = 0
    unneeded_rays: int = 0


@dataclass(frozen=True, eq=False)
class Estimate:
    """A number for each of P points.

    Attributes:
        value: (P,) float32, or (P, 3); 0 where the status is not 0.
        standard_error: of the same shape and unit. Each cell of the lobe has two independent randomisations of its rays; the
            squares of their differences add up to an unbiased estimate of the variance, whatever the sequence. Below 32 rays
            there is one cell, so one difference, then 4 cells, 8 from 256 rays on, 32 from 448. 0 where all rays agree. So
            it is right on average, not at each point. Of the points that are not proven open what is right is within one
            of them at 44 % on the bunny and 62 % in the city by 64 rays, 52 and 66 % by 256; within two at 58 and 82 %, 70
            and 89 %. `interval` is for that.
        spread: of the same shape and unit, the scale of the t distribution by which `interval` goes; never 0 where there is
            a number, but under no light.
        degrees_of_freedom: of the same shape, those of that distribution, float32: at least 1, or 0 without a number.
        rays: (P,) int32, rays cast.
        status: (P,) uint8, a `PointStatus`.
        skipped: what was not done.
    """

    value: np.ndarray
    standard_error: np.ndarray
    spread: np.ndarray
    degrees_of_freedom: np.ndarray
    rays: np.ndarray
    status: np.ndarray
    skipped: Skipped

    def interval(self, level: float = 0.95) -> Interval:
        """Where the right number of each point lies: between the two in a share of about `level` of all estimates.

        value -+ spread * (the quantile of t), see `estimate.intervals`. A level of 0.95, of the points that are not proven
        open, in 200 runs at 200 points each: 95 to 97 % on bunny and city from 32 to 4,096 rays by the default sequence, 94
        to 97.3 % by any; 94 to 97 % on the floors and walls of streets, 92 to 99 % under single edges, where few rays decide
        and 95 % may not be among what can happen. The same by other quantities, but for a short `max_distance` and `falloff`
        on the bunny: up to 98 %. Among leaves, many edges to a cell, it is 90 to 94 %. Below 32 rays nothing is promised.
        `pytest -m slow tests/test_intervals.py` measures again.

        A pure function of the numbers above, so that `skip` changes none of its bits: a point that is proven open, whose
        interval could be empty, has that of any point all of whose rays agree, half a ray's weight times the quantile.
        Not cut to what is possible, as 0 to 1 for occlusion. (value, value) where the status is not 0.

        Args:
            level: 0.01 to 0.9999.

        Returns:
            (lower, upper), each of `value`'s shape and unit.

        Raises:
            TypeError, ValueError: a level that is none.
        """
        return interval_of(self.value, self.spread, self.degrees_of_freedom, check_number(level, "level", 0.01, 0.9999))

    def counts(self) -> dict[PointStatus, int]:
        """How many points have each status; those that occur."""
        return {PointStatus(code): int(n) for code, n in enumerate(np.bincount(self.status)) if n}

    def to_polydata(self, on: Any, at: Literal["vertices", "faces"] | None = None) -> "PolyData":
        """The numbers on what they are of, as PyVista's PolyData.

        Args:
            on: the SurfacePoints of the estimate; or the mesh (a Mesh or whatever `as_mesh` takes), if they were its
                vertices or the centres of its faces.
            at: which of the two; by default the one of which there are as many as numbers.

        Returns:
            a copy with an array for each field: "value", "standard_error", "rays", "status" and what else there is.

        Raises:
            ModuleNotFoundError: PyVista is missing.
            ValueError: another number of points, or as many vertices as faces and no `at`.
        """
        if isinstance(on, SurfacePoints):
            made, sizes = on.to_polydata(), {"points": len(on)}
        else:
            mesh = as_mesh(on)
            made, sizes = mesh.to_polydata(), {"vertices": len(mesh.vertices), "faces": len(mesh.faces)}
        fit = [name for name, size in sizes.items() if size == len(self.status) and at in (None, name)]
        if len(fit) != 1:
            raise ValueError(f"on: got {sizes} for {len(self.status)} numbers, want as many of one kind; at={at!r}")
        data = made.cell_data if fit == ["faces"] else made.point_data
        for item in fields(self):
            if item.name != "skipped":
                data[item.name] = getattr(self, item.name)
        return made


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
    ) -> "Plan":
        """The plan of a call's arguments.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
            MemoryError: more than is free.
        """
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {type(points).__name__}, want SurfacePoints, as sample_surface gives them")
        check_memory(_BYTES_PER_POINT * len(points), f"the numbers of {len(points):,} points", "take them in parts")
        return cls(
            as_mesh(mesh),
            points,
            check_integer(count, "count", 2, _MOST_RAYS),
            sequences.get(sequence),
            check_seed(seed),
            check_first_point(first_point, len(points)),
            _check_active(active, len(points)),
            None if tolerance is None else check_number(tolerance, "tolerance", 1e-12, 1e12),
            bool(skip),
            check_tracer(tracer, wp.get_device("cpu")),
            check_workers(workers),
        )

    def estimate(self, quantity: Quantity) -> Estimate:
        """The numbers."""
        runner = _Runner(self, quantity)
        if self.tolerance is None:
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
        needed = rays * (error / tolerance) ** (1.0 / self.sequence.rate)
        steps = np.ceil(np.log2(np.clip(needed, _FEWEST_RAYS, self.count)))
        return np.minimum(2 ** steps.astype(np.int64), self.count)


def rays_of(counts: np.ndarray) -> np.ndarray:
    """How many rays `cells_of` makes of each count."""
    known, where = np.unique(counts, return_inverse=True)
    return np.array([cells_of(int(count)).rays for count in known])[where]


class _Runner:
    """The arrays of a plan and a quantity, ready to be run with any numbers of rays."""

    def __init__(self, plan: Plan, quantity: Quantity) -> None:
        self.plan, self.quantity, self.scene = plan, quantity, scene_of(plan.mesh)
        self.position = Triples.of(plan.points.position, "points.position")
        self.normal = np.ascontiguousarray(Triples.of(plan.points.normal, "points.normal").owner, np.float32)
        self.side = surface_normals(plan.mesh, plan.points, "points")

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

    def _job(self, cells: Cells, seed: int) -> Job:
        plan, quantity = self.plan, self.quantity
        rays = job_of(self.scene, self.position, self.position, quantity.reach, self.position.owner, self.position.owner)
        rays.normals, rays.count = self.side.ctypes.data, cells.rays
        return Job(
            rays=rays,
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
        plan, quantity, cpu = self.plan, self.quantity, wp.get_device("cpu")
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
            slots, accelerator = (prepare_builtin, query), self.scene.builtin(cpu)
            widen_lift(job.rays)
        about = CosineHemisphere("polar").about()
        what = (quantity.weigh, quantity.constant, quantity.binary and any_hit, quantity.channels)
        kernel = estimate_kernel(plan.sequence, about, *what, *slots, any_hit, wide)
        run(kernel, len(rows), [job, accelerator], cpu, plan.workers, RAY_WORK * len(rows) * job.rays.count)


def _check_active(active: Any, points: int) -> np.ndarray | None:
    if active is None:
        return None
    mask = np.asarray(active)
    if mask.dtype not in (np.bool_, np.uint8) or mask.shape != (points,):
        raise ValueError(f"active: got {mask.dtype} of shape {mask.shape}, want bool of shape {(points,)}")
    return np.ascontiguousarray(mask).view(np.uint8)
