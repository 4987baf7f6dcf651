"""A surface point's contact with its own face, and moves of the start of its rays off another face."""

import warp as wp

from warpsample.maths.numerics import HALF, ONE, ZERO
from warpsample.tracing.sight.facets import Facet, inward_distance

_STEP = wp.constant(wp.float64(16.0))  # slacks from a point to where faces next to it are told apart, from 1 degree on
_ABOVE = wp.constant(wp.float64(0.25))  # sine of the angle of a vertex's normal above a face, from which a lift will do
_EIGHTH = wp.constant(wp.float64(0.125))
_THIRD = wp.constant(wp.float64(1.0 / 3.0))
ALIKE: wp.float64 = wp.constant(wp.float64(0.5))
"""Cosine between faces that hide each other from no point straight above them, as in a terrain."""

SAME: wp.float64 = wp.constant(wp.float64(1.0 - 2.0**-20))
"""Least cosine between equal normals that are rounded to float32."""


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
        lift: further move of the start in the direction from p to o.
        inwards: move of the start towards the centre of the face, as a fraction of the way.
        aside: displacement of the start off faces that cross the own face.
        along: face with the greatest cosine, among cosines of at least 0; -1 if none.
        best_along: that cosine.
        against: face with the smallest cosine, among cosines of at most 0; -1 if none.
        best_against: that cosine, negated.
        ahead: sum over all touching faces of cosine times twice the area.
        behind: whether the own face is behind another one, like the floor inside a box that stands on it.
        several: whether walls of several directions stand on the own face at the point.
        in_corner: whether the own face ends at the point, at another face that rises above it.
    """

    p: wp.vec3d
    own: wp.int32
    facet: Facet
    side: wp.float64
    alone: wp.bool
    o: wp.vec3d
    moved: wp.float64
    lift: wp.float64
    inwards: wp.float64
    aside: wp.vec3d
    along: wp.int32
    best_along: wp.float64
    against: wp.int32
    best_against: wp.float64
    ahead: wp.float64
    behind: wp.bool
    several: wp.bool
    in_corner: wp.bool


@wp.func
def rises(own: Facet, side: wp.float64, other: Facet) -> wp.bool:
    """Return whether another face rises above a point's own face, on the side from which the point looks."""
    up = side * own.n
    height = wp.max(wp.max(wp.dot(up, other.a - own.a), wp.dot(up, other.b - own.a)), wp.dot(up, other.c - own.a))
    return height > own.offset


@wp.func
def _runs_into(contact: FaceContact, other: Facet) -> wp.bool:
    """Return whether another face crosses a point's own face next to the point, which is at an edge of its own face.

    So do walls whose foot runs on through the point, but not faces that meet the own face at the edge. A foot that is seen
    16 slacks away can be nearly along the edge; one that is seen 2 slacks away can belong to a narrow bit of a high wall.
    """
    own = contact.facet
    along = wp.cross(own.n, other.n)
    upright = wp.length(along)
    step = (_STEP * own.slack / upright) * along
    found = wp.bool(False)
    for k in range(4):
        q = contact.p + step
        inwards = inward_distance(own, own.n, q) - inward_distance(own, own.n, contact.p)
        beside = wp.where(k < 2, other.slack + contact.moved, HALF * HALF * own.slack)
        is_on_foot = inward_distance(other, other.n, q) >= -beside and (k < 2 or upright > HALF)
        found = found or (inwards > HALF * HALF * own.slack and is_on_foot)
        step *= wp.where(k == 1, -_EIGHTH, -ONE)
    return found


@wp.func
def is_passed(own: Facet, p: wp.vec3d, way: wp.vec3d, other: Facet) -> wp.bool:
    """Return whether a way from a point p along its own face leads over or under another face, or on it, next to the point.

    `way` is a unit vector.
    """
    n = wp.copysign(ONE, wp.dot(own.n, other.n)) * own.n
    return inward_distance(other, n, p + _STEP * own.slack * way) >= ZERO


@wp.func
def move_off_facet(contact: FaceContact, other: Facet) -> FaceContact:
    """Move the start of a point's rays to the visible side of another face that touches the point, if needed.

    The start point ends in front of a facet that crosses the point's own face, and else on the same side of the facet as the
    centre of the own face. No move is needed off a facet that is not steep as seen from the own face, and does not lie over
    it, since the start is straight above the point; the start of a vertex is only lifted further along the vertex's normal.
    """
    own = contact.facet
    a = wp.dot(other.n, own.a - other.a)
    b = wp.dot(other.n, own.b - other.a)
    c = wp.dot(other.n, own.c - other.a)
    across = wp.max(wp.max(a, b), c) > other.offset and wp.min(wp.min(a, b), c) < -other.offset
    if across and inward_distance(own, own.n, contact.p) <= own.slack:  # the point is at an edge
        across = _runs_into(contact, other)
    gain = (a + b + c) * _THIRD - wp.dot(other.n, contact.p - other.a)
    side = wp.where(across, contact.side, wp.copysign(ONE, gain))
    ahead = wp.dot(other.n, contact.o - other.a)
    height = side * ahead
    front = contact.side * ahead
    alike = wp.dot(own.n, other.n)
    enough = wp.where(across, ONE, HALF) * other.offset
    is_higher = rises(own, contact.side, other)
    contact.in_corner = contact.in_corner or (is_higher and not across)
    if is_higher and (height < enough or side != contact.side):
        is_under = is_passed(own, contact.p, wp.normalize((own.a + own.b + own.c) * _THIRD - contact.p), other)
        rise = contact.side * wp.normalize(contact.o - contact.p)
        steep = wp.dot(rise, other.n)
        if across:
            way = side * other.n
            if alike < ZERO:  # a move along the normal of a wall that leans over would end behind the own face
                way = (side / (ONE - alike * alike)) * (other.n - alike * own.n)
            is_same = wp.dot(contact.aside, way) >= SAME * wp.length(contact.aside) * wp.length(way)
            contact.several = contact.several or not is_same
            contact.aside += (other.offset - height) * way
        elif not (is_under and alike > ZERO) and steep > _ABOVE and wp.dot(rise, own.n) < SAME:
            if front < enough:
                contact.lift = wp.max(contact.lift, (other.offset - front) / steep)
        elif wp.abs(gain) > _THIRD * other.offset and (alike < ALIKE or front < enough or is_under):
            if height < enough:
                contact.inwards = wp.max(contact.inwards, (other.offset - height) / wp.abs(gain))
            contact.behind = contact.behind or side != contact.side
    return contact
