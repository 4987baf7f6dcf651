"""Area-weighted means over the parts of a mesh, with standard errors, from numbers at points.

The mean of a face is the mean of its points. The variance of that mean is the sample variance divided by the number of
points. This variance includes the noise of the rays, because each point has its own random numbers and errors of points are
independent. A face with one point has the variance of that point's rays alone; a face without points is left out. Faces are
weighted by area, and their errors are independent. Errors common to all points are not included: weather, sky model, mesh.
"""

from dataclasses import dataclass

import numpy as np


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
    part: np.ndarray, areas: np.ndarray, face: np.ndarray, value: np.ndarray, error: np.ndarray, *, count: int
) -> PartMeans:
    """Compute the area-weighted mean over each part of a mesh, with its standard error.

    Args:
        part: (F,) part number of each face, -1 for no part.
        areas: (F,) areas of the faces.
        face: (P,) face of each point, which is the face's centroid or a random point of the face; -1 for no face.
        value: (P,) or (P, k) numbers at the points; NaN for points without a number.
        error: Standard errors of `value`, of the same shape.
        count: Number of parts.
    """
    inside = (face >= 0) & (part[face] >= 0) & np.isfinite(value.reshape(len(value), -1)).all(axis=1)
    face, value, error = face[inside], value[inside], error[inside]
    points = np.bincount(face, minlength=len(part))
    weights = np.where((points > 0) & (part >= 0), areas, 0.0)
    owner = np.maximum(part, 0)
    total = np.bincount(owner, weights, count)
    components = zip(np.atleast_2d(value.T), np.atleast_2d(error.T), strict=True)
    found = [_means(face, points, *component) for component in components]
    with np.errstate(invalid="ignore", divide="ignore"):
        means = [np.bincount(owner, weights * mean, count) / total for mean, _ in found]
        errors = [np.sqrt(np.bincount(owner, weights**2 * variance, count)) / total for _, variance in found]
    shape = (count, *value.shape[1:])
    used = np.bincount(owner, np.where(weights > 0.0, points, 0), count).astype(np.int64)
    return PartMeans(np.stack(means, axis=1).reshape(shape), np.stack(errors, axis=1).reshape(shape), used)


def _means(face: np.ndarray, points: np.ndarray, value: np.ndarray, error: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean of the values on each face, and the variance of this mean; 0 for faces without points."""
    many = np.maximum(points, 1)
    mean = np.bincount(face, value, len(points)) / many
    spread = np.bincount(face, np.square(value - mean[face]), len(points)) / (np.maximum(points - 1, 1) * many)
    return mean, np.where(points == 1, np.bincount(face, np.square(error, dtype=np.float64), len(points)), spread)
