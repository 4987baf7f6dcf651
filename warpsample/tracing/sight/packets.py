"""Test for all rays of one point together (a packet): which of the rays hit anything.

All rays of a packet leave from one origin. So the planes through the origin and the sides of a triangle are the same for
all rays, and each leaf is opened once for all rays that hit its box. Where float32 does not decide, the test of single rays
does: no ray gets a different answer. A set of rays is a mask of 64 bits, one for each ray of a chunk.
"""

import warp as wp

from warpsample.maths.memory import address_at, float_at, set_address
from warpsample.maths.numerics import high_word, low_word, lowest_bit
from warpsample.tracing.placement import is_far_off
from warpsample.tracing.queries import CHUNK, REACH, Accelerator, column_of, direction_of
from warpsample.tracing.sight.point import LOCAL_LEAF, ShadingPoint
from warpsample.tracing.sight.sides import open_leaf, rays_passing, triangles_passed
from warpsample.tracing.wide.candidates import entry_distance, exit_distance
from warpsample.tracing.wide.lanes import lanes_with
from warpsample.tracing.wide.layout import NODE_BYTES, WIDTH, edge_in, leaf_at, link_in, node_at
from warpsample.tracing.wide.prepare import ray_in
from warpsample.tracing.wide.query import any_triangle
from warpsample.tracing.wide.triangle import is_between_edges, plane_distance

_ROW = wp.constant(wp.uint64(4 * WIDTH))
_ALL = wp.constant(wp.int32(2**WIDTH - 1))
_ENTRY = wp.constant(wp.uint64(16))
"""Bytes of one stack entry: the address of a node, and the set of rays that hit its box."""

NO_RAYS: wp.uint64 = wp.constant(wp.uint64(0))
_ONE = wp.constant(wp.uint64(1))


@wp.func
def first_rays(length: wp.int32) -> wp.uint64:
    """Return the bit set that holds the first `length` rays of a point."""
    return wp.where(length > 0, (~NO_RAYS) >> wp.uint64((CHUNK - length) % CHUNK), NO_RAYS)


@wp.func
def set_size(rays: wp.uint64) -> wp.int32:
    """Return the number of rays in a bit set of rays."""
    return wp.int32(wp.bit_count(rays))


@wp.func
def ray_set(k: wp.int32) -> wp.uint64:
    """Return the bit set that holds only the k-th ray."""
    return _ONE << wp.uint64(k)


@wp.func
def lowest_ray(rays: wp.uint64) -> wp.int32:
    """Return the index of the first ray in a non-empty bit set of rays."""
    return wp.int32(wp.bit_count((rays & (~rays + _ONE)) - _ONE))


@wp.func
def _is_hit(leaf: wp.uint64, triangles: wp.int32, column: wp.uint64, reach: wp.float32) -> wp.bool:
    """Return whether a single ray hits one of a leaf's masked triangles."""
    met = wp.bool(False)
    ray = ray_in(column)
    while triangles != 0 and not met:
        k = lowest_bit(triangles)
        triangles = triangles & (triangles - 1)
        distance = plane_distance(leaf, k, ray)
        met = distance > 0.0 and distance < reach and is_between_edges(leaf, k, ray)
    return met


@wp.func
def _unblocked_by_triangles(
    leaf: wp.uint64, triangles: wp.int32, point: ShadingPoint, alive: wp.uint64, blocks: wp.int32
) -> wp.uint64:
    """Return the rays in the bit set `alive` that miss a tree leaf's triangles, by a loop that is vectorised over rays."""
    open_leaf(leaf, point.o, point.reach, point.sides)
    while triangles != 0:
        t = lowest_bit(triangles)
        triangles = triangles & (triangles - 1)
        for block in range(blocks):
            passing = rays_passing(point.sides, t, point.chunk + wp.uint64(block) * _ROW)
            if passing != 0:
                shift = wp.uint64(WIDTH * block)
                alive = alive & (~(wp.uint64((passing >> WIDTH) & _ALL) << shift))
                maybe = alive & (wp.uint64(passing & _ALL) << shift)
                while maybe != NO_RAYS:
                    k = lowest_ray(maybe)
                    maybe = maybe & (maybe - _ONE)
                    if _is_hit(leaf, 1 << t, column_of(point.chunk, k), point.reach):
                        alive = alive & (~ray_set(k))
    return alive


