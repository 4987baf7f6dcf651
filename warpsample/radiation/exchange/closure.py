"""Adjustment of reciprocal view factors so that the factors of each surface add up to 1."""

import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.host.locks import imported

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_CLOSED = 1e-8  # relative to a row's area; the documented closure is 1e-7
_MOST_STEPS, _MOST_PRODUCTS = 40, 200
_YIELDING = (
    0.3  # exponent of a loss relative to pairs: the share of rays that hit nothing is known better than a pair's share
)
_DAMPING = 1e-12  # relative to the diagonal, so that rows that cannot close do not divide by 0


def rows_of(indptr: np.ndarray) -> np.ndarray:
    """Return the row number of each stored entry of a sparse CSR matrix, (E,) int32."""
    return np.repeat(np.arange(len(indptr) - 1, dtype=np.int32), np.diff(indptr))


@dataclass(frozen=True, eq=False)
class Closure:
    """Exchanged radiation of all pairs of surfaces, scaled so that each surface's shares add up to 1, with derivatives.

    Pair (i, j) is multiplied by exp(2 (u_i + u_j) / (q_i + q_j)), the loss of row i by exp(0.3 u_i / q_i); q is the row's
    ray density.

    Attributes:
        exchange: (N, N) symmetric matrix A_i F_ij, closed.
        scale: (E,) factor of each entry.
        give: (E,) derivative of the logarithm of each entry with respect to u_i + u_j.
        lost: (N,) area lost by each row before scaling: outside and behind.
        less: (N,) factor of `lost`.
        yields: (N,) derivative of the logarithm of the loss with respect to u_i.
    """

    exchange: "csr_array"
    scale: np.ndarray
    give: np.ndarray
    lost: np.ndarray
    less: np.ndarray
    yields: np.ndarray

    def step(self, gap: np.ndarray) -> np.ndarray:
        """Return how to change the scale parameters u so that the row sums increase by `gap`: one Newton step."""
        slopes = self.exchange.copy()
        slopes.data *= self.give
        diagonal = slopes.sum(axis=1) + self.yields * self.lost * self.less
        return _conjugate(slopes, np.where(diagonal > 0.0, diagonal, 1.0), gap)


def closure_of(pairs: "csr_array", areas: np.ndarray, lost: np.ndarray, densities: np.ndarray) -> Closure:
    """Scale the radiation exchanged by pairs of surfaces, an (N, N) matrix, so that each row adds up to the surface's area.

    The u with which all rows close minimises a convex function. It is found by Newton steps that change no factor by more
    than e.

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
    warnings.warn(f"view_factors: rows add up to 1 only within {worst:.1g}; pass a larger count of rays", stacklevel=5)
    return best


def _conjugate(matrix: "csr_array", diagonal: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solve (matrix + diagonal) x = right for x to five digits, by conjugate gradients.

    Sums do not depend on the number of threads. The columns of `right` are solved separately, until all have converged.
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
