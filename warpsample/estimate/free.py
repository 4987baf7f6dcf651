"""Means over sampled directions about a normal, without a mesh, in vectorised loops.

The points of a lattice are periodic on the unit square. Integrands are not: they jump from the horizon to the normal, and
from one end of a sector to the other. For a smooth integrand, this jump causes most of the error. Folding, the map of u to
1 - |2u - 1|, keeps the points uniform and removes the jump. The error then falls as 1/n^2, not as 1/n (Hickernell2002).
"""

import warp as wp

from warpsample.directions.variates import LANES, fill_variates
from warpsample.estimate.integrand import density_setter
from warpsample.estimate.lobe import NOTHING, widths_of
from warpsample.estimate.lobes import Lobes, lobe_of, orienter_of
from warpsample.estimate.rays import LAST_UNIFORM
from warpsample.estimate.slots import Slots
from warpsample.host.locks import once
from warpsample.maths.numerics import ZERO, clamp_uniform
from warpsample.sequences.hashing import stream_key
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.point import ShadingPoint

BLOCK = 256
"""Number of directions that are generated and integrated together; they may come from several streams."""

_TOGETHER = wp.constant(wp.int32(2 * LANES))  # variates are filled in multiples of this number


@wp.func
def _folded(u: wp.float32) -> wp.float32:
    """Return 1 - |2u - 1| for a uniform number u: also uniform, and equal at u = 0 and u = 1."""
    return clamp_uniform(1.0 - wp.abs(2.0 * u - 1.0))


@once
def _stream_fill(slots: Slots) -> wp.Function:
    """Build the Warp function that writes random points of the unit square, scaled to one sector of azimuth.

    Lattice points are folded, but not along the azimuth of a full circle, where the integrand is periodic.
    """
    fill, wraps = fill_variates(slots.sequence, BLOCK), slots.sequence.wraps

    @wp.func
    def fill_stream(lobes: Lobes, key: wp.vec4ui, stream: wp.int32, first: wp.int32, filled: wp.int32, at: wp.uint64):
        u = wp.array(ptr=at, shape=(2 * BLOCK,), dtype=wp.float32)
        fill(stream_key(key, wp.uint32(stream)), first, filled, wp.uint32(lobes.samples_per_stratum), u)
        sector = wp.float32(stream / 2)
        size = 1.0 / wp.float32(lobes.sectors)
        k = wp.int32(0)
        while k < filled:
            y = u[BLOCK + k]
            if wp.static(wraps):
                u[k] = _folded(u[k])
                y = wp.where(lobes.sectors > 1, _folded(y), y)
            y = (y + sector) * size
            u[BLOCK + k] = wp.where(y < LAST_UNIFORM, y, LAST_UNIFORM)
            k += 1

    return fill_stream


@once
def _block_values(slots: Slots) -> wp.Function:
    """Build the Warp function that maps unit-square points to directions and evaluates the integrand at each direction."""
    weigh, struct, channels, about = slots.weigh, slots.struct, slots.channels, slots.about
    redraw, redraw_below, redraws = slots.redraw, slots.redraw_below, slots.redraw is not None
    orient, with_pdf = orienter_of(slots.tangents), density_setter(slots.reads_pdf)

    @wp.func
    def evaluate(lobes: Lobes, data: struct, point: ShadingPoint, length: wp.int32, square: wp.uint64, target: wp.uint64):
        u = wp.array(ptr=square, shape=(2 * BLOCK,), dtype=wp.float32)
        values = wp.array(ptr=target, shape=(channels * BLOCK,), dtype=wp.float32)
        n, _usable = orient(lobes, point)
        lobe = lobe_of(lobes, point)
        rare = wp.int32(0)
        k = wp.int32(0)
        while k < length:
            d = about(n, wp.vec2(u[k] + 0.0, u[BLOCK + k] + 0.0), lobes.parameters)
            value = weigh(wp.vec3(d[0], d[1], d[2]), with_pdf(lobe, d[3]), data)
            for c in range(channels):
                values[c * BLOCK + k] = value[c]
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            k += 1
        if wp.static(redraws):  # noqa: SIM102  (the outer test is made when the kernel is built, the inner when it runs)
            if rare != 0:
                for j in range(length):
                    at = wp.vec2(u[j], u[BLOCK + j])
                    if about(n, at, lobes.parameters)[3] < redraw_below:
                        d = redraw(n, at, lobes.parameters)
                        value = weigh(wp.vec3(d[0], d[1], d[2]), with_pdf(lobe, d[3]), data)
                        for c in range(channels):
                            values[c * BLOCK + j] = value[c]

    return evaluate


