"""Ray tracing by Warp's own wp.Mesh: the tracer on CUDA, and a second, independent tracer on the CPU."""

import warp as wp

from warpsample.tracing.queries import DIRECTION, ORIGIN, Accelerator, vector_in


@wp.func
def prepare_builtin(chunk: wp.uint64, length: wp.int32):
    """Do nothing: wp.Mesh traces rays without preparation, unlike the 16-wide tree."""


@wp.func
def builtin_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
    """Trace a ray with wp.Mesh and return (distance, face, 0, 0) of the nearest hit; (inf, -1, 0, 0) without one.

    It also serves any-hit queries, since that of wp.Mesh returns no face. The zeros stand for the unknown numbers of visited
    nodes and leaves.
    """
    query = wp.mesh_query_ray(accelerator.mesh, vector_in(column, ORIGIN), vector_in(column, DIRECTION), reach)
    face = wp.int32(-1)
    distance = wp.float32(wp.INF)
    if query.result and query.t < reach:
        face = query.face
        distance = query.t
    return distance, face, 0, 0


@wp.func
def builtin_any_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
    """Trace a ray with wp.Mesh and return (0, 0, 0, 0) if it hits anything, else (inf, -1, 0, 0).

    The query of wp.Mesh provides neither distance nor face.
    """
    face = wp.int32(-1)
    distance = wp.float32(wp.INF)
    if wp.mesh_query_ray_anyhit(accelerator.mesh, vector_in(column, ORIGIN), vector_in(column, DIRECTION), reach):
        face = 0
        distance = 0.0
    return distance, face, 0, 0
