"""Area-weighted means over the parts of a mesh, with standard errors, from numbers at points.

The mean of a face is the mean of its points. The variance of that mean is the sample variance divided by the number of
points, which includes the noise of the rays: each point has its own random numbers. A face with one point has the variance
of that point's rays alone; a face without points is left out. Faces are weighted by area, and their errors are independent.
Errors common to all points are not included: weather, sky model, mesh.

Points share the light that faces reflect. The differences between the means of several independent runs of this light
(`runs`) contain the shared error, in full, and add to the variance. They also contain the noise of the points' own rays,
which then counts twice. So errors are up to 1.4 times too large.

If all values are equal, all rays may have missed the same geometry. So the error of a mean is at least the largest product
of a point's weight and its least error.

The variance of a few values is itself uncertain: all points of a roof may miss the shadow of its chimney. So the variance
of a part is combined with the mean variance of the other parts of its kind, unless its own is larger (empirical Bayes).
Parts with a similar number of points count most, because large open roofs say little about small roofs in the shade: a
part with r times as many points, or an r-th, counts r^-6. The mean variance counts as 8 values, or as k - 1 values if
this is more, where k is the deviations' kurtosis: if deviations are rare and large, a part's own values say little. A
part without any variation keeps the variance 0 if its least errors are 0, because then no point needs a ray; such parts
do not count for the others.
The three numbers are chosen from scenes of houses and of a real city, see `tests/city/test_means_over_roofs.py`.
"""

from dataclasses import dataclass

import numpy as np

_WORTH = 8.0  # number of values for which the mean variance of other parts counts at least


@dataclass(frozen=True, eq=False)
class PartMeans:
    """Area-weighted means over the N parts of a mesh, with standard errors.

    Attributes:
        value: (N,) or (N, k) float64 means; NaN for parts without points.
        standard_error: Standard errors of `value`, of the same shape and unit.
        points: (N,) int64 number of points with finite values in each part.
        runs: (k, R, N) float64 means of the `runs` of `part_means`, or None. Parts share their errors.
    """

    value: np.ndarray
    standard_error: np.ndarray
    points: np.ndarray
    runs: np.ndarray | None = None


def part_means(
    part: np.ndarray,
    areas: np.ndarray,
    face: np.ndarray,
    value: np.ndarray,
    error: np.ndarray,
    *,
    count: int,
    least: np.ndarray | None = None,
    runs: np.ndarray | None = None,
    kind: np.ndarray | None = None,
) -> PartMeans:
    """Compute the area-weighted mean over each part of a mesh, with its standard error.

    Args:
        part: (F,) part number of each face, -1 for no part.
        areas: (F,) areas of the faces.
        face: (P,) face of each point, which is the face's centroid or a random point of the face; -1 for no face.
        value: (P,) or (P, k) numbers at the points; NaN for points without a number.
        error: Standard errors of `value`, of the same shape.
        count: Number of parts.
        least: Standard errors of `value` that account for geometry without a hit, of the same shape. Default: `error`.
        runs: (P, k, R) part of `value` in each of R independent runs, whose errors points share. k is 1 for (P,) values.
            Default: no part with shared errors.
        kind: (count,) kind of each part, whose variance is combined with those of parts of the same kind. Default: one kind.
    """
    inside = (face >= 0) & (part[face] >= 0) & np.isfinite(value.reshape(len(value), -1)).all(axis=1)
    face, value, error, least = (array[inside] for array in (face, value, error, error if least is None else least))
    points = np.bincount(face, minlength=len(part))
    weights = np.where((points > 0) & (part >= 0), areas, 0.0)
    owner = np.maximum(part, 0)
    total = np.bincount(owner, weights, count)
    components = [np.atleast_2d(array.T) for array in (value, error, least)]
    found = [_means(face, points, *component) for component in zip(*components[:2], strict=True)]
    kinds = np.zeros(count, np.int64) if kind is None else np.unique(kind, return_inverse=True)[1]
    faces = _Faces(owner, weights, points, kinds)
    with np.errstate(invalid="ignore", divide="ignore"):
        share = weights[face] / points[face] / total[owner[face]]
        means = [np.bincount(owner, weights * mean, count) / total for mean, *_ in found]
        floors = np.array([_largest(owner[face], share * errors, count) for errors in components[2]])
        variances = [faces.combine(*sums, floor > 0.0) for (_, *sums), floor in zip(found, floors, strict=True)]
        spreads = np.sqrt(variances) / total
    if runs is not None:
        runs = np.array(
            [[np.bincount(owner[face], share * run, count) for run in rows.T] for rows in runs[inside].swapaxes(0, 1)]
        )
        spreads = np.hypot(spreads, np.sqrt(shared_variance(runs, axis=1)))
    errors = np.maximum(spreads, floors)
    shape = (count, *value.shape[1:])
    used = np.bincount(owner, np.where(weights > 0.0, points, 0), count).astype(np.int64)
    return PartMeans(np.stack(means, axis=1).reshape(shape), errors.T.reshape(shape), used, runs)


