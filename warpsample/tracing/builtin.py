"""Queries of wp.Mesh, which is the tracer on CUDA and a second, independent tracer on the CPU."""

import warp as wp

from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, Accelerator


@wp.func
def prepare_builtin(chunk: wp.uint64, length: wp.int32):
    """Nothing to prepare."""


@wp.func
def _vector(rows: wp.array[wp.float32], i: wp.int32) -> wp.vec3:
    return wp.vec3(rows[i], rows[i + CHUNK], rows[i + 2 * CHUNK])


@wp.func
def builtin_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
    """The query of `wp.Mesh`, always for the nearest hit, since its any-hit query tells no face; visits are not known: 0."""
    rows = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    query = wp.mesh_query_ray(accelerator.mesh, _vector(rows, ORIGIN), _vector(rows, DIRECTION), reach)
    face = wp.int32(-1)
    distance = wp.float32(wp.INF)
    if query.result and query.t < reach:
        face = query.face
        distance = query.t
    return distance, face, 0, 0


@wp.func
def builtin_any_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
    """Whether anything is met: distance 0 and face 0 if so, inf and -1 if not; the built-in query tells no more."""
    rows = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    face = wp.int32(-1)
    distance = wp.float32(wp.INF)
    if wp.mesh_query_ray_anyhit(accelerator.mesh, _vector(rows, ORIGIN), _vector(rows, DIRECTION), reach):
        face = 0
        distance = 0.0
    return distance, face, 0, 0
