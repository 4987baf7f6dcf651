"""Surface models "joined" and "block" for cities: similar neighbours share corners, and vertical walls separate the others.

A corner has four cells around it, in a ring. Two consecutive cells of the ring are linked if their heights differ by at most
a step. Linked cells share one vertex at the corner, at their mean height. With steps of 0 each cell is flat.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from warpsample.city.rasters.grid import TOP, WALL, Grid, Triangles

STEP = 2.0 * (1.0 + 2.0**-10)
"""Largest height difference of linked cells, in cell lengths: a slope of 63°, plus rounding of float32 heights."""

_UPPER_LEFT, _UPPER_RIGHT, _LOWER_RIGHT, _LOWER_LEFT = range(4)
_RING = ((0, 0), (0, 1), (1, 1), (1, 0))
"""Row and column offsets of a corner's four cells, in order around the corner."""


@dataclass(frozen=True, eq=False)
class _Corners:
    """Vertices at the corners of raster cells: one for each group of cells of similar height that meet at the corner.

    A corner of cells with and without data has another vertex below, at the lowest height, for the cells without data.
    number: (4, rows + 1, columns + 1) int32, vertex of each of the four cells around a corner; -1 without a vertex.
    height: (V,) float64. row, column: (V,) position of each vertex.
    """

    number: np.ndarray
    height: np.ndarray
    row: np.ndarray
    column: np.ndarray


def build_joined_cells(grid: Grid, step: float) -> Triangles:
    """Build a triangle mesh of a raster of heights, with vertical walls where neighbouring cells differ by more than a step.

    A cell consists of four triangles around its centre, which keeps the cell's height, or of two if all corners are in one
    plane with the centre. A wall fills the gap between the edges of two cells and faces away from the upper cell. Walls to
    cells without data reach down to the lowest height, so that no ray gets below a cell. There are no walls at the border.

    Args:
        grid: Heights of the cells.
        step: Largest height difference of linked cells, in cell lengths; 0 makes flat blocks.
    """
    corners = _build_corners(grid, step)
    top_faces, top_cells, peaks = _build_tops(grid, corners)
    centres = grid.centres(peaks)
    wall_faces, wall_cells, crossings = _build_walls(grid, corners, first=len(corners.height) + len(peaks))
    vertices = [grid.places(corners.column, corners.row, corners.height), centres, crossings]
    faces = np.concatenate([top_faces, wall_faces])
    return Triangles(
        vertices=np.concatenate(vertices),
        faces=faces[:, ::-1] if grid.mirrored else faces,
        kind=np.repeat(np.array([TOP, WALL], np.uint8), [len(top_faces), len(wall_faces)]),
        cell=np.concatenate([top_cells, wall_cells]),
    )


def _build_corners(grid: Grid, step: float) -> _Corners:
    """Build the vertices at the corners of all cells; cells of similar height share a vertex with the mean height."""
    rows, columns = grid.height.shape
    padded = np.pad(grid.height, 1, constant_values=np.nan)
    around = np.stack([padded[i : i + rows + 1, j : j + columns + 1] for i, j in _RING])
    number = np.full(around.shape, -1, np.int32)
    heights, places, known = [], [], 0
    links = _mask_links(around, step * np.array(grid.sides))
    for slot in range(4):
        members = _mask_linked_cells(links, slot)
        first = ~np.isnan(around[slot]) & ~members[:slot].any(axis=0)
        more, total = np.zeros(around.shape[1:]), np.ones(around.shape[1:])
        for other in range(slot + 1, 4):
            more += np.where(members[other], around[other] - around[slot], 0.0)
            total += members[other]
        place = np.flatnonzero(first)
        own = np.full(first.shape, -1, np.int32)
        own.ravel()[place] = known + np.arange(len(place), dtype=np.int32)
        for other in range(slot, 4):
            np.copyto(number[other], own, where=first & members[other])
        heights.append((around[slot] + more / total).ravel()[place])
        places.append(place)
        known += len(place)
    if not grid.whole:
        inside = np.pad(np.ones((rows, columns), bool), 1)
        gaps = np.isnan(around) & np.stack([inside[i : i + rows + 1, j : j + columns + 1] for i, j in _RING])
        place = np.flatnonzero(gaps.any(axis=0) & (number >= 0).any(axis=0))
        own = np.full(gaps.shape[1:], -1, np.int32)
        own.ravel()[place] = known + np.arange(len(place), dtype=np.int32)
        np.copyto(number, own, where=gaps)
        heights.append(np.full(len(place), np.nanmin(grid.height)))
        places.append(place)
    row, column = np.divmod(np.concatenate(places), columns + 1)
    return _Corners(number, np.concatenate(heights), row, column)


def _mask_links(around: np.ndarray, steps: np.ndarray) -> list[np.ndarray]:
    """Return four masks of the corners: whether each of the four cells there differs from the next by at most a step.

    Two cells are linked if their heights differ by at most a step.
    """
    return [np.abs(around[(slot + 1) % 4] - around[slot]) <= steps[slot % 2] for slot in range(4)]


