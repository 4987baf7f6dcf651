"""The nodes at which the rays of one point start: the tree without what is around the point or below its horizon.

All rays from a point on a surface would open the same nodes and leaves around it. So these are opened once: their other
children become nodes of the point's own, which its rays start from, and the few triangles around the point that reach
above its horizon become a leaf. What is below the horizon or out of reach is left out. No ray gets another answer.
"""

import warp as wp

from warpsample.maths.numerics import fma, greater, lowest_bit
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.corners import highest_corner
from warpsample.tracing.wide.layout import (
    LEAF_BYTES,
    LINKS,
    MOST_STARTS,
    NODE_BYTES,
    WIDTH,
    Accelerator,
    edge_in,
    leaf_at,
    link_in,
    node_at,
)

NEAR = wp.constant(wp.uint64(MOST_STARTS * NODE_BYTES))
"""Where the leaf around the point is, in bytes from the point's first node on."""

NEAR_EDGE = wp.constant(wp.uint64(MOST_STARTS * NODE_BYTES + LEAF_BYTES))
"""Where its triangles' longest side is, seen along an axis."""

HORIZON_MARGIN = wp.constant(wp.float32(2.0**-20))
"""Times `rays.reach_along` the normal: what is lower than this below the origin's horizon plane is below it for sure.

A height's three products and sums, and the coordinates and the normal's components in them, are rounded to 2^-21.4 of that.
An origin that is `rays.lift`ed off the surface, by 2^-19, thus has its own face, and all in its plane, below itself.
"""

_NODE_FLOATS = NODE_BYTES // 4
_LEAF_FLOATS = LEAF_BYTES // 4
_PADDING = wp.constant(wp.float32(PADDING))
_NOWHERE = wp.constant(wp.float32(2.0**60))
_MOST_ENTRIES = wp.constant(wp.int32(MOST_STARTS * WIDTH))
_MOST_OPENED = 2 * WIDTH


@wp.func
def _beyond(low: wp.float32, high: wp.float32, x: wp.float32) -> wp.float32:
    """From x to an interval; 0 inside."""
    return greater(greater(low - x, x - high), 0.0)


@wp.func
def visible(node: wp.uint64, o: wp.vec3, n: wp.vec3, limit: wp.float32, reach: wp.float32):
    """Masks of the children that reach above the horizon and into reach, and of those whose boxes the origin is in."""
    rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    links = wp.array(ptr=node + wp.uint64(4 * LINKS), shape=(WIDTH,), dtype=wp.int32)
    visible = wp.int32(0)
    around = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        x = wp.where(n[0] > 0.0, rows[3 * WIDTH + k], rows[k])
        y = wp.where(n[1] > 0.0, rows[4 * WIDTH + k], rows[WIDTH + k])
        z = wp.where(n[2] > 0.0, rows[5 * WIDTH + k], rows[2 * WIDTH + k])
        above = wp.where(fma(x, n[0], fma(y, n[1], z * n[2])) >= limit, 1, 0)
        dx = _beyond(rows[k], rows[3 * WIDTH + k], o[0])
        dy = _beyond(rows[WIDTH + k], rows[4 * WIDTH + k], o[1])
        dz = _beyond(rows[2 * WIDTH + k], rows[5 * WIDTH + k], o[2])
        apart = wp.sqrt(fma(dx, dx, fma(dy, dy, dz * dz)))
        visible = visible | ((above & wp.where(apart < reach, 1, 0) & wp.where(links[k] != 0, 1, 0)) << k)
        around = around | (wp.where(apart == 0.0, 1, 0) << k)
        k += 1
    return visible, around


@wp.func
def triangles_above(leaf: wp.uint64, n: wp.vec3, limit: wp.float32) -> wp.int32:
    """Mask of the leaf's triangles that reach above the horizon."""
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        mask = mask | wp.where(highest_corner(leaf, k, n[0], n[1], n[2]) >= limit, 1 << k, 0)
        k += 1
    return mask


