"""Search for the faces that touch a surface point, and choice of the position where the point's rays start."""

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.tracing.placement import OFFSET, origin_offset
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.facets import NOWHERE, Contacts, Facet, facet_of, inward_distance, is_touching, with_normal
from warpsample.tracing.sight.touching import faces_touching

_TWICE = wp.constant(wp.float32(2.0 * OFFSET))
_STEP = wp.constant(wp.float64(16.0))  # slacks, so that a foot at 8 degrees to the edge or more is found
_THIRD = wp.constant(wp.float64(1.0 / 3.0))
_RAISED = wp.constant(wp.float64(OFFSET))
_TENTH = wp.constant(wp.float64(0.1))
_SAME = wp.constant(wp.float64(1.0 - 2.0**-20))  # least cosine between equal normals that are rounded to float32
_THIN = wp.constant(wp.int32(-2))  # face number of a point that lies only on faces too thin to have a normal


@wp.struct
class FaceContact:
    """State of the search for the position where a surface point's rays start: the point, its face, and the start so far.

    The last fields are the state of the search for the point's own face, by the cosine of each touching face's normal to the
    point's direction of view.

    Attributes:
        p: position of the point.
        own: number of the point's own face; below 0 if unknown.
        facet: the point's own face.
        side: 1 if the point looks from the front of its face, else -1.
        alone: whether no other face is near the point.
        o: position moved off the own face.
        moved: distance between p and o.
        inwards: move of the start towards the centre of the face, as a fraction of the way.
        aside: displacement of the start off faces that cross the own face.
        along: face with the greatest cosine, among cosines of at least 0; -1 if none.
        best_along: that cosine.
        against: face with the smallest cosine, among cosines of at most 0; -1 if none.
        best_against: that cosine, negated.
        ahead: sum over all touching faces of cosine times twice the area.
        behind: whether the own face is behind another one, like the floor inside a box that stands on it.
        after: faces after this one are searched for another with the same normal; -2 in the search for the first one.
        next: the first such face; -1 if there is none.
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
    behind: wp.bool
    after: wp.int32
    next: wp.int32


@wp.func
def _runs_into(contact: FaceContact, other: Facet) -> wp.bool:
    """Return whether another face crosses a point's own face next to the point, which is at an edge of its own face.

    So do walls whose foot runs on through the point, but not faces that meet the own face at the edge.
    """
    own = contact.facet
    along = wp.cross(own.n, other.n)
    step = (_STEP * own.slack / wp.length(along)) * along
    found = wp.bool(False)
    for _way in range(2):
        q = contact.p + step
        found = found or (inward_distance(own, q) > TWO * own.slack and is_touching(other, q, contact.moved))
        step = -step
    return found


@wp.func
def _move_off_facet(contact: FaceContact, other: Facet) -> FaceContact:
    """Move the start of a point's rays to the visible side of another face that touches the point, if needed.

    The start point ends on the same side of that facet as the centre of the point's own face.
    """
    own = contact.facet
    up = contact.side * own.n
    rises = wp.max(wp.max(wp.dot(up, other.a - own.a), wp.dot(up, other.b - own.a)), wp.dot(up, other.c - own.a))
    a = wp.dot(other.n, own.a - other.a)
    b = wp.dot(other.n, own.b - other.a)
    c = wp.dot(other.n, own.c - other.a)
    across = wp.max(wp.max(a, b), c) > other.offset and wp.min(wp.min(a, b), c) < -other.offset
    if across and inward_distance(own, contact.p) <= own.slack:  # the point is at an edge
        across = _runs_into(contact, other)
    gain = (a + b + c) * _THIRD - wp.dot(other.n, contact.p - other.a)
    side = wp.where(across, contact.side, wp.copysign(ONE, gain))
    height = side * wp.dot(other.n, contact.o - other.a)
    if rises > own.offset and height < HALF * other.offset:
        if across:
            contact.aside += (side * (other.offset - height)) * other.n
        elif wp.abs(gain) > _THIRD * other.offset:
            contact.inwards = wp.max(contact.inwards, (other.offset - height) / wp.abs(gain))
            contact.behind = contact.behind or side != contact.side
    return contact


@wp.func
def _is_better(cosine: wp.float64, face: wp.int32, best: wp.float64, known: wp.int32) -> wp.bool:
    """Return whether a face matches a point's normal better than the best face so far; of equal ones, the first is better.

    The cosine must be at least 0. The result does not depend on the order in which faces are visited.
    """
    return cosine >= ZERO and (known < 0 or cosine > best or (cosine == best and face < known))


@wp.func
def _look_at_other(
    contacts: Contacts, contact: FaceContact, face: wp.int32, look: wp.vec3d, searching: wp.bool
) -> FaceContact:
    """Update the search for the start of a point's rays by another face, if the face touches the point."""
    facet = facet_of(contacts, face)
    if wp.dot(facet.n, facet.n) == ZERO:
        if contact.own == -1:
            contact.own = _THIN
    elif is_touching(facet, contact.p, contact.moved):
        cosine = wp.dot(facet.n, look)
        if searching and contact.after >= -1:
            if face > contact.after and wp.abs(cosine - wp.dot(contact.facet.n, look)) < ONE - _SAME:
                contact.next = wp.where(contact.next < 0, face, wp.min(contact.next, face))
        elif searching:
            contact.ahead += cosine * facet.area
            if _is_better(cosine, face, contact.best_along, contact.along):
                contact.best_along = cosine
                contact.along = face
            if _is_better(-cosine, face, contact.best_against, contact.against):
                contact.best_against = -cosine
                contact.against = face
        else:
            contact = _move_off_facet(contact, facet)
    return contact


