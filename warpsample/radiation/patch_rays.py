"""The rays of one patch: spread over the part of it above the point's horizon, traced, and summed by their cosines."""

import warp as wp

from warpsample.directions.variates import LANES
from warpsample.estimate.rays import STREAM_STEP
from warpsample.estimate.skipping.frontier import NEAR, NEAR_EDGE
from warpsample.estimate.spot import Spot, bring_near
from warpsample.maths.numerics import high_word, lesser, low_word, sincos_turns
from warpsample.radiation.shares import COLUMNS, FAINT, Patch, azimuth_near, highest, reaches
from warpsample.sequences.fibonacci import fibonacci
from warpsample.tracing.placement import Placement, far_off
from warpsample.tracing.wide.layout import CHUNK, CHUNK_FLOATS, DIRECTION, REACH, Accelerator
from warpsample.tracing.wide.prepare import prepare_wide, ray_in
from warpsample.tracing.wide.query import any_of, wide_query

WEIGHTS = 2 * CHUNK
"""Floats for the weights of a chunk's rays; a chunk more than there are, as all loops run over whole vectors."""

_FAINT = wp.constant(wp.float32(FAINT))
_LEAST = wp.constant(wp.float32(1e-20))
_COLUMN_BYTES = wp.constant(wp.uint64(8 * COLUMNS))
_ZERO = wp.constant(wp.float64(0.0))
_HALF = wp.constant(wp.float64(0.5))
_TWO = wp.constant(wp.float64(2.0))
_PI = wp.constant(wp.float64(3.141592653589793))
_TURN = wp.constant(wp.float64(0.15915494309189535))
_UPRIGHT = wp.constant(wp.float64(1e-12))
_query = wide_query(True, several=True)


@wp.struct
class SkyRows:
    """Scalars and addresses of the rows of a sky matrix, a point each.

    placement: of the points. normals, active: (P, 3) float32, (P,) uint8 or 0.
    count: rays of a point at most; its patches: their number, `shares.table_of`, `beams.beams_of`, and the (3, 3) float64
    of their frame. skip: whether what is known of a patch replaces its rays.
    by_task: whether the i-th task writes the i-th row, else that of its point. value, error: (rows, patches) float32.
    cast, open, closed, below, status: (P,), int32 but for the uint8 of the status: rays, patches of each kind, why not.
    """

    placement: Placement
    seed: wp.uint64
    first_point: wp.uint64
    normals: wp.uint64
    active: wp.uint64
    count: wp.int32
    patches: wp.int32
    table: wp.uint64
    beams: wp.uint64
    frame: wp.uint64
    skip: wp.int32
    by_task: wp.int32
    value: wp.uint64
    error: wp.uint64
    cast: wp.uint64
    open: wp.uint64
    closed: wp.uint64
    below: wp.uint64
    status: wp.uint64


SkyRowsArgs = type(SkyRows().__ctype__())


@wp.func
def _azimuths(n: wp.vec3d, patch: Patch):
    """(first, width), in turns, of the azimuths at which some of a patch is above the horizon.

    Of all of the patch's, if those are two intervals, with a hill of the horizon between.
    """
    first = patch.first
    last = patch.last
    level = wp.sqrt(n[0] * n[0] + n[1] * n[1])
    if level > _UPRIGHT:
        half = reaches(wp.where(n[2] < _ZERO, n[2] * patch.tan_low, n[2] * patch.tan_high), level)
        middle = azimuth_near(n, _HALF * (first + last))
        if last - first > _PI:  # the cap, which has all
            first = middle - half
            last = middle + half
        elif middle + half - _TWO * _PI <= first and middle - half + _TWO * _PI >= last:
            first = wp.max(first, middle - half)
            last = wp.max(first, wp.min(last, middle + half))
    return wp.float32(first * _TURN - wp.floor(first * _TURN)), wp.float32((last - first) * _TURN)


