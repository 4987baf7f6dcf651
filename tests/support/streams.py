"""The points and directions of one of a point's streams, as a kernel of one's own makes them."""

import numpy as np
import warp as wp

from warpsample import funcs
from warpsample.maths.numerics import normalize
from warpsample.sequences.fibonacci import fibonacci_sample
from warpsample.sequences.hashing import point_key, stream_key


@wp.kernel(enable_backward=False)
def _follow(
    seed: wp.uint64,
    stream: wp.uint32,
    normals: wp.array[wp.vec3],
    u: wp.array2d[wp.vec2],
    ways: wp.array2d[wp.vec3],
):
    p, k = wp.tid()
    key = stream_key(point_key(seed, wp.uint64(p)), stream)
    u[p, k] = fibonacci_sample(key, wp.uint32(k), wp.uint32(u.shape[1]))
    ways[p, k] = funcs.to_world(funcs.frame_about(normalize(normals[p])), funcs.square_to_cosine_hemisphere(u[p, k]))


def fibonacci_stream(normals, count, seed, stream):
    """((P, count, 2), (P, count, 3)): a lattice in the square, and in the cosine lobe about each normal."""
    normals = wp.array(np.asarray(normals, np.float32), dtype=wp.vec3, device="cpu")
    u, ways = (wp.empty((len(normals), count), dtype=kind, device="cpu") for kind in (wp.vec2, wp.vec3))
    wp.launch(_follow, u.shape, inputs=[seed, stream, normals], outputs=[u, ways], device="cpu")
    return u.numpy(), ways.numpy()
