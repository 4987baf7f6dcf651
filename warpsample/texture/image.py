"""Numbers at points of texels as images: means, their errors, and what fills texels that have none."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.making import imported

_MOST_GUTTER = 1 << 20
_BLOCK = 1 << 22  # points that are summed at a time


def check_gutter(gutter: Any, argument: str = "gutter") -> float:
    """How far an image is fill_texels, in texels; infinite for "all"."""
    if isinstance(gutter, str) and gutter == "all":
        return np.inf
    return float(check_integer(gutter, argument, 0, _MOST_GUTTER, "'all' or a whole number of at least 0"))


class TexelRows:
    """The texels of rows of points, in whose order they come: sums over texels are made block by block."""

    id: np.ndarray
    samples: np.uint64
    texels: int

    def __init__(self, id: np.ndarray, samples: int, texels: int) -> None:
        """`id` are those of `Claims`, ascending, of an image of so many texels."""
        self.id, self.samples, self.texels = id, np.uint64(samples), texels

    def blocks(self) -> Iterator[tuple[slice, np.ndarray]]:
        """Rows of points and their texels, (n,) int64."""
        for start in range(0, len(self.id), _BLOCK):
            rows = slice(start, start + _BLOCK)
            yield rows, (self.id[rows] // self.samples).view(np.int64)

    @property
    def covered(self) -> np.ndarray:
        """(texels,) bool, those that have a point."""
        found = np.zeros(self.texels, np.bool_)
        for _, texel in self.blocks():
            found[texel] = True
        return found

    def means(self, width: int, values: Callable[[slice, np.ndarray], np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
        """The mean (texels, width) float64 of what is finite of the values of points, NaN of none; (texels,) how many.

        `values` gives (n, width) numbers of points, by their rows and their texels.
        """
        total, count = np.zeros((self.texels, width)), np.zeros(self.texels, np.int32)
        for rows, texels in self.blocks():
            found = values(rows, texels)
            good = np.isfinite(found).all(axis=1)
            texel, found = (texels, found) if good.all() else (texels[good], found[good])
            if len(texel):
                first, span = int(texel[0]), int(texel[-1] - texel[0]) + 1
                count[first : first + span] += np.bincount(texel - first, minlength=span).astype(np.int32)
                for channel, column in enumerate(found.T):
                    total[first : first + span, channel] += np.bincount(texel - first, column, span)
        with np.errstate(invalid="ignore"):
            total /= np.where(count > 0, count, np.nan)[:, None]
        return total, count

    def errors(self, values: np.ndarray, own: np.ndarray, columns: int) -> np.ndarray:
        """Return the standard errors (texels, C) float64 of the means of values, from the differences between these.

        A texel with one value has no differences: its variance is that of the values in the texels around it, and at least
        the square of its own error.

        Args:
            values: (P, C), of the points.
            own: (P, C), their own standard errors.
            columns: texels in a row of the image.
        """
        width = values.shape[1]
        mean, count = self.means(width, lambda rows, _: values[rows])
        squares, _ = self.means(width, lambda rows, texel: np.square(values[rows] - mean[texel]))
        errors = np.sqrt(squares / np.maximum(count - 1, 1)[:, None])
        single = np.flatnonzero(count == 1)
        if len(single):
            alone, _ = self.means(width, lambda rows, _: own[rows])
            around = np.sqrt(_pool_variance(squares, count, single, columns))
            errors[single] = np.fmax(alone[single], around)
        return errors


def _pool_variance(squares: np.ndarray, count: np.ndarray, texels: np.ndarray, columns: int) -> np.ndarray:
    """Return the variance (n, C) within texels, pooled over the 3 x 3 around some; over all texels where these have none.

    Args:
        squares: (texels, C), means of the squared deviations in each texel.
        count: (texels,), values in each.
        texels: (n,), the numbers of those to pool around.
        columns: texels in a row of the image.
    """
    row, column = np.divmod(texels, columns)
    total, freedom = np.zeros((len(texels), squares.shape[1])), np.zeros((len(texels), 1))
    for down in (-1, 0, 1):
        for right in (-1, 0, 1):
            y, x = row + down, column + right
            good = np.flatnonzero((y >= 0) & (y < len(count) // columns) & (x >= 0) & (x < columns))
            near = y[good] * columns + x[good]
            good, near = good[count[near] > 1], near[count[near] > 1]
            total[good] += squares[near] * count[near, None]
            freedom[good] += count[near, None] - 1
    several = count > 1
    whole = np.einsum("tc,t->c", squares[several], count[several]) / max(1, int((count[several] - 1).sum()))
    return np.where(freedom > 0, total / np.maximum(freedom, 1), whole)


def fill_texels(
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
        source[rest] = _find_nearest(has.reshape(height, width)).ravel()[rest]
    if gutter and covered.any() and not covered.all():
        near = _find_nearest(covered.reshape(height, width), gutter).ravel()
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
            near = _find_nearest(own & has[box])[rows, columns]
            across = box[1].stop - box[1].start
            at = (rows + box[0].start) * width + columns + box[1].start
            source[at] = (near // across + box[0].start) * width + near % across + box[1].start


def _find_nearest(known: np.ndarray, most: float = np.inf) -> np.ndarray:
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
