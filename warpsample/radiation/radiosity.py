"""Radiation that is reflected again and again between faces: J = E + rho F J."""

from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.arrays import as_real

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_PRECISION = 1e-12
_ROUNDING = 1e-15
_MOST_STEPS = 20_000


def radiosity_of(matrix: "csr_array", emission: Any, reflectance: Any) -> np.ndarray:
    """The fixed point of J = E + rho F J; see `ViewFactors.radiosity`."""
    rows = matrix.shape[0]
    emitted = _finite(emission, "emission")
    if emitted.ndim not in (0, 1, 2) or (emitted.ndim and len(emitted) != rows):
        raise ValueError(f"emission: got shape {emitted.shape}, want ({rows},) or ({rows}, k), a row for each of the matrix")
    reflected = _finite(reflectance, "reflectance")
    if reflected.ndim and reflected.shape != (rows,):
        raise ValueError(f"reflectance: got shape {reflected.shape}, want one number or ({rows},)")
    if reflected.size and not (reflected.min() >= 0.0 and reflected.max() <= 1.0):
        raise ValueError(f"reflectance: got values from {reflected.min():g} to {reflected.max():g}, want 0 to 1")
    share = np.broadcast_to(reflected, (rows,))
    least = np.broadcast_to(emitted, (rows, *emitted.shape[1:])) if emitted.ndim == 0 else emitted
    return _fixed_point(matrix, np.array(least), share)


def _fixed_point(matrix: "csr_array", emitted: np.ndarray, share: np.ndarray) -> np.ndarray:
    column = share.reshape(-1, *(1,) * (emitted.ndim - 1))
    kept = float(np.max(share * matrix.sum(axis=1), initial=0.0))  # of what is under way, from one step to the next
    close = max(_PRECISION * (1.0 - kept), _ROUNDING)
    leaving = emitted
    for _ in range(_MOST_STEPS):
        before, leaving = leaving, emitted + column * (matrix @ leaving)
        if np.max(np.abs(leaving - before), initial=0.0) <= close * np.max(np.abs(leaving), initial=0.0):
            return leaving
    raise ValueError(
        f"reflectance: got up to {share.max():g}, by which {kept:.6g} of the radiation comes back each time; want less"
    )


def _finite(value: Any, argument: str) -> np.ndarray:
    array = as_real(value, argument).astype(np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"{argument}: got {told(value)}, want finite numbers")
    return array
