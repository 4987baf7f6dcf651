"""The kernel that casts the rays of faces: each starts from what stands above its face, and one number of it is kept."""

import warp as wp

from warpsample.directions.variates import LANES
from warpsample.estimate.skipping.frontier import NEAR, NEAR_EDGE, frontier
from warpsample.host.locks import once
from warpsample.maths.frames import frame_about
from warpsample.maths.memory import float_at, int_at, vec3_at
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
from warpsample.tracing.placement import in_double
from warpsample.tracing.wide.layout import (
    CHUNK,
    CHUNK_FLOATS,
    DIRECTION,
    ORIGIN,
    SCRATCH,
    START_FLOATS,
    Accelerator,
    face_in,
)
from warpsample.tracing.wide.prepare import prepare_wide, ray_in
from warpsample.tracing.wide.query import nearest_of, wide_query

_SKY = wp.constant(wp.int32(SKY))
_GROUND = wp.constant(wp.int32(GROUND))
_BACK = wp.constant(wp.int32(BACK))
_THREE = wp.constant(wp.float64(3.0))
_REACH = wp.constant(wp.float32(2.0**60))  # of the scene's size
_query = wide_query(False, several=True)


@wp.struct
class Task:
    """Memory to work in: a chunk of rays, the nodes and triangles that they start from, waiting nodes; and their codes."""

    chunk: wp.uint64
    room: wp.uint64
    scratch: wp.uint64
    codes: wp.uint64


@wp.func
def _fill(f: Face, key: wp.vec4ui, step: wp.uint64, first: wp.int32, length: wp.int32, chunk: wp.uint64):
    """Starts and directions of consecutive rays of a replicate; two loops, which vectorise better than one."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    frame = frame_about(f.n)
    k = wp.int32(0)
    while k < length:
        d = direction_of(frame, key, step, wp.uint32(first + k))
        rows[DIRECTION + k] = d[0]
        rows[DIRECTION + CHUNK + k] = d[1]
        rows[DIRECTION + 2 * CHUNK + k] = d[2]
        k += 1
    k = wp.int32(0)
    while k < length:
        o = start_of(f, key, wp.uint32(first + k))
        rows[ORIGIN + k] = o[0]
        rows[ORIGIN + CHUNK + k] = o[1]
        rows[ORIGIN + 2 * CHUNK + k] = o[2]
        k += 1


@wp.func
def _code(rays: FaceRays, face: wp.int32, d: wp.vec3) -> wp.int32:
    """What is kept of a ray that meets a face, or none."""
    if face < 0:
        return wp.where(wp.dot(wp.vec3(rays.up_x, rays.up_y, rays.up_z), d) < 0.0, _GROUND, _SKY)
    return wp.where(wp.dot(vec3_at(rays.normals, face), d) < 0.0, face, _BACK - face)


@wp.func
def _opened(rays: FaceRays, tree: Accelerator, f: Face, room: wp.uint64, scratch: wp.uint64):
    """(the tree without what is around the face or below its horizon, mask of the triangles around it that rise above).

    As all rays of the face start in one plane, what its middle sees as below the horizon is so from everywhere.
    """
    middle = f.a + (f.b + f.c) / _THREE + f.lift * in_double(f.n)
    o = wp.vec3(middle)
    low = horizon_margin(rays, f.n) + wp.max(wp.float32(wp.dot(in_double(f.n), middle) - lowest_start(f)), 0.0)
    starts, around = frontier(tree, o, f.n, low, _REACH, room, scratch)
    near = wp.int32(0)
    if starts >= 0:
        near = (1 << around) - 1
        tree.start = room
        tree.starts = starts
    return tree, near


@wp.func
def _nearest(tree: Accelerator, near: wp.int32, room: wp.uint64, column: wp.uint64, scratch: wp.uint64) -> wp.int32:
    """The face that a ray meets first; -1 if there is none."""
    reach = _REACH
    face = wp.int32(-1)
    if near != 0:
        edge = float_at(room + NEAR_EDGE, 0)
        met, triangle = nearest_of(room + NEAR, near, ray_in(column), reach, edge)
        if triangle >= 0:
            reach = met
            face = face_in(room + NEAR, triangle)
    if tree.starts > 0:
        _distance, other, _nodes, _leaves = _query(tree, column, reach, scratch)
        face = wp.where(other >= 0, other, face)
    return face


@wp.func
def _cast(rays: FaceRays, tree: Accelerator, near: wp.int32, task: Task, f: Face, key: wp.vec4ui):
    """Casts a replicate's rays, a chunk at a time."""
    codes = wp.array(ptr=task.codes, shape=(rays.each,), dtype=wp.int32)
    for first in range(0, rays.each, CHUNK):
        length = wp.min(CHUNK, rays.each - first)
        padded = (length + LANES - 1) / LANES * LANES
        _fill(f, key, rays.step, first, padded, task.chunk)
        prepare_wide(task.chunk, padded)
        for k in range(length):
            column = task.chunk + wp.uint64(4 * k)
            rows = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
            met = _nearest(tree, near, task.room, column, task.scratch)
            codes[first + k] = _code(
                rays, met, wp.vec3(rows[DIRECTION], rows[DIRECTION + CHUNK], rows[DIRECTION + 2 * CHUNK])
            )


@once
def face_kernel() -> wp.Kernel:
    """A kernel with a task for each face."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def cast(rays: FaceRays, accelerator: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        floats = wp.zeros(shape=(CHUNK_FLOATS,), dtype=wp.float32)
        room = wp.zeros(shape=(START_FLOATS,), dtype=wp.float32)
        row = first_task + wp.int64(wp.tid())
        face = int_at(rays.rows, row)
        f = face_at(rays, face)
        tree, near = _opened(rays, accelerator, f, room.ptr, words.ptr)
        task = Task()
        task.chunk = floats.ptr
        task.room = room.ptr
        task.scratch = words.ptr
        for replicate in range(rays.replicates):
            part = wp.uint64(row) * wp.uint64(rays.replicates) + wp.uint64(replicate)
            task.codes = rays.codes + part * wp.uint64(rays.each) * wp.uint64(4)
            id = (rays.first_face + wp.uint64(face)) * wp.uint64(rays.replicates) + wp.uint64(replicate)
            _cast(rays, tree, near, task, f, point_key(rays.seed, id))

    return cast
