"""The JSON texts of a CityJSON file: one, or in a sequence (CityJSONSeq) one on each line.

A text is read twice: for its surfaces, and again, if results are written, with each number as it is spelt there.
"""

import json
import re
import secrets
from collections.abc import Callable
from typing import Any

from warpsample.host.json_tree import Part, parsed

_HEAD, _FEATURE = "CityJSON", "CityJSONFeature"
_VERSION = re.compile(r"[12]\.\d")


def read_each(content: bytes, read: Callable[[int, Part], None]) -> None:
    """Calls `read` with each object of a file, (its number, the object): the CityJSON, then the features of a sequence.

    Damaged JSON, other objects and other versions are a ValueError, as are those that `read` raises and its TypeErrors; in a
    sequence they name the line.
    """
    lines, number = _split_lines(content), 0
    for at, line in enumerate(lines, 1):
        if line.strip():
            try:
                read(number, _check_header(parsed(line), _FEATURE if number else _HEAD))
            except (ValueError, TypeError) as error:
                raise ValueError(f"line {at}: {error}" if len(lines) > 1 else str(error)) from None
            number += 1


def rewrite_content(content: bytes, edit: Callable[[int, dict[str, Any]], None]) -> bytes:
    """The file with its objects changed by `edit`, (number of the object, the object), and else the same JSON.

    Members keep their order and numbers their spelling; there is no white space between them.
    """
    made, number = [], 0
    for line in _split_lines(content):
        text = line.strip()
        if text:
            made.append(_edit_text(text, lambda found, number=number: edit(number, found)) + line[len(line.rstrip()) :])
            number += 1
        else:
            made.append(line)
    return b"\n".join(made)


def _split_lines(content: bytes) -> list[bytes]:
    """The lines of a sequence, the first of which is not empty; or all as one."""
    first, _, rest = content.partition(b"\n")
    try:
        is_sequence = bool(first.strip() and rest.strip() and json.loads(first))
    except (ValueError, RecursionError):
        is_sequence = False
    return [first, *rest.split(b"\n")] if is_sequence else [content]


def _check_header(tree: Part, kind: str) -> Part:
    found = tree.text("type")
    if found != kind:
        raise ValueError(f"its type is {found!r}, want {kind!r}")
    if kind == _HEAD and not _VERSION.match(tree.text("version")):
        raise ValueError(f"its version is {tree.text('version')!r}, want 1.0, 1.1 or 2.0")
    return tree


class _SpelledNumber:
    """A number that Python would spell otherwise."""

    def __init__(self, text: str) -> None:
        self.text = text


def _parse_float(text: str) -> float | _SpelledNumber:
    number = float(text)
    return number if repr(number) == text else _SpelledNumber(text)


def _edit_text(text: bytes, edit: Callable[[dict[str, Any]], None]) -> bytes:
    found = json.loads(text, parse_float=_parse_float)
    edit(found)
    mark = secrets.token_hex(16)  # around the numbers, as JSON's encoder writes no text as it is
    options = {"separators": (",", ":"), "ensure_ascii": text.isascii()}
    try:
        made = json.dumps(found, default=lambda number: f"{mark}{number.text}", **options)
    except RecursionError:  # which is reached sooner by a call from further down
        raise ValueError("its JSON is nested too deeply") from None
    return re.sub(f'"{mark}([^"]*)"', r"\1", made).encode("utf-8", "backslashreplace")
