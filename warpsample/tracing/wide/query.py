"""Traversal of the 16-wide search tree by one ray, for its nearest hit or any hit."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import address_at, int_at
from warpsample.maths.numerics import lowest_bit
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.wide.candidates import boxes_hit, triangles_near
from warpsample.tracing.wide.layout import NODE_BYTES, WIDTH, edge_in, face_in, leaf_at, link_in, node_at
from warpsample.tracing.wide.prepare import Ray, ray_in
from warpsample.tracing.wide.triangle import is_between_edges, plane_distance
from warpsample.tracing.wide.walk import STACK_ENTRY, push_node

_ALL = wp.constant(wp.int32(2**WIDTH - 1))


@wp.func
def nearest_triangle(leaf: wp.uint64, lanes: wp.int32, ray: Ray, reach: wp.float32, edge: wp.float32):
    """Return (distance, index) of the nearest triangle that a ray hits among the masked triangles of a tree leaf.

    Without a hit the result is (reach, -1).
    """
    found = triangles_near(leaf, ray, reach, edge)
    met = found & lanes
    nearest = wp.int32(-1)
    for _ in range(wp.bit_count(met)):
        triangle = lowest_bit(met)
        met = met & (met - 1)
        distance = plane_distance(leaf, triangle, ray)
        # wp.where instead of a branch: the processor cannot predict which triangle is nearest, only whether a hit is
        # certain.
        nearer = wp.where(distance > 0.0, 1, 0) & wp.where(distance < reach, 1, 0)
        if (nearer & ~(found >> (WIDTH + triangle))) != 0:
            nearer = wp.where(is_between_edges(leaf, triangle, ray), 1, 0)
        reach = wp.where(nearer != 0, distance, reach)
        nearest = wp.where(nearer != 0, triangle, nearest)
    return reach, nearest


@wp.func
def any_triangle(leaf: wp.uint64, lanes: wp.int32, ray: Ray, reach: wp.float32, edge: wp.float32):
    """Return (reach, index) of any triangle that a ray hits among a tree leaf's masked triangles; index -1 without one."""
    found = triangles_near(leaf, ray, reach, edge) & (lanes | (lanes << WIDTH))
    triangle = wp.int32(-1)
    if found != 0:
        sure = (found >> WIDTH) & _ALL
        met = found & _ALL
        if sure != 0:
            triangle = lowest_bit(sure)
            met = 0
        for _ in range(wp.bit_count(met)):
            if triangle < 0:
                distance = plane_distance(leaf, lowest_bit(met), ray)
                if distance > 0.0 and distance < reach and is_between_edges(leaf, lowest_bit(met), ray):
                    triangle = lowest_bit(met)
            met = met & (met - 1)
    return reach, triangle


@wp.func
def _nearest_answer(leaf: wp.uint64, triangle: wp.int32, ray: Ray, reach: wp.float32):  # noqa: ARG001  (signature shared)
    """Return (distance, face) of the nearest hit at distance `reach`; (inf, -1) if `triangle` is below 0."""
    if triangle < 0:
        return wp.float32(wp.INF), wp.int32(-1)
    return reach, face_in(leaf, triangle)


@wp.func
def _any_answer(leaf: wp.uint64, triangle: wp.int32, ray: Ray, reach: wp.float32):  # noqa: ARG001  (signature shared)
    """Return (distance, face) of any hit; (inf, -1) if `triangle` is below 0."""
    if triangle < 0:
        return wp.float32(wp.INF), wp.int32(-1)
    face = face_in(leaf, triangle)
    return plane_distance(leaf, triangle, ray), face


@wp.func
def _pop_node(ray: Ray, reach: wp.float32, top: wp.uint64, bottom: wp.uint64):
    """Pop a waiting tree node from the stack; return (node, mask of its children within the present reach, top).

    Nodes without such children are skipped; the mask is 0 if no node is left.
    """
    node = wp.uint64(0)
    mask = wp.int32(0)
    while mask == 0 and top != bottom:
        top -= STACK_ENTRY
        node = address_at(top, 0)
        mask = int_at(top, 2)
        if int_at(top, 3) != wp.cast(reach, wp.int32):
            still, _ = boxes_hit(node, ray, reach, 0)
            mask = mask & still
    return node, mask, top


