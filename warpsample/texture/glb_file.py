"""Editing of a .glb or .gltf file in memory: arrays, pictures and materials are added, all else stays the same.

trimesh and pygltflib are not used, since they drop the parts of a file that they do not know.
"""

import json
import re
import struct
from base64 import b64encode
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.host.arguments import naming_file
from warpsample.host.json_tree import Part, check_finite, collect_names, parsed
from warpsample.mesh.files.gltf_data import Data, binary, content_of
from warpsample.texture.animations import copy_channels

MOST_BYTES = 2**32 - 2**20
"""Largest size of a written .glb: the format stores lengths in 32 bits."""

_CODES = {"f4": 5126, "u4": 5125, "u2": 5123, "u1": 5121}
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
_OF_ARRAY = ("bufferView", "byteOffset", "componentType", "type", "count", "min", "max")
_VERTICES, _INDICES = 34962, 34963  # targets of buffer views: vertex attributes and indices
_PICTURES = {
    rb"\x89PNG": "image/png",
    rb"\xff\xd8": "image/jpeg",
    rb"RIFF....WEBP": "image/webp",
    rb"\xabKTX 20\xbb": "image/ktx2",
}
"""First bytes of a picture and its media type. WebP and KTX2 need a glTF extension."""
_JSON, _BIN = 0x4E4F534A, 0x004E4942
_LISTS = ("accessors", "bufferViews", "images", "materials", "samplers", "textures")
_CLAMP, _LINEAR, _LINEAR_MIPMAP = 33071, 9729, 9987


@contextmanager
def convert_read_errors(path: Path) -> Iterator[None]:
    """Convert errors of the enclosed code that reads a file into one ValueError that names the file."""
    wants = "a glTF file to be edited" if path.suffix.lower() in (".glb", ".gltf") else "a mesh with normals"
    with naming_file("mesh", path, wants):
        try:
            yield
        except (TypeError, FileNotFoundError) as error:  # raised by the check of a single member
            raise ValueError(str(error)) from None


