"""Rays that met the back of a face: if another lies on it, turned to the ray, that is what they met.

Which of two faces in one place a tracer names is chance. As two walls of a thin slab or of two houses side by side may be
cut into different triangles, the face is looked for around the hit.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about
from warpsample.maths.memory import address_at, int_at, long_at, set_int, vec3_at
from warpsample.maths.numerics import lowest_bit
from warpsample.radiation.exchange.face_rays import BACK, FaceRays, direction_of, face_at, start_of
from warpsample.sequences.hashing import point_key
from warpsample.tracing.around import children_around, triangles_touched
from warpsample.tracing.placement import in_double
from warpsample.tracing.wide.layout import (
    SCRATCH,
    Accelerator,
    face_in,
    leaf_at,
    link_in,
    node_at,
)
from warpsample.tracing.wide.query import WAITING, put_aside

_BACK = wp.constant(wp.int32(BACK))
_NEAR = wp.constant(wp.float32(2.0**-21))  # of the scene's size, as far as eight roundings: so near is in one place
_OPPOSITE = wp.constant(wp.float32(-0.999))
_NONE = wp.constant(wp.int32(2**31 - 1))


@wp.func
def _first_opposite(rays: FaceRays, leaf: wp.uint64, p: wp.vec3, n: wp.vec3) -> wp.int32:
    """The lowest number of the faces of a leaf that touch a point and are turned against n."""
    best = _NONE
    touched = triangles_touched(leaf, p, _NEAR)
    for _ in range(wp.bit_count(touched)):
        face = face_in(leaf, lowest_bit(touched))
        touched = touched & (touched - 1)
        if wp.dot(vec3_at(rays.normals, face), n) < _OPPOSITE:
            best = wp.min(best, face)
    return best


@wp.func
def _opposite(rays: FaceRays, tree: Accelerator, p: wp.vec3, n: wp.vec3, scratch: wp.uint64) -> wp.int32:
    """The same of all faces."""
    best = _NONE
    node = tree.nodes
    mask = children_around(node, p, _NEAR)
    top = scratch
    while mask != 0 or top != scratch:
        if mask == 0:
            top -= WAITING
            node = address_at(top, 0)
            mask = wp.array(ptr=top, shape=(4,), dtype=wp.int32)[2]
        child = lowest_bit(mask)
        mask = mask & (mask - 1)
        place = link_in(node, child)
        if place < 0:
            best = wp.min(best, _first_opposite(rays, leaf_at(tree, ~place), p, n))
        else:
            if mask != 0:
                top = put_aside(top, node, mask, 0.0)
            node = node_at(tree, place)
            mask = children_around(node, p, _NEAR)
    return best


@once
def coincident_kernel() -> wp.Kernel:
    """A kernel with a task for each ray of `where`, (N,) int64 places among the codes, that met the back of a face."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def turn_round(rays: FaceRays, tree: Accelerator, where: wp.uint64, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        task = first_task + wp.int64(wp.tid())
        ray = long_at(where, task)
        part = ray / wp.int64(rays.each)
        row = part / wp.int64(rays.replicates)
        face = int_at(rays.rows, row)
        f = face_at(rays, face)
        id = (rays.first_face + wp.uint64(face)) * wp.uint64(rays.replicates) + wp.uint64(part % wp.int64(rays.replicates))
        key = point_key(rays.seed, id)
        i = wp.uint32(ray % wp.int64(rays.each))
        o = in_double(start_of(f, key, i))
        d = in_double(direction_of(frame_about(f.n), key, rays.step, i))
        met = face_at(rays, _BACK - int_at(rays.codes, ray))
        across = wp.cross(met.b, met.c)
        slope = wp.dot(across, d)
        if slope != wp.float64(0.0):
            p = o + (wp.dot(across, met.a - o) / slope) * d
            found = _opposite(rays, tree, wp.vec3(p), met.n, words.ptr)
            if found != _NONE:
                set_int(rays.codes, ray, found)

    return turn_round
