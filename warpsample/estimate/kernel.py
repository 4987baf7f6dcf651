"""Warp kernel of all estimates: it generates, traces and sums the rays of each point without storing rays."""

import warp as wp

from warpsample.directions.samples import INVALID_PARAMETER, INVALID_TANGENT
from warpsample.distributions.by_point.tables import row_check, row_loader
from warpsample.estimate.free import BLOCK, free_lobe
from warpsample.estimate.lobe import NOTHING, traced_lobe
from warpsample.estimate.lobes import NONFINITE_VALUE, Lobes, orienter_of
from warpsample.estimate.rays import OWN_FLOATS
from warpsample.estimate.slots import Slots
from warpsample.host.locks import once
from warpsample.maths.memory import set_byte, set_int
from warpsample.maths.numerics import ZERO
from warpsample.sequences.hashing import point_key
from warpsample.tracing.placement import id_of
from warpsample.tracing.queries import CHUNK_FLOATS, PREPARED, Accelerator
from warpsample.tracing.sight.point import ShadingPoint, orient_point, place_point, point_in, workspace_floats

_ANYTHING = wp.constant(wp.float32(2.0**60))  # no geometry is that far below a horizon


@once
def _keep(channels: int) -> wp.Function:
    """Build the Warp function that stores the mean, the standard error and the confidence interval's scale of one point."""

    @wp.func
    def keep(lobes: Lobes, point: wp.int64, total: wp.vec3d, variance: wp.vec3d, width: wp.vec3d, degrees: wp.vec3d):
        """Divide the sums over a point's rays by the number of rays, and store mean, standard error and interval."""
        rays = wp.float64(2 * lobes.samples_per_stratum * lobes.bands * lobes.sectors)
        at = wp.uint64(point) * wp.uint64(4 * channels)
        value = wp.array(ptr=lobes.value + at, shape=(channels,), dtype=wp.float32)
        error = wp.array(ptr=lobes.error + at, shape=(channels,), dtype=wp.float32)
        spreads = wp.array(ptr=lobes.spread + at, shape=(channels,), dtype=wp.float32)
        freedom = wp.array(ptr=lobes.degrees + at, shape=(channels,), dtype=wp.float32)
        for c in range(channels):
            value[c] = wp.float32(total[c] / rays)
            error[c] = wp.float32(wp.sqrt(variance[c]) / rays)
            spreads[c] = wp.float32(wp.sqrt(width[c]) / rays)
            freedom[c] = wp.float32(degrees[c])

    return keep


@once
def _estimator(slots: Slots) -> wp.Function:
    """Build the Warp function that computes and stores the estimate of one point."""
    struct, upward, traced, keep = slots.struct, slots.upward, slots.query is not None, _keep(slots.channels)
    sum_lobe = (free_lobe if slots.query is None else traced_lobe)(slots)
    load, check, by_point = row_loader(slots.layout), row_check(slots.layout), bool(slots.layout)
    orient = orienter_of(slots.tangents)

    @wp.func
    def estimate_point(lobes: Lobes, accelerator: Accelerator, data: struct, visit: wp.int64, workspace: ShadingPoint):
        """Compute and store the estimate of the point that is number `visit` in the order of processing."""
        point = orient_point(workspace, lobes.placement, lobes.normals, lobes.active, visit)
        point.key = point_key(lobes.seed, id_of(lobes.placement, lobes.first_point, point.index))
        if wp.static(traced):
            point = place_point(point, lobes.placement, 1)
            if wp.static(not upward):
                point.low = _ANYTHING
        total = NOTHING
        variance = NOTHING
        width = NOTHING
        degrees = NOTHING
        cast = wp.int32(0)
        empty = wp.int32(0)
        own = lobes
        if wp.static(by_point):
            own.parameters = load(lobes.parameters, lobes.tables, point.index)
            if point.status == 0 and check(own.parameters) != 0:
                point.status = INVALID_PARAMETER
        if point.status == 0:
            total, variance, width, degrees, cast, empty = sum_lobe(own, accelerator, data, point)
            _orientation, usable = orient(lobes, point)
            if usable == 0:
                point.status = INVALID_TANGENT
            if wp.dot(total - total, total - total) != ZERO:
                point.status = NONFINITE_VALUE
                total = NOTHING
                variance = NOTHING
                width = NOTHING
                degrees = NOTHING
        keep(lobes, point.index, total, variance, width, degrees)
        set_int(lobes.cast, point.index, cast)
        set_int(lobes.empty, point.index, empty)
        set_byte(lobes.status, point.index, point.status)

    return estimate_point


@once
def estimate_kernel(slots: Slots) -> wp.Kernel:
    """Build the Warp kernel that computes the estimates of all points; each task takes `lobes.rows` points.

    The points of a task share one block of cleared memory.
    """
    struct, estimate_point, traced = slots.struct, _estimator(slots), slots.query is not None
    chunk = (CHUNK_FLOATS if slots.wide else PREPARED) if traced else slots.channels * BLOCK
    own = OWN_FLOATS if traced else 2 * BLOCK
    searches = traced and slots.wide
    floats = workspace_floats(own, chunk, searches, searches and slots.any_hit)

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def estimate(lobes: Lobes, accelerator: Accelerator, data: struct, first_task: wp.int64):
        memory = wp.zeros(shape=(floats,), dtype=wp.float32)
        workspace = point_in(memory.ptr, own, chunk)
        first = (first_task + wp.int64(wp.tid())) * wp.int64(lobes.rows)
        for k in range(lobes.rows):
            if first + wp.int64(k) < lobes.visits:
                estimate_point(lobes, accelerator, data, first + wp.int64(k), workspace)

    return estimate
