"""The contact of a point among the faces that touch it, and where its rays start from there (see `starts`)."""

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.tracing.placement import OFFSET, origin_offset
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.facets import NOWHERE, Contacts, Facet, facet_of, touches, with_normal, within
from warpsample.tracing.sight.touching import faces_touching

_TWICE = wp.constant(wp.float32(2.0 * OFFSET))
_THIRD = wp.constant(wp.float64(1.0 / 3.0))
_RAISED = wp.constant(wp.float64(OFFSET))
_TENTH = wp.constant(wp.float64(0.1))
_SAME = wp.constant(wp.float64(1.0 - 2.0**-20))  # cosine of two normals that are one, rounded to float32
_THIN = wp.constant(wp.int32(-2))  # the face of a point that lies on none but those without a normal


@wp.struct
class FaceContact:
    """Where a point sits.

    p: its position. own: its face, below 0 if none is known. facet: that. side: 1 where it looks from the front, else -1.
    alone: whether no other face is near it. o: an offset above its face. moved: how far from p. inwards: how far the start
    moves towards the middle of the face, as a share. aside: off faces across it. In search of a face: of those whose normals
    are along the direction in which the point looks, the one with the greatest cosine; of those against it, likewise; and of
    all, the sum of cosines times areas.
    """

    p: wp.vec3d
    own: wp.int32
    facet: Facet
    side: wp.float64
    alone: wp.bool
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
def _settled(contact: FaceContact, other: Facet) -> FaceContact:
    """The contact, brought to its own side of another facet that touches the point."""
    own = contact.facet
    up = contact.side * own.n
    rises = wp.max(wp.max(wp.dot(up, other.a - own.a), wp.dot(up, other.b - own.a)), wp.dot(up, other.c - own.a))
    a = wp.dot(other.n, own.a - other.a)
    b = wp.dot(other.n, own.b - other.a)
    c = wp.dot(other.n, own.c - other.a)
    across = wp.max(wp.max(a, b), c) > other.offset and wp.min(wp.min(a, b), c) < -other.offset
    across = across and within(own, contact.p) > own.slack  # and not at an edge of its face
    gain = (a + b + c) * _THIRD - wp.dot(other.n, contact.p - other.a)
    side = wp.where(across, contact.side, wp.copysign(ONE, gain))
    height = side * wp.dot(other.n, contact.o - other.a)
    if rises > own.offset and height < HALF * other.offset:
        if across:
            contact.aside += (side * (other.offset - height)) * other.n
        elif wp.abs(gain) > _THIRD * other.offset:
            contact.inwards = wp.max(contact.inwards, (other.offset - height) / wp.abs(gain))
    return contact


@wp.func
def _better(cosine: wp.float64, face: wp.int32, best: wp.float64, known: wp.int32) -> wp.bool:
    """Whether a face is to be preferred to the one known; of equal ones the first, in whichever order they are looked at."""
    return cosine >= ZERO and (known < 0 or cosine > best or (cosine == best and face < known))


@wp.func
def _look_at_other(
    contacts: Contacts, contact: FaceContact, face: wp.int32, look: wp.vec3d, searching: wp.bool
) -> FaceContact:
    """The contact after a look at another face that may touch the point: as its own, or else as one beside it."""
    facet = facet_of(contacts, face)
    if wp.dot(facet.n, facet.n) == ZERO:
        if contact.own == -1:
            contact.own = _THIN
    elif touches(facet, contact.p, contact.moved):
        if searching:
            cosine = wp.dot(facet.n, look)
            contact.ahead += cosine * facet.area
            if _better(cosine, face, contact.best_along, contact.along):
                contact.best_along = cosine
                contact.along = face
            if _better(-cosine, face, contact.best_against, contact.against):
                contact.best_against = -cosine
                contact.against = face
        else:
            contact = _settled(contact, facet)
    return contact


