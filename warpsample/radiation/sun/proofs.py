"""Proofs that a group of sun directions is lit or dark without rays: nothing blocks it, or one triangle blocks it."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import greater
from warpsample.radiation.sun.view import Suns, View, blocker_mask
from warpsample.tracing.placement import is_far_off
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.cover import covering_triangles
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.search import EMPTY, search_shaft
from warpsample.tracing.sight.shafts import CORNERS, aim_at, corner_of, triangles_in

UNKNOWN: wp.int32 = wp.constant(wp.int32(0))
LIT: wp.int32 = wp.constant(wp.int32(1))
DARK: wp.int32 = wp.constant(wp.int32(2))
"""States of a shaft. UNKNOWN: undecided. LIT: no ray hits anything. DARK: each ray is blocked or below the horizon."""

_AVERTED = wp.constant(wp.float32(-(2.0**-18)))


COVER_MARGIN: wp.float32 = wp.constant(wp.float32(2.0**-19))
"""Margin by which a triangle must cover a shaft to block all of its rays; rounding moves directions by at most 2^-20.4."""


@wp.func
def open_tree(suns: Suns, tree: Accelerator, view: View):
    """Restrict the search tree to what rays from a point can hit; return (state of the point, restricted tree).

    If rays may be skipped, the tree is opened around the point.
    """
    view.skips = suns.skip != 0 and not is_far_off(view.point.position)
    if view.skips:
        tree, local, _opened = open_around(tree, view.point)
        view.local = local
    return view, tree


@wp.func
def highest(vectors: wp.uint64, n: wp.vec3) -> wp.float32:
    """Return the greatest dot product of n with the four corner directions of a pyramid of directions."""
    most = wp.float32(-1.0)
    for i in range(CORNERS):
        most = greater(most, wp.dot(corner_of(vectors, i), n))
    return most


@wp.func
def is_darkened(view: View, vectors: wp.uint64) -> wp.bool:
    """Return whether a triangle that blocked an earlier ray of the point blocks a whole pyramid of directions."""
    known = blocker_mask(view)
    if known == 0:
        return False
    return (
        covering_triangles(view.blockers, vectors, view.point.o, COVER_MARGIN) & known
    ) != 0  # within reach: coordinates are below 1e36


@wp.func
def _may_be_hit(seen: Accelerator, view: View, vectors: wp.uint64) -> wp.bool:
    """Return whether a ray of a shaft (pyramid of directions) may hit something."""
    if seen.starts == 0 and view.local == 0:
        return False
    aim_at(vectors, view.point)
    known = blocker_mask(view)
    if known != 0 and (triangles_in(view.blockers, view.point.shaft) & known) != 0:
        return True
    return search_shaft(seen, view.point, view.local).state != EMPTY


@once
def prover(glass: bool) -> wp.Function:
    """Build the Warp function that decides whether a point sees all suns in a pyramid of directions, or none.

    `glass` is for meshes with translucent faces.
    """

    @wp.func
    def classify_shaft(suns: Suns, seen: Accelerator, view: View, vectors: wp.uint64) -> wp.int32:
        """Return whether all suns in a pyramid of directions are visible (LIT), all blocked (DARK), or neither (UNKNOWN).

        Rays of a LIT shaft with a cosine below `LEAST_COSINE` must be traced all the same.
        """
        if highest(vectors, view.point.n) < _AVERTED:
            return DARK
        if is_darkened(view, vectors):
            return DARK
        state = wp.where(_may_be_hit(seen, view, vectors), UNKNOWN, LIT)
        if wp.static(glass) and state == LIT:
            aim_at(vectors, view.point)
            state = wp.where(search_shaft(suns.glass.tree, view.point, 0).state == EMPTY, LIT, UNKNOWN)
        return state

    return classify_shaft
