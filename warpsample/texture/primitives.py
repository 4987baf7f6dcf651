"""What a .glb places, as its textures need it: primitives, where their faces are in the mesh, and who shares a material."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf import placed_primitives, surface
from warpsample.mesh.files.gltf_data import Data

_VARIANTS = "KHR_materials_variants"


@dataclass(frozen=True, eq=False)
class Primitive:
    """A primitive of triangles, and where the first of its places is in what `load_mesh` gives.

    Attributes:
        mesh: the number of its mesh.
        number: of the primitive in that.
        part: what the file says of it.
        name: of its mesh, or its number.
        faces: rows of the mesh's faces, at the first place.
        vertices: rows of its vertices.
        triangles: (F, 3) its own vertices of these faces, in the order of their corners.
        mirrored: whether that order is the reverse of the file's.
        scale: of lengths at the first place, the cube root of that of volumes.
        materials: the numbers of its materials, those of its variants among them.
        node: the number of the node that places it.
        others: the same primitive at each of its other places.
    """

    mesh: int
    number: int
    part: Part
    name: str
    faces: slice
    vertices: slice
    triangles: np.ndarray
    mirrored: bool
    scale: float
    materials: list[int]
    node: int
    others: list["Primitive"] = field(default_factory=list)


def list_primitives(tree: Part, data: Data) -> list[Primitive]:
    """The primitives that the scene places, each once, in the order of their first places."""
    known = tree.parts("materials")
    faces, vertices = 0, 0
    found: dict[tuple[int, int], Primitive] = {}
    for one in placed_primitives(tree):
        points, triangles = surface(one.primitive, data)
        rows = slice(faces, faces + len(triangles)), slice(vertices, vertices + len(points))
        faces, vertices = rows[0].stop, rows[1].stop
        volume = float(np.linalg.det(one.matrix[:3, :3]))
        mesh = tree.parts("meshes")[one.mesh]
        name = mesh.text("name") if "name" in mesh else mesh.path
        own = triangles[:, ::-1] if volume < 0.0 else triangles
        materials = [part.index("material", known) for part in list_material_references(one.primitive)]
        size = {"mirrored": volume < 0.0, "scale": np.cbrt(abs(volume)), "node": int(one.node.path[len("nodes[") : -1])}
        made = Primitive(one.mesh, one.number, one.primitive, name, *rows, own, materials=materials, **size)
        first = found.setdefault((one.mesh, one.number), made)
        if first is not made:
            first.others.append(made)
    return list(found.values())


def group_by_material(primitives: list[Primitive]) -> Iterator[list[Primitive]]:
    """The primitives by groups, of which no two share a material; those without one are a group."""
    group_of: dict[Any, list[Primitive]] = {}
    for one in primitives:
        known = [group_of[key] for key in one.materials or [None] if key in group_of]
        merged = [*dict.fromkeys(item for group in known for item in group), one]
        for key in {key for item in merged for key in (item.materials or [None])}:
            group_of[key] = merged
    yield from {id(group): group for group in group_of.values()}.values()


def list_material_references(primitive: Part) -> list[Part]:
    """What names a material of a primitive as its member "material": itself, and each of its variants."""
    found = [primitive] if "material" in primitive else []
    if "extensions" in primitive and _VARIANTS in primitive.part("extensions"):
        found += primitive.part("extensions").part(_VARIANTS).parts("mappings")
    return found
