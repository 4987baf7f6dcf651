"""Surface model "tin" for terrain: triangles between the centres of neighbouring cells."""

import numpy as np

from warpsample.city.rasters.grid import TOP, WALL, Grid, Triangles, mask_blocks


def build_tin(grid: Grid) -> Triangles:
    """Build the triangles between the centres of each 2 x 2 block of cells that all have heights.

    A square is cut along the diagonal whose ends differ less in height, or else along the higher diagonal. So a rotated or
    mirrored raster gives the same surface. Flat squares are cut by the order of cells; this changes no height, but the
    weights of their normals at corners. Both triangles of a square belong to the square's first cell. Next to cells
    without data, walls reach from the triangles down to the lowest height, so that no ray gets below the triangles.

    A part of a raster may have no such block. Its cells are points without a triangle, and one triangle without an area
    stands for the surface, because a mesh has at least one triangle.
    """
    columns = grid.height.shape[1]
    cells = grid.cells
    number = np.zeros(grid.height.shape, np.int32)
    number.ravel()[cells] = np.arange(len(cells), dtype=np.int32)
    whole = np.flatnonzero(mask_blocks(grid.valid))
    if len(whole) == 0:
        return Triangles(grid.centres(cells), np.zeros((1, 3), np.int32), np.array([TOP], np.uint8), cells[:1])
    row, column = np.divmod(whole, columns - 1)
    first = row * columns + column
    square = [number.ravel()[first + step] for step in (0, 1, columns + 1, columns)]
    upper_left, upper_right, lower_right, lower_left = (grid.height.ravel()[first + s] for s in (0, 1, columns + 1, columns))
    falling, rising = np.abs(upper_left - lower_right), np.abs(upper_right - lower_left)
    higher = upper_left + lower_right >= upper_right + lower_left
    turn = np.where((falling < rising) | ((falling == rising) & higher), 0, 1)
    ends = np.stack(square, axis=1)
    a, b, c, d = (ends[np.arange(len(ends)), (turn + k) % 4] for k in range(4))
    faces = np.stack([a, d, c, a, c, b], axis=1).reshape(-1, 3)
    corners, walls, upper = _build_walls(grid, cells, _find_rim(grid, cells, faces))
    kind = np.repeat(np.array([TOP, WALL], np.uint8), [len(faces), len(walls)])
    faces = np.concatenate([faces, walls])
    return Triangles(
        vertices=np.concatenate([grid.centres(cells), corners]),
        faces=faces[:, ::-1] if grid.mirrored else faces,
        kind=kind,
        cell=np.concatenate([np.repeat(first, 2), upper]),
    )


def _find_rim(grid: Grid, cells: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the (E, 2) edges of triangles next to cells without data; the triangle is to the left of each edge."""
    if grid.whole:
        return np.zeros((0, 2), np.int32)
    edges = np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)])
    key = np.int64(len(cells)) * edges.min(axis=1) + edges.max(axis=1)
    _, which, count = np.unique(key, return_index=True, return_counts=True)
    rim = edges[which[count == 1]]
    row, column = np.divmod(cells[rim], grid.height.shape[1])
    last = grid.height.shape[0] - 1, grid.height.shape[1] - 1
    outside = [(along == end).all(axis=1) for along, most in zip((row, column), last, strict=True) for end in (0, most)]
    return rim[~np.any(outside, axis=0)]


def _build_walls(grid: Grid, cells: np.ndarray, rim: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Build walls from edges of triangles down to the lowest height; return (vertices, triangles, upper cell of each).

    The walls have vertices of their own, so that they do not tilt the normals of the terrain's vertices.
    """
    top = grid.centres(cells[rim].ravel()).reshape(-1, 2, 3)
    bottom = top.copy()
    bottom[..., 2] = np.nanmin(grid.height)
    falls = (top[:, 0, 2] > top[:, 1, 2])[:, None]  # the cut from the higher foot is the same in a mirrored raster
    corner = np.where(falls, [[2, 3, 1, 2, 1, 0]], [[2, 3, 0, 3, 1, 0]]).astype(np.int32)
    above = top[..., 2] > bottom[..., 2]
    above = np.where(falls, above[:, ::-1], above).ravel()
    first = len(cells) + 4 * np.arange(len(rim), dtype=np.int32)[:, None]
    faces = (first + corner).reshape(-1, 3)
    return np.concatenate([top, bottom], axis=1).reshape(-1, 3), faces[above], np.repeat(cells[rim[:, 0]], 2)[above]
