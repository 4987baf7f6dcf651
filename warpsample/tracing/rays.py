"""Kernels that trace a caller's rays: conversion to normalised float32 coordinates, and of hits to the user's units."""

import warp as wp

from warpsample.host.device_memory import at_home
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.maths.memory import float_at, set_float, set_int, vec3_at
from warpsample.maths.numerics import ZERO, direction_to_unit
from warpsample.tracing.order import visiting_order
from warpsample.tracing.placement import (
    Placement,
    distance_to_scene,
    is_far_off,
    local_origin,
    origin_offset,
    point_of,
    unit_in_double,
    vector_in_double,
)
from warpsample.tracing.queries import (
    AHEAD,
    CHUNK,
    CHUNK_FLOATS,
    DIRECTION,
    REACH,
    Accelerator,
    AcceleratorArgs,
    Glass,
    set_direction,
    set_origin,
)
from warpsample.tracing.scene import Scene
from warpsample.tracing.tracers import Tracer
from warpsample.tracing.wide.layout import SCRATCH
from warpsample.tracing.wide.prepare import prepare_wide, ray_in
from warpsample.tracing.wide.query import wide_query
from warpsample.tracing.wide.through import path_transmittance

RAY_WORK = 64
"""Cost of tracing a ray, in sampled directions."""


@wp.struct
class Rays:
    """Kernel argument that describes `count` rays from each point: origins, directions (P, count, 3), and results.

    Addresses of optional arrays are 0 where the array is missing.

    Attributes:
        placement: origins of the rays.
        count: number of rays per point.
        per_task: number of consecutive rays in a task, at most CHUNK.
        double_directions: 1 for float64 directions, 0 for float32.
        directions: address of the directions.
        distance: address of (P, count) float32 distances.
        face: address of (P, count) int32 faces.
        visits: optional address of (P, count, 2) int32, numbers of nodes and leaves visited.
        first: optional address of (P, count) int64, index in distance and face of each ray's first hit.
        transmitted: optional address of (P, count) float32, transmittance of the faces of `glass` along each ray.
        glass: translucent faces.
    """

    placement: Placement
    count: wp.int64
    per_task: wp.int64
    double_directions: wp.int32
    directions: wp.uint64
    distance: wp.uint64
    face: wp.uint64
    visits: wp.uint64
    first: wp.uint64
    transmitted: wp.uint64
    glass: Glass


RaysArgs = type(Rays().__ctype__())


@wp.func
def _direction(rays: Rays, ray: wp.int64) -> wp.vec3:
    """Return the direction of a ray in float32; float64 directions are scaled to unit length first."""
    if rays.double_directions == 0:
        return vec3_at(rays.directions, ray)
    return wp.vec3(unit_in_double(vector_in_double(rays.directions, 1, ray), 1))


@wp.func
def _load_ray(rays: Rays, point: wp.int64, o: wp.vec3d, ray: wp.int64, column: wp.uint64):
    """Write the start, direction and reach of a ray with origin o to the ray's column in a buffer of rays."""
    d = _direction(rays, ray)
    ahead = ZERO
    if is_far_off(o):
        unit = unit_in_double(vector_in_double(rays.directions, rays.double_directions, ray), rays.double_directions)
        ahead = distance_to_scene(o, unit)
        o = wp.where(ahead < ZERO, o - o, o + ahead * unit)  # for a ray that misses: 0, or NaN if not finite
    start = wp.vec3(o)
    if rays.placement.normals != wp.uint64(0) and ahead == ZERO:
        n = vec3_at(rays.placement.normals, point)
        forward = wp.dot(n, d)
        if rays.placement.starts == wp.uint64(0):
            start += wp.copysign(origin_offset(rays.placement, n), forward) * n
        else:
            start = vec3_at(rays.placement.starts, wp.int64(2) * point + wp.where(forward < 0.0, wp.int64(1), wp.int64(0)))
    set_origin(column, 0, start)
    set_direction(column, 0, d)
    set_float(column, REACH, wp.where(ahead < ZERO, -1.0, wp.float32(rays.placement.reach - ahead)))
    set_float(column, AHEAD, wp.float32(ahead))


@wp.func
def _normalize(chunk: wp.uint64, length: wp.int64):
    """Scale the directions of the rays in a buffer to unit length, and mark invalid rays by a reach of NaN."""
    rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < wp.int32(length):
        unit = direction_to_unit(wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k]))
        rays[DIRECTION + k] = unit[0]
        rays[DIRECTION + CHUNK + k] = unit[1]
        rays[DIRECTION + 2 * CHUNK + k] = unit[2]
        # x - x is 0, or NaN where x is not finite.
        nothing = (rays[k] - rays[k]) + (rays[CHUNK + k] - rays[CHUNK + k]) + (rays[2 * CHUNK + k] - rays[2 * CHUNK + k])
        valid = wp.where(wp.abs(unit[3]) < 0.1, 1, 0) * wp.where(nothing == 0.0, 1, 0)
        rays[REACH + k] = wp.where(valid != 0, rays[REACH + k], wp.float32(wp.NAN))
        k += 1


@wp.func
def user_distance(rays: Rays, column: wp.uint64, near: wp.float32) -> wp.float32:
    """Convert the distance of a ray's hit from normalised units to the user's units."""
    return wp.float32((wp.float64(near) + wp.float64(float_at(column, AHEAD))) * rays.placement.unit)


