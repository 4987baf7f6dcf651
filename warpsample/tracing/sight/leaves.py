"""List of triangles near one point, which many of the point's rays may hit; it is tested before the search tree."""

import warp as wp

from warpsample.maths.memory import float_at, set_float
from warpsample.maths.numerics import greater
from warpsample.tracing.wide.layout import LEAF_BYTES, WIDTH
from warpsample.tracing.wide.prepare import ray_in
from warpsample.tracing.wide.query import any_triangle, nearest_triangle

TRIANGLES = WIDTH
"""Largest number of triangles in a leaf."""

OWN_LEAF_FLOATS = LEAF_BYTES // 4 + 1
"""Number of float32 in the leaf of a point."""

_LONGEST = LEAF_BYTES // 4


@wp.func
def clear_leaf(leaf: wp.uint64):
    """Empty a point's list of nearby triangles.

    The triangles stay, but the caller does not use their lanes.
    """
    set_float(leaf, _LONGEST, 0.0)


@wp.func
def raise_extent(leaf: wp.uint64, edge: wp.float32):
    """Record that a point's list of nearby triangles has a triangle with an extent of `edge` along an axis."""
    set_float(leaf, _LONGEST, greater(float_at(leaf, _LONGEST), edge))


@wp.func
def copy_triangle(source: wp.uint64, k: wp.int32, leaf: wp.uint64, lane: wp.int32):
    """Copy the k-th triangle of a tree leaf to a place in a point's list of nearby triangles."""
    for row in range(10):
        set_float(leaf, row * WIDTH + lane, float_at(source, row * WIDTH + k))


@wp.func
def store_triangle(leaf: wp.uint64, lane: wp.int32, a: wp.vec3, b: wp.vec3, c: wp.vec3):
    """Store a triangle with corners a, b and c at a place in a point's list of nearby triangles."""
    for axis in range(3):
        set_float(leaf, axis * WIDTH + lane, a[axis])
        set_float(leaf, (3 + axis) * WIDTH + lane, b[axis])
        set_float(leaf, (6 + axis) * WIDTH + lane, c[axis])
    raise_extent(leaf, wp.max(wp.max(wp.max(a, b), c) - wp.min(wp.min(a, b), c)))


@wp.func
def any_in_leaf(leaf: wp.uint64, triangles: wp.int32, column: wp.uint64, reach: wp.float32) -> wp.int32:
    """Return the place of any triangle that a ray hits in a point's list of nearby triangles; -1 without a hit."""
    _reach, lane = any_triangle(leaf, triangles, ray_in(column), reach, float_at(leaf, _LONGEST))
    return lane


@wp.func
def nearest_in_leaf(leaf: wp.uint64, triangles: wp.int32, column: wp.uint64, reach: wp.float32):
    """Return (distance, place) of the nearest triangle that a ray hits in a point's list of nearby triangles.

    The result is (reach, -1) if the ray hits none.
    """
    distance, lane = nearest_triangle(leaf, triangles, ray_in(column), reach, float_at(leaf, _LONGEST))
    return distance, lane
