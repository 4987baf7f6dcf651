"""Radiation that is reflected again and again between faces: J = E + rho F J."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.arrays import as_real
from warpsample.host.locks import imported

if TYPE_CHECKING:
    from scipy.sparse import csr_array

    from warpsample.radiation.exchange.result import ViewFactors

_PRECISION = 1e-12
_EXACT, _ROUNDING = 1e-15, 1e-13  # of the largest: what sums of few and of many numbers come to
_STEPS = 300  # of following the radiation, before equations are solved: enough where a tenth is absorbed each time
_ROUNDS, _PRODUCTS = 20, 40
_MOST_TIMES = 1e9  # what is emitted, where hardly anything is ever absorbed


def radiosity_of(factors: "ViewFactors", emission: Any, reflectance: Any) -> np.ndarray:
    """The solution of J = E + rho F J; see `ViewFactors.radiosity`."""
    rows = len(factors.areas)
    emitted = _finite(emission, "emission")
    if emitted.ndim not in (0, 1, 2) or (emitted.ndim and len(emitted) != rows):
        raise ValueError(f"emission: got shape {emitted.shape}, want ({rows},) or ({rows}, k), a row for each of the matrix")
    reflected = _finite(reflectance, "reflectance")
    if reflected.ndim and reflected.shape != (rows,):
        raise ValueError(f"reflectance: got shape {reflected.shape}, want one number or ({rows},)")
    if reflected.size and not (reflected.min() >= 0.0 and reflected.max() <= 1.0):
        raise ValueError(f"reflectance: got values from {reflected.min():g} to {reflected.max():g}, want 0 to 1")
    check_rows(factors)
    share = np.broadcast_to(reflected, (rows,))
    columns = np.broadcast_to(emitted, (rows,)) if emitted.ndim == 0 else emitted
    with np.errstate(over="ignore"):
        leaving = followed(factors.matrix, columns.reshape(rows, math.prod(columns.shape[1:])), share)
    if not np.isfinite(leaving).all():
        raise ValueError(f"emission: got {told(emission)}, which adds up to more than a float64 holds")
    return leaving.reshape(columns.shape)


def check_rows(factors: "ViewFactors") -> None:
    """Refuses rows that were left out: to take them for black, or for open to the sky, would be wrong.

    Raises:
        ValueError: rows without a ray of surfaces with area.
    """
    absorbed = 0.0 if factors.absorbed is None else factors.absorbed
    left_out = (factors.areas > 0.0) & (factors.matrix.sum(axis=1) + factors.outside + factors.behind + absorbed == 0.0)
    if left_out.any():
        raise ValueError(f"active: got {np.count_nonzero(left_out)} rows that were left out, want those of all faces")


def followed(matrix: "csr_array", emitted: np.ndarray, share: np.ndarray) -> np.ndarray:
    """(N, k), J = emitted + share F J, by following the radiation of each column; and by equations where that takes long.

    Raises:
        ValueError: shares by which nothing is ever lost.
    """
    kept = float(np.max(share * matrix.sum(axis=1), initial=0.0))  # of what is under way, from one step to the next
    close = max(_PRECISION * (1.0 - kept), _EXACT)
    scale = np.max(np.abs(emitted), axis=0, initial=0.0)
    emitted = np.divide(emitted, scale, out=np.zeros_like(emitted), where=scale > 0.0)
    leaving, before = emitted, np.inf
    for step in range(_STEPS + _ROUNDS):
        lacking = emitted + share[:, None] * (matrix @ leaving) - leaving
        largest = np.maximum(np.max(np.abs(leaving), axis=0, initial=0.0), 1.0)
        apart = np.max(np.max(np.abs(lacking), axis=0, initial=0.0) / largest, initial=0.0)
        if largest.max(initial=1.0) > _MOST_TIMES:
            break
        if apart <= close or (0.5 * before < apart <= _ROUNDING and step > _STEPS):
            return scale * (leaving + lacking)
        leaving, before = leaving + (lacking if step < _STEPS else _corrections(matrix, lacking, share)), apart
    raise ValueError(
        f"reflectance: got up to {share.max():g}, by which {kept:.6g} of the radiation comes back each time; want less"
    )


def _corrections(matrix: "csr_array", lacking: np.ndarray, share: np.ndarray) -> np.ndarray:
    """(N, k), what to add to each column, to some digits."""
    linear = imported("scipy.sparse.linalg")
    operator, gmres = linear.LinearOperator, linear.gmres
    equations = operator(matrix.shape, matvec=lambda leaving: leaving - share * (matrix @ leaving), dtype=np.float64)
    return np.stack([gmres(equations, column, restart=_PRODUCTS, maxiter=1, atol=0.0)[0] for column in lacking.T], axis=1)


def _finite(value: Any, argument: str) -> np.ndarray:
    array = as_real(value, argument).astype(np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"{argument}: got {told(value)}, want finite numbers")
    return array
