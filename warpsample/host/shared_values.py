"""Cache of values by content hash, so that a process that receives the same mesh twice keeps only one copy."""

import hashlib
from collections import deque
from collections.abc import Callable
from typing import Any
from weakref import WeakValueDictionary

import numpy as np

from warpsample.host.locks import making

_KEPT = 4  # number of received values that are kept between tasks

HEIGHTS_OF = "_heights"
"""Suffix of the attribute of a stored run that has the hash of a raster's heights; the rest is the raster's argument."""

_values: WeakValueDictionary[str, Any] = WeakValueDictionary()
_received: deque[Any] = deque(maxlen=_KEPT)


def digest_of(*arrays: np.ndarray) -> str:
    """Return a SHA-256 hash of arrays (types, shapes and numbers), in hexadecimal digits."""
    found = hashlib.sha256()
    for array in arrays:
        found.update(f"{array.dtype.str}{array.shape}".encode())
        found.update(np.ascontiguousarray(array).data)
    return found.hexdigest()


def remember(digest: str, value: Any) -> None:
    """Register a value under a hash, so that `find_or_make` finds the value as long as it exists."""
    with making:
        _values.setdefault(digest, value)


def find_or_make(digest: str, make: Callable[..., Any], *content: Any) -> Any:
    """Return the value registered under a hash, or create and register `make(*content)`.

    The last few new values are kept: Dask sends a mesh with each task, and each time a tree would be built.
    """
    with making:
        value = _values.get(digest)
        if value is None:
            value = _values[digest] = make(*content)
            _received.append(value)
        return value


def describe_remedy(name: str) -> str:
    """Describe, for an error message, what to do if a stored run has another value of the attribute `name`."""
    if name.endswith(HEIGHTS_OF):
        raster = name.removesuffix(HEIGHTS_OF)
        return f"the heights of the raster {raster!r} have changed since that run: restore its file, or use a new name"
    return "repeat the arguments of that run, or use a new name"
