"""Search for faces with no geometry above their plane, whose rays hit nothing and are not cast."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import int_at, set_byte
from warpsample.radiation.exchange.face_rays import FaceRays, face_at, horizon_margin, lowest_start
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.frontier import has_triangle_above
from warpsample.tracing.sight.point import point_in, workspace_floats

_FLOATS = workspace_floats(0, 0)


@once
def open_kernel() -> wp.Kernel:
    """Build the kernel that marks the faces with no geometry above their plane, one face per task.

    It writes `opens` (B,) uint8, 1 for such faces.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def find_open(rays: FaceRays, tree: Accelerator, opens: wp.uint64, first_task: wp.int64):
        memory = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
        row = first_task + wp.int64(wp.tid())
        f = face_at(rays, int_at(rays.rows, row))
        limit = wp.float32(lowest_start(f)) - horizon_margin(rays, f.n)
        set_byte(opens, row, wp.where(has_triangle_above(tree, f.n, limit, point_in(memory.ptr, 0, 0).scratch), 0, 1))

    return find_open
