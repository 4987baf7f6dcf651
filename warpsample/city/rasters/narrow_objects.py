"""Bounds of what masts, towers and other narrow objects hide that no azimuth of a horizon search may have hit."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from warpsample.host.locks import imported
from warpsample.mesh.mesh import Mesh
from warpsample.tracing.placed_points import PlacedPoints

_MOST_CELLS = 2048  # of a grid of highest faces along a side
_FACES = 1 << 14  # whose places are computed at a time
_POINTS = 1 << 13  # whose depths are computed at a time
_SHORTEST = 1e-30  # length of a normal, so that 0 / 0 gives 0
_WALL = 1e-2  # area of a wall in the map, at most, as a fraction of the products of its sides; 0 but for rounding
_LINE = 5  # cells; an object that is shorter in all directions is narrow
_ENDS = np.array([1, 0, 0, 0, 1])  # of a line
_AROUND = 8  # cells of other areas, of which one is ground, not a mast, with a high probability
_SQUARE = np.ones((_LINE, _LINE))
_FEW, _MOST_OF_AZIMUTHS = 2.0, 0.4  # objects of a ring that do not add to the depth, and that add, at most; see README.md


@dataclass(frozen=True, eq=False)
class _Tops:
    """Highest faces of cells of similar size. heights: (R, C). low: (2,) least x and y. cell: width of the grid's cells."""

    heights: np.ndarray
    low: np.ndarray
    cell: float


@dataclass(frozen=True, eq=False)
class _Ring:
    """Narrow objects in a ring around each cell of a grid, in the grid's order.

    tops: (C,) heights of the highest face in the ring or nearer. highest: (C,) greatest height of an object there above the
    terrain around it. count: (C,) numbers of objects in the ring, which are sums of squared heights, divided by that of the
    highest object. radius: inner radius. level: number of times that cells were doubled. columns: columns of the grid.
    """

    tops: np.ndarray
    highest: np.ndarray
    count: np.ndarray
    radius: float
    level: int
    columns: int


def bound_depths(at: PlacedPoints, azimuths: int, cosine: bool, reach: float) -> np.ndarray:
    """Bound how much of the sky narrow objects hide that no azimuth may have hit, (P, 2) float32.

    The first column bounds what one azimuth may lose. The second bounds what several azimuths may lose to objects at similar
    distances, as the root of the sum of the squares of their depths: errors by these objects are independent, and errors by
    a regular row, where azimuths hit all objects or miss all, are about as large. So the second bound may exceed 1.

    Args:
        at: Points on a field of heights, with normals.
        azimuths: Number of azimuths of a point.
        cosine: Whether the sky is weighted by the cosine to the normal; otherwise by solid angle.
        reach: Largest distance of an object.
    """
    assert at.mesh is not None
    lowest = at.mesh.vertices[:, 2].min()
    parts = [(part, list(_look_at_rings(part, azimuths / np.pi, reach, lowest))) for part in _split_by_size(at.mesh)]
    depths = np.empty((len(at.normal), 2), np.float32)
    for start in range(0, len(depths), _POINTS):
        rows = slice(start, start + _POINTS)
        points = np.nan_to_num(np.asarray(at.points.position[rows], np.float64))
        normal = at.normal[rows]
        up = (normal[:, 2] / np.maximum(np.linalg.norm(normal, axis=1), _SHORTEST)).clip(_SHORTEST, 1.0)
        depths[rows] = _depths_at(points, up, parts, azimuths, cosine).T
    return depths


def _depths_at(
    points: np.ndarray, up: np.ndarray, parts: list[tuple[_Tops, list[_Ring]]], azimuths: int, cosine: bool
) -> np.ndarray:
    """Compute the two bounds at points, (2, P), from the rings of all parts. up: (P,) upward components of normals."""
    alone, together = np.zeros(len(points)), np.zeros(len(points))
    for part, rings in parts:
        rows, columns = (
            ((points[:, :2] - part.low) / part.cell).clip(0.0, np.array(part.heights.shape) - 1.0).astype(np.int64).T
        )
        for ring in rings:
            cell = (rows >> ring.level) * ring.columns + (columns >> ring.level)
            slope = np.minimum(ring.highest.take(cell), ring.tops.take(cell) - points[:, 2]).clip(0.0) / ring.radius
            square, count = slope * slope, ring.count.take(cell)
            alone += square
            many = np.flatnonzero(count > _FEW)
            counted = np.minimum(count[many] - _FEW, _MOST_OF_AZIMUTHS * azimuths)
            together[many] += counted * _depth_of(square[many], up[many], cosine) ** 2
    return np.stack([_depth_of(alone, up, cosine), np.sqrt(together)])


