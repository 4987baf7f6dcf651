"""The example mesh that `load_mesh("courtyard")` returns, computed by code."""

from os import PathLike, fspath
from pathlib import Path

import numpy as np

_STEP = 3.0  # metres: height of a storey, and width of a ground cell
_CELLS = 24
_STOREYS = (  # first row, end row, first column, end column, number of storeys
    (5, 19, 5, 9, 4),
    (5, 19, 15, 19, 6),
    (5, 9, 9, 15, 3),
    (15, 19, 9, 15, 8),
    (5, 9, 11, 13, 0),  # the entrance
)


def courtyard() -> tuple[np.ndarray, np.ndarray]:
    """Return the example mesh: four buildings of 3 to 8 storeys around a yard with one entrance, on a square of 72 m.

    z points up, and the underside is open. Vertices (V, 3) are float64 in metres; faces (F, 3) int32 are halves of 3 m
    squares.
    """
    height = np.zeros((_CELLS + 2, _CELLS + 2), int)  # with a margin, which has no faces
    for rows, to_row, columns, to_column, storeys in _STOREYS:
        height[rows + 1 : to_row + 1, columns + 1 : to_column + 1] = storeys
    quads = []
    for x, y in np.ndindex(_CELLS, _CELLS):
        here, right, behind = height[x + 1, y + 1], height[x + 2, y + 1], height[x + 1, y + 2]
        quads.append([(x, y, here), (x + 1, y, here), (x + 1, y + 1, here), (x, y + 1, here)])
        for z in range(min(here, right), max(here, right)):
            wall = [(x + 1, y, z), (x + 1, y + 1, z), (x + 1, y + 1, z + 1), (x + 1, y, z + 1)]
            quads.append(wall if here > right else wall[::-1])
        for z in range(min(here, behind), max(here, behind)):
            wall = [(x + 1, y + 1, z), (x, y + 1, z), (x, y + 1, z + 1), (x + 1, y + 1, z + 1)]
            quads.append(wall if here > behind else wall[::-1])
    vertices, corners = np.unique(np.reshape(quads, (-1, 3)), axis=0, return_inverse=True)
    corners = corners.reshape(-1, 4).astype(np.int32)
    return _STEP * vertices, corners[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)


def example(path: str | PathLike[str]) -> tuple[np.ndarray, np.ndarray] | None:
    """Return (vertices, faces) of the example mesh if `path` is "courtyard" and no file has this name, else None."""
    named = isinstance(path, str | PathLike) and fspath(path) == "courtyard"
    return courtyard() if named and not Path(path).exists() else None


def content_of(path: Path) -> bytes:
    """Return the bytes of a mesh file, or of the arrays of the example mesh."""
    made = example(path)
    return path.read_bytes() if made is None else b"".join(array.tobytes() for array in made)
