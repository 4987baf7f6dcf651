"""Kernel that casts rays from faces and stores, for each ray, a code for what it hits."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.frames import frame_about
from warpsample.maths.memory import int_at, set_float, set_int, vec3_at
from warpsample.radiation.exchange.face_rays import (
    BACK,
    GROUND,
    SKY,
    Face,
    FaceRays,
    direction_of,
    face_at,
    horizon_margin,
    lowest_start,
    start_of,
)
from warpsample.sequences.hashing import point_key
from warpsample.tracing import queries
from warpsample.tracing.placement import in_double
from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, Accelerator, set_direction, set_origin, start_all
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.point import ShadingPoint, point_in, workspace_floats
from warpsample.tracing.sight.rays import first_hit, glass_transmittance_to, prepare_rays, whole_vectors

_THREE = wp.constant(wp.float64(3.0))
_REACH = wp.constant(wp.float32(2.0**60))  # longest ray, relative to the scene's size
_FLOATS = workspace_floats(0)
_hit = first_hit(False)
_prepare = prepare_rays()


@wp.func
def _fill_chunk(f: Face, key: wp.vec4ui, step: wp.uint64, first: wp.int32, length: wp.int32, chunk: wp.uint64):
    """Write the starts and directions of consecutive rays of a face to the buffer of rays to trace."""
    frame = frame_about(f.n)
    k = wp.int32(0)
    while k < length:
        set_direction(chunk, k, direction_of(frame, key, step, wp.uint32(first + k)))
        k += 1
    k = wp.int32(0)
    while k < length:
        set_origin(chunk, k, start_of(f, key, wp.uint32(first + k)))
        k += 1


@wp.func
def _encode_hit(rays: FaceRays, face: wp.int32, d: wp.vec3) -> wp.int32:
    """Return the code for what a ray hits: a face number, or a negative code for sky, ground or the back of a face."""
    if face < 0:
        return wp.where(wp.dot(rays.up, d) < 0.0, GROUND, SKY)
    return wp.where(wp.dot(vec3_at(rays.normals, face), d) < 0.0, face, BACK - face)


@wp.func
def _place_at_centre(rays: FaceRays, f: Face, point: ShadingPoint) -> ShadingPoint:
    """Place a point at the centre of a face; the search tree is restricted to what this point sees, for all the face's rays.

    All rays of a face start in one plane, so geometry below the centre's horizon is below the horizon of every start.
    """
    along = in_double(f.n)
    point.position = f.a + (f.b + f.c) / _THREE + f.offset * along
    point.n = f.n
    point.o = wp.vec3(point.position)
    point.low = horizon_margin(rays, f.n) + wp.max(wp.float32(wp.dot(along, point.position) - lowest_start(f)), 0.0)
    point.reach = _REACH
    start_all(point.chunk, point.o, point.reach)
    return point


@once
def _build_caster(glass: bool) -> wp.Function:
    """Build the Warp function that casts one of the independent sets of rays of a face.

    `glass` is for meshes with transmitting faces.
    """

    @wp.func
    def cast(rays: FaceRays, tree: Accelerator, local: wp.int32, point: ShadingPoint, f: Face, place: wp.int64):
        """Cast one of the independent sets of rays of a face, and write a code for each hit, from index `place` on."""
        for first in range(0, rays.per_replicate, CHUNK):
            length = wp.min(CHUNK, rays.per_replicate - first)
            _fill_chunk(f, point.key, rays.step, first, whole_vectors(length), point.chunk)
            _prepare(tree, point, local, length)
            for k in range(length):
                distance, face = _hit(tree, point, local, k)
                at = place + wp.int64(first + k)
                set_int(rays.codes, at, _encode_hit(rays, face, queries.direction_of(point.chunk, k)))
                if wp.static(glass):
                    set_float(rays.weights, at, glass_transmittance_to(rays.glass, point, k, distance))

    return cast


@once
def face_kernel(glass: bool = False) -> wp.Kernel:
    """Build the kernel that casts rays from faces and stores the hit faces; `glass` adds translucent faces."""
    cast_replicate = _build_caster(glass)

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def cast(rays: FaceRays, accelerator: Accelerator, first_task: wp.int64):
        memory = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
        row = first_task + wp.int64(wp.tid())
        face = int_at(rays.rows, row)
        f = face_at(rays, face)
        point = _place_at_centre(rays, f, point_in(memory.ptr, 0, CHUNK_FLOATS))
        tree, local, _opened = open_around(accelerator, point)
        for replicate in range(rays.replicates):
            part = row * wp.int64(rays.replicates) + wp.int64(replicate)
            id = (rays.first_face + wp.uint64(face)) * wp.uint64(rays.replicates) + wp.uint64(replicate)
            point.key = point_key(rays.seed, id)
            cast_replicate(rays, tree, local, point, f, part * wp.int64(rays.per_replicate))

    return cast
