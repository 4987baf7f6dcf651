"""Lobes that nothing blocks: directions are made and integrated a chunk at a time, in loops that vectorise."""

import warp as wp

from warpsample.directions.variates import LANES
from warpsample.estimate.lobe import NOTHING, widths_of
from warpsample.estimate.rays import spread_of_replicate
from warpsample.estimate.slots import Slots
from warpsample.estimate.spot import Lobes, Spot
from warpsample.host.locks import once
from warpsample.tracing.wide.layout import CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, Accelerator

_ZERO = wp.constant(wp.float64(0.0))


@once
def _chunk_sum(slots: Slots) -> wp.Function:
    """A function that evaluates the integrand at the directions of a chunk and sums what it gives."""
    weigh, struct, channels = slots.weigh, slots.struct, slots.channels

    @wp.func
    def sum_chunk(data: struct, spot: Spot, length: wp.int32, padded: wp.int32) -> wp.vec3d:
        # The values stand where origins would; a sum for each of four keeps additions from waiting for one another.
        rows = wp.array(ptr=spot.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
        lobe = spot.lobe
        k = wp.int32(0)
        while k < padded:
            w = wp.vec3(rows[DIRECTION + k], rows[DIRECTION + CHUNK + k], rows[DIRECTION + 2 * CHUNK + k])
            value = weigh(w, lobe, data)
            for c in range(channels):
                rows[ORIGIN + c * CHUNK + k] = wp.where(k < length, value[c], 0.0)
            k += 1
        total = NOTHING
        for c in range(channels):
            first = _ZERO
            second = _ZERO
            third = _ZERO
            fourth = _ZERO
            for i in range(0, padded, 4):
                first += wp.float64(rows[ORIGIN + c * CHUNK + i])
                second += wp.float64(rows[ORIGIN + c * CHUNK + i + 1])
                third += wp.float64(rows[ORIGIN + c * CHUNK + i + 2])
                fourth += wp.float64(rows[ORIGIN + c * CHUNK + i + 3])
            total[c] = (first + second) + (third + fourth)
        return total

    return sum_chunk


@once
def free_lobe(slots: Slots) -> wp.Function:
    """A function that sums a lobe that nothing blocks, as `weighed_lobe` does one with a mesh."""
    spread, sum_chunk, widths, struct = spread_of_replicate(slots), _chunk_sum(slots), widths_of(slots), slots.struct

    @wp.func
    def sum_replicate(lobes: Lobes, data: struct, spot: Spot, cell: wp.int32, replicate: wp.int32) -> wp.vec3d:
        total = NOTHING
        for first in range(0, lobes.each, CHUNK):
            length = wp.min(CHUNK, lobes.each - first)
            padded = (length + LANES - 1) / LANES * LANES
            spread(lobes, spot, cell, replicate, first, padded)
            total += sum_chunk(data, spot, length, padded)
        return total

    @wp.func
    def sum_lobe(lobes: Lobes, accelerator: Accelerator, data: struct, spot: Spot):
        total = NOTHING
        variance = NOTHING
        unseen = NOTHING
        fourth = NOTHING
        cells = lobes.bands * lobes.sectors
        for cell in range(cells):
            first = sum_replicate(lobes, data, spot, cell, 0)
            second = sum_replicate(lobes, data, spot, cell, 1)
            squares = wp.cw_mul(first - second, first - second)
            mean = (first + second) / wp.float64(2 * lobes.each)
            total += first + second
            variance += squares
            unseen += wp.cw_mul(mean, mean)
            fourth += wp.cw_mul(squares, squares)
        width, degrees = widths(variance, NOTHING, unseen, variance, fourth, 0, cells)
        return total, variance, width, degrees, 2 * lobes.each * cells, 0

    return sum_lobe
