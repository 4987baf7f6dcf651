"""The corners of the triangles of a leaf."""

import warp as wp

from warpsample.maths.numerics import fma, greater
from warpsample.tracing.wide.layout import LEAF_BYTES, WIDTH

_LEAF_FLOATS = LEAF_BYTES // 4


@wp.func
def highest_corner(leaf: wp.uint64, k: wp.int32, nx: wp.float32, ny: wp.float32, nz: wp.float32) -> wp.float32:
    """How far the corners of a leaf's k-th triangle reach along a vector."""
    rows = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    a = fma(rows[k], nx, fma(rows[WIDTH + k], ny, rows[2 * WIDTH + k] * nz))
    b = fma(rows[3 * WIDTH + k], nx, fma(rows[4 * WIDTH + k], ny, rows[5 * WIDTH + k] * nz))
    c = fma(rows[6 * WIDTH + k], nx, fma(rows[7 * WIDTH + k], ny, rows[8 * WIDTH + k] * nz))
    return greater(greater(a, b), c)


@wp.func
def size_of(v: wp.vec3) -> wp.float32:
    """The sum of a vector's components, in magnitude: at least its length."""
    return wp.abs(v[0]) + wp.abs(v[1]) + wp.abs(v[2])


@wp.func
def corner(leaf: wp.uint64, first_row: wp.int32, k: wp.int32, o: wp.vec3) -> wp.vec3:
    """A corner of a leaf's k-th triangle, seen from the origin: so that it is rounded by a share of its distance."""
    rows = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    at = first_row * WIDTH + k
    return wp.vec3(rows[at] - o[0], rows[at + WIDTH] - o[1], rows[at + 2 * WIDTH] - o[2])
