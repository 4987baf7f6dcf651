"""Memory layout of the tree's nodes and leaves, and of the working memory of a query.

Each row holds sixteen float32, which fill one AVX-512 register or two AVX2 registers.

- A node has eight rows: the children's lower x, y, z and upper x, y, z, their links, and their edges. A link is the number
  of a node, ~number of a leaf (below 0), or 0 for no child. An edge is the longest extent of a leaf's triangles along an
  axis.
- A leaf has ten rows: x, y, z of its triangles' first, second and third corners, and the face numbers. Empty lanes hold NaN
  and face number -1.
"""

import warp as wp

from warpsample.maths.memory import float_at, int_at
from warpsample.maths.numerics import fma, greater
from warpsample.tracing.queries import Accelerator

WIDTH = 16
"""Number of children of a node, and of triangles in a leaf."""

NODE_BYTES = 8 * WIDTH * 4
LEAF_BYTES = 10 * WIDTH * 4
_LEAF_FLOATS = LEAF_BYTES // 4

LINKS, EDGES, FACES = 6 * WIDTH, 7 * WIDTH, 9 * WIDTH
"""Float offsets of rows: links and edges in a node, face numbers in a leaf."""

MOST_DEPTH = 24
"""Largest number of nodes on a path from the root to a leaf; `build` guarantees this limit."""

SCRATCH = 4 * (MOST_DEPTH + 3)
"""Number of int32 words that a query needs for its stack of waiting nodes."""

MOST_STARTS = 4
"""Largest number of nodes from which the rays of a point start."""


@wp.func
def node_at(accelerator: Accelerator, i: wp.int32) -> wp.uint64:
    """Return the memory address of the tree's i-th node."""
    return accelerator.nodes + wp.uint64(i) * wp.uint64(NODE_BYTES)


@wp.func
def leaf_at(accelerator: Accelerator, i: wp.int32) -> wp.uint64:
    """Return the memory address of the tree's i-th leaf."""
    return accelerator.leaves + wp.uint64(i) * wp.uint64(LEAF_BYTES)


@wp.func
def link_in(node: wp.uint64, k: wp.int32) -> wp.int32:
    """Return the link to a node's k-th child: a node number, ~number of a leaf, or 0 for no child."""
    return int_at(node, LINKS + k)


@wp.func
def edge_in(node: wp.uint64, k: wp.int32) -> wp.float32:
    """Return the longest extent, along an axis, of the triangles in the leaf that is a tree node's k-th child."""
    return float_at(node, EDGES + k)


@wp.func
def face_in(leaf: wp.uint64, k: wp.int32) -> wp.int32:
    """Return the face number of the k-th triangle of a leaf."""
    return int_at(leaf, FACES + k)


@wp.func
def highest_corner(leaf: wp.uint64, k: wp.int32, nx: wp.float32, ny: wp.float32, nz: wp.float32) -> wp.float32:
    """Return the largest dot product of the vector (nx, ny, nz) with the corners of a triangle."""
    rows = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    a = fma(rows[k], nx, fma(rows[WIDTH + k], ny, rows[2 * WIDTH + k] * nz))
    b = fma(rows[3 * WIDTH + k], nx, fma(rows[4 * WIDTH + k], ny, rows[5 * WIDTH + k] * nz))
    c = fma(rows[6 * WIDTH + k], nx, fma(rows[7 * WIDTH + k], ny, rows[8 * WIDTH + k] * nz))
    return greater(greater(a, b), c)


@wp.func
def size_of(v: wp.vec3) -> wp.float32:
    """Return the sum of the absolute components of a vector, an upper bound on the vector's length."""
    return wp.abs(v[0]) + wp.abs(v[1]) + wp.abs(v[2])


@wp.func
def corner(leaf: wp.uint64, first_row: wp.int32, k: wp.int32, o: wp.vec3) -> wp.vec3:
    """Return a corner of the k-th triangle of a leaf, relative to the point o.

    The rounding error is relative to the distance between the two.
    """
    rows = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    at = first_row * WIDTH + k
    return wp.vec3(rows[at] - o[0], rows[at + WIDTH] - o[1], rows[at + 2 * WIDTH] - o[2])
