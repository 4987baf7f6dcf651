"""What a function of the user's and its data hold, so that two runs can be told apart: numbers, and digests of the rest.

Warp's own hash of a kernel does not do: it sees no defaults of arguments, 32 bits of each number, and what a `wp.static` in
a loop gives only where the kernel's own module has one.
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
from warpsample.host.known import digest_of

WHAT = "what"
"""The entry of a content that is the name of a function, or of a struct."""

_OURS = "warpsample."
_BEHIND = ("mesh_", "bvh_", "hash_grid_", "volume_", "texture_")  # built-ins that read what a number is the address of
_ADDRESS = "address"


def is_data(value: Any) -> bool:
    """Whether a value is an instance of a wp.struct."""
    return hasattr(value, "_cls") and hasattr(value, "__ctype__")


def function_content(function: wp.Function) -> dict[str, Any]:
    """A digest of a function as it is now, and of each that it calls: their sources, and the numbers that these name."""
    parts: dict[str, list[Any]] = {}
    users = called(latest(function))
    for one in reached(users):
        parts.setdefault(_name(one.func), []).append(_told(one))  # two that a function has defined are of one name
    for one in users:
        parts[_name(one.func)].append([[code, _number(value)] for code, value in one.adj.deferred_static_expressions])
    return {WHAT: _name(function.func), **{name: sha256(repr(told).encode()).hexdigest() for name, told in parts.items()}}


def data_content(data: Any, function: Any) -> dict[str, Any]:
    """The numbers of a struct's fields, and digests of its arrays and vectors.

    What stands behind an address, as the id of a wp.Mesh, cannot be told: where the function reads such, it equals no other.
    """
    behind = is_function(function) and any(name.startswith(_BEHIND) or name == "ptr" for name in names_in(latest(function)))
    return {WHAT: _name(data._cls.cls), **dict(_fields(data, "", behind))}


def difference(name: str, old: dict[str, Any], new: dict[str, Any]) -> str:
    """What differs between two contents of an argument, as a sentence says it."""
    if old.get(WHAT) != new.get(WHAT):
        return f"{name}: it was {old.get(WHAT)}, and is {new.get(WHAT)}"
    part = next(part for part in (*new, *old) if old.get(part) != new.get(part))
    if name != "data":
        return f"{name}: the function {part} changed"
    if str(new.get(part)).startswith(_ADDRESS):
        return f"data: an address in its field {part!r}, and what is there cannot be compared"
    return f"data: other numbers in its field {part!r}"


def _fields(data: Any, within: str, behind: bool) -> Iterator[tuple[str, Any]]:
    """(name, content) of all fields of a struct, and of the structs in it."""
    behind = behind or data._cls.cls.__module__.startswith(_OURS)  # as a Tree's mesh
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
        else:  # a texture, or whatever else holds an address
            yield within + name, f"{_ADDRESS} {uuid4().hex}"


def _is_address(value: Any, raw: Any, kind: Any) -> bool:
    """Whether a field may hold addresses: a number of 64 bits, or an array of such, or of structs, that is not empty."""
    if isinstance(value, wp.array | wp.indexedarray):
        return bool(value.size) and (value.dtype is wp.uint64 or hasattr(value.dtype, "vars"))
    return kind is wp.uint64 and raw != 0


def _told(function: wp.Function) -> list[Any]:
    """One definition by its source and what that names."""
    constants, types, _ = function.adj.get_references()
    static = function.adj.resolved_static_expressions
    told = [function.adj.source, function.native_snippet]
    told += [_kind(kind) for kind in (*types, *function.input_types.values())]
    return told + [[name, _number(value)] for one in (constants, static, function.defaults) for name, value in one.items()]


def _number(value: Any) -> str:
    """A number that a source names, the same in each process."""
    return f"{type(value).__name__} {data_content(value, None) if is_data(value) else getattr(value, 'key', value)}"


def _kind(kind: Any) -> str:
    """A type that a source names; a struct by its fields, too."""
    of = getattr(kind, "dtype", kind)  # of an array
    fields = of.hash.hex() if hasattr(of, "native_name") else ""  # as structs have
    return f"{getattr(kind, 'key', kind)} {fields}"


def _name(definition: Any) -> str:
    return f"{definition.__module__}.{definition.__qualname__}"
