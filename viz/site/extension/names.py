"""Public names: the module that defines each, and its example, from its docstring or from the call that returns it."""

import inspect
import re
import textwrap
from collections.abc import Iterator
from enum import Enum
from functools import cache
from types import ModuleType
from typing import Any

from docutils import nodes
from sphinx import addnodes

import warpsample as ws
from extension import kernels
from warpsample import cluster, funcs
from warpsample.distributions.record import Distribution
from warpsample.output.quantities import quantities

_EXAMPLE = re.compile(r"^Examples?:\n((?:(?: {4}.*)?\n?)*)", re.MULTILINE)
_CODE_IN_WORD = re.compile(r"(`[^`]+`)(?=\w)")


@cache
def public() -> dict[str, Any]:
    """Return the public names of `warpsample`, `funcs`, `rasters` and `cluster`, as "warpsample.rasters.surface"."""
    calls = [quantity.call.__name__ for quantity in quantities().values() if quantity.in_stores]
    found = [("warpsample", ws, ws.__all__), ("warpsample.funcs", funcs, funcs.__all__)]
    found += [
        ("warpsample.rasters", ws.rasters, ws.rasters.__all__),
        ("warpsample.cluster", cluster, [*cluster.__all__, *calls]),
    ]
    for name in ("distributions", "sequences"):
        module = getattr(ws, name)
        found.append((f"warpsample.{name}", module, [key for key, item in vars(module).items() if _is_own(item, module)]))
    named = {f"{home}.{name}": getattr(module, name) for home, module, names in found for name in names}
    return {name: item for name, item in named.items() if not isinstance(item, ModuleType)}


def _is_own(item: Any, module: ModuleType) -> bool:
    return inspect.isfunction(item) and item.__module__ == module.__name__ and not item.__name__.startswith("_")


def module_of(app: Any, module: str, name: str) -> str | None:  # noqa: ARG001
    """Return the module that defines a public name or a method, to which the link "[source]" leads."""
    first, *rest = name.split(".")
    item = public().get(f"{module}.{first}")
    if item is None:
        return None
    if inspect.isclass(item) and rest:
        item = next((base for base in item.__mro__ if rest[0] in vars(base)), item)
    return kernels.home(item) or getattr(item, "__module__", None)


def polish(app: Any, doctree: Any) -> None:  # noqa: ARG001
    """Change a parsed page: rename the field "Variables" to "Attributes", and add link targets without ".funcs".

    So "warpsample.sobol" links to "warpsample.funcs.sobol".
    """
    for signature in doctree.findall(addnodes.desc_signature):
        signature["ids"] += [name.replace(".funcs.", ".") for name in signature["ids"] if ".funcs." in name]
    for name in doctree.findall(nodes.field_name):
        if name.astext() == "Variables":
            name.replace(name[0], nodes.Text("Attributes"))


def complete(app: Any, what: str, name: str, item: Any, options: Any, lines: list[str]) -> None:  # noqa: ARG001
    """Add an example to the lines of a docstring, and restore texts that napoleon has taken for types.

    Docstrings of this package contain no types.

    docutils requires a gap after the code in "`wp.func`s".
    """
    text = "\n".join(_CODE_IN_WORD.sub(r"\1\\ ", line) for line in lines)
    for kind, field in ((":rtype:", ":returns: "), (":type:", "")):
        if taken := re.search(rf"\n{kind} (.*(?:\n +.*)*)", text):
            text = text.replace(taken[0], "", 1)
            text = text.replace(field, f"{field}{taken[1]}: ", 1) if field else f"{taken[1]}: {text}"
    lines[:] = text.splitlines()
    if name in public() and "Example" not in text:
        made = textwrap.indent(example(name), "   ")
        lines += ["", ".. rubric:: Example", "", ".. code-block:: python", "", *made.splitlines(), ""]


@cache
def example(name: str) -> str:
    """Return the example of a public name, or of the function that returns it; "" if there is none."""
    item = public()[name]
    if name.startswith("warpsample.funcs."):
        return kernels.example(item)
    if own := _find_example(item):
        return own
    if inspect.isclass(item) and issubclass(item, Distribution):
        return _distribution_example(item)
    return next((text for maker in _find_makers(item) if (text := _find_example(maker))), "")


def _find_example(item: Any) -> str:
    found = _EXAMPLE.search(inspect.getdoc(item) or "") if not isinstance(item, Enum) else None
    return textwrap.dedent(found[1]).strip() if found else ""


def _distribution_example(kind: type[Distribution]) -> str:
    """Return example lines for a distribution: sampled directions and their densities."""
    text = re.sub(r"(?<![\w.])([A-Z]\w*\()", r"ws.\1", repr(kind.cases()[0]))
    text = re.sub(r"\barray(\([\d, ]+\))", r"np.ones(\1)", text)  # which stands for a picture of that shape
    return f">>> lobe = {text}\n>>> w = lobe.sample(ws.sample_square('sobol', points=1, count=64)[0])\n>>> p = lobe.pdf(w)"


def _find_makers(kind: Any) -> Iterator[Any]:
    """Yield the public functions and methods that return a class, and the classes with a field or property of this class."""
    calls = [call for call in public().values() if inspect.isfunction(call)]
    classes = [owner for owner in public().values() if inspect.isclass(owner) and owner is not kind]
    calls += [member for owner in classes for member in _members(owner)]
    yield from (call for call in calls if _returns(call, kind))
    for owner in classes:
        if _mentions(owner, kind) or any(_returns(member, kind) for member in _members(owner)):
            yield owner
            yield from (call for call in calls if _returns(call, owner))


def _members(owner: type) -> list[Any]:
    """Return the public methods of a class, and the functions of its properties."""
    items = [getattr(owner, key) for key in dir(owner) if not key.startswith("_")]
    return [getattr(item, "fget", getattr(item, "make", item)) for item in items]


def _returns(call: Any, kind: Any) -> bool:
    return inspect.isfunction(call) and kind.__name__ in re.findall(r"\w+", str(call.__annotations__.get("return", "")))


def _mentions(owner: Any, kind: Any) -> bool:
    return kind.__name__ in re.findall(r"\w+", " ".join(map(str, getattr(owner, "__annotations__", {}).values())))
