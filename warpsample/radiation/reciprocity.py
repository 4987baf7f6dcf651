"""Both directions of each pair pooled, and then scaled so that all rows close: A_i F_ij = A_j F_ji."""

import warnings
from typing import TYPE_CHECKING

import numpy as np

from warpsample.radiation.shares import Shares
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
    pairs = _pooled(shares, areas, surfaces.densities)
    lost = areas * (shares.others["outside"][0] + shares.others["behind"][0])
    factors = _factors(pairs.real, areas, lost)
    row = np.repeat(np.arange(len(areas)), np.diff(pairs.indptr))
    scale = factors[row] * factors[pairs.indices]
    less, area = factors**_YIELDING, areas[row]
    others = {name: (less * value, np.square(less) * variance) for name, (value, variance) in shares.others.items()}
    value, variance = pairs.data.real * scale / area, pairs.data.imag * np.square(scale / area)
    return Shares(pairs.indptr, pairs.indices, value, variance, others)


def _pooled(shares: Shares, areas: np.ndarray, densities: np.ndarray) -> "csr_array":
    """A_i F_ij of each pair, weighted by rays per area, as the real parts of a CSR matrix, its variance as the imaginary.

    As two matrices they could lose different entries: SciPy drops zeros when it adds.
    """
    from scipy.sparse import csr_array  # noqa: PLC0415

    row = np.repeat(np.arange(len(areas)), np.diff(shares.indptr))
    hits = (areas * densities)[row]
    data = hits * shares.value + 1j * (np.square(hits) * shares.variance)
    one_way = csr_array((data, shares.indices, shares.indptr), shape=(len(areas), len(areas)))
    pairs = (one_way + one_way.T.tocsr()).tocsr()
    pairs.sort_indices()
    row = np.repeat(np.arange(len(areas)), np.diff(pairs.indptr))
    both = densities[row] + densities[pairs.indices]
    pairs.data = pairs.data.real / both + 1j * (pairs.data.imag / np.square(both))
    return pairs


def _factors(pairs: "csr_array", areas: np.ndarray, lost: np.ndarray) -> np.ndarray:
    """(N,) factors e with e_i (G e)_i + lost_i e_i^0.3 = A_i."""
    logarithms = np.zeros(len(areas))
    there = areas > 0.0
    worst = 0.0
    for _ in range(_MOST_STEPS):
        factors = np.exp(logarithms)
        seen = factors * (pairs @ factors)
        left = lost * factors**_YIELDING
        gap = areas - seen - left
        worst = np.max(np.abs(gap[there]) / areas[there], initial=0.0)
        if worst <= _CLOSED:
            return factors
        logarithms[there] += (gap / np.where(there, 2.0 * seen + _YIELDING * left, 1.0))[there]
    warnings.warn(f"view_factors: rows close to {worst:.1g} only; more rays will help", stacklevel=4)
    return np.exp(logarithms)
