"""Rays of faces: place and direction from one lattice, traced, and one number kept of each: what it met."""

from fractions import Fraction

import warp as wp

from warpsample.directions.variates import LANES
from warpsample.distributions.cosine_hemisphere import square_to_cosine_hemisphere
from warpsample.estimate.skipping.frontier import HORIZON_MARGIN, NEAR, NEAR_EDGE, frontier
from warpsample.host.locks import once
from warpsample.maths.frames import frame_about, to_world
from warpsample.maths.numerics import uniform_from_bits, weyl
from warpsample.sequences.hashing import point_key
from warpsample.tracing.facets import in_double, vector_at
from warpsample.tracing.placement import lift_within
from warpsample.tracing.wide.layout import (
    CHUNK,
    CHUNK_FLOATS,
    DIRECTION,
    ORIGIN,
    SCRATCH,
    START_FLOATS,
    WIDTH,
    Accelerator,
)
from warpsample.tracing.wide.prepare import prepare_wide, ray_in
from warpsample.tracing.wide.query import nearest_of, wide_query

SKY, GROUND, BACK = -1, -2, -3
"""What is kept of a ray that meets nothing, above or below the horizon; a face met from behind is BACK - its number, one met
from the front its number."""

# 2^64 / g, / g^2, / g^3 for the root g of g^4 = g + 1, rounded to odd: the steps along a face and in azimuth.
_STEP_A = wp.constant(wp.uint64(0xD1B54A32D192ED03))
_STEP_B = wp.constant(wp.uint64(0xABC98388FB8FAC03))
_STEP_TURN = wp.constant(wp.uint64(0x8CB92BA72F3D8DD7))
_SKY = wp.constant(wp.int32(SKY))
_GROUND = wp.constant(wp.int32(GROUND))
_BACK = wp.constant(wp.int32(BACK))
_BIT = wp.constant(wp.uint32(1))
_CELL = wp.constant(wp.float64(2.0**-31))
_ZERO = wp.constant(wp.float64(0.0))
_HALF = wp.constant(wp.float64(0.5))
_THREE = wp.constant(wp.float64(3.0))
_FACES = wp.constant(wp.uint64(9 * WIDTH * 4))
_ONE = wp.constant(wp.float64(1.0))
_INWARDS = wp.constant(wp.float64(4.0))
_ROUNDINGS = wp.constant(wp.float64(2.0**-22))
_REACH = wp.constant(wp.float32(2.0**60))  # of the scene's size
_query = wide_query(False, several=True)


@wp.struct
class FaceRays:
    """Scalars and addresses of the rays of some faces of a scene.

    rows: (B,) int32, the faces. codes: (B, replicates, each) int32, what their rays met, see SKY.
    vertices, triangles: (V, 3) float32 and (F, 3) int32 of the scene; normals: (F, 3) float32, unit.
    step: 2^64 / each, along which sin^2 theta goes. first_face: the global number of face 0.
    extent, coarseness: of the scene, by which points are moved off their face. up: the sky's axis.
    """

    rows: wp.uint64
    codes: wp.uint64
    vertices: wp.uint64
    triangles: wp.uint64
    normals: wp.uint64
    seed: wp.uint64
    first_face: wp.uint64
    replicates: wp.int32
    each: wp.int32
    step: wp.uint64
    extent_x: wp.float32
    extent_y: wp.float32
    extent_z: wp.float32
    coarseness: wp.float32
    up_x: wp.float32
    up_y: wp.float32
    up_z: wp.float32


FaceRaysArgs = type(FaceRays().__ctype__())


def step_of(each: int) -> int:
    """2^64 / each, rounded."""
    return round(Fraction(1 << 64, each)) if each > 1 else 0


@wp.struct
class Face:
    """A face as its rays see it: a corner, two sides from there, its normal, and how far points are moved off it.

    inner_a, inner_b, inner_c: least weights of the corners.
    """

    a: wp.vec3d
    b: wp.vec3d
    c: wp.vec3d
    n: wp.vec3
    lift: wp.float64
    inner_a: wp.float64
    inner_b: wp.float64
    inner_c: wp.float64


@wp.struct
class Task:
    """Memory to work in: a chunk of rays, the nodes and triangles that they start from, waiting nodes; and their codes."""

    chunk: wp.uint64
    room: wp.uint64
    scratch: wp.uint64
    codes: wp.uint64


