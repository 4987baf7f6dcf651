"""Kernel that places random points on a mesh, uniformly by area."""

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import philox4x32_10

BLOCK = 64
"""Number of points per task on the CPU."""

_SURFACE_STREAM = wp.constant(wp.uint32(1))  # fourth counter word of Philox; directions use 0
_WORD_STEP = wp.constant(wp.float64(2.0**-32))


def guide_to(sums: np.ndarray, points: int) -> np.ndarray:
    """Return a lookup table that speeds up the search for the face at a fraction of the total area (Chen1974).

    The table has (2^b + 1,) int32 entries. A fraction between i / 2^b and (i + 1) / 2^b of the total area falls on a face
    from guide[i] to guide[i + 1]. Few `points` get a small table.

    Args:
        sums: (F,) float64 cumulative areas; the last one is above 0.
        points: Number of points to place.
    """
    size = 1 << max(0, min(len(sums).bit_length() + 1, points.bit_length() - 3))
    bounds = np.arange(size + 1) / size * sums[-1]  # rounded as the kernel rounds
    return np.minimum(np.searchsorted(sums, bounds, side="right"), len(sums) - 1).astype(np.int32)


@once
def _drawer(block: int) -> wp.Function:
    """Build a Warp function that draws random numbers for a block of points.

    For each point the function draws an area below the total, its entry in the lookup table, and two random words.
    """

    @wp.func
    def draw(
        seed: wp.uint64,
        first: wp.uint64,
        length: wp.int32,
        total: wp.float64,
        guide_bits: wp.int32,
        shares: wp.array[wp.float64],
        buckets: wp.array[wp.uint32],
        words: wp.array[wp.uint32],
    ):
        k = wp.int32(0)
        while k < length:
            id = first + wp.uint64(k)
            counter = wp.vec4ui(wp.uint32(0), low_word(id), high_word(id), _SURFACE_STREAM)
            bits = philox4x32_10(counter, low_word(seed), high_word(seed))
            shares[k] = (wp.float64(bits[0]) + wp.float64(bits[1]) * _WORD_STEP) * _WORD_STEP * total
            buckets[k] = wp.uint32(wp.uint64(bits[0]) >> wp.uint64(32 - guide_bits))
            words[k] = bits[2]
            words[block + k] = bits[3]
            k += 1

    return draw


@wp.func
def _face_of(share: wp.float64, areas: wp.array[wp.float64], low: wp.int32, high: wp.int32) -> wp.int32:
    """Return the first face from `low` to `high` whose cumulative area exceeds `share`, by bisection."""
    while low < high:
        middle = (low + high) / 2
        if areas[middle] > share:
            high = middle
        else:
            low = middle + 1
    return low


@wp.func
def _weights_of(first: wp.uint32, second: wp.uint32) -> wp.vec3d:
    """Map two random words to the barycentric coordinates of a point that is uniform by area in a triangle."""
    root = wp.sqrt((wp.float64(first) + wp.float64(0.5)) * _WORD_STEP)
    split = (wp.float64(second) + wp.float64(0.5)) * _WORD_STEP
    return wp.vec3d(wp.float64(1.0) - root, root * (wp.float64(1.0) - split), root * split)


@once
def place_points(block: int) -> wp.Kernel:
    """Build a kernel that places `block` points per task; Philox gives 64 bits for the face and 64 bits for the point in it.

    A task draws all its random numbers first, then looks up all faces, then places all points. So the memory accesses of
    many points overlap.
    """
    draw, words_size = _drawer(block), 2 * block

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def place_points(
        seed: wp.uint64,
        first_point: wp.uint64,
        points: wp.int32,
        vertex_count: wp.int32,
        last_face: wp.int32,
        vertices: wp.uint64,
        faces: wp.uint64,
        cumulative: wp.uint64,
        guide: wp.uint64,
        guide_bits: wp.int32,
        normals: wp.uint64,
        position: wp.uint64,
        normal: wp.uint64,
        face: wp.uint64,
        barycentric: wp.uint64,
        first_task: wp.int64,
    ):
        """Sample one block of random points on the surface."""
        start = (wp.int32(first_task) + wp.tid()) * block
        length = wp.min(block, points - start)
        corners = wp.array(ptr=vertices, shape=(vertex_count,), dtype=wp.vec3d)
        triangles = wp.array(ptr=faces, shape=(last_face + 1,), dtype=wp.vec3i)
        areas = wp.array(ptr=cumulative, shape=(last_face + 1,), dtype=wp.float64)
        unit = wp.array(ptr=normals, shape=(last_face + 1,), dtype=wp.vec3)
        positions = wp.array(ptr=position, shape=(points,), dtype=wp.vec3d)
        turned = wp.array(ptr=normal, shape=(points,), dtype=wp.vec3)
        indices = wp.array(ptr=face, shape=(points,), dtype=wp.int32)
        shares = wp.zeros(shape=(block,), dtype=wp.float64)
        buckets = wp.zeros(shape=(block,), dtype=wp.uint32)
        words = wp.zeros(shape=(words_size,), dtype=wp.uint32)
        draw(seed, first_point + wp.uint64(start), length, areas[last_face], guide_bits, shares, buckets, words)
        for j in range(length):
            ends = wp.array(ptr=guide + wp.uint64(4) * wp.uint64(buckets[j]), shape=(2,), dtype=wp.int32)
            indices[start + j] = _face_of(shares[j], areas, ends[0], ends[1])
        for j in range(length):
            i = start + j
            weights = _weights_of(words[j], words[block + j])
            triangle = triangles[indices[i]]
            # Relative to the first corner, so that rounding far from the origin affects only the edges.
            a = corners[triangle[0]]
            positions[i] = a + weights[1] * (corners[triangle[1]] - a) + weights[2] * (corners[triangle[2]] - a)
            turned[i] = unit[indices[i]]
            if barycentric != wp.uint64(0):
                wp.array(ptr=barycentric, shape=(points,), dtype=wp.vec3d)[i] = weights

    return place_points
