"""A user's rays, brought into the scene's own float32 coordinates one by one, asked, and answered in the user's."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import scaled_to_unit
from warpsample.tracing.wide.layout import AHEAD, CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, REACH, SCRATCH, Accelerator

FURTHEST = 6.0
"""From 0 on an axis; origins beyond come nearer first, in float64, so that float32 resolves the mesh."""

LIFT = 2.0**-19
"""Of how far a mesh reaches along a normal: so far are points moved off their face along it, which is 32 roundings."""

_LIFT = wp.constant(wp.float32(LIFT))
_FURTHEST = wp.constant(wp.float64(FURTHEST))
_ENTRY = wp.constant(wp.float64(1.25))
_ZERO = wp.constant(wp.float64(0.0))
_ONE = wp.constant(wp.float64(1.0))
_LEAST_STEP = wp.constant(wp.float64(1e-150))
_FLOATS = wp.constant(wp.uint64(12))
_DOUBLES = wp.constant(wp.uint64(24))


@wp.struct
class RayJob:
    """Scalars and addresses of `points` origins with `count` directions each, float32, or float64 where it says so.

    A task is `block` rays, at most CHUNK. A point x of the user's is (x - centre) * scale inside, where the mesh is within 1
    of 0 on each axis, and its extent; a distance t inside is t * unit. Optional, else 0: normals (P, 3) float32, unit, of
    the faces that origins are on; starts (P, 2, 3) float32, where rays to either side of these start, inside, else they are
    moved by `lift`; order (P,) int64, that of the visits; visits (P, count, 2) int32, nodes and leaves.
    """

    points: wp.int64
    count: wp.int64
    block: wp.int64
    double_origins: wp.int32
    double_directions: wp.int32
    origins: wp.uint64
    directions: wp.uint64
    normals: wp.uint64
    starts: wp.uint64
    order: wp.uint64
    centre_x: wp.float64
    centre_y: wp.float64
    centre_z: wp.float64
    scale: wp.float64
    unit: wp.float64
    reach: wp.float64
    extent_x: wp.float32
    extent_y: wp.float32
    extent_z: wp.float32
    coarseness: wp.float32
    distance: wp.uint64
    face: wp.uint64
    visits: wp.uint64


Job = type(RayJob().__ctype__())


@wp.func
def _vector(address: wp.uint64, double: wp.int32, i: wp.int64) -> wp.vec3d:
    if double != 0:
        doubles = wp.array(ptr=address + wp.uint64(i) * _DOUBLES, shape=(1,), dtype=wp.vec3d)
        return doubles[0]
    floats = wp.array(ptr=address + wp.uint64(i) * _FLOATS, shape=(1,), dtype=wp.vec3)
    v = floats[0]
    return wp.vec3d(wp.float64(v[0]), wp.float64(v[1]), wp.float64(v[2]))


@wp.func
def _unit(d: wp.vec3d, double: wp.int32) -> wp.vec3d:
    """d / abs(d); NaN where d is zero or not finite."""
    if double != 0:  # whose squares may over- or underflow
        d = d / wp.max(wp.max(wp.abs(d[0]), wp.abs(d[1])), wp.abs(d[2]))
    return (_ONE / wp.sqrt(wp.dot(d, d))) * d


@wp.func
def point_of(job: RayJob, i: wp.int64) -> wp.int64:
    """The point that is the i-th to be visited."""
    if job.order == wp.uint64(0):
        return i
    order = wp.array(ptr=job.order + wp.uint64(i) * wp.uint64(8), shape=(1,), dtype=wp.int64)
    return order[0]


@wp.func
def local_origin(job: RayJob, point: wp.int64) -> wp.vec3d:
    """In the scene's coordinates: what large ones have in common goes in float64, before they are rounded."""
    return (_vector(job.origins, job.double_origins, point) - wp.vec3d(job.centre_x, job.centre_y, job.centre_z)) * job.scale


@wp.func
def _direction(job: RayJob, ray: wp.int64) -> wp.vec3:
    """float32's as it is, float64's brought to unit length."""
    if job.double_directions == 0:
        floats = wp.array(ptr=job.directions + wp.uint64(ray) * _FLOATS, shape=(1,), dtype=wp.vec3)
        return floats[0]
    return wp.vec3(_unit(_vector(job.directions, 1, ray), 1))


@wp.func
def extent_along(job: RayJob, n: wp.vec3) -> wp.float32:
    """How far the mesh reaches along a normal, at most: what is rounded along it is rounded by 2^-24 of this."""
    return wp.abs(n[0]) * job.extent_x + wp.abs(n[1]) * job.extent_y + wp.abs(n[2]) * job.extent_z


@wp.func
def reach_along(job: RayJob, n: wp.vec3, o: wp.vec3) -> wp.float32:
    """The same of the mesh and a point that may be outside of it."""
    x = wp.abs(n[0]) * wp.max(job.extent_x, wp.abs(o[0]))
    y = wp.abs(n[1]) * wp.max(job.extent_y, wp.abs(o[1]))
    return x + y + wp.abs(n[2]) * wp.max(job.extent_z, wp.abs(o[2]))


@wp.func
def lift(job: RayJob, n: wp.vec3) -> wp.float32:
    """How far points of a face with that normal are moved off it: 32 roundings, and more where they are stored coarsely."""
    return _LIFT * extent_along(job, n) + job.coarseness


@wp.func
def far_off(o: wp.vec3d) -> wp.bool:
    """Whether an origin is so far from the mesh that its rays are to be brought near."""
    return wp.max(wp.max(wp.abs(o[0]), wp.abs(o[1])), wp.abs(o[2])) > _FURTHEST


