"""Both directions of each pair pooled, and then adjusted so that all rows close: A_i F_ij = A_j F_ji."""

import warnings
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from warpsample.radiation.row_shares import Shares
from warpsample.radiation.surfaces import Surfaces

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_CLOSED = 1e-8  # of a row's area, where 1e-7 is promised
_MOST_STEPS, _MOST_PRODUCTS = 40, 200
_YIELDING = 0.3  # by which power of a row's factor what it loses gives way: what meets nothing is known better than a pair
_BESIDES = {"outside": ("behind",), "behind": ("outside",), "sky": ("ground", "behind"), "ground": ("sky", "behind")}
_DAMPING = 1e-12  # of the diagonal, so that what cannot close divides by nothing that is 0


def reciprocal_shares(shares: Shares, surfaces: Surfaces) -> Shares:
    """The shares made reciprocal and closed.

    Of all exchanges that close, those that are nearest to what was counted, as counts of independent rays differ: each pair
    gives way by as much as its rays left it open. In a flat room the few rays to its low walls settle what these exchange
    with floor and ceiling; one factor for each row would spoil that by what is unsure between floor and ceiling.

    Warns:
        UserWarning: no exchange closes all rows.
    """
    areas = surfaces.areas
    pairs, variance = _pooled(shares, areas, surfaces.densities)
    lost = areas * (shares.others["outside"][0] + shares.others["behind"][0])
    scale, less = _factors(pairs, areas, lost, surfaces.densities)
    area = areas[_rows(pairs.indptr)]
    found = Shares(pairs.indptr, pairs.indices, pairs.data * scale / area, variance * np.square(scale / area), {})
    return replace(found, others=_others(shares, found, lost / np.where(areas > 0.0, areas, 1.0), less, surfaces.densities))


def _rows(indptr: np.ndarray) -> np.ndarray:
    """(E,) int32, the row of each entry."""
    return np.repeat(np.arange(len(indptr) - 1, dtype=np.int32), np.diff(indptr))


def _pooled(shares: Shares, areas: np.ndarray, densities: np.ndarray) -> tuple["csr_array", np.ndarray]:
    """A_i F_ij of each pair, from both its sides weighted by rays per area; and its variance."""
    from scipy.sparse import csr_array  # noqa: PLC0415

    size = (len(areas), len(areas))
    hits = (areas * densities)[_rows(shares.indptr)]
    # As two matrices they could lose different entries: SciPy drops zeros when it adds.
    data = np.empty(len(hits), np.complex128)
    data.real, data.imag = hits * shares.value, np.square(hits) * shares.variance
    del hits
    there = csr_array((data, shares.indices, shares.indptr.astype(np.int32 if len(data) < 2**31 else np.int64)), shape=size)
    sums = there + there.T.tocsr()
    del there, data
    sums.sort_indices()
    both = densities[_rows(sums.indptr)] + densities[sums.indices]
    return csr_array((sums.data.real / both, sums.indices, sums.indptr), shape=size), sums.data.imag / np.square(both)


def _factors(
    pairs: "csr_array", areas: np.ndarray, lost: np.ndarray, densities: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Factors of the entries and of what rows lose: exp(2 (u_i + u_j) / (q_i + q_j)) and exp(0.3 u_i / q_i).

    The u by which all rows close are the least of a convex function; found by Newton's steps, none of them over a factor e.
    """
    from scipy.sparse import csr_array  # noqa: PLC0415

    row, there = _rows(pairs.indptr), areas > 0.0
    own = np.where(densities > 0.0, densities, 1.0)
    give = 2.0 / (own[row] + own[pairs.indices])
    shifts, worst, best = np.zeros(len(areas)), np.inf, (give, own)
    for _ in range(_MOST_STEPS):
        scale, less = np.exp(give * (shifts[row] + shifts[pairs.indices])), np.exp(_YIELDING / own * shifts)
        exchange = csr_array((pairs.data * scale, pairs.indices, pairs.indptr), shape=pairs.shape)
        gap = np.where(there, areas - exchange.sum(axis=1) - lost * less, 0.0)
        apart = np.max(np.abs(gap[there]) / areas[there], initial=0.0)
        if apart < worst:
            worst, best = apart, (scale, less)
        if apart <= _CLOSED:
            return best
        exchange.data *= give
        diagonal = exchange.sum(axis=1) + _YIELDING / own * lost * less
        step = _conjugate(exchange, np.where(diagonal > 0.0, diagonal, 1.0), gap)
        shifts += step / max(1.0, np.max(np.abs(step) / own))
    warnings.warn(f"view_factors: rows close to {worst:.1g} only; more rays will help", stacklevel=5)
    return best


def _others(
    shares: Shares, pooled: Shares, lost: np.ndarray, less: np.ndarray, densities: np.ndarray
) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """What rows lose, (N,) share `lost`, times its factors `less`; and its variance.

    What takes most of its row's gap has the error of all else, pooled. Elsewhere errors are added as if they had one sign,
    but not beyond that of its own rays: the sum over the pairs forgets that a hit that one of them gains another loses.
    """
    row, own = _rows(pooled.indptr), np.where(densities > 0.0, densities, 1.0)
    gives = np.bincount(row, pooled.value * 2.0 / (own[row] + own[pooled.indices]), len(own))
    takes = _YIELDING / own * lost * less
    of_gap = takes / np.where(gives + takes > 0.0, gives + takes, 1.0) / np.where(lost > 0.0, lost, 1.0)
    pairs = np.sqrt(np.bincount(row, pooled.variance, len(own)))
    errors = {name: less * np.sqrt(variance) for name, (_, variance) in shares.others.items()}
    found = {}
    for name, error in errors.items():
        value = shares.others[name][0]
        part = of_gap * value
        adjusted = (1.0 - part) * error + part * (pairs + sum(errors[other] for other in _BESIDES[name]))
        found[name] = less * value, np.square(np.where(part > 0.5, adjusted, np.minimum(error, adjusted)))
    return found


def _conjugate(matrix: "csr_array", diagonal: np.ndarray, right: np.ndarray) -> np.ndarray:
    """x with (matrix + diagonal) x = right, to five digits, by conjugate gradients whose sums depend on no threads."""
    x, rest = np.zeros(len(right)), right
    way = right / diagonal
    size = first = (rest * way).sum()
    for _ in range(_MOST_PRODUCTS):
        if size <= 1e-10 * first:
            break
        product = matrix @ way + (1.0 + _DAMPING) * diagonal * way
        length = size / (way * product).sum()
        x, rest = x + length * way, rest - length * product
        before, size = size, (rest * rest / diagonal).sum()
        way = rest / diagonal + size / before * way
    return x
