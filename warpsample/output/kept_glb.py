"""Copies of a .glb file with computed values added at its vertices; all other content is kept."""

from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

import numpy as np

from warpsample.texture.glb_file import GlbFile, convert_read_errors
from warpsample.texture.notes import describe_materials, describe_missing_files, join_names
from warpsample.texture.primitives import Primitive, list_primitives


def keeps(source: Path, output: Path, at: str | None) -> bool:
    """Return whether the output is the input .glb with values added at its vertices, instead of a new mesh."""
    return source.suffix.lower() in (".glb", ".gltf") and output.suffix == ".glb" and at == "vertices"


def describe_kept_file(source: Path, output: Path) -> list[str]:
    """Return notes on a copied .glb: replaced colours, meshes placed several times, materials, and external files.

    Raises:
        ValueError: a file that cannot be edited.
    """
    file, primitives = _open(source)
    coloured = join_names(one.name for one in primitives if "COLOR_0" in one.part.part("attributes"))
    several = join_names(one.name for one in primitives if one.others)
    notes = [f"the colours of {coloured} are replaced"] if coloured else []
    notes += [f"of {several}, in several places, the first place counts"] if several else []
    return [*notes, *describe_materials(file.part, primitives), *describe_missing_files(source, file.tree, output)]


def write_kept_file(stream: BinaryIO, source: Path, columns: Mapping[str, np.ndarray]) -> None:
    """Write a copy of a .glb file with additional vertex attributes, (V,) or (V, 4), keyed by name."""
    file, primitives = _open(source)
    for one in primitives:
        attributes = file.tree["meshes"][one.mesh]["primitives"][one.number]["attributes"]
        for name, array in columns.items():
            shares = {"normalized": True} if array.dtype == np.uint8 else {}
            attributes[name] = file.add_vertices(array[one.vertices], **shares)
    file.write(stream)


def _open(source: Path) -> tuple[GlbFile, list[Primitive]]:
    """Read a glTF file; return its editable content and the list of its primitives."""
    with convert_read_errors(source):
        file = GlbFile(source)
        return file, list_primitives(file.part, file.data)