@wp.struct
class Around:
    """What is asked of the faces around a point: where it is, how near they are, the direction in which it looks.

    searching: whether the face that the point is of is searched for, else those beside it are looked at.
    """

    contacts: Contacts
    p: wp.vec3
    r: wp.float32
    look: wp.vec3d
    searching: wp.bool


@wp.func
def _look_at(face: wp.int32, around: Around, contact: FaceContact) -> FaceContact:
    """The contact after a look at a face that may touch the point."""
    if face != contact.own:
        contact.alone = wp.bool(False)
        contact = _look_at_other(around.contacts, contact, face, around.look, around.searching)
    return contact


_look_around = faces_touching(_look_at, Around, FaceContact)


@wp.func
def look_around(
    contacts: Contacts, tree: Accelerator, contact: FaceContact, look: wp.vec3d, searching: wp.bool, scratch: wp.uint64
) -> FaceContact:
    """The contact after a look at all faces that touch the point."""
    extent = contacts.placement.extent
    around = Around()
    around.contacts = contacts
    around.p = wp.vec3(contact.p)
    around.r = 2.0 * _TWICE * (extent[0] + extent[1] + extent[2]) + 4.0 * contacts.placement.coarseness
    around.look = look
    around.searching = searching
    return _look_around(tree, around, contact, scratch)


@wp.func
def own_face(contact: FaceContact) -> wp.int32:
    """The face that a point is of, found by its normal: that of the face, or the sum of several by area, or the opposite.

    The sum at the tip of a spike is against some of the faces that it is of. Below 0 if there is none.
    """
    along = contact.best_along > _SAME
    against = contact.best_against > _SAME
    forward = contact.ahead >= ZERO
    if along != against:
        forward = along
    found = wp.where(forward, contact.along, contact.against)
    return wp.where(found >= 0, found, contact.own)


@wp.func
def standing_off(contacts: Contacts, contact: FaceContact, look: wp.vec3d, known: wp.bool) -> FaceContact:
    """The contact an offset above its face, to the side to which the point looks."""
    own = contact.facet
    contact.side = wp.copysign(ONE, wp.dot(own.n, look))
    contact.inwards = ZERO
    contact.aside = NOWHERE
    height = contact.side * wp.dot(own.n, contact.p - own.a)
    away = wp.clamp(own.offset - height, ZERO, TWO * own.offset)
    way = contact.side * own.n
    steep = wp.dot(way, look)
    if not known and steep > _TENTH and away > ZERO:  # a vertex: along its normal, above all faces if none is in the way
        way = look
        away = wp.max(away / steep, with_normal(contacts, own, look).offset)
    contact.o = contact.p + away * way
    contact.moved = away
    return contact


@wp.func
def start_above(contacts: Contacts, p: wp.vec3d, look: wp.vec3d) -> wp.vec3:
    """Return the start straight above a vertex p of a field of heights, or straight below if `look` points down.

    It keeps x and y, which round as those of the vertex in the mesh, and is farther above the vertex than z rounds. So it is
    above all faces of the vertex, even those as steep as a wall: `plane_distance` decides that in float64.
    """
    most = wp.max(wp.abs(p[2]), wp.float64(contacts.spread[2]))
    height = wp.float64(contacts.placement.coarseness) + _RAISED * most
    return wp.vec3(wp.vec3d(p[0], p[1], p[2] + wp.copysign(height, look[2])))


@wp.func
def start_of(contacts: Contacts, contact: FaceContact, look: wp.vec3d) -> wp.vec3:
    """Where the rays of a contact start: where it is, if it is on no face."""
    if contact.own == _THIN:
        towards = wp.vec3(look)
        return wp.vec3(contact.p) + origin_offset(contacts.placement, towards) * towards
    if wp.dot(contact.facet.n, contact.facet.n) == ZERO:
        return wp.vec3(contact.p)
    middle = (contact.facet.a + contact.facet.b + contact.facet.c) * _THIRD
    return wp.vec3(contact.o + wp.min(contact.inwards, HALF) * (middle - contact.p) + contact.aside)
