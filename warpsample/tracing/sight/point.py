"""Point from which a kernel traces rays: position, start of the rays, and working memory."""

import warp as wp

from warpsample.directions.samples import normal_status
from warpsample.maths.memory import byte_at, set_float, vec3_at
from warpsample.maths.numerics import ZERO, scaled_to_unit
from warpsample.tracing.placement import (
    Placement,
    distance_to_scene,
    local_origin,
    origin_offset,
    point_of,
    reach_along,
)
from warpsample.tracing.queries import CHUNK_FLOATS, REACH, column_of, set_origin, start_all
from warpsample.tracing.sight.leaves import OWN_LEAF_FLOATS
from warpsample.tracing.wide.layout import MOST_DEPTH, MOST_STARTS, NODE_BYTES, SCRATCH, WIDTH

NONFINITE_POSITION = 4
"""Status of a point whose position is not finite; `directions.samples` has the other statuses."""

HORIZON_MARGIN: wp.float32 = wp.constant(wp.float32(2.0**-20))
"""Rounding margin of heights above a point's horizon plane, relative to `placement.reach_along` the normal.

A geometry lower than this below the origin's horizon plane is certainly below it. The three products and sums of a height,
and the coordinates and normal components in them, are rounded by 2^-21.4 of the reach. The origin is moved off the surface
by `placement.origin_offset`, 2^-19 of it. So its own face, and all faces in the same plane, are below the horizon.
"""

SHAFT_FLOATS = 5 * WIDTH
"""Number of float32 in a shaft; see `shafts`."""

SIDES_FLOATS = 12 * WIDTH
"""Number of float32 in an opened leaf; see `sides`."""

LOCAL_LEAF: wp.uint64 = wp.constant(wp.uint64(MOST_STARTS * NODE_BYTES))
"""Byte offset of a point's local leaf from its first start node."""

_ROW = 16  # parts of the workspace start at multiples of this number of floats
_OPENED_FLOATS = -(-(MOST_STARTS * NODE_BYTES // 4 + OWN_LEAF_FLOATS) // _ROW) * _ROW
_PACKET_FLOATS = SIDES_FLOATS + 4 * (MOST_STARTS + (WIDTH - 1) * MOST_DEPTH)
"""Number of float32 for packets: an opened leaf, and a stack on which up to 16 children replace a node at each level."""

_SCRATCH_FLOATS = -(-SCRATCH // _ROW) * _ROW


@wp.struct
class ShadingPoint:
    """Point from which a kernel traces rays, with addresses of the kernel's working memory.

    Attributes:
        index: row of the point in the arrays of the call.
        status: 0, or the reason why nothing is traced from the point.
        key: key of the point's random numbers.
        n: unit normal.
        position: position in the scene's coordinates.
        o: start of the rays, in the scene's coordinates.
        low: rounding margin of heights: geometry lower than this below the horizon of o is certainly below it.
        reach: largest distance of a hit, in the scene's coordinates.
        chunk: address of the chunk of rays.
        own: address of the part of the workspace that the kernel asked for.
        shaft: address of the shaft that is aimed.
        opened: address of the start nodes of the rays, followed by the local leaf.
        scratch: address of the stack of nodes.
        sides: address of the leaf opened for packets.
        waiting: address of the stack of nodes with sets of rays, for packets.
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
    """Return the number of float32 in the working memory of a kernel that traces rays from points.

    Args:
        own: number of float32 for the kernel's own use, a multiple of 16.
        chunk: number of float32 in a chunk.
        searches: whether to include shafts, start nodes and the stack of searches.
        packets: whether to include the memory for packets.
    """
    searching = SHAFT_FLOATS + _OPENED_FLOATS + _SCRATCH_FLOATS if searches else 0
    return chunk + own + searching + (_PACKET_FLOATS if packets else 0)


@wp.func
def point_in(workspace: wp.uint64, own: wp.int32, chunk: wp.int32) -> ShadingPoint:
    """Return a `ShadingPoint` whose working memory starts at the given address; its position is set later.

    The index, the normal and the position are not set yet. The workspace has the size that `workspace_floats` returns.
    """
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
def orient_point(
    point: ShadingPoint, placement: Placement, normals: wp.uint64, active: wp.uint64, visit: wp.int64
) -> ShadingPoint:
    """Return the point that is processed as number `visit`, with its index, unit normal and status.

    normals: address of (P, 3) float32, of any length. active: address of (P,) uint8, or 0 if all points are active.
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
    """Return the position where a point's rays start, on the side of its face to which the normal points."""
    if placement.starts != wp.uint64(0) and sides == 1:
        return vec3_at(placement.starts, point.index)
    side = vec3_at(placement.normals, point.index)
    forward = wp.dot(side, point.n)
    if placement.starts != wp.uint64(0):
        return vec3_at(placement.starts, wp.int64(2) * point.index + wp.where(forward < 0.0, wp.int64(1), wp.int64(0)))
    return wp.vec3(point.position) + wp.copysign(origin_offset(placement, side), forward) * side


@wp.func
def place_point(point: ShadingPoint, placement: Placement, sides: wp.int32) -> ShadingPoint:
    """Set the position, ray start and status of a point, and the origin of all rays in the point's working memory.

    `sides`, 1 or 2, is the number of starts per point in the placement.
    """
    point.position = local_origin(placement, point.index)
    point.o = _origin(placement, point, sides)
    point.low = HORIZON_MARGIN * reach_along(placement, point.n, point.o)
    point.reach = wp.float32(placement.reach)
    if point.status == 0 and wp.dot(point.position - point.position, point.position - point.position) != ZERO:
        point.status = NONFINITE_POSITION
    start_all(point.chunk, point.o, point.reach)
    return point


@wp.func
def move_ray_near(point: ShadingPoint, k: wp.int32, d: wp.vec3d):
    """Move the origin of the k-th ray of a distant point close to the mesh, along the unit vector d.

    The reach becomes negative if the ray misses the mesh.
    """
    ahead = distance_to_scene(point.position, d)
    set_origin(point.chunk, k, wp.vec3(point.position + ahead * d))
    reach = wp.where(ahead < ZERO, -1.0, wp.float32(wp.float64(point.reach) - ahead))
    set_float(column_of(point.chunk, k), REACH, reach)
