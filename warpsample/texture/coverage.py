"""Kernels that find which face covers each texel of an image, and where on the face the texel lies.

Lengths are in texels: the centre of the first texel is (0.5, 0.5). A texel belongs to the face with the largest key, so the
result does not depend on the order in which threads write.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import int_at
from warpsample.sequences.sobol import sobol

_ZERO = wp.constant(wp.float64(0.0))
_ONE = wp.constant(wp.float64(1.0))
_HALF = wp.constant(wp.float64(0.5))
_STRICTLY = wp.constant(wp.float64(1e-6))  # texels; smaller overlaps are rounding at a shared edge
_ASIDE = wp.constant(wp.vec2d(4.37e-4, 2.91e-4))  # texels; a centre may lie on edges of all faces that contain it
_FARTHEST = wp.constant(wp.uint64(0x7F800000))  # the bits of infinity, larger than the bits of every finite positive float32
_LAST_FACE = wp.constant(wp.uint64(0xFFFFFFFF))
_WORD = wp.constant(wp.uint64(32))

NO_FACE = 0
"""Key of a texel without a face."""


@wp.struct
class Triangle:
    """Face in the image: its corners in texels, and the inward normals of its edges.

    A point p is on the inner side of an edge where dot(normal, p - corner) >= 0. Normals have the length of their edges.
    """

    a: wp.vec2d
    b: wp.vec2d
    c: wp.vec2d
    ab: wp.vec2d
    bc: wp.vec2d
    ca: wp.vec2d


@wp.func
def _inward_normal(start: wp.vec2d, end: wp.vec2d, turn: wp.float64) -> wp.vec2d:
    """Return the normal of an edge that points to the triangle's inside, with the length of the edge."""
    d = end - start
    return wp.vec2d(-turn * d[1], turn * d[0])


@wp.func
def read_triangle(corners: wp.uint64, face: wp.int32) -> Triangle:
    """Return one face, with either winding, of the array `corners` (F, 3, 2) float64."""
    view = wp.array(ptr=corners + wp.uint64(face) * wp.uint64(48), shape=(3,), dtype=wp.vec2d)
    t = Triangle()
    t.a = view[0]
    t.b = view[1]
    t.c = view[2]
    u = t.b - t.a
    v = t.c - t.a
    turn = wp.where(u[0] * v[1] - u[1] * v[0] < _ZERO, -_ONE, _ONE)
    t.ab = _inward_normal(t.a, t.b, turn)
    t.bc = _inward_normal(t.b, t.c, turn)
    t.ca = _inward_normal(t.c, t.a, turn)
    return t


@wp.func
def edge_values(t: Triangle, p: wp.vec2d) -> wp.vec3d:
    """Return the signed distances of p from the edges opposite a, b and c, times the edge lengths; positive inside."""
    return wp.vec3d(wp.dot(t.bc, p - t.b), wp.dot(t.ca, p - t.c), wp.dot(t.ab, p - t.a))


@wp.func
def _smallest(e: wp.vec3d) -> wp.float64:
    """Return the smallest of three components."""
    return wp.min(e[0], wp.min(e[1], e[2]))


@wp.func
def _is_near(e: wp.vec3d, t: Triangle, half: wp.float64) -> wp.bool:
    """Return whether a triangle may overlap the square of half width `half` around a point; e are the edge values there.

    `e` is `edge_values` at the point. The caller has already compared bounding boxes.
    """
    return (
        e[0] + half * (wp.abs(t.bc[0]) + wp.abs(t.bc[1])) > _ZERO
        and e[1] + half * (wp.abs(t.ca[0]) + wp.abs(t.ca[1])) > _ZERO
        and e[2] + half * (wp.abs(t.ab[0]) + wp.abs(t.ab[1])) > _ZERO
    )


@wp.func
def _is_strictly_inside(e: wp.vec3d, t: Triangle) -> wp.bool:
    """Return whether a point is inside a triangle by more than a rounding error; e are the point's edge values."""
    return e[0] > _STRICTLY * wp.length(t.bc) and e[1] > _STRICTLY * wp.length(t.ca) and e[2] > _STRICTLY * wp.length(t.ab)


