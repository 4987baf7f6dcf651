"""Rays from a point to one sky patch: sampling of directions above the horizon, tracing, and the visible share."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import float_at
from warpsample.maths.numerics import ONE, TWO, ZERO, greater, lesser
from warpsample.radiation.sky.form_factors import FAINT, Patch, highest
from warpsample.radiation.sky.spreading import LEAST, Slope, azimuth_at, column_at, cube_root, slope_of, weight_of
from warpsample.sequences.fibonacci import fibonacci_sample
from warpsample.sequences.hashing import ONE_WORD, select_key, stream_key
from warpsample.tracing.placement import Placement
from warpsample.tracing.queries import CHUNK, Accelerator, Glass, set_direction
from warpsample.tracing.sight.packets import NO_RAYS, ray_set, set_size
from warpsample.tracing.sight.point import ShadingPoint
from warpsample.tracing.sight.rays import glass_transmittance, move_rays_near, prepare_rays, rays_blocked, whole_vectors

WEIGHTS = 2 * CHUNK
"""Number of floats for the weights of a chunk's rays: twice the chunk, because loops run over whole vectors."""

_FAINT = wp.constant(wp.float32(FAINT))
_LEAST_CUBE = wp.constant(wp.float32(1e-12))
_prepare, _blocked = prepare_rays(), rays_blocked()

# Variance of the visible share of a patch in squared rays, by the spread of its rays. In a city, a yard and on the bunny, it
# was 0.02 to 0.1 if all rays agree, else 0.4 + 0.2 sqrt(spread), with 2 to 2,000 rays per patch.
_IF_ALL_AGREE = wp.constant(wp.float64(0.1))
_OF_FEW = wp.constant(wp.float64(0.12))
_OF_EDGE = wp.constant(wp.float64(0.25))
_OF_LONG_EDGE = wp.constant(wp.float64(0.12))
_THIRD = wp.constant(wp.float64(1.0 / 3.0))


@wp.struct
class SkyRows:
    """Kernel argument of the computation of a sky matrix: numbers, and addresses of arrays.

    placement: placement of the points. normals, active: (P, 3) float32, (P,) uint8 or 0. count: largest number of rays per
    point. patches: number of patches. table: see `form_factors.table_of`. shafts: shafts of the patches. frame: (3, 3)
    float64, the patches' frame. groups: number of groups. begins: (groups + 1,) int32, first patch of each group.
    group_shafts: shafts of the groups. skip: 1 if proofs about a patch replace its rays. by_task: 1 if the i-th task writes
    row i, 0 if it writes the row of its point.
    value, error: (rows, patches) float32. glass: transmitting faces, if any.
    tally: (P, 4) int32, rays cast and patches open, closed and below the horizon. status: (P,) uint8, `PointStatus`.
    """

    placement: Placement
    seed: wp.uint64
    first_point: wp.uint64
    normals: wp.uint64
    active: wp.uint64
    count: wp.int32
    patches: wp.int32
    table: wp.uint64
    shafts: wp.uint64
    frame: wp.uint64
    groups: wp.int32
    begins: wp.uint64
    group_shafts: wp.uint64
    skip: wp.int32
    by_task: wp.int32
    value: wp.uint64
    error: wp.uint64
    tally: wp.uint64
    status: wp.uint64
    glass: Glass


SkyRowsArgs = type(SkyRows().__ctype__())


@wp.func
def _write_directions(
    sky: SkyRows, point: ShadingPoint, slope: Slope, k: wp.int32, per_replicate: wp.int32, at: wp.int32, length: wp.int32
):
    """Sample the directions and weights of `length` rays from a point to a sky patch, starting with ray number `at`.

    The second replicate's rays follow those of the first. The density is nearly proportional to the cosine: linear in the
    height along a column, with columns chosen by weight.
    """
    weights = wp.array(ptr=point.own, shape=(WEIGHTS,), dtype=wp.float32)
    frame = wp.array(ptr=sky.frame, shape=(9,), dtype=wp.float64)
    east = wp.vec3(wp.float32(frame[0]), wp.float32(frame[1]), wp.float32(frame[2]))
    north = wp.vec3(wp.float32(frame[3]), wp.float32(frame[4]), wp.float32(frame[5]))
    up = wp.vec3(wp.float32(frame[6]), wp.float32(frame[7]), wp.float32(frame[8]))
    n = point.n
    chunk = point.chunk
    cubes = slope.start * slope.start * slope.start
    more = slope.end * slope.end * slope.end - cubes
    steeper = slope.end - slope.start
    even = steeper == 0.0
    inverse = 1.0 / wp.where(even, 1.0, steeper)
    stream = wp.uint32(2 * k)
    key = stream_key(point.key, stream)
    other = stream_key(point.key, stream + ONE_WORD)
    i = wp.int32(0)
    while i < length:
        j = at + i
        second = wp.where(j >= per_replicate, 1, 0)
        u = fibonacci_sample(select_key(key, other, second), wp.uint32(j - second * per_replicate), wp.uint32(per_replicate))
        height = cube_root(cubes + more * u[0] + _LEAST_CUBE)
        share = wp.where(even, u[0], lesser(greater((height - slope.start) * inverse, 0.0), 1.0))
        root = slope.start + steeper * share
        cs = azimuth_at(slope, share)
        column = column_at(slope, cs)
        a = column[2]
        b = column[3]
        slant = wp.sqrt(a * a + u[1] * (b * b - a * a)) + a
        down = lesser(u[1] * (a + b) / (slant + LEAST), 1.0)
        drop = column[0] + column[1] * down
        along = wp.sqrt(drop * (2.0 - drop))
        x = along * cs[1]
        y = along * cs[0]
        z = 1.0 - drop
        dx = x * east[0] + y * north[0] + z * up[0]
        dy = x * east[1] + y * north[1] + z * up[1]
        dz = x * east[2] + y * north[2] + z * up[2]
        set_direction(chunk, i, wp.vec3(dx, dy, dz))
        cosine = n[0] * dx + n[1] * dy + n[2] * dz
        density = (a + down * (b - a)) * root * root + LEAST
        weights[i] = wp.where(cosine >= _FAINT, cosine * weight_of(column) / density, 0.0)
        i += 1