@wp.struct
class Around:
    """Arguments of the search for the faces that touch a point.

    Attributes:
        contacts: points and faces of the scene.
        p: position of the point.
        r: largest distance of a face.
        look: direction of view.
        searching: True to search for the point's own face, False to move the start off neighbouring faces.
    """

    contacts: Contacts
    p: wp.vec3
    r: wp.float32
    look: wp.vec3d
    searching: wp.bool


@wp.func
def _look_at(face: wp.int32, around: Around, contact: FaceContact) -> FaceContact:
    """Update the search for the start of a point's rays by one nearby face; the point's own face is skipped."""
    if face != contact.own:
        contact.alone = wp.bool(False)
        contact = _look_at_other(around.contacts, contact, face, around.look, around.searching)
    return contact


_look_around = faces_touching(_look_at, Around, FaceContact)


@wp.func
def look_around(
    contacts: Contacts, tree: Accelerator, contact: FaceContact, look: wp.vec3d, searching: wp.bool, scratch: wp.uint64
) -> FaceContact:
    """Update the search for the start of a point's rays by all faces that touch the point; return the new state.

    `searching` is True to search for the point's own face, False to move the start off neighbouring faces.
    """
    extent = contacts.placement.extent
    around = Around()
    around.contacts = contacts
    around.p = wp.vec3(contact.p)
    around.r = 2.0 * _TWICE * (extent[0] + extent[1] + extent[2]) + 4.0 * contacts.placement.coarseness
    around.look = look
    around.searching = searching
    return _look_around(tree, around, contact, scratch)


@wp.func
def find_own_face(contact: FaceContact) -> wp.int32:
    """Return the number of the face on which a point lies, found by the point's normal; below 0 if there is none.

    The point's normal may be the normal of the face, the area-weighted sum of several faces' normals, or the opposite of
    either. At the tip of a spike, such a sum points against the normals of some of the faces.
    """
    along = contact.best_along > _SAME
    forward = contact.ahead >= ZERO
    if along or contact.best_against > _SAME:  # both for a floor on which the bottom of a crate lies
        forward = along
    found = wp.where(forward, contact.along, contact.against)
    return wp.where(found >= 0, found, contact.own)


@wp.func
def raise_start(contacts: Contacts, contact: FaceContact, look: wp.vec3d, known: wp.bool) -> FaceContact:
    """Move the start of a point's rays one offset above the point's own face, on the side of `look`.

    Return the new contact state.
    """
    own = contact.facet
    contact.side = wp.copysign(ONE, wp.dot(own.n, look))
    contact.inwards = ZERO
    contact.aside = NOWHERE
    contact.behind = wp.bool(False)
    height = contact.side * wp.dot(own.n, contact.p - own.a)
    away = wp.clamp(own.offset - height, ZERO, TWO * own.offset)
    way = contact.side * own.n
    steep = wp.dot(way, look)
    if not known and steep > _TENTH and away > ZERO:  # a vertex moves along its normal, which is above all its faces
        way = look
        away = wp.max(away / steep, with_normal(contacts, own, look).offset)
    contact.o = contact.p + away * way
    contact.moved = away
    return contact


@wp.func
def start_above(contacts: Contacts, p: wp.vec3d, look: wp.vec3d) -> wp.vec3:
    """Return the start of rays straight above a vertex p of a height field, or below if `look` points down.

    The start keeps x and y, which are rounded like those of the vertex in the mesh. Its height above the vertex exceeds the
    rounding of z. So it is above all faces of the vertex, even those as steep as a wall: `plane_distance` decides in
    float64.
    """
    most = wp.max(wp.abs(p[2]), wp.float64(contacts.spread[2]))
    height = wp.float64(contacts.placement.coarseness) + _RAISED * most
    return wp.vec3(wp.vec3d(p[0], p[1], p[2] + wp.copysign(height, look[2])))


@wp.func
def start_of(contacts: Contacts, contact: FaceContact, look: wp.vec3d) -> wp.vec3:
    """Return the position where a point's rays start, after the search for touching faces."""
    if contact.own == _THIN:
        towards = wp.vec3(look)
        return wp.vec3(contact.p) + origin_offset(contacts.placement, towards) * towards
    if wp.dot(contact.facet.n, contact.facet.n) == ZERO:
        return wp.vec3(contact.p)
    middle = (contact.facet.a + contact.facet.b + contact.facet.c) * _THIRD
    return wp.vec3(contact.o + wp.min(contact.inwards, HALF) * (middle - contact.p) + contact.aside)