@wp.func
def face_at(rays: FaceRays, face: wp.int32) -> Face:
    """A face, with the least weights of its corners that keep points as far from its sides as rays from there need.

    What is nearer to a side than four lifts and eight roundings could be behind the face that meets it there, and see out of
    a closed room, if the two are at an angle of 14 degrees or more. It is moved inwards to there: a share of the square of
    that over the face's size, so nothing is lost. Not further than half of the face.
    """
    corners = wp.array(ptr=rays.triangles + wp.uint64(face) * wp.uint64(12), shape=(1,), dtype=wp.vec3i)[0]
    f = Face()
    f.a = in_double(vector_at(rays.vertices, wp.int64(corners[0])))
    f.b = in_double(vector_at(rays.vertices, wp.int64(corners[1]))) - f.a
    f.c = in_double(vector_at(rays.vertices, wp.int64(corners[2]))) - f.a
    f.n = vector_at(rays.normals, wp.int64(face))
    extent = wp.vec3(rays.extent_x, rays.extent_y, rays.extent_z)
    f.lift = wp.float64(lift_within(extent, rays.coarseness, f.n))
    inwards = _INWARDS * f.lift + _ROUNDINGS * wp.float64(extent[0] + extent[1] + extent[2])
    area = wp.length(wp.cross(f.b, f.c))
    share = inwards / wp.max(area, wp.float64(1e-300))
    f.inner_a = share * wp.length(f.c - f.b)
    f.inner_b = share * wp.length(f.c)
    f.inner_c = share * wp.length(f.b)
    too_much = wp.max(_ONE, (f.inner_a + f.inner_b + f.inner_c) / _HALF)
    f.inner_a = f.inner_a / too_much
    f.inner_b = f.inner_b / too_much
    f.inner_c = f.inner_c / too_much
    return f


@wp.func
def _uniform(bits: wp.uint32) -> wp.float64:
    """In (0, 1), by 31 bits: a signed integer becomes a float in one instruction."""
    return (wp.float64(wp.int32(bits >> _BIT)) + _HALF) * _CELL


@wp.func
def direction_of(frame: wp.mat33, key: wp.vec4ui, step: wp.uint64, i: wp.uint32) -> wp.vec3:
    """The direction of a replicate's i-th ray."""
    radius = weyl(i, step) + wp.uint32(step >> wp.uint64(33)) + key[0]
    turn = weyl(i, _STEP_TURN) + key[1]
    return to_world(frame, square_to_cosine_hemisphere(wp.vec2(uniform_from_bits(radius), uniform_from_bits(turn))))


@wp.func
def start_of(f: Face, key: wp.vec4ui, i: wp.uint32) -> wp.vec3:
    """Where a replicate's i-th ray starts: a uniform point of the face (Turk1990, method 2), moved off it."""
    root = wp.sqrt(_uniform(weyl(i, _STEP_A) + key[2]))
    split = _uniform(weyl(i, _STEP_B) + key[3])
    b = wp.max(root * (_ONE - split) - f.inner_b, _ZERO)
    c = wp.max(root * split - f.inner_c, _ZERO)
    room = _ONE - (f.inner_a + f.inner_b + f.inner_c)
    less = wp.min(_ONE, room / wp.max(b + c, _CELL))
    b = f.inner_b + less * b
    c = f.inner_c + less * c
    return wp.vec3(
        wp.float32(f.a[0] + b * f.b[0] + c * f.c[0] + f.lift * wp.float64(f.n[0])),
        wp.float32(f.a[1] + b * f.b[1] + c * f.c[1] + f.lift * wp.float64(f.n[1])),
        wp.float32(f.a[2] + b * f.b[2] + c * f.c[2] + f.lift * wp.float64(f.n[2])),
    )


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
    return wp.where(wp.dot(vector_at(rays.normals, wp.int64(face)), d) < 0.0, face, _BACK - face)


@wp.func
def lowest_start(f: Face) -> wp.float64:
    """How far along the normal the rays of a face start, at least."""
    along = in_double(f.n)
    return wp.dot(along, f.a) + wp.min(wp.min(wp.dot(along, f.b), wp.dot(along, f.c)), _ZERO) + f.lift


@wp.func
def horizon_margin(rays: FaceRays, n: wp.vec3) -> wp.float32:
    """What is as far below a start is below its horizon for sure."""
    return HORIZON_MARGIN * (wp.abs(n[0]) * rays.extent_x + wp.abs(n[1]) * rays.extent_y + wp.abs(n[2]) * rays.extent_z)


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
        edge = wp.array(ptr=room + NEAR_EDGE, shape=(1,), dtype=wp.float32)
        met, triangle = nearest_of(room + NEAR, near, ray_in(column), column, reach, edge[0])
        if triangle >= 0:
            reach = met
            face = wp.array(ptr=room + NEAR + _FACES, shape=(WIDTH,), dtype=wp.int32)[triangle]
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
        face = wp.array(ptr=rays.rows + wp.uint64(row) * wp.uint64(4), shape=(1,), dtype=wp.int32)[0]
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
