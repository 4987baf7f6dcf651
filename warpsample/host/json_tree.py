"""JSON of a file, whose values are checked as they are read. Errors name a value by its path in the JSON."""

import json
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np

from warpsample.host.arguments import check_flag, check_integer, quote


@dataclass(frozen=True)
class Part:
    """JSON object that checks the type of each member when the member is read.

    Attributes:
        content: members by name.
        path: path of the object in the JSON, as "nodes[3]"; "" for the whole.
    """

    content: dict[str, Any]
    path: str = ""

    def __contains__(self, key: str) -> bool:
        """Return whether the JSON object has a member with the given name."""
        return key in self.content

    def at(self, key: str) -> str:
        """Return the path of a member in the JSON document, for error messages: "nodes[3].mesh" for example."""
        return f"{self.path}.{key}" if self.path else key

    def flag(self, key: str) -> bool:
        """Return a member that is true or false; False if the member is missing."""
        return check_flag(self.content.get(key, False), self.at(key))

    def whole(self, key: str, default: int | None = None, high: int = 2**62) -> int:
        """Return a member that is a whole number from 0 to `high`; if it is missing, the default, or else an error."""
        return check_integer(self._member(key, default), self.at(key), 0, high)

    def reals(self, key: str, default: Sequence[float]) -> np.ndarray:
        """Return a JSON list of finite numbers as a float64 array; the list must be as long as `default`, its default."""
        values = self.values(key, default)
        finite = [value for value in values if type(value) in (int, float) and abs(value) <= sys.float_info.max]
        if not len(finite) == len(values) == len(default):
            raise ValueError(f"{self.at(key)}: got {quote(values)}, want {len(default)} finite numbers")
        return np.array(finite, np.float64)

    def text(self, key: str) -> str:
        """Return a member that is a string; raise a ValueError if it is missing."""
        return _of_kind(self._member(key, None), self.at(key), str, "a text")

    def texts(self, key: str) -> list[str]:
        """Return a member that is a list of strings; empty if the member is missing."""
        return [_of_kind(value, f"{self.at(key)}[{i}]", str, "a text") for i, value in enumerate(self.values(key))]

    def part(self, key: str) -> "Part":
        """Return a member that is a JSON object; raise a ValueError if it is missing."""
        return Part(_of_kind(self._member(key, None), self.at(key), dict, "an object"), self.at(key))

    def parts(self, key: str) -> list["Part"]:
        """Return a member that is a list of JSON objects; empty if the member is missing."""
        members = ((value, f"{self.at(key)}[{i}]") for i, value in enumerate(self.values(key)))
        return [Part(_of_kind(value, path, dict, "an object"), path) for value, path in members]

    def members(self, key: str) -> dict[str, "Part"]:
        """Return the members of a JSON object whose members are objects themselves, keyed by name."""
        whole = self.part(key)
        return {
            name: Part(_of_kind(value, whole.at(name), dict, "an object"), whole.at(name))
            for name, value in whole.content.items()
        }

    def index(self, key: str, among: Sequence[Any], default: int | None = None) -> int:
        """Return a member that is an index into `among`; if it is missing, the default, or else an error."""
        return _index(self._member(key, default), self.at(key), among)

    def indices(self, key: str, among: Sequence[Any]) -> list[int]:
        """Return a member that is a list of indices into `among`; empty if the member is missing."""
        return [_index(value, f"{self.at(key)}[{i}]", among) for i, value in enumerate(self.values(key))]

    def _member(self, key: str, default: Any) -> Any:
        """Return the value of a member, or the default; raise a ValueError if the member is missing and has no default."""
        if key not in self.content and default is None:
            raise ValueError(f"the JSON member {self.at(key)} is missing")
        return self.content.get(key, default)

    def values(self, key: str, default: Sequence[Any] = ()) -> Sequence[Any]:
        """Return a member that is a list of values of any type; the default if the member is missing."""
        return _of_kind(self.content[key], self.at(key), list, "a list") if key in self.content else default


def parsed(content: bytes) -> Part:
    """Parse a JSON text in UTF-8, and return its top-level object.

    Raises:
        ValueError: the text is no JSON object, an object has two members of one name, or a number is NaN, infinite or of
            thousands of digits.
    """
    try:
        found = json.loads(content, object_pairs_hook=_object, parse_constant=_refuse_constant)
    except RecursionError:
        raise ValueError("the JSON is nested too deeply") from None
    except UnicodeDecodeError:
        raise ValueError("the JSON is not encoded in UTF-8") from None
    except ValueError as error:
        if "set_int_max_str_digits" in str(error):
            raise ValueError(f"the JSON has a number of more than {sys.get_int_max_str_digits():,} digits") from None
        raise
    if not isinstance(found, dict):
        raise ValueError(f"the JSON is {quote(found)}, want an object")
    return Part(found)


def split_documents(content: bytes) -> list[bytes]:
    """Return the JSON texts in a file: the lines of a sequence such as CityJSONSeq, or the whole content of another file.

    A sequence has several lines, and its first line is a JSON document.
    """
    first, _, rest = content.partition(b"\n")
    try:
        is_sequence = bool(first.strip() and rest.strip() and json.loads(first))
    except (ValueError, RecursionError):
        is_sequence = False
    return [first, *rest.split(b"\n")] if is_sequence else [content]


def check_finite(tree: Part) -> None:
    """Raise a ValueError for the first number that is infinite in float64, as 1e400: JSON has no infinite numbers."""
    left: list[tuple[str, Any]] = [("", tree.content)]
    while left:
        path, value = left.pop()
        if isinstance(value, float) and not isfinite(value):
            raise ValueError(f"{path}: got a number beyond {sys.float_info.max:.2g}, want one that float64 holds")
        if isinstance(value, dict):
            left += [(Part(value, path).at(key), member) for key, member in reversed(value.items())]
        elif isinstance(value, list):
            left += [(f"{path}[{i}]", member) for i, member in reversed(list(enumerate(value)))]


def collect_names(content: Any, key: str) -> set[str]:
    """Return the names of the members of all JSON objects that are themselves members with the name `key`, at any depth."""
    found, left = set[str](), [content]
    while left:
        value = left.pop()
        if isinstance(value, dict):
            found |= set(value[key]) if isinstance(value.get(key), dict) else set()
            left += value.values()
        elif isinstance(value, list):
            left += value
    return found


def _object(members: list[tuple[str, Any]]) -> dict[str, Any]:
    """Return a dictionary of a JSON object's members; raise a ValueError if two members have one name."""
    made = dict(members)
    if len(made) < len(members):
        name, _ = Counter(name for name, _ in members).most_common(1)[0]
        raise ValueError(f"the JSON has an object with two members {quote(name)}, want each name once")
    return made


def _refuse_constant(name: str) -> float:
    raise ValueError(f"the JSON has the number {name}, want finite numbers")


def _of_kind(value: Any, path: str, kind: type, wants: str) -> Any:
    """Check that a JSON value is of a Python type, and return it; raise a TypeError otherwise."""
    if not isinstance(value, kind):
        raise TypeError(f"{path}: got {quote(value)}, want {wants}")
    return value


def _index(value: Any, path: str, among: Sequence[Any]) -> int:
    return check_integer(value, path, 0, len(among) - 1, f"a whole number below {len(among)}, which is how many there are")
