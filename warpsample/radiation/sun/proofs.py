"""What a point knows of a shaft about suns without a ray: that it meets nothing, or that one triangle blocks all of it."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import greater
from warpsample.radiation.sun.view import Suns, View, known_triangles
from warpsample.tracing.placement import is_far_off
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.cover import covering_triangles
from warpsample.tracing.sight.frontier import open_around
from warpsample.tracing.sight.search import EMPTY, search_shaft
from warpsample.tracing.sight.shafts import CORNERS, aim_at, corner_of, triangles_in

MET: wp.int32 = wp.constant(wp.int32(0))
LIT: wp.int32 = wp.constant(wp.int32(1))
DARK: wp.int32 = wp.constant(wp.int32(2))
"""What is known of a shaft: nothing; none of its rays meets anything; all do, or are below the horizon."""

_AVERTED = wp.constant(wp.float32(-(2.0**-18)))


COVER_MARGIN: wp.float32 = wp.constant(wp.float32(2.0**-19))
"""By which a shaft must be within a triangle that darkens it: directions are rounded by at most 2^-20.4."""


@wp.func
def opened(suns: Suns, tree: Accelerator, view: View):
    """(the point, the tree as its rays see it); the tree is opened around the point if anything may be skipped."""
    view.skips = suns.skip != 0 and not is_far_off(view.point.position)
    if view.skips:
        tree, local, _opened = open_around(tree, view.point)
        view.local = local
    return view, tree


@wp.func
def highest(vectors: wp.uint64, n: wp.vec3) -> wp.float32:
    """The greatest cosine of a shaft's corners to a unit vector: none of its directions has a greater one above 0."""
    most = wp.float32(-1.0)
    for i in range(CORNERS):
        most = greater(most, wp.dot(corner_of(vectors, i), n))
    return most


@wp.func
def darkened(view: View, vectors: wp.uint64) -> wp.bool:
    """Whether one known triangle blocks all rays of a shaft."""
    known = known_triangles(view)
    if known == 0:
        return False
    return (
        covering_triangles(view.known, vectors, view.point.o, COVER_MARGIN) & known
    ) != 0  # within reach: coordinates are below 1e36


@wp.func
def _met(seen: Accelerator, view: View, vectors: wp.uint64) -> wp.bool:
    """Whether a ray of a shaft may meet something."""
    if seen.starts == 0 and view.local == 0:
        return False
    aim_at(vectors, view.point)
    known = known_triangles(view)
    if known != 0 and (triangles_in(view.known, view.point.shaft) & known) != 0:
        return True
    return search_shaft(seen, view.point, view.local).state != EMPTY


@once
def prover(glass: bool) -> wp.Function:
    """A function that tells what is known of a shaft, of a mesh with faces that let some light through, or without."""

    @wp.func
    def proven(suns: Suns, seen: Accelerator, view: View, vectors: wp.uint64) -> wp.int32:
        """MET, LIT or DARK. Of what is LIT, rays below `LEAST_COSINE` are to be traced all the same."""
        if highest(vectors, view.point.n) < _AVERTED:
            return DARK
        if darkened(view, vectors):
            return DARK
        state = wp.where(_met(seen, view, vectors), MET, LIT)
        if wp.static(glass) and state == LIT:
            aim_at(vectors, view.point)
            state = wp.where(search_shaft(suns.glass.tree, view.point, 0).state == EMPTY, LIT, MET)
        return state

    return proven
