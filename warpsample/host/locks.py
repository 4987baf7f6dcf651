"""Values that a process makes once: by one thread at a time, visible when complete, never half-made in a forked child."""

from collections.abc import Callable
from functools import partial, wraps
from typing import Any, Generic, TypeVar

import numpy as np

from warpsample.host.making import make, making

T = TypeVar("T")
_UNKNOWN: Any = object()


def once(factory: Callable[..., T]) -> Callable[..., T]:
    """Like `functools.cache`, but two threads never make the same value; known values are found without the lock."""
    known: dict[tuple[Any, ...], T] = {}

    @wraps(factory)
    def get(*arguments: Any, **named: Any) -> T:
        key = (*arguments, *named.items()) if named else arguments
        value = known.get(key, _UNKNOWN)
        return make(partial(get_new, key, arguments, named)) if value is _UNKNOWN else value

    def get_new(key: tuple[Any, ...], arguments: tuple[Any, ...], named: dict[str, Any]) -> T:
        if key not in known:
            known[key] = factory(*arguments, **named)
        return known[key]

    get.known = known  # type: ignore[attr-defined]
    return get


class once_property(Generic[T]):  # noqa: N801  (used as a decorator, like `functools.cached_property`)
    """Like `functools.cached_property`, but two threads never make the same value; an array is kept read-only."""

    def __init__(self, make: Callable[[Any], T]) -> None:
        self.make = make
        self.__doc__ = make.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        """The name under which instances keep the value."""
        self.name = name

    def __get__(self, instance: Any, owner: type | None = None) -> T:
        """Makes the value; afterwards Python finds the instance's own attribute first."""
        if instance is None:
            return self  # type: ignore[return-value]
        with making:
            if self.name not in instance.__dict__:
                value = self.make(instance)
                instance.__dict__[self.name] = read_only(value) if isinstance(value, np.ndarray) else value
            return instance.__dict__[self.name]


def read_only(array: np.ndarray) -> np.ndarray:
    """A copy in immutable memory, which cannot be made writeable again."""
    return np.ndarray(array.shape, array.dtype, array.tobytes())
