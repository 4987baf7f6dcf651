"""Construction of the 16-wide tree: assigns triangles to leaves, and leaves to nodes, by the surface-area heuristic.

The tree is built level by level, with one task for each node. A node starts as one range of triangles. The child with the
largest box is split in two until there are sixteen children.
"""

from dataclasses import dataclass, replace

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.maths.memory import int_at, vec3_at, vec3i_at
from warpsample.tracing.wide.layout import WIDTH
from warpsample.tracing.wide.sah import ALL_BINS, BINS, MOST_BINS, best_split, centres, fill_bins, partition

SAH_LEVELS = 14
"""Number of levels split by the surface-area heuristic.

Deeper nodes halve their ranges by count, so that no arrangement of triangles makes the tree deeper than 22 nodes.
"""


_BLOCK = 1 << 14  # leaves per block in `_leaf_faces`


@dataclass(frozen=True, eq=False)
class Topology:
    """Structure of the 16-wide tree, without the boxes and triangles: links of nodes and faces of leaves.

    Attributes:
        links: (nodes, 16) int32, links to children: a node number, ~number of a leaf, or 0 for no child.
        levels: number of the first node of each level, followed by the number of nodes.
        faces: (leaves, 16) int32, face numbers of the mesh in each leaf; -1 in empty lanes.
    """

    links: np.ndarray
    levels: list[int]
    faces: np.ndarray


def build(vertices: np.ndarray, faces: np.ndarray, workers: int) -> Topology:
    """Build the structure of the 16-wide tree over all triangles, from vertices (V, 3) float32 and faces (F, 3) int32."""
    count = len(faces)
    lower, upper = np.empty((count, 4), np.float32), np.empty((count, 4), np.float32)
    inputs = [a.ctypes.data for a in (vertices, faces, lower, upper)]
    run(_triangle_boxes(), count, inputs, cpu(), workers=workers, work=8 * count)
    begins, ends = np.array([0], np.int32), np.array([count], np.int32)
    links, leaf_begins, leaf_ends, levels = [], [], [], [0]
    leaves = 0
    while len(begins):
        children = np.zeros((3, len(begins), WIDTH), np.int32)
        by_area = int(len(levels) <= SAH_LEVELS)
        inputs = [a.ctypes.data for a in (lower, upper, begins, ends, *children)]
        run(_split_nodes(), len(begins), [by_area, *inputs], cpu(), workers=workers, work=128 * int((ends - begins).sum()))
        begin, end, used = children
        inner = end - begin > WIDTH
        leaf = (used != 0) & ~inner
        levels.append(levels[-1] + len(begins))
        link = np.zeros(inner.shape, np.int32)
        link[inner] = levels[-1] + np.arange(np.count_nonzero(inner))
        link[leaf] = ~(leaves + np.arange(np.count_nonzero(leaf)))
        leaves += np.count_nonzero(leaf)
        links.append(link)
        leaf_begins.append(begin[leaf])
        leaf_ends.append(end[leaf])
        begins, ends = begin[inner], end[inner]
    ranges = np.concatenate(leaf_begins), np.concatenate(leaf_ends)
    return Topology(np.concatenate(links), levels, _leaf_faces(lower[:, 3].view(np.int32), *ranges))


def build_some(vertices: np.ndarray, faces: np.ndarray, chosen: np.ndarray, workers: int) -> Topology:
    """Build the structure of the 16-wide search tree over some faces of a mesh, `chosen`.

    The arguments are those of `build` and the numbers of the chosen faces. Without any face the tree has one empty leaf,
    which no ray hits.
    """
    if len(chosen) == 0:
        return Topology(np.array([[~0, *[0] * (WIDTH - 1)]], np.int32), [0, 1], np.full((1, WIDTH), -1, np.int32))
    topology = build(vertices, np.ascontiguousarray(faces[chosen]), workers)
    return replace(topology, faces=np.where(topology.faces >= 0, chosen[topology.faces], -1).astype(np.int32))


