"""Reuse of equal meshes within a process: unpickled meshes with equal content share one object and one ray-tracing tree."""

import hashlib
from collections import deque
from collections.abc import Callable
from typing import Any
from weakref import WeakValueDictionary

import numpy as np

from warpsample.host.locks import making

_KEPT = 4  # created values that are kept alive between tasks

_known: WeakValueDictionary[str, Any] = WeakValueDictionary()
_arrived: deque[Any] = deque(maxlen=_KEPT)


def digest_of(*arrays: np.ndarray) -> str:
    """Return the SHA-256 of the types, shapes and numbers of arrays, in hexadecimal digits."""
    found = hashlib.sha256()
    for array in arrays:
        found.update(f"{array.dtype.str}{array.shape}".encode())
        found.update(np.ascontiguousarray(array).data)
    return found.hexdigest()


def remember(digest: str, value: Any) -> None:
    """Register `value` under its digest while the value exists, for `find_or_make` in this process and in forked ones."""
    with making:
        _known.setdefault(digest, value)


def arrived(digest: str, make: Callable[..., Any], *content: Any) -> Any:
    """Return the value registered under `digest`; if there is none, create and register `make(*content)`.

    The last few created values are kept alive. Dask sends a mesh anew with each task; without this, each task would build a
    tree.
    """
    with making:
        value = _known.get(digest)
        if value is None:
            value = _known[digest] = make(*content)
            _arrived.append(value)
        return value
