"""The files that mesh files name, and need beside them: data, materials and pictures."""

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from urllib.parse import unquote

from warpsample.host.json_tree import Part, parsed
from warpsample.mesh.files.gltf_data import binary

_PICTURES = ("map_", "bump", "disp", "decal", "refl", "norm")  # what a line of an .mtl with the name of one begins with
_WORDS = 20  # of such a line: options come before the name, which may have spaces


def files_beside(path: Path | None) -> list[Path]:
    """The files that a .gltf, .glb or .obj needs: buffers and pictures, materials and their pictures.

    None of another file, nor of one that cannot be read: whoever reads it says so.
    """
    reader = _READERS.get(path.suffix.lower()) if path is not None else None
    with suppress(OSError, TypeError, ValueError):
        if reader is not None and path is not None:
            return [path.parent / name for name in reader(path) if "\0" not in name]
    return []


def uris_of(tree: Part) -> Iterator[str]:
    """What the JSON of a glTF file says of the files that it needs."""
    for item in (*tree.parts("images"), *tree.parts("buffers")):
        if "uri" in item and not (uri := item.text("uri")).startswith("data:"):
            yield uri


def _gltf(path: Path) -> Iterator[str]:
    return map(unquote, uris_of(binary(path)[0] if path.suffix.lower() == ".glb" else parsed(path.read_bytes())))


def _obj(path: Path) -> Iterator[str]:
    for line in _lines(path):
        if line.startswith("mtllib"):
            for library in _names(line):
                yield library
                with suppress(OSError, ValueError):
                    for other in _lines(path.parent / library):
                        if other.lower().startswith(_PICTURES):
                            yield from (str(Path(library).parent / name) for name in _names(other))


def _names(line: str) -> list[str]:
    """What of a line may be the name of a file: any of its words with all that follow."""
    words = line.split()[:_WORDS]
    return [" ".join(words[start:]) for start in range(1, len(words))]


def _lines(path: Path) -> Iterator[str]:
    with path.open("rb") as file:
        yield from (os.fsdecode(line).strip() for line in file)


_READERS = {".obj": _obj, ".glb": _gltf, ".gltf": _gltf}
