"""Rays that go on behind what they meet: every leaf in their way is looked into, every triangle that they cross is found."""

from typing import Any

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import address_at, float_at, int_at
from warpsample.maths.numerics import ONE, lowest_bit
from warpsample.tracing.queries import Accelerator, Glass
from warpsample.tracing.wide.candidates import boxes_met, triangles_near
from warpsample.tracing.wide.layout import NODE_BYTES, WIDTH, edge_in, face_in, leaf_at, link_in, node_at
from warpsample.tracing.wide.prepare import Ray
from warpsample.tracing.wide.triangle import crosses, plane_distance
from warpsample.tracing.wide.walk import WAITING, put_aside

_NOT_LOOKED_AT = wp.constant(wp.int32(-1))


@wp.func
def crossed(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32) -> wp.int32:
    """Mask of the triangles of a leaf that a ray crosses within reach; `edge` as for `triangles_near`."""
    near = triangles_near(leaf, ray, reach, edge)
    maybe = near & ((1 << WIDTH) - 1)
    mask = wp.int32(0)
    while maybe != 0:
        k = lowest_bit(maybe)
        maybe = maybe & (maybe - 1)
        distance = plane_distance(leaf, k, ray)
        if distance > 0.0 and distance < reach and (((near >> (WIDTH + k)) & 1) != 0 or crosses(leaf, k, ray)):
            mask = mask | (1 << k)
    return mask


@once
def through_walk(look: wp.Function, answer: Any) -> wp.Function:
    """A function (Accelerator, ray, reach, answer so far, scratch) -> answer, of a ray that nothing stops.

    In the tree's coordinates. `scratch` is the address of SCRATCH words.

    Args:
        look: (leaf, ray, reach, longest side in the leaf, answer so far) -> answer, asked of each leaf whose box the ray
            meets, in an order that is a function of the ray and the tree.
        answer: the type of the answer.
    """

    @wp.func
    def walk(tree: Accelerator, ray: Ray, reach: wp.float32, found: answer, scratch: wp.uint64):
        top = scratch
        for start in range(tree.starts):
            top = put_aside(top, tree.start + wp.uint64(start) * wp.uint64(NODE_BYTES), _NOT_LOOKED_AT, 0.0)
        while top != scratch:
            top -= WAITING
            node = address_at(top, 0)
            mask = int_at(top, 2)
            if mask == _NOT_LOOKED_AT:
                mask, _nearest = boxes_met(node, ray, reach, 0)
            below = wp.int32(0)
            while mask != 0 and below == 0:
                child = lowest_bit(mask)
                mask = mask & (mask - 1)
                link = link_in(node, child)
                if link < 0:
                    found = look(leaf_at(tree, ~link), ray, reach, edge_in(node, child), found)
                else:
                    below = link
            if mask != 0:
                top = put_aside(top, node, mask, 0.0)
            if below != 0:
                top = put_aside(top, node_at(tree, below), _NOT_LOOKED_AT, 0.0)
        return found

    return walk


@wp.struct
class Passed:
    """The share of light that is left of a ray so far, and the address of the faces' transmittances."""

    share: wp.float64
    transmittance: wp.uint64


@wp.func
def _multiply(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32, found: Passed):
    mask = crossed(leaf, ray, reach, edge)
    while mask != 0:
        k = lowest_bit(mask)
        mask = mask & (mask - 1)
        found.share *= wp.float64(float_at(found.transmittance, face_in(leaf, k)))
    return found


_walk_through_glass = through_walk(_multiply, Passed)


@wp.func
def share_through(glass: Glass, ray: Ray, reach: wp.float32, scratch: wp.uint64) -> wp.float32:
    """The product of the transmittances of what a ray crosses within reach, of the faces that let some light through.

    It is multiplied in float64, so that only its last bit may know in which order.
    """
    passed = Passed()
    passed.share = ONE
    passed.transmittance = glass.transmittance
    passed = _walk_through_glass(glass.tree, ray, reach, passed, scratch)
    return wp.float32(passed.share)


@wp.struct
class Crossing:
    """The first crossing of a ray behind another one: its distance and face, by which those at one distance are ordered.

    after, after_face: the other one.
    """

    distance: wp.float32
    face: wp.int32
    after: wp.float32
    after_face: wp.int32


@wp.func
def _first_of(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32, found: Crossing):
    mask = crossed(leaf, ray, reach, edge)
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


_walk_to_next = through_walk(_first_of, Crossing)


@wp.func
def next_crossing(
    tree: Accelerator, ray: Ray, reach: wp.float32, after: wp.float32, after_face: wp.int32, scratch: wp.uint64
):
    """(distance, face) of the first crossing within reach behind that of `after_face` at `after`; (inf, -1) without one."""
    found = Crossing()
    found.distance = wp.float32(wp.INF)
    found.face = -1
    found.after = after
    found.after_face = after_face
    found = _walk_to_next(tree, ray, reach, found, scratch)
    return found.distance, found.face
