"""Uniform points of a mesh, from the cumulative areas of its faces."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.philox import philox4x32_10

_SURFACE_STREAM = wp.constant(wp.uint32(1))  # the fourth counter word; directions use 0
_WORD_STEP = wp.constant(wp.float64(2.0**-32))


@once
def place_points() -> wp.Kernel:
    """A kernel with a task for each point: Philox draws the face with 64 bits and the point on it with 64."""

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
        position: wp.uint64,
        face: wp.uint64,
        barycentric: wp.uint64,
        first_task: wp.int64,
    ):
        """One point."""
        i = wp.int32(first_task) + wp.tid()
        corners = wp.array(ptr=vertices, shape=(vertex_count,), dtype=wp.vec3d)
        triangles = wp.array(ptr=faces, shape=(last_face + 1,), dtype=wp.vec3i)
        areas = wp.array(ptr=cumulative, shape=(last_face + 1,), dtype=wp.float64)
        positions = wp.array(ptr=position, shape=(points,), dtype=wp.vec3d)
        indices = wp.array(ptr=face, shape=(points,), dtype=wp.int32)
        id = first_point + wp.uint64(i)
        counter = wp.vec4ui(wp.uint32(0), low_word(id), high_word(id), _SURFACE_STREAM)
        bits = philox4x32_10(counter, low_word(seed), high_word(seed))
        share = (wp.float64(bits[0]) + wp.float64(bits[1]) * _WORD_STEP) * _WORD_STEP * areas[last_face]
        # The first face whose cumulative area exceeds the share; a face without area is never chosen.
        low = wp.int32(0)
        high = last_face
        while low < high:
            middle = (low + high) / 2
            if areas[middle] > share:
                high = middle
            else:
                low = middle + 1
        root = wp.sqrt((wp.float64(bits[2]) + wp.float64(0.5)) * _WORD_STEP)
        split = (wp.float64(bits[3]) + wp.float64(0.5)) * _WORD_STEP
        weights = wp.vec3d(wp.float64(1.0) - root, root * (wp.float64(1.0) - split), root * split)
        triangle = triangles[low]
        # Relative to the first corner, so that far from the origin only the edges are weighted.
        a = corners[triangle[0]]
        positions[i] = a + weights[1] * (corners[triangle[1]] - a) + weights[2] * (corners[triangle[2]] - a)
        indices[i] = low
        if barycentric != wp.uint64(0):
            kept = wp.array(ptr=barycentric, shape=(points,), dtype=wp.vec3d)
            kept[i] = weights

    return place_points
