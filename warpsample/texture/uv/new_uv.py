"""New texture coordinates for primitives of a .glb: vertices at chart borders are split, with all their attributes."""

from collections.abc import Iterator
from itertools import count as count_up
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.mesh import Mesh
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.notes import join_names
from warpsample.texture.primitives import Primitive
from warpsample.texture.uv.pieces import MeshCharts
from warpsample.texture.uv.unwrapping import PADDING, unwrap_meshes

_BY_VERTEX = ("CESIUM_primitive_outline", "EXT_mesh_manifold")
"""Extensions of primitives and meshes that refer to vertices by number."""
_WITHOUT_VERTICES = ("KHR_materials_variants", "KHR_xmp_json_ld", "EXT_mesh_features", "EXT_structural_metadata")
_WITHOUT_VERTICES += ("EXT_feature_metadata", "KHR_xmp")


def charts_for(group: list[Primitive], mesh: Mesh, size: int) -> list[MeshCharts]:
    """Compute new texture coordinates for a group of primitives, in one square image of `size` texels.

    Positions are those of `load_mesh`, at the first place with an area of each primitive.
    """
    return unwrap_meshes([(mesh.vertices[one.vertices], one.triangles) for one in group], size, PADDING)


def add_uv(file: GlbFile, group: list[Primitive], charts: list[MeshCharts]) -> tuple[int, list[np.ndarray]]:
    """Add new texture coordinates to a group of primitives, as a set that none of the primitives has yet.

    Args:
        file: file to edit.
        group: primitives that share materials.
        charts: charts of each primitive.

    Returns:
        the number of the set; and the coordinates of each primitive's faces, (n, 3, 2) float64.
    """
    used = {name for one in group for name in one.part.part("attributes").content}
    number = next(number for number in count_up() if f"TEXCOORD_{number}" not in used)
    for one, own in zip(group, charts, strict=True):
        _split_vertices(file, one, own, number)
    return number, [places[faces].astype(np.float32).astype(np.float64) for _, faces, places in charts]


def describe_extensions(tree: Part, group: list[Primitive]) -> Iterator[str]:
    """Yield sentences on extensions that refer, or may refer, to the vertices of primitives with new coordinates by number.

    Args:
        tree: JSON of the file as it was read.
        group: primitives with new coordinates.
    """
    found: dict[str, list[str]] = {}
    for one in group:
        for holder in (one.part, tree.parts("meshes")[one.mesh]):
            for name in holder.part("extensions").content if "extensions" in holder else ():
                found.setdefault(name, []).append(one.name)
    for name, meshes in found.items():
        if name in _BY_VERTEX:
            yield f"new coordinates renumber the vertices of {join_names(meshes)}, and so {name} is left out"
        elif name not in _WITHOUT_VERTICES:
            yield f"new coordinates renumber the vertices of {join_names(meshes)}; {name} is kept, and may have old numbers"


def _split_vertices(file: GlbFile, one: Primitive, charts: MeshCharts, number: int) -> None:
    """Rewrite a primitive with new texture coordinates as set `number`; vertices at chart borders are split.

    The sets below `number` that the primitive lacks get the new coordinates, too, since glTF numbers sets without gaps.
    Extensions that refer to vertices by number are removed.
    """
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
    for holder in (primitive, file.tree["meshes"][one.mesh]):
        for name in holder.get("extensions", {}).keys() & set(_BY_VERTEX):
            del holder["extensions"][name]
            if not holder["extensions"]:
                del holder["extensions"]


def _gather_attributes(file: GlbFile, attributes: Part, vertex: np.ndarray) -> dict[str, int]:
    """Append the attributes of selected vertices to the file; return the new accessors by attribute."""
    return {name: file.add_like(*_gather_rows(file, attributes, name, vertex)) for name in attributes.content}


def _gather_rows(file: GlbFile, attributes: Part, name: str, vertex: np.ndarray) -> tuple[Part, np.ndarray]:
    accessor, array = file.data.rows(attributes, name)
    if vertex.max(initial=0) >= len(array):
        raise ValueError(f"{attributes.at(name)}: got {len(array):,} values, want one for each vertex")
    return accessor, array[vertex]
