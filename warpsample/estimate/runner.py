"""Launches of the estimate kernel with different numbers of rays, for points that are prepared once."""

from typing import Any

import numpy as np

from warpsample.distributions.parameters import redraw_of
from warpsample.estimate.intervals import widen
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.lobes import LobesArgs
from warpsample.estimate.plan import Plan, RaySum
from warpsample.estimate.result import Estimate, Skipped, has_value
from warpsample.estimate.slots import Slots
from warpsample.estimate.strata import POLAR_COSINE, Strata, strata_of
from warpsample.host.device_memory import Loan, at_home
from warpsample.host.engine import run
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.placement import PlacementArgs
from warpsample.tracing.queries import AcceleratorArgs
from warpsample.tracing.rays import RAY_WORK

_BYTES_OF_POINT = 144  # on a device: position, start, two normals, mask, order, and up to three components of each result
_TASK, _MOST_ROWS = 1 << 11, 16  # rays and points per task on the CPU, where clearing memory takes as long as ten rays
_MOST_REACH = 2.0**60  # in sizes of the scene: relative to this reach, all distances in the scene round to 0


class Runner:
    """Estimator at prepared points: it computes the estimate repeatedly, with different numbers of rays per point."""

    plan: Plan
    summed: RaySum
    at: PlacedPoints
    options: RayOptions
    traced: bool
    placement: Any
    data: Any

    def __init__(self, plan: Plan, summed: RaySum, loan: Loan) -> None:
        """Prepare the points' ray origins and the integrand's data on the device.

        Keep `loan`, which holds the device memory, open while this object is in use.
        """
        self.plan, self.summed, self.at, self.options = plan, summed, plan.at, plan.options
        self.traced = plan.at.scene is not None
        self.placement = self._placement() if len(plan.at) else None
        self.data = summed.integrand.data_for(loan)

    def result(self, seed: int, count: int, chosen: np.ndarray | None = None, skip: bool | None = None) -> Estimate:
        """Compute the estimate with `count` rays per point, and return values and standard errors.

        Args:
            seed: Random seed of the rays.
            count: Number of rays per point.
            chosen: (P,) bool mask of the points to compute; the values of all other points are 0. Default: None, all points.
            skip: Whether to skip rays whose answer is known. Default: None, the plan's option.
        """
        points, channels = len(self.at), self.summed.integrand.channels
        shape = (points,) if channels == 1 else (points, channels)
        value, error, spread, degrees = (np.zeros(shape, np.float32) for _ in range(4))
        cast, empty, status = (np.zeros(points, kind) for kind in (np.int32, np.int32, np.uint8))
        lobe = self.plan.distribution
        has_cones = lobe.symmetric and lobe.polar and not lobe.by_point and self.plan.tangent is None
        strata = strata_of(count, lobe if has_cones else None, self.traced)
        for rows in self.options.memory.parts(points, _BYTES_OF_POINT):
            with self.options.memory.loan() as loan:
                part = self._part(loan, rows, strata, self.options.skip if skip is None else skip)
                part.seed = seed
                part.value, part.error, part.spread, part.degrees, part.cast, part.empty, part.status = (
                    loan.output(array, rows, zero=chosen is not None)
                    for array in (value, error, spread, degrees, cast, empty, status)
                )
                self._run(loan, part, None if chosen is None else chosen[rows])
        valid = has_value(status)
        total = np.where(valid, strata.rays, 0)
        skipped = Skipped(
            points=int(np.count_nonzero(~valid)),
            open_points=int(np.count_nonzero((empty == total) & (total > 0))),
            empty_rays=int(empty.sum(dtype=np.int64)),
            weightless_rays=int((total - cast - empty).sum()),
        )
        unit = np.float32(self.summed.unit)
        found = self.summed.result(unit * value, unit * error, unit * spread, degrees, cast, status, skipped)
        return widen(found, self.summed.typical, strata.rays)

    def _placement(self) -> PlacementArgs:
        if not self.traced:
            return PlacementArgs()
        placement = self.at.facing(self.options, self.summed.reach)
        if self.summed.falloff is not None:  # the falloff is relative to the reach, which must be a finite float32
            placement.reach = min(placement.reach, _MOST_REACH)
        return placement

    def _part(self, loan: Loan, rows: slice, strata: Strata, skip: bool) -> LobesArgs:
        """Build the kernel argument for a slice of the points, still without the seed and the result arrays."""
        options = self.options
        part = LobesArgs(
            placement=self.placement,
            first_point=options.first_point + rows.start,
            first_row=rows.start,
            normals=loan.lend(self.at.normal, rows),
            active=loan.lend(options.active, rows),
            samples_per_stratum=strata.samples_per_stratum,
            bands=strata.bands,
            sectors=strata.sectors,
            shafts=loan.lend(strata.shafts) if strata.shafts.size and skip and options.tracer.skips else 0,
            skip=skip,
            edge=options.sequence.edge_variance(strata.samples_per_stratum),
            falloff=self.summed.falloff or 0.0,
            parameters=self.plan.distribution.kernel_parameters(loan).__ctype__(),
            tables=self.plan.distribution.lend_tables(loan, rows),
            tangents=loan.lend(self.plan.tangent, rows),
        )
        if self.traced and self.at.scene.has_glass:
            part.glass = self.at.scene.glass(options.workers)
        part.placement.points = rows.stop - rows.start
        part.placement.ids = loan.lend(options.ids, rows)
        if self.traced:
            self.at.lend(part.placement, loan, rows)
        return part

    def _run(self, loan: Loan, lobes: LobesArgs, chosen: np.ndarray | None) -> None:
        """Launch the kernel for the chosen points, by default for all points."""
        options, memory = self.options, self.options.memory
        rays = 2 * lobes.samples_per_stratum * lobes.bands * lobes.sectors
        in_scene = self.traced and memory.in_place
        order = self.at.order(lobes.placement, rays, options.workers) if in_scene else None
        rows = np.arange(lobes.placement.points) if order is None else order
        rows = rows if chosen is None else rows[chosen[rows]]
        if len(rows) == 0:
            return
        lobes.placement.order = loan.lend(rows)
        accelerator = AcceleratorArgs()
        if self.traced:
            accelerator = options.tracer.accelerator(self.at.scene, memory.device, options.workers)
        work = (RAY_WORK if self.traced else 1) * len(rows) * rays
        lobes.visits = len(rows)
        lobes.rows = min(max(1, _TASK // rays), _MOST_ROWS) if at_home(memory.device) else 1
        kernel, tasks = estimate_kernel(self._slots()), -(-len(rows) // lobes.rows)
        run(kernel, tasks, [lobes, accelerator, self.data], memory.device, workers=options.workers, work=work)

    def _slots(self) -> Slots:
        plan, integrand, any_hit = self.plan, self.summed.integrand, self.summed.falloff is None
        maps, tracer = plan.distribution.maps, self.options.tracer
        has_glass, tangents = self.traced and self.at.scene.has_glass, plan.tangent is not None
        return Slots(
            sequence=self.options.sequence,
            about=plan.distribution.about(tangents),
            redraw=redraw_of(maps, tangents),
            redraw_below=maps.redraw_below,
            upward=plan.distribution == POLAR_COSINE or integrand.sparse,
            weigh=integrand.function,
            struct=integrand.struct,
            constant=integrand.constant,
            counts=integrand.binary and any_hit and not has_glass,
            channels=integrand.channels,
            prepare=tracer.prepare if self.traced else None,
            query=tracer.distance_query(any_hit) if self.traced else None,
            any_hit=any_hit,
            wide=tracer.skips,
            glass=has_glass,
            sparse=integrand.sparse,
            layout=plan.distribution.layout,
            tangents=tangents,
            reads_pdf=integrand.reads_pdf,
            binary=integrand.binary,
        )
