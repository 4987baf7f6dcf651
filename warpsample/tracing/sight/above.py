"""Whether anything stands above a plane."""

import warp as wp

from warpsample.tracing.queries import Accelerator
from warpsample.tracing.sight.frontier import limit_of_boxes, triangles_above, visible
from warpsample.tracing.wide.walk import tree_walk

_VISITS = wp.constant(wp.int32(256))  # nodes and leaves that are looked into: as long as a few dozen rays take
_ANYWHERE = wp.constant(wp.float32(wp.INF))


@wp.struct
class Above:
    """A plane, above which x n is at least the limit."""

    n: wp.vec3
    limit: wp.float32


@wp.func
def _enter(node: wp.uint64, plane: Above):
    """Mask of the children whose boxes reach above the plane."""
    mask, _around = visible(node, wp.vec3(0.0), plane.n, limit_of_boxes(plane.limit, plane.n), _ANYWHERE)
    return mask


@wp.func
def _look(leaf: wp.uint64, plane: Above, found: wp.bool):
    """(whether a triangle reaches above the plane, whether that is enough)."""
    found = triangles_above(leaf, plane.n, plane.limit) != 0
    return found, found


_walk = tree_walk(_enter, _look, Above, wp.bool)


@wp.func
def stands_above(tree: Accelerator, n: wp.vec3, limit: wp.float32, scratch: wp.uint64) -> wp.bool:
    """Whether a triangle reaches as far along n as the limit, or so many visits do not tell."""
    plane = Above()
    plane.n = n
    plane.limit = limit
    found, spent = _walk(tree, plane, wp.bool(False), _VISITS, scratch)
    return found or spent
