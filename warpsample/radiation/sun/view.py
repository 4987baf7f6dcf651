"""The arguments of the suns' kernel, and one point as it sees the suns: what it knows, and memory to work in."""

import warp as wp

from warpsample.maths.memory import int_at, set_int
from warpsample.tracing.placement import Placement
from warpsample.tracing.queries import Glass
from warpsample.tracing.sight.leaves import OWN_LEAF_FLOATS
from warpsample.tracing.sight.point import ShadingPoint

KNOWN, NEXT, PROVEN, REMEMBERED, CAST = range(5)
"""Words of a point: known triangles in their leaf, and where the next one goes; suns found lit by a shaft; rays that a known
triangle blocked; rays cast."""

WORDS = 5

OWN_FLOATS = 16 * -(-(OWN_LEAF_FLOATS + WORDS) // 16)
"""float32 numbers that a point needs: a leaf of triangles that blocked rays of it, and the words."""

_WORDS_BYTES = wp.constant(wp.uint64(4 * OWN_LEAF_FLOATS))


@wp.struct
class Suns:
    """Scalars and addresses of points, of a `SunTree` and of where the answers go.

    placement: of the points; its starts are for both sides of its normals, those of the faces.
    normals, active: (P, 3) float32, (P,) uint8 or 0: of the points.
    count, nodes: suns and nodes of the tree. directions: (count, 3), as the caller gave them.
    vertices, faces: of the scene.
    sine, one_minus_cos: of the disc's radius.
    weights: (count, channels) float64 or 0. cosine: whether they are multiplied by it.
    answer: (P, count) uint8 or float32, or (P, channels) float64; all 0.
    tally: (P, 3) int32 or 0: the last three words of the points. glass: the faces that let some light through, if any.
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
    """A shading point, with what it knows of the suns.

    local: mask of the triangles of its local leaf. skips: whether anything may be proven. known: address of the leaf of
    triangles that blocked rays of the point. words: address of its words.
    """

    point: ShadingPoint
    local: wp.int32
    skips: wp.bool
    known: wp.uint64
    words: wp.uint64


@wp.func
def view_of(point: ShadingPoint) -> View:
    """A point that knows nothing yet."""
    view = View()
    view.point = point
    view.known = point.own
    view.words = point.own + _WORDS_BYTES
    return view


@wp.func
def word(view: View, i: wp.int32) -> wp.int32:
    """One of the point's words."""
    return int_at(view.words, i)


@wp.func
def add(view: View, i: wp.int32, more: wp.int32):
    """Adds to one of the point's words."""
    set_int(view.words, i, word(view, i) + more)


@wp.func
def known_triangles(view: View) -> wp.int32:
    """Mask of the known triangles."""
    return (1 << word(view, KNOWN)) - 1


@wp.func
def cosine_to(n: wp.vec3, d: wp.vec3) -> wp.float64:
    """The cosine between two float32 unit vectors, without rounding the products."""
    x = wp.float64(n[0]) * wp.float64(d[0])
    y = wp.float64(n[1]) * wp.float64(d[1])
    return x + y + wp.float64(n[2]) * wp.float64(d[2])
