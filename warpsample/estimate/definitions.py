"""What the user's source stands for now: names are defined again, in a notebook or by a reload, and Warp keeps both.

A function whose arguments change becomes one of several in Warp, under the first's name; a kernel that is built keeps the
helpers and the numbers that were found when it was.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from inspect import get_annotations, getclosurevars
from types import ModuleType
from typing import Any

import warp as wp

NUMBERS = (float, int, wp.float16, wp.float32, wp.float64, wp.int8, wp.int16, wp.int32, wp.int64)
NUMBERS += (wp.uint8, wp.uint16, wp.uint32, wp.uint64)
"""What kernels call a number."""

_OURS = "warpsample."
_DOES_NOT_COMPILE = (
    wp.WarpCodegenError,
    wp.WarpCodegenAttributeError,
    wp.WarpCodegenIndexError,
    wp.WarpCodegenKeyError,
    wp.WarpCodegenTypeError,
    wp.WarpCodegenValueError,
)


def latest(function: wp.Function) -> wp.Function:
    """The function that was last defined under its name, with whichever arguments."""
    last = getattr(function, "__wrapped__", function.func)
    overloads = (*function.user_overloads.values(), *function.user_templates.values())
    return next((overload for overload in overloads if overload.func is last), function)


def returned(function: wp.Function) -> Any:
    """What a function says that it returns, also in a string; None if it says nothing."""
    names = getclosurevars(function.func).nonlocals
    return get_annotations(function.func, locals=names, eval_str=True).get("return")


def meaning(function: wp.Function) -> tuple[Any, ...]:
    """The functions, structs and numbers that a function's source names, and those of these functions; to be compared."""
    found: list[Any] = []
    for one in _reached(function):
        for name, value in _named(one):
            if isinstance(value, NUMBERS) or hasattr(type(value), "_wp_scalar_type_"):
                found.append((name, type(value), repr(value)))  # NaN is equal to itself there
            elif isinstance(value, wp.Function) or hasattr(value, "native_name"):
                found.append(value)
    return tuple(found)


def names_in(function: wp.Function) -> set[str]:
    """The fields, among other names, that a function's source and those of the functions that it names read."""
    return {name for one in _reached(function) for name in one.func.__code__.co_names}


def _reached(function: wp.Function) -> list[wp.Function]:
    """A function, and those that it calls, without this package's own."""
    reached = [function]
    for one in reached:  # grows
        for _name, value in _named(one):
            if isinstance(value, wp.Function) and value not in reached and value.func is not None:
                reached += [] if value.func.__module__.startswith(_OURS) else [value]
    return reached


def _named(function: wp.Function) -> Iterator[tuple[str, Any]]:
    """(name, value) of all that a function's source names outside of itself, also in modules."""
    known = getclosurevars(function.func)
    for name, value in (*known.nonlocals.items(), *known.globals.items()):
        if not isinstance(value, ModuleType):
            yield name, value
        elif not value.__name__.startswith(("warp.", _OURS)) and value is not wp:
            yield from ((f"{name}.{inner}", getattr(value, inner, None)) for inner in sorted(known.unbound))


@contextmanager
def naming_function(argument: str) -> Iterator[None]:
    """Names the argument whose function Warp cannot compile, and what in it.

    Raises:
        TypeError: it cannot.
    """
    try:
        yield
    except _DOES_NOT_COMPILE as error:
        reason = " ".join(str(error.args[0]).rpartition("Error while parsing function")[2].split())
        raise TypeError(f"{argument}: got a function that does not compile, in {reason}") from error
