"""From a row of numbers to a mask."""

import numpy as np
import warp as wp

from warpsample.tracing.wide.lanes import lanes_with
from warpsample.tracing.wide.layout import WIDTH


@wp.kernel(enable_backward=False, module="unique")
def _masks(rows: wp.array2d[wp.int32], masks: wp.array2d[wp.int32]):
    i, bit = wp.tid()
    masks[i, bit] = lanes_with(rows.ptr + wp.uint64(i) * wp.uint64(4 * WIDTH), bit)


def test_a_mask_has_a_bit_for_each_number_with_the_bit_set():
    numbers = np.random.default_rng(0).integers(0, 2**32, (100, WIDTH), dtype=np.uint32)
    numbers[:3] = [[0], [2**32 - 1], [2**31]]
    masks = wp.zeros((100, 32), wp.int32, device="cpu")
    wp.launch(_masks, masks.shape, [wp.array(numbers.view(np.int32), device="cpu"), masks], device="cpu")
    for bit in range(32):
        lanes = masks.numpy()[:, bit, None] >> np.arange(WIDTH) & 1
        assert np.array_equal(lanes, numbers >> np.uint32(bit) & 1)
        assert (masks.numpy()[:, bit] >> WIDTH == 0).all()