@wp.func
def _project_on_edge(start: wp.vec2d, end: wp.vec2d, p: wp.vec2d) -> wp.float64:
    """Return the position, from 0 at `start` to 1 at `end`, of the edge's point nearest to p."""
    d = end - start
    length = wp.dot(d, d)
    if length == _ZERO:
        return _ZERO
    return wp.clamp(wp.dot(p - start, d) / length, _ZERO, _ONE)


@wp.func
def _squared_distance(start: wp.vec2d, end: wp.vec2d, s: wp.float64, p: wp.vec2d) -> wp.float64:
    """Return the squared distance between p and the point start + s * (end - start)."""
    d = start + s * (end - start) - p
    return wp.dot(d, d)


@wp.func
def find_nearest(t: Triangle, e: wp.vec3d, p: wp.vec2d) -> wp.vec4d:
    """Return the triangle's point nearest to p, as barycentric weights of a, b and c, and its squared distance from p."""
    if _smallest(e) >= _ZERO:
        sum = e[0] + e[1] + e[2]
        return wp.vec4d(e[0] / sum, e[1] / sum, e[2] / sum, _ZERO)
    s = _project_on_edge(t.a, t.b, p)
    found = wp.vec4d(_ONE - s, s, _ZERO, _squared_distance(t.a, t.b, s, p))
    s = _project_on_edge(t.b, t.c, p)
    squared = _squared_distance(t.b, t.c, s, p)
    if squared < found[3]:
        found = wp.vec4d(_ZERO, _ONE - s, s, squared)
    s = _project_on_edge(t.c, t.a, p)
    squared = _squared_distance(t.c, t.a, s, p)
    if squared < found[3]:
        found = wp.vec4d(s, _ZERO, _ONE - s, squared)
    return found


@wp.func
def _claim_key(squared: wp.float64, face: wp.int32) -> wp.uint64:
    """Return a 64-bit key of a face's claim to a texel; the largest key is that of the nearest face. Never 0."""
    near = _FARTHEST - wp.uint64(wp.cast(wp.float32(squared), wp.uint32))
    return (near << _WORD) | (_LAST_FACE - wp.uint64(face))


@wp.func
def sample_at(seed: wp.uint64, texel: wp.int32, width: wp.int32, sample: wp.int32, samples: wp.int32) -> wp.vec2d:
    """Return the position of a sample: the texel's centre, or one of `samples` stratified positions in the texel."""
    corner = wp.vec2d(wp.float64(texel % width), wp.float64(texel / width))
    if samples == 1:
        return corner + wp.vec2d(_HALF, _HALF)
    u = sobol(seed, wp.uint64(texel), wp.uint32(sample), wp.uint32(samples))
    return corner + wp.vec2d(wp.float64(u[0]), wp.float64(u[1]))


