"""How a checked call of `sample_directions` is run: which kernel, in which parts, on which device."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import warp as wp

from warpsample.directions.blocks import direction_blocks
from warpsample.directions.rows import MOST_ROWS, direction_rows
from warpsample.directions.samples import SamplesArgs
from warpsample.directions.variates import CHUNK
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.distributions.record import Distribution
from warpsample.host.arrays import Array
from warpsample.host.engine import run
from warpsample.host.neighbours import address_of
from warpsample.host.vectors import Vectors, as_vectors, new_vectors
from warpsample.sequences.record import Sequence

_SEGMENT = 1 << 14  # samples of one row that a task takes: enough to share out one point's million samples
_TASK = 1 << 10  # samples of short rows that a task takes
_ROW = 12  # samples from which rows, padded to vectors, are faster than blocks of pairs
_UPLOAD = 1 << 28  # bytes a CUDA device holds at a time of a call whose arrays are NumPy's


@dataclass(frozen=True)
class Plan:
    """A checked call of `sample_directions`, but for its arrays."""

    distribution: Distribution
    sequence: Sequence
    count: int
    seed: int
    pdf: bool
    workers: int

    def fill(self, normals: Vectors, vectors: Vectors, pdf: Vectors | None, active: Array | None, first_point: int) -> Array:
        """Writes vectors and pdf, all arrays on one device, and returns the status."""
        device = normals.device
        on_host = isinstance(normals.owner, np.ndarray)
        status = np.zeros(normals.count, np.uint8) if on_host else wp.zeros(normals.count, dtype=wp.uint8, device=device)
        for start, end in same_high_word(first_point, normals.count):
            points = end - start
            args = SamplesArgs(
                seed=self.seed,
                first_point=first_point + start,
                points=points,
                count=self.count,
                normals=normals.address + 12 * start,
                vectors=vectors.address + 12 * start * self.count,
                pdf=pdf.address + 4 * start * self.count if pdf else 0,
                status=address_of(status) + start,
                active=0 if active is None else address_of(active) + start,
                parameters=self.distribution.kernel_parameters().__ctype__(),
            )
            kernel, tasks, args.segment, args.rows = self.kernel(device, points, masked=active is not None)
            run(kernel, tasks, [args], device, self.workers, points * self.count)
        return status

    def kernel(self, device: wp.Device, points: int, masked: bool) -> tuple[wp.Kernel, int, int, int]:
        """(kernel, tasks, samples of a segment, rows of a task): rows where one fills the vector lanes, and on CUDA."""
        maps = self.distribution.maps
        slots = (self.sequence, self.distribution.about(), maps.redraw, maps.redraw_below, self.pdf, masked)
        if device.is_cuda:
            return direction_rows(*slots, 1), points * self.count, 1, 1
        if self.count >= _ROW:
            segment = min(self.count, _SEGMENT)
            rows = min(max(1, _TASK // self.count), MOST_ROWS) if segment == self.count else 1
            tasks = -(-points * -(-self.count // segment) // rows)
            return direction_rows(*slots, CHUNK), tasks, segment, rows
        return direction_blocks(*slots, self.count == 1), -(-points * self.count // FLAT_BLOCK), FLAT_BLOCK, 1

    def fill_there(
        self,
        device: wp.Device,
        normals: np.ndarray,
        vectors: np.ndarray,
        pdf: np.ndarray | None,
        active: np.ndarray | None,
        first_point: int,
    ) -> np.ndarray:
        """As `fill`, for NumPy arrays and another device, which holds a part of at most _UPLOAD bytes at a time."""
        status = np.empty(len(normals), np.uint8)
        step = max(1, _UPLOAD // (16 * self.count + 14))
        for start in range(0, len(normals), step):
            rows = slice(start, start + step)
            there = as_vectors(wp.array(normals[rows], dtype=wp.vec3, device=device), 3, "normals")
            shape = (there.count, self.count)
            got, got_pdf = new_vectors(there, shape, 3), new_vectors(there, shape, 1) if self.pdf else None
            mask = None if active is None else wp.array(active[rows], dtype=wp.uint8, device=device)
            status[rows] = self.fill(there, got, got_pdf, mask, first_point + start).numpy()
            vectors[rows] = got.owner.numpy()
            if pdf is not None and got_pdf is not None:
                pdf[rows] = got_pdf.owner.numpy()
        return status


def same_high_word(first_point: int, points: int) -> list[tuple[int, int]]:
    """Rows [start, end) between which the global id does not cross a multiple of 2^32."""
    crossings = range(-first_point % 2**32 or 2**32, points, 2**32)
    return list(pairwise([0, *crossings, points]))
