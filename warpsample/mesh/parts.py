"""Named parts of a mesh, such as the objects of a file: the part of each face, and the parts' names."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.locks import read_only
from warpsample.host.neighbours import as_ndarray

Named = tuple[np.ndarray, np.ndarray, np.ndarray | None, Sequence[str]]
"""Vertices, faces, the part of each face, and the names of the parts; without parts the last two are (None, ())."""


def named_parts(counts: Iterable[int], names: Sequence[str]) -> tuple[np.ndarray | None, Sequence[str]]:
    """Return the (F,) int32 part of each face for consecutive parts with `counts` faces, and the names of the parts.

    Returns (None, ()) if all names are empty.
    """
    if not any(names):
        return None, ()
    return np.repeat(np.arange(len(names), dtype=np.int32), list(counts)), names


def check_names(names: Any) -> tuple[str, ...]:
    """Return the names of parts as a tuple of strings; raise a TypeError for anything but a sequence of strings."""
    made = tuple(names) if isinstance(names, Sequence) and not isinstance(names, str) else (None,)
    if not all(isinstance(name, str) for name in made):
        raise TypeError(f"parts: got {quote(names)}, want a sequence of names")
    return made


def check_part(part: Any, faces: int, names: int) -> np.ndarray:
    """Return a read-only int32 copy of the (F,) part numbers, from -1 to `names` - 1.

    Raises:
        TypeError: Numbers that are not integers.
        ValueError: A wrong shape, or a number outside -1 to `names` - 1.
    """
    wants = f"({faces},) whole numbers from -1 to {names - 1}, one for each face"
    array = as_ndarray(part, "part", wants)
    if array.dtype.kind not in "iu":
        raise TypeError(f"part: got {f'dtype {array.dtype}' if array.ndim else quote(part)}, want {wants}")
    if array.shape != (faces,):
        raise ValueError(f"part: got shape {array.shape}, want {wants}")
    if array.min() < -1 or array.max() >= names:
        raise ValueError(f"part: got numbers from {array.min()} to {array.max()}, want {wants}")
    return read_only(array.astype(np.int32, copy=False))
