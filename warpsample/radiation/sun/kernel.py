"""Kernel that finds the suns (sun positions) that each point sees.

Groups of suns are proven lit or dark, or rays are cast to their suns; no ray is stored.
"""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import set_byte, set_float, set_int
from warpsample.maths.numerics import ONE, ZERO
from warpsample.radiation.sun.proofs import DARK, LIT, UNKNOWN, is_darkened, open_tree, prover
from warpsample.radiation.sun.rays import (
    DISC_RAYS,
    GROUP_BYTES,
    LEAST_COSINE,
    aim_at_disc,
    aim_at_group,
    is_blocked,
    sun_number,
    sun_of,
)
from warpsample.radiation.sun.suns import GROUP
from warpsample.radiation.sun.view import CAST, OWN_FLOATS, PROVEN, Suns, View, add, cosine_to, view_of, word
from warpsample.sequences.hashing import point_key
from warpsample.tracing.placement import id_of
from warpsample.tracing.queries import CHUNK_FLOATS, Accelerator, direction_of
from warpsample.tracing.sight.point import orient_point, place_point, point_in, workspace_floats
from warpsample.tracing.sight.rays import glass_transmittance

_FLOATS = workspace_floats(OWN_FLOATS)
_TALLIES = 3
_WHOLE = wp.constant(wp.float64(2.0**-18))  # a disc this far above the horizon has no ray that rounding moves below it


@wp.func
def _add_weights(suns: Suns, view: View, column: wp.int32, factor: wp.float64):
    """Add the weights of sun number `column`, times a factor, to the sums of a point."""
    row = wp.uint64(8 * suns.channels)
    total = wp.array(ptr=suns.answer + wp.uint64(view.point.index) * row, shape=(suns.channels,), dtype=wp.float64)
    weights = wp.array(ptr=suns.weights + wp.uint64(column) * row, shape=(suns.channels,), dtype=wp.float64)
    m = wp.int32(0)
    while m < suns.channels:
        total[m] = total[m] + weights[m] * factor
        m += 1


@once
def _build_recorder(shares: bool) -> wp.Function:
    """Build the Warp function that writes to the result that a point sees a sun, or what share of it."""

    @wp.func
    def keep(suns: Suns, view: View, column: wp.int32, share: wp.float32, cosine: wp.float64):
        at = wp.uint64(view.point.index) * wp.uint64(suns.count) + wp.uint64(column)
        if suns.weights != wp.uint64(0):
            _add_weights(suns, view, column, wp.float64(share) * wp.where(suns.cosine != 0, cosine, ONE))
        elif wp.static(shares):
            set_float(suns.answer + at * wp.uint64(4), 0, share)
        else:
            set_byte(suns.answer + at, 0, 1)

    return keep


@once
def _build_transmission(glass: bool) -> wp.Function:
    """Build the Warp function that returns the share of sunlight that translucent faces transmit along a ray."""

    @wp.func
    def transmitted(suns: Suns, view: View, k: wp.int32) -> wp.float32:
        """Return the share of light that translucent faces transmit along the k-th ray; 1 without translucent faces."""
        share = wp.float32(1.0)
        if wp.static(glass):
            share = glass_transmittance(suns.glass, view.point, k)
        return share

    return transmitted


@once
def _build_points_test(glass: bool) -> wp.Function:
    """Build the Warp function that tests which suns of a group a point sees; suns have no size here."""
    keep, transmitted = _build_recorder(glass), _build_transmission(glass)

    @wp.func
    def look_at_points(
        suns: Suns, whole: Accelerator, seen: Accelerator, view: View, group: wp.int32, shaft: wp.uint64, state: wp.int32
    ):
        """Record which suns of a group a point sees; cast rays unless `state` says that all are visible or all blocked."""
        aimed = wp.int32(0)
        k = wp.int32(0)
        while k < GROUP:
            cosine = cosine_to(view.point.n, sun_of(suns, group, k))
            if cosine > ZERO and state != DARK:
                column = sun_number(suns, group, k)
                if state == LIT and cosine >= LEAST_COSINE:
                    add(view, PROVEN, 1)
                    keep(suns, view, column, 1.0, cosine)
                else:
                    if aimed == 0:
                        aim_at_group(suns, seen, view, group)
                        aimed = 1
                    cast = word(view, CAST)
                    if not is_blocked(suns, whole, seen, view, k, cosine):
                        keep(suns, view, column, transmitted(suns, view, k), cosine)
                    elif shaft != wp.uint64(0) and cast != word(view, CAST):  # blocked by a new triangle
                        state = wp.where(is_darkened(view, shaft), DARK, state)
            k += 1

    return look_at_points


