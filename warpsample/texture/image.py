"""Numbers at points of texels as images: means, their errors, and what fills texels that have none."""

from collections.abc import Callable
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.making import imported

_MOST_GUTTER = 1 << 20


def check_gutter(gutter: Any, argument: str = "gutter") -> float:
    """How far an image is filled, in texels; infinite for "all"."""
    if isinstance(gutter, str) and gutter == "all":
        return np.inf
    return float(check_integer(gutter, argument, 0, _MOST_GUTTER, "'all' or a whole number of at least 0"))


def means_of(values: np.ndarray, texel: np.ndarray, texels: int) -> tuple[np.ndarray, np.ndarray]:
    """The mean (texels, C) float64 of the finite ones of (P, C) numbers of points, NaN of none; and (texels,) how many."""
    good = np.isfinite(values).all(axis=1)
    texel, values = texel[good], values[good]
    count = np.bincount(texel, minlength=texels)
    found = np.empty((texels, values.shape[1]))
    for channel, column in enumerate(values.T):
        with np.errstate(invalid="ignore"):
            found[:, channel] = np.bincount(texel, column, texels) / np.where(count > 0, count, np.nan)
    return found, count


def errors_of(values: np.ndarray, own: np.ndarray, texel: np.ndarray, texels: int) -> np.ndarray:
    """(texels, C) float64: the standard errors of `means_of`, by the differences of a texel's points; of one, its own."""
    mean, count = means_of(values, texel, texels)
    squares, _ = means_of(np.square(values - mean[texel]), texel, texels)
    alone, _ = means_of(own, texel, texels)
    spread = np.sqrt(squares / np.maximum(count - 1, 1)[:, None])
    return np.where((count == 1)[:, None], alone, spread)


def filled(
    found: np.ndarray, covered: np.ndarray, charts: Callable[[], np.ndarray], size: tuple[int, int], gutter: float
) -> np.ndarray:
    """(H, W, C) float32: an image whose texels without a number get that of the nearest one that has.

    Args:
        found: (texels, C), NaN where there is none.
        covered: (texels,) bool, those that faces reach: they take numbers of their own chart if it has any.
        charts: gives (texels,) int32, the chart of each; asked for only if some covered one has no number.
        size: width and height.
        gutter: how far from the covered ones others get numbers; what is left over is 0.
    """
    width, height = size
    has = ~np.isnan(found).any(axis=1)
    source = np.arange(len(found))
    lost = covered & ~has
    if lost.any():
        _fill_charts(source, lost, has, charts().reshape(height, width))
        rest = lost & ~has[source]
        source[rest] = _nearest(has.reshape(height, width)).ravel()[rest]
    if gutter and covered.any() and not covered.all():
        near = _nearest(covered.reshape(height, width), gutter).ravel()
        source = np.where(covered, source, source[near])
    image = found[source].astype(np.float32)
    image[~has[source]] = 0.0
    return image.reshape(height, width, -1)


def _fill_charts(source: np.ndarray, lost: np.ndarray, has: np.ndarray, charts: np.ndarray) -> None:
    """Sets where the covered texels that have no number take one from: from the nearest of their chart that has."""
    height, width = charts.shape
    lost, has = lost.reshape(height, width), has.reshape(height, width)
    boxes = imported("scipy.ndimage").find_objects(charts + 1)
    for chart in np.unique(charts[lost]).tolist():
        box = boxes[chart]
        own = charts[box] == chart
        if (own & has[box]).any():
            rows, columns = np.nonzero(own & lost[box])
            near = _nearest(own & has[box])[rows, columns]
            across = box[1].stop - box[1].start
            at = (rows + box[0].start) * width + columns + box[1].start
            source[at] = (near // across + box[0].start) * width + near % across + box[1].start


def _nearest(known: np.ndarray, most: float = np.inf) -> np.ndarray:
    """(H, W): the number of the nearest texel that is known, by the distance of centres; beyond `most` of each itself."""
    transform = imported("scipy.ndimage").distance_transform_edt
    if not known.any():
        return np.arange(known.size).reshape(known.shape)
    row, column = transform(~known, return_distances=False, return_indices=True)
    near = row.astype(np.int64) * known.shape[1] + column
    if most == np.inf:
        return near
    y, x = np.indices(known.shape, np.int64, sparse=True)
    far = (row - y) ** 2 + (column - x) ** 2 > most**2
    return np.where(far, y * known.shape[1] + x, near)
