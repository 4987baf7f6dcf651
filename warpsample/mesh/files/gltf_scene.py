"""Transformations of the nodes in a glTF scene, and the joints that pose meshes."""

from collections import Counter
from collections.abc import Iterator

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.host.locks import imported
from warpsample.mesh.files.skins import Skin

_AFFINE = 1e-6  # largest deviation of a matrix' last column from (0, 0, 0, 1): float32 rounding


VISIBILITY = "KHR_node_visibility"
"""glTF extension that hides a node and all nodes below it."""


def iterate_nodes(tree: Part) -> Iterator[tuple[Part, np.ndarray, Skin | None]]:
    """Yield the visible nodes of the scene, parents first, each with its matrix for row vectors and its skin or None."""
    nodes = tree.parts("nodes")
    skins = tree.parts("skins") if any("skin" in node for node in nodes) else []
    found = list(_places(tree, nodes))
    places = {number: matrix for number, matrix, _ in found}  # an invisible node can be a joint
    for number, matrix, is_visible in found:
        if is_visible:
            yield nodes[number], matrix, Skin.of(nodes[number], skins, nodes, places)


def count_invisible(tree: Part) -> int:
    """Return the number of nodes of the scene that place a mesh and are invisible."""
    nodes = tree.parts("nodes")
    return sum("mesh" in nodes[number] and not is_visible for number, _, is_visible in _places(tree, nodes))


def _places(tree: Part, nodes: list[Part]) -> Iterator[tuple[int, np.ndarray, bool]]:
    """Yield (index, matrix, is visible) of each node of the scene, parents first; matrices transform row vectors."""
    scenes = tree.parts("scenes")
    children = [node.indices("children", nodes) for node in nodes]
    parents = _parents(children)
    if not scenes:
        return
    scene = scenes[tree.index("scene", scenes, 0)]
    roots = scene.indices("nodes", nodes)
    for number in roots:
        if number in parents:
            raise ValueError(
                f"{scene.path} lists node {number}, a child of node {parents[number]}, want only nodes without a parent"
            )
    for number, times in Counter(roots).items():
        if times > 1:
            raise ValueError(f"{scene.path} lists node {number} {times} times, want each node once")
    left = [(number, np.eye(4), True) for number in reversed(roots)]
    while left:  # ends, because each node below a root has one parent
        number, above, is_visible = left.pop()
        matrix, is_visible = _matrix(nodes[number]) @ above, is_visible and _is_shown(nodes[number])
        yield number, matrix, is_visible
        left += [(child, matrix, is_visible) for child in reversed(children[number])]


def _is_shown(node: Part) -> bool:
    """Return whether a node itself is visible, without regard to the nodes above it."""
    if "extensions" not in node or VISIBILITY not in node.part("extensions"):
        return True
    state = node.part("extensions").part(VISIBILITY)
    return "visible" not in state or state.flag("visible")


def _parents(children: list[list[int]]) -> dict[int, int]:
    """Return a dictionary from nodes to parents; raise a ValueError for two parents or a circle."""
    parents: dict[int, int] = {}
    for number, below in enumerate(children):
        for child in below:
            if child in parents:
                both = f"of node {number} twice" if parents[child] == number else f"of nodes {parents[child]} and {number}"
                raise ValueError(f"node {child} is a child {both}, want one parent for each node")
            parents[child] = number
    known: set[int] = set()
    for start in parents:
        number, path = start, {start}
        while number in parents and number not in known:
            number = parents[number]
            if number in path:
                raise ValueError(f"node {number} is its own ancestor, want a tree of nodes")
            path.add(number)
        known |= path
    return parents


def _matrix(node: Part) -> np.ndarray:
    """Return the (4, 4) matrix of a node relative to its parent, for row vectors."""
    if "matrix" in node:
        matrix = node.reals("matrix", (0.0,) * 16).reshape(4, 4)
        if np.abs(matrix[:, 3] - (0.0, 0.0, 0.0, 1.0)).max() > _AFFINE:
            raise ValueError(f"{node.at('matrix')}: got a matrix with a perspective, want 0, 0, 0, 1 as the last row")
        return matrix
    matrix = np.eye(4)
    if "rotation" in node:
        matrix[:3, :3] = _rotation(node)
    matrix[:3, :3] *= node.reals("scale", (1.0, 1.0, 1.0))[:, None]
    matrix[3, :3] = node.reals("translation", (0.0, 0.0, 0.0))
    return matrix


def _rotation(node: Part) -> np.ndarray:
    """Return the (3, 3) rotation matrix of a node's quaternion, for row vectors."""
    quaternion = node.reals("rotation", (0.0, 0.0, 0.0, 1.0))
    if not 0.5 < np.linalg.norm(quaternion) < 2.0:  # rounding causes smaller deviations from 1
        raise ValueError(f"{node.at('rotation')}: got {quaternion.tolist()}, want a quaternion of length 1")
    return imported("scipy.spatial.transform").Rotation.from_quat(quaternion).as_matrix().T
