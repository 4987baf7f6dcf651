"""Surface model "tin" for terrain: triangles between the centres of neighbouring cells."""

import numpy as np

from warpsample.city.rasters.grid import TOP, Grid, Triangles


def build_tin(grid: Grid) -> Triangles:
    """Build the triangles between the centres of each 2 x 2 block of cells that all have heights.

    A square is cut along the diagonal whose ends differ less in height, or else along the higher diagonal. So a rotated or
    mirrored raster gives the same triangles. Both triangles of a square belong to the square's first cell.

    Raises:
        ValueError: No 2 x 2 cells with heights.
    """
    rows, columns = grid.height.shape
    cells = grid.cells
    number = np.zeros(grid.height.shape, np.int32)
    number.ravel()[cells] = np.arange(len(cells), dtype=np.int32)
    valid = grid.valid
    whole = np.flatnonzero(valid[:-1, :-1] & valid[:-1, 1:] & valid[1:, :-1] & valid[1:, 1:])
    if len(whole) == 0:
        raise ValueError(
            f"source: got {rows} x {columns} cells without a block of 2 x 2 cells with heights, want at least one block "
            "for model='tin'; or pass model='joined' or model='block', which need no such block"
        )
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
    return Triangles(
        vertices=grid.centres(cells),
        faces=faces[:, ::-1] if grid.mirrored else faces,
        kind=np.full(len(faces), TOP, np.uint8),
        cell=np.repeat(first, 2),
    )