@dataclass(frozen=True, eq=False)
class _Faces:
    """F faces of N parts, with their numbers of points.

    Attributes:
        owner: (F,) part of each face.
        weights: (F,) area of each face; 0 for a face without points or without a part.
        points: (F,) number of points on each face.
        kind: (N,) kind of each part, from 0.
    """

    owner: np.ndarray
    weights: np.ndarray
    points: np.ndarray
    kind: np.ndarray

    def combine(self, squares: np.ndarray, fourth: np.ndarray, may_vary: np.ndarray) -> np.ndarray:
        """Return the variance of each part's weighted sum of face means, (N,) float64, combined with other parts.

        Args:
            squares: (F,) sum of the squared deviations of a face's values from their mean. For a face with one point, the
                squared error of this point.
            fourth: (F,) sum of the fourth powers of these deviations.
            may_vary: (N,) bool, whether parts without any variation may have missed geometry.
        """
        many = (self.points > 1) & (self.weights > 0.0)
        per_value = np.square(self.weights) / np.maximum(self.points, 1)
        own = self._add(per_value * squares / np.maximum(self.points - 1, 1), many)
        varies = (own > 0.0) | may_vary
        others, worth = self._average_others(squares, fourth, many & varies[self.owner])
        degrees = self._add(self.points - 1, many)
        combined = (degrees * own + worth * others * self._add(per_value, many)) / (degrees + worth)
        return self._add(per_value * squares, ~many) + np.where(varies, np.fmax(own, combined), own)

    def _average_others(self, squares: np.ndarray, fourth: np.ndarray, many: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean variance of the other parts of a part's kind, and the number of values for which it counts.

        Both are (N,) float64. The variance is NaN for parts without other parts.
        """
        degrees, points, *sums = (self._add(terms, many) for terms in (self.points - 1, self.points, squares, fourth))
        terms = np.array([degrees, points, *sums]) / np.where(degrees > 0.0, degrees, np.inf)
        means = np.zeros(terms.shape)
        for number in range(self.kind.max(initial=-1) + 1):
            rows = np.flatnonzero(self.kind == number)
            rows = rows[np.argsort(points[rows], kind="stable")]
            size = np.maximum(points[rows], 1.0)
            power = np.square(size * size * size)
            # A part with fewer points n' counts (n'/n)^6, one with more points (n/n')^6.
            means[:, rows] = _sum_before(terms[:, rows] * power) / power
            means[:, rows] += _sum_before((terms[:, rows] / power)[:, ::-1])[:, ::-1] * power
        weight, values, second, fourth = means
        kurtosis = fourth * values / np.square(second)
        return second / weight, np.fmax(_WORTH, kurtosis - 1.0)

    def _add(self, terms: np.ndarray, where: np.ndarray) -> np.ndarray:
        """Return the sum over the chosen faces of each part, (N,) float64."""
        return np.bincount(self.owner[where], terms[where], len(self.kind))


def _sum_before(terms: np.ndarray) -> np.ndarray:
    """Return the sum of all terms before each term in its row, of the same shape."""
    return np.hstack([np.zeros((len(terms), 1)), np.cumsum(terms, axis=1)[:, :-1]])


def shared_variance(runs: np.ndarray, axis: int) -> np.ndarray:
    """Return the variance of the mean over the independent runs along an axis."""
    return np.var(runs, axis=axis, ddof=1) / runs.shape[axis]


def _largest(owner: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    """Return the largest of the values of each owner, (count,) float64; 0 without values."""
    found = np.zeros(count)
    np.maximum.at(found, owner, values)
    return found


def _means(face: np.ndarray, points: np.ndarray, value: np.ndarray, error: np.ndarray) -> list[np.ndarray]:
    """Return the mean of the values on each face, and the sums of the second and fourth powers of their deviations.

    For a face with one point, the deviation is the error of this point.
    """
    mean = np.bincount(face, value, len(points)) / np.maximum(points, 1)
    away = np.where(points[face] == 1, error, value - mean[face])
    squares = np.square(away, dtype=np.float64)
    return [mean, *(np.bincount(face, terms, len(points)) for terms in (squares, np.square(squares)))]