class GlbFile:
    """Contents of a .glb, or of a .gltf and its external files, to which arrays and pictures are added.

    Attributes:
        part: JSON of the file as it was read, with checked access.
        data: arrays of the file.
        tree: JSON to be edited and written.
    """

    part: Part

    def __init__(self, path: Path) -> None:
        """Read a .glb, or a .gltf and the files that it names.

        Raises:
            ValueError: the file is neither .glb nor .gltf, or the first buffer of the .glb is an external file.
        """
        is_binary = path.suffix.lower() == ".glb"
        self.part, chunk = binary(path) if is_binary else (parsed(path.read_bytes()), memoryview(b""))
        self.data: Data = Data.of(self.part, path, chunk)
        for key in _LISTS:
            self.part.parts(key)  # checks the type of each list that may grow
        for animation in self.part.parts("animations"):
            animation.parts("channels")
        check_finite(self.part)
        self.tree: dict[str, Any] = _copy_json(self.part.content)
        self.tree["buffers"] = self.tree.get("buffers") or [{"byteLength": 0}]
        self._chunks, self._size, self._rest = [bytes(chunk)], len(chunk), b""
        if is_binary:
            self._rest = _read_trailing_bytes(path, len(chunk))
            if "uri" in self.tree["buffers"][0]:
                raise ValueError("the buffer buffers[0] is in another file, want a .glb with embedded data")
        else:
            self._embed_files(path)

    def add_vertices(self, array: np.ndarray, **more: Any) -> int:
        """Append an array of vertex values, (V,) or (V, k), and return the number of its glTF accessor."""
        return self._add_array(array, _VERTICES, more)

    def add_indices(self, array: np.ndarray) -> int:
        """Append an array of (N,) vertex indices, and return the number of its glTF accessor."""
        kind = np.uint16 if array.max(initial=0) < 65535 else np.uint32
        return self._add_array(array.astype(kind), _INDICES, {})

    def add_like(self, accessor: Part, array: np.ndarray) -> int:
        """Append vertex values of the type of an existing glTF accessor, and return the new accessor's number."""
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
        """Append a .png as a texture, clamped at its edges, and return the texture's number."""
        image = self._append("images", {"name": name, "mimeType": "image/png", "bufferView": self._add_view(png, {})})
        how = {"magFilter": _LINEAR, "minFilter": _LINEAR_MIPMAP, "wrapS": _CLAMP, "wrapT": _CLAMP}
        samplers = self.tree.setdefault("samplers", [])
        sampler = samplers.index(how) if how in samplers else self._append("samplers", how)
        return self._append("textures", {"name": name, "sampler": sampler, "source": image})

    def add_material(self, material: dict[str, Any]) -> int:
        """Append a glTF material, given as JSON, and return its number."""
        return self._append("materials", material)

    def copy_item(self, key: str, number: int) -> int:
        """Append a copy of a mesh or material and return its number; both use the same data and the same animations.

        Animations name meshes and materials by number (KHR_animation_pointer), so a copy needs channels of its own.

        Args:
            key: "meshes" or "materials".
            number: number of the mesh or material.
        """
        made = self._append(key, _copy_json(self.tree[key][number]))
        copy_channels(self.tree, f"/{key}/{number}/", f"/{key}/{made}/")
        return made

    def write(self, file: BinaryIO) -> None:
        """Write the edited content to an open file as a .glb.

        Raises:
            ValueError: the file would be longer than 4 GiB.
        """
        self._finish()
        text = json.dumps(self.tree, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        length = 28 + len(text) + self._size + len(self._rest)
        if length > MOST_BYTES:
            raise ValueError(
                f"--output: got {length:,} bytes to write, want at most 4 GiB, the limit of a .glb; take smaller pictures"
            )
        file.write(struct.pack("<4sIIII", b"glTF", 2, length, len(text), _JSON))
        file.write(text + struct.pack("<II", self._size, _BIN))
        file.writelines(self._chunks)
        file.write(self._rest)

    def write_text(self, file: BinaryIO) -> None:
        """Write the edited content to an open file as a .gltf with embedded data, so that the .gltf needs no second file."""
        self._finish()
        uri = "data:application/octet-stream;base64," + b64encode(b"".join(self._chunks)).decode()
        self.tree["buffers"][0]["uri"] = uri
        file.write(json.dumps(self.tree, separators=(",", ":"), allow_nan=False).encode())

    def check_no_trailing_bytes(self) -> None:
        """Raise a ValueError if the .glb has chunks after its data, which a .gltf cannot store."""
        if self._rest:
            raise ValueError(
                f"the file has {len(self._rest):,} bytes after its data, which a .gltf cannot hold, want a .glb as --output"
            )

    def _finish(self) -> None:
        """Pad the data to a multiple of 4 bytes, and remove the names of extensions that the edits removed completely."""
        self._append_bytes(b"")
        self.tree["buffers"][0]["byteLength"] = self._size
        removed = collect_names(self.part.content, "extensions") - collect_names(self.tree, "extensions")
        for key in {"extensionsUsed", "extensionsRequired"} & set(self.tree if removed else ()):
            self.tree[key] = [name for name in self.tree[key] if name not in removed]
            if not self.tree[key]:  # glTF has no empty lists
                del self.tree[key]

    def _embed_files(self, path: Path) -> None:
        """Join all buffers into one and embed external pictures of the types that a .glb can hold."""
        starts = [self._append_bytes(bytes(buffer)) for buffer in self.data.buffers]
        # the name and extras of the first buffer are kept
        self.tree["buffers"] = [{**self.tree["buffers"][0], "byteLength": 0}]
        self.tree["buffers"][0].pop("uri", None)
        for view, part in zip(self.tree.get("bufferViews", []), self.data.views, strict=True):
            view["byteOffset"] = part.whole("byteOffset", 0) + starts[part.index("buffer", starts)]
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
        """Append bytes to the binary data, aligned to 4 bytes, and return the offset of the first byte."""
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


def _copy_json(content: Any) -> Any:
    """Return a copy by text: the file was parsed, so that its nesting is not too deep."""
    return json.loads(json.dumps(content, allow_nan=False))


def _read_trailing_bytes(path: Path, chunk: int) -> bytes:
    """Return the bytes of a .glb file after its JSON chunk and its data chunk of `chunk` bytes."""
    with path.open("rb") as file:
        size = int.from_bytes(file.read(20)[12:16], "little")
        file.seek(20 + size)
        is_data = file.read(8)[4:] == b"BIN\0"
        file.seek(20 + size + (8 + chunk if is_data else 0))
        return file.read()