@wp.func
def _rounded_up(length: wp.int32) -> wp.int32:
    """Return `length` rounded up to a whole number of SIMD vectors."""
    return (length + _TOGETHER - 1) / _TOGETHER * _TOGETHER


@wp.func
def _sum_of(row: wp.uint64, length: wp.int32) -> wp.float64:
    """Return the float64 sum of the first `length` float32 values at the address `row`."""
    values = wp.array(ptr=row, shape=(BLOCK,), dtype=wp.float32)
    sums = wp.vec4d(ZERO, ZERO, ZERO, ZERO)
    k = wp.int32(0)
    while k + 3 < length:
        for j in range(4):
            sums[j] += wp.float64(values[k + j])
        k += 4
    while k < length:
        sums[0] += wp.float64(values[k])
        k += 1
    return (sums[0] + sums[1]) + (sums[2] + sums[3])


@once
def free_lobe(slots: Slots) -> wp.Function:
    """Build the Warp function that sums the integrand over sampled directions about one normal, without a mesh.

    Its arguments and results are those of `traced_lobe`'s function.
    """
    fill_stream, evaluate, widths = _stream_fill(slots), _block_values(slots), widths_of(slots)
    struct, channels = slots.struct, slots.channels

    @wp.func
    def sum_lobe(lobes: Lobes, accelerator: Accelerator, data: struct, point: ShadingPoint):
        """Sum the integrand over the sampled directions of one point; return the sum, its error, and counts of rays."""
        total = NOTHING
        variance = NOTHING
        unseen = NOTHING
        fourth = NOTHING
        one = NOTHING
        other = NOTHING
        streams = 2 * lobes.sectors
        together = wp.clamp(
            (BLOCK - _rounded_up(wp.min(lobes.samples_per_stratum, BLOCK))) / lobes.samples_per_stratum + 1, 1, streams
        )
        for lowest in range(0, streams, together):
            taken = wp.min(together, streams - lowest)
            for first in range(0, lobes.samples_per_stratum, BLOCK):
                length = wp.min(BLOCK, lobes.samples_per_stratum - first)
                filled = _rounded_up(length)
                for i in range(taken):  # each stream overwrites the padding of the stream before
                    fill_stream(lobes, point.key, lowest + i, first, filled, point.own + wp.uint64(4 * i * length))
                evaluate(lobes, data, point, _rounded_up(taken * length), point.own, point.chunk)
                for i in range(taken):
                    part = NOTHING
                    for c in range(channels):
                        part[c] = _sum_of(point.chunk + wp.uint64(4 * (c * BLOCK + i * length)), length)
                    second_half = (lowest + i) % 2 == 1
                    one = wp.where(second_half, one, wp.where(first == 0, part, one + part))
                    other = wp.where(second_half, wp.where(first == 0, part, other + part), other)
                    if second_half and first + BLOCK >= lobes.samples_per_stratum:
                        squares = wp.cw_mul(one - other, one - other)
                        mean = (one + other) / wp.float64(2 * lobes.samples_per_stratum)
                        total += one + other
                        variance += squares
                        unseen += wp.cw_mul(mean, mean)
                        fourth += wp.cw_mul(squares, squares)
        width, degrees = widths(variance, NOTHING, unseen, variance, fourth, 0, 0, lobes.sectors)
        return total, variance, width, degrees, 2 * lobes.samples_per_stratum * lobes.sectors, 0

    return sum_lobe