@wp.func
def way_to_scene(o: wp.vec3d, d: wp.vec3d) -> wp.float64:
    """How far a ray that starts outside is from a cube around the scene; negative where it misses that.

    Or comes from so far away that float64 does not tell.
    """
    enter = _ZERO
    leave = wp.float64(wp.INF)
    for axis in range(3):
        inverse = _ONE / wp.where(wp.abs(d[axis]) > _LEAST_STEP, d[axis], wp.copysign(_LEAST_STEP, d[axis]))
        middle = -o[axis] * inverse
        half = wp.abs(_ENTRY * inverse)
        enter = wp.max(enter, middle - half)
        leave = wp.min(leave, middle + half)
    return wp.where(enter < leave and not far_off(o + enter * d), enter, -_ONE)


@wp.func
def _read(job: RayJob, point: wp.int64, o: wp.vec3d, ray: wp.int64, column: wp.uint64):
    """A ray from o into its column."""
    d = _direction(job, ray)
    ahead = _ZERO
    if far_off(o):
        unit = _unit(_vector(job.directions, job.double_directions, ray), job.double_directions)
        ahead = way_to_scene(o, unit)
        o = wp.where(ahead < _ZERO, o - o, o + ahead * unit)  # of a ray that misses: 0, and NaN where that is not finite
    start = wp.vec3(o)
    if job.normals != wp.uint64(0) and ahead == _ZERO:
        n = wp.array(ptr=job.normals + wp.uint64(point) * _FLOATS, shape=(1,), dtype=wp.vec3)[0]
        forward = wp.dot(n, d)
        if job.starts == wp.uint64(0):
            start += wp.copysign(lift(job, n), forward) * n
        else:
            start = wp.array(ptr=job.starts + wp.uint64(point) * _DOUBLES, shape=(2,), dtype=wp.vec3)[
                wp.where(forward < 0.0, 1, 0)
            ]
    rows = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    rows[ORIGIN] = start[0]
    rows[ORIGIN + CHUNK] = start[1]
    rows[ORIGIN + 2 * CHUNK] = start[2]
    rows[DIRECTION] = d[0]
    rows[DIRECTION + CHUNK] = d[1]
    rows[DIRECTION + 2 * CHUNK] = d[2]
    rows[REACH] = wp.where(ahead < _ZERO, -1.0, wp.float32(job.reach - ahead))
    rows[AHEAD] = wp.float32(ahead)


@wp.func
def _normalize(chunk: wp.uint64):
    """Unit directions; NaN as the reach of what is no ray."""
    rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < CHUNK:
        unit = scaled_to_unit(wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k]))
        rays[DIRECTION + k] = unit[0]
        rays[DIRECTION + CHUNK + k] = unit[1]
        rays[DIRECTION + 2 * CHUNK + k] = unit[2]
        # x - x is 0, or NaN where x is not finite.
        nothing = (rays[k] - rays[k]) + (rays[CHUNK + k] - rays[CHUNK + k]) + (rays[2 * CHUNK + k] - rays[2 * CHUNK + k])
        valid = wp.where(wp.abs(unit[3]) < 0.1, 1, 0) * wp.where(nothing == 0.0, 1, 0)
        rays[REACH + k] = wp.where(valid != 0, rays[REACH + k], wp.float32(wp.NAN))
        k += 1


@once
def ray_kernel(prepare: wp.Function, query: wp.Function) -> wp.Kernel:
    """A kernel with a task for each block of rays, in the job's order.

    Args:
        prepare: (chunk, rays): adds what the query needs.
        query: (Accelerator, ray, reach, scratch) -> (distance, face, nodes, leaves) of one.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def trace_rays(job: RayJob, accelerator: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        floats = wp.zeros(shape=(CHUNK_FLOATS,), dtype=wp.float32)
        first = (first_task + wp.int64(wp.tid())) * job.block
        length = wp.int32(wp.min(job.block, job.points * job.count - first))
        row = first / job.count
        j = first - row * job.count
        point = point_of(job, row)
        o = local_origin(job, point)
        for k in range(length):
            if j == wp.int64(0):
                point = point_of(job, row)
                o = local_origin(job, point)
            _read(job, point, o, point * job.count + j, floats.ptr + wp.uint64(4 * k))
            j += wp.int64(1)
            if j == job.count:
                j = wp.int64(0)
                row += wp.int64(1)
        _normalize(floats.ptr)
        prepare(floats.ptr, CHUNK)
        row = first / job.count
        j = first - row * job.count
        for k in range(length):
            ray = point_of(job, row) * job.count + j
            j += wp.int64(1)
            if j == job.count:
                j = wp.int64(0)
                row += wp.int64(1)
            distance = wp.float32(wp.INF)
            face = wp.int32(-1)
            column = floats.ptr + wp.uint64(4 * k)
            rows = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
            reach = rows[REACH]
            if reach > 0.0:
                near, face, nodes, leaves = query(accelerator, column, reach, words.ptr)
                distance = wp.float32((wp.float64(near) + wp.float64(rows[AHEAD])) * job.unit)
                if job.visits != wp.uint64(0):
                    visits = wp.array(ptr=job.visits + wp.uint64(ray) * wp.uint64(8), shape=(2,), dtype=wp.int32)
                    visits[0] = nodes
                    visits[1] = leaves
            elif not (reach <= 0.0):
                distance = wp.float32(wp.NAN)
            distances = wp.array(ptr=job.distance + wp.uint64(ray) * wp.uint64(4), shape=(1,), dtype=wp.float32)
            faces = wp.array(ptr=job.face + wp.uint64(ray) * wp.uint64(4), shape=(1,), dtype=wp.int32)
            distances[0] = distance
            faces[0] = face

    return trace_rays