@once
def build_hit_writer(query: wp.Function) -> wp.Function:
    """Build a Warp function that traces a prepared ray and writes its hit.

    Its arguments are (rays, accelerator, column, ray, scratch).

    Args:
        query: `face_query` of a `Tracer` with any_hit applied.
    """

    @wp.func
    def write_hit(rays: Rays, accelerator: Accelerator, column: wp.uint64, ray: wp.int64, scratch: wp.uint64):
        distance = wp.float32(wp.INF)
        face = wp.int32(-1)
        reach = float_at(column, REACH)
        if reach > 0.0:
            near, face, nodes, leaves = query(accelerator, column, reach, scratch)
            distance = user_distance(rays, column, near)
            if rays.visits != wp.uint64(0):
                set_int(rays.visits, wp.int64(2) * ray, nodes)
                set_int(rays.visits, wp.int64(2) * ray + wp.int64(1), leaves)
        elif not (reach <= 0.0):
            distance = wp.float32(wp.NAN)
        set_float(rays.distance, ray, distance)
        set_int(rays.face, ray, face)

    return write_hit


@once
def build_glass_hit_writer(any_hit: bool) -> wp.Function:
    """Build a Warp function that traces a prepared ray and writes its hit and the transmittance up to the hit.

    The arguments are those of `build_hit_writer`; translucent faces attenuate the ray. The hits are those of the opaque
    faces. With any_hit the transmittance is 0 where there is a hit.
    """
    query = wide_query(any_hit)

    @wp.func
    def write_hit(rays: Rays, accelerator: Accelerator, column: wp.uint64, ray: wp.int64, scratch: wp.uint64):
        distance = wp.float32(wp.INF)
        face = wp.int32(-1)
        share = wp.float32(1.0)
        reach = float_at(column, REACH)
        if reach > 0.0:
            near, face, _nodes, _leaves = query(accelerator, column, reach, scratch)
            distance = user_distance(rays, column, near)
            if wp.static(any_hit) and face >= 0:
                share = 0.0
            else:
                share = path_transmittance(rays.glass, ray_in(column), wp.min(reach, near), scratch)
        elif not (reach <= 0.0):
            distance = wp.float32(wp.NAN)
            share = wp.float32(wp.NAN)
        set_float(rays.distance, ray, distance)
        set_int(rays.face, ray, face)
        set_float(rays.transmitted, ray, share)

    return write_hit


@once
def ray_kernel(prepare: wp.Function, answer: wp.Function, size: int = CHUNK_FLOATS) -> wp.Kernel:
    """Build a kernel that prepares and traces a caller's rays, with several consecutive rays per task.

    Args:
        prepare: `prepare` of a `Tracer`.
        answer: function (rays, accelerator, column, ray, scratch) that writes the result of a ray; see `build_hit_writer`.
        size: number of float32 in a chunk.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def each_ray(rays: Rays, accelerator: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        floats = wp.zeros(shape=(size,), dtype=wp.float32)
        first = (first_task + wp.int64(wp.tid())) * rays.per_task
        length = wp.int32(wp.min(rays.per_task, rays.placement.points * rays.count - first))
        row = first / rays.count
        j = first - row * rays.count
        point = point_of(rays.placement, row)
        o = local_origin(rays.placement, point)
        for k in range(length):
            if j == wp.int64(0):
                point = point_of(rays.placement, row)
                o = local_origin(rays.placement, point)
            _load_ray(rays, point, o, point * rays.count + j, floats.ptr + wp.uint64(4 * k))
            j += wp.int64(1)
            if j == rays.count:
                j = wp.int64(0)
                row += wp.int64(1)
        _normalize(floats.ptr, rays.per_task)
        prepare(floats.ptr, CHUNK)
        row = first / rays.count
        j = first - row * rays.count
        for k in range(length):
            ray = point_of(rays.placement, row) * rays.count + j
            j += wp.int64(1)
            if j == rays.count:
                j = wp.int64(0)
                row += wp.int64(1)
            answer(rays, accelerator, floats.ptr + wp.uint64(4 * k), ray, words.ptr)

    return each_ray


def trace_rays(scene: Scene, rays: RaysArgs, *, tracer: Tracer, any_hit: bool, device: wp.Device, workers: int) -> None:
    """Trace a caller's rays against a mesh and write their hits to the arrays that `rays` refers to.

    It counts visits if `rays.visits` is set. If `rays.transmitted` is set, which only the wide tree supports, hits are those
    of opaque faces.
    """
    order = visiting_order(scene, rays.placement, rays.count, workers) if at_home(device) else None
    rays.placement.order = 0 if order is None else order.ctypes.data
    if rays.transmitted:
        kernel = ray_kernel(prepare_wide, build_glass_hit_writer(any_hit))
        rays.glass = scene.glass(workers)
    else:
        kernel = ray_kernel(tracer.prepare, build_hit_writer(tracer.face_query(any_hit)), tracer.floats)
    launch_rays(kernel, tracer.accelerator(scene, device, workers), rays, device, workers)


def launch_rays(kernel: wp.Kernel, accelerator: AcceleratorArgs, rays: RaysArgs, device: wp.Device, workers: int) -> None:
    """Launch a kernel built by `ray_kernel` on all rays of a caller."""
    total = rays.placement.points * rays.count
    rays.per_task = CHUNK if at_home(device) else 1  # on CUDA neighbouring threads then trace neighbouring rays
    run(kernel, -(-total // rays.per_task), [rays, accelerator], device, workers=workers, work=RAY_WORK * total)
