"""The nodes at which the rays of one point start: the tree without what is around the point or below its horizon.

All rays from a point on a surface would open the same nodes and leaves around it. So these are opened once: their other
children become nodes of the point's own, which its rays start from, and the few triangles around the point that reach
above its horizon become its local leaf. What is below the horizon or out of reach is left out. No ray gets another answer.
"""

import warp as wp

from warpsample.maths.numerics import fma, greater, lowest_bit
from warpsample.tracing.placement import far_off
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.leaves import clear_leaf, copy_triangle, lengthen
from warpsample.tracing.sight.point import LOCAL_LEAF, ShadingPoint
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.layout import (
    LINKS,
    MOST_STARTS,
    NODE_BYTES,
    WIDTH,
    edge_in,
    highest_corner,
    leaf_at,
    link_in,
    node_at,
)
from warpsample.tracing.wide.walk import tree_walk

_NODE_FLOATS = NODE_BYTES // 4
_PADDING = wp.constant(wp.float32(PADDING))
_NOWHERE = wp.constant(wp.float32(2.0**60))
_MOST_ENTRIES = wp.constant(wp.int32(MOST_STARTS * WIDTH))
_MOST_OPENED = 2 * WIDTH
_VISITS = wp.constant(wp.int32(256))  # nodes and leaves that are looked into: as long as a few dozen rays take
_ANYWHERE = wp.constant(wp.float32(wp.INF))


@wp.func
def _beyond(low: wp.float32, high: wp.float32, x: wp.float32) -> wp.float32:
    """From x to an interval; 0 inside."""
    return greater(greater(low - x, x - high), 0.0)


@wp.func
def limit_of_boxes(limit: wp.float32, n: wp.vec3) -> wp.float32:
    """The limit along a normal for boxes, which are padded, from that for the triangles in them, which are not."""
    return limit + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))


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
def _take_over(node: wp.uint64, child: wp.int32, nodes: wp.uint64, entry: wp.int32):
    """Makes a child of a node the entry-th of the point's own nodes."""
    source = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    target = wp.array(ptr=nodes + wp.uint64(entry / WIDTH) * wp.uint64(NODE_BYTES), shape=(_NODE_FLOATS,), dtype=wp.float32)
    lane = entry % WIDTH
    if lane == 0:
        for k in range(3 * WIDTH):
            target[k] = _NOWHERE
            target[3 * WIDTH + k] = -_NOWHERE
    for row in range(8):
        target[row * WIDTH + lane] = source[row * WIDTH + child]


@wp.func
def _take_apart(
    leaf: wp.uint64, n: wp.vec3, limit: wp.float32, edge: wp.float32, local: wp.uint64, triangles: wp.int32
) -> wp.int32:
    """How many triangles are in the local leaf with those of a leaf that the point is in; -1 if they do not fit."""
    met = triangles_above(leaf, n, limit)
    count = wp.bit_count(met)
    if triangles + count > WIDTH:
        return -1
    if count > 0:
        lengthen(local, edge)
    for _ in range(count):
        copy_triangle(leaf, lowest_bit(met), local, triangles)
        met = met & (met - 1)
        triangles += 1
    return triangles


@wp.func
def _frontier(tree: Accelerator, point: ShadingPoint):
    """(nodes to start from, triangles in the local leaf): the rays of a point above its horizon meet nothing else.

    Their cosines to its normal are at least 2^-12, as the cosine lobe's are. With neither, nothing is above. -1 nodes: there
    was no room for all, and rays are to start from the root.
    """
    local = point.opened + LOCAL_LEAF
    clear_leaf(local)
    waiting = wp.array(ptr=point.scratch, shape=(WIDTH,), dtype=wp.int32)
    waiting[0] = 0
    waits = wp.int32(1)
    n = point.n
    limit = wp.dot(n, point.o) - point.low
    box_limit = limit_of_boxes(limit, n)
    entries = wp.int32(0)
    triangles = wp.int32(0)
    for _ in range(_MOST_OPENED):
        if waits > 0:
            waits -= 1
            node = node_at(tree, waiting[waits])
            seen, around = visible(node, point.o, n, box_limit, point.reach)
            for _ in range(wp.bit_count(seen)):
                child = lowest_bit(seen)
                seen = seen & (seen - 1)
                link = link_in(node, child)
                apart = wp.int32(-1)
                if ((around >> child) & 1) != 0:
                    if link < 0:
                        leaf = leaf_at(tree, ~link)
                        apart = _take_apart(leaf, n, limit, edge_in(node, child), local, triangles)
                        triangles = wp.max(triangles, apart)
                    elif waits < WIDTH:
                        waiting[waits] = link
                        waits += 1
                        apart = 0
                if apart < 0:
                    if entries < _MOST_ENTRIES:
                        _take_over(node, child, point.opened, entries)
                    entries += 1
    starts = (entries + WIDTH - 1) / WIDTH
    if entries > _MOST_ENTRIES or waits > 0:
        starts = -1
    return starts, triangles


@wp.func
def open_around(tree: Accelerator, point: ShadingPoint):
    """(the tree as the point's rays see it, mask of the triangles in its local leaf, whether it was opened).

    Not opened, it is the whole tree: where the point is far off, or where there is no room for all that is around it.
    """
    local = wp.int32(0)
    opened = wp.bool(False)
    if not far_off(point.position):
        starts, around = _frontier(tree, point)
        opened = starts >= 0
        if opened:
            local = (1 << around) - 1
            tree.start = point.opened
            tree.starts = starts
    return tree, local, opened


@wp.struct
class Above:
    """A plane, above which x n is at least the limit."""

    n: wp.vec3
    limit: wp.float32


@wp.func
def _enter(node: wp.uint64, plane: Above):
    """Mask of the children whose boxes reach above the plane."""
    mask, _around = visible(node, wp.vec3(0.0), plane.n, limit_of_boxes(plane.limit, plane.n), _ANYWHERE)
    return mask


@wp.func
def _look(leaf: wp.uint64, plane: Above, found: wp.bool):
    """(whether a triangle reaches above the plane, whether that is enough)."""
    found = triangles_above(leaf, plane.n, plane.limit) != 0
    return found, found


_walk = tree_walk(_enter, _look, Above, wp.bool)


@wp.func
def stands_above(tree: Accelerator, n: wp.vec3, limit: wp.float32, scratch: wp.uint64) -> wp.bool:
    """Whether a triangle reaches as far along n as the limit, or so many visits do not tell."""
    plane = Above()
    plane.n = n
    plane.limit = limit
    found, spent = _walk(tree, plane, wp.bool(False), _VISITS, scratch)
    return found or spent
