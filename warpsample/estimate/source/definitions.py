"""What the user's source stands for now: names are defined again, in a notebook or by a reload, and Warp keeps both.

A function whose arguments change becomes one of several in Warp, under the first's name; a kernel that is built keeps the
helpers and the numbers that were found when it was.
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
"""What kernels call a number."""

_OURS = "warpsample."
_DOES_NOT_COMPILE = "Error while parsing function"


def latest(function: wp.Function) -> wp.Function:
    """The function that was last defined under its name, with whichever arguments."""
    last = getattr(function, "__wrapped__", function.func)
    overloads = (*function.user_overloads.values(), *function.user_templates.values())
    return next((overload for overload in overloads if overload.func is last), function)


def returned(function: wp.Function) -> Any:
    """What a function says that it returns, also in a string; None if it says nothing."""
    names = getclosurevars(function.func).nonlocals
    return get_annotations(function.func, locals=names, eval_str=True).get("return")


def is_function(value: Any) -> bool:
    """Whether a value is a function of the user's, and not one of Warp's."""
    return isinstance(value, wp.Function) and value.func is not None


def names_in(function: wp.Function) -> set[str]:
    """The fields, among other names, that a function's source and those of the functions that it calls read."""
    return {name for one in reached(called(function)) for name in one.func.__code__.co_names}


def called(function: wp.Function) -> list[wp.Function]:
    """A function, and if a loop lets a `wp.static` in it wait, those that it calls: each then knows what its own ones give.

    They are known when Warp makes code of the function.
    """
    found = [function]
    if any(one.adj.has_unresolved_static_expressions for one in reached(found)):
        options = wp.get_module(__name__).resolve_options(wp.config)
        make(partial(function.build, None, {**options, "output_arch": None}))
        for one in found:  # grows
            found += [other for other in one.adj.called_user_functions if other not in found and _is_users(other)]
    return found


def reached(functions: list[wp.Function]) -> list[wp.Function]:
    """Functions, and all definitions of those that they name, without this package's own."""
    found = list(functions)
    for one in found:  # grows
        named = (*one.adj.get_references()[2], *one.adj.resolved_static_expressions.values(), *one.defaults.values())
        for other in filter(_is_users, named):
            found += [definition for definition in _definitions(other) if definition not in found]
    return found


def _is_users(value: Any) -> bool:
    return is_function(value) and not value.func.__module__.startswith(_OURS)


def _definitions(function: wp.Function) -> list[wp.Function]:
    """All definitions of a function's name, for other types of arguments."""
    known = sorted((function.user_overloads | function.user_templates).items())
    return [one for _, one in known if one.generic_parent is None] or [function]


@contextmanager
def naming_function(argument: str) -> Iterator[None]:
    """Names the argument whose function Warp cannot compile, and what in it.

    Raises:
        TypeError: it cannot.
    """
    try:
        yield
    except Exception as error:  # of any type: Warp only adds where it was raised
        _, parsing, reason = str(error.args[0] if error.args else "").rpartition(_DOES_NOT_COMPILE)
        if not parsing:
            raise
        raise TypeError(f"{argument}: got a function that does not compile, in {' '.join(reason.split())}") from error
