"""Lobes that nothing blocks: directions are made and integrated a chunk at a time, in loops that vectorise."""

import warp as wp

from warpsample.directions.variates import LANES, fill_variates
from warpsample.estimate.lobe import NOTHING, widths_of
from warpsample.estimate.rays import LAST_UNIFORM, SQUARE_FLOATS, STREAM_STEP
from warpsample.estimate.slots import Slots
from warpsample.estimate.spot import Lobes, Spot
from warpsample.host.locks import once
from warpsample.maths.numerics import high_word, low_word
from warpsample.tracing.wide.layout import CHUNK, Accelerator

_ZERO = wp.constant(wp.float64(0.0))


@once
def _reduced(channels: int) -> wp.Function:
    """A function that adds up the sums of a chunk's places: four at a time, so that no addition waits for the last."""

    @wp.func
    def add_up(places: wp.uint64, length: wp.int32) -> wp.vec3d:
        sums = wp.array(ptr=places, shape=(channels * CHUNK,), dtype=wp.float64)
        total = NOTHING
        for c in range(channels):
            first = _ZERO
            second = _ZERO
            third = _ZERO
            fourth = _ZERO
            for i in range(0, length, 4):
                first += sums[c * CHUNK + i]
                second += sums[c * CHUNK + i + 1]
                third += sums[c * CHUNK + i + 2]
                fourth += sums[c * CHUNK + i + 3]
            total[c] = (first + second) + (third + fourth)
        return total

    return add_up


@once
def _chunk_sum(slots: Slots) -> wp.Function:
    """A function that adds what the integrand gives at a chunk's directions to a sum for each place in the chunk."""
    weigh, struct, channels, about = slots.weigh, slots.struct, slots.channels, slots.about
    redraw, redraw_below, redraws = slots.redraw, slots.redraw_below, slots.redraw is not None

    @wp.func
    def sum_chunk(lobes: Lobes, data: struct, spot: Spot, sector: wp.float32, length: wp.int32, places: wp.uint64):
        u = wp.array(ptr=spot.square, shape=(SQUARE_FLOATS,), dtype=wp.float32)
        sums = wp.array(ptr=places, shape=(channels * CHUNK,), dtype=wp.float64)
        n = spot.n
        lobe = spot.lobe
        size = 1.0 / wp.float32(lobes.sectors)
        padded = (length + LANES - 1) / LANES * LANES
        rare = wp.int32(0)
        k = wp.int32(0)
        while k < padded:
            y = (u[CHUNK + k] + sector) * size
            d = about(n, wp.vec2(u[k] + 0.0, wp.where(y < LAST_UNIFORM, y, LAST_UNIFORM)), lobes.parameters)
            value = weigh(wp.vec3(d[0], d[1], d[2]), lobe, data)
            for c in range(channels):
                sums[c * CHUNK + k] = sums[c * CHUNK + k] + wp.float64(wp.where(k < length, value[c], 0.0))
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            k += 1
        if wp.static(redraws):  # noqa: SIM102  (one is decided when the kernel is built, the other when it runs)
            if rare != 0:
                for j in range(length):
                    turn = (u[CHUNK + j] + sector) * size
                    at = wp.vec2(u[j], wp.where(turn < LAST_UNIFORM, turn, LAST_UNIFORM))
                    d = about(n, at, lobes.parameters)
                    if d[3] < redraw_below:
                        e = redraw(n, at, lobes.parameters)
                        was = weigh(wp.vec3(d[0], d[1], d[2]), lobe, data)
                        value = weigh(wp.vec3(e[0], e[1], e[2]), lobe, data)
                        for c in range(channels):
                            sums[c * CHUNK + j] = sums[c * CHUNK + j] + (wp.float64(value[c]) - wp.float64(was[c]))

    return sum_chunk


@once
def free_lobe(slots: Slots) -> wp.Function:
    """A function that sums a lobe that nothing blocks, as `weighed_lobe` does one with a mesh."""
    fill, sum_chunk, add_up = fill_variates(slots.sequence, CHUNK), _chunk_sum(slots), _reduced(slots.channels)
    widths, struct, size = widths_of(slots), slots.struct, slots.channels * CHUNK

    @wp.func
    def sum_replicate(lobes: Lobes, data: struct, spot: Spot, sector: wp.int32, replicate: wp.int32) -> wp.vec3d:
        """The sum over one of the two streams of a sector."""
        u = wp.array(ptr=spot.square, shape=(SQUARE_FLOATS,), dtype=wp.float32)
        sums = wp.zeros(shape=(size,), dtype=wp.float64)
        word = high_word(lobes.seed) ^ (wp.uint32(2 * sector + replicate) * STREAM_STEP)
        seed = (wp.uint64(word) << wp.uint64(32)) | wp.uint64(low_word(lobes.seed))
        for first in range(0, lobes.each, CHUNK):
            length = wp.min(CHUNK, lobes.each - first)
            fill(seed, spot.lobe.point, first, (length + LANES - 1) / LANES * LANES, wp.uint32(lobes.each), u)
            sum_chunk(lobes, data, spot, wp.float32(sector), length, sums.ptr)
        return add_up(sums.ptr, wp.min(CHUNK, lobes.each))

    @wp.func
    def sum_lobe(lobes: Lobes, accelerator: Accelerator, data: struct, spot: Spot):
        total = NOTHING
        variance = NOTHING
        unseen = NOTHING
        fourth = NOTHING
        for sector in range(lobes.sectors):
            first = sum_replicate(lobes, data, spot, sector, 0)
            second = sum_replicate(lobes, data, spot, sector, 1)
            squares = wp.cw_mul(first - second, first - second)
            mean = (first + second) / wp.float64(2 * lobes.each)
            total += first + second
            variance += squares
            unseen += wp.cw_mul(mean, mean)
            fourth += wp.cw_mul(squares, squares)
        width, degrees = widths(variance, NOTHING, unseen, variance, fourth, 0, lobes.sectors)
        return total, variance, width, degrees, 2 * lobes.each * lobes.sectors, 0

    return sum_lobe
