"""Opening of USD files by usd-core, after checks for damage that would crash usd-core or make it use all memory."""

import os
import struct
import sys
from contextlib import suppress
from itertools import chain
from pathlib import Path
from typing import Any
from zipfile import BadZipFile, ZipFile

_TWO_COUNTS = ("TOKENS", "PATHS")
"""Sections of a binary file that begin with two counts, where others begin with one."""
_MOST_OF_BYTE = 1020
"""Largest number of entries per byte of a section: LZ4 expands a byte to 255 bytes, each of which codes four numbers."""


def open_stage(path: Path) -> Any:
    """Open a file as a USD stage.

    Raises:
        ValueError: A damaged archive, a damaged binary file, an archive without a USD file, or a missing reference.
    """
    from pxr import Usd

    if path.suffix.lower() == ".usdz":
        try:
            with ZipFile(path) as archive:
                damaged = archive.testzip()  # by checksums that usd-core ignores
        except BadZipFile:
            raise ValueError("the file is not a zip archive, or is cut off") from None
        if damaged:
            raise ValueError(f"the file {damaged} in the archive is damaged")
    layers = _layers(path)  # kept, so that each file is read once
    stage = Usd.Stage.Open(layers[0])
    lost = stage.GetCompositionErrors()
    if lost:
        raise ValueError(str(lost[0]))
    return stage


def write_names(path: str) -> None:
    """Write the paths of all files that a USD file needs to stdout, separated by zero bytes, in UTF-8."""
    from pxr import Tf, UsdUtils

    try:
        layers, assets, lost = UsdUtils.ComputeAllDependencies(path)
        names = [*(layer.realPath for layer in layers), *assets, *lost]
    except (Tf.ErrorException, UnicodeError):
        names = _find_names(path)  # a damaged layer is among the assets, which are no parts of the stage
    sys.stdout.buffer.write("\0".join(names).encode("utf-8", "surrogatepass"))


def _find_names(path: str) -> list[str]:
    """Return the paths that a layer names, and those that the named layers name in turn; damaged layers name none.

    Names in a layer that is a symbolic link are relative to the folder of the link.
    """
    from pxr import Ar, Tf, UsdUtils

    names, places = [str(Path(path).absolute())], set()
    for layer in names:  # which grows
        folder, name = os.path.split(layer)
        place = os.path.realpath(folder), name
        with suppress(Tf.ErrorException, OSError, UnicodeError):
            if place not in places and Path(layer).is_file():
                places.add(place)  # without circles
                for each in chain(*UsdUtils.ExtractExternalReferences(layer)):
                    found = each.partition(":SDF_FORMAT_ARGS:")[0]
                    searched = str(Ar.GetResolver().Resolve(found))  # by PXR_AR_DEFAULT_SEARCH_PATH
                    names += [os.path.normpath(Path(layer).parent / found), *filter(None, [searched])]
    return names


def _layers(path: Path) -> list[Any]:
    """Load and return the layers of a file and of all existing files that it refers to, directly or not.

    Missing files become composition errors of the stage.

    Raises:
        ValueError: A reference to a device or a pipe, for which usd-core would wait forever.
    """
    layers = {str(path): _layer(path)}
    left = [layers[str(path)]]
    while left:
        layer = left.pop()
        for name in map(layer.ComputeAbsolutePath, filter(None, layer.GetCompositionAssetDependencies())):
            file = Path(name)
            if file.exists() and not file.is_file():
                raise ValueError(f"the file refers to {name!r}, which is no ordinary file")
            if file.is_file() and name not in layers:
                layers[name] = _layer(file)
                left.append(layers[name])
    return list(layers.values())


def _layer(path: Path) -> Any:
    """Load one file as a layer, after a check of its sections."""
    from pxr import Sdf

    _check_sections(path)
    layer = Sdf.Layer.FindOrOpen(str(path))
    if layer is None:
        raise ValueError(f"{path.name} holds no USD layer; the first file of a .usdz must be a .usd, .usda or .usdc")
    return layer


def _check_sections(path: Path) -> None:
    """Raise a ValueError if a binary USD file is shorter than the sections that it declares.

    usd-core would allocate memory of the declared size.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(24)
        if header[:8] != b"PXR-USDC":
            return
        start = int.from_bytes(header[16:], "little")
        file.seek(min(start, size))
        sections = int.from_bytes(file.read(8), "little")
        if start + 8 + 32 * sections > size:
            raise ValueError(
                f"the header declares {sections:,} sections from byte {start:,} on, but the file has {size:,} bytes"
            )
        compressed = tuple(header[8:11]) >= (0, 4, 0)
        for padded, first, length in struct.iter_unpack("<16sQQ", file.read(32 * sections)):
            name = padded.rstrip(b"\0").decode("ascii", "replace")
            if first + length > size:
                raise ValueError(f"the section {name!r} ends beyond the {size:,} bytes of the file")
            file.seek(first)
            _check_counts(name, file.read(8 * (2 if compressed and name in _TWO_COUNTS else 1)), length)


def _check_counts(section: str, counts: bytes, length: int) -> None:
    """Raise a ValueError if a section of `length` bytes is too short for its declared entries.

    `counts` are the entry counts at its beginning, 8 bytes each.
    """
    for at in range(0, length and len(counts), 8):
        declared = int.from_bytes(counts[at : at + 8], "little")
        if declared > _MOST_OF_BYTE * length:
            raise ValueError(f"the section {section!r} declares {declared:,} entries, too many for {length:,} bytes")


def describe_error(error: Any, path: Path) -> str:
    """Return the first line of a usd-core error, without the path and the name of its parser."""
    try:
        reason = error.args[0].commentary.strip().partition("\n")[0]
    except UnicodeDecodeError:  # it quotes the damaged bytes
        return "the file is damaged"
    for quoted, plain in ((f"{path}:", "line "), (f"<{path}>", "the file"), (f" @{path}@", "")):
        reason = reason.replace(quoted, plain)
    return reason.partition(" matching ")[0]
