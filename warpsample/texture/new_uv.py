"""New texture coordinates of primitives of a .glb: their vertices are split, and all that belongs to these follows."""

from itertools import count as count_up
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.mesh import Mesh
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import Primitive
from warpsample.texture.unwrapping import PADDING, MeshCharts, unwrap_meshes


def charts_for(group: list[Primitive], mesh: Mesh, size: int) -> list[MeshCharts]:
    """Charts of a group of primitives, as `load_mesh` places them, in one image of so many texels."""
    return unwrap_meshes([(mesh.vertices[one.vertices], one.triangles) for one in group], size, PADDING)


def add_uv(file: GlbFile, group: list[Primitive], charts: list[MeshCharts], count: int) -> tuple[int, np.ndarray]:
    """Gives a group of primitives the coordinates of their charts, in a set that none of them has.

    Args:
        file: to be edited.
        group: of primitives that share materials.
        charts: theirs.
        count: of the faces of the mesh in which they are placed.

    Returns:
        the number of the set, and (F, 3, 2) float64, NaN of the faces of others.
    """
    used = {name for one in group for name in one.part.part("attributes").content}
    number = next(number for number in count_up() if f"TEXCOORD_{number}" not in used)
    uv = np.full((count, 3, 2), np.nan)
    for one, (vertex, faces, places) in zip(group, charts, strict=True):
        uv[one.faces] = places[faces]
        _split_vertices(file, one, (vertex, faces, places), number)
    return number, uv.astype(np.float32).astype(np.float64)


def _split_vertices(file: GlbFile, one: Primitive, charts: MeshCharts, number: int) -> None:
    """Rewrites a primitive by the vertex that each new one is; sets below `number` that it has not are the new one, too."""
    primitive: dict[str, Any] = file.tree["meshes"][one.mesh]["primitives"][one.number]
    vertex, faces, uv = charts
    primitive["attributes"] = _gather_attributes(file, one.part.part("attributes"), vertex)
    places = file.add_vertices(uv.astype(np.float32))
    primitive["attributes"] = {f"TEXCOORD_{i}": places for i in range(number + 1)} | primitive["attributes"]
    targets = one.part.parts("targets")
    if targets:
        primitive["targets"] = [_gather_attributes(file, target, vertex) for target in targets]
    primitive["indices"] = file.add_indices((faces[:, ::-1] if one.mirrored else faces).ravel())
    primitive.pop("mode", None)


def _gather_attributes(file: GlbFile, attributes: Part, vertex: np.ndarray) -> dict[str, int]:
    """The accessors of a primitive's attributes, of other vertices."""
    return {name: file.add_like(*_gather_rows(file, attributes, name, vertex)) for name in attributes.content}


def _gather_rows(file: GlbFile, attributes: Part, name: str, vertex: np.ndarray) -> tuple[Part, np.ndarray]:
    accessor, array = file.data.rows(attributes, name)
    if vertex.max(initial=0) >= len(array):
        raise ValueError(f"{attributes.at(name)}: got {len(array):,} of them, want one for each vertex")
    return accessor, array[vertex]
