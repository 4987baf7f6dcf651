"""Arguments of the functions that trace one ray: the search structure, and a buffer of prepared rays.

A chunk consists of rows of float32, with one column per ray. The address of its column identifies a ray.
"""

import warp as wp

from warpsample.maths.memory import float_at

CHUNK = 64
"""Number of rays in a chunk, which are prepared together: columns of the rows of float32."""

ORIGIN, DIRECTION, REACH, AHEAD, PREPARED = (row * CHUNK for row in (0, 3, 6, 7, 8))
"""Float offsets of rows: origin (3), unit direction (3), reach, distance travelled before the origin, the tracer's rows."""

CHUNK_FLOATS = PREPARED + 18 * CHUNK


@wp.struct
class Accelerator:
    """Search structure as a kernel argument: addresses of a tree's nodes and leaves, or the id of a wp.Mesh.

    Queries start from `starts` consecutive nodes at the address `start`. With starts = 0, rays hit nothing.
    """

    nodes: wp.uint64
    leaves: wp.uint64
    mesh: wp.uint64
    start: wp.uint64
    starts: wp.int32


AcceleratorArgs = type(Accelerator().__ctype__())


@wp.struct
class Glass:
    """Translucent faces as a kernel argument: their search tree, and the address of all faces' transmittances.

    The transmittances are (F,) float32.
    """

    tree: Accelerator
    transmittance: wp.uint64


GlassArgs = type(Glass().__ctype__())


@wp.func
def column_of(chunk: wp.uint64, k: wp.int32) -> wp.uint64:
    """Return the address of the k-th ray in a buffer of rays; each ray is a column."""
    return chunk + wp.uint64(4 * k)


@wp.func
def vector_in(column: wp.uint64, row: wp.int32) -> wp.vec3:
    """Return one vector of a prepared ray, for example its origin: three numbers from `row` on in the ray's column."""
    return wp.vec3(float_at(column, row), float_at(column, row + CHUNK), float_at(column, row + 2 * CHUNK))


@wp.func
def direction_of(chunk: wp.uint64, k: wp.int32) -> wp.vec3:
    """Return the unit direction of the k-th ray in a buffer of rays."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    return wp.vec3(rows[DIRECTION + k], rows[DIRECTION + CHUNK + k], rows[DIRECTION + 2 * CHUNK + k])


@wp.func
def set_direction(chunk: wp.uint64, k: wp.int32, d: wp.vec3):
    """Write the direction of the k-th ray in a buffer of rays."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    rows[DIRECTION + k] = d[0]
    rows[DIRECTION + CHUNK + k] = d[1]
    rows[DIRECTION + 2 * CHUNK + k] = d[2]


@wp.func
def set_origin(chunk: wp.uint64, k: wp.int32, o: wp.vec3):
    """Write the origin of the k-th ray in a buffer of rays."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    rows[ORIGIN + k] = o[0]
    rows[ORIGIN + CHUNK + k] = o[1]
    rows[ORIGIN + 2 * CHUNK + k] = o[2]


@wp.func
def start_all(chunk: wp.uint64, o: wp.vec3, reach: wp.float32):
    """Set the origin and the largest hit distance of all rays in a buffer of rays."""
    rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < CHUNK:
        set_origin(chunk, k, o)
        rows[REACH + k] = reach
        k += 1
