"""Readers of .obj and .off files.

trimesh, meshio and VTK are not used: from a truncated .obj of 80 faces all three read 72, and so does trimesh from an .off.
Such a loss cannot be detected without parsing the file again. trimesh also drops broken lines and relative indices of an
.obj, and cannot read an .off whose polygons have different numbers of corners.
"""

import re
from array import array
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from math import nan
from pathlib import Path
from typing import NamedTuple

import numpy as np

from warpsample.mesh.parts import Named
from warpsample.mesh.polygons import corner_triangles, triangles

_NAMING = ("o", "g", "usemtl")
# First words of the lines of an .obj that make no surface: other vertex data, lines and points.
_NO_SURFACE = {"vt", "vn", "vp", "l", "p", "s", "mg", "lod", "bevel", "c_interp", "d_interp", "mtllib"}
_NO_SURFACE |= {"usemap", "maplib", "shadow_obj", "trace_obj"}


def read_obj(path: Path) -> Named:
    """Read vertices, faces and named parts of an .obj file; polygons are cut into triangles.

    Faces with the same object, group and material ("o", "g", "usemtl") form a part. Its name joins these names by "/".

    An .obj declares no counts, so a truncated file cannot always be detected. Detected are a line with too few numbers, a
    face with fewer than three corners or with corners of different kinds, and a face with missing vertices. A file that ends
    after three or more corners of its last face raises no error.

    Raises:
        ValueError: A line that cannot be read; the message gives the number of the line.
    """
    positions, lengths, corners, number = array("d"), array("i"), array("i"), 0
    given, parts, part = dict.fromkeys(_NAMING, ""), {"": 0}, array("i")
    try:
        for number, words in numbered(path, joins=True):  # noqa: B007  (the error names it)
            if words[0] == "v":
                positions.extend(three(words[1:]))
            elif words[0] == "f":
                face = _corners(words[1:], len(positions) // 3)
                lengths.append(len(face))
                corners.extend(face)
                name = "/".join(filter(None, given.values()))
                part.append(parts.setdefault(name, len(parts)))
            elif words[0] in given:
                given[words[0]] = " ".join(words[1:])
            elif words[0] not in _NO_SURFACE:
                raise ValueError(f"the keyword {words[0][:20]!r} is unknown")
    except ValueError as error:
        raise ValueError(f"line {number}: {error}") from None
    vertices, faces = _cut(positions, lengths, corners)
    return vertices, faces, *_used(np.repeat(np.array(part, np.int32), np.array(lengths, np.int64) - 2), list(parts))


def read_obj_uv(path: Path) -> np.ndarray:
    """Read the texture coordinates of an .obj at all face corners, (F, 3, 2), v upward; NaN for faces without any.

    Raises:
        ValueError: A line that cannot be read; the message gives the number of the line.
    """
    return _read_obj_corners(path, _UV)


def read_obj_normals(path: Path) -> np.ndarray | None:
    """Read the normals of an .obj at all face corners, (F, 3, 3); NaN for faces without any, None for a file without any.

    Raises:
        ValueError: A line that cannot be read; the message gives the number of the line.
    """
    return _read_obj_corners(path, _NORMALS) if has_obj_lines(path, _NORMALS.keyword) else None


def has_obj_lines(path: Path, keyword: str) -> bool:
    """Return whether an .obj file has lines with a keyword such as "vt", whatever their values."""
    with path.open(encoding="utf-8-sig", errors="replace") as file:  # all ends of lines
        return any(line.split(None, 1)[:1] == [keyword] for line in file)


class _CornerData(NamedTuple):
    """Kind of values at corners of faces in an .obj: keyword, place between slashes, width, parser, and name in errors."""

    keyword: str
    column: int
    width: int
    parse: Callable[[list[str]], Iterable[float]]
    name: str


def _two(words: list[str]) -> list[float]:
    """Parse texture coordinates; v is 0 for a single number."""
    return [real(word) for word in (*words, "0" if words else "", "")[:2]]


def _read_obj_corners(path: Path, kind: _CornerData) -> np.ndarray:
    """Read values of an .obj at all face corners, (F, 3, width); NaN for faces without any."""
    positions, values, number = array("d"), array("d", kind.width * (nan,)), 0
    lengths, corners, named = array("i"), array("i"), array("i")
    try:
        for number, words in numbered(path, joins=True):  # noqa: B007  (the error names it)
            if words[0] == "v":
                positions.extend(three(words[1:]))
            elif words[0] == kind.keyword:
                values.extend(kind.parse(words[1:]))
            elif words[0] == "f":
                corners.extend(_corners(words[1:], len(positions) // 3))
                has_none = words[1].split("/")[kind.column : kind.column + 1] in ([], [""])
                count = len(values) // kind.width - 1
                named.extend([0] * len(words[1:]) if has_none else _indices(words[1:], count, kind))
                lengths.append(len(words) - 1)
    except ValueError as error:
        raise ValueError(f"line {number}: {error}") from None
    polygons = np.frombuffer(lengths, "i"), np.frombuffer(corners, "i")
    cut = corner_triangles(np.frombuffer(positions).reshape(-1, 3), *polygons)
    return np.frombuffer(values).reshape(-1, kind.width)[np.frombuffer(named, "i")[cut]]


def _indices(words: list[str], count: int, kind: _CornerData) -> list[int]:
    """Parse a face line of an .obj; return the 1-based indices of its texture coordinates or normals."""
    found = [index + 1 for index in _corners(words, count, kind.column)]
    if not 1 <= min(found) <= max(found) <= count:
        raise ValueError(f"a face has the {kind.name} {min(found)} to {max(found)}, want 1 to {count}")
    return found


def _used(part: np.ndarray, names: list[str]) -> tuple[np.ndarray | None, list[str]]:
    """Return the part number of each face and the parts' names, without parts that have no faces.

    If no part has a name, return (None, []).
    """
    if len(names) == 1:
        return None, []
    used, part = np.unique(part, return_inverse=True)
    return part.astype(np.int32), [names[number] for number in used.tolist()]


def read_off(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Read vertices and faces of an .off file; polygons are cut into triangles, colours and normals are ignored.

    Raises:
        ValueError: Another header, more or fewer lines than declared, or a line that cannot be read.
    """
    lines = (words for _, words in numbered(path))
    keyword, *counts = next(lines, [""])
    if not re.fullmatch("(ST)?C?N?OFF", keyword) or counts[:1] == ["BINARY"]:
        raise ValueError("the file does not begin with 'OFF'")
    counts = counts or next(lines, [])
    if len(counts) < 2 or not all(map(str.isdecimal, counts)):
        raise ValueError("the header declares no numbers of vertices and faces")
    vertices, faces = map(int, counts[:2])
    positions, lengths, corners = array("d"), array("i"), array("i")
    for words in islice(lines, vertices):
        positions.extend(three(words))
    for words in islice(lines, faces):
        face = [whole(word) for word in words[1 : 1 + whole(words[0])]]
        if len(face) != whole(words[0]):
            raise ValueError(f"face {len(lengths)} ends after {len(face)} of {words[0]} corners")
        lengths.append(len(face))
        corners.extend(face)
    if (len(positions), len(lengths)) != (3 * vertices, faces) or next(lines, None):
        found = f"holds {len(positions) // 3:,} and {len(lengths):,}" if len(lengths) < faces else "continues after them"
        raise ValueError(f"the header declares {vertices:,} vertices and {faces:,} faces, but the file {found}")
    return _cut(positions, lengths, corners)


def numbered(path: Path, joins: bool = False) -> Iterator[tuple[int, list[str]]]:
    """Yield (line number, words) of each line of a text file that is not empty, without comments.

    With `joins`, a backslash at the end of a line continues the line.
    """
    held = ""
    with path.open(encoding="utf-8-sig", errors="replace") as file:
        for number, line in enumerate(file, 1):
            if joins and line.endswith("\\\n"):
                held += line[:-2] + " "
                continue
            words = (held + line).partition("#")[0].split()
            held = ""
            if words:
                yield number, words
    if held:
        raise ValueError("the file ends within a line")


def three(words: list[str]) -> list[float]:
    """Parse the three coordinates of a vertex from the words of a line; further numbers are ignored."""
    if len(words) < 3:
        raise ValueError(f"a vertex has {len(words)} numbers, want at least 3")
    return [real(word) for word in words[:3]]


def real(word: str | bytes) -> float:
    """Parse a number in a text file as a float."""
    try:
        return float(_plain(word))
    except ValueError:
        raise ValueError(f"{_quote(word)} is not a number") from None


def whole(word: str | bytes) -> int:
    """Parse a whole number in a text file as an int."""
    try:
        return int(_plain(word))
    except ValueError:
        raise ValueError(f"{_quote(word)} is not a whole number") from None


def _quote(word: str | bytes) -> str:
    """Return a word in quotes for an error message, shortened to 60 characters."""
    return ascii(word if isinstance(word, str) else word.decode("latin-1"))[:60]


def _plain(word: str | bytes) -> str | bytes:
    """Return a word unchanged; raise a ValueError if it is a number only to Python, for example 1_0.

    Digits of other scripts raise the error, too.
    """
    if {"_", "\\"} & set(ascii(word)):
        raise ValueError
    return word


def _corners(words: list[str], vertices: int, column: int = 0) -> list[int]:
    """Parse a face line of an .obj; return the 0-based indices of its vertices.

    Indices of the file are 1-based, or count back from the last vertex, which is -1. `column` selects the number between
    slashes.
    """
    parts = [word.split("/") for word in words]
    if len({tuple(map(bool, part)) for part in parts}) != 1 or len(parts) < 3:
        raise ValueError(
            f"{' '.join(words)[:60]!r} is not a face, want at least 3 corners, all in the same form, such as 1/1"
        )
    indices = [whole(part[column]) for part in parts]
    if 0 in indices:
        raise ValueError("a face has the vertex 0, but vertices count from 1")
    if max(map(abs, indices)) >= 2**31:
        raise ValueError(f"a face has the vertex {max(indices, key=abs):.3g}, want an index below 2^31")
    return [index - 1 if index > 0 else vertices + index for index in indices]


def _cut(positions: array, lengths: array, corners: array) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices (V, 3) and triangles (F, 3) from flat arrays of coordinates, corner counts and corners."""
    vertices = np.frombuffer(positions).reshape(-1, 3)
    return vertices, triangles(vertices, np.frombuffer(lengths, "i"), np.frombuffer(corners, "i"))


_UV = _CornerData("vt", 1, 2, _two, "texture coordinates")
_NORMALS = _CornerData("vn", 2, 3, three, "normals")
