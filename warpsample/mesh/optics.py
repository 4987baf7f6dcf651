"""Checks and hashes of the optical properties of faces: the fractions of light that a face transmits and reflects."""

from typing import Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.host.locks import read_only
from warpsample.host.shared_values import digest_of

_ROUNDED = 2.0**-22  # rounding error of a sum of two float32 fractions


def check_share(value: Any, argument: str, faces: int) -> np.ndarray | None:
    """Return a read-only (F,) float32 copy of fractions from 0 to 1, given as one number or one per face; None for None.

    Raises:
        TypeError, ValueError: Values that are not numbers from 0 to 1, or a wrong shape; the message names the argument.
    """
    if value is None:
        return None
    wants = f"a number from 0 to 1, or ({faces},) numbers, one for each face"
    share = as_real(value, argument, wants)
    if share.shape not in ((), (faces,)):
        raise ValueError(f"{argument}: got shape {share.shape}, want {wants}")
    wrong = np.flatnonzero(~((share >= 0.0) & (share <= 1.0)))
    if len(wrong):
        where = f" in face {wrong[0]}" if share.ndim else ""
        raise ValueError(f"{argument}: got {quote(float(share.flat[wrong[0]]))}{where}, want {wants}")
    return read_only(np.broadcast_to(share.astype(np.float32), (faces,)))


def check_sum(transmittance: np.ndarray | None, reflectance: np.ndarray | None) -> None:
    """Raise a ValueError that names the first face whose transmittance and reflectance add up to more than 1."""
    if transmittance is None or reflectance is None:
        return
    total = transmittance.astype(np.float64) + reflectance
    if total.max() > 1.0 + _ROUNDED:
        face = int(np.argmax(total > 1.0 + _ROUNDED))
        raise ValueError(
            f"reflectance: got {reflectance[face]:g} in face {face}, whose transmittance is {transmittance[face]:g}, "
            "want a sum of at most 1"
        )


def optics_digest(digest: str, transmittance: np.ndarray | None, reflectance: np.ndarray | None) -> str:
    """Return a hash of a mesh with optical properties, from the hash `digest` of its vertices and faces."""
    if transmittance is None and reflectance is None:
        return digest
    nothing = np.zeros(0, np.float32)
    known = [nothing if array is None else array for array in (transmittance, reflectance)]
    return digest_of(np.frombuffer(digest.encode(), np.uint8), *known)
