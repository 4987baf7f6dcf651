"""A shading point as its rays see it: where it is, where they start, and the workspace of the kernel that looks from it."""

import warp as wp

from warpsample.directions.samples import normal_status
from warpsample.maths.memory import byte_at, set_float, vec3_at
from warpsample.maths.numerics import ZERO, scaled_to_unit
from warpsample.tracing.placement import (
    Placement,
    local_origin,
    origin_offset,
    point_of,
    reach_along,
    way_to_scene,
)
from warpsample.tracing.queries import CHUNK_FLOATS, REACH, column_of, set_origin, start_all
from warpsample.tracing.sight.leaves import OWN_LEAF_FLOATS
from warpsample.tracing.wide.layout import MOST_DEPTH, MOST_STARTS, NODE_BYTES, SCRATCH, WIDTH

NONFINITE_POSITION = 4
"""The status of a point that is nowhere; `directions.samples` has the others that a point may have."""

HORIZON_MARGIN: wp.float32 = wp.constant(wp.float32(2.0**-20))
"""Times `placement.reach_along` the normal: what is lower than this below the origin's horizon plane is below it for sure.

A height's three products and sums, and the coordinates and the normal's components in them, are rounded to 2^-21.4 of that.
An origin that is moved off the surface by `placement.origin_offset`, of 2^-19, thus has its own face, and all in its plane,
below itself.
"""

SHAFT_FLOATS = 5 * WIDTH
"""float32 numbers of a shaft: see `shafts`."""

SIDES_FLOATS = 12 * WIDTH
"""float32 numbers of an opened leaf: see `sides`."""

LOCAL_LEAF: wp.uint64 = wp.constant(wp.uint64(MOST_STARTS * NODE_BYTES))
"""Where a point's local leaf is, in bytes from its first node on."""

_ROW = 16  # parts of the workspace start at multiples of as many floats
_OPENED_FLOATS = -(-(MOST_STARTS * NODE_BYTES // 4 + OWN_LEAF_FLOATS) // _ROW) * _ROW
_PACKET_FLOATS = SIDES_FLOATS + 4 * (MOST_STARTS + (WIDTH - 1) * MOST_DEPTH)
"""Of an opened leaf, and of nodes that wait: of each, all children may take its place, and one of these is opened next."""

_SCRATCH_FLOATS = -(-SCRATCH // _ROW) * _ROW


@wp.struct
class ShadingPoint:
    """A point, and the addresses of memory to work in.

    index: its row in the arrays of the call. status: 0, or why nothing is seen from it. key: of its random numbers.
    n: its unit normal. position: in the scene's coordinates. o: where its rays start. low: what is lower than this below
    the horizon of o is below it. reach: of its rays.
    chunk: of rays. own: what the kernel asked for. shaft: the one that is aimed. opened: the nodes that rays start from, and
    the local leaf. scratch: nodes that wait. sides, waiting: of packets, an opened leaf, and nodes with rays that wait.
    """

    index: wp.int64
    status: wp.int32
    key: wp.vec4ui
    n: wp.vec3
    position: wp.vec3d
    o: wp.vec3
    low: wp.float32
    reach: wp.float32
    chunk: wp.uint64
    own: wp.uint64
    shaft: wp.uint64
    opened: wp.uint64
    scratch: wp.uint64
    sides: wp.uint64
    waiting: wp.uint64


def workspace_floats(own: int, chunk: int = CHUNK_FLOATS, searches: bool = True, packets: bool = False) -> int:
    """float32 numbers of the workspace of a kernel: a multiple of 16 of its own, a chunk, what searches and packets need."""
    searching = SHAFT_FLOATS + _OPENED_FLOATS + _SCRATCH_FLOATS if searches else 0
    return chunk + own + searching + (_PACKET_FLOATS if packets else 0)


@wp.func
def point_in(workspace: wp.uint64, own: wp.int32, chunk: wp.int32) -> ShadingPoint:
    """A point that is nowhere yet, with the addresses of a workspace of `workspace_floats`."""
    point = ShadingPoint()
    point.chunk = workspace
    point.own = point.chunk + wp.uint64(4 * chunk)
    point.shaft = point.own + wp.uint64(4 * own)
    point.opened = point.shaft + wp.uint64(4 * SHAFT_FLOATS)
    point.scratch = point.opened + wp.uint64(4 * _OPENED_FLOATS)
    point.sides = point.scratch + wp.uint64(4 * _SCRATCH_FLOATS)
    point.waiting = point.sides + wp.uint64(4 * SIDES_FLOATS)
    return point


@wp.func
def turned(
    point: ShadingPoint, placement: Placement, normals: wp.uint64, active: wp.uint64, visit: wp.int64
) -> ShadingPoint:
    """The point in the workspace that is visited so many points after the first, with its normal; it is nowhere yet.

    normals: address of (P, 3) float32, of any length; active: of (P,) uint8, or 0 where all points count.
    """
    point.index = point_of(placement, visit)
    normal = vec3_at(normals, point.index)
    unit = scaled_to_unit(normal)
    point.n = wp.vec3(unit[0], unit[1], unit[2])
    weight = wp.float32(1.0)
    if active != wp.uint64(0):
        weight = wp.where(byte_at(active, point.index) == wp.uint8(0), 0.0, 1.0)
    point.status = normal_status(normal, weight)
    return point


@wp.func
def _origin(placement: Placement, point: ShadingPoint, sides: wp.int32) -> wp.vec3:
    """Where the rays of a point start, to the side of its normal."""
    if placement.starts != wp.uint64(0) and sides == 1:
        return vec3_at(placement.starts, point.index)
    side = vec3_at(placement.normals, point.index)
    forward = wp.dot(side, point.n)
    if placement.starts != wp.uint64(0):
        return vec3_at(placement.starts, wp.int64(2) * point.index + wp.where(forward < 0.0, wp.int64(1), wp.int64(0)))
    return wp.vec3(point.position) + wp.copysign(origin_offset(placement, side), forward) * side


@wp.func
def standing(point: ShadingPoint, placement: Placement, sides: wp.int32) -> ShadingPoint:
    """A point of `turned` where it is, with the origin of its rays; `sides`, 1 or 2: of the starts in the placement."""
    point.position = local_origin(placement, point.index)
    point.o = _origin(placement, point, sides)
    point.low = HORIZON_MARGIN * reach_along(placement, point.n, point.o)
    point.reach = wp.float32(placement.reach)
    if point.status == 0 and wp.dot(point.position - point.position, point.position - point.position) != ZERO:
        point.status = NONFINITE_POSITION
    start_all(point.chunk, point.o, point.reach)
    return point


@wp.func
def bring_near(point: ShadingPoint, k: wp.int32, d: wp.vec3d):
    """Lets the k-th ray of a point that is far off, along d, start near the mesh; without reach if it passes the mesh."""
    ahead = way_to_scene(point.position, d)
    set_origin(point.chunk, k, wp.vec3(point.position + ahead * d))
    reach = wp.where(ahead < ZERO, -1.0, wp.float32(wp.float64(point.reach) - ahead))
    set_float(column_of(point.chunk, k), REACH, reach)
