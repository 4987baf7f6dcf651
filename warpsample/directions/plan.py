"""Choice of the Warp kernel, and of the work of each of its tasks, for a call of `sample_directions`."""

from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from typing import Any

import numpy as np
import warp as wp

from warpsample.directions.blocks import direction_blocks
from warpsample.directions.rows import MOST_ROWS, direction_rows
from warpsample.directions.samples import SamplesArgs
from warpsample.directions.variates import CHUNK
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.distributions.parameters import redraw_of
from warpsample.distributions.record import Distribution
from warpsample.host.arrays import Array
from warpsample.host.device_memory import at_home
from warpsample.host.engine import run
from warpsample.host.options import CallOptions
from warpsample.host.vectors import Vectors
from warpsample.sequences.record import Sequence

_SEGMENT = 1 << 14  # most samples of a segment, so that the million samples of a single point are shared between threads
_TASK = 1 << 12  # samples of a task of short rows or blocks; the local memory that a task clears is a tenth of the size
# Samples per point from which rows are faster than blocks: 12 with SIMD vectors of 8 lanes, 24 with 16. Rows are padded.
_ROW = 20


@dataclass(frozen=True)
class DirectionPlan:
    """Checked arguments of a `sample_directions` call, without the arrays."""

    distribution: Distribution
    sequence: Sequence
    count: int
    pdf: bool
    options: CallOptions
    tangents: np.ndarray | None = None

    def fill(self, normals: Vectors, vectors: Vectors, pdf: Vectors | None) -> Array:
        """Sample directions and densities into the given arrays, and return a status code for each point."""
        memory, active = self.options.memory, _copy_rows(normals, self.options.active, wp.uint8)
        tangents = _copy_rows(normals, self.tangents, wp.vec4)
        on_host, points = isinstance(normals.owner, np.ndarray), normals.count
        status = np.zeros(points, np.uint8) if on_host else wp.zeros(points, wp.uint8, memory.device)
        row = 16 * self.count + 14 + (0 if tangents is None else 16) + 4 * len(self.distribution.layout)  # bytes
        for rows in memory.parts(points, row):
            with memory.loan() as loan:
                args = SamplesArgs(
                    count=self.count,
                    normals=loan.lend(normals.owner, rows),
                    vectors=loan.output(vectors.owner, rows),
                    pdf=loan.output(pdf.owner, rows) if pdf else 0,
                    status=loan.output(status, rows, zero=True),
                    seed=self.options.seed,
                    ids=loan.lend(self.options.ids, rows),
                    active=loan.lend(active, rows),
                    parameters=self.distribution.kernel_parameters(loan).__ctype__(),
                    tables=self.distribution.lend_tables(loan, rows),
                    tangents=loan.lend(tangents, rows),
                )
                self._run(args, memory.device, self.options.first_point + rows.start, rows.stop - rows.start)
        return status

    def _run(self, whole: SamplesArgs, device: wp.Device, first_point: int, points: int) -> None:
        """Run the kernel on arrays in the device's memory, once for each range of point ids with the same upper 32 bits."""
        for start, end in split_at_high_word(first_point, points):
            args = whole
            if start:
                args = SamplesArgs.from_buffer_copy(whole)
                args.normals += 12 * start
                args.vectors += 12 * start * self.count
                args.pdf += 4 * start * self.count if whole.pdf else 0
                args.status += start
                args.ids += 8 * start if whole.ids else 0
                args.row = start
                args.tangents += 16 * start if whole.tangents else 0
                args.active += start if whole.active else 0
            high, args.first_point = divmod(first_point + start, 2**32)
            args.run = _pack_run_words(self.sequence, self.options.seed, high)
            args.points = end - start
            kernel, tasks, args.segment, args.rows = self.kernel(
                device, args.points, masked=whole.active != 0, own_ids=whole.ids != 0
            )
            run(kernel, tasks, [args], device, workers=self.options.workers, work=args.points * self.count)

    def kernel(self, device: wp.Device, points: int, masked: bool, own_ids: bool = False) -> tuple[wp.Kernel, int, int, int]:
        """Choose the kernel; return (kernel, number of tasks, samples of a segment, rows or blocks of a task).

        Rows serve CUDA, points with user-defined ids, and counts that fill a SIMD vector. Blocks serve smaller counts, but
        not user-defined ids, because the keys of a block must differ in one word only.
        """
        lobe, tangents = self.distribution, self.tangents is not None
        how = {"redraw": redraw_of(lobe.maps, tangents), "redraw_below": lobe.maps.redraw_below, "with_pdf": self.pdf}
        how |= {"masked": masked, "layout": lobe.layout, "tangents": tangents}
        build = partial(_build_kernel, self.sequence, lobe.about(tangents), **how)
        if not at_home(device):
            return build(own_ids=own_ids, chunk=1), points * self.count, 1, 1
        if self.count >= _ROW or own_ids:
            segment = min(self.count, _SEGMENT)
            rows = min(max(1, _TASK // self.count), MOST_ROWS) if segment == self.count else 1
            tasks = -(-points * -(-self.count // segment) // rows)
            return build(own_ids=own_ids, chunk=CHUNK), tasks, segment, rows
        kernel = build(one_sample=self.count == 1)
        return kernel, -(-points * self.count // _TASK), FLAT_BLOCK, _TASK // FLAT_BLOCK


@lru_cache(maxsize=256)
def _build_kernel(sequence: Sequence, about: wp.Function, **shape: Any) -> wp.Kernel:
    """Build the kernel of `direction_blocks` if `shape` has the key `one_sample`, else that of `direction_rows`."""
    return (direction_blocks if "one_sample" in shape else direction_rows)(sequence, about, **shape)


@lru_cache(maxsize=1024)
def _pack_run_words(sequence: Sequence, seed: int, high: int) -> wp.vec4ui:
    """Return the four random words from which a sequence derives the keys of all points, as a vec4ui for a kernel struct."""
    return wp.vec4ui(*sequence.run_words(seed, high))


def _copy_rows(normals: Vectors, array: np.ndarray | None, kind: Any) -> Array | None:
    """Copy an array with one row for each point to the device of the normals, if the normals are a wp.array."""
    if array is None or isinstance(normals.owner, np.ndarray):
        return array
    return wp.array(array, dtype=kind, device=normals.device)


def split_at_high_word(first_point: int, points: int) -> list[tuple[int, int]]:
    """Split the rows of points into ranges [start, end) whose 64-bit point ids have the same upper 32 bits."""
    if first_point % 2**32 + points <= 2**32:
        return [(0, points)]
    crossings = range(-first_point % 2**32 or 2**32, points, 2**32)
    return list(pairwise([0, *crossings, points]))
