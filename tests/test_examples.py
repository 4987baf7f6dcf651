"""Every public function documents its arguments and its result, and has an example, which is run."""

import inspect
from enum import Enum
from types import ModuleType

import pytest
import pyvista as pv
from docstrings import failures, flaws, sections

import warpsample as ws
from warpsample.distributions.record import Distribution
from warpsample.estimate.result import PointResult

ACCESSOR = type(pv.PolyData().warpsample)


def public():
    """Return (name, function) of the functions of `ws.__all__`, its modules and classes, where they are first defined."""
    for name in ws.__all__:
        item = getattr(ws, name)
        if isinstance(item, ModuleType):
            yield from ((f"{name}.{key}", f) for key, f in own(item) if f.__module__ == item.__name__)
        elif inspect.isclass(item):
            yield from methods(name, item)
        else:
            yield name, item
    yield from methods("Distribution", Distribution)
    yield from methods("PointResult", PointResult)
    yield from methods("accessor", ACCESSOR)
    yield from (
        (f"rasters.{name}", call) for name in ws.rasters.__all__ if inspect.isfunction(call := getattr(ws.rasters, name))
    )


def own(owner):
    """Return public functions by name, including class methods."""
    found = ((key, getattr(owner, key)) for key in vars(owner) if not key.startswith("_"))
    return [(key, item) for key, item in found if inspect.isfunction(item) or inspect.ismethod(item)]


def methods(name, owner):
    inherited = {key for base in owner.__mro__[1:] for key in vars(base)}
    if not issubclass(owner, Enum):
        yield from ((f"{name}.{key}", function) for key, function in own(owner) if key not in inherited)


def documented():
    """Return every docstring with an example, of functions and of classes."""
    classes = {name: item for name in ws.__all__ if inspect.isclass(item := getattr(ws, name))}
    return FUNCTIONS | {name: item for name, item in classes.items() if "Example" in sections(item)}


FUNCTIONS = dict(public())
EXAMPLES = documented()


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_docstring_says_what_goes_in_and_comes_out(name):
    assert flaws(FUNCTIONS[name]) == []


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_prints_what_it_says(name):
    assert failures(name, sections(EXAMPLES[name])["Example"]) == ""


def test_all_that_is_public_is_read():
    functions = {name for name in ws.__all__ if inspect.isfunction(getattr(ws, name))}
    assert functions | {"distributions.get", "sequences.names", "Estimate.interval", "Directions.to_polydata"} <= set(
        FUNCTIONS
    )
    assert {"Distribution.sample", "Distribution.cases", "Distribution.invert", "accessor.sky_view_factor"} <= set(FUNCTIONS)


def lacks_much(count: int, seed: int = 0, **options) -> int:
    """Lacks much.

    Args:
        count: told.

    Example:
        >>> print(count)
    """


def test_what_is_lacking_is_seen():
    assert flaws(lacks_much) == [
        "Args: seed",
        "Args: **options",
        "Returns",
        "Example of one to five lines, with what it prints",
    ]


@pytest.mark.parametrize("text", [">>> 1 + 1\n3\n", ">>> ws.nothing\n", ">>> 2\n"])
def test_an_example_that_is_wrong_fails(text):
    assert failures("wrong", text) != ""
