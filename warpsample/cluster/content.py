"""What a function of the user's and its data hold, so that two runs can be told apart: numbers, and digests of the rest."""

import re
from collections.abc import Iterator
from ctypes import Array
from hashlib import sha256
from inspect import getclosurevars
from math import isfinite
from types import ModuleType
from typing import Any
from uuid import uuid4

import numpy as np
import warp as wp

from warpsample.estimate.definitions import latest, names_in
from warpsample.mesh.known import digest_of

WHAT = "what"
"""The entry of a content that is the name of a function, or of a struct."""

_OURS = "warpsample."
_PLAIN = (list, tuple, dict, set, frozenset, np.ndarray)  # what a `wp.static` may read
_WHERE = re.compile(r" at 0x[0-9a-f]+")  # of an object, as Python prints it
_BEHIND = ("mesh_", "bvh_", "hash_grid_", "volume_", "texture_")  # built-ins that read what a number is the address of
_ADDRESS = "address"


def is_function(value: Any) -> bool:
    """Whether a value is a function of the user's."""
    return isinstance(value, wp.Function) and value.func is not None


def is_data(value: Any) -> bool:
    """Whether a value is an instance of a wp.struct."""
    return hasattr(value, "_cls") and hasattr(value, "__ctype__")


def function_content(function: wp.Function) -> dict[str, Any]:
    """A digest of a function as it is now, and of each that it calls: their sources, and the numbers that these name."""
    reached, parts = [latest(function)], {}
    for one in reached:  # grows
        for definition in _definitions(one) if one is not reached[0] else [one]:
            told, called = _told(definition)
            parts.setdefault(_name(one.func), []).append(told)  # two that a function has defined are of one name
            reached += [other for other in called if other not in reached]
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


def _told(function: wp.Function) -> tuple[list[Any], list[wp.Function]]:
    """One definition by its source and what that names, and the functions that it calls, without this package's own."""
    constants, types, called = function.adj.get_references()
    static = function.adj.resolved_static_expressions
    told = [function.adj.source, function.native_snippet]
    told += [_kind(kind) for kind in (*types, *function.input_types.values())]
    told += [[name, _number(value)] for name, value in (*constants.items(), *static.items())]
    named: list[wp.Function] = []
    told += [[name, _walked(value, named)] for name, value in _named(function) if isinstance(value, _PLAIN)]
    users = [one for one in (*called, *static.values(), *named) if is_function(one)]
    return told, [one for one in users if not one.func.__module__.startswith(_OURS)]


def _walked(value: Any, functions: list[wp.Function]) -> Any:
    """What a list or the like holds, the same in each process; the functions in it are told by name, and put into a list."""
    if is_function(value):
        functions.append(value)
        return _name(value.func)
    if isinstance(value, np.ndarray) and not value.dtype.hasobject:
        return digest_of(value)
    if isinstance(value, dict):
        return "dict", [[_walked(part, functions) for part in item] for item in value.items()]
    if isinstance(value, set | frozenset):
        return "set", sorted(repr(_walked(part, functions)) for part in value)
    if isinstance(value, list | tuple | np.ndarray):
        return type(value).__name__, [_walked(part, functions) for part in value]
    return _WHERE.sub("", _number(value))


def _definitions(function: wp.Function) -> list[wp.Function]:
    """All definitions of a function's name, for other types of arguments."""
    known = sorted((function.user_overloads | function.user_templates).items())
    return [one for _, one in known if one.generic_parent is None] or [function]


def _named(function: wp.Function) -> Iterator[tuple[str, Any]]:
    """(name, value) of all that a function's source names outside of itself."""
    known = getclosurevars(function.func)
    return ((name, value) for name, value in (known.nonlocals | known.globals).items() if not isinstance(value, ModuleType))


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
