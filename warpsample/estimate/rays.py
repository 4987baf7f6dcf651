"""The rays of one cell: their directions, and how far each goes."""

import warp as wp

from warpsample.estimate.skipping.frontier import NEAR, NEAR_EDGE
from warpsample.estimate.slots import Slots
from warpsample.estimate.spot import Lobes, Spot
from warpsample.host.locks import once
from warpsample.maths.memory import float_at
from warpsample.sequences.hashing import ONE_WORD, one_of, stream_key
from warpsample.tracing.wide.layout import CHUNK, CHUNK_FLOATS, DIRECTION, Accelerator
from warpsample.tracing.wide.prepare import ray_in
from warpsample.tracing.wide.query import any_of, nearest_of

SQUARE_FLOATS = 2 * CHUNK
"""Of the variates of a chunk."""

LAST_UNIFORM = wp.constant(wp.float32(1.0 - 2.0**-24))
"""For variates that are rounded up to the next cell."""


@once
def spread_of(slots: Slots) -> wp.Function:
    """A function that writes the directions of a chunk of rays."""
    sample, directions = slots.sequence.sample, directions_of(slots)

    @wp.func
    def spread(lobes: Lobes, spot: Spot, cell: wp.int32, first: wp.int32, length: wp.int32):
        """The directions of a cell's rays, both replicates one after the other, from the first-th on.

        Each replicate of each cell is a stream of its own.
        """
        u = wp.array(ptr=spot.square, shape=(SQUARE_FLOATS,), dtype=wp.float32)
        stream = wp.uint32(2 * cell)
        key = stream_key(spot.key, stream)
        other = stream_key(spot.key, stream + ONE_WORD)
        sector = cell / lobes.bands
        band = wp.float32(cell - sector * lobes.bands)
        band_size = 1.0 / wp.float32(lobes.bands)
        sector_size = 1.0 / wp.float32(lobes.sectors)
        each = lobes.each
        k = wp.int32(0)
        while k < length:
            i = first + k
            second = wp.where(i >= each, 1, 0)
            p = sample(one_of(key, other, second), wp.uint32(i - second * each), wp.uint32(each))
            x = (p[0] + band) * band_size
            y = (p[1] + wp.float32(sector)) * sector_size
            u[k] = wp.where(x < LAST_UNIFORM, x, LAST_UNIFORM)  # where the sum is rounded up to the next cell
            u[CHUNK + k] = wp.where(y < LAST_UNIFORM, y, LAST_UNIFORM)
            k += 1
        directions(lobes, spot, length)

    return spread


@once
def directions_of(slots: Slots) -> wp.Function:
    """A function that maps a chunk's variates to directions."""
    about, redraw, redraw_below, redraws = slots.about, slots.redraw, slots.redraw_below, slots.redraw is not None

    @wp.func
    def write_directions(lobes: Lobes, spot: Spot, length: wp.int32):
        u = wp.array(ptr=spot.square, shape=(SQUARE_FLOATS,), dtype=wp.float32)
        rays = wp.array(ptr=spot.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
        n = spot.n
        rare = wp.int32(0)
        k = wp.int32(0)
        while k < length:
            d = about(n, wp.vec2(u[k] + 0.0, u[CHUNK + k] + 0.0), lobes.parameters)
            rays[DIRECTION + k] = d[0]
            rays[DIRECTION + CHUNK + k] = d[1]
            rays[DIRECTION + 2 * CHUNK + k] = d[2]
            if wp.static(redraws):
                rare = rare | wp.where(d[3] < redraw_below, 1, 0)
            k += 1
        if wp.static(redraws):
            if rare != 0:
                for j in range(length):
                    at = wp.vec2(u[j], u[CHUNK + j])
                    if about(n, at, lobes.parameters)[3] < redraw_below:
                        d = redraw(n, at, lobes.parameters)
                        rays[DIRECTION + j] = d[0]
                        rays[DIRECTION + CHUNK + j] = d[1]
                        rays[DIRECTION + 2 * CHUNK + j] = d[2]

    return write_directions


@once
def distance_of(slots: Slots) -> wp.Function:
    """A function that gives how far one ray goes."""
    query, any_hit, wide = slots.query, slots.any_hit, slots.wide

    @wp.func
    def distance_of(
        accelerator: Accelerator, spot: Spot, near: wp.int32, column: wp.uint64, reach: wp.float32
    ) -> wp.float32:
        """The distance to the nearest face, with any_hit to some face; inf if there is none."""
        distance = wp.float32(wp.INF)
        if wp.static(wide):
            if near != 0:
                edge = float_at(spot.room + NEAR_EDGE, 0)
                leaf = spot.room + NEAR
                if wp.static(any_hit):
                    if any_of(leaf, near, ray_in(column), reach, edge) >= 0:
                        distance = 0.0
                else:
                    met, triangle = nearest_of(leaf, near, ray_in(column), reach, edge)
                    if triangle >= 0:
                        distance = met
                        reach = met
        if accelerator.starts > 0 and (wp.static(not any_hit) or not (distance < wp.INF)):
            met, face, _nodes, _leaves = query(accelerator, column, reach, spot.scratch)
            if wp.static(any_hit):  # so that nobody computes how far away it is
                met = wp.where(face >= 0, 0.0, wp.float32(wp.INF))
            distance = wp.min(distance, met)
        return distance

    return distance_of
