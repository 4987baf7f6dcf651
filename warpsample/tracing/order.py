"""Order in which a kernel processes points: along a Morton curve, so that neighbours in space share cached memory."""

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.tracing.placement import Placement, PlacementArgs, local_origin
from warpsample.tracing.scene import Scene

MANY_FACES = 1 << 18
"""Number of faces from which the order of points matters: the cache holds smaller trees whole."""

_CELLS = 32  # along each axis: 15 bits, which NumPy sorts by radix in 20 ns a point
_FEW_POINTS = 1 << 12
_FEW_RAYS = 8  # per point: sorting takes as long as tracing one ray per point, and saves a tenth of the time
_COHERENT = 0.25  # largest fraction of consecutive points in different cells

_LAST_CELL = wp.constant(wp.int32(_CELLS - 1))
_HALF_CELLS = wp.constant(wp.float32(_CELLS / 2))


def visiting_order(scene: Scene, placement: PlacementArgs, count: int, workers: int) -> np.ndarray | None:
    """Return the indices of points, (P,) int64, in the order of a space-filling curve; None if the order is good already.

    Return None where sorting does not pay, or where the caller's order is coherent already. `count` is the number of rays
    per point.
    """
    points = placement.points
    if len(scene.faces) < MANY_FACES or points < _FEW_POINTS or count < _FEW_RAYS:
        return None
    cells = np.empty(points, np.uint16)
    run(_point_cells(), points, [placement, cells.ctypes.data], cpu(), workers=workers, work=points)
    if np.count_nonzero(cells[1:] != cells[:-1]) < _COHERENT * points:
        return None
    return np.argsort(cells, kind="stable")


@wp.func
def _find_cell(x: wp.float32) -> wp.int32:
    """Return the index, 0 to 31, of the grid cell that contains a coordinate from -1 to 1."""
    return wp.clamp(wp.int32((x + 1.0) * _HALF_CELLS), 0, _LAST_CELL)


@wp.func
def _spread_bits(x: wp.int32) -> wp.int32:
    """Insert two zero bits between neighbouring bits of a 5-bit number, as for one axis of a Morton code."""
    x = (x | (x << 8)) & 0x100F
    x = (x | (x << 4)) & 0x10C3
    return (x | (x << 2)) & 0x1249


@once
def _point_cells() -> wp.Kernel:
    """Build a kernel that writes the Morton code of each point's cell in the mesh's box, one point per task."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def point_cells(placement: Placement, cells: wp.uint64, first_task: wp.int64):
        i = first_task + wp.int64(wp.tid())
        o = local_origin(placement, i)
        x = _spread_bits(_find_cell(wp.float32(o[0])))
        y = _spread_bits(_find_cell(wp.float32(o[1])))
        z = _spread_bits(_find_cell(wp.float32(o[2])))
        cell = wp.array(ptr=cells + wp.uint64(i) * wp.uint64(2), shape=(1,), dtype=wp.uint16)
        cell[0] = wp.uint16(x | (y << 1) | (z << 2))

    return point_cells
