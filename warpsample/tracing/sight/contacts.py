"""Search for the faces that touch a surface point, and choice of the position where the point's rays start."""

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.tracing.placement import OFFSET, origin_offset
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.face_contact import ALIKE, SAME, FaceContact, move_off_facet
from warpsample.tracing.sight.facets import NOWHERE, Contacts, facet_of, is_touching, with_normal
from warpsample.tracing.sight.touching import faces_touching

_TWICE = wp.constant(wp.float32(2.0 * OFFSET))
_THIRD = wp.constant(wp.float64(1.0 / 3.0))
_RAISED = wp.constant(wp.float64(OFFSET))
_TENTH = wp.constant(wp.float64(0.1))
_EXACT = wp.constant(wp.float64(1.0 - 2.0**-34))  # least cosine between normals of one face, before and after rounding
_THIN = wp.constant(wp.int32(-2))  # face number of a point that lies only on faces too thin to have a normal


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
        if searching:
            cosine = wp.dot(facet.n, look)
            contact.ahead += cosine * facet.area
            if _is_better(cosine, face, contact.best_along, contact.along):
                contact.best_along = cosine
                contact.along = face
            if _is_better(-cosine, face, contact.best_against, contact.against):
                contact.best_against = -cosine
                contact.against = face
        else:
            contact = move_off_facet(contact, facet)
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
def around_of(contacts: Contacts, p: wp.vec3d, look: wp.vec3d, searching: wp.bool) -> Around:
    """Return the arguments of a search for the faces that touch a point."""
    extent = contacts.placement.extent
    around = Around()
    around.contacts = contacts
    around.p = wp.vec3(p)
    around.r = 2.0 * _TWICE * (extent[0] + extent[1] + extent[2]) + 4.0 * contacts.placement.coarseness
    around.look = look
    around.searching = searching
    return around


@wp.func
def look_around(
    contacts: Contacts, tree: Accelerator, contact: FaceContact, look: wp.vec3d, searching: wp.bool, scratch: wp.uint64
) -> FaceContact:
    """Update the search for the start of a point's rays by all faces that touch the point; return the new state.

    `searching` is True to search for the point's own face, False to move the start off neighbouring faces.
    """
    return _look_around(tree, around_of(contacts, contact.p, look, searching), contact, scratch)


@wp.func
def find_own_face(contact: FaceContact) -> wp.int32:
    """Return the number of the face on which a point lies, found by the point's normal; below 0 if there is none.

    The point's normal may be the normal of the face, the area-weighted sum of several faces' normals, or the opposite of
    either. At the tip of a spike, such a sum points against the normals of some of the faces. Faces of other bodies, such as
    a high wall, may touch the point, too; a face that is nearly across the normal then counts more than their areas.
    """
    along = contact.best_along > wp.where(contact.best_along > contact.best_against, ALIKE, SAME)
    forward = contact.ahead >= ZERO
    if along or contact.best_against > SAME:  # both for a floor on which the bottom of a crate lies
        forward = along
    found = wp.where(forward, contact.along, contact.against)
    return wp.where(found >= 0, found, contact.own)


@wp.func
def has_exact_normal(contact: FaceContact, look: wp.vec3d) -> wp.bool:
    """Return whether a point's normal is that of a face, and no mean of several, after the search for its own face."""
    return wp.max(contact.best_along, contact.best_against) > _EXACT * wp.length(look)


@wp.struct
class NextFace:
    """State of the search for another face that may be a vertex's own.

    Attributes:
        p: position of the point.
        own: number of the face that was tried last.
        moved: distance by which the start is off that face.
        first: normal of the own face that was found first; the other face must be like it.
        least: smallest cosine between these two normals.
        after: number that the other face's number must exceed; -2 before the first search.
        face: smallest such number; -1 if there is none.
    """

    p: wp.vec3d
    own: wp.int32
    moved: wp.float64
    first: wp.vec3d
    least: wp.float64
    after: wp.int32
    face: wp.int32


@wp.func
def _look_for_next(face: wp.int32, around: Around, found: NextFace) -> NextFace:
    """Update the search for another own face by one nearby face."""
    if face > found.after and face != found.own and (found.face < 0 or face < found.face):
        facet = facet_of(around.contacts, face)
        if wp.dot(facet.n, found.first) > found.least and is_touching(facet, found.p, found.moved):
            found.face = face
    return found


_look_for_next_face = faces_touching(_look_for_next, Around, NextFace)


@wp.func
def find_next_face(
    contacts: Contacts, tree: Accelerator, contact: FaceContact, last: NextFace, exact: wp.bool, scratch: wp.uint64
) -> NextFace:
    """Find the next face that touches a point and is like the own face that was found first.

    If the point's normal is `exact`, as on the rim of an attic's floor, both must be in one plane.
    """
    found = last
    if last.after < -1:
        found.p = contact.p
        found.first = contact.facet.n
        found.least = wp.where(exact, SAME, ALIKE)
    found.after = wp.where(last.after < -1, -1, contact.own)
    found.own = contact.own
    found.moved = contact.moved
    found.face = -1
    return _look_for_next_face(tree, around_of(contacts, contact.p, found.first, True), found, scratch)


@wp.func
def raise_start(contacts: Contacts, contact: FaceContact, look: wp.vec3d, known: wp.bool) -> FaceContact:
    """Move the start of a point's rays one offset above the point's own face, on the side of `look`.

    Return the new contact state.
    """
    own = contact.facet
    contact.side = wp.copysign(ONE, wp.dot(own.n, look))
    contact.lift = ZERO
    contact.inwards = ZERO
    contact.aside = NOWHERE
    contact.several = wp.bool(False)
    contact.in_corner = wp.bool(False)
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
def move_along(contact: FaceContact) -> wp.vec3d:
    """Return the move of the start along the own face: towards its centre, and aside."""
    middle = (contact.facet.a + contact.facet.b + contact.facet.c) * _THIRD
    return wp.min(contact.inwards, HALF) * (middle - contact.p) + contact.aside


@wp.func
def start_of(contacts: Contacts, contact: FaceContact, look: wp.vec3d) -> wp.vec3:
    """Return the position where a point's rays start, after the search for touching faces."""
    if contact.own == _THIN:
        towards = wp.vec3(look)
        return wp.vec3(contact.p) + origin_offset(contacts.placement, towards) * towards
    if wp.dot(contact.facet.n, contact.facet.n) == ZERO:
        return wp.vec3(contact.p)
    lift = contact.lift * wp.normalize(contact.o - contact.p)
    return wp.vec3(contact.o + lift + move_along(contact))
