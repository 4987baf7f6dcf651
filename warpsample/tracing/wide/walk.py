"""The walk over the tree that whatever is no ray takes, and the stack of nodes that wait, which rays have too."""

from typing import Any

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import address_at, int_at, set_address, set_float, set_int
from warpsample.maths.numerics import lowest_bit
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.wide.layout import NODE_BYTES, leaf_at, link_in, node_at

WAITING: wp.uint64 = wp.constant(wp.uint64(4 * 4))
"""Bytes of a node that waits on the stack: its address, a mask of its children, and the reach they were found with."""

_NOT_LOOKED_AT = wp.constant(wp.int32(-1))


@wp.func
def put_aside(top: wp.uint64, node: wp.uint64, mask: wp.int32, reach: wp.float32) -> wp.uint64:
    """The new top of the stack of nodes that wait, with the children to be visited and the reach they were found with."""
    set_address(top, 0, node)
    set_int(top, 2, mask)
    set_float(top, 3, reach)
    return top + WAITING


@once
def tree_walk(enter: wp.Function, look: wp.Function, asked: Any, answer: Any) -> wp.Function:
    """A function (Accelerator, what is asked, answer so far, visits, scratch) -> (answer, whether the visits did not do).

    `visits` is how many nodes and leaves are looked into at most, 0 for all; `scratch` the address of SCRATCH words.

    Args:
        enter: (node, what is asked) -> mask of the children to be visited.
        look: (leaf, what is asked, answer so far) -> (answer, whether that is enough).
        asked: the type of what is asked.
        answer: that of the answer.
    """

    @wp.func
    def walk(tree: Accelerator, what: asked, found: answer, visits: wp.int32, scratch: wp.uint64):
        top = scratch
        for other in range(1, tree.starts):
            top = put_aside(top, tree.start + wp.uint64(other) * wp.uint64(NODE_BYTES), _NOT_LOOKED_AT, 0.0)
        node = tree.start
        mask = _NOT_LOOKED_AT
        spent = wp.bool(False)
        searching = tree.starts > 0
        while searching:
            if mask == _NOT_LOOKED_AT:
                mask = enter(node, what)
            elif mask != 0:
                child = lowest_bit(mask)
                mask = mask & (mask - 1)
                link = link_in(node, child)
                enough = wp.bool(False)
                if link < 0:
                    found, enough = look(leaf_at(tree, ~link), what, found)
                else:
                    if mask != 0:
                        top = put_aside(top, node, mask, 0.0)
                    node = node_at(tree, link)
                    mask = _NOT_LOOKED_AT
                visits -= 1
                spent = visits == 0 and not enough
                searching = not (enough or spent)
            elif top != scratch:
                top -= WAITING
                node = address_at(top, 0)
                mask = int_at(top, 2)
            else:
                searching = wp.bool(False)
        return found, spent

    return walk
