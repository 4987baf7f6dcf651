"""Functions of the user's on their way to other processes."""

import importlib
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Named:
    """A function of the user's, or its data: within a process as it is, to others by its module and name.

    Attributes:
        argument: what it is given as.
        value: a wp.func, or an instance of a wp.struct.
    """

    argument: str
    value: Any

    def __str__(self) -> str:
        """As a store's attributes tell it."""
        function = getattr(self.value, "func", None)
        return f"{function.__module__}.{function.__qualname__}" if function else type(self.value).__name__

    def __reduce__(self) -> tuple[Any, ...]:
        """What to import.

        Raises:
            TypeError: it cannot be imported.
        """
        function = getattr(self.value, "func", None)
        if function is None or function.__module__ == "__main__" or "<locals>" in function.__qualname__:
            raise TypeError(
                f"{self.argument}: got {self}, which other processes cannot import, "
                "want a wp.func at the top of a module that they have, without data, or Dask's threads"
            )
        return _named, (self.argument, function.__module__, function.__qualname__)

    def __dask_tokenize__(self) -> tuple[str, int]:
        """What Dask names tasks by: this very object, in this process."""
        return str(self), id(self.value)


def _named(argument: str, module: str, name: str) -> Named:
    return Named(argument, getattr(importlib.import_module(module), name))
