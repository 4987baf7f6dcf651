"""A leaf of a point's own: triangles that many of its rays meet, copied together, and the longest side of theirs."""

import warp as wp

from warpsample.maths.memory import float_at, set_float
from warpsample.maths.numerics import greater
from warpsample.tracing.wide.layout import LEAF_BYTES, WIDTH
from warpsample.tracing.wide.prepare import ray_in
from warpsample.tracing.wide.query import any_of, nearest_of

TRIANGLES = WIDTH
"""How many triangles a leaf has room for."""

OWN_LEAF_FLOATS = LEAF_BYTES // 4 + 1
"""Floats of such a leaf."""

_LONGEST = LEAF_BYTES // 4


@wp.func
def clear_leaf(leaf: wp.uint64):
    """Makes a leaf one without triangles: none of its lanes is asked for."""
    set_float(leaf, _LONGEST, 0.0)


@wp.func
def lengthen(leaf: wp.uint64, edge: wp.float32):
    """Tells a leaf that a side of its triangles may be so long, seen along an axis."""
    set_float(leaf, _LONGEST, greater(float_at(leaf, _LONGEST), edge))


@wp.func
def copy_triangle(source: wp.uint64, k: wp.int32, leaf: wp.uint64, lane: wp.int32):
    """Copies the k-th triangle of a leaf of the tree."""
    for row in range(10):
        set_float(leaf, row * WIDTH + lane, float_at(source, row * WIDTH + k))


@wp.func
def keep_triangle(leaf: wp.uint64, lane: wp.int32, a: wp.vec3, b: wp.vec3, c: wp.vec3):
    """Keeps a triangle, without the number of its face."""
    for axis in range(3):
        set_float(leaf, axis * WIDTH + lane, a[axis])
        set_float(leaf, (3 + axis) * WIDTH + lane, b[axis])
        set_float(leaf, (6 + axis) * WIDTH + lane, c[axis])
    lengthen(leaf, wp.max(wp.max(wp.max(a, b), c) - wp.min(wp.min(a, b), c)))


@wp.func
def any_in_leaf(leaf: wp.uint64, triangles: wp.int32, column: wp.uint64, reach: wp.float32) -> wp.int32:
    """The lane of some triangle of a mask that a prepared ray meets; -1 if it meets none."""
    _reach, lane = any_of(leaf, triangles, ray_in(column), reach, float_at(leaf, _LONGEST))
    return lane


@wp.func
def nearest_in_leaf(leaf: wp.uint64, triangles: wp.int32, column: wp.uint64, reach: wp.float32):
    """(distance, lane) of the nearest triangle of a mask that a prepared ray meets; (reach, -1) if it meets none."""
    distance, lane = nearest_of(leaf, triangles, ray_in(column), reach, float_at(leaf, _LONGEST))
    return distance, lane
