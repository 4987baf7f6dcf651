"""JSON documents of a CityJSON file: a single one, or one per line of a sequence (CityJSONSeq).

A document is parsed once to read its surfaces. It is parsed again to write results, keeping the spelling of each number.
"""

import json
import re
import secrets
from collections.abc import Callable
from typing import Any

from warpsample.host.json_tree import Part, parsed, split_documents

_HEAD, _FEATURE = "CityJSON", "CityJSONFeature"
_VERSION = re.compile(r"[12]\.\d")


def read_each(content: bytes, read: Callable[[int, Part], None]) -> None:
    """Parse each JSON document of a CityJSON file and pass it to `read(number, document)`.

    Raises:
        ValueError: a document is damaged or has another type or version, or `read` raises a TypeError or ValueError. For a
            sequence, the message names the line.
    """
    lines, number = split_documents(content), 0
    for at, line in enumerate(lines, 1):
        if line.strip():
            try:
                read(number, _check_header(parsed(line), _FEATURE if number else _HEAD))
            except (ValueError, TypeError) as error:
                raise ValueError(f"line {at}: {error}" if len(lines) > 1 else str(error)) from None
            number += 1


def rewrite_content(content: bytes, edit: Callable[[int, dict[str, Any]], None]) -> bytes:
    """Return the bytes of a CityJSON file after `edit(number, document)` has changed each JSON document.

    Members keep their order and numbers their spelling; white space between members is removed.
    """
    made, number = [], 0
    for line in split_documents(content):
        text = line.strip()
        if text:
            made.append(_edit_text(text, lambda found, number=number: edit(number, found)) + line[len(line.rstrip()) :])
            number += 1
        else:
            made.append(line)
    return b"\n".join(made)


def _check_header(tree: Part, kind: str) -> Part:
    found = tree.text("type")
    if found != kind:
        raise ValueError(f"the JSON has the type {found!r}, want {kind!r}")
    if kind == _HEAD and not _VERSION.match(tree.text("version")):
        raise ValueError(f"the CityJSON version is {tree.text('version')!r}, want 1.0, 1.1 or 2.0")
    return tree


class _SpelledNumber:
    """Number read from JSON that is written back with its original digits; equal to the number."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __eq__(self, other: object) -> bool:
        return float(self.text) == other

    def __hash__(self) -> int:
        return hash(float(self.text))


def _parse_float(text: str) -> float | _SpelledNumber:
    number = float(text)
    return number if repr(number) == text else _SpelledNumber(text)


def _parse_int(text: str) -> int | _SpelledNumber:
    return int(text) if text != "-0" else _SpelledNumber(text)


def _edit_text(text: bytes, edit: Callable[[dict[str, Any]], None]) -> bytes:
    found = json.loads(text, parse_float=_parse_float, parse_int=_parse_int)
    edit(found)
    mark = secrets.token_hex(16)  # marks numbers in the output, since the JSON encoder cannot write raw text
    options = {"separators": (",", ":"), "ensure_ascii": text.isascii()}
    try:
        made = json.dumps(found, default=lambda number: f"{mark}{number.text}", **options)
    except RecursionError:  # the limit is reached earlier than in parsing, since the stack is deeper here
        raise ValueError("the JSON is nested too deeply") from None
    return re.sub(f'"{mark}([^"]*)"', r"\1", made).encode("utf-8", "backslashreplace")
