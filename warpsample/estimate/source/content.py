"""Hashes of user-defined Warp functions and of their data, which detect changes between two runs.

Warp's own hash of a kernel is not sufficient. It ignores defaults of arguments, uses only 32 bits of each number, and sees
the value of a `wp.static` in a loop only if the kernel's own module contains one.
"""

from collections.abc import Iterator
from ctypes import Array
from hashlib import sha256
from math import isfinite
from typing import Any
from uuid import uuid4

import numpy as np
import warp as wp

from warpsample.estimate.source.definitions import called, is_function, latest, names_in, reached
from warpsample.host.shared_values import digest_of

WHAT = "what"
"""Key of the name of the function or the struct in a content."""

_OURS = "warpsample."
_BEHIND = ("mesh_", "bvh_", "hash_grid_", "volume_", "texture_")  # built-ins that read from an address
_ADDRESS = "address"


def is_data(value: Any) -> bool:
    """Return whether a value is an instance of a wp.struct."""
    return hasattr(value, "_cls") and hasattr(value, "__ctype__")


def function_content(function: wp.Function) -> dict[str, Any]:
    """Return a hash of a user's Warp function and of each function it calls, keyed by function name.

    A digest covers the current source, and the current values of the constants in the source.
    """
    parts: dict[str, list[Any]] = {}
    users = called(latest(function))
    for one in reached(users):
        parts.setdefault(_name(one.func), []).append(_list_parts(one))  # two functions may have one name
    for one in users:
        parts[_name(one.func)].append([[code, _number(value)] for code, value in one.adj.deferred_static_expressions])
    return {WHAT: _name(function.func), **{name: sha256(repr(facts).encode()).hexdigest() for name, facts in parts.items()}}


def data_content(data: Any, function: Any) -> dict[str, Any]:
    """Return the content of a user's struct for comparisons: its numbers, and hashes of its arrays, keyed by field name.

    The memory at an address, such as the id of a wp.Mesh, cannot be compared. Where `function` reads from addresses, the
    content of an address field therefore differs from every other content.
    """
    behind = is_function(function) and any(name.startswith(_BEHIND) or name == "ptr" for name in names_in(latest(function)))
    return {WHAT: _name(data._cls.cls), **dict(_fields(data, "", behind))}


def difference(name: str, old: dict[str, Any], new: dict[str, Any]) -> str:
    """Describe, for an error message, the first difference between two versions of a user's function or data."""
    if old.get(WHAT) != new.get(WHAT):
        return f"{name}: it was {old.get(WHAT)}, and is {new.get(WHAT)}"
    part = next(part for part in (*new, *old) if old.get(part) != new.get(part))
    if name != "data":
        return f"{name}: the function {part} changed"
    if str(new.get(part)).startswith(_ADDRESS):
        return f"data: an address in its field {part!r}, and what is there cannot be compared"
    return f"data: other numbers in its field {part!r}"


def _fields(data: Any, within: str, behind: bool) -> Iterator[tuple[str, Any]]:
    """Yield the (name, content) pairs of the fields of a struct and its nested structs.

    `behind` states whether the function reads from addresses.
    """
    behind = behind or data._cls.cls.__module__.startswith(_OURS)  # such as the mesh of a Tree
    for name, variable in data._cls.vars.items():
        value, raw = getattr(data, name), getattr(data._ctype, name)
        if hasattr(value, "_cls"):
            yield from _fields(value, f"{within}{name}.", behind)
        elif behind and _is_address(value, raw, variable.type):
            yield within + name, f"{_ADDRESS} {uuid4().hex}"
        elif value is None:
            yield within + name, None
        elif isinstance(value, wp.array | wp.indexedarray):
            yield within + name, digest_of(value.numpy())
        elif isinstance(raw, bool | int) or (isinstance(raw, float) and isfinite(raw)):
            yield within + name, raw
        elif isinstance(raw, Array | float):
            yield within + name, bytes(np.asarray(raw)).hex()
        else:  # a texture, or another type that holds an address
            yield within + name, f"{_ADDRESS} {uuid4().hex}"


def _is_address(value: Any, raw: Any, kind: Any) -> bool:
    """Return whether a field may hold addresses: a nonzero uint64, or a nonempty array of uint64 or of structs."""
    if isinstance(value, wp.array | wp.indexedarray):
        return bool(value.size) and (value.dtype is wp.uint64 or hasattr(value.dtype, "vars"))
    return kind is wp.uint64 and raw != 0


def _list_parts(function: wp.Function) -> list[Any]:
    """Return the parts of a user's function that determine the results: source, types, constants and defaults."""
    constants, types, _ = function.adj.get_references()
    static = function.adj.resolved_static_expressions
    facts = [function.adj.source, function.native_snippet]
    facts += [_kind(kind) for kind in (*types, *function.input_types.values())]
    return facts + [[name, _number(value)] for one in (constants, static, function.defaults) for name, value in one.items()]


def _number(value: Any) -> str:
    """Return a text that identifies a constant and is the same in each process."""
    return f"{type(value).__name__} {data_content(value, None) if is_data(value) else getattr(value, 'key', value)}"


def _kind(kind: Any) -> str:
    """Return a text that identifies a type; the text of a struct includes the fields."""
    of = getattr(kind, "dtype", kind)  # the element type of an array type
    fields = of.hash.hex() if hasattr(of, "native_name") else ""  # a struct
    return f"{getattr(kind, 'key', kind)} {fields}"


def _name(definition: Any) -> str:
    return f"{definition.__module__}.{definition.__qualname__}"