@wp.func
def _start_at_one(accelerator: Accelerator, ray: Ray, reach: wp.float32, flip: wp.int32, scratch: wp.uint64):
    """Start the traversal of the search tree at one node; return (node, mask of children hit, nearest child, stack top)."""
    mask, child = boxes_hit(accelerator.start, ray, reach, flip)
    return accelerator.start, mask, child, scratch


@wp.func
def _start_at_several(accelerator: Accelerator, ray: Ray, reach: wp.float32, flip: wp.int32, scratch: wp.uint64):
    """Start the traversal of the search tree at the first of several nodes; the other nodes wait on the stack.

    Return the values of `_start_at_one`.
    """
    top = scratch
    node = accelerator.start
    mask, child = boxes_hit(node, ray, reach, flip)
    for other in range(1, accelerator.starts):
        top = push_node(top, node + wp.uint64(other) * wp.uint64(NODE_BYTES), -1, -1.0)
    if mask == 0:
        node, mask, top = _pop_node(ray, reach, top, scratch)
        child = lowest_bit(mask)
    return node, mask, child, top


@once
def wide_walk(any_hit: bool, several: bool = False) -> wp.Function:
    """Build the Warp function that traces one ray through the 16-wide search tree, for the nearest or any hit.

    It maps (Accelerator, Ray, reach, scratch) to (distance or inf, face or -1, nodes visited, leaves visited). Distances are
    in the tree's coordinates. Origins must be within 6 of 0 on each axis, and reaches above 0. `scratch` is the address of
    SCRATCH words.

    Args:
        any_hit: whether the query stops at the first triangle found instead of the nearest. It then visits the farthest
            child first: near the surface that it leaves, a ray hits many boxes and no triangle.
        several: whether there may be several start nodes; 5 % slower.
    """
    flip = -1 if any_hit else 0
    begin = _start_at_several if several else _start_at_one
    look_into, answer = (any_triangle, _any_answer) if any_hit else (nearest_triangle, _nearest_answer)

    @wp.func
    def walk(accelerator: Accelerator, ray: Ray, reach: wp.float32, scratch: wp.uint64):
        hit = wp.int32(-1)
        hit_leaf = wp.uint64(0)
        visited = wp.int32(1)
        visited_leaves = wp.int32(0)
        node, mask, child, top = begin(accelerator, ray, reach, flip, scratch)
        while mask != 0:
            mask = mask & (~(1 << child))
            link = link_in(node, child)
            below = wp.int32(0)
            if link < 0:
                visited_leaves += 1
                leaf = leaf_at(accelerator, ~link)
                edge = edge_in(node, child)
                reach, triangle = look_into(leaf, _ALL, ray, reach, edge)
                if triangle >= 0:
                    hit = triangle
                    hit_leaf = leaf
                    if any_hit:
                        mask = 0
                        top = scratch
                    if mask != 0:
                        still, child = boxes_hit(node, ray, reach, flip)
                        mask = mask & still
            else:
                visited += 1
                inner = node_at(accelerator, link)
                below, child = boxes_hit(inner, ray, reach, flip)
                if below != 0:
                    if mask != 0:
                        top = push_node(top, node, mask, reach)
                    node = inner
                    mask = below
            if below == 0:
                if mask == 0:
                    node, mask, top = _pop_node(ray, reach, top, scratch)
                child = lowest_bit(mask)
        nearest, face = answer(hit_leaf, hit, ray, reach)
        return nearest, face, visited, visited_leaves

    return walk


@once
def wide_query(any_hit: bool, several: bool = False) -> wp.Function:
    """Build the Warp function that traces one prepared ray through the 16-wide search tree.

    It takes (Accelerator, column, reach, scratch), where `column` is the address of the ray; see `wide_walk`.
    """
    walk = wide_walk(any_hit, several)

    @wp.func
    def wide_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
        return walk(accelerator, ray_in(column), reach, scratch)

    return wide_query
