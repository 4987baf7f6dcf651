"""Named parts of a mesh: which of its faces belong together, as the file had it."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.locks import read_only
from warpsample.host.neighbours import as_ndarray

Named = tuple[np.ndarray, np.ndarray, np.ndarray | None, Sequence[str]]
"""Vertices and faces, with the part of each face and the names of the parts: (None, ()) if they have none."""


def named_parts(counts: Iterable[int], names: Sequence[str]) -> tuple[np.ndarray | None, Sequence[str]]:
    """(F,) int32 and the names of parts that have so many faces, one after the other; (None, ()) if no part has a name."""
    if not any(names):
        return None, ()
    return np.repeat(np.arange(len(names), dtype=np.int32), list(counts)), names


def check_names(names: Any) -> tuple[str, ...]:
    """The names of parts as a tuple; a TypeError for what is no sequence of texts."""
    made = tuple(names) if isinstance(names, Sequence) and not isinstance(names, str) else (None,)
    if not all(isinstance(name, str) for name in made):
        raise TypeError(f"parts: got {told(names)}, want a sequence of names")
    return made


def check_part(part: Any, faces: int, names: int) -> np.ndarray:
    """(F,) int32, a read-only copy, of numbers from -1 to the last name's."""
    wants = f"({faces},) whole numbers from -1 to {names - 1}, one for each face"
    array = as_ndarray(part, "part", wants)
    if array.dtype.kind not in "iu":
        raise TypeError(f"part: got {f'dtype {array.dtype}' if array.ndim else told(part)}, want {wants}")
    if array.shape != (faces,):
        raise ValueError(f"part: got shape {array.shape}, want {wants}")
    if array.min() < -1 or array.max() >= names:
        raise ValueError(f"part: got numbers from {array.min()} to {array.max()}, want {wants}")
    return read_only(array.astype(np.int32, copy=False))
