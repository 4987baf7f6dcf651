"""Boxes and triangles in the nodes and leaves of the 16-wide search tree, computed from the vertices."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.maths.memory import float_at, set_float, vec3_at, vec3i_at
from warpsample.tracing.queries import AcceleratorArgs
from warpsample.tracing.wide.build import Topology
from warpsample.tracing.wide.layout import LEAF_BYTES, NODE_BYTES, WIDTH

PADDING = 2.0**-17
"""Enlargement of boxes on each side, in the tree's coordinates, where the mesh is within 1 of 0 and ray origins within 6.

The distance of a plane is rounded in the direction's inverse, in its product with the origin, and in the sum: along the
axis, by 2^-24 of 7, 6 and 7. A corner of a triangle is rounded by 2^-24 of 7 in each of three steps, so that a ray may hit
a triangle at that distance beside it. The sum of these errors is 2^-18.6.
"""

_PADDING = wp.constant(wp.float32(PADDING))
_NOWHERE = wp.constant(wp.float32(2.0**60))  # times an inverse of 2^60 at most: finite
_NODE_FLOATS = NODE_BYTES // 4
_LEAF_FLOATS = LEAF_BYTES // 4
_LINE = 64


@dataclass(frozen=True, eq=False)
class WideTree:
    """Search tree with 16 children per node, over the triangles of a mesh.

    Attributes:
        topology: links to the nodes' children, and the leaves' faces.
        nodes: (nodes, 8, 16) float32, in the layout of the module `layout`.
        leaves: (leaves, 10, 16) float32, likewise.
    """

    topology: Topology
    nodes: np.ndarray
    leaves: np.ndarray

    def accelerator(self) -> Any:
        """Return the kernel argument with the addresses of the tree's nodes and leaves; valid while the tree lives."""
        return AcceleratorArgs(
            nodes=self.nodes.ctypes.data, leaves=self.leaves.ctypes.data, start=self.nodes.ctypes.data, starts=1
        )


def fill(topology: Topology, vertices: np.ndarray, faces: np.ndarray, workers: int) -> WideTree:
    """Fill the nodes of a 16-wide tree with boxes, and the leaves with triangles.

    Args:
        topology: tree of the faces.
        vertices: (V, 3) float32, within 1 of 0.
        faces: (F, 3) int32.
        workers: number of threads.
    """
    leaves, nodes = len(topology.faces), len(topology.links)
    tree = WideTree(topology, _empty_aligned((nodes, 8, WIDTH)), _empty_aligned((leaves, 10, WIDTH)))
    leaf_boxes, node_boxes = np.empty((leaves, 2, 3), np.float32), np.empty((nodes, 2, 3), np.float32)
    edges = np.empty(leaves, np.float32)
    inputs = [a.ctypes.data for a in (topology.faces, vertices, faces, tree.leaves, leaf_boxes, edges)]
    run(_fill_leaves(), leaves, inputs, cpu(), workers=workers, work=128 * leaves)
    for first, last in list(pairwise(topology.levels))[::-1]:  # from the bottom
        inputs = [a.ctypes.data for a in (topology.links, leaf_boxes, edges, node_boxes, tree.nodes)]
        run(_fill_nodes(), last - first, [first, *inputs], cpu(), workers=workers, work=128 * (last - first))
    return tree


def _empty_aligned(shape: tuple[int, ...]) -> np.ndarray:
    """Return an uninitialised float32 array that starts at a cache line, so that no row of sixteen spans two lines."""
    size = 4 * int(np.prod(shape))
    raw = np.empty(size + _LINE, np.uint8)
    start = -raw.ctypes.data % _LINE
    return raw[start : start + size].view(np.float32).reshape(shape)


