"""Search for triangles in a shaft (pyramid of directions): none, some, or undecided after a limited number of visits."""

import warp as wp

from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.point import LOCAL_LEAF, ShadingPoint
from warpsample.tracing.sight.shafts import boxes_in, triangles_in
from warpsample.tracing.wide.walk import tree_walk

EMPTY: wp.int32 = wp.constant(wp.int32(0))
OCCUPIED: wp.int32 = wp.constant(wp.int32(1))
UNDECIDED: wp.int32 = wp.constant(wp.int32(2))
"""State of a shaft: no ray of it hits anything; it contains triangles that a ray may hit; undecided."""

_VISITS = wp.constant(wp.int32(32))  # limit on nodes and leaves to look into: the time of five rays


@wp.struct
class InShaft:
    """Result of a search for triangles in a shaft (pyramid of directions).

    Attributes:
        state: EMPTY, OCCUPIED or UNDECIDED.
        leaf: address of the first leaf with triangles in the shaft.
        triangles: mask of these triangles.
    """

    state: wp.int32
    leaf: wp.uint64
    triangles: wp.int32


@wp.func
def _find_triangles_in(leaf: wp.uint64, shaft: wp.uint64, found: InShaft):
    """Return the search result with the triangles of a tree leaf that are in a shaft, and whether there are any."""
    found.leaf = leaf
    found.triangles = triangles_in(leaf, shaft)
    return found, found.triangles != 0


_walk = tree_walk(boxes_in, _find_triangles_in, wp.uint64, InShaft)


@wp.func
def search_shaft(tree: Accelerator, point: ShadingPoint, local: wp.int32) -> InShaft:
    """Search the tree for triangles in a shaft, a pyramid of directions from a point.

    The triangles `local` of the point's local leaf are tested first.
    """
    found = InShaft()
    if local != 0:
        found.leaf = point.opened + LOCAL_LEAF
        found.triangles = triangles_in(found.leaf, point.shaft) & local
    spent = wp.bool(False)
    if found.triangles == 0 and tree.starts > 0:
        found, spent = _walk(tree, point.shaft, found, _VISITS, point.scratch)
    found.state = wp.where(found.triangles != 0, OCCUPIED, wp.where(spent, UNDECIDED, EMPTY))
    return found


@wp.func
def in_local_leaf(found: InShaft, point: ShadingPoint) -> wp.int32:
    """Return a mask of the nearby triangles of a point that a search found in a shaft (pyramid of directions)."""
    return wp.where(found.leaf == point.opened + LOCAL_LEAF, found.triangles, 0)
