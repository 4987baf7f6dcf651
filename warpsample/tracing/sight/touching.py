"""Search for the faces that touch a point; it may find a few more faces, but misses none."""

from typing import Any

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import greater, lesser, lowest_bit
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.wide.lanes import lanes_with
from warpsample.tracing.wide.layout import LINKS, NODE_BYTES, WIDTH, corner, face_in, size_of
from warpsample.tracing.wide.walk import tree_walk

_ROUNDING = wp.constant(wp.float32(2.0**-18))
_NODE_FLOATS = NODE_BYTES // 4


@wp.func
def _children_around(node: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:
    """Return a mask of a tree node's children whose boxes are within the distance r of a point p along each axis."""
    rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    links = wp.array(ptr=node + wp.uint64(4 * LINKS), shape=(WIDTH,), dtype=wp.int32)
    near = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    k = wp.int32(0)
    while k < WIDTH:
        x = wp.where(rows[k] <= p[0] + r, 1, 0) & wp.where(rows[3 * WIDTH + k] >= p[0] - r, 1, 0)
        y = wp.where(rows[WIDTH + k] <= p[1] + r, 1, 0) & wp.where(rows[4 * WIDTH + k] >= p[1] - r, 1, 0)
        z = wp.where(rows[2 * WIDTH + k] <= p[2] + r, 1, 0) & wp.where(rows[5 * WIDTH + k] >= p[2] - r, 1, 0)
        near[k] = x & y & z & wp.where(links[k] != 0, 1, 0)
        k += 1
    return lanes_with(near.ptr, 0)


@wp.func
def _is_near_zero(a: wp.float32, b: wp.float32, c: wp.float32, r: wp.float32) -> wp.int32:
    """Return 1 if the interval from the smallest to the largest of a, b and c comes within r of 0, else 0."""
    return wp.where(lesser(lesser(a, b), c) <= r, 1, 0) & wp.where(greater(greater(a, b), c) >= -r, 1, 0)


@wp.func
def _triangles_near_point(leaf: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:
    """Return a mask of a tree leaf's triangles that may be within the distance r of a point p."""
    touched = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    k = wp.int32(0)
    while k < WIDTH:
        a = corner(leaf, 0, k, p)
        b = corner(leaf, 3, k, p)
        c = corner(leaf, 6, k, p)
        near = _is_near_zero(a[0], b[0], c[0], r) & _is_near_zero(a[1], b[1], c[1], r) & _is_near_zero(a[2], b[2], c[2], r)
        n = wp.cross(b - a, c - a)
        far = greater(greater(size_of(a), size_of(b)), size_of(c))
        # A component of the normal is rounded by 2^-23 of two edges, each within 2 far; then come products and sums.
        rounding = _ROUNDING * far * far
        beside = (r * size_of(n) + rounding * far) * far * 4.0
        near = near & wp.where(wp.abs(wp.dot(n, a)) <= r * size_of(n) + rounding * far, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(a, b)) >= -beside, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(b, c)) >= -beside, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(c, a)) >= -beside, 1, 0)
        touched[k] = near
        k += 1
    return lanes_with(touched.ptr, 0)


@once
def faces_touching(look: wp.Function, query_type: Any, answer_type: Any) -> wp.Function:
    """Build a Warp function that calls `look` for each face that touches a point and returns the answer.

    Its arguments are (tree, query, answer, scratch). It also calls `look` for a few faces close to the point.

    Args:
        look: function (face, query, answer) -> answer.
        query_type: type of the query, a struct with the fields `p`, vec3, the point, and `r`, the largest distance of a
            face.
        answer_type: type of the answer.
    """

    @wp.func
    def enter(node: wp.uint64, query: query_type):
        return _children_around(node, query.p, query.r)

    @wp.func
    def look_into(leaf: wp.uint64, query: query_type, answer: answer_type):
        touched = _triangles_near_point(leaf, query.p, query.r)
        for _ in range(wp.bit_count(touched)):
            answer = look(face_in(leaf, lowest_bit(touched)), query, answer)
            touched = touched & (touched - 1)
        return answer, wp.bool(False)

    walk = tree_walk(enter, look_into, query_type, answer_type)

    @wp.func
    def look_around(tree: Accelerator, query: query_type, answer: answer_type, scratch: wp.uint64):
        answer, _spent = walk(tree, query, answer, 0, scratch)
        return answer

    return look_around