@wp.func
def _take_over(node: wp.uint64, child: wp.int32, room: wp.uint64, entry: wp.int32):
    """Makes a child of a node the entry-th of the point's own nodes."""
    source = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    target = wp.array(ptr=room + wp.uint64(entry / WIDTH) * wp.uint64(NODE_BYTES), shape=(_NODE_FLOATS,), dtype=wp.float32)
    lane = entry % WIDTH
    if lane == 0:
        for k in range(3 * WIDTH):
            target[k] = _NOWHERE
            target[3 * WIDTH + k] = -_NOWHERE
    for row in range(8):
        target[row * WIDTH + lane] = source[row * WIDTH + child]


@wp.func
def _copy_triangle(leaf: wp.uint64, k: wp.int32, near: wp.uint64, lane: wp.int32):
    source = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    target = wp.array(ptr=near, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    for row in range(10):
        target[row * WIDTH + lane] = source[row * WIDTH + k]


@wp.func
def _take_apart(
    leaf: wp.uint64,
    n: wp.vec3,
    limit: wp.float32,
    edge: wp.float32,
    room: wp.uint64,
    triangles: wp.int32,
) -> wp.int32:
    """How many triangles are around the point with those of a leaf that it is in; -1 if there is no room for them."""
    met = triangles_above(leaf, n, limit)
    count = wp.bit_count(met)
    if triangles + count > WIDTH:
        return -1
    if count > 0:
        longest = wp.array(ptr=room + NEAR_EDGE, shape=(1,), dtype=wp.float32)
        longest[0] = wp.max(longest[0], edge)
    for _ in range(count):
        _copy_triangle(leaf, lowest_bit(met), room + NEAR, triangles)
        met = met & (met - 1)
        triangles += 1
    return triangles


@wp.func
def frontier(
    accelerator: Accelerator, o: wp.vec3, n: wp.vec3, low: wp.float32, reach: wp.float32, room: wp.uint64, scratch: wp.uint64
):
    """(nodes to start from, triangles in the leaf at NEAR): the rays from o above the horizon of n meet nothing else.

    With neither, nothing is above. -1 nodes: there was no room for all, and rays are to start from the root.

    Args:
        accelerator: the tree.
        o: the rays' origin.
        n: unit; the rays' cosines to it are at least 2^-12, as the cosine lobe's are.
        low: what is lower than this below the horizon is below it.
        reach: what is as far is left out.
        room: address of START_FLOATS floats.
        scratch: address of SCRATCH words.
    """
    longest = wp.array(ptr=room + NEAR_EDGE, shape=(1,), dtype=wp.float32)
    longest[0] = 0.0
    waiting = wp.array(ptr=scratch, shape=(WIDTH,), dtype=wp.int32)
    waiting[0] = 0
    waits = wp.int32(1)
    limit = wp.dot(n, o) - low
    box_limit = limit + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))  # boxes are padded, triangles are not
    entries = wp.int32(0)
    triangles = wp.int32(0)
    for _ in range(_MOST_OPENED):
        if waits > 0:
            waits -= 1
            node = node_at(accelerator, waiting[waits])
            seen, around = visible(node, o, n, box_limit, reach)
            for _ in range(wp.bit_count(seen)):
                child = lowest_bit(seen)
                seen = seen & (seen - 1)
                place = link_in(node, child)
                apart = wp.int32(-1)
                if ((around >> child) & 1) != 0:
                    if place < 0:
                        leaf = leaf_at(accelerator, ~place)
                        apart = _take_apart(leaf, n, limit, edge_in(node, child), room, triangles)
                        triangles = wp.max(triangles, apart)
                    elif waits < WIDTH:
                        waiting[waits] = place
                        waits += 1
                        apart = 0
                if apart < 0:
                    if entries < _MOST_ENTRIES:
                        _take_over(node, child, room, entries)
                    entries += 1
    starts = (entries + WIDTH - 1) / WIDTH
    if entries > _MOST_ENTRIES or waits > 0:
        starts = -1
    return starts, triangles
