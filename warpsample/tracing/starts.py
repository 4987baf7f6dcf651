"""Where the rays of points on a surface start: a little in front of the face that a point lies on, and of no other's back.

What lies on an edge or a corner sees what points of its own face just beside it see. So of the faces that touch a point,
those that rise above its own are looked at: the start moves towards the middle of its own face, as little as brings it to
that side of them. A face that stands across the point's own, as a wall in the middle of a floor, has the point on its front.
"""

from typing import TYPE_CHECKING

import numpy as np
import warp as wp

from warpsample.arrays import cpu
from warpsample.engine import run
from warpsample.locks import once
from warpsample.numerics import normalize
from warpsample.tracing.beams import corner, size_of
from warpsample.tracing.intersect import greater, lesser, lowest_bit
from warpsample.tracing.layout import LEAF_BYTES, NODE_BYTES, SCRATCH, WIDTH, Accelerator, AcceleratorJob
from warpsample.tracing.rays import LIFT, Job, RayJob, lift, local_origin
from warpsample.tracing.wide import put_aside

if TYPE_CHECKING:
    from warpsample.tracing.scene import Scene

_LIFT = wp.constant(wp.float64(LIFT))
_TWICE = wp.constant(wp.float32(2.0 * LIFT))
_ROUNDING = wp.constant(wp.float32(2.0**-18))
_NODE = wp.constant(wp.uint64(NODE_BYTES))
_LEAF = wp.constant(wp.uint64(LEAF_BYTES))
_PLACES = wp.constant(wp.uint64(6 * WIDTH * 4))
_FACES = wp.constant(wp.uint64(9 * WIDTH * 4))
_WAITING = wp.constant(wp.uint64(4 * 4))
_NODE_FLOATS = NODE_BYTES // 4
_LEAF_FLOATS = LEAF_BYTES // 4
_THIRD = wp.constant(wp.float64(1.0 / 3.0))
_HALF = wp.constant(wp.float64(0.5))
_TENTH = wp.constant(wp.float64(0.1))
_ZERO = wp.constant(wp.float64(0.0))
_ONE = wp.constant(wp.float64(1.0))
_SAME = wp.constant(wp.float64(1.0 - 2.0**-20))  # cosine of two normals that are one, rounded to float32
_TWO = wp.constant(wp.float64(2.0))
_THIN = wp.constant(wp.int32(-2))  # the face of a point that lies on none but those without a normal
_NOWHERE = wp.constant(wp.vec3d(0.0, 0.0, 0.0))


@wp.struct
class StartJob:
    """Scalars and addresses.

    rays: of the points: their places, and in `normals` the unit normals of their faces, their own where they lie on none.
    towards: (P, 3) float32, directions to the side of the face from which a point looks; 0: both sides, `normals` first.
    face: (P,) int32, -1 where it is not known.
    vertices, triangles: (V, 3) float32 and (F, 3) int32 of the scene.
    starts: (P, sides, 3) float32, where they start; in the scene's coordinates.
    sides: 1 or 2.
    """

    rays: RayJob
    towards: wp.uint64
    face: wp.uint64
    vertices: wp.uint64
    triangles: wp.uint64
    spread_x: wp.float32
    spread_y: wp.float32
    spread_z: wp.float32
    starts: wp.uint64
    sides: wp.int32


_Job = type(StartJob().__ctype__())


@wp.struct
class Facet:
    """A face: its corners, unit normal (0 if it is too thin to have one) and twice its area.

    lift: how far points of it are moved off it. slack: how far beside it they may be, since its corners are rounded.
    """

    a: wp.vec3d
    b: wp.vec3d
    c: wp.vec3d
    n: wp.vec3d
    area: wp.float64
    lift: wp.float64
    slack: wp.float64


@wp.struct
class Seat:
    """Where a point sits.

    p: its place. own: its face, below 0 if none is known. facet: that. side: 1 where it looks from the front, else -1.
    o: a lift above its face. moved: how far from p. inwards: how far the start
    moves towards the middle of the face, as a share. aside: off faces across it. In search of a face: of those whose normals
    are along the direction in which the point looks, the one with the greatest cosine; of those against it, likewise; and of
    all, the sum of cosines times areas.
    """

    p: wp.vec3d
    own: wp.int32
    facet: Facet
    side: wp.float64
    o: wp.vec3d
    moved: wp.float64
    inwards: wp.float64
    aside: wp.vec3d
    along: wp.int32
    best_along: wp.float64
    against: wp.int32
    best_against: wp.float64
    ahead: wp.float64


@wp.func
def _vector(address: wp.uint64, i: wp.int64) -> wp.vec3:
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(12), shape=(1,), dtype=wp.vec3)[0]


