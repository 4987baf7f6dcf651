"""Sum of the ray weights of one stratum: rays are generated, weighted and traced in groups."""

import warp as wp

from warpsample.estimate.integrand import Lobe, density_setter
from warpsample.estimate.lobes import BLOCKERS, GLASS, Lobes, lobe_of
from warpsample.estimate.rays import OWN_FLOATS, build_ray_writer
from warpsample.estimate.slots import Slots
from warpsample.host.locks import once
from warpsample.maths.memory import float_at
from warpsample.maths.numerics import HALF, ONE, ZERO
from warpsample.tracing.queries import CHUNK, REACH, Accelerator, column_of, direction_of
from warpsample.tracing.sight.packets import NO_RAYS, first_rays, ray_set, set_size
from warpsample.tracing.sight.point import ShadingPoint
from warpsample.tracing.sight.rays import (
    first_hit,
    glass_transmittance,
    move_rays_near,
    next_glass_crossing,
    prepare_rays,
    rays_blocked,
    whole_vectors,
)


@once
def jump_of(slots: Slots) -> wp.Function:
    """Build the Warp function that estimates how much a ray's weight jumps at an occlusion edge, to compute the error."""
    any_hit, counts, glass, binary = slots.any_hit, slots.counts, slots.glass, slots.binary

    @wp.func
    def jump_at(w: wp.vec3, total: wp.vec3d, free: wp.int32, rays: wp.int32) -> wp.vec3d:
        """Return the squared difference between the weights of an unoccluded and an occluded ray, for each channel.

        Args:
            w: Weight of one ray; with partly transmitting faces, the mean weight that the occluded rays have lost.
            total: Sum of the weights of the stratum's rays.
            free: Number of unoccluded rays.
            rays: Number of all rays of the stratum.
        """
        jump = wp.vec3d(ONE, ZERO, ZERO)
        if wp.static(not any_hit):
            # A blocker at an edge may occlude by anything between 0 and the mean of the occluded rays.
            if free < rays:
                jump[0] = (wp.float64(rays) - total[0]) / wp.float64(rays - free)
            return wp.vec3d(HALF * jump[0] * jump[0], ZERO, ZERO)
        if wp.static(not counts):
            jump = wp.vec3d(wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2]))
            if free > 0 and (wp.static(not glass) or free == rays):
                # Rays below the sky's horizon have weight 0, but what no ray has hit may change a weight of 1.
                jump = wp.where(wp.static(binary), wp.vec3d(ONE, ZERO, ZERO), total / wp.float64(free))
        return wp.cw_mul(jump, jump)

    return jump_at


@wp.func
def _fallen_off(lobes: Lobes, point: ShadingPoint, k: wp.int32, distance: wp.float32) -> wp.float32:
    """Return the occlusion of a hit, 0 to 1, which falls with distance as (1 - distance / max_distance)^falloff."""
    reach = float_at(column_of(point.chunk, k), REACH)
    t = (distance + (point.reach - reach)) / point.reach
    return wp.pow(1.0 - t, lobes.falloff)


@wp.func
def _stopped_before(lobes: Lobes, point: ShadingPoint, k: wp.int32, distance: wp.float32):
    """Return the occlusion of the k-th ray by translucent faces up to `distance`, and the transmitted share, both 0 to 1."""
    occluded = wp.float32(0.0)
    left = wp.float32(1.0)
    near, face = next_glass_crossing(lobes.glass, point, k, distance, 0.0, -1)
    while face >= 0:
        passed = left * float_at(lobes.glass.transmittance, face)
        occluded += (left - passed) * _fallen_off(lobes, point, k, near)
        left = passed
        near, face = next_glass_crossing(lobes.glass, point, k, distance, near, face)
    return occluded, left


