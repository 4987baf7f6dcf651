"""What a point knows of a beam about suns without a ray: that it meets nothing, or that one triangle blocks all of it."""

import warp as wp

from warpsample.estimate.skipping.beams import meets, triangles_in
from warpsample.estimate.skipping.frontier import NEAR, frontier
from warpsample.estimate.spot import start_beam
from warpsample.radiation.sun.shafts import covering, highest
from warpsample.radiation.sun.view import Suns, View, known_triangles
from warpsample.tracing.placement import far_off
from warpsample.tracing.wide.layout import Accelerator

MET, LIT, DARK = (wp.constant(wp.int32(i)) for i in range(3))
"""What is known of a beam: nothing; none of its rays meets anything; all do, or are below the horizon."""

_VISITS = wp.constant(wp.int32(32))  # nodes and leaves that a beam may look into: as long as five rays take
_AVERTED = wp.constant(wp.float32(-(2.0**-18)))


@wp.func
def open_around(suns: Suns, accelerator: Accelerator, view: View):
    """(the point, the tree as its rays see it); the tree is opened around the point if anything may be skipped."""
    view.skips = suns.skip != 0 and not far_off(view.place)
    if view.skips:
        starts, around = frontier(accelerator, view.o, view.n, view.low, view.reach, view.room, view.scratch)
        view.near = (1 << around) - 1
        if starts >= 0:
            accelerator.start = view.room
            accelerator.starts = starts
    return view, accelerator


@wp.func
def darkened(view: View, vectors: wp.uint64) -> wp.bool:
    """Whether one known triangle blocks all rays of a beam."""
    known = known_triangles(view)
    if known == 0:
        return False
    return (covering(view.known, vectors, view.o) & known) != 0  # within reach: coordinates are below 1e36


@wp.func
def _met(seen: Accelerator, view: View, vectors: wp.uint64) -> wp.bool:
    """Whether a ray of a beam may meet something."""
    if seen.starts == 0 and view.near == 0:
        return False
    start_beam(vectors, view.n, view.o, view.low, view.beam)
    found = wp.int32(0)
    known = known_triangles(view)
    if known != 0:
        found = triangles_in(view.known, view.beam) & known
    if found == 0 and view.near != 0:
        found = triangles_in(view.room + NEAR, view.beam) & view.near
    if found == 0 and seen.starts > 0:
        found = meets(seen, view.beam, _VISITS, view.scratch)
    return found != 0


@wp.func
def proven(seen: Accelerator, view: View, vectors: wp.uint64) -> wp.int32:
    """MET, LIT or DARK. Of what is LIT, rays below `LEAST_COSINE` are to be traced all the same."""
    if highest(vectors, view.n) < _AVERTED:
        return DARK
    if darkened(view, vectors):
        return DARK
    return wp.where(_met(seen, view, vectors), MET, LIT)
