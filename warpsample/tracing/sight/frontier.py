"""Part of the search tree that rays from one surface point can reach, collected once for all the point's rays.

All rays from a point on a surface would open the same nodes and
leaves around the point. So these are opened once for all rays. The other children of the opened nodes become start nodes of
the point's rays, the *frontier*. The few triangles around the point that reach above its horizon become its *local leaf*.
Parts below the horizon or out of reach are left out. No ray gets a different answer.
"""

import warp as wp

from warpsample.maths.numerics import fma, greater, lowest_bit
from warpsample.tracing.placement import is_far_off
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.leaves import clear_leaf, copy_triangle, raise_extent
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
_VISITS = wp.constant(wp.int32(256))  # limit on nodes and leaves to look into: the time of a few dozen rays
_ANYWHERE = wp.constant(wp.float32(wp.INF))


@wp.func
def _distance_to_interval(low: wp.float32, high: wp.float32, x: wp.float32) -> wp.float32:
    """Return the distance from x to the interval from low to high; 0 inside."""
    return greater(greater(low - x, x - high), 0.0)


@wp.func
def limit_of_boxes(limit: wp.float32, n: wp.vec3) -> wp.float32:
    """Return the limit for the padded boxes of a tree, from a limit for triangles: both are dot products with n."""
    return limit + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))


@wp.func
def visible_children(node: wp.uint64, o: wp.vec3, n: wp.vec3, limit: wp.float32, reach: wp.float32):
    """Return two masks of a tree node's children: those that rays from the point o may hit, and those that contain o.

    A child is above the horizon if its box has a point x with x n of at least `limit`.
    """
    rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    links = wp.array(ptr=node + wp.uint64(4 * LINKS), shape=(WIDTH,), dtype=wp.int32)
    visible_children = wp.int32(0)
    around = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        x = wp.where(n[0] > 0.0, rows[3 * WIDTH + k], rows[k])
        y = wp.where(n[1] > 0.0, rows[4 * WIDTH + k], rows[WIDTH + k])
        z = wp.where(n[2] > 0.0, rows[5 * WIDTH + k], rows[2 * WIDTH + k])
        above = wp.where(fma(x, n[0], fma(y, n[1], z * n[2])) >= limit, 1, 0)
        dx = _distance_to_interval(rows[k], rows[3 * WIDTH + k], o[0])
        dy = _distance_to_interval(rows[WIDTH + k], rows[4 * WIDTH + k], o[1])
        dz = _distance_to_interval(rows[2 * WIDTH + k], rows[5 * WIDTH + k], o[2])
        apart = wp.sqrt(fma(dx, dx, fma(dy, dy, dz * dz)))
        visible_children = visible_children | ((above & wp.where(apart < reach, 1, 0) & wp.where(links[k] != 0, 1, 0)) << k)
        around = around | (wp.where(apart == 0.0, 1, 0) << k)
        k += 1
    return visible_children, around


@wp.func
def triangles_above(leaf: wp.uint64, n: wp.vec3, limit: wp.float32) -> wp.int32:
    """Return a mask of a tree leaf's triangles that have a corner above a point's horizon.

    Such a corner has a dot product with n of at least `limit`.
    """
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        mask = mask | wp.where(highest_corner(leaf, k, n[0], n[1], n[2]) >= limit, 1 << k, 0)
        k += 1
    return mask


@wp.func
def _copy_child(node: wp.uint64, child: wp.int32, nodes: wp.uint64, entry: wp.int32):
    """Copy a child (box and link) of a search-tree node to the list of nodes at which the rays of a point start."""
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
def _copy_to_local_leaf(
    leaf: wp.uint64, n: wp.vec3, limit: wp.float32, edge: wp.float32, local: wp.uint64, triangles: wp.int32
) -> wp.int32:
    """Copy a tree leaf's triangles above the horizon to the point's own list of triangles; return the list's new length.

    If they do not fit, nothing is copied and the result is -1.
    """
    met = triangles_above(leaf, n, limit)
    count = wp.bit_count(met)
    if triangles + count > WIDTH:
        return -1
    if count > 0:
        raise_extent(local, edge)
    for _ in range(count):
        copy_triangle(leaf, lowest_bit(met), local, triangles)
        met = met & (met - 1)
        triangles += 1
    return triangles


@wp.func
def _frontier(tree: Accelerator, point: ShadingPoint):
    """Collect the tree nodes and nearby triangles that a point's rays can hit; return the numbers of nodes and triangles.

    Local triangles are copies of the triangles around the point. Rays above the point's horizon hit nothing else; their
    cosines to the normal must be at least 2^-12, as in the cosine lobe. If both numbers are 0, nothing is above the horizon.
    The first is -1 if there was no room, so that rays start at the root.
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
            seen, around = visible_children(node, point.o, n, box_limit, point.reach)
            for _ in range(wp.bit_count(seen)):
                child = lowest_bit(seen)
                seen = seen & (seen - 1)
                link = link_in(node, child)
                apart = wp.int32(-1)
                if ((around >> child) & 1) != 0:
                    if link < 0:
                        leaf = leaf_at(tree, ~link)
                        apart = _copy_to_local_leaf(leaf, n, limit, edge_in(node, child), local, triangles)
                        triangles = wp.max(triangles, apart)
                    elif waits < WIDTH:
                        waiting[waits] = link
                        waits += 1
                        apart = 0
                if apart < 0:
                    if entries < _MOST_ENTRIES:
                        _copy_child(node, child, point.opened, entries)
                    entries += 1
    starts = (entries + WIDTH - 1) / WIDTH
    if entries > _MOST_ENTRIES or waits > 0:
        starts = -1
    return starts, triangles


@wp.func
def open_around(tree: Accelerator, point: ShadingPoint):
    """Restrict the search tree to what a point's rays can hit; return (tree, mask of nearby triangles, True if restricted).

    Local triangles are copies of the triangles around the point. The whole tree is returned unopened for a distant point,
    and where there is no room for all parts around the point.
    """
    local = wp.int32(0)
    opened = wp.bool(False)
    if not is_far_off(point.position):
        starts, around = _frontier(tree, point)
        opened = starts >= 0
        if opened:
            local = (1 << around) - 1
            tree.start = point.opened
            tree.starts = starts
    return tree, local, opened


@wp.struct
class HalfSpace:
    """Half-space of all points whose dot product with n is at least `limit`."""

    n: wp.vec3
    limit: wp.float32


@wp.func
def _find_children_in(node: wp.uint64, plane: HalfSpace):
    """Return a mask of a tree node's children whose boxes intersect a half-space."""
    mask, _around = visible_children(node, wp.vec3(0.0), plane.n, limit_of_boxes(plane.limit, plane.n), _ANYWHERE)
    return mask


@wp.func
def _find_triangle_in(leaf: wp.uint64, plane: HalfSpace, found: wp.bool):
    """Return (answer, stop), both True if a triangle of a tree leaf has a corner in a half-space."""
    found = triangles_above(leaf, plane.n, plane.limit) != 0
    return found, found


_walk = tree_walk(_find_children_in, _find_triangle_in, HalfSpace, wp.bool)


@wp.func
def has_triangle_above(tree: Accelerator, n: wp.vec3, limit: wp.float32, scratch: wp.uint64) -> wp.bool:
    """Return whether a triangle has a corner in a half-space: a dot product with n of at least `limit`.

    The result is True, too, if the limit on visits ends the search early.
    """
    plane = HalfSpace()
    plane.n = n
    plane.limit = limit
    found, spent = _walk(tree, plane, wp.bool(False), _VISITS, scratch)
    return found or spent