@once
def share_of(slots: Slots) -> wp.Function:
    """Build the Warp function that traces one ray and returns the unoccluded share of the ray, 0 to 1."""
    glass, any_hit, hit = slots.glass, slots.any_hit, first_hit(False, slots.query, slots.wide)

    @wp.func
    def share_of(lobes: Lobes, tree: Accelerator, point: ShadingPoint, local: wp.int32, k: wp.int32):
        """Trace the k-th ray; return its unoccluded share, 0 to 1, and whether the ray hits a face."""
        share = wp.float32(1.0)
        met = wp.bool(False)
        if wp.static(any_hit):
            share = glass_transmittance(lobes.glass, point, k)
            met = share < 1.0
        else:
            left = wp.float32(1.0)
            distance, _face = hit(tree, point, local, k)
            met = distance < wp.INF
            if wp.static(glass):
                occluded, left = _stopped_before(lobes, point, k, distance)
                share = 1.0 - occluded
            if met:
                share -= left * _fallen_off(lobes, point, k, distance)
            met = met or left < 1.0
        return share, met

    return share_of


@wp.func
def _weight_at(point: ShadingPoint, k: wp.int32) -> wp.vec3:
    """Return the weight of the k-th ray, from the three rows of a point's working memory."""
    return wp.vec3(float_at(point.own, k), float_at(point.own, CHUNK + k), float_at(point.own, 2 * CHUNK + k))


@once
def weighing(slots: Slots) -> wp.Function:
    """Build the Warp function that evaluates the integrand for a group of rays of one point."""
    weigh, struct, constant, with_pdf = slots.weigh, slots.struct, slots.constant, density_setter(slots.reads_pdf)

    @wp.func
    def weigh_rays(lobe: Lobe, data: struct, point: ShadingPoint, length: wp.int32) -> wp.uint64:
        """Evaluate the integrand for `length` rays of a point; return the bit set of rays with a weight other than 0."""
        alive = first_rays(length)
        if wp.static(not constant):
            own = wp.array(ptr=point.own, shape=(OWN_FLOATS,), dtype=wp.float32)
            chunk = point.chunk
            padded = whole_vectors(length)
            k = wp.int32(0)
            while k < padded:
                w = weigh(direction_of(chunk, k), with_pdf(lobe, own[2 * CHUNK + k]), data)
                own[k] = w[0]
                own[CHUNK + k] = w[1]
                own[2 * CHUNK + k] = w[2]
                k += 1
            alive = NO_RAYS
            for j in range(length):
                w = _weight_at(point, j)
                if w[0] != 0.0 or w[1] != 0.0 or w[2] != 0.0:
                    alive = alive | ray_set(j)
        return alive

    return weigh_rays


@once
def group_tracer(slots: Slots) -> wp.Function:
    """Build the Warp function that writes, weighs and casts a group of rays of one stratum, as far as any hit is enough."""
    write_rays, weigh, struct, any_hit = build_ray_writer(slots), weighing(slots), slots.struct, slots.any_hit
    prepare, block = prepare_rays(slots.prepare), rays_blocked(slots.query, slots.wide)
    stops = BLOCKERS if slots.glass else -1

    @wp.func
    def trace_group(
        lobes: Lobes,
        tree: Accelerator,
        lobe: Lobe,
        data: struct,
        point: ShadingPoint,
        stratum: wp.int32,
        first: wp.int32,
        length: wp.int32,
        found: wp.int32,
        local: wp.int32,
    ):
        """Return the bit sets of the rays from `first` on that have a weight, and of those that no opaque face blocks."""
        write_rays(lobes, point, stratum, first, whole_vectors(length))
        rays = weigh(lobe, data, point, length)
        left = rays
        if found != 0:
            move_rays_near(point, length)
            prepare(tree, point, local, length)
            if wp.static(any_hit) and (found & stops) != 0:
                left = rays & (~block(tree, point, local, rays, length))
        return rays, left

    return trace_group


@once
def stratum_sum(slots: Slots) -> wp.Function:
    """Build the Warp function that casts the rays of one stratum of a point's directions and sums their weights.

    It returns six numbers: the sum of the weights of both replicates, the first replicate's sum less the second's, the
    number of rays cast, the number of unoccluded rays, the number of rays that count, and the weight `w` for `jump_of`'s
    function.
    """
    return _stratum_count(slots) if slots.counts else _stratum_weights(slots)


