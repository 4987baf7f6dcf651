"""Reader of .ply files, as text or binary of either byte order.

plyfile 1.1.5 is not used, because 14 of our 42 tests fail with it. It allocates whatever a header declares (2.7 GB for 3 *
10^8 faces in 200 bytes), ignores data after the last row, accepts "1_0" as a number and a fraction as the length of a list,
and rounds text to the declared type. It takes 2.7 s for 10^6 triangles, which one NumPy call reads in 0.01 s. From a
truncated text of 80 faces, trimesh 5.2 reads 72, and VTK 9.7 reads 80, some of them uninitialized memory; a truncated binary
file crashes VTK.
"""

from array import array
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from io import SEEK_CUR, SEEK_END
from itertools import islice
from pathlib import Path
from typing import Any, BinaryIO, Literal

import numpy as np

from warpsample.mesh.files.text import real, whole
from warpsample.mesh.polygons import triangles

_KINDS = {
    "char": "i1",
    "uchar": "u1",
    "short": "i2",
    "ushort": "u2",
    "int": "i4",
    "uint": "u4",
    "float": "f4",
    "double": "f8",
}
_KINDS |= {f"{name}{8 * size}": f"{name[0]}{size}" for name in ("int", "uint") for size in (1, 2, 4, 8)}
_KINDS |= {"float32": "f4", "float64": "f8"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_LONGEST = 4096  # largest number of bytes in a header line


@dataclass(frozen=True)
class _Property:
    name: str
    kind: np.dtype
    count_kind: np.dtype | None = None  # type of a list's length; None: not a list


@dataclass(frozen=True)
class _Element:
    name: str
    count: int
    properties: list[_Property] = field(default_factory=list)

    def check(self, is_text: bool, size: int) -> None:
        """Raise a ValueError if a file with `size` more bytes is too short for the number of rows in the header."""
        least = sum(2 if is_text else (p.count_kind or p.kind).itemsize for p in self.properties)
        if not 0 <= self.count * least <= size + 1 or (self.count and not least):
            raise self.cut(f"{size:,} bytes follow")

    def cut(self, found: str) -> ValueError:
        """Return the ValueError for an element with fewer rows than the header declares; `found` states what follows."""
        return ValueError(f"the header declares {self.count:,} elements '{self.name}', but {found}")


def read(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Read vertices and triangles of a .ply file; polygons are cut into triangles.

    Raises:
        ValueError: A header without vertices or faces, or more or less data than the header declares.
    """
    return _mesh(read_elements(path))


def read_corners(path: Path, names: Sequence[str]) -> np.ndarray | None:
    """Read properties of a .ply file's vertices at all face corners, (F, 3, k) float64; None if one is missing.

    Raises:
        ValueError: As for `read`.
    """
    if not set(names) <= read_names(path):
        return None
    found = read_elements(path)
    return np.stack([found["vertex"][name] for name in names], axis=1, dtype=np.float64)[_mesh(found)[1]]


def read_names(path: Path) -> set[str]:
    """Read the names of the vertex properties that the header of a .ply file declares."""
    with path.open("rb") as file:
        return {p.name for element in _header(file)[1] if element.name == "vertex" for p in element.properties}


def read_elements(path: Path) -> dict[str, dict[str, Any]]:
    """Read all data of a .ply file: arrays keyed by the name of the element, then of the property.

    Raises:
        ValueError: More or less data than the header declares.
    """
    with path.open("rb") as file:
        order, elements = _header(file)
        size = path.stat().st_size - file.tell()
        for element in elements:
            element.check(order == "", size)
        if order:
            found = {element.name: _binary(file, element) for element in elements}
            rest = file.read(1)
        else:
            rows = (line.split() for line in file if not line.isspace())
            found = {element.name: _text(rows, element) for element in elements}
            rest = next(rows, b"")
    if rest:
        raise ValueError("the file has more data than the header declares")
    return found


def _mesh(found: dict[str, dict[str, Any]]) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices (V, 3) and triangles (F, 3) from the data of a .ply file."""
    vertex, face = found.get("vertex", {}), found.get("face", {})
    polygons = face.get("vertex_indices", face.get("vertex_index"))
    if not {"x", "y", "z"} <= vertex.keys() or not isinstance(polygons, tuple):
        raise ValueError(
            "the header declares no vertices, or no faces; want vertices with x, y, z and faces with vertex_indices"
        )
    if "tristrips" in found:
        raise ValueError("the file has triangle strips, want separate faces; export the mesh as triangles")
    if polygons[1].dtype.kind == "f":
        raise ValueError("the header declares vertex_indices of a type with fractions, want whole numbers, such as int")
    vertices = np.stack([vertex[axis] for axis in "xyz"], axis=1, dtype=np.float64)
    return vertices, triangles(vertices, *polygons)


def _header(file: BinaryIO) -> tuple[str, list[_Element]]:
    """Read the header of a .ply file; return (byte order, "" for text; declared elements)."""
    if file.readline(_LONGEST).split() != [b"ply"]:
        raise ValueError("the file does not begin with 'ply'")
    order, elements, line = None, [], ""
    try:
        while (line := file.readline(_LONGEST).decode("latin-1")).split() != ["end_header"]:
            match line.split():
                case ["format", name, _]:
                    order = _ORDERS[name]
                case ["element", name, count]:
                    elements.append(_Element(name, whole(count)))
                case ["property", "list", count_kind, kind, name]:
                    elements[-1].properties.append(_Property(name, _kind(order, kind), _kind(order, count_kind, "iu")))
                case ["property", kind, name]:
                    elements[-1].properties.append(_Property(name, _kind(order, kind)))
                case ["comment" | "obj_info", *_]:
                    pass
                case _:
                    raise ValueError
    except (ValueError, KeyError, IndexError):
        raise ValueError(
            f"the header has {f'the unknown line {line.strip()[:60]!r}' if line else 'no end_header'}"
        ) from None
    if order is None:
        raise ValueError("the header declares no format, want a line such as 'format ascii 1.0'")
    return order, elements


def _kind(order: str | None, name: str, kinds: str = "iuf") -> np.dtype:
    """Return the NumPy type of a type name in a .ply header, for example "float"."""
    kind = np.dtype(_KINDS[name])
    if order is None or kind.kind not in kinds:
        raise ValueError
    return kind.newbyteorder(order) if order else kind


def _text(rows: Iterator[list[bytes]], element: _Element) -> dict[str, Any]:
    """Read the rows of one element of a text .ply; return arrays keyed by property name.

    A list property is a pair (lengths, all numbers).
    """
    lengths, numbers = _empty(element, lambda p: array("d" if p.kind.kind == "f" else "q"))
    steps = [(p.name in lengths, real if p.kind.kind == "f" else whole, p.name) for p in element.properties]
    seen = 0
    for seen, words in enumerate(islice(rows, element.count), 1):
        at, length = 0, 1
        for is_list, parse, name in steps:
            if is_list:
                length = whole(words[at]) if at < len(words) else -1
                lengths[name].append(length)
                at += 1
            numbers[name].extend(map(parse, words[at : at + length]))
            at, length = at + length, 1
        if at != len(words):
            raise ValueError(
                f"row {seen - 1} of '{element.name}' has {len(words)} numbers, more or fewer than the header declares"
            )
    if seen < element.count:
        raise element.cut(f"only {seen:,} follow")
    return _columns(lengths, {name: np.frombuffer(found, found.typecode) for name, found in numbers.items()})


def _binary(file: BinaryIO, element: _Element) -> dict[str, Any]:
    """Read the rows of one element of a binary .ply; return arrays keyed by property name, as `_text` does."""
    start = file.tell()
    left = file.seek(0, SEEK_END) - file.seek(start)
    kind = _first_row(file, element, left)
    file.seek(start)
    rows = np.fromfile(file, kind, element.count if element.count * kind.itemsize <= left else 0)
    lists = {p.name: kind[p.name].shape[0] for p in element.properties if p.count_kind is not None}
    if len(rows) == element.count and all((rows[name + " length"] == length).all() for name, length in lists.items()):
        lengths = {name: np.broadcast_to(length, len(rows)) for name, length in lists.items()}
        return _columns(lengths, {p.name: rows[p.name].ravel() for p in element.properties})
    file.seek(start)
    return _rows(file, element)


def _first_row(file: BinaryIO, element: _Element, left: int) -> np.dtype:
    """Return the NumPy type of an element's rows, assuming that all lists are as long as in the first row."""
    fields: list[tuple] = []
    for p in element.properties:
        if p.count_kind is not None:
            length = int.from_bytes(file.read(p.count_kind.itemsize), _order(p.count_kind))
            length = length if length * p.kind.itemsize <= left else 0
            fields += [(p.name + " length", p.count_kind), (p.name, p.kind, (length,))]
        else:
            fields.append((p.name, p.kind))
        file.seek(np.dtype(fields[-1:]).itemsize, SEEK_CUR)
    return np.dtype(fields)


def _rows(file: BinaryIO, element: _Element) -> dict[str, Any]:
    """Read one element of a binary .ply row by row, since its lists differ in length."""
    start, data, at = file.tell(), file.read(), 0
    lengths, numbers = _empty(element, lambda _: bytearray())
    for _ in range(element.count):
        for p in element.properties:
            length = 1
            if p.count_kind is not None:
                length = int.from_bytes(data[at : at + p.count_kind.itemsize], _order(p.count_kind))
                lengths[p.name].append(length)
                at += p.count_kind.itemsize
            numbers[p.name] += data[at : at + length * p.kind.itemsize]
            at += length * p.kind.itemsize
    if at > len(data):
        raise element.cut(f"{len(data):,} bytes follow")
    file.seek(start + at)
    return _columns(lengths, {p.name: np.frombuffer(numbers[p.name], p.kind) for p in element.properties})


def _empty(element: _Element, make: Callable[[_Property], Any]) -> tuple[dict[str, array], dict[str, Any]]:
    """Return empty containers for the data of an element: one for list lengths, one for numbers."""
    lengths = {p.name: array("q") for p in element.properties if p.count_kind is not None}
    return lengths, {p.name: make(p) for p in element.properties}


def _columns(lengths: dict[str, Any], numbers: dict[str, np.ndarray]) -> dict[str, Any]:
    """Combine list lengths and numbers of an element to a dictionary of its properties."""
    return {name: (np.asarray(lengths[name]), found) if name in lengths else found for name, found in numbers.items()}


def _order(kind: np.dtype) -> Literal["little", "big"]:
    """Return the byte order of a NumPy type as "little" or "big"."""
    return "big" if kind.byteorder == ">" else "little"
