"""Traversal of the 16-wide search tree with user-supplied tests, and the stack of nodes to visit."""

from typing import Any

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import address_at, int_at, set_address, set_float, set_int
from warpsample.maths.numerics import lowest_bit
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.wide.layout import NODE_BYTES, leaf_at, link_in, node_at

STACK_ENTRY: wp.uint64 = wp.constant(wp.uint64(4 * 4))
"""Bytes of one stack entry: the address of a node, a mask of its children, and the reach at which the mask was computed."""

_UNTESTED = wp.constant(wp.int32(-1))


@wp.func
def push_node(top: wp.uint64, node: wp.uint64, mask: wp.int32, reach: wp.float32) -> wp.uint64:
    """Push a tree node and a mask of its children to visit onto the stack; return the new top of the stack."""
    set_address(top, 0, node)
    set_int(top, 2, mask)
    set_float(top, 3, reach)
    return top + STACK_ENTRY


@once
def tree_walk(enter: wp.Function, look: wp.Function, query_type: Any, answer_type: Any) -> wp.Function:
    """Build a Warp function that searches the 16-wide tree with user-supplied tests of nodes and leaves.

    It maps (Accelerator, query, answer, visits, scratch) to (answer, exhausted). `answer` is the answer so far. `visits` is
    the largest number of nodes and leaves to look into, 0 for no limit. `exhausted` is True where that limit ended the
    search. `scratch` is the address of SCRATCH words.

    Args:
        enter: function (node, query) -> mask of the children to visit.
        look: function (leaf, query, answer) -> (answer, bool: True to end the search).
        query_type: type of the query.
        answer_type: type of the answer.
    """

    @wp.func
    def walk(tree: Accelerator, query: query_type, answer: answer_type, visits: wp.int32, scratch: wp.uint64):
        top = scratch
        for other in range(1, tree.starts):
            top = push_node(top, tree.start + wp.uint64(other) * wp.uint64(NODE_BYTES), _UNTESTED, 0.0)
        node = tree.start
        mask = _UNTESTED
        spent = wp.bool(False)
        searching = tree.starts > 0
        while searching:
            if mask == _UNTESTED:
                mask = enter(node, query)
            elif mask != 0:
                child = lowest_bit(mask)
                mask = mask & (mask - 1)
                link = link_in(node, child)
                enough = wp.bool(False)
                if link < 0:
                    answer, enough = look(leaf_at(tree, ~link), query, answer)
                else:
                    if mask != 0:
                        top = push_node(top, node, mask, 0.0)
                    node = node_at(tree, link)
                    mask = _UNTESTED
                visits -= 1
                spent = visits == 0 and not enough
                searching = not (enough or spent)
            elif top != scratch:
                top -= STACK_ENTRY
                node = address_at(top, 0)
                mask = int_at(top, 2)
            else:
                searching = wp.bool(False)
        return answer, spent

    return walk
