"""The arguments of the suns' kernel, and one point as it sees the suns: its rays, and memory to work in."""

import warp as wp

from warpsample.maths.memory import int_at
from warpsample.tracing.placement import Placement
from warpsample.tracing.wide.layout import LEAF_BYTES

KNOWN_FLOATS = LEAF_BYTES // 4 + 1
"""A leaf of triangles that blocked rays of the point, and their longest side along an axis."""

KNOWN, NEXT, PROVEN, REMEMBERED, CAST = range(5)
"""Words of a point: triangles in that leaf, and where the next one goes; suns found lit by a beam; rays that a known
triangle blocked; rays cast."""

WORDS = 5


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
    tally: (P, 3) int32 or 0: the last three words of the points.
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
    beams: wp.uint64
    disc_beams: wp.uint64
    vertices: wp.uint64
    faces: wp.uint64
    sine: wp.float64
    one_minus_cos: wp.float32
    weights: wp.uint64
    channels: wp.int32
    cosine: wp.int32
    answer: wp.uint64
    tally: wp.uint64


SunsArgs = type(Suns().__ctype__())


@wp.struct
class View:
    """A point.

    The key of its random numbers (where suns are discs), unit normal, place, origin of its rays, what is lower is below the
    horizon, reach; mask of the triangles around it; whether anything may be proven; and addresses of memory to work in.
    """

    point: wp.int64
    key: wp.vec4ui
    n: wp.vec3
    place: wp.vec3d
    o: wp.vec3
    low: wp.float32
    reach: wp.float32
    near: wp.int32
    skips: wp.bool
    chunk: wp.uint64
    room: wp.uint64
    beam: wp.uint64
    scratch: wp.uint64
    known: wp.uint64
    words: wp.uint64


@wp.func
def word(view: View, i: wp.int32) -> wp.int32:
    """One of the point's words."""
    return int_at(view.words, i)


@wp.func
def add(view: View, i: wp.int32, more: wp.int32):
    """Adds to one of the point's words."""
    words = wp.array(ptr=view.words, shape=(WORDS,), dtype=wp.int32)
    words[i] = words[i] + more


@wp.func
def known_triangles(view: View) -> wp.int32:
    """Mask of the known triangles."""
    return (1 << word(view, KNOWN)) - 1


@wp.func
def cosine_to(n: wp.vec3, d: wp.vec3) -> wp.float64:
    """Of two float32 unit vectors, without rounding the products."""
    x = wp.float64(n[0]) * wp.float64(d[0])
    y = wp.float64(n[1]) * wp.float64(d[1])
    return x + y + wp.float64(n[2]) * wp.float64(d[2])
