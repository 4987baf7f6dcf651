"""Meshes by their content: in one process, those that arrive from others with the same content are one, with one tree."""

import hashlib
from collections import deque
from collections.abc import Callable
from typing import Any
from weakref import WeakValueDictionary

import numpy as np

from warpsample.host.locks import making

_KEPT = 4  # of those that arrived, between tasks that nothing else keeps them for

_known: WeakValueDictionary[str, Any] = WeakValueDictionary()
_arrived: deque[Any] = deque(maxlen=_KEPT)


def digest_of(*arrays: np.ndarray) -> str:
    """SHA-256 of the types, shapes and numbers of arrays, in hexadecimal digits."""
    found = hashlib.sha256()
    for array in arrays:
        found.update(f"{array.dtype.str}{array.shape}".encode())
        found.update(np.ascontiguousarray(array).data)
    return found.hexdigest()


def remember(digest: str, value: Any) -> None:
    """Lets `arrived` find a value again in this process and in those that it forks, while it lives."""
    with making:
        _known.setdefault(digest, value)


def arrived(digest: str, make: Callable[..., Any], *content: Any) -> Any:
    """The value of this content that the process knows, or a new one: `make(*content)`.

    The last few are kept, since Dask's processes get them anew with each task, and would build their trees as often.
    """
    with making:
        value = _known.get(digest)
        if value is None:
            value = _known[digest] = make(*content)
            _arrived.append(value)
        return value