@wp.func
def _spread(sky: SkyRows, spot: Spot, n: wp.vec3d, k: wp.int32, patch: Patch, each: wp.int32, at: wp.int32, length: wp.int32):
    """Writes directions of a patch's rays, both replicates one after the other, from the at-th on, and their weights."""
    rays = wp.array(ptr=spot.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    weights = wp.array(ptr=spot.square, shape=(WEIGHTS,), dtype=wp.float32)
    row = wp.array(ptr=sky.table + wp.uint64(k) * _COLUMN_BYTES, shape=(COLUMNS,), dtype=wp.float64)
    frame = wp.array(ptr=sky.frame, shape=(9,), dtype=wp.float64)
    east_x = wp.float32(frame[0])
    east_y = wp.float32(frame[1])
    east_z = wp.float32(frame[2])
    north_x = wp.float32(frame[3])
    north_y = wp.float32(frame[4])
    north_z = wp.float32(frame[5])
    up_x = wp.float32(frame[6])
    up_y = wp.float32(frame[7])
    up_z = wp.float32(frame[8])
    # How much lower than the zenith directions are: where that is little, the height itself would have lost it.
    top = wp.float32(row[18])
    bottom = wp.float32(row[19])
    nx = wp.float32(n[0])
    ny = wp.float32(n[1])
    nz = wp.float32(n[2])
    normal = spot.n
    first, width = _azimuths(n, patch)
    low = low_word(sky.seed)
    high = high_word(sky.seed)
    stream = wp.uint32(2 * k)
    id = spot.lobe.point
    i = wp.int32(0)
    while i < length:
        j = at + i
        second = wp.where(j >= each, 1, 0)
        word = high ^ ((stream + wp.uint32(second)) * STREAM_STEP)
        seed = (wp.uint64(word) << wp.uint64(32)) | wp.uint64(low)
        u = fibonacci(seed, id, wp.uint32(j - second * each), wp.uint32(each))
        turn = first + width * u[0]
        turn = wp.where(turn < 1.0, turn, turn - 1.0)
        cs = sincos_turns(turn)
        level = nx * cs[1] + ny * cs[0]
        # The horizon's height at this azimuth: what is above it lies above for a normal that points up, else below.
        horizon = 1.0 + wp.where(nz < 0.0, -level, level) / wp.sqrt(level * level + nz * nz + _LEAST)
        nearest = wp.where(nz < 0.0, wp.where(horizon > top, horizon, top), top)
        farthest = wp.where(nz < 0.0, bottom, lesser(horizon, bottom))
        extent = farthest - nearest
        drop = nearest + extent * u[1]
        along = wp.sqrt(drop * (2.0 - drop))
        x = along * cs[1]
        y = along * cs[0]
        z = 1.0 - drop
        dx = x * east_x + y * north_x + z * up_x
        dy = x * east_y + y * north_y + z * up_y
        dz = x * east_z + y * north_z + z * up_z
        rays[DIRECTION + i] = dx
        rays[DIRECTION + CHUNK + i] = dy
        rays[DIRECTION + 2 * CHUNK + i] = dz
        cosine = normal[0] * dx + normal[1] * dy + normal[2] * dz
        weights[i] = wp.where(cosine >= _FAINT, 1.0, 0.0) * wp.where(extent > 0.0, 1.0, 0.0) * cosine * extent
        i += 1


@wp.func
def _to_highest(sky: SkyRows, spot: Spot, n: wp.vec3d, patch: Patch):
    """Prepares one ray, to where a patch is highest above the point's horizon."""
    frame = wp.array(ptr=sky.frame, shape=(3,), dtype=wp.vec3d)
    rays = wp.array(ptr=spot.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    w = highest(n, patch)
    d = w[0] * frame[0] + w[1] * frame[1] + w[2] * frame[2]
    for axis in range(3):
        rays[DIRECTION + axis * CHUNK] = wp.float32(d[axis])
    if far_off(spot.place):
        bring_near(spot, spot.chunk)
    prepare_wide(spot.chunk, LANES)


@wp.func
def _blocked(accelerator: Accelerator, spot: Spot, near: wp.int32, column: wp.uint64) -> wp.bool:
    """Whether a prepared ray meets something."""
    reach = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)[REACH]
    blocked = wp.bool(False)
    if reach > 0.0:
        if near != 0:
            edge = wp.array(ptr=spot.room + NEAR_EDGE, shape=(1,), dtype=wp.float32)[0]
            blocked = any_of(spot.room + NEAR, near, ray_in(column), column, reach, edge) >= 0
        if not blocked and accelerator.starts > 0:
            met, _face, _nodes, _leaves = _query(accelerator, column, reach, spot.scratch)
            blocked = met < wp.INF
    return blocked


@wp.func
def sum_rays(
    sky: SkyRows, accelerator: Accelerator, spot: Spot, near: wp.int32, n: wp.vec3d, k: wp.int32, patch: Patch, each: wp.int32
):
    """(share of the k-th patch that is seen, its standard error as a share, rays cast), by `each` rays of two replicates.

    A share of the rays' weights: where none is blocked, it is 1 in every bit.
    """
    free = _ZERO
    free_first = _ZERO
    all = _ZERO
    all_first = _ZERO
    cast = wp.int32(0)
    for at in range(0, 2 * each, CHUNK):
        length = wp.min(CHUNK, 2 * each - at)
        padded = (length + LANES - 1) / LANES * LANES
        _spread(sky, spot, n, k, patch, each, at, padded)
        if far_off(spot.place):
            for i in range(length):
                bring_near(spot, spot.chunk + wp.uint64(4 * i))
        prepare_wide(spot.chunk, padded)
        weights = wp.array(ptr=spot.square, shape=(WEIGHTS,), dtype=wp.float32)
        for i in range(length):
            weight = wp.float64(weights[i])
            if weight > _ZERO:
                cast += 1
                seen = wp.where(_blocked(accelerator, spot, near, spot.chunk + wp.uint64(4 * i)), _ZERO, weight)
                in_first = at + i < each
                free += seen
                all += weight
                free_first += wp.where(in_first, seen, _ZERO)
                all_first += wp.where(in_first, weight, _ZERO)
    error = _ZERO
    if all == _ZERO:
        # Few rays that are all but parallel to the horizon: one where the patch is highest above it.
        cast = 1
        _to_highest(sky, spot, n, patch)
        share = wp.where(_blocked(accelerator, spot, near, spot.chunk), _ZERO, wp.float64(1.0))
    else:
        share = free / all
        # The replicates' deviations from the share add up to 0: one is half of their difference.
        error = wp.abs(free_first - share * all_first) * _TWO / all
    return share, error, cast
