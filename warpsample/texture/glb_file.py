"""A .glb or .gltf that gets more: its JSON is edited and bytes are appended; all else stays byte for byte.

Not by trimesh or pygltflib, which write anew what they know of a file, and lose the rest.
"""

import json
import re
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO
from urllib.parse import quote

import numpy as np

from warpsample.host.arguments import naming_file
from warpsample.host.json_tree import Part, check_finite, parsed
from warpsample.mesh.files.gltf_data import Data, binary, content_of

MOST_BYTES = 2**32 - 2**20
"""Of the data of a file: it tells its length in 32 bits."""

_CODES = {"f4": 5126, "u4": 5125, "u2": 5123, "u1": 5121}
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
_OF_ARRAY = ("bufferView", "byteOffset", "componentType", "type", "count", "min", "max")
_VERTICES, _INDICES = 34962, 34963  # what a view of the buffer is for
_PICTURES = {
    rb"\x89PNG": "image/png",
    rb"\xff\xd8": "image/jpeg",
    rb"RIFF....WEBP": "image/webp",
    rb"\xabKTX 20\xbb": "image/ktx2",
}
"""What a picture begins with, and what a .glb calls it; of the last two by an extension."""
_JSON, _BIN = 0x4E4F534A, 0x004E4942
_LISTS = ("accessors", "bufferViews", "images", "materials", "samplers", "textures")
_CLAMP, _LINEAR, _LINEAR_MIPMAP = 33071, 9729, 9987


@contextmanager
def convert_read_errors(path: Path) -> Iterator[None]:
    """Wraps what reads a file to be edited: whatever is wrong with it is one ValueError that names it."""
    with naming_file("mesh", path, "a glTF file to be edited"):
        try:
            yield
        except (TypeError, FileNotFoundError) as error:  # of the check of one member
            raise ValueError(str(error)) from None


