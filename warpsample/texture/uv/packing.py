"""Packing of charts into one square image with xatlas, as large as they fit."""

from typing import Any, NamedTuple

import numpy as np

from warpsample.texture.uv.charts import POINT, find_flat_areas

_TRIES = 20
_ENOUGH = 8  # tries after which charts need not fill the image
_FILL = 0.7  # part of the image that xatlas usually fills with charts and the texels between them
_NESTED = 0.5  # part of the empty texels in the boxes of charts that other charts take
_CLOSE = 1.01  # ratio of two scales between which no other is tried
_FARTHER = 1.1  # largest scale to try next, in scales that fit
_SLACK = 0.99  # factor on the filled part at each further try, because packing is uneven
_STEPS = 2.0**16  # steps of scales between powers of 2
_UNITS = 1024.0  # units per texel: xatlas leaves out faces with an area below 1e-7
_alive: list[Any] = []  # all atlases: destroying one can wait forever for a thread of xatlas


class Charts(NamedTuple):
    """Charts of some faces, not packed yet.

    Attributes:
        places: (V, 2) positions of the vertices, in any unit of length; mostly different ones, because xatlas takes
            quadratic time for equal ones.
        faces: (F, 3) rows of `places`.
        chart: (F,) number of each face's chart.
        sizes: (C, 2) sides of the box of each chart.
        areas: (C,) area of each chart.
    """

    places: np.ndarray
    faces: np.ndarray
    chart: np.ndarray
    sizes: np.ndarray
    areas: np.ndarray


class _Packed(NamedTuple):
    """Charts in an image, or as many of them as fit.

    Attributes:
        is_whole: whether all charts are in the image.
        fill: part of the image that is taken, or part that would be taken if the image ended at the last chart.
        places: (V, 2) places in texels.
        is_packed: (F,) mask of the faces in packed charts.
    """

    is_whole: bool
    fill: float
    places: np.ndarray
    is_packed: np.ndarray


def new_atlas() -> Any:
    """Return an empty atlas of xatlas that lives as long as the process."""
    import xatlas

    _alive.append(xatlas.Atlas())
    return _alive[-1]


def measure_charts(places: np.ndarray, faces: np.ndarray, chart: np.ndarray) -> Charts:
    """Return charts with their sizes and areas, numbered from 0.

    Args:
        places: (V, 2) positions of the vertices.
        faces: (F, 3) vertices of each face.
        chart: (F,) number of each face's chart; numbers may be missing.
    """
    corners, chart = places[faces], np.unique(chart, return_inverse=True)[1]
    order = np.argsort(chart, kind="stable")
    starts = np.flatnonzero(np.diff(chart[order], prepend=-1))
    low = np.minimum.reduceat(corners[order].min(axis=1), starts)
    high = np.maximum.reduceat(corners[order].max(axis=1), starts)
    return Charts(places, faces, chart, high - low, np.bincount(chart, find_flat_areas(corners)))


def pack_charts(charts: Charts, size: int, padding: int) -> tuple[np.ndarray, np.ndarray]:
    """Pack charts into one image, at least `padding` texels apart.

    xatlas packs charts of a given scale. So charts are packed with several scales, and the largest that fits is taken. The
    next scale follows from the part of the image that xatlas has filled.

    Returns:
        (V, 2) float64 texture coordinates from 0 to 1, and the mask (F,) of faces with an area in the image.

    Raises:
        ValueError: the image is too small, or no face has an area.
    """
    scale, slack, best, low = find_scale(charts, size, padding), 1.0, None, 0.0
    high = (1.0 + 1e-6) * (size - 1) / max(charts.sizes.max(), POINT)  # xatlas shrinks longer charts
    if len(charts.sizes) * (1 + 2 * padding) ** 2 > (size + 2 * padding) ** 2 or scale > high:
        raise _too_small(charts, size, padding)
    for tries in range(_TRIES):
        packed = _pack(charts, scale, size, padding)
        if packed.is_whole:
            best, low = packed, scale
        else:
            high = scale
        if best and (tries >= _ENOUGH or high <= _CLOSE * low):
            break
        scale = find_scale(charts, size, padding, slack * packed.fill)
        slack *= _SLACK
        if best and not low < scale < high:
            scale = np.sqrt(low * min(high, _FARTHER * low))
        if not low < scale < high:  # the longest chart fills the image, or all charts are a texel
            break
    if not best:
        raise _too_small(charts, size, padding)
    return best.places / size, best.is_packed


