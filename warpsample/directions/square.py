"""Warp kernel that writes the unit-square points of a sequence, without mapping them to directions."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.record import Sequence


@once
def square_blocks(sequence: Sequence) -> wp.Kernel:
    """Build the Warp kernel that writes unit-square points of a sequence, for point ids with the same upper 32 bits."""
    run_of, key_of, sample_of = sequence.run, sequence.key, sequence.sample

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def square_blocks(
        total: wp.int64,
        block: wp.int32,
        count: wp.int32,
        seed: wp.uint64,
        first_point: wp.uint64,
        target: wp.uint64,
        first_task: wp.int64,
    ):
        first = (first_task + wp.int64(wp.tid())) * wp.int64(block)
        length = wp.int32(wp.min(wp.int64(block), total - first))
        point = first / wp.int64(count)
        start = wp.uint32(first - point * wp.int64(count))
        middle = wp.float64(start) + wp.float64(0.5)
        per_count = wp.float64(1.0) / wp.float64(count)
        y = wp.array(ptr=target + wp.uint64(first * wp.int64(8)), shape=(2 * length,), dtype=wp.float32)
        run = run_of(seed, high_word(first_point))
        low = low_word(first_point) + wp.uint32(point)
        i = wp.int32(0)
        while i < length:
            # The half keeps the quotient away from integers by more than the error of float64 below 2^52.
            q = wp.int32((middle + wp.float64(i)) * per_count)
            sample = start + wp.uint32(i) - wp.uint32(q) * wp.uint32(count)
            u = sample_of(key_of(run, low + wp.uint32(q)), sample, wp.uint32(count))
            y[2 * i] = u[0]
            y[2 * i + 1] = u[1]
            i += 1

    return square_blocks
