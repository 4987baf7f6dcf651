"""New texture coordinates of primitives of a .glb: their vertices are split, and all that belongs to these follows."""

from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.mesh import Mesh
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import Primitive
from warpsample.texture.unwrapping import PADDING, Charted, charted


def add_uv(file: GlbFile, group: list[Primitive], mesh: Mesh, size: int) -> tuple[int, np.ndarray]:
    """Gives a group of primitives coordinates of one image, in a set that none of them has.

    Args:
        file: to be edited.
        group: of primitives that share materials.
        mesh: as `load_mesh` gives it, in which they are placed.
        size: of the image, in texels.

    Returns:
        the number of the set, and (F, 3, 2) float64, NaN of the faces of others.
    """
    parts = [(mesh.vertices[one.vertices], one.triangles) for one in group]
    number = max(map(_sets, group))
    uv = np.full((len(mesh.faces), 3, 2), np.nan)
    for one, (vertex, faces, places) in zip(group, charted(parts, size, PADDING), strict=True):
        uv[one.faces] = places[faces]
        _split(file, one, (vertex, faces, places), number)
    return number, uv.astype(np.float32).astype(np.float64)


def _sets(one: Primitive) -> int:
    """How many sets of coordinates a primitive has: they are counted from 0 without a gap."""
    attributes, number = one.part.part("attributes"), 0
    while f"TEXCOORD_{number}" in attributes:
        number += 1
    return number


def _split(file: GlbFile, one: Primitive, charts: Charted, number: int) -> None:
    """Rewrites a primitive by the vertex that each new one is; sets below `number` that it has not are the new one, too."""
    primitive: dict[str, Any] = file.tree["meshes"][one.mesh]["primitives"][one.number]
    (vertex, faces, uv), had = charts, _sets(one)
    primitive["attributes"] = _gathered(file, one.part.part("attributes"), vertex)
    places = file.add_vertices(uv.astype(np.float32))
    primitive["attributes"] |= {f"TEXCOORD_{i}": places for i in range(had, number + 1)}
    targets = one.part.parts("targets")
    if targets:
        primitive["targets"] = [_gathered(file, target, vertex) for target in targets]
    primitive["indices"] = file.add_indices((faces[:, ::-1] if one.mirrored else faces).ravel())
    primitive.pop("mode", None)


def _gathered(file: GlbFile, attributes: Part, vertex: np.ndarray) -> dict[str, int]:
    """The accessors of a primitive's attributes, of other vertices."""
    return {name: file.add_like(*_rows(file, attributes, name, vertex)) for name in attributes.content}


def _rows(file: GlbFile, attributes: Part, name: str, vertex: np.ndarray) -> tuple[Part, np.ndarray]:
    accessor, array = file.data.rows(attributes, name)
    if vertex.max(initial=0) >= len(array):
        raise ValueError(f"{attributes.at(name)}: got {len(array):,} of them, want one for each vertex")
    return accessor, array[vertex]
