"""Runs a checked call: the arrays of its points, made once, and a launch for each number of rays."""

from typing import TYPE_CHECKING

import numpy as np

from warpsample.estimate.cells import POLAR_COSINE, Cells, cells_of
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.result import Estimate, Skipped
from warpsample.estimate.slots import Slots
from warpsample.estimate.spot import LobesArgs
from warpsample.host.device_memory import Loan, at_home
from warpsample.host.engine import run
from warpsample.host.vectors import as_directions
from warpsample.tracing.order import order_of
from warpsample.tracing.placement import PlacementArgs, placed
from warpsample.tracing.rays import RAY_WORK
from warpsample.tracing.scene import scene_of
from warpsample.tracing.starts import faces_and_normals, set_starts
from warpsample.tracing.triples import Triples
from warpsample.tracing.wide.layout import AcceleratorArgs

if TYPE_CHECKING:
    from warpsample.estimate.plan import Plan, Quantity

_BYTES_OF_POINT = 128  # on a device: position, two normals, mask, order, and at most three of each number
_TASK, _MOST_ROWS = 1 << 11, 16  # rays and points of a task on the CPU, where to clear memory takes as long as ten rays
_MOST_REACH = 2.0**60  # of the scene's size: what is in it is at no distance at all from there on


class Runner:
    """The arrays of a plan and a quantity, ready to be run with any numbers of rays."""

    def __init__(self, plan: "Plan", quantity: "Quantity", loan: Loan) -> None:
        """Places the points and finds where their rays start; the loan lasts as long as the runner."""
        self.plan, self.quantity = plan, quantity
        self.scene = scene_of(plan.mesh) if plan.mesh else None
        self.position = Triples.of(plan.points.position, "points.position")
        self.normal = as_directions(Triples.of(plan.points.normal, "points.normal").owner)
        self.placement = self._placement() if len(plan.points) else None
        self.data = quantity.integrand.data_for(loan)

    def result(self, seed: int, count: int, chosen: np.ndarray | None = None, skip: bool | None = None) -> Estimate:
        """The estimate by `count` rays from each point.

        Args:
            seed: of the rays.
            count: rays.
            chosen: (P,) bool, the points to estimate; the others get 0.
            skip: as in the plan by default.
        """
        points, channels = len(self.plan.points), self.quantity.integrand.channels
        shape = (points,) if channels == 1 else (points, channels)
        value, error, spread, degrees = (np.zeros(shape, np.float32) for _ in range(4))
        cast, empty, status = (np.zeros(points, kind) for kind in (np.int32, np.int32, np.uint8))
        cells = cells_of(count, self.plan.distribution, self.scene is not None)
        for rows in self.plan.memory.parts(points, _BYTES_OF_POINT):
            with self.plan.memory.loan() as loan:
                part = self._part(loan, rows, cells, self.plan.skip if skip is None else skip)
                part.seed = seed
                part.value, part.error, part.spread, part.degrees, part.cast, part.empty, part.status = (
                    loan.output(array, rows, zero=chosen is not None)
                    for array in (value, error, spread, degrees, cast, empty, status)
                )
                self._run(loan, part, None if chosen is None else chosen[rows])
        total = np.where(status == 0, cells.rays, 0)
        skipped = Skipped(
            points=int(np.count_nonzero(status)),
            open_points=int(np.count_nonzero((empty == total) & (total > 0))),
            empty_rays=int(empty.sum(dtype=np.int64)),
            weightless_rays=int((total - cast - empty).sum()),
        )
        unit = np.float32(self.quantity.unit)
        return self.quantity.result(unit * value, unit * error, unit * spread, degrees, cast, status, skipped)

    def _placement(self) -> PlacementArgs:
        if self.scene is None:
            return PlacementArgs(points=len(self.plan.points))
        placement = placed(self.scene, self.position, self.quantity.reach)
        face, self.side = faces_and_normals(self.plan.mesh, self.plan.points, "points")
        placement.normals = self.side.ctypes.data
        if self.quantity.falloff is not None:  # is relative to the reach, so that must be a float32
            placement.reach = min(placement.reach, _MOST_REACH)
        plan = self.plan
        self.starts = set_starts(self.scene, placement, face, self.normal, plan.tracer, plan.workers)
        return placement

    def _part(self, loan: Loan, rows: slice, cells: Cells, skip: bool) -> LobesArgs:
        """The lobes of some points, without the seed of their rays and where their numbers go."""
        plan = self.plan
        part = LobesArgs(
            placement=self.placement,
            first_point=plan.first_point + rows.start,
            first_row=rows.start,
            normals=loan.put(self.normal, rows),
            active=loan.put(plan.active, rows),
            each=cells.each,
            bands=cells.bands,
            sectors=cells.sectors,
            beams=loan.put(cells.beams) if cells.beams.size and skip and plan.tracer.skips else 0,
            skip=skip,
            edge=plan.sequence.edge_variance(cells.each),
            falloff=self.quantity.falloff or 0.0,
            parameters=plan.distribution.kernel_parameters().__ctype__(),
        )
        part.placement.points = rows.stop - rows.start
        if self.scene:
            part.placement.origins = loan.put(self.position.owner, rows)
            part.placement.normals = loan.put(self.side, rows)
        return part

    def _run(self, loan: Loan, lobes: LobesArgs, chosen: np.ndarray | None) -> None:
        """Sums the lobes of the chosen points, by default of all."""
        plan, memory, rays = self.plan, self.plan.memory, 2 * lobes.each * lobes.bands * lobes.sectors
        order = order_of(self.scene, lobes.placement, rays, plan.workers) if self.scene and memory.in_place else None
        rows = np.arange(lobes.placement.points) if order is None else order
        rows = rows if chosen is None else rows[chosen[rows]]
        if len(rows) == 0:
            return
        lobes.placement.order = loan.put(rows)
        accelerator = plan.tracer.accelerator(self.scene, memory.device, plan.workers) if self.scene else AcceleratorArgs()
        work = (RAY_WORK if self.scene else 1) * len(rows) * rays
        lobes.visits = len(rows)
        lobes.rows = min(max(1, _TASK // rays), _MOST_ROWS) if at_home(memory.device) else 1
        kernel, tasks = estimate_kernel(self._slots()), -(-len(rows) // lobes.rows)
        run(kernel, tasks, [lobes, accelerator, self.data], memory.device, plan.workers, work)

    def _slots(self) -> Slots:
        plan, integrand, any_hit = self.plan, self.quantity.integrand, self.quantity.falloff is None
        maps, tracer = plan.distribution.maps, plan.tracer
        return Slots(
            sequence=plan.sequence,
            about=plan.distribution.about(),
            redraw=maps.redraw,
            redraw_below=maps.redraw_below,
            upward=plan.distribution == POLAR_COSINE,
            weigh=integrand.function,
            struct=integrand.struct,
            constant=integrand.constant,
            counts=integrand.binary and any_hit,
            channels=integrand.channels,
            prepare=tracer.prepare if self.scene else None,
            query=tracer.distance_query(any_hit) if self.scene else None,
            any_hit=any_hit,
            wide=tracer.skips,
        )