@once
def _fill_leaves() -> wp.Kernel:
    """Build a kernel that writes each leaf's triangles, box, and longest extent along an axis, one leaf per task."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def fill_leaves(
        leaf_faces: wp.uint64,
        vertices: wp.uint64,
        faces: wp.uint64,
        leaves: wp.uint64,
        boxes: wp.uint64,
        edges: wp.uint64,
        first_task: wp.int64,
    ):
        leaf = wp.int32(first_task) + wp.tid()
        mine = wp.array(ptr=leaf_faces + wp.uint64(leaf) * wp.uint64(4 * WIDTH), shape=(WIDTH,), dtype=wp.int32)
        rows = wp.array(ptr=leaves + wp.uint64(leaf) * wp.uint64(LEAF_BYTES), shape=(_LEAF_FLOATS,), dtype=wp.float32)
        box = wp.array(ptr=boxes + wp.uint64(leaf) * wp.uint64(24), shape=(2,), dtype=wp.vec3)
        low = wp.vec3(_NOWHERE)
        high = wp.vec3(-_NOWHERE)
        longest = wp.float32(0.0)
        k = wp.int32(0)
        while k < WIDTH:  # the compiler would unroll `range` and take four times as long
            a = wp.vec3(wp.NAN)  # no ray hits an empty lane
            b = a
            c = a
            if mine[k] >= 0:
                corners = vec3i_at(faces, mine[k])
                a = vec3_at(vertices, corners[0])
                b = vec3_at(vertices, corners[1])
                c = vec3_at(vertices, corners[2])
                least = wp.min(wp.min(a, b), c)
                most = wp.max(wp.max(a, b), c)
                longest = wp.max(longest, wp.max(most - least))
                low = wp.min(low, least)
                high = wp.max(high, most)
            for axis in range(3):
                rows[axis * WIDTH + k] = a[axis]
                rows[(3 + axis) * WIDTH + k] = b[axis]
                rows[(6 + axis) * WIDTH + k] = c[axis]
            rows[9 * WIDTH + k] = wp.cast(mine[k], wp.float32)
            k += 1
        box[0] = low
        box[1] = high
        set_float(edges, leaf, longest)

    return fill_leaves


@once
def _fill_nodes() -> wp.Kernel:
    """Build a kernel that writes each node's boxes from its children's boxes, one node of a level per task."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def fill_nodes(
        first_node: wp.int32,
        links: wp.uint64,
        leaf_boxes: wp.uint64,
        edges: wp.uint64,
        node_boxes: wp.uint64,
        nodes: wp.uint64,
        first_task: wp.int64,
    ):
        node = first_node + wp.int32(first_task) + wp.tid()
        below = wp.array(ptr=links + wp.uint64(node) * wp.uint64(4 * WIDTH), shape=(WIDTH,), dtype=wp.int32)
        rows = wp.array(ptr=nodes + wp.uint64(node) * wp.uint64(NODE_BYTES), shape=(_NODE_FLOATS,), dtype=wp.float32)
        own = wp.array(ptr=node_boxes + wp.uint64(node) * wp.uint64(24), shape=(2,), dtype=wp.vec3)
        low = wp.vec3(_NOWHERE)
        high = wp.vec3(-_NOWHERE)
        k = wp.int32(0)
        while k < WIDTH:
            link = below[k]
            lower = wp.vec3(_NOWHERE)
            upper = wp.vec3(-_NOWHERE)
            edge = wp.float32(0.0)
            if link != 0:
                address = node_boxes + wp.uint64(link) * wp.uint64(24)
                if link < 0:
                    address = leaf_boxes + wp.uint64(~link) * wp.uint64(24)
                    edge = float_at(edges, ~link)
                box = wp.array(ptr=address, shape=(2,), dtype=wp.vec3)
                low = wp.min(low, box[0])
                high = wp.max(high, box[1])
                lower = box[0] - wp.vec3(_PADDING)
                upper = box[1] + wp.vec3(_PADDING)
            for axis in range(3):
                rows[axis * WIDTH + k] = lower[axis]
                rows[(3 + axis) * WIDTH + k] = upper[axis]
            rows[6 * WIDTH + k] = wp.cast(link, wp.float32)
            rows[7 * WIDTH + k] = edge
            k += 1
        own[0] = low
        own[1] = high

    return fill_nodes
