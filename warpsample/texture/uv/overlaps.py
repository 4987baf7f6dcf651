"""Division of charts that lie on themselves, found by drawing their faces as pixels."""

from collections import deque
from typing import NamedTuple

import numpy as np

from warpsample.host.locks import imported
from warpsample.texture.uv.charts import POINT, find_flat_areas, find_neighbours, number_points

_SHARE = 2e-4  # of a chart's pixels: folds of rough terrain, which are not worth further charts, have less
_PIXELS = 2.0**22  # pixels of the charts that are compared at once, so that they fit into memory; least of divided ones
_ROWS = 2.0**20  # rows of pixels, over all faces, that are drawn at once
_LONGEST = 2.0**13  # most rows of pixels of a face


class _Drawn(NamedTuple):
    """Pixels that lie in two or more faces of a chart.

    Attributes:
        face: (n,) face of each pixel, ascending; a pixel in two faces is listed twice.
        pixel: (n,) number of each pixel.
        is_folded: (C,) whether a chart has more than a few of them.
    """

    face: np.ndarray
    pixel: np.ndarray
    is_folded: np.ndarray


def divide_overlaps(places: np.ndarray, positions: np.ndarray, chart: np.ndarray, pixels: np.ndarray) -> np.ndarray:
    """Return new numbers of charts, (F,), such that hardly any pixel of a chart lies in two of its faces.

    xatlas projects a chain of nearly coplanar faces, such as a spiral ramp or a road that crosses itself, although parts of
    it lie above each other. Such a chart is divided into connected parts.

    Args:
        places: (F, 3, 2) places of the corners of each face.
        positions: (F, 3, 3) their positions in space.
        chart: (F,) number of each face's chart, counted from 0.
        pixels: (C,) number of pixels of each chart.
    """
    block = np.floor((np.cumsum(pixels) - pixels) / _PIXELS)[chart]
    order = np.argsort(block, kind="stable")
    divided = chart.copy()
    for rows in np.split(order, np.flatnonzero(np.diff(block[order])) + 1):
        folded = rows[_draw_charts(places[rows], chart[rows], pixels).is_folded[chart[rows]]]
        if len(folded):
            divided[folded] = divided.max() + 1 + _divide(places[folded], positions[folded], chart[folded], pixels)
    return np.unique(divided, return_inverse=True)[1]


def _divide(places: np.ndarray, positions: np.ndarray, chart: np.ndarray, pixels: np.ndarray) -> np.ndarray:
    """Return numbers of parts, (F,), of charts that lie on themselves; arguments as of `divide_overlaps`."""
    number, own = np.unique(chart, return_inverse=True)
    drawn = _draw_charts(places, own, pixels[number] * max(1.0, _PIXELS / pixels[number].sum()))
    known = np.concatenate([places, positions, np.tile(own[:, None, None], (1, 3, 1))], axis=2)
    corner = number_points(known.reshape(-1, 6)).reshape(-1, 3)
    return _grow_parts(find_neighbours(corner), drawn, len(chart))


def _grow_parts(pairs: np.ndarray, drawn: _Drawn, count: int) -> np.ndarray:
    """Return numbers of parts, (count,): each grows from a face to its neighbours, and takes faces without overlap.

    Args:
        pairs: (2, E) faces that share an edge.
        drawn: pixels in two or more faces.
        count: number of faces.
    """
    links = imported("scipy.sparse").coo_array(
        (np.ones(2 * pairs.shape[1], np.bool_), np.hstack([pairs, pairs[::-1]])), (count, count)
    )
    links = links.tocsr()
    ends, neighbours = links.indptr.tolist(), links.indices.tolist()
    starts = np.searchsorted(drawn.face, np.arange(count + 1)).tolist()
    pixel = np.unique(drawn.pixel, return_inverse=True)[1]
    owner = np.full(len(pixel), -1)
    part, seen = [-1] * count, [-1] * count
    for number in range(count):
        if part[number] >= 0:
            continue
        queue = deque([number])
        while queue:
            face = queue.popleft()
            own = pixel[starts[face] : starts[face + 1]]
            if (owner[own] == number).any():
                continue
            owner[own], part[face] = number, number
            for other in neighbours[ends[face] : ends[face + 1]]:
                if part[other] < 0 and seen[other] != number:
                    seen[other] = number
                    queue.append(other)
    return np.array(part)


