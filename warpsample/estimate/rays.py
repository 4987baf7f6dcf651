"""Sampling of the ray directions of one stratum, a part of the directions about a normal."""

import warp as wp

from warpsample.estimate.lobes import Lobes, orienter_of
from warpsample.estimate.slots import Slots
from warpsample.host.locks import once
from warpsample.sequences.hashing import ONE_WORD, select_key, stream_key
from warpsample.tracing.queries import CHUNK, set_direction
from warpsample.tracing.sight.point import ShadingPoint

OWN_FLOATS = 3 * CHUNK
"""Number of float32 values in a chunk's buffer: two rows of variates and a row of densities first, three of weights later.

Weight k is written after density k is read.
"""

LAST_UNIFORM: wp.float32 = wp.constant(wp.float32(1.0 - 2.0**-24))
"""Largest float32 below 1: upper limit for variates that would be rounded up to the next stratum."""


@once
def build_ray_writer(slots: Slots) -> wp.Function:
    """Build the Warp function that samples ray directions in one stratum of the directions about a point's normal."""
    sample, directions = slots.sequence.sample, directions_of(slots)

    @wp.func
    def write_rays(lobes: Lobes, point: ShadingPoint, stratum: wp.int32, first: wp.int32, length: wp.int32):
        """Sample the directions of rays `first` to `first + length - 1` of a stratum into the point's working memory.

        The rays of the first replicate come before those of the second. Each replicate of each stratum has its own stream.
        """
        u = wp.array(ptr=point.own, shape=(OWN_FLOATS,), dtype=wp.float32)
        stream = wp.uint32(2 * stratum)
        key = stream_key(point.key, stream)
        other = stream_key(point.key, stream + ONE_WORD)
        sector = stratum / lobes.bands
        band = wp.float32(stratum - sector * lobes.bands)
        band_size = 1.0 / wp.float32(lobes.bands)
        sector_size = 1.0 / wp.float32(lobes.sectors)
        samples = lobes.samples_per_stratum
        k = wp.int32(0)
        while k < length:
            i = first + k
            second = wp.where(i >= samples, 1, 0)
            p = sample(select_key(key, other, second), wp.uint32(i - second * samples), wp.uint32(samples))
            x = (p[0] + band) * band_size
            y = (p[1] + wp.float32(sector)) * sector_size
            u[k] = wp.where(x < LAST_UNIFORM, x, LAST_UNIFORM)  # where the sum is rounded up to the next stratum
            u[CHUNK + k] = wp.where(y < LAST_UNIFORM, y, LAST_UNIFORM)
            k += 1
        directions(lobes, point, length)

    return write_rays


@once
def directions_of(slots: Slots) -> wp.Function:
    """Build the Warp function that maps unit-square points to ray directions about a point's normal."""
    about, redraw, redraw_below, redraws = slots.about, slots.redraw, slots.redraw_below, slots.redraw is not None
    orient, reads_pdf = orienter_of(slots.tangents), slots.reads_pdf

    @wp.func
    def write_directions(lobes: Lobes, point: ShadingPoint, length: wp.int32):
        u = wp.array(ptr=point.own, shape=(OWN_FLOATS,), dtype=wp.float32)
        n, _usable = orient(lobes, point)
        chunk = point.chunk
        rare = wp.int32(0)
        k = wp.int32(0)
        while k < length:
            d = about(n, wp.vec2(u[k] + 0.0, u[CHUNK + k] + 0.0), lobes.parameters)
            set_direction(chunk, k, wp.vec3(d[0], d[1], d[2]))
            if wp.static(reads_pdf):
                u[2 * CHUNK + k] = d[3]
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            k += 1
        if wp.static(redraws):
            if rare != 0:
                for j in range(length):
                    at = wp.vec2(u[j], u[CHUNK + j])
                    if about(n, at, lobes.parameters)[3] < redraw_below:
                        d = redraw(n, at, lobes.parameters)
                        set_direction(chunk, j, wp.vec3(d[0], d[1], d[2]))
                        if wp.static(reads_pdf):
                            u[2 * CHUNK + j] = d[3]

    return write_directions