@wp.func
def _unblocked_by_leaf(
    leaf: wp.uint64, edge: wp.float32, point: ShadingPoint, rays: wp.uint64, alive: wp.uint64
) -> wp.uint64:
    """Return the rays in the bit set `alive` that miss a tree leaf's triangles, vectorised over triangles or rays.

    A single ray is tested without opening the leaf, which would not pay.
    """
    if (rays & (rays - _ONE)) == NO_RAYS:
        _reach, triangle = any_triangle(leaf, _ALL, ray_in(column_of(point.chunk, lowest_ray(rays))), point.reach, edge)
        return wp.where(triangle >= 0, alive & (~rays), alive)
    open_leaf(leaf, point.o, point.reach, point.sides)
    while rays != NO_RAYS:
        k = lowest_ray(rays)
        rays = rays & (rays - _ONE)
        passed = triangles_passed(point.sides, direction_of(point.chunk, k))
        met = wp.where((passed >> WIDTH) & _ALL != 0, 1, 0)
        if met == 0 and passed != 0:
            met = wp.where(_is_hit(leaf, passed & _ALL, column_of(point.chunk, k), point.reach), 1, 0)
        alive = alive & (~(wp.uint64(met) << wp.uint64(k)))
    return alive


@wp.func
def _children_hit(node: wp.uint64, point: ShadingPoint, rays: wp.uint64) -> wp.int32:
    """Return a mask of a tree node's children whose boxes are hit by at least one ray of a bit set of rays.

    Two words per child in `scratch` receive the set of rays that hit the child's box.
    """
    reach = point.reach
    low = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    high = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    while rays != NO_RAYS:
        bit = rays & (~rays + _ONE)
        rays = rays & (rays - _ONE)
        ray = ray_in(column_of(point.chunk, lowest_ray(bit)))
        low_bit = wp.int32(low_word(bit))
        high_bit = wp.int32(high_word(bit))
        k = wp.int32(0)
        while k < WIDTH:
            meets = wp.where(entry_distance(node, ray, k) <= exit_distance(node, ray, reach, k), -1, 0)
            low[k] = low[k] | (meets & low_bit)
            high[k] = high[k] | (meets & high_bit)
            k += 1
    words = wp.array(ptr=point.scratch, shape=(2 * WIDTH,), dtype=wp.int32)
    some = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    i = wp.int32(0)
    while i < WIDTH:
        words[i] = low[i]
        words[WIDTH + i] = high[i]
        some[i] = wp.where((low[i] | high[i]) != 0, -1, 0)
        i += 1
    return lanes_with(some.ptr, 31)


@wp.func
def _rays_at_child(point: ShadingPoint, child: wp.int32) -> wp.uint64:
    """Return the bit set of rays that hit the box of a tree node's child, from the results of `_children_hit`."""
    words = wp.array(ptr=point.scratch, shape=(2 * WIDTH,), dtype=wp.uint32)
    return (wp.uint64(words[WIDTH + child]) << wp.uint64(32)) | wp.uint64(words[child])


@wp.func
def _push(top: wp.uint64, node: wp.uint64, rays: wp.uint64) -> wp.uint64:
    """Push a tree node and the set of rays that hit its box onto the stack; return the new top."""
    set_address(top, 0, node)
    set_address(top, 1, rays)
    return top + _ENTRY


@wp.func
def _unblocked_by_tree(tree: Accelerator, point: ShadingPoint, alive: wp.uint64) -> wp.uint64:
    """Return the set of rays in `alive` that hit nothing in the tree."""
    top = point.waiting
    for start in range(tree.starts):
        top = _push(top, tree.start + wp.uint64(start) * wp.uint64(NODE_BYTES), alive)
    while top != point.waiting:
        top -= _ENTRY
        node = address_at(top, 0)
        mask = _children_hit(node, point, address_at(top, 1) & alive)
        while mask != 0:
            child = lowest_bit(mask)
            mask = mask & (mask - 1)
            rays = alive & _rays_at_child(point, child)
            if rays != NO_RAYS:
                link = link_in(node, child)
                if link < 0:
                    alive = _unblocked_by_leaf(leaf_at(tree, ~link), edge_in(node, child), point, rays, alive)
                else:
                    top = _push(top, node_at(tree, link), rays)
    return alive


@wp.func
def blocked_rays(tree: Accelerator, point: ShadingPoint, local: wp.int32, rays: wp.uint64, length: wp.int32) -> wp.uint64:
    """Return the bit set of a point's rays that hit anything, among the prepared rays in the bit set `rays`.

    The set holds some of the first `length` rays of the chunk. `local` is that of `first_hit`. The rays of a distant point
    have separate origins and reaches, and are traced one by one.
    """
    alive = rays
    if local != 0:
        alive = _unblocked_by_triangles(point.opened + LOCAL_LEAF, local, point, alive, (length + WIDTH - 1) / WIDTH)
    left = alive
    apart = is_far_off(point.position)
    while alive != NO_RAYS:
        these = alive
        if apart:
            these = ray_set(lowest_ray(alive))
            point.reach = float_at(column_of(point.chunk, lowest_ray(alive)), REACH)
        alive = alive & (~these)
        if point.reach > 0.0:
            left = left & (~these | _unblocked_by_tree(tree, point, these))
    return rays & (~left)
