"""Rays that met the back of a face: if another lies on it, turned to the ray, that is what they met.

Which of two faces in one place a tracer names is chance. As two walls of a thin slab or of two houses side by side may be
cut into different triangles, the face is looked for around the hit.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about
from warpsample.maths.numerics import lowest_bit
from warpsample.radiation.exchange.face_rays import BACK, FaceRays, direction_of, face_at, start_of
from warpsample.sequences.hashing import point_key
from warpsample.tracing.around import children_around, triangles_touched
from warpsample.tracing.facets import in_double, vector_at
from warpsample.tracing.wide.layout import LEAF_BYTES, NODE_BYTES, SCRATCH, WIDTH, Accelerator
from warpsample.tracing.wide.query import put_aside

_BACK = wp.constant(wp.int32(BACK))
_NODE = wp.constant(wp.uint64(NODE_BYTES))
_LEAF = wp.constant(wp.uint64(LEAF_BYTES))
_PLACES = wp.constant(wp.uint64(6 * WIDTH * 4))
_FACES = wp.constant(wp.uint64(9 * WIDTH * 4))
_WAITING = wp.constant(wp.uint64(4 * 4))
_NEAR = wp.constant(wp.float32(2.0**-21))  # of the scene's size, as far as eight roundings: so near is in one place
_OPPOSITE = wp.constant(wp.float32(-0.999))
_NONE = wp.constant(wp.int32(2**31 - 1))


@wp.func
def _first_opposite(rays: FaceRays, leaf: wp.uint64, p: wp.vec3, n: wp.vec3) -> wp.int32:
    """The lowest number of the faces of a leaf that touch a point and are turned against n."""
    best = _NONE
    touched = triangles_touched(leaf, p, _NEAR)
    faces = wp.array(ptr=leaf + _FACES, shape=(WIDTH,), dtype=wp.int32)
    for _ in range(wp.bit_count(touched)):
        face = faces[lowest_bit(touched)]
        touched = touched & (touched - 1)
        if wp.dot(vector_at(rays.normals, wp.int64(face)), n) < _OPPOSITE:
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
            top -= _WAITING
            node = wp.array(ptr=top, shape=(1,), dtype=wp.uint64)[0]
            mask = wp.array(ptr=top, shape=(4,), dtype=wp.int32)[2]
        child = lowest_bit(mask)
        mask = mask & (mask - 1)
        place = wp.array(ptr=node + _PLACES, shape=(WIDTH,), dtype=wp.int32)[child]
        if place < 0:
            best = wp.min(best, _first_opposite(rays, tree.leaves + wp.uint64(~place) * _LEAF, p, n))
        else:
            if mask != 0:
                top = put_aside(top, node, mask, 0.0)
            node = tree.nodes + wp.uint64(place) * _NODE
            mask = children_around(node, p, _NEAR)
    return best


@once
def coincident_kernel() -> wp.Kernel:
    """A kernel with a task for each ray of `where`, (N,) int64 places among the codes, that met the back of a face."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def turn_round(rays: FaceRays, tree: Accelerator, where: wp.uint64, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        task = first_task + wp.int64(wp.tid())
        ray = wp.array(ptr=where + wp.uint64(task) * wp.uint64(8), shape=(1,), dtype=wp.int64)[0]
        part = ray / wp.int64(rays.each)
        row = part / wp.int64(rays.replicates)
        face = wp.array(ptr=rays.rows + wp.uint64(row) * wp.uint64(4), shape=(1,), dtype=wp.int32)[0]
        f = face_at(rays, face)
        id = (rays.first_face + wp.uint64(face)) * wp.uint64(rays.replicates) + wp.uint64(part % wp.int64(rays.replicates))
        key = point_key(rays.seed, id)
        i = wp.uint32(ray % wp.int64(rays.each))
        o = in_double(start_of(f, key, i))
        d = in_double(direction_of(frame_about(f.n), key, rays.step, i))
        code = wp.array(ptr=rays.codes + wp.uint64(ray) * wp.uint64(4), shape=(1,), dtype=wp.int32)
        met = face_at(rays, _BACK - code[0])
        across = wp.cross(met.b, met.c)
        slope = wp.dot(across, d)
        if slope != wp.float64(0.0):
            p = o + (wp.dot(across, met.a - o) / slope) * d
            found = _opposite(rays, tree, wp.vec3(p), met.n, words.ptr)
            if found != _NONE:
                code[0] = found

    return turn_round