def _mask_linked_cells(links: list[np.ndarray], slot: int) -> np.ndarray:
    """Return masks of the cells around each corner that share a vertex with cell number `slot`, (4, ...)."""
    members = np.zeros((4, *links[0].shape), bool)
    members[slot] = True
    for way, before in ((1, 0), (-1, -1)):
        reached = np.ones(links[0].shape, bool)
        for away in range(3):
            reached = reached & links[(slot + way * away + before) % 4]
            members[(slot + way * (away + 1)) % 4] |= reached
    return members


def _build_tops(grid: Grid, corners: _Corners) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Build the top triangles of all cells; return (triangles, cell of each, cells that have a vertex at the centre).

    Centre vertices are numbered after the corners.
    """
    cells, n = grid.cells, corners.number
    around = (n[_LOWER_RIGHT, :-1, :-1], n[_LOWER_LEFT, :-1, 1:], n[_UPPER_LEFT, 1:, 1:], n[_UPPER_RIGHT, 1:, :-1])
    ring = np.stack([corner.ravel()[cells] for corner in around])
    above = corners.height[ring] - grid.height.ravel()[cells]
    level = (above[0] + above[2] == 0.0) & (above[1] + above[3] == 0.0)
    peaks = cells[~level]
    faces = np.empty((2 * len(cells) + 2 * len(peaks), 3), np.int32)
    size = np.where(level, 2, 4)
    first = np.cumsum(size) - size
    upper_left, upper_right, lower_right, lower_left = ring[:, level]
    faces[first[level]] = np.stack([upper_left, lower_left, lower_right], axis=1)
    faces[first[level] + 1] = np.stack([upper_left, lower_right, upper_right], axis=1)
    centre = len(corners.height) + np.arange(len(peaks), dtype=np.int32)
    for side in range(4):
        sides = (centre, ring[(side + 1) % 4, ~level], ring[side, ~level])
        faces[first[~level] + side] = np.stack(sides, axis=1)
    return faces, np.repeat(cells, size), peaks


@dataclass(frozen=True, eq=False)
class _Edges:
    """Edges between neighbouring cells a and b: the vertices of each cell at both ends p and q of the edge.

    Seen from b, the end p is on the left of q. pa, qa, pb, qb: (N,) vertices. a, b: (N,) cells.
    """

    pa: np.ndarray
    qa: np.ndarray
    pb: np.ndarray
    qb: np.ndarray
    a: np.ndarray
    b: np.ndarray


def _find_edges(grid: Grid, corners: _Corners) -> Iterator[_Edges]:
    """Yield the edges between neighbouring cells that share at most one end vertex: first within rows, then columns."""
    n, number = corners.number, np.arange(grid.height.size).reshape(grid.height.shape)
    upper, lower = n[:, :-1, 1:-1], n[:, 1:, 1:-1]
    in_rows = (lower[_UPPER_LEFT], upper[_LOWER_LEFT], lower[_UPPER_RIGHT], upper[_LOWER_RIGHT])
    left, right = n[:, 1:-1, :-1], n[:, 1:-1, 1:]
    in_columns = (left[_UPPER_RIGHT], right[_UPPER_LEFT], left[_LOWER_RIGHT], right[_LOWER_LEFT])
    cells = ((number[:, :-1], number[:, 1:]), (number[:-1], number[1:]))
    for (pa, qa, pb, qb), (a, b) in zip((in_rows, in_columns), cells, strict=True):
        apart = np.nonzero((pa >= 0) & (pb >= 0) & ((pa != pb) | (qa != qb)))
        yield _Edges(*(array[apart] for array in (pa, qa, pb, qb, a, b)))


def _build_walls(grid: Grid, corners: _Corners, first: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Build the vertical walls between cells; return (triangles, upper cell of each, additional vertices (X, 3)).

    An additional vertex is where the edges of two neighbouring cells cross.

    Crossing vertices are numbered from `first`.
    """
    faces, cells, crossings = [], [], []
    for edge in _find_edges(grid, corners):
        at_p = corners.height[edge.pa] - corners.height[edge.pb]
        at_q = corners.height[edge.qa] - corners.height[edge.qb]
        cross = at_p * at_q < 0.0
        crossings.append(_find_crossings(grid, corners, edge, cross, at_p / np.where(cross, at_p - at_q, 1.0)))
        middle = np.zeros(len(cross), np.int32)
        middle[cross] = first + np.arange(len(crossings[-1]))
        first += len(crossings[-1])
        of_q = np.stack([np.where(cross, middle, edge.pb), edge.qb, edge.qa], axis=1)
        of_p = np.stack([edge.pb, np.where(cross, middle, edge.qa), edge.pa], axis=1)
        for made, above in ((of_q, at_q), (of_p, at_p)):
            faces.append(made[above != 0.0])
            cells.append(np.where(above > 0.0, edge.a, edge.b)[above != 0.0])
    return np.concatenate(faces), np.concatenate(cells), np.concatenate(crossings)


def _find_crossings(grid: Grid, corners: _Corners, edge: _Edges, cross: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Return the (X, 3) points where the edges of two neighbouring cells cross, at the fraction `share` from p to q.

    Crossings occur only between long and narrow cells.
    """
    p, q, t = edge.pb[cross], edge.qb[cross], share[cross]
    return grid.places(*((1.0 - t) * of[p] + t * of[q] for of in (corners.column, corners.row, corners.height)))
