"""What a process makes once: in one thread at a time, published whole, and never half-made in a forked child."""

import os
import threading
from collections.abc import Callable
from functools import wraps
from typing import Any, Generic, TypeVar

import numpy as np

making = threading.RLock()
"""Held while a kernel is built or loaded, a launch recorded, a tree or another cache made: Warp's own steps are not safe
from two threads at once. A fork waits for it, so that the child finds everything either made or not begun."""

if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=making.acquire, after_in_parent=making.release, after_in_child=making.release)

T = TypeVar("T")


def once(factory: Callable[..., T]) -> Callable[..., T]:
    """As `functools.cache`, but made once whichever threads ask; what is known already is found without the lock."""
    known: dict[tuple[Any, ...], T] = {}

    @wraps(factory)
    def get(*arguments: Any, **named: Any) -> T:
        key = (*arguments, *named.items())
        if key not in known:
            with making:
                if key not in known:
                    known[key] = factory(*arguments, **named)
        return known[key]

    get.known = known  # type: ignore[attr-defined]
    return get


class once_property(Generic[T]):  # noqa: N801  (used as a decorator, like `functools.cached_property`)
    """As `functools.cached_property`, but made once whichever threads ask; an array is kept read-only."""

    def __init__(self, make: Callable[[Any], T]) -> None:
        """Of the method that makes the value."""
        self.make = make
        self.__doc__ = make.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        """The name under which instances keep the value."""
        self.name = name

    def __get__(self, instance: Any, owner: type | None = None) -> T:
        """Makes the value; afterwards the instance's own attribute is found first."""
        if instance is None:
            return self  # type: ignore[return-value]
        with making:
            if self.name not in instance.__dict__:
                value = self.make(instance)
                instance.__dict__[self.name] = read_only(value) if isinstance(value, np.ndarray) else value
            return instance.__dict__[self.name]


def read_only(array: np.ndarray) -> np.ndarray:
    """A copy on immutable memory, so that nobody can make it writeable again."""
    return np.ndarray(array.shape, array.dtype, array.tobytes())