class GlbFile:
    """A .glb in memory, or a .gltf with its files as one, to which arrays and pictures are added.

    Attributes:
        part: its JSON as it was, for readers that check what they read.
        data: the numbers in it.
        tree: its JSON, to be edited.
    """

    part: Part

    def __init__(self, path: Path) -> None:
        """Reads a file.

        Raises:
            ValueError: neither of the two, or a .glb whose first buffer is not in it, so that nothing can be appended.
        """
        is_binary = path.suffix.lower() == ".glb"
        self.part, chunk = binary(path) if is_binary else (parsed(path.read_bytes()), memoryview(b""))
        self.data: Data = Data.of(self.part, path, chunk)
        for key in _LISTS:
            self.part.parts(key)  # checked: they get further members
        check_finite(self.part)
        self.tree: dict[str, Any] = json.loads(json.dumps(self.part.content, allow_nan=False))  # as deep as it could be read
        self._chunks, self._size, self._rest = [bytes(chunk)], len(chunk), b""
        if is_binary:
            self._rest = _read_trailing_bytes(path, len(chunk))
            if "uri" in self.tree.setdefault("buffers", [{"byteLength": 0}])[0]:
                raise ValueError("buffers[0] is not in the file itself, want one whose data are")
        else:
            self._embed_files(path)

    def add_vertices(self, array: np.ndarray, **more: Any) -> int:
        """The number of a new accessor of (V,) or (V, k) numbers of vertices, of rows of whole 4 bytes."""
        return self._add_array(array, _VERTICES, more)

    def add_indices(self, array: np.ndarray) -> int:
        """The number of a new accessor of (N,) indices of vertices."""
        kind = np.uint16 if array.max(initial=0) < 65535 else np.uint32
        return self._add_array(array.astype(kind), _INDICES, {})

    def add_like(self, accessor: Part, array: np.ndarray) -> int:
        """The number of a new accessor of (V, k) numbers of vertices, of which all else is said as of another one."""
        more = {key: value for key, value in accessor.content.items() if key not in _OF_ARRAY}
        bounds = {"min": array.min(axis=0), "max": array.max(axis=0)}
        more |= {key: value.tolist() for key, value in bounds.items() if key in accessor and np.isfinite(value).all()}
        size = array.shape[1] * array.dtype.itemsize
        rows = np.ascontiguousarray(array).view(np.uint8).reshape(len(array), size)
        padded = np.pad(rows, ((0, 0), (0, -size % 4)))
        view = {"target": _VERTICES} | ({"byteStride": padded.shape[1]} if size % 4 else {})
        kind = {"componentType": accessor.whole("componentType"), "type": accessor.text("type"), "count": len(array)}
        return self._append("accessors", {"bufferView": self._add_view(padded.tobytes(), view), **kind, **more})

    def add_picture(self, png: bytes, name: str) -> int:
        """The number of a new texture of a picture, whose edges do not meet each other."""
        image = self._append("images", {"name": name, "mimeType": "image/png", "bufferView": self._add_view(png, {})})
        how = {"magFilter": _LINEAR, "minFilter": _LINEAR_MIPMAP, "wrapS": _CLAMP, "wrapT": _CLAMP}
        samplers = self.tree.setdefault("samplers", [])
        sampler = samplers.index(how) if how in samplers else self._append("samplers", how)
        return self._append("textures", {"name": name, "sampler": sampler, "source": image})

    def add_material(self, material: dict[str, Any]) -> int:
        """The number of a new material."""
        return self._append("materials", material)

    def copy_mesh(self, number: int) -> int:
        """Append a copy of a mesh, which shares its data; return the number of the copy."""
        return self._append("meshes", json.loads(json.dumps(self.tree["meshes"][number])))

    def write(self, file: BinaryIO) -> None:
        """Writes the whole: a length of more than 32 bits is a ValueError."""
        self._append_bytes(b"")  # a part is of whole 4 bytes
        self.tree["buffers"][0]["byteLength"] = self._size
        text = json.dumps(self.tree, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        length = 28 + len(text) + self._size + len(self._rest)
        if length > MOST_BYTES:
            raise ValueError(f"--output: got {length:,} bytes to write, and a .glb holds 4 GiB")
        file.write(struct.pack("<4sIIII", b"glTF", 2, length, len(text), _JSON))
        file.write(text + struct.pack("<II", self._size, _BIN))
        file.writelines(self._chunks)
        file.write(self._rest)

    def write_data(self, data: BinaryIO) -> None:
        """Write all data, as the file beside a .gltf holds them."""
        self._append_bytes(b"")  # the same as in a .glb
        data.writelines(self._chunks)

    def text_naming(self, name: str) -> bytes:
        """Return the content of a .gltf whose data are in a file of that name beside it."""
        self.tree["buffers"][0] |= {"byteLength": self._size, "uri": quote(name)}
        return json.dumps(self.tree, separators=(",", ":"), allow_nan=False).encode()

    def check_no_trailing_bytes(self) -> None:
        """Refuses, by a ValueError, a .glb with parts that a .gltf has no place for."""
        if self._rest:
            raise ValueError(f"it has {len(self._rest):,} bytes after its data, which a .gltf has no place for, want a .glb")

    def _embed_files(self, path: Path) -> None:
        """Makes one buffer of all, and takes in the pictures of other files that a .glb may hold."""
        starts = [self._append_bytes(bytes(buffer)) for buffer in self.data.buffers]
        self.tree["buffers"] = [{**self.tree.get("buffers", [{}])[0], "byteLength": 0}]  # with what is said of the first
        self.tree["buffers"][0].pop("uri", None)
        for view in self.tree.get("bufferViews", []):
            view["byteOffset"] = view.get("byteOffset", 0) + starts[view["buffer"]]
            view["buffer"] = 0
        for image, part in zip(self.tree.get("images", []), self.part.parts("images"), strict=True):
            if "uri" in part:
                content = bytes(content_of(path, part.text("uri"), 0, part))
                kind = next((kind for start, kind in _PICTURES.items() if re.match(start, content, re.DOTALL)), None)
                if kind is None:
                    raise ValueError(
                        f"{part.at('uri')}: got a picture that is none of .png .jpg .webp .ktx2, want one of these"
                    )
                del image["uri"]
                image |= {"mimeType": kind, "bufferView": self._add_view(content, {})}

    def _append_bytes(self, content: bytes) -> int:
        """Where in the buffer some bytes begin from now on: at a whole number of four."""
        before = -self._size % 4
        self._chunks += [b"\0" * before, content]
        start = self._size + before
        self._size = start + len(content)
        return start

    def _add_array(self, array: np.ndarray, target: int, more: dict[str, Any]) -> int:
        array = np.ascontiguousarray(array)
        width = array.shape[1] if array.ndim == 2 else 1
        view = self._add_view(array.tobytes(), {"target": target})
        kind = {"componentType": _CODES[array.dtype.str[1:]], "type": _TYPES[width]}
        return self._append("accessors", {"bufferView": view, **kind, "count": len(array), **more})

    def _add_view(self, content: bytes, more: dict[str, Any]) -> int:
        view = {"buffer": 0, "byteOffset": self._append_bytes(content), "byteLength": len(content), **more}
        return self._append("bufferViews", view)

    def _append(self, key: str, item: dict[str, Any]) -> int:
        items = self.tree.setdefault(key, [])
        items.append(item)
        return len(items) - 1


def _read_trailing_bytes(path: Path, chunk: int) -> bytes:
    """What follows the first two parts of a file, of which the second has so many bytes."""
    with path.open("rb") as file:
        size = int.from_bytes(file.read(20)[12:16], "little")
        file.seek(20 + size)
        is_data = file.read(8)[4:] == b"BIN\0"
        file.seek(20 + size + (8 + chunk if is_data else 0))
        return file.read()
