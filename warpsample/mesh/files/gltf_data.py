"""Buffers of a glTF file, and the arrays that its accessors describe."""

import re
from base64 import b64decode
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote

import numpy as np

from warpsample.host.arguments import check_file, quote
from warpsample.host.engine import check_memory
from warpsample.host.json_tree import Part, parsed

_WHOLE = {5121: "<u1", 5123: "<u2", 5125: "<u4"}
_KINDS = {**_WHOLE, 5120: "<i1", 5122: "<i2", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_COPIES = 8  # memory for an array of zeros and what a reader computes from it, in sizes of the array
_SCHEME = re.compile("[A-Za-z][A-Za-z0-9+.-]+:")  # scheme of a URI; one letter is a drive of Windows


@dataclass(frozen=True)
class Data:
    """Binary data of a glTF file, from which the arrays described in its JSON are read."""

    accessors: list[Part]
    views: list[Part]
    buffers: list[memoryview]

    @classmethod
    def of(cls, tree: Part, path: Path, chunk: memoryview) -> "Data":
        """Load the binary data that the JSON of a glTF file refers to; `chunk` is the binary part of a .glb."""
        return cls(tree.parts("accessors"), tree.parts("bufferViews"), _buffers(path, tree.parts("buffers"), chunk))

    def vectors(self, by: Part, key: str, width: int = 3) -> np.ndarray:
        """Return the array of vectors, (V, width), that the JSON member by[key] refers to.

        Normalized integers become float64.

        Without a copy, unless the numbers are normalized.
        """
        accessor, found = self._numbers(by, key, shape=f"VEC{width}", width=width, kinds=_KINDS)
        if not accessor.flag("normalized"):
            return found
        if found.dtype.itemsize == 4:
            raise ValueError(f"{accessor.at('normalized')}: got 32-bit numbers, want numbers of 8 or 16 bits")
        return np.maximum(found / np.iinfo(found.dtype).max, -1.0)

    def indices(self, by: Part, key: str) -> np.ndarray:
        """Return the array of integers, (N,), that the JSON member by[key] refers to, without a copy."""
        return self._numbers(by, key, shape="SCALAR", width=1, kinds=_WHOLE)[1].ravel()

    def matrices(self, by: Part, key: str) -> np.ndarray:
        """Return the array of matrices for row vectors, (N, 4, 4) float64, that the JSON member by[key] refers to."""
        found = self._numbers(by, key, shape="MAT4", width=16, kinds={5126: "<f4"})[1]
        return found.astype(np.float64).reshape(-1, 4, 4)

    def rows(self, by: Part, key: str) -> tuple[Part, np.ndarray]:
        """Return the glTF accessor that the JSON member by[key] refers to, and its array, (V, k), of any type."""
        shape = self.accessors[by.index(key, self.accessors)].text("type")
        if shape not in _WIDTHS:
            raise ValueError(f"{by.at(key)}: got an accessor of type {quote(shape)}, want one of {', '.join(_WIDTHS)}")
        return self._numbers(by, key, shape=shape, width=_WIDTHS[shape], kinds=_KINDS | _WHOLE)

    def picture(self, image: Part, path: Path) -> bytes:
        """Return the bytes of a picture that is in the file `path`, or in a file relative to `path`."""
        if "uri" in image:
            return bytes(content_of(path, image.text("uri"), 0, image))
        return bytes(self._view(self.views[image.index("bufferView", self.views)]))

    def _numbers(self, by: Part, key: str, *, shape: str, width: int, kinds: Mapping[int, str]) -> tuple[Part, np.ndarray]:
        """Return a glTF accessor and its array, (V, width), after checks of type and bounds."""
        accessor = self.accessors[by.index(key, self.accessors)]
        if "sparse" in accessor:
            raise ValueError(
                "the file has sparse accessors, want a file that stores all numbers; export it without sparse accessors"
            )
        found, code, count = accessor.text("type"), accessor.whole("componentType"), accessor.whole("count")
        if found != shape or code not in kinds:
            wants = f"{shape} with componentType {' or '.join(map(str, sorted(kinds)))}"
            raise ValueError(f"{by.at(key)}: got an accessor of type {quote(found)} with componentType {code}, want {wants}")
        kind, begin = np.dtype(kinds[code]), accessor.whole("byteOffset", 0)
        size = width * kind.itemsize
        if "bufferView" not in accessor:  # all numbers are zero
            check_memory(_COPIES * size * count, f"{accessor.path}, {count:,} {shape} of zeros,", "leave it out")
            return accessor, np.zeros((count, width), kind)
        view = self.views[accessor.index("bufferView", self.views)]
        data, stride = self._view(view), view.whole("byteStride", size)
        if stride < size:
            raise ValueError(f"{view.at('byteStride')}: got {stride}, want at least {size}, the bytes of one {shape}")
        if begin + (stride * (count - 1) + size if count else 0) > len(data):
            raise ValueError(
                f"{accessor.path} declares {count:,} {shape}, too many for the {len(data):,} bytes of the buffer view"
            )
        return accessor, np.ndarray((count, width), kind, data, begin, (stride, kind.itemsize))

    def _view(self, view: Part) -> memoryview:
        """Return the bytes of a glTF buffer view, a part of a buffer."""
        data = self.buffers[view.index("buffer", self.buffers)]
        begin, length = view.whole("byteOffset", 0), view.whole("byteLength")
        if begin + length > len(data):
            raise ValueError(f"{view.path} ends at byte {begin + length:,}, but the buffer has only {len(data):,} bytes")
        return data[begin : begin + length]


def binary(path: Path, *, with_data: bool = True) -> tuple[Part, memoryview]:
    """Read the JSON and the binary part of a .glb; without `with_data`, return an empty binary part.

    Raises:
        ValueError: A file with another length than its header declares, or of another format.
    """
    actual = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(20)
        version, length, size = (int.from_bytes(header[at : at + 4], "little") for at in (4, 8, 12))
        if header[:4] == b"glTF" and version != 2:
            raise ValueError(f"the file is a .glb of version {version}, want version 2; export the file as glTF 2.0")
        if header[:4] != b"glTF" or header[16:] != b"JSON":
            raise ValueError("the file does not begin as a .glb of version 2")
        if length != actual or size > length - 20:
            raise ValueError(
                f"the header declares {length:,} bytes, {size:,} in the first chunk, but the file has {actual:,}"
            )
        text, header = file.read(size), file.read(8)
        size = int.from_bytes(header[:4], "little")
        if size > (left := length - file.tell()):
            raise ValueError(f"the second chunk declares {size:,} bytes, but the file has only {left:,} more")
        return parsed(text), memoryview(file.read(size) if with_data and header[4:] == b"BIN\0" else b"")


def _buffers(path: Path, buffers: list[Part], chunk: memoryview) -> list[memoryview]:
    """Return the bytes of all buffers; a file that several buffers name is read once."""
    lengths = [buffer.whole("byteLength") for buffer in buffers]
    names = [buffer.text("uri") if "uri" in buffer else None for buffer in buffers]
    longest: dict[str, tuple[int, Part]] = {}
    for name, length, buffer in zip(names, lengths, buffers, strict=True):
        if name is not None:
            longest[name] = max(longest.get(name, (0, buffer)), (length, buffer), key=lambda known: known[0])
    found = {name: content_of(path, name, *known) for name, known in longest.items()}
    inner = [chunk] + [memoryview(b"")] * len(buffers)
    held = [inner[i] if name is None else found[name] for i, name in enumerate(names)]
    for data, length in zip(held, lengths, strict=True):
        _check_length(length, len(data))
    return [data[:length] for data, length in zip(held, lengths, strict=True)]


def is_embedded(uri: str) -> bool:
    """Return whether a URI contains data, instead of the name of a file."""
    return uri[:5].lower() == "data:"


def content_of(path: Path, uri: str, length: int, by: Part) -> memoryview:
    """Return the first `length` bytes of embedded data or of a file relative to `path`, as specified by a URI.

    A length of 0 returns all bytes.
    """
    if is_embedded(uri):
        kind, _, data = uri.partition(",")
        try:
            if data and not kind.lower().endswith(";base64"):
                raise ValueError
            return memoryview(b64decode(unquote(data), validate=True))
        except ValueError:
            raise ValueError(f"{by.at('uri')}: got data that are not base64, want base64 after 'data:...;base64,'") from None
    if _SCHEME.match(uri) or Path(unquote(uri)).anchor:
        raise ValueError(f"{by.at('uri')}: got {quote(uri)}, want the name of a file, or data")
    file = check_file(path.parent / unquote(uri), by.at("uri"), "a file")
    with file.open("rb") as stream:
        _check_length(length, file.stat().st_size)
        return memoryview(stream.read(length or -1))


def _check_length(declared: int, held: int) -> None:
    """Raise a ValueError if data are shorter than declared."""
    if held < declared:
        raise ValueError(f"the buffer declares {declared:,} bytes, but has only {held:,}; the data are truncated")
