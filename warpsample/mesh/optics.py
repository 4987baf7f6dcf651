"""Optical properties of a mesh's faces: how much of the light that falls on one goes through, and how much comes back."""

from typing import Any

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.arrays import as_real
from warpsample.host.known import digest_of
from warpsample.host.locks import read_only

_ROUNDED = 2.0**-22  # of a sum of two shares that were float32 once


def check_share(value: Any, argument: str, faces: int) -> np.ndarray | None:
    """(F,) float32, a read-only copy, of a share from 0 to 1 for all faces, or one for each; None for None.

    Raises:
        TypeError, ValueError: not such shares; names the argument.
    """
    if value is None:
        return None
    wants = f"a number from 0 to 1, or ({faces},) of them, one for each face"
    share = as_real(value, argument, wants)
    if share.shape not in ((), (faces,)):
        raise ValueError(f"{argument}: got shape {share.shape}, want {wants}")
    wrong = np.flatnonzero(~((share >= 0.0) & (share <= 1.0)))
    if len(wrong):
        where = f" in face {wrong[0]}" if share.ndim else ""
        raise ValueError(f"{argument}: got {told(float(share.flat[wrong[0]]))}{where}, want {wants}")
    return read_only(np.broadcast_to(share.astype(np.float32), (faces,)))


def check_sum(transmittance: np.ndarray | None, reflectance: np.ndarray | None) -> None:
    """Refuses faces that give more light than they get: a ValueError names the first."""
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
    """A digest of a mesh with its optical properties; that which is given, if it has none."""
    if transmittance is None and reflectance is None:
        return digest
    nothing = np.zeros(0, np.float32)
    known = [nothing if array is None else array for array in (transmittance, reflectance)]
    return digest_of(np.frombuffer(digest.encode(), np.uint8), *known)
