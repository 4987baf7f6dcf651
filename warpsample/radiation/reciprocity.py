"""Both directions of each pair pooled, and then scaled so that all rows close: A_i F_ij = A_j F_ji."""

import warnings
from typing import TYPE_CHECKING

import numpy as np

from warpsample.radiation.row_shares import Shares
from warpsample.radiation.surfaces import Surfaces

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_CLOSED = 1e-8  # of a row's area, where 1e-7 is promised
_MOST_STEPS = 500
_YIELDING = 0.3  # by which power of a row's factor what it loses gives way: what meets nothing is known better than a pair


def reciprocal_shares(shares: Shares, surfaces: Surfaces) -> Shares:
    """The shares made reciprocal and closed.

    Warns:
        UserWarning: no scaling closes all rows.
    """
    areas = surfaces.areas
    pairs, variance = _pooled(shares, areas, surfaces.densities)
    lost = areas * (shares.others["outside"][0] + shares.others["behind"][0])
    factors = _factors(pairs, areas, lost)
    row = _rows(pairs.indptr)
    scale = factors[row] * factors[pairs.indices]
    less, area = np.float_power(factors, _YIELDING), areas[row]
    others = {name: (less * value, np.square(less) * error) for name, (value, error) in shares.others.items()}
    return Shares(pairs.indptr, pairs.indices, pairs.data * scale / area, variance * np.square(scale / area), others)


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


def _factors(pairs: "csr_array", areas: np.ndarray, lost: np.ndarray) -> np.ndarray:
    """(N,) factors e with e_i (G e)_i + lost_i e_i^0.3 = A_i."""
    logarithms = np.zeros(len(areas))
    there = areas > 0.0
    worst = 0.0
    for _ in range(_MOST_STEPS):
        factors = np.exp(logarithms)
        seen = factors * (pairs @ factors)
        left = lost * np.float_power(factors, _YIELDING)
        gap = areas - seen - left
        worst = np.max(np.abs(gap[there]) / areas[there], initial=0.0)
        if worst <= _CLOSED:
            return factors
        logarithms[there] += (gap / np.where(there, 2.0 * seen + _YIELDING * left, 1.0))[there]
    warnings.warn(f"view_factors: rows close to {worst:.1g} only; more rays will help", stacklevel=4)
    return np.exp(logarithms)
