"""The search for what is in a shaft that is aimed from a point: nothing, some triangles, or more than a few visits tell."""

import warp as wp

from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.point import LOCAL_LEAF, ShadingPoint
from warpsample.tracing.sight.shafts import boxes_in, triangles_in
from warpsample.tracing.wide.walk import tree_walk

EMPTY: wp.int32 = wp.constant(wp.int32(0))
OCCUPIED: wp.int32 = wp.constant(wp.int32(1))
UNTOLD: wp.int32 = wp.constant(wp.int32(2))
"""What is known of a shaft: none of its rays meets anything; there are triangles that one may meet; neither."""

_VISITS = wp.constant(wp.int32(32))  # nodes and leaves that are looked into: as long as five rays take


@wp.struct
class InShaft:
    """What is found in a shaft.

    state: EMPTY, OCCUPIED or UNTOLD. leaf: address of the leaf in which triangles were found. triangles: their mask.
    """

    state: wp.int32
    leaf: wp.uint64
    triangles: wp.int32


@wp.func
def _look(leaf: wp.uint64, shaft: wp.uint64, found: InShaft):
    """(what is found, with a leaf; whether that is enough)."""
    found.leaf = leaf
    found.triangles = triangles_in(leaf, shaft)
    return found, found.triangles != 0


_walk = tree_walk(boxes_in, _look, wp.uint64, InShaft)


@wp.func
def search_shaft(tree: Accelerator, point: ShadingPoint, local: wp.int32) -> InShaft:
    """What is in the shaft that is aimed from a point; first looked into are the triangles `local` of its local leaf."""
    found = InShaft()
    if local != 0:
        found.leaf = point.opened + LOCAL_LEAF
        found.triangles = triangles_in(found.leaf, point.shaft) & local
    spent = wp.bool(False)
    if found.triangles == 0 and tree.starts > 0:
        found, spent = _walk(tree, point.shaft, found, _VISITS, point.scratch)
    found.state = wp.where(found.triangles != 0, OCCUPIED, wp.where(spent, UNTOLD, EMPTY))
    return found


@wp.func
def in_local_leaf(found: InShaft, point: ShadingPoint) -> wp.int32:
    """Mask of the triangles of the local leaf that are in the shaft."""
    return wp.where(found.leaf == point.opened + LOCAL_LEAF, found.triangles, 0)