def _depth_of(square: np.ndarray, up: np.ndarray, cosine: bool) -> np.ndarray:
    """Bound how much of the sky of one azimuth objects hide. square: squares of slopes. up: normals' upward components."""
    sine = np.sqrt(square / (1.0 + square))
    return (up * sine + np.sqrt(1.0 - up * up)) * sine if cosine else sine


def _look_at_rings(part: _Tops, gaps: float, reach: float, lowest: float) -> Iterator[_Ring]:
    """Find the tops of narrow objects and count the objects, ring by ring around the cells of a grid.

    A narrow object is at most four cells of a grid wide, and terrain is the grid without narrow objects. So slopes, ridges,
    walls and wide buildings, which azimuths hit, are terrain. An object's height is that above the terrain around it. The
    grid's cells double from ring to ring, and so does the ring's inner radius of `gaps` cells, where the gap between two
    azimuths is two cells wide. An azimuth hits an object with half the probability p from one ring to the next. The
    standard deviation is the depth times sqrt(p (1 - p)), which is largest at p = 1/2. From the second ring after its own
    on, the object's height counts by sqrt(1/2) less per ring.

    Args:
        part: Heights.
        gaps: Number of halves of a gap between two azimuths in one radian.
        reach: Largest distance of an object.
        lowest: Least height of the terrain.

    Yields:
        rings with narrow objects.
    """
    filters = imported("scipy.ndimage")
    terrain = tops = part.heights
    narrow, squares, cell, level = np.zeros(tops.shape), np.zeros(tops.shape), part.cell, 0
    while max(tops.shape) > 1 and gaps * cell < 2.0 * reach:
        opened = _open_heights(terrain, lowest)
        own = np.subtract(terrain, opened, out=np.zeros(terrain.shape), where=terrain > -np.inf)
        once = _square_once(own)
        found = np.maximum(narrow, own)
        if found.any():
            window, inside = (2 * min(int(radius), max(tops.shape)) + 1 for radius in (np.ceil(2.0 * gaps), gaps))
            sums = [size**2 * filters.uniform_filter(squares + once, size, mode="constant") for size in (window, inside)]
            highest = filters.maximum_filter(found, window, mode="constant")
            count = np.divide(sums[0] - sums[1], highest**2, out=np.zeros(tops.shape), where=highest > 0.0)
            above = filters.maximum_filter(tops, window, mode="constant", cval=-np.inf)
            yield _Ring(above.ravel(), highest.ravel(), count.ravel(), gaps * cell, level, tops.shape[1])
        narrow = np.maximum(np.sqrt(0.5) * narrow, own)
        tops, terrain, narrow = (_pool(each, np.maximum, -np.inf) for each in (tops, opened, narrow))
        squares = _pool(0.5 * squares + once, np.add, 0.0)
        cell, level = 2.0 * cell, level + 1


def _open_heights(heights: np.ndarray, lowest: float) -> np.ndarray:
    """Return a grid of heights without objects that are up to four cells wide in all directions. -inf is no data.

    This is the highest of the openings by a row, a column and two diagonals of five cells, whose ends and one more cell have
    data. Cells that are in no such line have the opening by squares of 5 x 5 cells with data in the first and last rows or
    columns. See `_open_small_areas` for cells that are in no such square.
    """
    filters, has_data = imported("scipy.ndimage"), heights > -np.inf
    filled = np.where(has_data, heights, np.inf)
    opened = np.full(heights.shape, -np.inf)
    for line in (np.ones((1, _LINE)), np.ones((_LINE, 1)), np.eye(_LINE), np.eye(_LINE)[::-1]):
        ends = line * (_ENDS if len(line) == 1 else _ENDS[:, None])
        is_line = filters.binary_erosion(has_data, ends) & filters.binary_dilation(has_data, line - ends)
        opened = np.maximum(opened, _open_by(filled, line, is_line))
    lacking = has_data & (opened == -np.inf)
    if not lacking.any():
        return opened
    opened = np.where(lacking, _open_by(filled, _SQUARE, _find_wide(has_data)), opened)
    return _open_small_areas(heights, opened, lowest)


