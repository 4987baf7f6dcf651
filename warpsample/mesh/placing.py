"""Uniform points of a mesh, from the cumulative areas of its faces."""

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.philox import philox4x32_10

BLOCK = 64
"""Points that a task of the CPU places."""

_SURFACE_STREAM = wp.constant(wp.uint32(1))  # the fourth counter word; directions use 0
_WORD_STEP = wp.constant(wp.float64(2.0**-32))


def guide_to(sums: np.ndarray, points: int) -> np.ndarray:
    """Where among running sums to look for a share of the last one, by the share's first bits.

    Args:
        sums: (F,) float64, the last one above 0.
        points: how many are to be found: for few a coarse guide is made.

    Returns:
        (2^b + 1,) int32: a share from i to i + 1, of 2^b, is exceeded first by one of the sums number guide[i] to
        guide[i + 1].

    Source: Chen1974.
    """
    size = 1 << max(0, min(len(sums).bit_length() + 1, points.bit_length() - 3))
    bounds = np.arange(size + 1) / size * sums[-1]  # rounded as the kernel rounds
    return np.minimum(np.searchsorted(sums, bounds, side="right"), len(sums) - 1).astype(np.int32)


@once
def place_points(block: int) -> wp.Kernel:
    """A kernel with a task for each `block` points: Philox draws the face with 64 bits and the point on it with 64.

    It draws, searches and places in turn, so that a processor waits for the memory of many points at once.
    """
    words = 2 * block

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
        """One block."""
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
        places = wp.zeros(shape=(words,), dtype=wp.uint32)
        total = areas[last_face]
        k = wp.int32(0)
        while k < length:
            id = first_point + wp.uint64(start + k)
            counter = wp.vec4ui(wp.uint32(0), low_word(id), high_word(id), _SURFACE_STREAM)
            bits = philox4x32_10(counter, low_word(seed), high_word(seed))
            shares[k] = (wp.float64(bits[0]) + wp.float64(bits[1]) * _WORD_STEP) * _WORD_STEP * total
            buckets[k] = wp.uint32(wp.uint64(bits[0]) >> wp.uint64(32 - guide_bits))
            places[k] = bits[2]
            places[block + k] = bits[3]
            k += 1
        for j in range(length):
            # The first face whose cumulative area exceeds the share; a face without area is never chosen.
            ends = wp.array(ptr=guide + wp.uint64(4) * wp.uint64(buckets[j]), shape=(2,), dtype=wp.int32)
            low = ends[0]
            high = ends[1]
            while low < high:
                middle = (low + high) / 2
                if areas[middle] > shares[j]:
                    high = middle
                else:
                    low = middle + 1
            indices[start + j] = low
        for j in range(length):
            i = start + j
            chosen = indices[i]
            root = wp.sqrt((wp.float64(places[j]) + wp.float64(0.5)) * _WORD_STEP)
            split = (wp.float64(places[block + j]) + wp.float64(0.5)) * _WORD_STEP
            weights = wp.vec3d(wp.float64(1.0) - root, root * (wp.float64(1.0) - split), root * split)
            triangle = triangles[chosen]
            # Relative to the first corner, so that far from the origin only the edges are weighted.
            a = corners[triangle[0]]
            positions[i] = a + weights[1] * (corners[triangle[1]] - a) + weights[2] * (corners[triangle[2]] - a)
            turned[i] = unit[chosen]
            if barycentric != wp.uint64(0):
                kept = wp.array(ptr=barycentric, shape=(points,), dtype=wp.vec3d)
                kept[i] = weights

    return place_points