@wp.func
def _double(v: wp.vec3) -> wp.vec3d:
    return wp.vec3d(wp.float64(v[0]), wp.float64(v[1]), wp.float64(v[2]))


@wp.func
def _with_normal(job: StartJob, facet: Facet, n: wp.vec3d) -> Facet:
    """A facet with that unit normal, along which points are moved off it by 32 roundings of its corners."""
    spread = wp.vec3d(wp.float64(job.spread_x), wp.float64(job.spread_y), wp.float64(job.spread_z))
    facet.n = n
    facet.lift = wp.float64(job.rays.coarseness)
    facet.slack = facet.lift
    for axis in range(3):
        reach = wp.max(wp.max(wp.abs(facet.a[axis]), wp.abs(facet.b[axis])), wp.abs(facet.c[axis]))
        facet.lift += _LIFT * wp.abs(n[axis]) * wp.max(reach, spread[axis])
        facet.slack += _LIFT * wp.max(reach, spread[axis])
    return facet


@wp.func
def _corners(job: StartJob, face: wp.int32) -> Facet:
    corners = wp.array(ptr=job.triangles + wp.uint64(face) * wp.uint64(12), shape=(1,), dtype=wp.vec3i)[0]
    facet = Facet()
    facet.a = _double(_vector(job.vertices, wp.int64(corners[0])))
    facet.b = _double(_vector(job.vertices, wp.int64(corners[1])))
    facet.c = _double(_vector(job.vertices, wp.int64(corners[2])))
    return facet


@wp.func
def _facet(job: StartJob, face: wp.int32) -> Facet:
    facet = _corners(job, face)
    n = wp.cross(facet.b - facet.a, facet.c - facet.a)
    facet.area = wp.length(n)
    longest = wp.max(wp.max(wp.length(facet.b - facet.a), wp.length(facet.c - facet.b)), wp.length(facet.a - facet.c))
    if facet.area > _ZERO:
        facet = _with_normal(job, facet, n / facet.area)
    if facet.area <= facet.lift * longest:  # thinner than its lift: its normal is rounded to nothing
        facet.n = _NOWHERE
    return facet


@wp.func
def _inwards(facet: Facet, start: wp.vec3d, end: wp.vec3d, p: wp.vec3d) -> wp.float64:
    """How far a point of a facet's plane is on the inner side of an edge."""
    edge = end - start
    return wp.dot(wp.cross(edge, p - start), facet.n) / wp.length(edge)


@wp.func
def _within(facet: Facet, p: wp.vec3d) -> wp.float64:
    """How far a point of a facet's plane is on the inner side of all its edges."""
    first = wp.min(_inwards(facet, facet.a, facet.b, p), _inwards(facet, facet.b, facet.c, p))
    return wp.min(first, _inwards(facet, facet.c, facet.a, p))


@wp.func
def _touches(facet: Facet, p: wp.vec3d, moved: wp.float64) -> wp.bool:
    """Whether a point is as near to a facet as two lifts, or may be brought as near by a move."""
    near = wp.abs(wp.dot(facet.n, p - facet.a)) <= _TWO * facet.lift + moved
    return near and _within(facet, p) >= -facet.slack - moved


@wp.func
def _settled(seat: Seat, other: Facet) -> Seat:
    """The seat, brought to its own side of another facet that touches the point."""
    own = seat.facet
    up = seat.side * own.n
    rises = wp.max(wp.max(wp.dot(up, other.a - own.a), wp.dot(up, other.b - own.a)), wp.dot(up, other.c - own.a))
    a = wp.dot(other.n, own.a - other.a)
    b = wp.dot(other.n, own.b - other.a)
    c = wp.dot(other.n, own.c - other.a)
    across = wp.max(wp.max(a, b), c) > other.lift and wp.min(wp.min(a, b), c) < -other.lift
    across = across and _within(own, seat.p) > own.slack  # and not at an edge of its face
    gain = (a + b + c) * _THIRD - wp.dot(other.n, seat.p - other.a)
    side = wp.where(across, seat.side, wp.copysign(_ONE, gain))
    height = side * wp.dot(other.n, seat.o - other.a)
    if rises > own.lift and height < _HALF * other.lift:
        if across:
            seat.aside += (side * (other.lift - height)) * other.n
        elif wp.abs(gain) > _THIRD * other.lift:
            seat.inwards = wp.max(seat.inwards, (other.lift - height) / wp.abs(gain))
    return seat


@wp.func
def _better(cosine: wp.float64, face: wp.int32, best: wp.float64, known: wp.int32) -> wp.bool:
    """Whether a face is to be preferred to the one known; of equal ones the first, in whichever order they are looked at."""
    return cosine >= _ZERO and (known < 0 or cosine > best or (cosine == best and face < known))


