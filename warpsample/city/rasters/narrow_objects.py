"""Bounds of what masts, towers and other narrow objects hide that no azimuth of a horizon search may have hit."""

from dataclasses import dataclass

import numpy as np

from warpsample.host.locks import imported
from warpsample.mesh.mesh import Mesh
from warpsample.tracing.placed_points import PlacedPoints

_MOST_CELLS = 2048  # of a grid of highest vertices along a side
_MOST_FACES = 1 << 20  # whose widths are computed at a time
_SHORTEST = 1e-30  # length of a normal, so that 0 / 0 gives 0
_LINES = (np.ones((1, 3)), np.ones((3, 1)), np.eye(3), np.eye(3)[::-1])  # of three cells, in four directions


@dataclass(frozen=True, eq=False)
class _Tops:
    """Vertices of cells of similar size. low: (2,) least x and y of a grid of these vertices. cell: width of its cells."""

    vertices: np.ndarray
    low: np.ndarray
    cell: float


def bound_depths(at: PlacedPoints, azimuths: int, cosine: bool, reach: float) -> np.ndarray:
    """Bound how much of the sky of one azimuth narrow objects hide that no azimuth may have hit, (P,) float32.

    Args:
        at: Points on a field of heights, with normals.
        azimuths: Number of azimuths of a point.
        cosine: Whether the sky is weighted by the cosine to the normal; otherwise by solid angle.
        reach: Largest distance of an object.
    """
    assert at.mesh is not None
    points = np.nan_to_num(np.asarray(at.points.position, np.float64))
    slope = np.zeros(len(points))
    for part in _split_by_size(at.mesh):
        slope = np.hypot(slope, _bound_slopes(points, part, azimuths / (2.0 * np.pi), reach))
    sine = slope / np.hypot(1.0, slope)
    if not cosine:
        return sine.astype(np.float32)
    up = (at.normal[:, 2] / np.maximum(np.linalg.norm(at.normal, axis=1), _SHORTEST)).clip(_SHORTEST, 1.0)
    return (up * sine**2 + np.sqrt(1.0 - up**2) * sine).astype(np.float32)


def _bound_slopes(points: np.ndarray, part: _Tops, gaps: float, reach: float) -> np.ndarray:
    """Bound the slopes from points to the tops of narrow objects, by their heights above the terrain around, (P,) float64.

    A narrow object is at most two cells of a grid wide, and terrain is the grid without narrow objects. So slopes, ridges,
    walls and wide buildings, which azimuths hit, are terrain. The grid's cells double from ring to ring, and so does the
    ring's inner radius of `gaps` cells, where the gap between two azimuths is a cell wide. An azimuth hits an object with
    half the probability p from one ring to the next. The standard deviation is the depth times sqrt(p (1 - p)), which is
    largest at p = 1/2. From the second ring after its own on, the object's height counts by sqrt(1/2) less per ring.

    Args:
        points: (P, 3) positions.
        part: Vertices.
        gaps: Number of azimuths in one radian.
        reach: Largest distance of an object.
    """
    cell = part.cell
    rows, where = (((xyz[:, :2] - part.low) / cell + 0.5).clip(0.0).astype(np.int64) for xyz in (part.vertices, points))
    terrain = np.full(np.maximum(rows.max(axis=0), where.max(axis=0)) + 1, -np.inf)
    np.maximum.at(terrain, tuple(rows.T), part.vertices[:, 2])
    find_highest, window = imported("scipy.ndimage").maximum_filter, 2 * int(np.ceil(2.0 * gaps)) + 1
    tops, narrow, slope, level = terrain, np.zeros(terrain.shape), np.zeros(len(points)), 0
    while max(tops.shape) > 1 and gaps * cell < reach:
        opened = _open_heights(terrain)
        own = np.subtract(terrain, opened, out=np.zeros(terrain.shape), where=terrain > -np.inf)
        at = tuple(where.T >> level)
        above = find_highest(tops, window, mode="constant", cval=-np.inf)[at] - points[:, 2]
        height = np.minimum(find_highest(np.maximum(narrow, own), window, mode="constant")[at], np.maximum(above, 0.0))
        slope = np.hypot(slope, height / (gaps * cell))
        tops, terrain, narrow = (_pool_highest(each) for each in (tops, opened, np.maximum(np.sqrt(0.5) * narrow, own)))
        cell, level = 2.0 * cell, level + 1
    return slope


def _open_heights(heights: np.ndarray) -> np.ndarray:
    """Return a grid of heights without objects that are up to two cells wide in all directions. -inf is no data.

    This is the highest of the openings by a row, a column and two diagonals of three cells, and, for cells next to missing
    data, of that by the cells with data among 3 x 3.
    """
    filters = imported("scipy.ndimage")
    lowest = filters.minimum_filter(np.where(heights > -np.inf, heights, np.inf), 3, mode="constant", cval=np.inf)
    opened = filters.maximum_filter(np.where(lowest < np.inf, lowest, -np.inf), 3, mode="constant", cval=-np.inf)
    for line in _LINES:
        lowest = filters.minimum_filter(heights, footprint=line, mode="constant", cval=-np.inf)
        opened = np.maximum(opened, filters.maximum_filter(lowest, footprint=line, mode="constant", cval=-np.inf))
    return opened


def _pool_highest(values: np.ndarray) -> np.ndarray:
    """Return the highest value of each block of 2 x 2 cells."""
    values = np.pad(values, [(0, length % 2) for length in values.shape], mode="edge")
    return values.reshape(len(values) // 2, 2, -1, 2).max(axis=(1, 3))


def _split_by_size(mesh: Mesh) -> list[_Tops]:
    """Split the vertices of a field of heights into those of its own cells, and those of larger cells of distant terrain.

    A mesh that fits into one grid is not split.
    """
    corners = mesh.vertices[mesh.faces[:4], :2]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    cell, longest = float(min(sides[sides > 0.0], default=np.inf)), sides.max()
    low, size = mesh.vertices[:, :2].min(axis=0), np.ptp(mesh.vertices[:, :2], axis=0).max()
    if size <= _MOST_CELLS * cell:
        return [_Tops(mesh.vertices, low, cell)]
    chunks = np.array_split(mesh.faces, len(mesh.faces) // _MOST_FACES + 1)
    wide = np.concatenate([(np.ptp(mesh.vertices[chunk, :2], axis=1) > 2.0 * longest).any(axis=1) for chunk in chunks])
    parts = []
    for chosen, width in ((~wide, cell), (wide, 2.0 * longest)):
        if chosen.any():
            used = np.zeros(len(mesh.vertices), bool)
            used[mesh.faces[chosen]] = True
            vertices = mesh.vertices[used]
            first = vertices[:, :2].min(axis=0) if width == cell else low
            parts.append(_Tops(vertices, first, max(width, np.ptp(vertices[:, :2], axis=0).max() / _MOST_CELLS)))
    return parts
