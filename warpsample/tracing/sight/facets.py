"""A face in float64, as the starts of rays see it: its corners, its normal, and which points touch it."""

import warp as wp

from warpsample.maths.memory import vec3_at, vec3i_at
from warpsample.maths.numerics import TWO, ZERO
from warpsample.tracing.placement import OFFSET, Placement, in_double

_OFFSET = wp.constant(wp.float64(OFFSET))

NOWHERE: wp.vec3d = wp.constant(wp.vec3d(0.0, 0.0, 0.0))


@wp.struct
class Contacts:
    """Scalars and addresses of points on the faces of a scene.

    placement: of the points; its `normals` are those of their faces, and their own where they lie on none.
    towards: (P, 3) float32, directions to the side of the face from which a point looks; 0: both sides, `normals` first.
    face: (P,) int32, -1 where it is not known.
    vertices, triangles: (V, 3) float32 and (F, 3) int32 of the scene. spread: its extent without parts that are far apart.
    raised: (P,) bool, points whose rays start straight above or below them, as `SurfacePoints` has it; 0: none.
    starts: (P, sides, 3) float32, where rays start; in the scene's coordinates. sides: 1 or 2.
    """

    placement: Placement
    towards: wp.uint64
    face: wp.uint64
    raised: wp.uint64
    vertices: wp.uint64
    triangles: wp.uint64
    spread: wp.vec3
    starts: wp.uint64
    sides: wp.int32


ContactsArgs = type(Contacts().__ctype__())


@wp.struct
class Facet:
    """A face: its corners, unit normal (0 if it is too thin to have one) and twice its area.

    offset: how far points of it are moved off it. slack: how far beside it they may be, since its corners are rounded.
    """

    a: wp.vec3d
    b: wp.vec3d
    c: wp.vec3d
    n: wp.vec3d
    area: wp.float64
    offset: wp.float64
    slack: wp.float64


@wp.func
def with_normal(contacts: Contacts, facet: Facet, n: wp.vec3d) -> Facet:
    """A facet with that unit normal, along which points are moved off it by 32 roundings of its corners."""
    spread = in_double(contacts.spread)
    facet.n = n
    facet.offset = wp.float64(contacts.placement.coarseness)
    facet.slack = facet.offset
    for axis in range(3):
        reach = wp.max(wp.max(wp.abs(facet.a[axis]), wp.abs(facet.b[axis])), wp.abs(facet.c[axis]))
        facet.offset += _OFFSET * wp.abs(n[axis]) * wp.max(reach, spread[axis])
        facet.slack += _OFFSET * wp.max(reach, spread[axis])
    return facet


@wp.func
def corners_of(contacts: Contacts, face: wp.int32) -> Facet:
    """A face without its normal."""
    corners = vec3i_at(contacts.triangles, face)
    facet = Facet()
    facet.a = in_double(vec3_at(contacts.vertices, corners[0]))
    facet.b = in_double(vec3_at(contacts.vertices, corners[1]))
    facet.c = in_double(vec3_at(contacts.vertices, corners[2]))
    return facet


@wp.func
def facet_of(contacts: Contacts, face: wp.int32) -> Facet:
    """A face with its normal, which is 0 where the face is thinner than its offset."""
    facet = corners_of(contacts, face)
    n = wp.cross(facet.b - facet.a, facet.c - facet.a)
    facet.area = wp.length(n)
    longest = wp.max(wp.max(wp.length(facet.b - facet.a), wp.length(facet.c - facet.b)), wp.length(facet.a - facet.c))
    if facet.area > ZERO:
        facet = with_normal(contacts, facet, n / facet.area)
    if facet.area <= facet.offset * longest:
        facet.n = NOWHERE
    return facet


@wp.func
def _inwards(facet: Facet, start: wp.vec3d, end: wp.vec3d, p: wp.vec3d) -> wp.float64:
    """How far a point of a facet's plane is on the inner side of an edge."""
    edge = end - start
    return wp.dot(wp.cross(edge, p - start), facet.n) / wp.length(edge)


@wp.func
def within(facet: Facet, p: wp.vec3d) -> wp.float64:
    """How far a point of a facet's plane is on the inner side of all its edges."""
    first = wp.min(_inwards(facet, facet.a, facet.b, p), _inwards(facet, facet.b, facet.c, p))
    return wp.min(first, _inwards(facet, facet.c, facet.a, p))


@wp.func
def touches(facet: Facet, p: wp.vec3d, moved: wp.float64) -> wp.bool:
    """Whether a point is as near to a facet as two offsets, or may be brought as near by a move."""
    near = wp.abs(wp.dot(facet.n, p - facet.a)) <= TWO * facet.offset + moved
    return near and within(facet, p) >= -facet.slack - moved