@wp.func
def _rays_with_weight(point: ShadingPoint, length: wp.int32) -> wp.uint64:
    """Return the bit set of the rays with a weight above 0, among the first `length` rays of a point."""
    rays = NO_RAYS
    for i in range(length):
        rays = rays | wp.where(float_at(point.own, i) > 0.0, ray_set(i), NO_RAYS)
    return rays


@once
def _highest_share(glass: bool) -> wp.Function:
    """Build the Warp function that returns the visible share of one direction of a sky patch."""

    @wp.func
    def share_at_highest(
        sky: SkyRows, tree: Accelerator, point: ShadingPoint, local: wp.int32, n: wp.vec3d, patch: Patch
    ) -> wp.float64:
        """Return the visible share, 0 to 1, of the direction in a sky patch that is highest above the point's horizon."""
        frame = wp.array(ptr=sky.frame, shape=(3,), dtype=wp.vec3d)
        w = highest(n, patch)
        d = w[0] * frame[0] + w[1] * frame[1] + w[2] * frame[2]
        set_direction(point.chunk, 0, wp.vec3(d))
        move_rays_near(point, 1)
        _prepare(tree, point, local, 1)
        share = wp.where(_blocked(tree, point, local, ray_set(0), 1) != NO_RAYS, ZERO, ONE)
        if wp.static(glass) and share > ZERO:
            share = wp.float64(glass_transmittance(sky.glass, point, 0))
        return share

    return share_at_highest


@wp.func
def _error_of_share(difference: wp.float64, spread: wp.float64, rays: wp.float64) -> wp.float64:
    """Return the standard error of a patch's visible share.

    The difference between the two replicates is 0 where all rays miss a small opening, and too large where one ray differs.
    So its weight grows with the spread, and the error is at least that of an edge between the rays.

    Args:
        difference: Difference between the share and that of one of the two replicates.
        spread: Variance of single rays times their number, in squared rays; 0 if all rays agree.
        rays: Number of rays.
    """
    edge = wp.min(_IF_ALL_AGREE + _OF_FEW * spread * spread, _OF_EDGE + _OF_LONG_EDGE * wp.sqrt(spread))
    return wp.sqrt(wp.max(difference * difference * spread / (spread + _THIRD), edge / (rays * rays)))


@once
def patch_sum(glass: bool) -> wp.Function:
    """Build the Warp function that estimates by rays the visible share of a sky patch."""
    share_at_highest = _highest_share(glass)

    @wp.func
    def sum_rays(
        sky: SkyRows,
        tree: Accelerator,
        point: ShadingPoint,
        local: wp.int32,
        n: wp.vec3d,
        k: wp.int32,
        patch: Patch,
        per_replicate: wp.int32,
    ):
        """Estimate the visible share of a sky patch at a point by rays; return (share, standard error, number of rays).

        The share is a quotient of weights: exactly 1 if no ray is blocked.
        """
        free = ZERO
        free_first = ZERO
        all = ZERO
        all_first = ZERO
        squares = ZERO
        cast = wp.int32(0)
        slope = slope_of(n, patch)
        for at in range(0, 2 * per_replicate, CHUNK):
            length = wp.min(CHUNK, 2 * per_replicate - at)
            _write_directions(sky, point, slope, k, per_replicate, at, whole_vectors(length))
            move_rays_near(point, length)
            _prepare(tree, point, local, length)
            rays = _rays_with_weight(point, length)
            blocked = _blocked(tree, point, local, rays, length)
            cast += set_size(rays)
            for i in range(length):
                if (rays & ray_set(i)) != NO_RAYS:
                    weight = wp.float64(float_at(point.own, i))
                    through = wp.where((blocked & ray_set(i)) != NO_RAYS, ZERO, ONE)
                    if wp.static(glass) and through > ZERO:
                        through = wp.float64(glass_transmittance(sky.glass, point, i))
                    seen = weight * through
                    in_first = at + i < per_replicate
                    free += seen
                    squares += seen * through
                    all += weight
                    free_first += wp.where(in_first, seen, ZERO)
                    all_first += wp.where(in_first, weight, ZERO)
        difference = ZERO
        spread = ZERO
        if all == ZERO:
            # All rays are almost parallel to the horizon: cast one ray where the patch is highest above the horizon.
            cast = 1
            share = share_at_highest(sky, tree, point, local, n, patch)
        else:
            share = free / all
            # The two replicates deviate from the share by opposite amounts: each deviation is half of their difference.
            difference = wp.abs(free_first - share * all_first) * TWO / all
            spread = wp.float64(cast) * wp.max(squares / all - share * share, ZERO)
        return share, _error_of_share(difference, spread, wp.float64(cast)), cast

    return sum_rays