@once
def _build_disc_share(glass: bool) -> wp.Function:
    """Build the Warp function that estimates the visible share of a sun's disc by rays."""
    transmitted = _build_transmission(glass)

    @wp.func
    def share_of(
        suns: Suns, whole: Accelerator, seen: Accelerator, view: View, column: wp.int32, sun: wp.vec3, state: wp.int32
    ) -> wp.float32:
        """Return the share of a sun's disc that is above the horizon and not blocked.

        Rays well above the horizon are not cast if the disc is known to be LIT.
        """
        dark = wp.int32(0)
        lost = wp.float32(0.0)
        aim_at_disc(suns, seen, view, column, sun)
        k = wp.int32(0)
        while k < DISC_RAYS:
            cosine = cosine_to(view.point.n, direction_of(view.point.chunk, k))
            if cosine <= ZERO:
                dark += 1
            elif state != LIT or cosine < LEAST_COSINE:
                if is_blocked(suns, whole, seen, view, k, cosine):
                    dark += 1
                elif wp.static(glass):
                    lost += 1.0 - transmitted(suns, view, k)
            k += 1
        return (wp.float32(DISC_RAYS - dark) - lost) / wp.float32(DISC_RAYS)

    return share_of


@once
def _build_discs_test(glass: bool) -> wp.Function:
    """Build the Warp function that computes the visible share of each sun's disc, for the suns of a group."""
    keep, proven, share_of = _build_recorder(True), prover(glass), _build_disc_share(glass)

    @wp.func
    def look_at_discs(
        suns: Suns, whole: Accelerator, seen: Accelerator, view: View, group: wp.int32, shaft: wp.uint64, state: wp.int32
    ):
        """Record the visible share of each sun's disc in a group; cast rays only to discs that are not decided otherwise."""
        k = wp.int32(0)
        while k < GROUP:
            sun = sun_of(suns, group, k)
            cosine = cosine_to(view.point.n, sun)
            if cosine > ZERO:
                column = sun_number(suns, group, k)
                own = state
                if state == UNKNOWN and view.skips and shaft != wp.uint64(0):
                    own = proven(suns, seen, view, suns.disc_shafts + wp.uint64(group * GROUP + k) * GROUP_BYTES)
                if own == LIT and cosine > suns.sine + _WHOLE:
                    add(view, PROVEN, 1)
                    keep(suns, view, column, 1.0, cosine)
                elif own != DARK:
                    keep(suns, view, column, share_of(suns, whole, seen, view, column, sun, own), cosine)
            k += 1

    return look_at_discs


@once
def _build_sun_test(disc: bool, glass: bool) -> wp.Function:
    """Build the Warp function that finds all suns that one point sees."""
    look, proven = (_build_discs_test if disc else _build_points_test)(glass), prover(glass)

    @wp.func
    def look_all(suns: Suns, accelerator: Accelerator, view: View):
        """Find the suns that one point sees; groups that are all visible or all blocked are decided without rays."""
        view, seen = open_tree(suns, accelerator, view)
        node = wp.int32(0)
        while node < suns.nodes:
            span = wp.array(ptr=suns.spans + wp.uint64(node) * wp.uint64(16), shape=(4,), dtype=wp.int32)
            state = wp.int32(UNKNOWN)
            shaft = wp.uint64(0)
            if view.skips and span[3] != 0:
                shaft = suns.shafts + wp.uint64(node) * GROUP_BYTES
                state = proven(suns, seen, view, shaft)
            if state == LIT or (state == UNKNOWN and span[1] == span[0] + 1):
                for group in range(span[0], span[1]):
                    look(suns, accelerator, seen, view, group, shaft, state)
            node = wp.where(state == UNKNOWN, node + 1, span[2])

    return look_all


@once
def sun_kernel(disc: bool, glass: bool = False) -> wp.Kernel:
    """Build the kernel that tests all suns from all points, one point per task in the processing order.

    `disc` selects discs instead of points. `glass` is for meshes with transmitting faces; the results are then shares.
    """
    look_all = _build_sun_test(disc, glass)

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def each_point(suns: Suns, accelerator: Accelerator, first_task: wp.int64):
        memory = wp.zeros(shape=(_FLOATS,), dtype=wp.float32)
        task = first_task + wp.int64(wp.tid())
        point = orient_point(point_in(memory.ptr, OWN_FLOATS, CHUNK_FLOATS), suns.placement, suns.normals, suns.active, task)
        point = place_point(point, suns.placement, 2)
        if wp.static(disc):
            point.key = point_key(suns.seed, id_of(suns.placement, suns.first_point, point.index))
        view = view_of(point)
        if point.status == 0:
            look_all(suns, accelerator, view)
        if suns.tally != wp.uint64(0):
            row = suns.tally + wp.uint64(point.index) * wp.uint64(4 * _TALLIES)
            for i in range(_TALLIES):
                set_int(row, i, word(view, PROVEN + i))

    return each_point
