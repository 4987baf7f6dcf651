"""How much less the hits of a lattice's rays vary than those of independent rays: their design effect, told by all rows.

A number's own replicates tell its variance by few degrees of freedom: with them alone, a bar is often a third of what it
should be, and 0 where they agree. But design effects are alike where as many rays hit, or miss: 1 where those are few, 0.1
where they are thousands. So each number takes part of its variance from the replicates of all that are like it.
"""

from collections.abc import Iterator

import numpy as np

_CLASSES = 64
_PRIOR = 4.0
"""Degrees of freedom of what a class tells: within it design effects differ by 0.7 of their mean or less; 2 / 0.7^2 is 4."""

_SLICE = 1 << 20  # hits at a time: the squares of all of them would take more memory than the result


def factors_and_variances(hits: np.ndarray, rays: int) -> tuple[np.ndarray, np.ndarray]:
    """Factors F and their variances, (4 v F (1 - F) / n + (R - 1) s^2) / (4 + R - 1): v is a design effect.

    Args:
        hits: (E, R) integers, of each replicate; of one kind: what meets the sky varies less than what meets a face. Or
            float64, sums of weights from 0 to 1: those of a part vary less than whole ones, and are a kind of their own.
        rays: n of each row, of all replicates together.
    """
    if hits.dtype.kind == "f" and len(hits):
        whole = (hits == np.rint(hits)).all(axis=1)
        if 0 < np.count_nonzero(whole) < len(hits):
            return _apart(hits, rays, whole)
    value, variance = np.empty(len(hits)), np.empty(len(hits))
    own, effects = hits.shape[1] - 1, _effects(hits, rays)
    for part, total, spread in _slices(hits):
        independent, kind = _independent(total, rays)
        value[part] = total / rays
        expected = _PRIOR * effects[kind] * independent
        variance[part] = (expected + own * spread) / ((_PRIOR + own) * float(rays) ** 2)
    return value, variance


def _apart(hits: np.ndarray, rays: int, whole: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Factors and variances of two kinds of numbers, each by themselves."""
    found = np.empty((2, len(hits)))
    for kind in (whole, ~whole):
        found[:, kind] = factors_and_variances(hits[kind], rays)
    return found[0], found[1]


def _effects(hits: np.ndarray, rays: int) -> np.ndarray:
    """(_CLASSES,) design effects: the mean of a class's numbers and of one more, which is as usual."""
    sums, numbers = np.zeros(_CLASSES), np.zeros(_CLASSES)
    for _, total, spread in _slices(hits) if hits.shape[1] > 1 else ():
        independent, kind = _independent(total, rays)
        there = independent > 0.0
        sums += np.bincount(kind[there], spread[there] / independent[there], _CLASSES)
        numbers += np.bincount(kind[there], minlength=_CLASSES)
    usual = _usual(sums, numbers)
    return (sums + usual) / (numbers + 1.0)


def _usual(sums: np.ndarray, numbers: np.ndarray) -> np.ndarray:
    """(_CLASSES,) design effects that are a power of the hits' variance: that which suits all numbers, 1 for single hits.

    Without differences of replicates: where a boundary parts points that fill four dimensions evenly, those of its cells are
    unsure, m^(3/4) of m, a share of m^(-1/4).
    """
    if not numbers.any():
        return np.exp2(-0.25 * np.arange(_CLASSES))
    low, high = 0.0, 1.0
    for _ in range(20):
        middle = 0.5 * (low + high)
        suits = (sums * np.exp2(middle * np.arange(_CLASSES))).sum() <= numbers.sum()
        low, high = (middle, high) if suits else (low, middle)
    return np.exp2(-low * np.arange(_CLASSES))


def _slices(hits: np.ndarray) -> Iterator[tuple[slice, np.ndarray, np.ndarray]]:
    """(which, their totals, the variance of those by the replicates) of some hits at a time."""
    replicates = hits.shape[1]
    step = _SLICE // replicates
    for first in range(0, len(hits), step):
        some = hits[first : first + step].astype(np.float64 if hits.dtype.kind == "f" else np.int64)
        total = some.sum(axis=1)
        squares = np.maximum(replicates * np.square(some).sum(axis=1) - np.square(total), 0)
        yield slice(first, first + step), total, squares / max(1, replicates - 1)


def _independent(total: np.ndarray, rays: int) -> tuple[np.ndarray, np.ndarray]:
    """n F (1 - F), the variance of so many hits of independent rays, and their class: its binary exponent."""
    variance = total * np.maximum(rays - total, 0) / rays
    return variance, np.clip(np.frexp(variance)[1], 0, _CLASSES - 1)