@once
def claim_texels() -> wp.Kernel:
    """Build the kernel that assigns faces to the texels of an image, and counts the faces that overlap at a texel.

    Samples, which are positions within a texel, get faces, too.

    Each task covers some image rows of one face's bounding box. The kernel's arguments are addresses of arrays:

    - `corners` (F, 3, 2) float64: corners of the faces in texels;
    - `boxes` (F, 4) int32: first column, end column, first row and end row, with ends excluded;
    - `tasks` (T, 2) int32: face and first row;
    - `nearest` (texels,) uint64, 0 on input: the largest key of the faces that a bilinear lookup reads the texel for;
    - `owners` (texels, samples) uint32, 0 on input: F minus the lowest face that contains the sample; unused with one
    sample;
    - `centre_counts` (texels,) int32, 0 on input: number of faces that contain a point very near the texel's centre.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def claim_texels(
        corners: wp.uint64,
        boxes: wp.uint64,
        tasks: wp.uint64,
        rows: wp.int32,
        width: wp.int32,
        height: wp.int32,
        samples: wp.int32,
        faces: wp.int32,
        seed: wp.uint64,
        nearest: wp.uint64,
        owners: wp.uint64,
        centre_counts: wp.uint64,
        first_task: wp.int64,
    ):
        task = first_task + wp.int64(wp.tid())
        face = int_at(tasks, task * wp.int64(2))
        first = int_at(tasks, task * wp.int64(2) + wp.int64(1))
        texels = width * height
        keys = wp.array(ptr=nearest, shape=(texels,), dtype=wp.uint64)
        counts = wp.array(ptr=centre_counts, shape=(texels,), dtype=wp.int32)
        owner_keys = wp.array(ptr=owners, shape=(texels * samples,), dtype=wp.uint32)
        t = read_triangle(corners, face)
        left = int_at(boxes, wp.int64(4) * wp.int64(face))
        right = int_at(boxes, wp.int64(4) * wp.int64(face) + wp.int64(1))
        last = int_at(boxes, wp.int64(4) * wp.int64(face) + wp.int64(3))
        for y in range(first, wp.min(first + rows, last)):
            for x in range(left, right):
                texel = y * width + x
                p = wp.vec2d(wp.float64(x) + _HALF, wp.float64(y) + _HALF)
                e = edge_values(t, p)
                if _is_near(e, t, _ONE):
                    found = find_nearest(t, e, p)
                    wp.atomic_max(keys, texel, _claim_key(found[3], face))
                    if _is_strictly_inside(edge_values(t, p + _ASIDE), t):
                        wp.atomic_add(counts, texel, 1)
                    if samples > 1 and _is_near(e, t, _HALF):
                        for k in range(samples):
                            if _smallest(edge_values(t, sample_at(seed, texel, width, k, samples))) >= _ZERO:
                                wp.atomic_max(owner_keys, texel * samples + k, wp.uint32(faces - face))

    return claim_texels


@once
def mark_overlaps() -> wp.Kernel:
    """Build the kernel that marks all faces that overlap another face at the centre of a texel.

    Tasks are those of `claim_texels`; `marks` (F,) int32 becomes 1 for each marked face.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def mark_overlaps(
        corners: wp.uint64,
        boxes: wp.uint64,
        tasks: wp.uint64,
        rows: wp.int32,
        width: wp.int32,
        centre_counts: wp.uint64,
        marks: wp.uint64,
        first_task: wp.int64,
    ):
        task = first_task + wp.int64(wp.tid())
        face = int_at(tasks, task * wp.int64(2))
        first = int_at(tasks, task * wp.int64(2) + wp.int64(1))
        t = read_triangle(corners, face)
        left = int_at(boxes, wp.int64(4) * wp.int64(face))
        right = int_at(boxes, wp.int64(4) * wp.int64(face) + wp.int64(1))
        last = int_at(boxes, wp.int64(4) * wp.int64(face) + wp.int64(3))
        found = wp.int32(0)
        for y in range(first, wp.min(first + rows, last)):
            for x in range(left, right):
                if int_at(centre_counts, y * width + x) > 1:
                    p = wp.vec2d(wp.float64(x) + _HALF, wp.float64(y) + _HALF)
                    if _is_strictly_inside(edge_values(t, p + _ASIDE), t):
                        found = wp.int32(1)
        if found == 1:
            view = wp.array(ptr=marks + wp.uint64(face) * wp.uint64(4), shape=(1,), dtype=wp.int32)
            view[0] = 1

    return mark_overlaps


@once
def weigh_corners() -> wp.Kernel:
    """Build the kernel that computes the barycentric weights, (P, 3) float64, of points in texels on their faces.

    A point's id is texel * samples + sample.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def weigh_corners(
        corners: wp.uint64,
        ids: wp.uint64,
        faces: wp.uint64,
        width: wp.int32,
        samples: wp.int32,
        seed: wp.uint64,
        weights: wp.uint64,
        first_task: wp.int64,
    ):
        i = first_task + wp.int64(wp.tid())
        id = wp.array(ptr=ids + wp.uint64(i) * wp.uint64(8), shape=(1,), dtype=wp.uint64)[0]
        texel = wp.int32(id / wp.uint64(samples))
        p = sample_at(seed, texel, width, wp.int32(id % wp.uint64(samples)), samples)
        t = read_triangle(corners, int_at(faces, i))
        found = find_nearest(t, edge_values(t, p), p)
        view = wp.array(ptr=weights + wp.uint64(i) * wp.uint64(24), shape=(1,), dtype=wp.vec3d)
        view[0] = wp.vec3d(found[0], found[1], found[2])

    return weigh_corners
