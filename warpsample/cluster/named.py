"""Wrapper with which Dask sends user-defined Warp functions and their data to other processes."""

import importlib
import json
from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsample.estimate.integrand import with_arrays
from warpsample.estimate.source.content import WHAT, data_content, difference, function_content, is_data
from warpsample.estimate.source.definitions import is_function, naming_function
from warpsample.host.neighbours import as_ndarray

_ARRAYS = ("__array__", "__array_interface__", "__dlpack__", "__cuda_array_interface__")


@dataclass(frozen=True)
class Named:
    """User-defined function, or the data of a function, wrapped as an argument of Dask tasks.

    Within a process the value itself is used. Other processes import a function by its module and name.

    Attributes:
        argument: Name of the argument.
        value: A wp.func, or a private copy of an instance of a wp.struct.
        content: Texts that identify the function or the data, by name; also saved in a store's attributes.
    """

    argument: str
    value: Any
    content: dict[str, Any]

    def unwrap(self) -> Any:
        """Return the wrapped function or data; raise an error if the function has been redefined since the call.

        Raises:
            ValueError: if the function has changed since the call was made, or differs in this process.
        """
        if is_function(self.value) and (now := function_content(self.value)) != self.content:
            changed = difference(self.argument, self.content, now)
            raise ValueError(f"{changed} since the call, or differs on this worker: make the call again")
        return self.value

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle a function as its module, its name and its content.

        Raises:
            TypeError: if the function cannot be imported by other processes, or the value is data.
        """
        function = getattr(self.value, "func", None)
        if function is None or function.__module__ == "__main__" or "<locals>" in function.__qualname__:
            raise TypeError(
                f"{self.argument}: got {self.content[WHAT]}, which other processes cannot import, "
                'want a wp.func at the top level of an importable module and no data, or Dask\'s scheduler="threads"'
            )
        return _import_named, (self.argument, function.__module__, function.__qualname__, self.content)

    def __dask_tokenize__(self) -> tuple[str, str]:
        """Return the values that Dask hashes into the names of tasks."""
        return self.argument, json.dumps(self.content)


def named(argument: str, value: Any, function: Any) -> Any:
    """Copy or wrap an argument of a call, so that later changes by the caller have no effect.

    Args:
        argument: Name of the argument.
        value: Value of the argument. Functions and data become a Named, arrays and lists are copied, all else is unchanged.
        function: Function that reads the data.
    """
    if is_function(value):
        with naming_function(argument):
            return Named(argument, value, function_content(value))
    if is_data(value):
        own = with_arrays(value, wp.clone)
        return Named(argument, own, data_content(own, function))
    if isinstance(value, list) or (getattr(value, "ndim", 0) and any(hasattr(value, name) for name in _ARRAYS)):
        return np.array(as_ndarray(value, argument))
    return value


def _import_named(argument: str, module: str, name: str, content: dict[str, Any]) -> Named:
    """Import a function by module and name, and wrap the function as a Named, to unpickle a Named."""
    return Named(argument, getattr(importlib.import_module(module), name), content)
