"""Kernel for the mean of a function over sampled directions, without storing the directions."""

import warp as wp

from warpsample.directions.variates import CHUNK, LANES, fill_variates
from warpsample.distributions.parameters import Parameters
from warpsample.host.locks import once
from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.record import Sequence

_Z = wp.constant(wp.vec3(0.0, 0.0, 1.0))


@once
def direction_means(sequence: Sequence, about: wp.Function, function: wp.Function) -> wp.Kernel:
    """Build the Warp kernel that computes each point's mean of function(w) over `count` directions w about +z.

    `about` is a wp.func (unit normal, u, Parameters) -> (direction, pdf), and `function` a wp.func (w: vec3) -> float32.
    """
    fill, run_of, key_of = fill_variates(sequence, CHUNK), sequence.run, sequence.key
    variates = 2 * CHUNK

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def direction_means(
        seed: wp.uint64,
        first_point: wp.uint64,
        count: wp.int32,
        target: wp.uint64,
        parameters: Parameters,
        first_task: wp.int64,
    ):
        point = wp.uint64(first_task) + wp.uint64(wp.tid())
        buffer = wp.zeros(shape=(variates,), dtype=wp.float32)
        u = wp.array(ptr=buffer.ptr, shape=(variates,), dtype=wp.float32)
        # One sum for each index in the chunk, so that the loop vectorises: a single sum would be added up in order.
        lanes = wp.zeros(shape=(CHUNK,), dtype=wp.float64)
        sums = wp.array(ptr=lanes.ptr, shape=(CHUNK,), dtype=wp.float64)
        id = first_point + point
        key = key_of(run_of(seed, high_word(id)), low_word(id))
        for first in range(0, count, CHUNK):
            length = wp.min(CHUNK, count - first)
            padded = (length + LANES - 1) / LANES * LANES
            fill(key, first, padded, wp.uint32(count), u)
            j = wp.int32(0)
            while j < padded:
                d = about(_Z, wp.vec2(u[j] + 0.0, u[CHUNK + j] + 0.0), parameters)
                value = function(wp.vec3(d[0], d[1], d[2]))
                sums[j] = sums[j] + wp.float64(wp.where(j < length, value, 0.0))
                j += 1
        total = wp.float64(0.0)
        for k in range(wp.min(CHUNK, count)):
            total += sums[k]
        out = wp.array(ptr=target + point * wp.uint64(8), shape=(1,), dtype=wp.float64)
        out[0] = total / wp.float64(count)

    return direction_means
