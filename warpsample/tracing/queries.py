"""What a tracer's query is given: the addresses of a tree or a mesh, and a chunk of rays, prepared side by side.

A chunk is rows of float32, a column for each ray; the address of its column stands for a ray.
"""

import warp as wp

from warpsample.maths.memory import float_at

CHUNK = 64
"""Rays that are prepared together: columns of rows of float32."""

ORIGIN, DIRECTION, REACH, AHEAD, PREPARED = (row * CHUNK for row in (0, 3, 6, 7, 8))
"""Where rows start: origin and unit direction, 3 each; reach; how far the ray came before its origin; the tracer's own."""

CHUNK_FLOATS = PREPARED + 18 * CHUNK


@wp.struct
class Accelerator:
    """Addresses of a tree's nodes and leaves, or the id of a wp.Mesh.

    Queries start from `starts` nodes, a few, from the address `start` on; without any, nothing is met.
    """

    nodes: wp.uint64
    leaves: wp.uint64
    mesh: wp.uint64
    start: wp.uint64
    starts: wp.int32


AcceleratorArgs = type(Accelerator().__ctype__())


@wp.struct
class Glass:
    """The tree of the faces that let some light through, and the address of the transmittances of all faces, float32."""

    tree: Accelerator
    transmittance: wp.uint64


GlassArgs = type(Glass().__ctype__())


@wp.func
def column_of(chunk: wp.uint64, k: wp.int32) -> wp.uint64:
    """The address of the k-th ray's column."""
    return chunk + wp.uint64(4 * k)


@wp.func
def vector_in(column: wp.uint64, row: wp.int32) -> wp.vec3:
    """What is in a ray's column in three rows from one on."""
    return wp.vec3(float_at(column, row), float_at(column, row + CHUNK), float_at(column, row + 2 * CHUNK))


@wp.func
def direction_of(chunk: wp.uint64, k: wp.int32) -> wp.vec3:
    """The direction of the k-th ray."""
    return vector_in(column_of(chunk, k), DIRECTION)


@wp.func
def set_direction(chunk: wp.uint64, k: wp.int32, d: wp.vec3):
    """Writes the direction of the k-th ray."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    rows[DIRECTION + k] = d[0]
    rows[DIRECTION + CHUNK + k] = d[1]
    rows[DIRECTION + 2 * CHUNK + k] = d[2]


@wp.func
def set_origin(chunk: wp.uint64, k: wp.int32, o: wp.vec3):
    """Writes the origin of the k-th ray."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    rows[ORIGIN + k] = o[0]
    rows[ORIGIN + CHUNK + k] = o[1]
    rows[ORIGIN + 2 * CHUNK + k] = o[2]


@wp.func
def start_all(chunk: wp.uint64, o: wp.vec3, reach: wp.float32):
    """Lets all rays of a chunk start from one origin."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < CHUNK:
        set_origin(chunk, k, o)
        rows[REACH + k] = reach
        k += 1
