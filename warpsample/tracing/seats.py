"""The seat of a point among the faces that touch it, and where its rays start from there (see `starts`)."""

import warp as wp

from warpsample.maths.numerics import HALF, ONE, TWO, ZERO
from warpsample.tracing.facets import NOWHERE, Facet, Seats, facet_of, touches, with_normal, within
from warpsample.tracing.placement import LIFT, lift
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.touching import faces_touching

_TWICE = wp.constant(wp.float32(2.0 * LIFT))
_THIRD = wp.constant(wp.float64(1.0 / 3.0))
_TENTH = wp.constant(wp.float64(0.1))
_SAME = wp.constant(wp.float64(1.0 - 2.0**-20))  # cosine of two normals that are one, rounded to float32
_THIN = wp.constant(wp.int32(-2))  # the face of a point that lies on none but those without a normal


@wp.struct
class Seat:
    """Where a point sits.

    p: its place. own: its face, below 0 if none is known. facet: that. side: 1 where it looks from the front, else -1.
    alone: whether no other face is near it. o: a lift above its face. moved: how far from p. inwards: how far the start
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
def _settled(seat: Seat, other: Facet) -> Seat:
    """The seat, brought to its own side of another facet that touches the point."""
    own = seat.facet
    up = seat.side * own.n
    rises = wp.max(wp.max(wp.dot(up, other.a - own.a), wp.dot(up, other.b - own.a)), wp.dot(up, other.c - own.a))
    a = wp.dot(other.n, own.a - other.a)
    b = wp.dot(other.n, own.b - other.a)
    c = wp.dot(other.n, own.c - other.a)
    across = wp.max(wp.max(a, b), c) > other.lift and wp.min(wp.min(a, b), c) < -other.lift
    across = across and within(own, seat.p) > own.slack  # and not at an edge of its face
    gain = (a + b + c) * _THIRD - wp.dot(other.n, seat.p - other.a)
    side = wp.where(across, seat.side, wp.copysign(ONE, gain))
    height = side * wp.dot(other.n, seat.o - other.a)
    if rises > own.lift and height < HALF * other.lift:
        if across:
            seat.aside += (side * (other.lift - height)) * other.n
        elif wp.abs(gain) > _THIRD * other.lift:
            seat.inwards = wp.max(seat.inwards, (other.lift - height) / wp.abs(gain))
    return seat


@wp.func
def _better(cosine: wp.float64, face: wp.int32, best: wp.float64, known: wp.int32) -> wp.bool:
    """Whether a face is to be preferred to the one known; of equal ones the first, in whichever order they are looked at."""
    return cosine >= ZERO and (known < 0 or cosine > best or (cosine == best and face < known))


@wp.func
def _look_at_other(seats: Seats, seat: Seat, face: wp.int32, look: wp.vec3d, searching: wp.bool) -> Seat:
    """The seat after a look at another face that may touch the point: as its own, or else as one beside it."""
    facet = facet_of(seats, face)
    if wp.dot(facet.n, facet.n) == ZERO:
        if seat.own == -1:
            seat.own = _THIN
    elif touches(facet, seat.p, seat.moved):
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


@wp.struct
class Around:
    """What is asked of the faces around a point: where it is, how near they are, the direction in which it looks.

    searching: whether the face that the point is of is searched for, else those beside it are looked at.
    """

    seats: Seats
    p: wp.vec3
    r: wp.float32
    look: wp.vec3d
    searching: wp.bool


@wp.func
def _look_at(face: wp.int32, around: Around, seat: Seat) -> Seat:
    """The seat after a look at a face that may touch the point."""
    if face != seat.own:
        seat.alone = wp.bool(False)
        seat = _look_at_other(around.seats, seat, face, around.look, around.searching)
    return seat


_look_around = faces_touching(_look_at, Around, Seat)


@wp.func
def look_around(seats: Seats, tree: Accelerator, seat: Seat, look: wp.vec3d, searching: wp.bool, scratch: wp.uint64) -> Seat:
    """The seat after a look at all faces that touch the point."""
    extent = seats.placement.extent_x + seats.placement.extent_y + seats.placement.extent_z
    around = Around()
    around.seats = seats
    around.p = wp.vec3(seat.p)
    around.r = 2.0 * _TWICE * extent + 4.0 * seats.placement.coarseness
    around.look = look
    around.searching = searching
    return _look_around(tree, around, seat, scratch)


@wp.func
def own_face(seat: Seat) -> wp.int32:
    """The face that a point is of, found by its normal: that of the face, or the sum of several by area, or the opposite.

    The sum at the tip of a spike is against some of the faces that it is of. Below 0 if there is none.
    """
    along = seat.best_along > _SAME
    against = seat.best_against > _SAME
    forward = seat.ahead >= ZERO
    if along != against:
        forward = along
    found = wp.where(forward, seat.along, seat.against)
    return wp.where(found >= 0, found, seat.own)


@wp.func
def sitting(seats: Seats, seat: Seat, look: wp.vec3d, known: wp.bool) -> Seat:
    """The seat a lift above its face, to the side to which the point looks."""
    own = seat.facet
    seat.side = wp.copysign(ONE, wp.dot(own.n, look))
    seat.inwards = ZERO
    seat.aside = NOWHERE
    height = seat.side * wp.dot(own.n, seat.p - own.a)
    away = wp.clamp(own.lift - height, ZERO, TWO * own.lift)
    way = seat.side * own.n
    steep = wp.dot(way, look)
    if not known and steep > _TENTH and away > ZERO:  # a vertex: along its normal, above all faces if none is in the way
        way = look
        away = wp.max(away / steep, with_normal(seats, own, look).lift)
    seat.o = seat.p + away * way
    seat.moved = away
    return seat


@wp.func
def start_of(seats: Seats, seat: Seat, look: wp.vec3d) -> wp.vec3:
    """Where the rays of a seat start: where it is, if it is on no face."""
    if seat.own == _THIN:
        towards = wp.vec3(look)
        return wp.vec3(seat.p) + lift(seats.placement, towards) * towards
    if wp.dot(seat.facet.n, seat.facet.n) == ZERO:
        return wp.vec3(seat.p)
    middle = (seat.facet.a + seat.facet.b + seat.facet.c) * _THIRD
    return wp.vec3(seat.o + wp.min(seat.inwards, HALF) * (middle - seat.p) + seat.aside)
