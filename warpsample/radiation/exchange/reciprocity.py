"""Reciprocal view factors: the two estimates of each pair are averaged, then adjusted so that each row adds up to 1."""

from typing import TYPE_CHECKING

import numpy as np

from warpsample.host.locks import imported
from warpsample.radiation.exchange.closure import Closure, closure_of, rows_of
from warpsample.radiation.exchange.error_draws import ErrorDraws
from warpsample.radiation.exchange.row_factors import RowFactors
from warpsample.radiation.exchange.surfaces import Surfaces

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def reciprocal_factors(factors: RowFactors, surfaces: Surfaces) -> RowFactors:
    """Return view factors adjusted so that A_i F_ij = A_j F_ji and each row adds up to 1.

    Among all exchanges that close, the result is nearest to the counts, in the metric of counts of independent rays: each
    pair is adjusted in proportion to its uncertainty. In a flat room the few rays to the low walls determine the exchange of
    walls with floor and ceiling. One factor per row would spoil this exchange with the uncertainty between floor and
    ceiling.

    Warns:
        UserWarning: no exchange closes all rows.
    """
    if not len(factors.indices):
        return factors  # no surface sees another
    areas = surfaces.areas
    pooling = _Pooling(factors, areas, surfaces.densities)
    lost = areas * (factors.others["outside"][0] + factors.others["behind"][0])
    closure = closure_of(pooling.pairs(factors.value), areas, lost, surfaces.densities)
    exchange = closure.exchange
    variance, others = _variances(factors, pooling, closure, areas)
    values = exchange.data / areas[rows_of(exchange.indptr)]
    others = {name: (closure.less * factors.others[name][0], others[name]) for name in factors.others}
    return RowFactors(exchange.indptr, exchange.indices, values, variance, others)


class _Pooling:
    """Averaging of the two estimates A_i F_ij and A_j F_ji of each pair of surfaces, weighted by rays per area."""

    def __init__(self, factors: RowFactors, areas: np.ndarray, densities: np.ndarray) -> None:
        """Index the pairs of surfaces with a view factor in either direction."""
        size, row = len(areas), rows_of(factors.indptr)
        one, other = (a.astype(np.int64) * size + b for a, b in ((row, factors.indices), (factors.indices, row)))
        keys = np.concatenate([one, other])
        keys.sort()
        keys = keys[np.append(True, keys[1:] != keys[:-1])]
        kind = np.int32 if len(keys) < 2**31 else np.int64
        self._here, self._there = (np.searchsorted(keys, pair).astype(kind) for pair in (one, other))
        self._hits = (areas * densities)[row]
        self.rows, self.columns = (keys // size).astype(kind), (keys % size).astype(kind)
        self._indptr = np.searchsorted(keys, np.arange(size + 1, dtype=np.int64) * size).astype(kind)
        self._both = densities[self.rows] + densities[self.columns]

    def pooled(self, value: np.ndarray) -> np.ndarray:
        """Return the average of A_i F_ij and A_j F_ji for each pair of surfaces, from the (E,) view factors."""
        hits = self._hits * value
        sums = np.zeros(len(self._both))
        sums[self._here] = hits
        sums[self._there] += hits
        sums /= self._both
        return sums

    def pairs(self, value: np.ndarray) -> "csr_array":
        """Return the averages of `pooled` as a symmetric sparse matrix, with a row and a column per surface."""
        size = len(self._indptr) - 1
        return imported("scipy.sparse").csr_array((self.pooled(value), self.columns, self._indptr), shape=(size, size))


def _variances(
    factors: RowFactors, pooling: _Pooling, closure: Closure, areas: np.ndarray
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Estimate the variances of reciprocal view factors by propagating random errors through the adjustment.

    Each draw is processed as the factors, to first order: pooled, then adjusted to close the rows again.
    """
    exchange, rows, columns = closure.exchange, pooling.rows, pooling.columns
    draws = ErrorDraws(factors)

    def changed(draw: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        entries, others = draws.draw(draw)
        pairs = pooling.pooled(entries)
        pairs *= closure.scale
        return pairs, others

    gaps = np.empty((len(areas), draws.number))
    for draw in range(draws.number):
        entries, others = changed(draw)
        lost = areas * closure.less * (others["outside"] + others["behind"])
        gaps[:, draw] = -np.bincount(rows, entries, len(areas)) - lost
        del entries
    shifts = closure.step(gaps)
    variance, of_others = np.zeros(len(rows)), {name: np.zeros(len(areas)) for name in factors.others}
    slopes = exchange.data * closure.give
    for draw in range(draws.number):
        entries, others = changed(draw)
        shift = shifts[:, draw]
        give = shift[rows]  # in place from here on: arrays of pairs take most memory
        give += shift[columns]
        give *= slopes
        entries += give
        entries /= areas[rows]
        variance += np.square(entries, out=entries) / draws.number
        del entries, give  # frees memory before the next draw
        for name, change in others.items():
            adjusted = closure.less * (change + closure.yields * factors.others[name][0] * shift)
            of_others[name] += np.square(adjusted) / draws.number
    return variance, of_others
