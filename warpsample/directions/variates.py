"""The variates of consecutive samples of one point, written to a local buffer by a loop of their own.

Sequence and map in one loop are a chain of 150 cycles through 100 instructions: longer than a processor looks ahead, so
its units idle. Apart they run 1.1 to 1.3 times faster, and a sequence that makes two points at a time can.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.sequences.record import Sequence

CHUNK = 64
"""Samples in the buffer: a multiple of 2 * LANES."""
LANES = 8
"""Of AVX2. Loops run over multiples of it, since a scalar remainder costs as much as a row."""


@once
def fill_variates(sequence: Sequence, chunk: int) -> wp.Function:
    """A `wp.func` (key, start, length, count, u) that fills u, 2 * chunk floats: u[0] of each sample, then u[1].

    `start` is even where `chunk` is above 1; `length` is at most `chunk`. Samples past it are filled too.
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
