"""The exchange that closes: what was counted of each pair, times factors by which all rows add up to their areas."""

import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.host.locks import imported

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_CLOSED = 1e-8  # of a row's area, where 1e-7 is promised
_MOST_STEPS, _MOST_PRODUCTS = 40, 200
_YIELDING = 0.3  # by which power of a row's factor what it loses gives way: what meets nothing is known better than a pair
_DAMPING = 1e-12  # of the diagonal, so that what cannot close divides by nothing that is 0


def rows_of(indptr: np.ndarray) -> np.ndarray:
    """(E,) int32, the row of each entry."""
    return np.repeat(np.arange(len(indptr) - 1, dtype=np.int32), np.diff(indptr))


@dataclass(frozen=True, eq=False)
class Closure:
    """Pairs and what rows lose, times exp(2 (u_i + u_j) / (q_i + q_j)) and exp(0.3 u_i / q_i), in linear order about u.

    Attributes:
        exchange: (N, N) symmetric, A_i F_ij, closed.
        scale: (E,) of its entries, by what the counted ones were multiplied.
        give: (E,) by which share each changes with u_i + u_j.
        lost: (N,) area that what was counted as lost stands for.
        less: (N,) by what it was multiplied.
        yields: (N,) by which share the product changes with u_i.
    """

    exchange: "csr_array"
    scale: np.ndarray
    give: np.ndarray
    lost: np.ndarray
    less: np.ndarray
    yields: np.ndarray

    def step(self, gap: np.ndarray) -> np.ndarray:
        """How much u changes, (N,) or (N, k), so that rows take up as much more."""
        slopes = self.exchange.copy()
        slopes.data *= self.give
        diagonal = slopes.sum(axis=1) + self.yields * self.lost * self.less
        return _conjugate(slopes, np.where(diagonal > 0.0, diagonal, 1.0), gap)


def closure_of(pairs: "csr_array", areas: np.ndarray, lost: np.ndarray, densities: np.ndarray) -> Closure:
    """Closes pairs (N, N), with the area that each row loses.

    The u by which all rows close are the least of a convex function; found by Newton's steps, none of them over a factor e.

    Warns:
        UserWarning: no u closes all rows.
    """
    csr_array = imported("scipy.sparse").csr_array
    row, there = rows_of(pairs.indptr), areas > 0.0
    own = np.where(densities > 0.0, densities, 1.0)
    give = 2.0 / (own[row] + own[pairs.indices])
    shifts, worst, best = np.zeros(len(areas)), np.inf, None
    for _ in range(_MOST_STEPS):
        scale, less = np.exp(give * (shifts[row] + shifts[pairs.indices])), np.exp(_YIELDING / own * shifts)
        exchange = csr_array((pairs.data * scale, pairs.indices, pairs.indptr), shape=pairs.shape)
        found = Closure(exchange, scale, give, lost, less, _YIELDING / own)
        gap = np.where(there, areas - exchange.sum(axis=1) - lost * less, 0.0)
        apart = np.max(np.abs(gap[there]) / areas[there], initial=0.0)
        if apart < worst or best is None:
            worst, best = apart, found
        if apart <= _CLOSED:
            return best
        step = found.step(gap)
        shifts += step / max(1.0, np.max(np.abs(step) / own))
    warnings.warn(f"view_factors: rows close to {worst:.1g} only; more rays will help", stacklevel=5)
    return best


def _conjugate(matrix: "csr_array", diagonal: np.ndarray, right: np.ndarray) -> np.ndarray:
    """x with (matrix + diagonal) x = right, to five digits, by conjugate gradients whose sums depend on no threads.

    Of several columns each by itself, until all are there.
    """
    diagonal = diagonal.reshape(-1, *[1] * (right.ndim - 1))
    x, rest = np.zeros(right.shape), right
    way = right / diagonal
    size = first = (rest * way).sum(axis=0)
    for _ in range(_MOST_PRODUCTS):
        if np.all(size <= 1e-10 * first):
            break
        product = matrix @ way + (1.0 + _DAMPING) * diagonal * way
        along = (way * product).sum(axis=0)
        length = size / np.where(along > 0.0, along, 1.0)
        x, rest = x + length * way, rest - length * product
        before, size = size, (rest * rest / diagonal).sum(axis=0)
        way = rest / diagonal + size / np.where(before > 0.0, before, 1.0) * way
    return x
