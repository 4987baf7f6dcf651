"""Radiosity of faces that reflect repeatedly: the solution of J = E + rho F J."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.host.locks import algebra, imported

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_PRECISION = 1e-12
_EXACT, _ROUNDING = 1e-15, 1e-13  # relative to the largest: rounding of sums of few and of many numbers
_STEPS = 300  # reflections followed before equations are solved: enough if a tenth is absorbed each time
_ROUNDS, _PRODUCTS = 20, 40
_MOST_TIMES = 1e9  # largest radiosity relative to the emission, else hardly anything is ever absorbed


def radiosity_of(matrix: "csr_array", emission: Any, reflectance: Any) -> np.ndarray:
    """Compute the radiosity of each surface: solve J = E + rho F J for the view factors F.

    See `ViewFactors.radiosity`.
    """
    rows = matrix.shape[0]
    emitted = _check_finite(emission, "emission")
    if emitted.ndim not in (0, 1, 2) or (emitted.ndim and len(emitted) != rows):
        raise ValueError(f"emission: got shape {emitted.shape}, want ({rows},), or ({rows}, k), a row for each surface")
    reflected = _check_finite(reflectance, "reflectance")
    if reflected.ndim and reflected.shape != (rows,):
        raise ValueError(
            f"reflectance: got shape {reflected.shape}, want one number, or ({rows},), a number for each surface"
        )
    if reflected.size and not (reflected.min() >= 0.0 and reflected.max() <= 1.0):
        raise ValueError(f"reflectance: got values from {reflected.min():g} to {reflected.max():g}, want 0 to 1")
    share = np.broadcast_to(reflected, (rows,))
    columns = np.broadcast_to(emitted, (rows,)) if emitted.ndim == 0 else emitted
    with np.errstate(over="ignore"):
        leaving = followed(matrix, columns.reshape(rows, math.prod(columns.shape[1:])), share)
    if not np.isfinite(leaving).all():
        raise ValueError(
            f"emission: got {quote(emission)}, want smaller numbers: the sum of all reflections exceeds the range of float64"
        )
    return leaving.reshape(columns.shape)


def followed(matrix: "csr_array", emitted: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Solve J = emitted + share F J for the (N, k) radiosity J, by adding one reflection after the other.

    Where that converges slowly, corrections come from solved equations.

    Raises:
        ValueError: reflectances with which almost nothing is ever lost.
    """
    kept = float(
        np.max(share * matrix.sum(axis=1), initial=0.0)
    )  # largest share that is reflected onto other faces at each step
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
        leaving, before = leaving + (lacking if step < _STEPS else _solve_corrections(matrix, lacking, share)), apart
    raise ValueError(
        f"reflectance: got up to {share.max():g}, with which {kept:.6g} of the radiation remains after each reflection, "
        "want a smaller reflectance, so that reflections die out"
    )


def _solve_corrections(matrix: "csr_array", lacking: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Return the (N, k) radiosity that is still missing after several reflections, to a few digits, by GMRES."""
    linear = imported("scipy.sparse.linalg")
    operator, gmres = linear.LinearOperator, linear.gmres
    equations = operator(matrix.shape, matvec=lambda leaving: leaving - share * (matrix @ leaving), dtype=np.float64)
    with algebra:
        return np.stack(
            [gmres(equations, column, restart=_PRODUCTS, maxiter=1, atol=0.0)[0] for column in lacking.T], axis=1
        )


def _check_finite(value: Any, argument: str) -> np.ndarray:
    """Return `value` as a float64 array; raise a ValueError if a number is not finite."""
    array = as_real(value, argument).astype(np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"{argument}: got {quote(value)}, want finite numbers")
    return array
