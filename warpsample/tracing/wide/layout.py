"""How a tree and the scratch space of a query lie in memory.

Rows of sixteen float32 fill one AVX-512 register or two of AVX2:

- a node is eight: the children's lower x, y, z, upper x, y, z, their links (below 0 to a leaf, ~link; 0 none), and the
  longest side, along an axis, of the triangles in a leaf;
- a leaf is ten: x, y, z of its triangles' first corners, of the second, of the third, and the faces' numbers; where there
  is no triangle, NaN and -1.
"""

import warp as wp

from warpsample.maths.memory import float_at, int_at
from warpsample.maths.numerics import fma, greater
from warpsample.tracing.queries import Accelerator

WIDTH = 16
"""Children of a node, triangles of a leaf."""

NODE_BYTES = 8 * WIDTH * 4
LEAF_BYTES = 10 * WIDTH * 4
_LEAF_FLOATS = LEAF_BYTES // 4

LINKS, EDGES, FACES = 6 * WIDTH, 7 * WIDTH, 9 * WIDTH
"""Where rows start: of links and of longest sides in a node, of faces' numbers in a leaf."""

MOST_DEPTH = 24
"""Nodes from the root to a leaf, at most; `build` keeps to it."""

SCRATCH = 4 * (MOST_DEPTH + 3)
"""int32 words that a query needs: nodes that wait."""

MOST_STARTS = 4
"""Nodes that the rays of a point start from."""


@wp.func
def node_at(accelerator: Accelerator, i: wp.int32) -> wp.uint64:
    """The address of the i-th node."""
    return accelerator.nodes + wp.uint64(i) * wp.uint64(NODE_BYTES)


@wp.func
def leaf_at(accelerator: Accelerator, i: wp.int32) -> wp.uint64:
    """The address of the i-th leaf."""
    return accelerator.leaves + wp.uint64(i) * wp.uint64(LEAF_BYTES)


@wp.func
def link_in(node: wp.uint64, k: wp.int32) -> wp.int32:
    """Where a node's k-th child is: the number of a node, or ~ that of a leaf; 0 if there is none."""
    return int_at(node, LINKS + k)


@wp.func
def edge_in(node: wp.uint64, k: wp.int32) -> wp.float32:
    """The longest side, along an axis, of the triangles in a node's k-th child, a leaf."""
    return float_at(node, EDGES + k)


@wp.func
def face_in(leaf: wp.uint64, k: wp.int32) -> wp.int32:
    """The number of the face that a leaf's k-th triangle is."""
    return int_at(leaf, FACES + k)


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
