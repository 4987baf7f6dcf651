"""Values by their content: a process that receives a mesh twice from another process keeps one mesh, with one tree."""

import hashlib
from collections import deque
from collections.abc import Callable
from typing import Any
from weakref import WeakValueDictionary

import numpy as np

from warpsample.host.locks import making

_KEPT = 4  # number of received values that are kept between tasks

_values: WeakValueDictionary[str, Any] = WeakValueDictionary()
_received: deque[Any] = deque(maxlen=_KEPT)


def digest_of(*arrays: np.ndarray) -> str:
    """Return the SHA-256 of the types, shapes and numbers of arrays, in hexadecimal digits."""
    found = hashlib.sha256()
    for array in arrays:
        found.update(f"{array.dtype.str}{array.shape}".encode())
        found.update(np.ascontiguousarray(array).data)
    return found.hexdigest()


def remember(digest: str, value: Any) -> None:
    """Register a value by its digest, so that `find_or_make` returns it in this and in forked processes while it exists."""
    with making:
        _values.setdefault(digest, value)


def find_or_make(digest: str, make: Callable[..., Any], *content: Any) -> Any:
    """Return the registered value of a digest, or a new value, `make(*content)`.

    The last few new values are kept: Dask sends a mesh with each task, and each time a tree would be built.
    """
    with making:
        value = _values.get(digest)
        if value is None:
            value = _values[digest] = make(*content)
            _received.append(value)
        return value
