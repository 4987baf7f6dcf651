"""Images of values at texel points: means, standard errors, and filling of texels without a value."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.locks import imported, once_property
from warpsample.mesh.part_means import shared_variance

_MOST_GUTTER = 1 << 20
_BLOCK = 1 << 22  # points summed at a time
_SIGMAS_OF_CHANGE = 5.0  # those of a texel in `do_pictures_differ`: the change of one sample is no difference


def check_gutter(gutter: Any, argument: str = "gutter") -> float:
    """Check the option `gutter`, the distance in texels up to which empty texels are filled; return inf for "all"."""
    if isinstance(gutter, str) and gutter == "all":
        return np.inf
    return float(check_integer(gutter, argument, 0, _MOST_GUTTER, f"'all' or a whole number from 0 to {_MOST_GUTTER}"))


class TexelRows:
    """Grouping of points by texel, for means, standard errors and images.

    Attributes:
        id: (P,) uint64, ids of the points in ascending order, as in `Claims`.
        samples: samples per texel.
        size: width and height of the image.
        charts: function that returns the chart of each texel, as for `fill_texels`.
    """

    id: np.ndarray
    samples: np.uint64
    size: tuple[int, int]
    charts: Callable[[], np.ndarray]

    def __init__(self, id: np.ndarray, samples: int, size: tuple[int, int], charts: Callable[[], np.ndarray]) -> None:
        """Set the attributes."""
        self.id, self.samples, self.size, self.charts = id, np.uint64(samples), size, charts
        self.texels = size[0] * size[1]

    def blocks(self) -> Iterator[tuple[slice, np.ndarray]]:
        """Yield (slice of points, (n,) int64 texel of each point) for blocks of points."""
        for start in range(0, len(self.id), _BLOCK):
            rows = slice(start, start + _BLOCK)
            yield rows, (self.id[rows] // self.samples).view(np.int64)

    @once_property
    def covered(self) -> np.ndarray:
        """Mask of the texels with at least one point, (texels,) bool."""
        found = np.zeros(self.texels, np.bool_)
        for _, texel in self.blocks():
            found[texel] = True
        return found

    def means(
        self, values: np.ndarray, transform: Callable[[np.ndarray, np.ndarray], np.ndarray] | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean (texels, C) float64 of the finite values in each texel, NaN without one, and their number.

        Args:
            values: (P, C), values at the points. A point counts only if all its values are finite.
            transform: function of the (n, C) values and (n,) texels of a block of points that returns the numbers to
                average. Default: None, the values themselves.
        """
        total, count = np.zeros((self.texels, values.shape[1])), np.zeros(self.texels, np.int32)
        for rows, texels in self.blocks():
            found = values[rows] if transform is None else transform(values[rows], texels)
            finite, texel = np.isfinite(found), texels
            if not finite.all():
                good = finite.all(axis=1)
                texel, found = texels[good], found[good]
            if len(texel):
                first, span = int(texel[0]), int(texel[-1] - texel[0]) + 1
                count[first : first + span] += np.bincount(texel - first, minlength=span).astype(np.int32)
                for channel, column in enumerate(found.T):
                    total[first : first + span, channel] += np.bincount(texel - first, column, span)
        with np.errstate(invalid="ignore"):
            total /= np.where(count > 0, count, np.nan)[:, None]
        return total, count

    def means_and_errors(self, values: np.ndarray, owns: Sequence[np.ndarray]) -> list[np.ndarray]:
        """Return the means of the values in each texel, and for each of `owns` the standard errors of the means.

        With several samples per texel, errors come from the spread of the values within a texel. A texel with one value has
        no spread: its variance is pooled from the surrounding texels. The error of a mean of k values is at least a k-th of
        the largest standard error among these values, because equal values have no spread. A texel without a finite value
        has the error NaN.

        Args:
            values: (P, C), values at the points.
            owns: (P, C) arrays of standard errors of the values.

        Returns:
            (texels, C) float64 arrays.
        """
        mean, count = self.means(values)
        if self.samples == 1:
            return [mean, *map(self.copy_errors, owns)]
        squares, _ = self.means(values, lambda some, texel: np.square(some - mean.take(texel, axis=0)))
        spread = np.sqrt(squares / np.maximum(count - 1, 1)[:, None])
        single = np.flatnonzero(count == 1)
        if len(single):
            spread[single] = np.sqrt(_pool_variance(squares, count, single, self.size[0]))
        errors = [np.fmax(spread, most / np.maximum(count, 1)[:, None]) for most in self._reduce(np.fmax, *owns)]
        for error in errors:
            error[count == 0] = np.nan
        return [mean, *errors]

    def copy_errors(self, errors: np.ndarray) -> np.ndarray:
        """Return the errors (P, C) of points, one per texel, as (texels, C) float64; inf stays inf, NaN without a point."""
        found = np.full((self.texels, errors.shape[1]), np.nan)
        for rows, texel in self.blocks():
            found[texel] = np.abs(errors[rows])  # -0.0 becomes 0.0
        return found

    def shared_errors(self, values: np.ndarray, runs: np.ndarray) -> np.ndarray:
        """Return the errors of the texels' means due to the reflected light that all points share, (texels, C) float64.

        The samples of a texel have this error in common, so their spread does not contain it.

        Args:
            values: (P, C), values at the points, NaN if unknown.
            runs: (P, C, R), light that faces reflect to the points, in each of R independent runs.
        """
        known = np.isfinite(values).all(axis=1, keepdims=True)
        means = [self.means(np.where(known, run, np.nan))[0] for run in np.moveaxis(runs, 2, 0)]
        return np.sqrt(shared_variance(np.stack(means), axis=0))

    def ray_errors(self, values: np.ndarray, raised: np.ndarray, unbiased: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the parts of two kinds of standard errors that come from rays, (texels, C) float64, NaN without a value.

        The first is at least a k-th of the largest of the k raised errors in a texel. Rays that all agree have such an
        error, which is proportional to 1 / rays, and k samples have k times as many rays. For exact values, rounding may
        move one sample to a neighbouring face of a finer mesh: the first is a fifth of the largest change of the mean by one
        sample.

        Args:
            values: (P, C), values at the points, NaN if unknown.
            raised: Raised standard errors of the same shape, NaN for points without a value.
            unbiased: Standard errors of the same shape that are 0 where all rays agree.
        """
        squares, count = self.means(unbiased, lambda some, _: np.square(some))
        count = np.maximum(count, 1)[:, None]
        own = np.sqrt(squares / count)
        most, high = self._reduce(np.fmax, raised, values)
        change = (high - self._reduce(np.fmin, values)[0]) / count
        least = np.fmax(own, most / count)
        return np.where(least > 0.0, least, change / _SIGMAS_OF_CHANGE), own

    def fill(self, found: np.ndarray, gutter: Any, channels: tuple[int, ...]) -> np.ndarray:
        """Return the image (H, W, *channels) of values (texels, C), as `fill_texels` fills texels without a value."""
        made = fill_texels(found, self.covered, self.charts, self.size, check_gutter(gutter))
        return made.reshape(*made.shape[:2], *channels)

    def _reduce(self, extreme: np.ufunc, *arrays: np.ndarray) -> list[np.ndarray]:
        """Return the extreme values of (P, C) arrays in each texel, (texels, C), by np.fmax or np.fmin; NaN without any."""
        found = [np.full((self.texels, array.shape[1]), np.nan, array.dtype) for array in arrays]
        for rows, texel in self.blocks():
            starts = np.flatnonzero(np.diff(texel, prepend=-1))
            own = texel[starts]
            for one, array in zip(found, arrays, strict=True):
                one[own] = extreme(one[own], extreme.reduceat(array[rows], starts))
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
