"""Queries of wp.Mesh, which is the tracer on CUDA and a second, independent tracer on the CPU."""

import warp as wp

from warpsample.tracing.queries import DIRECTION, ORIGIN, Accelerator, vector_in


@wp.func
def prepare_builtin(chunk: wp.uint64, length: wp.int32):
    """Nothing to prepare."""


@wp.func
def builtin_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
    """The query of `wp.Mesh`, always for the nearest hit, since its any-hit query tells no face; visits are not known: 0."""
    query = wp.mesh_query_ray(accelerator.mesh, vector_in(column, ORIGIN), vector_in(column, DIRECTION), reach)
    face = wp.int32(-1)
    distance = wp.float32(wp.INF)
    if query.result and query.t < reach:
        face = query.face
        distance = query.t
    return distance, face, 0, 0


@wp.func
def builtin_any_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):
    """Whether anything is met: distance 0 and face 0 if so, inf and -1 if not; the built-in query tells no more."""
    face = wp.int32(-1)
    distance = wp.float32(wp.INF)
    if wp.mesh_query_ray_anyhit(accelerator.mesh, vector_in(column, ORIGIN), vector_in(column, DIRECTION), reach):
        face = 0
        distance = 0.0
    return distance, face, 0, 0
