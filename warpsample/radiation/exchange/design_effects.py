"""Variances of view factors: how much smaller they are with quasi-random rays than with independent rays.

The replicates of one number give few degrees of freedom: alone they often give an error bar of a third of the right one, or
0 where they agree. But design effects are similar for similar numbers of hits or misses: 1 for few, 0.1 for thousands. So
the variance of each number is partly estimated from the replicates of all similar numbers.
"""

from collections.abc import Iterator

import numpy as np

_CLASSES = 64
_PRIOR = 4.0
"""Degrees of freedom of a class's design effect: in a class, effects vary by at most 0.7 of the mean; 2 / 0.7^2 is 4."""

_SLICE = 1 << 20  # hits at a time: the squares of all hits would take more memory than the result


def factors_and_variances(hits: np.ndarray, rays: int) -> tuple[np.ndarray, np.ndarray]:
    """Return view factors and their variances, from the numbers of hits of two or more independent sets of rays.

    The variance is (4 v F (1 - F) / n + (R - 1) s^2) / (4 + R - 1), with s^2 from the R replicates.

    Args:
        hits: (E, R) hits of each replicate, as integers or as float64 sums of weights from 0 to 1. All must be of one kind,
            since hits of the sky vary less than hits of faces. Sums of weights are split by whether all are whole numbers.
        rays: Number of rays n per row, over all replicates.
    """
    if hits.dtype.kind == "f" and len(hits):
        whole = (hits == np.rint(hits)).all(axis=1)
        if 0 < np.count_nonzero(whole) < len(hits):
            return _compute_by_kind(hits, rays, whole)
    value, variance = np.empty(len(hits)), np.empty(len(hits))
    own, effects = hits.shape[1] - 1, _estimate_effects(hits, rays)
    for part, total, spread in _iterate_slices(hits):
        independent, kind = _compute_independent_variance(total, rays)
        value[part] = total / rays
        expected = _PRIOR * effects[kind] * independent
        variance[part] = (expected + own * spread) / ((_PRIOR + own) * float(rays) ** 2)
    return value, variance


def _compute_by_kind(hits: np.ndarray, rays: int, whole: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return view factors and variances, computed separately for the entries in the mask `whole` and for the rest."""
    found = np.empty((2, len(hits)))
    for kind in (whole, ~whole):
        found[:, kind] = factors_and_variances(hits[kind], rays)
    return found[0], found[1]


def _estimate_effects(hits: np.ndarray, rays: int) -> np.ndarray:
    """Estimate the ratio of measured to binomial variance (design effect), for each class of equal binomial variance."""
    sums, numbers = np.zeros(_CLASSES), np.zeros(_CLASSES)
    for _, total, spread in _iterate_slices(hits) if hits.shape[1] > 1 else ():
        independent, kind = _compute_independent_variance(total, rays)
        there = independent > 0.0
        sums += np.bincount(kind[there], spread[there] / independent[there], _CLASSES)
        numbers += np.bincount(kind[there], minlength=_CLASSES)
    usual = _fit_effects(sums, numbers)
    return (sums + usual) / (numbers + 1.0)


def _fit_effects(sums: np.ndarray, numbers: np.ndarray) -> np.ndarray:
    """Fit ratios of measured to binomial variance, (_CLASSES,), that are a power of the binomial variance.

    With a single replicate the power is -1/4: a boundary through points that fill four dimensions evenly leaves m^(3/4) of m
    cells undecided.
    """
    if not numbers.any():
        return np.exp2(-0.25 * np.arange(_CLASSES))
    low, high = 0.0, 1.0
    for _ in range(20):
        middle = 0.5 * (low + high)
        suits = (sums * np.exp2(middle * np.arange(_CLASSES))).sum() <= numbers.sum()
        low, high = (middle, high) if suits else (low, middle)
    return np.exp2(-low * np.arange(_CLASSES))


def _iterate_slices(hits: np.ndarray) -> Iterator[tuple[slice, np.ndarray, np.ndarray]]:
    """Yield (slice of the view factors, total numbers of hits, measured variances of the numbers of hits)."""
    replicates = hits.shape[1]
    step = _SLICE // replicates
    for first in range(0, len(hits), step):
        some = hits[first : first + step].astype(np.float64 if hits.dtype.kind == "f" else np.int64)
        total = some.sum(axis=1)
        squares = np.maximum(replicates * np.square(some).sum(axis=1) - np.square(total), 0)
        yield slice(first, first + step), total, squares / max(1, replicates - 1)


def _compute_independent_variance(total: np.ndarray, rays: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the binomial variance n F (1 - F) of numbers of hits, and the class of each: its binary exponent."""
    variance = total * np.maximum(rays - total, 0) / rays
    return variance, np.clip(np.frexp(variance)[1], 0, _CLASSES - 1)
