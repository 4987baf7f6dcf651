"""Data structures of the kernel of `direct_sun`: its argument, and its state for one point."""

import warp as wp

from warpsample.maths.memory import int_at, set_int
from warpsample.tracing.placement import Placement
from warpsample.tracing.queries import Glass
from warpsample.tracing.sight.leaves import OWN_LEAF_FLOATS
from warpsample.tracing.sight.point import ShadingPoint

KNOWN, NEXT, PROVEN, REMEMBERED, CAST = range(5)
"""Indices of a point's counters: remembered triangles, lane for the next one, suns that a shaft proves lit, rays that a
remembered triangle blocked, and rays cast."""

WORDS = 5

OWN_FLOATS = 16 * -(-(OWN_LEAF_FLOATS + WORDS) // 16)
"""Number of float32 values of working memory per point: a leaf of remembered triangles, and the counters."""

_WORDS_BYTES = wp.constant(wp.uint64(4 * OWN_LEAF_FLOATS))


@wp.struct
class Suns:
    """Kernel argument of the sun test: scalars, and addresses of the points, a `SunTree` and the results.

    placement: placement of the points, whose rays may start on either side of the face. normals, active: (P, 3) float32,
    (P,) uint8 or 0. count, nodes: numbers of suns and of nodes of the tree. directions: (count, 3), the caller's array.
    vertices, faces: arrays of the scene. sine, one_minus_cos: functions of the disc's angular radius. weights: (count,
    channels) float64 or 0. cosine: 1 to multiply the weights by the cosine, else 0. answer: (P, count) uint8 or float32, or
    (P, channels) float64; zeros at the start. tally: (P, 3) int32 or 0, for the last three counters of each point. glass:
    transmitting faces, if any.
    """

    placement: Placement
    seed: wp.uint64
    first_point: wp.uint64
    normals: wp.uint64
    active: wp.uint64
    skip: wp.int32
    count: wp.int32
    nodes: wp.int32
    directions: wp.uint64
    double_directions: wp.int32
    groups: wp.uint64
    columns: wp.uint64
    spans: wp.uint64
    shafts: wp.uint64
    disc_shafts: wp.uint64
    vertices: wp.uint64
    faces: wp.uint64
    sine: wp.float64
    one_minus_cos: wp.float32
    weights: wp.uint64
    channels: wp.int32
    cosine: wp.int32
    answer: wp.uint64
    tally: wp.uint64
    glass: Glass


SunsArgs = type(Suns().__ctype__())


@wp.struct
class View:
    """Point at which `direct_sun` tests which suns are visible, with addresses of the point's working memory and counters.

    local: mask of the triangles of the point's local leaf. skips: whether rays may be skipped. blockers: address of the leaf
    of triangles that blocked rays of the point. words: address of the point's counters.
    """

    point: ShadingPoint
    local: wp.int32
    skips: wp.bool
    blockers: wp.uint64
    words: wp.uint64


@wp.func
def view_of(point: ShadingPoint) -> View:
    """Return the initial state of a point for the test of suns, with an empty list of blockers."""
    view = View()
    view.point = point
    view.blockers = point.own
    view.words = point.own + _WORDS_BYTES
    return view


@wp.func
def word(view: View, i: wp.int32) -> wp.int32:
    """Return the value of counter number i of a point; `CAST`, for example, is the counter of rays cast."""
    return int_at(view.words, i)


@wp.func
def add(view: View, i: wp.int32, more: wp.int32):
    """Increase counter number i of a point by `more`; see `word`."""
    set_int(view.words, i, word(view, i) + more)


@wp.func
def blocker_mask(view: View) -> wp.int32:
    """Return a bit mask of the triangles in a point's list of blockers, which have blocked earlier rays."""
    return (1 << word(view, KNOWN)) - 1


@wp.func
def cosine_to(n: wp.vec3, d: wp.vec3) -> wp.float64:
    """Return the float64 dot product of two float32 unit vectors; the products are exact."""
    x = wp.float64(n[0]) * wp.float64(d[0])
    y = wp.float64(n[1]) * wp.float64(d[1])
    return x + y + wp.float64(n[2]) * wp.float64(d[2])
