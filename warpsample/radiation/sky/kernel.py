"""Kernel that computes the sky matrix: how much of each sky patch a point sees, by proofs where possible, else by rays."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import set_byte, set_vec4i
from warpsample.maths.numerics import HALF, ONE, ZERO
from warpsample.radiation.sky.form_factors import open_form_factor, patch_at
from warpsample.radiation.sky.patch_rays import WEIGHTS, SkyRows, patch_sum
from warpsample.radiation.sky.shafts import CLOSED, OPEN, UNKNOWN, looker
from warpsample.sequences.hashing import point_key
from warpsample.tracing.placement import id_of, in_double
from warpsample.tracing.queries import CHUNK_FLOATS, Accelerator
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.point import ShadingPoint, orient_point, place_point, point_in, workspace_floats
from warpsample.tracing.sight.shafts import VECTORS_BYTES

CONCENTRATION = 4.0
"""Largest ratio between the ray density on patches and that of `count` rays over the whole lobe, for points with little sky.

The density does not depend on proofs about other patches, so the rays do not depend on the tree's boxes."""

_CONCENTRATION = wp.constant(wp.float64(CONCENTRATION))
_FLOATS = workspace_floats(WEIGHTS, packets=True)


@wp.func
def _in_frame(sky: SkyRows, n: wp.vec3) -> wp.vec3d:
    """Return the components of a normal along east, north and up, as a float64 unit vector."""
    frame = wp.array(ptr=sky.frame, shape=(3,), dtype=wp.vec3d)
    v = in_double(n)
    return wp.normalize(wp.vec3d(wp.dot(frame[0], v), wp.dot(frame[1], v), wp.dot(frame[2], v)))


@once
def _build_patch_classifier(glass: bool) -> wp.Function:
    """Build the Warp function that classifies each sky patch, seen from a point, as open, blocked or undecided."""
    look = looker(glass)

    @wp.func
    def look_into(
        sky: SkyRows, tree: Accelerator, point: ShadingPoint, n: wp.vec3d, local: wp.int32, search: wp.bool, row: wp.int64
    ):
        """Write each sky patch's unobstructed form factor at a point, and whether the patch is open, blocked or undecided.

        States are those of `shafts`, and 0 for a patch below the horizon.
        """
        at = wp.uint64(row) * wp.uint64(sky.patches) * wp.uint64(4)
        value = wp.array(ptr=sky.value + at, shape=(sky.patches,), dtype=wp.float32)
        error = wp.array(ptr=sky.error + at, shape=(sky.patches,), dtype=wp.float32)
        begins = wp.array(ptr=sky.begins, shape=(sky.groups + 1,), dtype=wp.int32)
        filled = wp.uint64(0)
        of_all = wp.where(not glass and tree.starts == 0 and local == 0, OPEN, UNKNOWN)
        for group in range(sky.groups):
            most = wp.float32(0.0)
            for k in range(begins[group], begins[group + 1]):
                value[k] = wp.float32(open_form_factor(n, patch_at(sky.table, k)))
                most = wp.max(most, value[k])
            of_group = of_all
            if search and most > 0.0 and of_all == UNKNOWN and begins[group + 1] - begins[group] > 1:
                of_group, filled = look(
                    tree, sky.glass, point, local, sky.group_shafts + wp.uint64(group) * VECTORS_BYTES, filled
                )
            for k in range(begins[group], begins[group + 1]):
                known = wp.int32(0)
                if value[k] > 0.0:
                    known = of_group
                    if search and known == UNKNOWN:
                        known, filled = look(
                            tree, sky.glass, point, local, sky.shafts + wp.uint64(k) * VECTORS_BYTES, filled
                        )
                error[k] = wp.float32(known)

    return look_into


@once
def _build_row_filler(glass: bool) -> wp.Function:
    """Build the Warp function that computes one row of the sky matrix, for one point."""
    look_into, sum_rays = _build_patch_classifier(glass), patch_sum(glass)

    @wp.func
    def fill_row(sky: SkyRows, tree: Accelerator, point: ShadingPoint, row: wp.int64):
        """Compute the row of the sky matrix for a point; return counts of rays, and of open, blocked and hidden patches."""
        seen, local, opened = open_around(tree, point)
        n = _in_frame(sky, point.n)
        look_into(sky, seen, point, n, local, opened, row)
        if sky.skip == 0:
            seen = tree
            local = 0
        of_sky = HALF + HALF * n[2]
        density = HALF * wp.float64(sky.count) / wp.max(of_sky, ONE / _CONCENTRATION)
        at = wp.uint64(row) * wp.uint64(sky.patches) * wp.uint64(4)
        value = wp.array(ptr=sky.value + at, shape=(sky.patches,), dtype=wp.float32)
        error = wp.array(ptr=sky.error + at, shape=(sky.patches,), dtype=wp.float32)
        cast = wp.int32(0)
        open = wp.int32(0)
        closed = wp.int32(0)
        below = wp.int32(0)
        for k in range(sky.patches):
            known = wp.int32(error[k])
            share = wp.float64(value[k])
            part = wp.where(known == CLOSED, ZERO, ONE)
            deviation = ZERO
            if known == 0:
                below += 1
            elif known == UNKNOWN or sky.skip == 0:
                per_replicate = wp.max(1, wp.int32(density * share))
                part, error_of_rays, rays = sum_rays(sky, seen, point, local, n, k, patch_at(sky.table, k), per_replicate)
                cast += rays
                deviation = wp.where(known == UNKNOWN, error_of_rays, ZERO)
            elif known == OPEN:
                open += 1
            else:
                closed += 1
            value[k] = wp.float32(part * share)
            error[k] = wp.float32(deviation * share)
        return wp.vec4i(cast, open, closed, below)

    return fill_row


@once
def sky_kernel(glass: bool = False) -> wp.Kernel:
    """Build the kernel that computes rows of a sky matrix, one point per task in the processing order.

    `glass` is for meshes with transmitting faces.
    """
    fill_row = _build_row_filler(glass)

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def fill_rows(sky: SkyRows, tree: Accelerator, first_task: wp.int64):
        memory = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
        task = first_task + wp.int64(wp.tid())
        point = orient_point(point_in(memory.ptr, WEIGHTS, CHUNK_FLOATS), sky.placement, sky.normals, sky.active, task)
        point = place_point(point, sky.placement, 1)
        point.key = point_key(sky.seed, id_of(sky.placement, sky.first_point, point.index))
        tally = wp.vec4i(0)
        if point.status == 0:
            tally = fill_row(sky, tree, point, wp.where(sky.by_task != 0, task, point.index))
        set_vec4i(sky.tally, point.index, tally)
        set_byte(sky.status, point.index, point.status)

    return fill_rows