def _open_by(filled: np.ndarray, shape: np.ndarray, where: np.ndarray) -> np.ndarray:
    """Return the opening of a grid by a shape around the cells of a mask, -inf in other cells. inf is no data."""
    filters = imported("scipy.ndimage")
    lowest = filters.minimum_filter(filled, footprint=shape, mode="constant", cval=np.inf)
    return filters.maximum_filter(np.where(where, lowest, -np.inf), footprint=shape, mode="constant", cval=-np.inf)


def _find_wide(has_data: np.ndarray) -> np.ndarray:
    """Return the centres of squares of 5 x 5 cells that have data in the first and last rows, or columns."""
    filters = imported("scipy.ndimage")
    rows, columns = (filters.binary_dilation(has_data, line) for line in (_SQUARE[:1], _SQUARE[:, :1]))
    return filters.binary_erosion(rows, _ENDS[:, None]) | filters.binary_erosion(columns, _ENDS[None])


def _open_small_areas(heights: np.ndarray, opened: np.ndarray, lowest: float) -> np.ndarray:
    """Return a grid of opened heights, changed in areas up to four cells wide without data around them. -inf is no data.

    Such an area is an object that stands on the nearest larger area. In sparse data, where most cells are in such areas, see
    `_find_lowest_around`; a few areas stand at `lowest`.
    """
    filters, has_data = imported("scipy.ndimage"), heights > -np.inf
    areas, count = filters.label(has_data, np.ones((3, 3)))
    where, widths = areas[has_data], []
    for places in np.nonzero(has_data):
        ends = np.full((2, count + 1), -np.inf)
        np.maximum.at(ends[0], where, places)
        np.maximum.at(ends[1], where, -places)
        widths.append(ends.sum(axis=0) + 1.0)
    objects = (np.maximum(*widths) < _LINE)[areas] & has_data
    if 2 * objects.sum() > has_data.sum():
        opened[objects] = _find_lowest_around(heights, areas, objects) if count > _AROUND else lowest
    elif objects.any():
        land = has_data & ~objects
        nearest = filters.distance_transform_edt(~land, return_distances=False, return_indices=True)
        opened[objects] = np.minimum(heights, opened[tuple(nearest)])[objects]
    return opened


def _find_lowest_around(heights: np.ndarray, areas: np.ndarray, objects: np.ndarray) -> np.ndarray:
    """Return the least height among each cell of a mask and the nearest cells of other areas, (N,)."""
    has_data = areas > 0
    values, area, own = heights[has_data], areas[has_data], areas[objects]
    tree = imported("scipy.spatial").KDTree(np.argwhere(has_data))
    near = tree.query(np.argwhere(objects), min(len(values), _AROUND + (_LINE - 1) ** 2))[1]
    is_other = area[near] != own[:, None]
    is_near = is_other & (np.cumsum(is_other, axis=1) <= _AROUND)
    return np.minimum(heights[objects], np.where(is_near, values[near], np.inf).min(axis=1))


def _square_once(heights: np.ndarray) -> np.ndarray:
    """Return numbers whose sum over the cells of an object is the square of its height, however many cells it has.

    This is cells less pairs of neighbours plus blocks of four, the Euler characteristic, integrated over the squares.
    """
    squares = np.pad(heights**2, [(0, 1), (0, 1)])
    down, right = np.minimum(squares[:-1], squares[1:]), np.minimum(squares[:, :-1], squares[:, 1:])
    return squares[:-1, :-1] - down[:, :-1] - right[:-1] + np.minimum(down[:, :-1], down[:, 1:])


def _pool(values: np.ndarray, pool: np.ufunc, empty: float) -> np.ndarray:
    """Return the highest value or the sum of each block of 2 x 2 cells. empty: value of cells beyond the edge."""
    values = np.pad(values, [(0, length % 2) for length in values.shape], constant_values=empty)
    values = pool(values[::2], values[1::2])
    return pool(values[:, ::2], values[:, 1::2])


