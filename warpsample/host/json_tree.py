"""The JSON of a file: what is read from it is checked there and then, and what is wrong is named by its JSON path."""

import json
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np

from warpsample.host.arguments import check_flag, check_integer, told


@dataclass(frozen=True)
class Part:
    """An object of the JSON, and its path there, as "nodes[3]"; that of the whole is ""."""

    content: dict[str, Any]
    path: str = ""

    def __contains__(self, key: str) -> bool:
        """Whether it has a member of that name."""
        return key in self.content

    def at(self, key: str) -> str:
        """Where a member stands."""
        return f"{self.path}.{key}" if self.path else key

    def flag(self, key: str) -> bool:
        """True or false; false if it is not there."""
        return check_flag(self.content.get(key, False), self.at(key))

    def whole(self, key: str, default: int | None = None, high: int = 2**62) -> int:
        """A whole number from 0 on; one without a default must be there."""
        return check_integer(self._member(key, default), self.at(key), 0, high)

    def reals(self, key: str, default: Sequence[float]) -> np.ndarray:
        """The list of finite numbers under a key, as many as the default has."""
        values = self.values(key, default)
        finite = [value for value in values if type(value) in (int, float) and abs(value) <= sys.float_info.max]
        if not len(finite) == len(values) == len(default):
            raise ValueError(f"{self.at(key)}: got {told(values)}, want {len(default)} finite numbers")
        return np.array(finite, np.float64)

    def text(self, key: str) -> str:
        """A text, which must be there."""
        return _of_kind(self._member(key, None), self.at(key), str, "a text")

    def texts(self, key: str) -> list[str]:
        """A list of texts; empty if it is not there."""
        return [_of_kind(value, f"{self.at(key)}[{i}]", str, "a text") for i, value in enumerate(self.values(key))]

    def part(self, key: str) -> "Part":
        """An object, which must be there."""
        return Part(_of_kind(self._member(key, None), self.at(key), dict, "an object"), self.at(key))

    def parts(self, key: str) -> list["Part"]:
        """A list of objects; empty if it is not there."""
        members = ((value, f"{self.at(key)}[{i}]") for i, value in enumerate(self.values(key)))
        return [Part(_of_kind(value, path, dict, "an object"), path) for value, path in members]

    def members(self, key: str) -> dict[str, "Part"]:
        """The objects that are the members of one, by name; there must be one."""
        whole = self.part(key)
        return {
            name: Part(_of_kind(value, whole.at(name), dict, "an object"), whole.at(name))
            for name, value in whole.content.items()
        }

    def index(self, key: str, among: Sequence[Any], default: int | None = None) -> int:
        """The number of one of several items; one without a default must be there."""
        return _index(self._member(key, default), self.at(key), among)

    def indices(self, key: str, among: Sequence[Any]) -> list[int]:
        """The numbers of some of several items; empty if they are not there."""
        return [_index(value, f"{self.at(key)}[{i}]", among) for i, value in enumerate(self.values(key))]

    def _member(self, key: str, default: Any) -> Any:
        if key not in self.content and default is None:
            raise ValueError(f"{self.at(key)} is missing")
        return self.content.get(key, default)

    def values(self, key: str, default: Sequence[Any] = ()) -> Sequence[Any]:
        """A list, of whatever there is; the default if it is not there."""
        return _of_kind(self.content[key], self.at(key), list, "a list") if key in self.content else default


def parsed(content: bytes) -> Part:
    """The whole of a JSON text.

    No object, a name that is twice in one, and what JSON does not know, as NaN, are a ValueError.
    """
    try:
        found = json.loads(content, object_pairs_hook=_object, parse_constant=_refuse_constant)
    except RecursionError:
        raise ValueError("its JSON is nested too deeply") from None
    except UnicodeDecodeError:
        raise ValueError("its JSON is no UTF-8") from None
    if not isinstance(found, dict):
        raise ValueError(f"its JSON is {told(found)}, want an object")
    return Part(found)


def check_finite(tree: Part) -> None:
    """Raise a ValueError that names the first number beyond float64, such as 1e400, which JSON cannot write again."""
    left: list[tuple[str, Any]] = [("", tree.content)]
    while left:
        path, value = left.pop()
        if isinstance(value, float) and not isfinite(value):
            raise ValueError(f"{path}: got a number beyond {sys.float_info.max:.2g}, want one that float64 holds")
        if isinstance(value, dict):
            left += [(Part(value, path).at(key), member) for key, member in reversed(value.items())]
        elif isinstance(value, list):
            left += [(f"{path}[{i}]", member) for i, member in reversed(list(enumerate(value)))]


def _object(members: list[tuple[str, Any]]) -> dict[str, Any]:
    made = dict(members)
    if len(made) < len(members):
        name, _ = Counter(name for name, _ in members).most_common(1)[0]
        raise ValueError(f"its JSON has an object with two members {told(name)}")
    return made


def _refuse_constant(name: str) -> float:
    raise ValueError(f"its JSON has the number {name}, want finite ones")


def _of_kind(value: Any, path: str, kind: type, wants: str) -> Any:
    if not isinstance(value, kind):
        raise TypeError(f"{path}: got {told(value)}, want {wants}")
    return value


def _index(value: Any, path: str, among: Sequence[Any]) -> int:
    return check_integer(value, path, 0, len(among) - 1, f"a whole number below {len(among)}, which is how many there are")