@wp.func
def _look_at(job: StartJob, seat: Seat, face: wp.int32, look: wp.vec3d, searching: wp.bool) -> Seat:
    """The seat after a look at another face that may touch the point: as its own, or else as one beside it."""
    facet = _facet(job, face)
    if wp.dot(facet.n, facet.n) == _ZERO:
        if seat.own == -1:
            seat.own = _THIN
    elif _touches(facet, seat.p, seat.moved):
        if searching:
            cosine = wp.dot(facet.n, look)
            seat.ahead += cosine * facet.area
            if _better(cosine, face, seat.best_along, seat.along):
                seat.best_along = cosine
                seat.along = face
            if _better(-cosine, face, seat.best_against, seat.against):
                seat.best_against = -cosine
                seat.against = face
        else:
            seat = _settled(seat, facet)
    return seat


@wp.func
def _around(node: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:
    """Mask of the children whose boxes are as near to a point as r along each axis."""
    rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    places = wp.array(ptr=node + _PLACES, shape=(WIDTH,), dtype=wp.int32)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        x = wp.where(rows[k] <= p[0] + r, 1, 0) & wp.where(rows[3 * WIDTH + k] >= p[0] - r, 1, 0)
        y = wp.where(rows[WIDTH + k] <= p[1] + r, 1, 0) & wp.where(rows[4 * WIDTH + k] >= p[1] - r, 1, 0)
        z = wp.where(rows[2 * WIDTH + k] <= p[2] + r, 1, 0) & wp.where(rows[5 * WIDTH + k] >= p[2] - r, 1, 0)
        mask = mask | ((x & y & z & wp.where(places[k] != 0, 1, 0)) << k)
        k += 1
    return mask


@wp.func
def _beside(rows: wp.array[wp.float32], k: wp.int32, x: wp.float32, r: wp.float32) -> wp.int32:
    """1 where a coordinate is between those of a triangle's corners, or as near to them as r."""
    a = rows[k]
    b = rows[3 * WIDTH + k]
    c = rows[6 * WIDTH + k]
    return wp.where(lesser(lesser(a, b), c) <= x + r, 1, 0) & wp.where(greater(greater(a, b), c) >= x - r, 1, 0)


@wp.func
def _touched(leaf: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:
    """Mask of the triangles that may be as near to a point as r: a few too many, never one too few."""
    xs = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    ys = wp.array(ptr=leaf + wp.uint64(4 * WIDTH), shape=(_LEAF_FLOATS,), dtype=wp.float32)
    zs = wp.array(ptr=leaf + wp.uint64(8 * WIDTH), shape=(_LEAF_FLOATS,), dtype=wp.float32)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        near = _beside(xs, k, p[0], r) & _beside(ys, k, p[1], r) & _beside(zs, k, p[2], r)
        a = corner(leaf, 0, k, p)
        b = corner(leaf, 3, k, p)
        c = corner(leaf, 6, k, p)
        n = wp.cross(b - a, c - a)
        far = greater(greater(size_of(a), size_of(b)), size_of(c))
        # A component of the normal is rounded by 2^-23 of two edges, each within 2 far; then come products and sums.
        rounding = _ROUNDING * far * far
        beside = (r * size_of(n) + rounding * far) * far * 4.0
        near = near & wp.where(wp.abs(wp.dot(n, a)) <= r * size_of(n) + rounding * far, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(a, b)) >= -beside, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(b, c)) >= -beside, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(c, a)) >= -beside, 1, 0)
        mask = mask | (near << k)
        k += 1
    return mask


@wp.func
def _look_around(
    job: StartJob, tree: Accelerator, seat: Seat, look: wp.vec3d, searching: wp.bool, scratch: wp.uint64
) -> Seat:
    """The seat after a look at all faces that touch the point."""
    p = wp.vec3(seat.p)
    r = 2.0 * _TWICE * (job.rays.extent_x + job.rays.extent_y + job.rays.extent_z) + 4.0 * job.rays.coarseness
    node = tree.nodes
    mask = _around(node, p, r)
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
            leaf = tree.leaves + wp.uint64(~place) * _LEAF
            touched = _touched(leaf, p, r)
            faces = wp.array(ptr=leaf + _FACES, shape=(WIDTH,), dtype=wp.int32)
            for _ in range(wp.bit_count(touched)):
                face = faces[lowest_bit(touched)]
                touched = touched & (touched - 1)
                if face != seat.own:
                    seat = _look_at(job, seat, face, look, searching)
        else:
            if mask != 0:
                top = put_aside(top, node, mask, 0.0)
            node = tree.nodes + wp.uint64(place) * _NODE
            mask = _around(node, p, r)
    return seat