def _too_small(charts: Charts, size: int, padding: int) -> ValueError:
    side = np.sqrt(_find_rooms(charts, 0.0, padding).sum() / _FILL) - 2 * padding
    side = max(int(np.ceil(side)), size + 1)
    count = len(charts.sizes)
    subject, verb = ("1 chart", "takes") if count == 1 else (f"{count:,} charts", "take")
    return ValueError(
        f"size: got {size}, want a larger image: {subject} with a padding of {padding} {verb} about {side} texels"
    )


def _find_rooms(charts: Charts, scale: float, padding: int) -> np.ndarray:
    """Return the number of texels of each chart, with those to the next chart; xatlas rounds charts up to whole texels."""
    boxes = (np.ceil(charts.sizes * scale).clip(1.0) + 1 + 2 * padding).prod(axis=1)
    empty = (charts.sizes.prod(axis=1) - charts.areas).clip(0.0) * scale**2
    return boxes - _NESTED * empty


def find_scale(charts: Charts, size: int, padding: int, fill: float = _FILL) -> float:
    """Return the most texels per unit of length with which charts fill a part of the image, and the longest chart fits.

    The longest chart has at least one texel.
    """
    longest, room = max(charts.sizes.max(), POINT), fill * (size + 2 * padding) ** 2
    low, high = 1.0 / longest, (size - 1) / longest
    if _find_rooms(charts, high, padding).sum() <= room:
        return high
    while high > (1.0 + 1e-6) * low:
        middle = np.sqrt(low * high)
        low, high = (middle, high) if _find_rooms(charts, middle, padding).sum() <= room else (low, middle)
    return low


def _pack(charts: Charts, scale: float, size: int, padding: int) -> _Packed:
    """Pack charts with `scale` texels per unit of length into a square image, and the rest into further images.

    The scale is rounded down, so that sums in another order on another processor give the same image.
    """
    import xatlas

    atlas, (fraction, exponent) = new_atlas(), np.frexp(scale)
    scale = np.ldexp(np.floor(_STEPS * fraction) / _STEPS, exponent)
    places = (charts.places * (_UNITS * scale)).astype(np.float32)
    atlas.add_uv_mesh(places, charts.faces.astype(np.uint32), charts.chart[:, None].astype(np.uint32))
    options = xatlas.PackOptions()
    options.resolution, options.texels_per_unit, options.padding = size, 1.0 / _UNITS, padding
    options.rotate_charts_to_axis = False
    atlas.generate(pack_options=options)
    if not atlas.width:
        raise ValueError("mesh: got only faces without an area, want at least one face with an area")
    image, number = (own.astype(np.int32)[charts.faces] for own in atlas.get_mesh_vertex_assignment(0))
    is_packed = (number[:, 0] >= 0) & (number == number[:, :1]).all(axis=1)  # a face left out may join two charts
    places = atlas.get_mesh(0)[2].astype(np.float64) * size
    areas = find_flat_areas(charts.places[charts.faces])
    share = np.bincount(charts.chart, areas * (is_packed & (image[:, 0] == 0))) / np.maximum(charts.areas, POINT)
    taken = float((_find_rooms(charts, scale, padding) * share).sum())
    side = size if atlas.atlas_count > 1 else places[charts.faces[is_packed]].max() + 0.5
    return _Packed(atlas.atlas_count == 1, taken / (side + 2 * padding) ** 2, places, is_packed)
