"""Faces that nothing stands above: their rays meet nothing, so none is cast."""

import warp as wp

from warpsample.estimate.skipping.frontier import triangles_above, visible
from warpsample.host.locks import once
from warpsample.maths.memory import address_at, int_at, set_byte
from warpsample.maths.numerics import lowest_bit
from warpsample.radiation.exchange.face_rays import FaceRays, face_at, horizon_margin, lowest_start
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.layout import SCRATCH, Accelerator, leaf_at, link_in, node_at
from warpsample.tracing.wide.query import WAITING, put_aside

_VISITS = wp.constant(wp.int32(256))  # nodes and leaves that are looked into: as long as a few dozen rays take
_PADDING = wp.constant(wp.float32(PADDING))
_ANYWHERE = wp.constant(wp.float32(wp.INF))


@wp.func
def _stands_above(tree: Accelerator, n: wp.vec3, limit: wp.float32, scratch: wp.uint64) -> wp.bool:
    """Whether a triangle reaches as far along n as the limit, or so many visits do not tell."""
    box_limit = limit + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))  # boxes are padded, triangles are not
    visits = _VISITS
    found = wp.bool(False)
    node = tree.nodes
    top = scratch
    mask, _around = visible(node, wp.vec3(0.0), n, box_limit, _ANYWHERE)
    while (mask != 0 or top != scratch) and not found:
        if mask == 0:
            top -= WAITING
            node = address_at(top, 0)
            mask = wp.array(ptr=top, shape=(4,), dtype=wp.int32)[2]
        child = lowest_bit(mask)
        mask = mask & (mask - 1)
        place = link_in(node, child)
        if place < 0:
            found = triangles_above(leaf_at(tree, ~place), n, limit) != 0
        else:
            if mask != 0:
                top = put_aside(top, node, mask, 0.0)
            node = node_at(tree, place)
            mask, _around = visible(node, wp.vec3(0.0), n, box_limit, _ANYWHERE)
        visits -= 1
        found = found or visits == 0
    return found


@once
def open_kernel() -> wp.Kernel:
    """A kernel with a task for each face; opens (B,) uint8: 1 where nothing stands above it."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def find_open(rays: FaceRays, tree: Accelerator, opens: wp.uint64, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        row = first_task + wp.int64(wp.tid())
        face = int_at(rays.rows, row)
        f = face_at(rays, face)
        limit = wp.float32(lowest_start(f)) - horizon_margin(rays, f.n)
        set_byte(opens, row, wp.where(_stands_above(tree, f.n, limit, words.ptr), 0, 1))

    return find_open
