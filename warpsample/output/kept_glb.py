"""Numbers at the vertices of a .glb, written into the .glb: what it has besides stays as it is."""

from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

import numpy as np

from warpsample.texture.glb_file import GlbFile, convert_read_errors
from warpsample.texture.notes import describe_materials, join_names
from warpsample.texture.primitives import Primitive, list_primitives


def keeps(source: Path, output: Path, at: str | None) -> bool:
    """Whether a run of numbers at places writes them into the file that it has the mesh from."""
    return source.suffix.lower() in (".glb", ".gltf") and output.suffix == ".glb" and at == "vertices"


def told_of_kept(source: Path) -> list[str]:
    """What is to be said of writing into a file: which colours are replaced, and what stands in several places.

    Raises:
        ValueError: a file that cannot be edited.
    """
    file, primitives = _opened(source)
    coloured = join_names(one.name for one in primitives if "COLOR_0" in one.part.part("attributes"))
    several = join_names(one.name for one in primitives if one.others)
    told = [f"the colours of {coloured} are replaced"] if coloured else []
    told += [f"of {several}, in several places, the first one counts"] if several else []
    return [*told, *describe_materials(file.part, primitives)]


def write_kept(stream: BinaryIO, source: Path, columns: Mapping[str, np.ndarray]) -> None:
    """Writes a file with further attributes of its vertices, (V,) or (V, 4) by name; a uint8 stands for 0 to 1."""
    file, primitives = _opened(source)
    for one in primitives:
        attributes = file.tree["meshes"][one.mesh]["primitives"][one.number]["attributes"]
        for name, array in columns.items():
            shares = {"normalized": True} if array.dtype == np.uint8 else {}
            attributes[name] = file.add_vertices(array[one.vertices], **shares)
    file.write(stream)


def _opened(source: Path) -> tuple[GlbFile, list[Primitive]]:
    with convert_read_errors(source):
        file = GlbFile(source)
        return file, list_primitives(file.part, file.data)
