"""The faces that touch a point, or are within a little of it: a walk over all of them."""

from typing import Any

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.numerics import lowest_bit
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.wide.around import children_around, triangles_touched
from warpsample.tracing.wide.layout import face_in
from warpsample.tracing.wide.walk import tree_walk


@once
def faces_touching(look: wp.Function, asked: Any, answer: Any) -> wp.Function:
    """A function (tree, what is asked, answer so far, scratch) -> answer, after a look at each face that touches a point.

    A few that are beside it are looked at, too.

    Args:
        look: (face, what is asked, answer so far) -> answer.
        asked: the type of what is asked, with the point `p`, vec3, and how near `r` is to it.
        answer: that of the answer.
    """

    @wp.func
    def enter(node: wp.uint64, what: asked):
        return children_around(node, what.p, what.r)

    @wp.func
    def look_into(leaf: wp.uint64, what: asked, found: answer):
        touched = triangles_touched(leaf, what.p, what.r)
        for _ in range(wp.bit_count(touched)):
            found = look(face_in(leaf, lowest_bit(touched)), what, found)
            touched = touched & (touched - 1)
        return found, wp.bool(False)

    walk = tree_walk(enter, look_into, asked, answer)

    @wp.func
    def look_around(tree: Accelerator, what: asked, found: answer, scratch: wp.uint64):
        found, _spent = walk(tree, what, found, 0, scratch)
        return found

    return look_around
