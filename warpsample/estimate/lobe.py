"""Sum of the ray weights of one point. Strata without geometry are detected by a tree search and cast no rays."""

import warp as wp

from warpsample.estimate.intervals import Prior, edge_variance, posterior, prior_numbers
from warpsample.estimate.lobes import BLOCKERS, GLASS, Lobes, finder_of
from warpsample.estimate.slots import Slots
from warpsample.estimate.stratum import jump_of, stratum_sum
from warpsample.host.locks import once
from warpsample.maths.numerics import HALF, ONE
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.point import ShadingPoint

NOTHING: wp.vec3d = wp.constant(wp.vec3d(0.0, 0.0, 0.0))


@once
def widths_of(slots: Slots) -> wp.Function:
    """Build the Warp function that computes the confidence interval of each channel of a point's estimate."""
    channels = slots.channels
    numbers = prior_numbers(slots.counts, slots.sequence.unseen, slots.query is not None)
    worth, unseen_ray, worth_if_agreed, unseen_if_agreed, unseen_if_one = (wp.constant(wp.float64(x)) for x in numbers)

    @wp.func
    def widths_of(
        variance: wp.vec3d,
        expected: wp.vec3d,
        unseen: wp.vec3d,
        rest: wp.vec3d,
        fourth: wp.vec3d,
        mixed: wp.int32,
        fewer: wp.int32,
        strata: wp.int32,
    ):
        """Return squared scale and degrees of freedom of the t-distributed error of an estimate, for each of its channels.

        `unseen` is the sum over the strata of the squared weight of one ray.
        """
        width = NOTHING
        degrees = NOTHING
        prior = Prior(worth, unseen_ray, worth_if_agreed, unseen_if_agreed, unseen_if_one)
        for c in range(channels):
            of_ray = unseen[c] / wp.float64(strata)
            square, freedom = posterior(variance[c], expected[c], of_ray, rest[c], fourth[c], mixed, fewer, strata, prior)
            width[c] = square
            degrees[c] = freedom
        return width, degrees

    return widths_of


@once
def shaft_finder(slots: Slots) -> wp.Function:
    """Build the Warp function that searches a shaft, the region that the rays of a stratum or sector cross, for faces."""
    find, wide = finder_of(slots.glass), slots.wide

    @wp.func
    def find_in_shaft(
        lobes: Lobes,
        tree: Accelerator,
        point: ShadingPoint,
        shaft: wp.int32,
        found: wp.int32,
        local: wp.int32,
        opened: wp.bool,
    ):
        """Return the kinds of faces in a shaft and the nodes to start from; `found` and `local` if no search is possible."""
        kinds = found
        start = local
        if wp.static(wide):
            if opened and lobes.shafts != wp.uint64(0) and found != 0:
                kinds, start = find(lobes, tree, point, shaft, local)
        return kinds, start

    return find_in_shaft


@once
def traced_lobe(slots: Slots) -> wp.Function:
    """Build the Warp function that casts all rays of one point against a mesh and sums their weights."""
    find_in_shaft, of_glass = shaft_finder(slots), GLASS if slots.glass else 0
    constant, struct, wide, open_jump = slots.constant, slots.struct, slots.wide, ONE if slots.any_hit else HALF
    sum_stratum, widths, jump_at = stratum_sum(slots), widths_of(slots), jump_of(slots)

    @wp.func
    def sum_lobe(lobes: Lobes, accelerator: Accelerator, data: struct, point: ShadingPoint):
        """Trace the rays of one point against a mesh; return the sum of their weights, its error, and counts of rays.

        They are: the sum of the weights, its squared standard error, its squared spread, the degrees of freedom, the number
        of rays cast, and the number of rays in strata proven empty.
        """
        total = NOTHING
        variance = NOTHING
        mixed = wp.int32(0)
        fewer = wp.int32(0)
        expected = NOTHING
        unseen = NOTHING
        rest = NOTHING
        fourth = NOTHING
        cast = wp.int32(0)
        empty = wp.int32(0)
        seen = accelerator
        local = wp.int32(0)
        opened = wp.bool(False)
        if wp.static(wide):
            if lobes.skip != 0:
                seen, local, opened = open_around(accelerator, point)
        for sector in range(lobes.sectors):
            in_sector = wp.where(seen.starts == 0 and local == 0, 0, BLOCKERS) | of_glass
            for step in range(wp.where(lobes.bands > 2, 0, 1), lobes.bands + 1):  # step 0: whole sector
                found, start = find_in_shaft(lobes, seen, point, sector * (lobes.bands + 1) + step, in_sector, local, opened)
                if step == 0:
                    in_sector = found
                elif wp.static(constant) and found == 0:
                    empty += 2 * lobes.samples_per_stratum
                    total[0] += wp.float64(2 * lobes.samples_per_stratum)
                    unseen[0] += open_jump
                else:
                    empty += wp.where(found == 0, 2 * lobes.samples_per_stratum, 0)
                    stratum = sector * lobes.bands + step - 1
                    add, difference, rays, free, counted, w = sum_stratum(lobes, seen, data, point, stratum, found, start)
                    cast += rays
                    squares = wp.cw_mul(difference, difference)
                    total += add
                    variance += squares
                    jump = jump_at(w, add, free, counted)
                    unseen += jump
                    if free > 0 and free < counted:
                        expected += edge_variance(free, counted, lobes.edge) * jump
                        mixed += 1
                        fewer += wp.min(free, counted - free)
                    else:
                        rest += squares
                        fourth += wp.cw_mul(squares, squares)
        width, degrees = widths(variance, expected, unseen, rest, fourth, mixed, fewer, lobes.bands * lobes.sectors)
        return total, variance, width, degrees, cast, empty

    return sum_lobe