@wp.func
def _own(seat: Seat) -> wp.int32:
    """The face that a point is of, found by its normal: that of the face, or the sum of several by area, or the opposite.

    The sum at the tip of a spike is against some of the faces that it is of. Below 0 if there is none.
    """
    along = seat.best_along > _SAME
    against = seat.best_against > _SAME
    forward = seat.ahead >= _ZERO
    if along != against:
        forward = along
    found = wp.where(forward, seat.along, seat.against)
    return wp.where(found >= 0, found, seat.own)


@wp.func
def _sitting(job: StartJob, seat: Seat, look: wp.vec3d, known: wp.bool) -> Seat:
    """The seat a lift above its face, to the side to which the point looks."""
    own = seat.facet
    seat.side = wp.copysign(_ONE, wp.dot(own.n, look))
    seat.inwards = _ZERO
    seat.aside = _NOWHERE
    height = seat.side * wp.dot(own.n, seat.p - own.a)
    away = wp.clamp(own.lift - height, _ZERO, _TWO * own.lift)
    way = seat.side * own.n
    steep = wp.dot(way, look)
    if not known and steep > _TENTH and away > _ZERO:  # a vertex: along its normal, above all faces if none is in the way
        way = look
        away = wp.max(away / steep, _with_normal(job, own, look).lift)
    seat.o = seat.p + away * way
    seat.moved = away
    return seat


@wp.func
def _start(job: StartJob, seat: Seat, look: wp.vec3d) -> wp.vec3:
    """Where the rays of a seat start: where it is, if it is on no face."""
    if seat.own == _THIN:
        towards = wp.vec3(look)
        return wp.vec3(seat.p) + lift(job.rays, towards) * towards
    if wp.dot(seat.facet.n, seat.facet.n) == _ZERO:
        return wp.vec3(seat.p)
    middle = (seat.facet.a + seat.facet.b + seat.facet.c) * _THIRD
    return wp.vec3(seat.o + wp.min(seat.inwards, _HALF) * (middle - seat.p) + seat.aside)


def starts_of(
    scene: "Scene", rays: Job, face: np.ndarray, towards: np.ndarray | None, tree: AcceleratorJob, workers: int
) -> np.ndarray:
    """(P, sides, 3) float32, the starts of P points in the scene's coordinates.

    Args:
        scene: what they are on.
        rays: their places, and in `normals` the unit normals of their faces, their own where they lie on none.
        face: (P,) int32, -1 where it is not known: then of those that touch a point the one that faces its normal best.
        towards: (P, 3) float32, to which side of its face each looks; None for both, that of the normal first.
        tree: of the scene.
        workers: threads.
    """
    sides = 2 if towards is None else 1
    starts = np.empty((rays.points, sides, 3), np.float32)
    job = _Job(rays=rays, towards=0 if towards is None else towards.ctypes.data, face=face.ctypes.data)
    job.vertices, job.triangles = scene.vertices.ctypes.data, scene.faces.ctypes.data
    job.spread_x, job.spread_y, job.spread_z = scene.spread
    job.starts, job.sides = starts.ctypes.data, sides
    run(_start_kernel(), rays.points, [job, tree], cpu(), workers, 16 * rays.points)
    return starts


@once
def _start_kernel() -> wp.Kernel:
    """A kernel with a task for each point."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def find_starts(job: StartJob, tree: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        i = first_task + wp.int64(wp.tid())
        seat = Seat()
        seat.p = local_origin(job.rays, i)
        seat.own = wp.array(ptr=job.face + wp.uint64(i) * wp.uint64(4), shape=(1,), dtype=wp.int32)[0]
        seat.along = -1
        seat.against = -1
        normal = _vector(job.rays.normals, i)
        look = _double(normal)
        if job.sides == 1:
            look = _double(normalize(_vector(job.towards, i)))
        known = seat.own >= 0
        if known:
            seat.facet = _with_normal(job, _corners(job, seat.own), _double(normal))  # from before corners were rounded
        # First the search for its own face, if that is not known; then a start for each side.
        for step in range(wp.where(known, 1, 0), job.sides + 1):
            if step > 0 and seat.own >= 0:
                seat = _sitting(job, seat, look, known)
            if wp.dot(look, look) > _ZERO and (step == 0 or seat.own >= 0):
                seat = _look_around(job, tree, seat, look, step == 0, words.ptr)
            if step == 0:
                seat.own = _own(seat)
                if seat.own >= 0:
                    seat.facet = _facet(job, seat.own)
            else:
                at = job.starts + wp.uint64(12) * (wp.uint64(i) * wp.uint64(job.sides) + wp.uint64(step - 1))
                start = wp.array(ptr=at, shape=(1,), dtype=wp.vec3)
                start[0] = _start(job, seat, look)
                look = -look

    return find_starts
