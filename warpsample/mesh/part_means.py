"""Area-weighted means over the parts of a mesh, with standard errors, from numbers at points.

The mean of a face is the mean of its points. The variance of that mean is the sample variance divided by the number of
points. This variance includes the noise of the rays, because each point has its own random numbers and errors of points are
independent. A face with one point has the variance of that point's rays alone; a face without points is left out. Faces are
weighted by area, and their errors are independent. Errors common to all points are not included: weather, sky model, mesh.

Points share the light that faces reflect, so errors of reflected light do not average out. Several independent runs of this
light are known (`runs`). The differences between the runs' means over a part contain the shared error, in full, and add to
the variance. They also contain the noise of the points' own rays, which the sample variance contains, too. So errors are up
to 1.4 times too large.

If all values are equal, their spread is 0, but all rays may have missed the same geometry. So the error of a mean is at
least the largest product of a point's weight and its least error. With k equal weights this is a k-th of the least error, as
for a single point with all rays.

The variance of two or three values is itself uncertain, and two errors then contain the true mean too rarely. `widen`
multiplies the spread by half the quantile of Student's t distribution, so that two errors contain 95.45 % as for a normal
distribution. The degrees of freedom of a sum over faces are those of Welch and Satterthwaite.
"""

from dataclasses import dataclass

import numpy as np

from warpsample.host.locks import imported

_UPPER = 0.9772498680518208  # probability below two standard deviations of a normal distribution


@dataclass(frozen=True, eq=False)
class PartMeans:
    """Area-weighted means over the N parts of a mesh, with standard errors.

    Attributes:
        value: (N,) or (N, k) float64 means; NaN for parts without points.
        standard_error: Standard errors of `value`, of the same shape and unit.
        points: (N,) int64 number of points with finite values in each part.
    """

    value: np.ndarray
    standard_error: np.ndarray
    points: np.ndarray


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
    widen: bool = False,
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
        widen: Whether to widen errors of few points, so that two standard errors contain the true mean in 95 % of the runs.
    """
    inside = (face >= 0) & (part[face] >= 0) & np.isfinite(value.reshape(len(value), -1)).all(axis=1)
    face, value, error, least = (array[inside] for array in (face, value, error, error if least is None else least))
    points = np.bincount(face, minlength=len(part))
    weights = np.where((points > 0) & (part >= 0), areas, 0.0)
    owner = np.maximum(part, 0)
    total = np.bincount(owner, weights, count)
    components = [np.atleast_2d(array.T) for array in (value, error, least)]
    found = [_means(face, points, *component) for component in zip(*components[:2], strict=True)]
    weight = weights[face] / points[face]
    with np.errstate(invalid="ignore", divide="ignore"):
        means = [np.bincount(owner, weights * mean, count) / total for mean, _ in found]
        spreads = [_combine_variances(owner, weights**2 * variance, points, count, widen) / total for _, variance in found]
        share = weight / total[owner[face]]
        floors = [_largest(owner[face], weight * errors, count) / total for errors in components[2]]
    if runs is not None:
        spreads = np.hypot(spreads, np.sqrt(_shared_variances(owner[face], share, runs[inside], count)))
    errors = np.maximum(spreads, floors)
    shape = (count, *value.shape[1:])
    used = np.bincount(owner, np.where(weights > 0.0, points, 0), count).astype(np.int64)
    return PartMeans(np.stack(means, axis=1).reshape(shape), errors.T.reshape(shape), used)


def _combine_variances(owner: np.ndarray, variance: np.ndarray, points: np.ndarray, count: int, widen: bool) -> np.ndarray:
    """Return the root of the sum of the variances of each owner's faces, (count,) float64; widened by `_t_ratio`."""
    total = np.bincount(owner, variance, count)
    return np.sqrt(total) * (_t_ratio(owner, variance, points, total) if widen else 1.0)


def _shared_variances(owner: np.ndarray, share: np.ndarray, runs: np.ndarray, count: int) -> np.ndarray:
    """Return the variance of the mean over independent runs, (k, count) float64, of the points' owners and shares."""
    _, components, number = runs.shape
    means = [[np.bincount(owner, share * runs[:, c, r], count) for r in range(number)] for c in range(components)]
    return np.var(means, axis=1, ddof=1) / number


def _t_ratio(owner: np.ndarray, variance: np.ndarray, points: np.ndarray, total: np.ndarray) -> np.ndarray:
    """Return Student's t quantile at 95.45 %, divided by 2, for each owner; 1 where no face has two points.

    For a variance v estimated with n degrees of freedom, v^2 n / (n + 2) estimates the square of the true variance without
    bias. Hence n + 2 in the sum, and 2 less in the result.
    """
    own = np.where((variance > 0.0) & (points > 1), points - 1, 0)
    fourth = np.bincount(owner, np.where(own > 0, np.square(variance), 0.0) / (own + 2), len(total))
    known = fourth > 0.0
    degrees = np.square(total[known]) / fourth[known] - 2.0
    ratio = np.ones(len(total))
    degrees = np.clip(degrees, 1.0, np.bincount(owner, own, len(total))[known])
    ratio[known] = 0.5 * imported("scipy.special").stdtrit(degrees, _UPPER)
    return ratio


def _largest(owner: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    """Return the largest of the values of each owner, (count,) float64; 0 without values."""
    found = np.zeros(count)
    np.maximum.at(found, owner, values)
    return found


def _means(face: np.ndarray, points: np.ndarray, value: np.ndarray, error: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean of the values on each face, and the variance of this mean; 0 for faces without points."""
    many = np.maximum(points, 1)
    mean = np.bincount(face, value, len(points)) / many
    spread = np.bincount(face, np.square(value - mean[face]), len(points)) / (np.maximum(points - 1, 1) * many)
    return mean, np.where(points == 1, np.bincount(face, np.square(error, dtype=np.float64), len(points)), spread)