def _draw_charts(corners: np.ndarray, chart: np.ndarray, pixels: np.ndarray) -> _Drawn:
    """Draw charts, apart from each other; in blocks, so that long faces with many rows of pixels fit into memory.

    Args:
        corners: (F, 3, 2) places of the corners.
        chart: (F,) number of each face's chart, counted from 0.
        pixels: (C,) number of pixels of each chart.
    """
    areas = np.bincount(chart, find_flat_areas(corners), len(pixels))
    corners = corners * np.sqrt(pixels / np.maximum(areas, POINT))[chart, None, None]
    width, height = (np.bincount(chart, own) for own in np.ptp(corners, axis=1).T)
    corners = np.where((width < height)[chart, None, None], corners[:, :, ::-1], corners)
    rows, longest = np.ptp(corners[:, :, 1], axis=1), np.full(len(width), _LONGEST)
    np.maximum.at(longest, chart, rows)
    scale = (_LONGEST / longest)[chart]
    corners *= scale[:, None, None]
    starts = np.flatnonzero(np.diff(np.cumsum(scale * rows) // _ROWS)) + 1
    blocks = np.split(np.arange(len(chart)), starts)
    drawn = [(own[face], column, row) for own in blocks for face, column, row in [_draw(corners[own])]]
    return _find_shared_pixels(*(np.concatenate(own) for own in zip(*drawn, strict=True)), chart)


def _find_shared_pixels(face: np.ndarray, column: np.ndarray, row: np.ndarray, chart: np.ndarray) -> _Drawn:
    """Return the pixels that lie in two or more faces of a chart.

    Args:
        face: (n,) face of each pixel, ascending.
        column: (n,) column of each pixel in its chart.
        row: (n,) row of each pixel in its chart.
        chart: (F,) number of each face's chart, counted from 0.
    """
    own, count = chart[face], int(chart.max()) + 1
    low, high = np.full((2, count), np.iinfo(np.int64).max), np.full((2, count), np.iinfo(np.int64).min)
    for axis, line in enumerate((column, row)):
        np.minimum.at(low[axis], own, line)
        np.maximum.at(high[axis], own, line)
    width, height = np.where(high >= low, high - low + 1, 0)
    first = np.cumsum(width * height) - width * height
    pixel = first[own] + (row - low[1, own]) * width[own] + column - low[0, own]
    order = np.argsort(pixel, kind="stable")
    again = np.flatnonzero(np.diff(pixel[order]) == 0)
    is_shared = np.zeros(len(pixel), np.bool_)
    is_shared[order[again]] = is_shared[order[again + 1]] = True
    is_folded = np.bincount(own[order[again]], minlength=count) > _SHARE * np.bincount(own, minlength=count)
    return _Drawn(face[is_shared], pixel[is_shared], is_folded)


def _draw(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the face, the column and the row of each pixel whose centre is in a face, (n,); an edge has one side.

    Args:
        corners: (F, 3, 2) places of the corners, in pixels.
    """
    order = np.lexsort((corners[:, :, 0], corners[:, :, 1]), axis=1)  # so that an edge has equal bits in both faces
    x, y = np.take_along_axis(corners, order[:, :, None], axis=1).transpose(2, 1, 0)
    first, end = np.ceil(y[0] - 0.5).astype(np.int64), np.ceil(y[2] - 0.5).astype(np.int64)
    face, row = _count_through(first, end)
    left, right = np.full(len(row), np.inf), np.full(len(row), -np.inf)
    for a, b in ((0, 1), (1, 2), (0, 2)):
        x_a, y_a, height = x[a, face], y[a, face], y[b, face] - y[a, face]
        ahead = row + 0.5 - y_a
        crosses = (ahead >= 0.0) & (ahead < height)
        at = x_a + ahead / np.where(crosses, height, 1.0) * (x[b, face] - x_a)
        left, right = np.where(crosses, np.minimum(left, at), left), np.where(crosses, np.maximum(right, at), right)
    span, column = _count_through(np.ceil(left - 0.5).astype(np.int64), np.ceil(right - 0.5).astype(np.int64))
    return face[span], column, row[span]


def _count_through(first: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the number of each range, and the whole numbers of all ranges from `first` to before `end`."""
    count = np.maximum(end - first, 0)
    start = np.cumsum(count) - count
    number = np.repeat(np.arange(len(count)), count)
    return number, np.arange(len(number)) - start[number] + first[number]
