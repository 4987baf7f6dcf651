"""Position where a surface point's rays start between walls that stand on the point's face."""

from math import pi

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.contacts import Around, around_of, move_along
from warpsample.tracing.sight.face_contact import ALIKE, FaceContact, is_passed, rises
from warpsample.tracing.sight.facets import NOWHERE, Contacts, Facet, facet_of, inward_distance, is_touching
from warpsample.tracing.sight.touching import faces_touching

_LEVEL = wp.constant(wp.float64(1e-3))  # sine of the angle between faces, below which they are no wall and floor
_TIE = wp.constant(wp.float64(1e-4))  # difference of cosines of feet at one place
_WAYS = wp.constant(wp.int32(64))  # ways that are tried
_TURN = wp.constant(wp.float64(2.0 * pi / 64.0))
_NARROW = wp.constant(wp.float64(0.05))  # sine of the angle between a way and the nearest wall
_ACROSS = wp.constant(wp.float64(0.1))  # cosine between the axis of crossed cards and a way across it


@wp.struct
class Foot:
    """Nearest foot of a wall on one side of a direction between walls.

    Attributes:
        nearest: cosine of the angle between the direction and the foot; -2 if there is none.
        is_free: whether the direction is in front of the walls on this foot.
    """

    nearest: wp.float64
    is_free: wp.bool


@wp.func
def _no_foot() -> Foot:
    """Return what is known before a foot has been found on one side of a direction."""
    foot = Foot()
    foot.nearest = -TWO
    foot.is_free = wp.bool(True)
    return foot


@wp.struct
class Way:
    """Direction along a point's own face, between walls that stand on the face at the point.

    Attributes:
        p: position of the point.
        own: number of its face.
        facet: its face.
        side: 1 if the point looks from the front of its face, else -1.
        moved: distance by which the start is off the face.
        way: unit vector along the face.
        is_on: whether `way` leads along the own face, or along another face that is like it.
        is_covered: whether `way` leads behind another face that is like the own face, such as the roof of an attic.
        left: nearest foot of a wall to the left of `way`, as seen from the front of the own face.
        right: nearest foot to the right.
        far: distance from the walls by which the start is off all of them.
    """

    p: wp.vec3d
    own: wp.int32
    facet: Facet
    side: wp.float64
    moved: wp.float64
    way: wp.vec3d
    is_on: wp.bool
    is_covered: wp.bool
    left: Foot
    right: Foot
    far: wp.float64


@wp.func
def _nearer(foot: Foot, cosine: wp.float64, is_front: wp.bool) -> Foot:
    """Update the nearest foot on one side of a direction; of feet at one place, one can have its front elsewhere."""
    if cosine > foot.nearest - _TIE:
        foot.is_free = is_front and (foot.is_free or cosine > foot.nearest + _TIE)
        foot.nearest = wp.max(foot.nearest, cosine)
    return foot


@wp.func
def _look_along(between: Way, other: Facet) -> Way:
    """Update a direction between walls by another face: the nearest foot of a wall on either side.

    A foot is where a wall meets the plane of the own face. It leads away from the point in one direction, or in two. In a
    high wall, triangles that touch the point can be narrow at the foot, so only the first bit of the foot is looked at.
    """
    p = between.p
    slack = between.facet.slack
    is_higher = rises(between.facet, between.side, other)
    is_front = between.side * wp.dot(between.way, other.n) > ZERO
    alike = wp.dot(between.facet.n, other.n)
    if wp.abs(alike) > ALIKE and is_passed(between.facet, p, between.way, other):
        between.is_on = between.is_on or not is_higher
        between.is_covered = between.is_covered or (is_higher and not is_front)
    foot = wp.cross(between.facet.n, other.n)
    upright = wp.length(foot)
    step = (TWO * slack / wp.max(upright, _LEVEL)) * foot
    for _way in range(2):
        if upright > _LEVEL and is_higher and inward_distance(other, other.n, p + step) > -HALF * HALF * slack:
            cosine = wp.dot(between.way, step) / wp.length(step)
            if wp.dot(wp.cross(between.way, step), between.facet.n) > ZERO:
                between.left = _nearer(between.left, cosine, is_front)
            else:
                between.right = _nearer(between.right, cosine, is_front)
            lean = wp.max(-alike, ZERO) * between.moved
            between.far = wp.max(between.far, (other.offset + lean) / upright)
        step = -step
    return between


@wp.func
def _look_between(face: wp.int32, around: Around, between: Way) -> Way:
    """Update a direction between walls by one nearby face; the point's own face is skipped."""
    if face != between.own:
        facet = facet_of(around.contacts, face)
        if wp.dot(facet.n, facet.n) > ZERO and is_touching(facet, between.p, between.moved):
            between = _look_along(between, facet)
    return between


_look_between_walls = faces_touching(_look_between, Around, Way)


@wp.func
def stand_between_walls(
    contacts: Contacts, tree: Accelerator, contact: FaceContact, exact: wp.bool, scratch: wp.uint64
) -> FaceContact:
    """Move the start of a point's rays aside to where it is off all walls that stand on its own face at the point.

    The sum of the moves off each wall is too short where they lead in nearly opposite directions. Then a way along the face
    is sought that is in front of the nearest walls on both sides, and as far from them as possible; if the point's normal is
    `exact`, it is on the own face or a face like it, and not under one. If there is none, as on the axis of crossed cards,
    some of which show their backs, a way across the axis will do.
    """
    move = move_along(contact)
    move -= wp.dot(move, contact.facet.n) * contact.facet.n
    length = wp.length(move)
    least = ONE
    across = NOWHERE
    x = wp.normalize(contact.facet.b - contact.facet.a)
    y = wp.cross(contact.facet.n, x)
    between = Way()
    between.p = contact.p
    between.own = contact.own
    between.facet = contact.facet
    between.side = contact.side
    between.moved = contact.moved
    around = around_of(contacts, contact.p, x, False)
    for k in range(_WAYS + 1):
        angle = wp.float64(k) * _TURN
        between.way = wp.cos(angle) * x + wp.sin(angle) * y
        if k == 0 and length > ZERO:
            between.way = move / length
        between.is_on = is_passed(contact.facet, contact.p, between.way, contact.facet)
        between.is_covered = wp.bool(False)
        between.left = _no_foot()
        between.right = _no_foot()
        between.far = ZERO
        between = _look_between_walls(tree, around, between, scratch)
        nearest = wp.max(between.left.nearest, between.right.nearest)
        sine = wp.where(nearest > ZERO, wp.sqrt(wp.max(ONE - nearest * nearest, ZERO)), ONE)
        is_free = between.left.is_free and between.right.is_free
        is_free = is_free and not (exact and (between.is_covered or not between.is_on))
        if is_free and k == 0 and length * sine > HALF * between.far:
            least = -TWO  # the sum will do
            break
        if is_free and nearest < least and sine > _NARROW:
            least = nearest
            contact.inwards = ZERO
            contact.aside = (between.far / sine) * between.way
        elif between.is_on and wp.max(wp.abs(between.left.nearest), wp.abs(between.right.nearest)) < _ACROSS:
            across = (TWO * between.far) * between.way
    if least == ONE and wp.dot(across, across) > ZERO:
        contact.inwards = ZERO
        contact.aside = across
    return contact
