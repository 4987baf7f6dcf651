"""Function that writes the unit-square points of consecutive samples of one surface point to a temporary buffer.

A single loop over sequence and map is a dependency chain of 150 cycles and 100 instructions, longer than the reorder window
of a processor, whose units then idle. Two loops run 1.1 to 1.3 times as fast, and allow a sequence to compute two points at
once.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.sequences.record import Sequence

CHUNK = 64
"""Number of samples in the buffer, a multiple of 2 * LANES."""
LANES = 8
"""Float32 lanes of an AVX2 vector; loops run over multiples, since a scalar remainder costs as much as a whole row."""


@once
def fill_variates(sequence: Sequence, chunk: int) -> wp.Function:
    """Build the wp.func that writes the unit-square points of `length` consecutive samples of one surface point to u.

    The samples have the numbers start, start + 1, and so on.
    u has 2 * chunk floats: u[0] of all samples, then u[1]. `start` must be even if `chunk` is above 1, and `length` at most
    `chunk`. The function may write a few samples more than `length`.
    """
    sample, pair = sequence.sample, sequence.pair
    if pair is None or chunk == 1:

        @wp.func
        def fill(key: wp.vec4ui, start: wp.int32, length: wp.int32, count: wp.uint32, u: wp.array[wp.float32]):
            k = wp.int32(0)
            while k < length:
                p = sample(key, wp.uint32(start + k), count)
                u[k] = p[0]
                u[chunk + k] = p[1]
                k += 1

    else:

        @wp.func
        def fill(key: wp.vec4ui, start: wp.int32, length: wp.int32, count: wp.uint32, u: wp.array[wp.float32]):
            pairs = (length + 2 * LANES - 1) / (2 * LANES) * LANES
            k = wp.int32(0)
            while k < pairs:
                p = pair(key, wp.uint32(start / 2 + k), count)
                u[2 * k] = p[0]
                u[2 * k + 1] = p[2]
                u[chunk + 2 * k] = p[1]
                u[chunk + 2 * k + 1] = p[3]
                k += 1

    return fill