def _leaf_faces(order: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the face numbers of each tree leaf, (leaves, 16) int32, padded with -1."""
    faces = np.empty((len(begin), WIDTH), np.int32)
    for start in range(0, len(faces), _BLOCK):
        rows = slice(start, start + _BLOCK)
        position = begin[rows, None] + np.arange(WIDTH)
        faces[rows] = np.where(position < end[rows, None], order[np.minimum(position, len(order) - 1)], -1)
    return faces


@once
def _triangle_boxes() -> wp.Kernel:
    """Build a kernel that writes the lower and upper corner of each triangle's box, one triangle per task.

    The fourth component of the lower corner holds the bits of the face number.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def triangle_boxes(vertices: wp.uint64, faces: wp.uint64, lower: wp.uint64, upper: wp.uint64, first_task: wp.int64):
        i = wp.int32(first_task) + wp.tid()
        corners = vec3i_at(faces, i)
        a = vec3_at(vertices, corners[0])
        b = vec3_at(vertices, corners[1])
        c = vec3_at(vertices, corners[2])
        low = wp.min(wp.min(a, b), c)
        high = wp.max(wp.max(a, b), c)
        lows = wp.array(ptr=lower, shape=(i + 1,), dtype=wp.vec4)
        highs = wp.array(ptr=upper, shape=(i + 1,), dtype=wp.vec4)
        lows[i] = wp.vec4(low[0], low[1], low[2], wp.cast(i, wp.float32))
        highs[i] = wp.vec4(high[0], high[1], high[2], 0.0)

    return triangle_boxes


@wp.func
def _choose_child_to_split(
    by_area: wp.int32,
    children: wp.int32,
    begins: wp.array[wp.int32],
    ends: wp.array[wp.int32],
    areas: wp.array[wp.float32],
) -> wp.int32:
    """Return the index of the child to split next: the largest with more triangles than a leaf holds, or -1."""
    largest = wp.int32(-1)
    most = wp.float32(-1.0)
    for k in range(children):
        size = ends[k] - begins[k]
        weight = wp.where(by_area != 0, areas[k], wp.float32(size))
        if size > WIDTH and weight > most:
            most = weight
            largest = k
    return largest


@once
def _split_nodes() -> wp.Kernel:
    """Build a kernel that splits each node of a level into up to 16 children, one node per task.

    It writes the children's ranges of triangles and marks the used children.
    """

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def split_nodes(
        by_area: wp.int32,
        lower: wp.uint64,
        upper: wp.uint64,
        begins: wp.uint64,
        ends: wp.uint64,
        child_begins: wp.uint64,
        child_ends: wp.uint64,
        child_used: wp.uint64,
        first_task: wp.int64,
    ):
        node = wp.int32(first_task) + wp.tid()
        end = int_at(ends, node)
        lows = wp.array(ptr=lower, shape=(end,), dtype=wp.vec4)
        highs = wp.array(ptr=upper, shape=(end,), dtype=wp.vec4)
        row = wp.uint64(node) * wp.uint64(4 * WIDTH)
        begin_of = wp.array(ptr=child_begins + row, shape=(WIDTH,), dtype=wp.int32)
        end_of = wp.array(ptr=child_ends + row, shape=(WIDTH,), dtype=wp.int32)
        used = wp.array(ptr=child_used + row, shape=(WIDTH,), dtype=wp.int32)
        area_of = wp.zeros(shape=(WIDTH,), dtype=wp.float32)
        bin_lows = wp.zeros(shape=(ALL_BINS,), dtype=wp.vec3)
        bin_highs = wp.zeros(shape=(ALL_BINS,), dtype=wp.vec3)
        bin_counts = wp.zeros(shape=(ALL_BINS,), dtype=wp.int32)
        right = wp.zeros(shape=(ALL_BINS,), dtype=wp.float32)
        begin_of[0] = int_at(begins, node)
        end_of[0] = end
        used[0] = 1
        children = wp.int32(1)
        largest = wp.int32(0)
        while children < WIDTH and largest >= 0:
            largest = _choose_child_to_split(by_area, children, begin_of, end_of, area_of)
            if largest >= 0:
                b = begin_of[largest]
                e = end_of[largest]
                middle = b + (e - b) / 2
                split = wp.int32(-1)
                left_area = area_of[largest]
                right_area = left_area
                if by_area != 0:
                    start, stop = centres(lows, highs, b, e)
                    extent = wp.max(stop - start, wp.vec3(1.0e-30))
                    scale = wp.cw_div(wp.vec3(MOST_BINS), extent)
                    fill_bins(lows, highs, b, e, start, scale, bin_lows, bin_highs, bin_counts)
                    split, left_area, right_area = best_split(e - b, bin_lows, bin_highs, bin_counts, right)
                    if split >= 0:
                        axis = split / BINS
                        middle = partition(lows, highs, b, e, axis, start[axis], scale[axis], split - axis * BINS)
                end_of[largest] = middle
                area_of[largest] = left_area
                begin_of[children] = middle
                end_of[children] = e
                area_of[children] = right_area
                used[children] = 1
                children += 1

    return split_nodes
