"""Means over parts of a mesh from numbers at points of it, and what errors they have.

The points of a face are alike: its mean is theirs, and its variance that of their values over their number. This holds the
rays' noise, too, since each point has random numbers of its own: errors of points are independent. A face with one point has
the error of that point's rays alone, and one without is left out. Faces count by area, and their errors are independent as
well. What all points have in common is in none of it: the weather, the model of the sky, the mesh.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class PartMeans:
    """Means over N parts, weighted by area.

    Attributes:
        value: (N,) or (N, k) float64; NaN for parts without a point.
        standard_error: of the same shape and unit.
        points: (N,) int64, how many had a number.
    """

    value: np.ndarray
    standard_error: np.ndarray
    points: np.ndarray


def part_means(
    part: np.ndarray, areas: np.ndarray, face: np.ndarray, value: np.ndarray, error: np.ndarray, *, count: int
) -> PartMeans:
    """The means over the parts of a mesh.

    Args:
        part: (F,) which of so many parts each face is of, or -1.
        areas: (F,) of the faces.
        face: (P,) the face of each point, on which it is its centre or a random one; -1 of none.
        value: (P,) or (P, k) numbers at the points; NaN of points that have none.
        error: of the same shape, their standard errors.
        count: how many parts.
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
    """The mean of each face and its variance; 0 for faces without points."""
    many = np.maximum(points, 1)
    mean = np.bincount(face, value, len(points)) / many
    spread = np.bincount(face, np.square(value - mean[face]), len(points)) / (np.maximum(points - 1, 1) * many)
    return mean, np.where(points == 1, np.bincount(face, np.square(error, dtype=np.float64), len(points)), spread)
