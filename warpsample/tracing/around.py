"""Which triangles of the tree may touch a point: a few too many, never one too few."""

import warp as wp

from warpsample.maths.numerics import greater, lesser
from warpsample.tracing.wide.corners import corner, size_of
from warpsample.tracing.wide.layout import LEAF_BYTES, NODE_BYTES, WIDTH

_ROUNDING = wp.constant(wp.float32(2.0**-18))
_PLACES = wp.constant(wp.uint64(6 * WIDTH * 4))
_NODE_FLOATS = NODE_BYTES // 4
_LEAF_FLOATS = LEAF_BYTES // 4


@wp.func
def children_around(node: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:
    """Mask of the children whose boxes are as near to a point as r along each axis."""
    rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)
    places = wp.array(ptr=node + _PLACES, shape=(WIDTH,), dtype=wp.int32)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        x = wp.where(rows[k] <= p[0] + r, 1, 0) & wp.where(rows[3 * WIDTH + k] >= p[0] - r, 1, 0)
        y = wp.where(rows[WIDTH + k] <= p[1] + r, 1, 0) & wp.where(rows[4 * WIDTH + k] >= p[1] - r, 1, 0)
        z = wp.where(rows[2 * WIDTH + k] <= p[2] + r, 1, 0) & wp.where(rows[5 * WIDTH + k] >= p[2] - r, 1, 0)
        mask = mask | ((x & y & z & wp.where(places[k] != 0, 1, 0)) << k)
        k += 1
    return mask


@wp.func
def _beside(rows: wp.array[wp.float32], k: wp.int32, x: wp.float32, r: wp.float32) -> wp.int32:
    """1 where a coordinate is between those of a triangle's corners, or as near to them as r."""
    a = rows[k]
    b = rows[3 * WIDTH + k]
    c = rows[6 * WIDTH + k]
    return wp.where(lesser(lesser(a, b), c) <= x + r, 1, 0) & wp.where(greater(greater(a, b), c) >= x - r, 1, 0)


@wp.func
def triangles_touched(leaf: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:
    """Mask of the triangles that may be as near to a point as r: a few too many, never one too few."""
    xs = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    ys = wp.array(ptr=leaf + wp.uint64(4 * WIDTH), shape=(_LEAF_FLOATS,), dtype=wp.float32)
    zs = wp.array(ptr=leaf + wp.uint64(8 * WIDTH), shape=(_LEAF_FLOATS,), dtype=wp.float32)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        near = _beside(xs, k, p[0], r) & _beside(ys, k, p[1], r) & _beside(zs, k, p[2], r)
        a = corner(leaf, 0, k, p)
        b = corner(leaf, 3, k, p)
        c = corner(leaf, 6, k, p)
        n = wp.cross(b - a, c - a)
        far = greater(greater(size_of(a), size_of(b)), size_of(c))
        # A component of the normal is rounded by 2^-23 of two edges, each within 2 far; then come products and sums.
        rounding = _ROUNDING * far * far
        beside = (r * size_of(n) + rounding * far) * far * 4.0
        near = near & wp.where(wp.abs(wp.dot(n, a)) <= r * size_of(n) + rounding * far, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(a, b)) >= -beside, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(b, c)) >= -beside, 1, 0)
        near = near & wp.where(wp.dot(n, wp.cross(c, a)) >= -beside, 1, 0)
        mask = mask | (near << k)
        k += 1
    return mask
