"""Functions of the user's, and their data, on their way to tasks and to other processes."""

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
    """A function of the user's, or its data: within a process as it is, to others by its module and name.

    Attributes:
        argument: what it is given as.
        value: a wp.func, or an instance of a wp.struct that nobody else has.
        content: what tells it apart from others, as a store's attributes tell it.
    """

    argument: str
    value: Any
    content: dict[str, Any]

    def taken(self) -> Any:
        """The value, to be computed with.

        Raises:
            ValueError: a function that has changed since the call was made, or is another one in this process.
        """
        if is_function(self.value) and (now := function_content(self.value)) != self.content:
            changed = difference(self.argument, self.content, now)
            raise ValueError(f"{changed} since the call, or is another one where it is computed: make the call again")
        return self.value

    def __reduce__(self) -> tuple[Any, ...]:
        """Tells other processes what to import.

        Raises:
            TypeError: it cannot be imported.
        """
        function = getattr(self.value, "func", None)
        if function is None or function.__module__ == "__main__" or "<locals>" in function.__qualname__:
            raise TypeError(
                f"{self.argument}: got {self.content[WHAT]}, which other processes cannot import, "
                "want a wp.func at the top of a module that they have, without data, or Dask's threads"
            )
        return _named, (self.argument, function.__module__, function.__qualname__, self.content)

    def __dask_tokenize__(self) -> tuple[str, str]:
        """What Dask names tasks by."""
        return self.argument, json.dumps(self.content)


def named(argument: str, value: Any, function: Any) -> Any:
    """An argument as tasks keep it: what changes in place, or is defined again, later does not change what they compute.

    Args:
        argument: its name.
        value: what was given. Functions and data become Named, arrays and lists are copied.
        function: the one that reads the data.
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


def _named(argument: str, module: str, name: str, content: dict[str, Any]) -> Named:
    return Named(argument, getattr(importlib.import_module(module), name), content)
