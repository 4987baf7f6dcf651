"""Faces in float64: corners, normals, and tests whether a point touches a face."""

import warp as wp

from warpsample.maths.memory import vec3_at, vec3i_at
from warpsample.maths.numerics import TWO, ZERO
from warpsample.tracing.placement import OFFSET, Placement, in_double

_OFFSET = wp.constant(wp.float64(OFFSET))

NOWHERE: wp.vec3d = wp.constant(wp.vec3d(0.0, 0.0, 0.0))
"""Zero vector: the normal of a face that is too thin to have one."""


@wp.struct
class Contacts:
    """Kernel argument of the search for ray starts: numbers, and addresses of the points and of the mesh's faces.

    Attributes:
        placement: placement of the points. Its `normals` are those of the points' faces, or the points' own without a face.
        towards: address of (P, 3) float32, direction to the side from which rays start; 0 for both sides, `normals` first.
        face: address of (P,) int32, face of each point, -1 if unknown.
        raised: address of (P,) bool, points whose starts are raised vertically, as in `SurfacePoints`; 0 for none.
        vertices: address of the scene's (V, 3) float32 vertices.
        triangles: address of the scene's (F, 3) int32 faces.
        spread: extent of the scene without distant parts, or 1 on each axis for a tracer with inexact distances.
        starts: address of (P, sides, 3) float32 for the starts, in the scene's coordinates.
        sides: number of starts per point, 1 or 2.
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
    """Face of a mesh in float64: corners, normal, and tolerances.

    Attributes:
        a, b, c: corners.
        n: unit normal; zero if the face is too thin to have one.
        area: twice the area.
        offset: distance by which points of the face are moved off it.
        slack: distance outside the edges at which a point still touches the face, since corners are rounded.
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
    """Return a copy of a face with the unit normal n, and the offset and tolerance for this normal.

    The offset and the slack are 32 roundings of the corners plus the coarseness of stored positions.
    """
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
    """Return the corners of a face in float64, as a `Facet` without a normal."""
    corners = vec3i_at(contacts.triangles, face)
    facet = Facet()
    facet.a = in_double(vec3_at(contacts.vertices, corners[0]))
    facet.b = in_double(vec3_at(contacts.vertices, corners[1]))
    facet.c = in_double(vec3_at(contacts.vertices, corners[2]))
    return facet


@wp.func
def facet_of(contacts: Contacts, face: wp.int32) -> Facet:
    """Return the corners and the normal of a face in float64; the normal of a needle-like face is zero."""
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
def _edge_distance(start: wp.vec3d, end: wp.vec3d, n: wp.vec3d, p: wp.vec3d) -> wp.float64:
    """Return the signed distance of a point from an edge, as seen along the unit vector n."""
    edge = end - start
    return wp.dot(wp.cross(edge, p - start), n) / wp.length(edge)


@wp.func
def inward_distance(facet: Facet, n: wp.vec3d, p: wp.vec3d) -> wp.float64:
    """Return the signed distance of a point from the nearest edge of a face, as seen along the unit vector n.

    It is positive inside, if n is on the front side of the face.
    """
    first = wp.min(_edge_distance(facet.a, facet.b, n, p), _edge_distance(facet.b, facet.c, n, p))
    return wp.min(first, _edge_distance(facet.c, facet.a, n, p))


@wp.func
def is_touching(facet: Facet, p: wp.vec3d, moved: wp.float64) -> wp.bool:
    """Return whether a point touches a face, or may touch it after a move of length `moved`."""
    near = wp.abs(wp.dot(facet.n, p - facet.a)) <= TWO * facet.offset + moved
    return near and inward_distance(facet, facet.n, p) >= -facet.slack - moved
