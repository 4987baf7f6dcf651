"""Lists the files that a mesh file or CityJSON refers to: buffers, materials and pictures."""

import glob
import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import chain, takewhile
from os import fsencode
from pathlib import Path
from urllib.parse import unquote

from warpsample.host.json_tree import Part, parsed, split_documents
from warpsample.mesh.files.gltf_data import binary, is_embedded
from warpsample.mesh.files.usd import list_assets

_PICTURES = ("map_", "bump", "disp", "decal", "refl", "norm", "aniso")  # first words of lines with a picture in an .mtl
_LONGEST = 1 << 16  # bytes of a line that are read at a time
_BYTES = re.compile("[\udc80-\udcff]+")  # that are not UTF-8, as `surrogateescape` reads them
_FILE_URI = re.compile("^file:(//(localhost)?)?", re.IGNORECASE)
_TILES = {
    "<udim>": "[0-9]" * 4,
    "<uvtile>": "u[0-9]*_v[0-9]*",
}  # parts of names of a picture's tiles, and what they stand for
_TILE = re.compile("|".join(_TILES), re.IGNORECASE)
_WORDS = 30  # largest number of words of such a line that is read


def list_linked_files(path: Path | None) -> list[Path]:
    """Return the paths of the files that a .gltf, .glb, .obj, .ply, USD or CityJSON file refers to, such as pictures.

    Returns an empty list for other formats and for files that cannot be read; reading such a file raises the error.
    """
    reader = _READERS.get(path.suffix.lower()) if path is not None else None
    with suppress(OSError, TypeError, ValueError):
        if reader is not None and path is not None and path.is_file():  # reading a pipe may never end
            found = [path.parent / name for name in _spellings(reader(path))]
            return [*found, *chain.from_iterable(_tiles_of(each) for each in found if _TILE.search(each.name))]
    return []


def _spellings(names: Iterable[str]) -> list[str]:
    """Return names of files and their other spellings: slashes, no `file:`, and text for bytes that are not UTF-8."""
    names = [name for name in names if "\0" not in name]
    names += [each.replace("\\", "/") for each in names]
    names += [_FILE_URI.sub("", each) for each in names]
    names += [_BYTES.sub(_text_of_windows, each) for each in names]
    return list(filter(_is_possible, dict.fromkeys(names)))


def _is_possible(name: str) -> bool:
    """Return whether a file can have the given name. JSON can hold half of a UTF-16 pair, which no name of a file can."""
    try:
        fsencode(name)
    except UnicodeEncodeError:
        return False
    return True


def _text_of_windows(found: re.Match[str]) -> str:
    """Return the text of bytes that are not UTF-8."""
    return found[0].encode("utf-8", "surrogateescape").decode("cp1252", "replace")


def _tiles_of(picture: Path) -> list[Path]:
    """Return the paths of all tiles of a picture; none in a folder that cannot be read."""
    pattern = _TILE.sub(lambda found: _TILES[found[0].lower()], glob.escape(picture.name))
    with suppress(OSError, ValueError):  # the second for a name that is no text
        return list(picture.parent.glob(pattern))
    return []


def uris_of(tree: Part) -> Iterator[str]:
    """Yield the URIs of pictures and buffers in the JSON of a glTF file, embedded data excluded."""
    for item in (*tree.parts("images"), *tree.parts("buffers")):
        if "uri" in item and not is_embedded(uri := item.text("uri")):
            yield uri


def _gltf(path: Path) -> Iterator[str]:
    """Yield the names of the external files that a .gltf or .glb refers to; items that are damaged are passed over."""
    content = _tree(path).content
    for items in (content.get("images"), content.get("buffers")):
        for item in items if isinstance(items, list) else []:
            uri = item.get("uri") if isinstance(item, dict) else None
            if isinstance(uri, str) and not is_embedded(uri):
                yield from {unquote(each, errors="surrogateescape") for each in (uri, re.split("[?#]", uri)[0])}


def _tree(path: Path) -> Part:
    """Return the JSON of a .gltf or .glb file, as a `Part`."""
    return binary(path, with_data=False)[0] if path.suffix.lower() == ".glb" else parsed(path.read_bytes())


def _ply(path: Path) -> Iterator[str]:
    """Yield the pictures that comments in the header of a .ply file name."""
    for line in takewhile(lambda line: line != "end_header", _lines(path)):
        words = line.split(maxsplit=2)
        if words[:2] == ["comment", "TextureFile"]:
            yield from words[2:]


def _city(path: Path) -> Iterator[str]:
    """Yield the pictures that the appearances of a CityJSON file or of a sequence of features name."""
    for text in split_documents(path.read_bytes()):
        if b"image" in text or b"\\u" in text:  # most documents name no picture, and parsing takes time
            tree = parsed(text)
            for texture in tree.part("appearance").parts("textures") if tree.content.get("appearance") else []:
                if isinstance(name := texture.content.get("image"), str):
                    yield from {name, unquote(name.removeprefix("file:"), errors="surrogateescape")}


def _obj(path: Path) -> Iterator[str]:
    """Yield the material files that an .obj names, and the pictures that the material files name."""
    known = set()
    for line in _lines(path):
        if line.lower().startswith("mtllib"):
            for library in set(_spellings(_names(line))) - known:
                known.add(library)
                yield library
                with suppress(OSError, ValueError):
                    if not (path.parent / library).is_file():
                        continue
                    for other in _lines(path.parent / library):
                        if other.lower().startswith(_PICTURES):
                            for name in _spellings(_names(other)):  # relative to the .obj in some programs
                                yield from {name, str(Path(library).parent / name)}


def _names(line: str) -> list[str]:
    """Return all possible file names in a line of an .obj or .mtl: names may contain spaces, quotation marks and #.

    Options and other names may be on both sides of a name. None begins within a comment.
    """
    words = [match.span() for match in re.finditer(r"[^ \t]+", line)][:_WORDS]
    comment = len(line.partition("#")[0])
    starts = [start for start, _ in words[1:] if start < comment]
    return [line[start:end].strip("'\"") for start in starts for _, end in words if end > start]


def _lines(path: Path) -> Iterator[str]:
    """Yield the lines of a text without surrounding spaces, and also lines that a backslash joins, as one.

    Lines above 64 KiB are in parts.
    """
    held = ""
    with path.open(encoding="utf-8-sig", errors="surrogateescape") as file:
        for line in iter(lambda: file.readline(_LONGEST), ""):
            text = line.strip()
            yield text
            if held:
                yield held + text
            held = f"{held}{text[:-1]} " if text.endswith("\\") and len(held) < _LONGEST else ""


_READERS = {".obj": _obj, ".ply": _ply, ".glb": _gltf, ".gltf": _gltf, ".json": _city, ".jsonl": _city} | dict.fromkeys(
    (".usd", ".usda", ".usdc"), list_assets
)
