"""Meshes with faces of similar size, which are typical for view factors."""

import numpy as np

from warpsample.mesh.mesh import Mesh, as_mesh

_SIDES = ((1, 0), (0, 1), (-1, 0), (0, -1))
_FEET = (((1, 0), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0)), ((0, 0), (1, 0)))  # of the wall on each side of a square


def build_mesh(name: str) -> Mesh:
    """Build the view-factor mesh with this name, for example "boxes 6" or "city 4"."""
    kind, size = name.split()
    return {"boxes": build_boxes, "city": build_blocks}[kind](int(size))


def build_blocks(side: int) -> Mesh:
    """Build a mesh of side x side blocks in streets; all faces are half unit squares that face outward.

    A block is 2 x 2 squares wide and 1 to 6 floors high.
    """
    heights = np.clip(np.rint(np.random.default_rng(0).lognormal(0.7, 0.5, (side, side))), 1, 6).astype(int)
    # A street is two squares wide, within a margin of 1.
    squares = np.pad(np.kron(heights, np.pad(np.ones((2, 2), int), 1)), 1)
    quads = []
    for x, y in np.ndindex(squares.shape):
        z = squares[x, y]
        quads.append([(x, y, z), (x + 1, y, z), (x + 1, y + 1, z), (x, y + 1, z)])
        for (dx, dy), foot in zip(_SIDES, _FEET, strict=True):
            inside = 0 <= x + dx < len(squares) and 0 <= y + dy < len(squares)
            for floor in range(squares[x + dx, y + dy] if inside else z, z):
                (ax, ay), (bx, by) = foot
                a, b = (x + ax, y + ay, floor), (x + bx, y + by, floor)
                quads.append([a, b, (*b[:2], floor + 1), (*a[:2], floor + 1)])
    return _halve(np.array(quads, np.float64))


def build_boxes(outer: int) -> Mesh:
    """Build a mesh of an inward-facing cube of edge 3 around an outward-facing cube of edge 1.

    Each side of the outer cube is outer x outer squares; the inner cube has half as many squares per edge.
    """
    sides, inner = [], max(1, outer // 2)
    for count, size, turn in ((outer, 3.0, -1), (inner, 1.0, 1)):
        u, v = (g.reshape(-1, 1, 1) for g in np.meshgrid(np.arange(count), np.arange(count), indexing="ij"))
        square = np.array([[[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]]])[:, ::turn]
        top = (square * [1.0, 1.0, count] + u * [1.0, 0.0, 0.0] + v * [0.0, 1.0, 0.0]) * (size / count) - 0.5 * size
        for axis in range(3):
            sides += [np.roll(top, axis, axis=2), np.roll(top * [1.0, -1.0, -1.0], axis, axis=2)]
    return _halve(np.concatenate(sides))


def _halve(quads: np.ndarray) -> Mesh:
    """Split each quad of (Q, 4, 3) into two triangles and merge corners at the same position."""
    vertices, index = np.unique(quads.reshape(-1, 3).round(9), axis=0, return_inverse=True)
    return as_mesh((vertices, index.reshape(-1, 4)[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)))
