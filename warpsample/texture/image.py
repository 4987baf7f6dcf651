"""Images of values at texel points: means, standard errors, and filling of texels without a value."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.locks import imported

_MOST_GUTTER = 1 << 20
_BLOCK = 1 << 22  # points summed at a time


def check_gutter(gutter: Any, argument: str = "gutter") -> float:
    """Check the option `gutter`, the distance in texels up to which empty texels are filled; return inf for "all"."""
    if isinstance(gutter, str) and gutter == "all":
        return np.inf
    return float(check_integer(gutter, argument, 0, _MOST_GUTTER, f"'all' or a whole number from 0 to {_MOST_GUTTER}"))


class TexelRows:
    """Grouping of points by texel, for means and standard errors per texel.

    Attributes:
        id: (P,) uint64, ids of the points, as in `Claims`.
        samples: samples per texel.
        texels: number of texels of the image.
    """

    id: np.ndarray
    samples: np.uint64
    texels: int

    def __init__(self, id: np.ndarray, samples: int, texels: int) -> None:
        """Set the points, given by ids in ascending order, the samples per texel and the number of texels."""
        self.id, self.samples, self.texels = id, np.uint64(samples), texels

    def blocks(self) -> Iterator[tuple[slice, np.ndarray]]:
        """Yield (slice of points, (n,) int64 texel of each point) for blocks of points."""
        for start in range(0, len(self.id), _BLOCK):
            rows = slice(start, start + _BLOCK)
            yield rows, (self.id[rows] // self.samples).view(np.int64)

    @property
    def covered(self) -> np.ndarray:
        """Mask of the texels with at least one point, (texels,) bool."""
        found = np.zeros(self.texels, np.bool_)
        for _, texel in self.blocks():
            found[texel] = True
        return found

    def means(self, width: int, values: Callable[[slice, np.ndarray], np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean (texels, width) float64 of the finite values in each texel, NaN without one, and their number.

        Args:
            width: number of values per point. A point counts only if all its values are finite.
            values: function that returns the (n, width) values of points, from their slice and their texels.
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
        """Return the standard errors (texels, C) float64 of the texels' means, from the spread of values within texels.

        A texel with one value has no spread: its variance is pooled from the surrounding texels. The error of a mean of k
        values is at least a k-th of the largest standard error among these values, because equal values have no spread. A
        texel without a finite value has the error NaN.

        Args:
            values: (P, C), values at the points.
            own: (P, C), standard errors of the values.
            columns: texels in a row of the image.
        """
        width = values.shape[1]
        mean, count = self.means(width, lambda rows, _: values[rows])
        squares, _ = self.means(width, lambda rows, texel: np.square(values[rows] - mean[texel]))
        errors = np.sqrt(squares / np.maximum(count - 1, 1)[:, None])
        single = np.flatnonzero(count == 1)
        if len(single):
            errors[single] = np.sqrt(_pool_variance(squares, count, single, columns))
        errors = np.fmax(errors, self._largest(own) / np.maximum(count, 1)[:, None])
        errors[count == 0] = np.nan
        return errors

    def _largest(self, values: np.ndarray) -> np.ndarray:
        """Return the largest of the values (P, C) in each texel, (texels, C), without NaN; 0 for texels without points."""
        found = np.zeros((self.texels, values.shape[1]), values.dtype)
        for rows, texel in self.blocks():
            starts = np.flatnonzero(np.diff(texel, prepend=-1))
            found[texel[starts]] = np.fmax(found[texel[starts]], np.fmax.reduceat(values[rows], starts))
        return found


def _pool_variance(squares: np.ndarray, count: np.ndarray, texels: np.ndarray, columns: int) -> np.ndarray:
    """Return the variance of values within a texel, (n, C), averaged over the 3 x 3 block around each given texel.

    Where the block has no texel with several values, the variance is pooled over the whole image.

    Args:
        squares: (texels, C), mean squared deviation in each texel.
        count: (texels,), number of values in each texel.
        texels: (n,), numbers of the texels to pool around.
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
    """Build the (H, W, C) image of texel values; empty texels get the value of the nearest texel with a value.

    Args:
        found: (texels, C), values, NaN where there is none. The image has the same type.
        covered: (texels,) bool, texels that faces reach. A covered texel is filled from its own chart if possible.
        charts: function that returns (texels,) int32, the chart of each texel. Called only if a covered texel has no value.
        size: width and height.
        gutter: largest distance in texels from a covered texel at which other texels are filled; texels farther away are 0.
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
    image = found[source]
    image[~has[source]] = 0.0
    return image.reshape(height, width, -1)


def _fill_charts(source: np.ndarray, lost: np.ndarray, has: np.ndarray, charts: np.ndarray) -> None:
    """Choose, for each texel of a chart without a value, the nearest texel of the same chart to copy from."""
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
    """Return, for each texel, the number of the nearest texel in the mask `known`, (H, W).

    Texels farther than `most` texels from the mask get their own number, and so do all texels if the mask is empty.
    """
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