@once
def _stratum_count(slots: Slots) -> wp.Function:
    """Build the function of `stratum_sum` for rays that each add 0 or 1, so that their sum is a count."""
    trace_group, struct, weightless = group_tracer(slots), slots.struct, 1 if slots.sparse else 0

    @wp.func
    def count_rays(
        lobes: Lobes,
        tree: Accelerator,
        data: struct,
        point: ShadingPoint,
        stratum: wp.int32,
        found: wp.int32,
        local: wp.int32,
    ):
        """Cast the rays of one stratum, and count the unoccluded ones; see `stratum_sum`."""
        hits = wp.int32(0)
        more_hits = wp.int32(0)
        cast = wp.int32(0)
        each = lobes.samples_per_stratum
        counted = 2 * each
        lobe = lobe_of(lobes, point)
        for first in range(0, 2 * each, CHUNK):
            length = wp.min(CHUNK, 2 * each - first)
            rays, left = trace_group(lobes, tree, lobe, data, point, stratum, first, length, found, local)
            cast += wp.where(found != 0, set_size(rays), 0)
            counted -= weightless * (length - set_size(rays))
            hits += set_size(left)
            more_hits += 2 * set_size(left & first_rays(wp.clamp(each - first, 0, length))) - set_size(left)
        total = wp.vec3d(wp.float64(hits), ZERO, ZERO)
        difference = wp.vec3d(wp.float64(more_hits), ZERO, ZERO)
        return total, difference, cast, hits, counted, wp.vec3(1.0, 0.0, 0.0)

    return count_rays


@once
def _stratum_weights(slots: Slots) -> wp.Function:
    """Build the function of `stratum_sum` for rays of any weight."""
    trace_group, share_left, struct = group_tracer(slots), share_of(slots), slots.struct
    constant, channels, glass = slots.constant, slots.channels, slots.glass and slots.any_hit
    weightless, dims = 1 if slots.sparse else 0, GLASS if glass else 0 if slots.any_hit else -1

    @wp.func
    def sum_weights(
        lobes: Lobes,
        tree: Accelerator,
        data: struct,
        point: ShadingPoint,
        stratum: wp.int32,
        found: wp.int32,
        local: wp.int32,
    ):
        """Cast the rays of one stratum, and sum their weights; see `stratum_sum`."""
        # Scalars, since a vector of doubles goes through memory and costs half as much as a ray.
        x = ZERO
        y = ZERO
        z = ZERO
        more_x = ZERO
        more_y = ZERO
        more_z = ZERO
        cast = wp.int32(0)
        each = lobes.samples_per_stratum
        free = 2 * each
        counted = 2 * each
        w = wp.vec3(1.0, 0.0, 0.0)
        lost = wp.vec3(0.0, 0.0, 0.0)
        lobe = lobe_of(lobes, point)
        for first in range(0, 2 * each, CHUNK):
            length = wp.min(CHUNK, 2 * each - first)
            rays, left = trace_group(lobes, tree, lobe, data, point, stratum, first, length, found, local)
            cast += wp.where(found != 0, set_size(rays), 0)
            counted -= weightless * (length - set_size(rays))
            free -= set_size(rays & (~left))
            for k in range(length):
                if wp.static(not constant):
                    w = _weight_at(point, k)
                share = wp.where((rays & (~left) & ray_set(k)) != NO_RAYS, 0.0, 1.0)
                if wp.static(dims != 0) and (found & dims) != 0 and (left & ray_set(k)) != NO_RAYS:
                    share, met = share_left(lobes, tree, point, local, k)
                    free -= wp.where(met, 1, 0)
                if wp.static(glass):
                    lost += (1.0 - share) * w
                sign = wp.float64(wp.where(first + k < each, 1, -1))
                x += wp.float64(share * w[0])
                more_x += sign * wp.float64(share * w[0])
                if wp.static(channels > 1):
                    y += wp.float64(share * w[1])
                    z += wp.float64(share * w[2])
                    more_y += sign * wp.float64(share * w[1])
                    more_z += sign * wp.float64(share * w[2])
        free -= 2 * each - counted
        if wp.static(glass):
            w = lost / wp.float32(wp.max(counted - free, 1))
        return wp.vec3d(x, y, z), wp.vec3d(more_x, more_y, more_z), cast, free, counted, w

    return sum_weights
