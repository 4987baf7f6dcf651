"""Lookup of the current definition of a user's Warp function, which notebooks may have defined again.

If a function is defined again with other argument types, Warp keeps both definitions as overloads of one name. A kernel
keeps the functions and constants of the time when the kernel was built.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from inspect import get_annotations, getclosurevars
from typing import Any

import warp as wp

from warpsample.host.locks import make

NUMBERS = (float, int, wp.float16, wp.float32, wp.float64, wp.int8, wp.int16, wp.int32, wp.int64)
NUMBERS += (wp.uint8, wp.uint16, wp.uint32, wp.uint64)
"""Types of numbers in kernels."""

_OURS = "warpsample."
_DOES_NOT_COMPILE = "Error while parsing function"


def latest(function: wp.Function) -> wp.Function:
    """Return the most recent definition of a Warp function with the same name, whatever the types of the arguments."""
    last = getattr(function, "__wrapped__", function.func)
    overloads = (*function.user_overloads.values(), *function.user_templates.values())
    return next((overload for overload in overloads if overload.func is last), function)


def returned(function: wp.Function) -> Any:
    """Return the type of a function's return annotation, also of a string; None without an annotation."""
    names = getclosurevars(function.func).nonlocals
    return get_annotations(function.func, locals=names, eval_str=True).get("return")


def is_function(value: Any) -> bool:
    """Return whether a value is a `wp.func` written in Python rather than a built-in function of Warp."""
    return isinstance(value, wp.Function) and value.func is not None


def names_in(function: wp.Function) -> set[str]:
    """Return the names of all attributes and globals that a user's function, and the functions it calls, read."""
    return {name for one in reached(called(function)) for name in one.func.__code__.co_names}


def called(function: wp.Function) -> list[wp.Function]:
    """Return a list of a function and, if Warp has not evaluated a `wp.static` there yet, of the functions it calls.

    In that case Warp generates the function's code first, which evaluates each `wp.static`.
    """
    found = [function]
    if any(one.adj.has_unresolved_static_expressions for one in reached(found)):
        options = wp.get_module(__name__).resolve_options(wp.config)
        make(partial(function.build, None, {**options, "output_arch": None}))
        for one in found:  # the list grows
            found += [other for other in one.adj.called_user_functions if other not in found and _is_users(other)]
    return found


def reached(functions: list[wp.Function]) -> list[wp.Function]:
    """Return the given functions and all user-defined functions called from there, directly or indirectly."""
    found = list(functions)
    for one in found:  # the list grows
        named = (*one.adj.get_references()[2], *one.adj.resolved_static_expressions.values(), *one.defaults.values())
        for other in filter(_is_users, named):
            found += [definition for definition in _definitions(other) if definition not in found]
    return found


def _is_users(value: Any) -> bool:
    return is_function(value) and not value.func.__module__.startswith(_OURS)


def _definitions(function: wp.Function) -> list[wp.Function]:
    """Return all overloads of a function, one for each signature."""
    known = sorted((function.user_overloads | function.user_templates).items())
    return [one for _, one in known if one.generic_parent is None] or [function]


@contextmanager
def naming_function(argument: str) -> Iterator[None]:
    """Context manager: report a Warp compilation error as a TypeError that names the argument.

    Raises:
        TypeError: Warp cannot compile the function.
    """
    try:
        yield
    except Exception as error:  # of any type: Warp adds the place to the original error
        _, parsing, reason = str(error.args[0] if error.args else "").rpartition(_DOES_NOT_COMPILE)
        if not parsing:
            raise
        raise TypeError(f"{argument}: got a function that does not compile, in {' '.join(reason.split())}") from error
