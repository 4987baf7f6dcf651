"""Correction of rays that hit the back of a face where another face coincides with it and faces the ray.

Which of two coincident faces a tracer reports is arbitrary. The walls of a thin slab or of adjacent houses may be cut into
different triangles, so the other face is searched for around the hit.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about
from warpsample.maths.memory import int_at, long_at, set_int, vec3_at
from warpsample.maths.numerics import ZERO
from warpsample.radiation.exchange.face_rays import BACK, FaceRays, direction_of, face_at, start_of
from warpsample.sequences.hashing import point_key
from warpsample.tracing.placement import in_double
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.point import SCRATCH
from warpsample.tracing.sight.touching import faces_touching

_NEAR = wp.constant(wp.float32(2.0**-21))  # of the scene's size, eight roundings: nearer faces coincide
_OPPOSITE = wp.constant(wp.float32(-0.999))
_NONE = wp.constant(wp.int32(2**31 - 1))


@wp.struct
class Hit:
    """Hit of a ray on the back of a face: point p, radius r to search around it, and normal n.

    `normals` is the address of the normals of all faces, (F, 3) float32.
    """

    p: wp.vec3
    r: wp.float32
    n: wp.vec3
    normals: wp.uint64


@wp.func
def _choose_face(face: wp.int32, hit: Hit, best: wp.int32) -> wp.int32:
    """Return `face` if it coincides with the face that was hit, faces the ray, and has a lower number than `best`.

    Otherwise return `best`.
    """
    if wp.dot(vec3_at(hit.normals, face), hit.n) < _OPPOSITE:
        best = wp.min(best, face)
    return best


_look_around = faces_touching(_choose_face, Hit, wp.int32)


@once
def coincident_kernel() -> wp.Kernel:
    """Build the kernel that replaces hits on backs of faces by coincident front faces, one ray per task.

    `where`, (N,) int64: indices among the codes of the rays that hit a back.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def turn_round(rays: FaceRays, tree: Accelerator, where: wp.uint64, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        task = first_task + wp.int64(wp.tid())
        ray = long_at(where, task)
        part = ray / wp.int64(rays.per_replicate)
        row = part / wp.int64(rays.replicates)
        face = int_at(rays.rows, row)
        f = face_at(rays, face)
        id = (rays.first_face + wp.uint64(face)) * wp.uint64(rays.replicates) + wp.uint64(part % wp.int64(rays.replicates))
        key = point_key(rays.seed, id)
        i = wp.uint32(ray % wp.int64(rays.per_replicate))
        o = in_double(start_of(f, key, i))
        d = in_double(direction_of(frame_about(f.n), key, rays.step, i))
        met = face_at(rays, BACK - int_at(rays.codes, ray))
        across = wp.cross(met.b, met.c)
        slope = wp.dot(across, d)
        if slope != ZERO:
            p = o + (wp.dot(across, met.a - o) / slope) * d
            hit = Hit()
            hit.p = wp.vec3(p)
            hit.r = _NEAR
            hit.n = met.n
            hit.normals = rays.normals
            found = _look_around(tree, hit, _NONE, words.ptr)
            if found != _NONE:
                set_int(rays.codes, ray, found)

    return turn_round