def _split_by_size(mesh: Mesh) -> list[_Tops]:
    """Split the faces of a field of heights into those of its own cells, and those of larger cells of distant terrain.

    A mesh that fits into one grid is not split.
    """
    corners = mesh.vertices[mesh.faces[:4], :2]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    cell, longest = float(min(sides[sides > 0.0], default=np.inf)), sides.max()
    lone = ~mesh.used  # points of a tin without a triangle
    ends = np.array([[limit(axis) for axis in mesh.vertices.T[:2]] for limit in (np.min, np.max)])
    if np.ptp(ends, axis=0).max() <= _MOST_CELLS * cell:
        return [_find_tops(mesh, mesh.faces, lone, ends, cell)]
    chunks = np.array_split(mesh.faces, len(mesh.faces) // _FACES + 1)
    wide = np.concatenate([(np.ptp(mesh.vertices[chunk, :2], axis=1) > 2.0 * longest).any(axis=1) for chunk in chunks])
    parts = []
    for chosen, alone, least in ((~wide, lone, cell), (wide, np.zeros_like(lone), 2.0 * longest)):
        if chosen.any():
            used = alone.copy()
            used[mesh.faces[chosen]] = True
            ends = np.array([limit(mesh.vertices[used, :2], axis=0) for limit in (np.min, np.max)])
            width = max(least, np.ptp(ends, axis=0).max() / _MOST_CELLS)
            parts.append(_find_tops(mesh, mesh.faces[chosen], alone, ends, width))
    return parts


def _find_tops(mesh: Mesh, faces: np.ndarray, alone: np.ndarray, ends: np.ndarray, cell: float) -> _Tops:
    """Put the highest corners of faces other than walls into a grid, by the middles of the faces, and some vertices.

    Args:
        mesh: Field of heights.
        faces: Faces of it.
        alone: Mask of the vertices that count as cells.
        ends: (2, 2) least and greatest x and y.
        cell: Width of the grid's cells.
    """
    low, shape = ends[0], np.ceil((ends[1] - ends[0]) / cell - 0.01).clip(1.0).astype(np.int64)
    heights = np.full(shape.prod(), -np.inf)
    places, tops = ((mesh.vertices[:, :2] - low) / cell).astype(np.float32).T.copy(), mesh.vertices[:, 2].copy()
    for start in range(0, len(faces), _FACES):
        corners = faces[start : start + _FACES].T.copy()
        x, y = (place.take(corners) for place in places)
        one, other = (x[1] - x[0]) * (y[2] - y[0]), (x[2] - x[0]) * (y[1] - y[0])
        row, column = ((place.sum(axis=0) / np.float32(3.0)).astype(np.int64) for place in (x, y))
        is_flat = np.abs(one - other) > _WALL * (np.abs(one) + np.abs(other))
        _raise_cells(heights, shape, (row, column), np.where(is_flat, tops.take(corners).max(axis=0), -np.inf))
    grid = heights.reshape(shape)
    return _Tops(_add_ground(grid, places[:, alone].astype(np.int64), tops[alone]) if alone.any() else grid, low, cell)


def _add_ground(heights: np.ndarray, places: np.ndarray, tops: np.ndarray) -> np.ndarray:
    """Return a grid of heights with single points in its cells without data, lowered to the cells around them.

    No ray can hit a point, so it is ground, and no object.
    """
    with_points = heights.copy()
    _raise_cells(with_points.ravel(), heights.shape, places, tops)
    is_point, has_data = (heights == -np.inf) & (with_points > -np.inf), with_points > -np.inf
    tree = imported("scipy.spatial").KDTree(np.argwhere(has_data))
    near = tree.query(np.argwhere(is_point), _AROUND + 1)[1].clip(max=int(has_data.sum()) - 1)  # the last, where too few
    with_points[is_point] = with_points[has_data][near].min(axis=1)
    return with_points


def _raise_cells(heights: np.ndarray, shape: np.ndarray, places: Sequence[np.ndarray], tops: np.ndarray) -> None:
    """Raise cells of a grid to heights, in place. heights: cells of the grid. places: row and column of each height."""
    row, column = (np.minimum(place, length - 1) for place, length in zip(places, shape, strict=True))
    np.maximum.at(heights, row * shape[1] + column, tops)  # a strip of 0.01 cells at the edge has no cells
