"""Thread-safe caching, of values that are computed once per process by one thread at a time, and work that a fork awaits."""

import os
import threading
from collections.abc import Callable
from functools import cache, partial, wraps
from importlib import import_module
from types import ModuleType
from typing import Any, Generic, TypeVar

from warpsample.host.interrupts import uninterrupted

T = TypeVar("T")
_UNKNOWN: Any = object()

making = threading.RLock()
"""Held while a kernel is built or loaded, a launch recorded, a tree or another cache made: Warp does not allow two threads
there. A fork waits for the lock, so that the child finds each of these either complete or not begun."""

_importing = threading.RLock()  # held while parts of this package are imported, which make things: taken before `making`


algebra = threading.RLock()
"""Held during linear algebra with large arrays, which a fork waits for. OpenBLAS ends its threads at a fork: a fork during a
product and the product itself would never end."""


def _hold() -> None:
    _importing.acquire()
    making.acquire()
    algebra.acquire()


def _let_go() -> None:
    algebra.release()
    making.release()
    _importing.release()


import_module("logging")  # has a lock that a fork takes, too, and imports need: what is registered last is taken first
if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_let_go, after_in_child=_let_go)


def make(work: Callable[[], T], lock: Any = making) -> T:
    """Call `work` and return its result, under a process-wide lock and without interrupts."""

    def work_alone() -> T:
        with lock:
            return work()

    return uninterrupted(work_alone)


def multiply(a: Any, b: Any) -> Any:
    """Return the matrix product a @ b of large arrays; a fork waits until it is computed."""
    with algebra:
        return a @ b


@cache
def imported(name: str) -> ModuleType:
    """Import a module and return it, at its first use, with interrupts deferred."""
    return make(partial(import_module, name), _importing if name.startswith("warpsample.") else making)


def once(factory: Callable[..., T]) -> Callable[..., T]:
    """Decorate a function like `functools.cache`, but two threads never make the same value. A known value needs no lock."""
    values: dict[tuple[Any, ...], T] = {}

    @wraps(factory)
    def get(*arguments: Any, **named: Any) -> T:
        key = (*arguments, *named.items()) if named else arguments
        value = values.get(key, _UNKNOWN)
        return make(partial(get_new, key, arguments, named)) if value is _UNKNOWN else value

    def get_new(key: tuple[Any, ...], arguments: tuple[Any, ...], named: dict[str, Any]) -> T:
        if key not in values:
            values[key] = factory(*arguments, **named)
        return values[key]

    get.cache = values  # type: ignore[attr-defined]
    return get


class once_property(Generic[T]):  # noqa: N801  (used as a decorator, like `functools.cached_property`)
    """Thread-safe `functools.cached_property`; arrays are made read-only."""

    def __init__(self, make: Callable[[Any], T]) -> None:
        self.make = make
        self.__doc__ = make.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        """Store the attribute name under which instances keep the value."""
        self.name = name

    def __get__(self, instance: Any, owner: type | None = None) -> T:
        """Return the cached value, which is computed at the first use."""
        if instance is None:
            return self  # type: ignore[return-value]
        with making:
            if self.name not in instance.__dict__:
                value = self.make(instance)
                instance.__dict__[self.name] = read_only(value) if isinstance(value, imported("numpy").ndarray) else value
            return instance.__dict__[self.name]


def read_only(array: Any) -> Any:
    """Copy a NumPy array to immutable memory, which cannot be made writeable again."""
    return imported("numpy").ndarray(array.shape, array.dtype, array.tobytes())
