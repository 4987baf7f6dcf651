"""Traversal of the 16-wide search tree that finds every triangle a ray crosses."""

from typing import Any

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import address_at, float_at, int_at
from warpsample.maths.numerics import ONE, lowest_bit
from warpsample.tracing.queries import Accelerator, Glass
from warpsample.tracing.wide.candidates import boxes_hit, triangles_near
from warpsample.tracing.wide.layout import NODE_BYTES, WIDTH, edge_in, face_in, leaf_at, link_in, node_at
from warpsample.tracing.wide.prepare import Ray
from warpsample.tracing.wide.triangle import is_crossed, plane_distance
from warpsample.tracing.wide.walk import STACK_ENTRY, push_node

_UNTESTED = wp.constant(wp.int32(-1))


@wp.func
def crossed_triangles(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32) -> wp.int32:
    """Return a mask of a leaf's triangles that a ray crosses within `reach`.

    `edge` is that of `triangles_near`.
    """
    near = triangles_near(leaf, ray, reach, edge)
    maybe = near & ((1 << WIDTH) - 1)
    mask = wp.int32(0)
    while maybe != 0:
        k = lowest_bit(maybe)
        maybe = maybe & (maybe - 1)
        distance = plane_distance(leaf, k, ray)
        if distance > 0.0 and distance < reach and (((near >> (WIDTH + k)) & 1) != 0 or is_crossed(leaf, k, ray)):
            mask = mask | (1 << k)
    return mask


@once
def through_walk(look: wp.Function, answer_type: Any) -> wp.Function:
    """Build a Warp function that traverses the tree along a ray and collects all triangles that the ray crosses.

    It maps (Accelerator, ray, reach, answer, scratch) to the answer. Rays are in the tree's coordinates. `answer` is the
    answer so far. `scratch` is the address of SCRATCH words.

    Args:
        look: function (leaf, ray, reach, edge, answer) -> answer, called for each leaf whose box the ray hits. `edge` is the
            longest extent of the leaf's triangles along an axis. The order of the leaves depends on the ray and the tree
            alone.
        answer_type: type of the answer.
    """

    @wp.func
    def walk(tree: Accelerator, ray: Ray, reach: wp.float32, answer: answer_type, scratch: wp.uint64):
        top = scratch
        for start in range(tree.starts):
            top = push_node(top, tree.start + wp.uint64(start) * wp.uint64(NODE_BYTES), _UNTESTED, 0.0)
        while top != scratch:
            top -= STACK_ENTRY
            node = address_at(top, 0)
            mask = int_at(top, 2)
            if mask == _UNTESTED:
                mask, _nearest = boxes_hit(node, ray, reach, 0)
            below = wp.int32(0)
            while mask != 0 and below == 0:
                child = lowest_bit(mask)
                mask = mask & (mask - 1)
                link = link_in(node, child)
                if link < 0:
                    answer = look(leaf_at(tree, ~link), ray, reach, edge_in(node, child), answer)
                else:
                    below = link
            if mask != 0:
                top = push_node(top, node, mask, 0.0)
            if below != 0:
                top = push_node(top, node_at(tree, below), _UNTESTED, 0.0)
        return answer

    return walk


@wp.struct
class Transmission:
    """Share of light transmitted along a ray so far, 0 to 1, and the address of the faces' transmittances, (F,) float32."""

    share: wp.float64
    transmittance: wp.uint64


@wp.func
def _multiply_transmittance(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32, found: Transmission):
    """Multiply the light transmitted along a ray by the transmittances of a leaf's triangles that the ray crosses."""
    mask = crossed_triangles(leaf, ray, reach, edge)
    while mask != 0:
        k = lowest_bit(mask)
        mask = mask & (mask - 1)
        found.share *= wp.float64(float_at(found.transmittance, face_in(leaf, k)))
    return found


_walk_through_glass = through_walk(_multiply_transmittance, Transmission)


@wp.func
def path_transmittance(glass: Glass, ray: Ray, reach: wp.float32, scratch: wp.uint64) -> wp.float32:
    """Return the product of the transmittances of the translucent faces that a ray crosses within `reach`, from 0 to 1.

    The product is computed in float64, so that the order of the faces can change only its last float32 bit.
    """
    passed = Transmission()
    passed.share = ONE
    passed.transmittance = glass.transmittance
    passed = _walk_through_glass(glass.tree, ray, reach, passed, scratch)
    return wp.float32(passed.share)


@wp.struct
class Crossing:
    """Search state for the next crossing of a ray with a face, behind a given crossing.

    Crossings are ordered by distance, then by face number.

    Attributes:
        distance: distance of the first crossing found so far, inf before one is found.
        face: face of that crossing, -1 before one is found.
        after: distance of the given crossing.
        after_face: face of the given crossing.
    """

    distance: wp.float32
    face: wp.int32
    after: wp.float32
    after_face: wp.int32


@wp.func
def _update_crossing(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32, found: Crossing):
    """Return the nearest crossing found so far, updated by the triangles of a tree leaf."""
    mask = crossed_triangles(leaf, ray, reach, edge)
    while mask != 0:
        k = lowest_bit(mask)
        mask = mask & (mask - 1)
        distance = plane_distance(leaf, k, ray)
        face = face_in(leaf, k)
        behind = distance > found.after or (distance == found.after and face > found.after_face)
        if behind and (distance < found.distance or (distance == found.distance and face < found.face)):
            found.distance = distance
            found.face = face
    return found


_walk_to_next = through_walk(_update_crossing, Crossing)


@wp.func
def next_crossing(
    tree: Accelerator, ray: Ray, reach: wp.float32, after: wp.float32, after_face: wp.int32, scratch: wp.uint64
):
    """Return (distance, face) of a ray's next crossing within `reach`, behind a given crossing.

    The given crossing is with `after_face` at distance `after`. Without one the result is (inf, -1).
    """
    found = Crossing()
    found.distance = wp.float32(wp.INF)
    found.face = -1
    found.after = after
    found.after_face = after_face
    found = _walk_to_next(tree, ray, reach, found, scratch)
    return found.distance, found.face
