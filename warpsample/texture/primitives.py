"""Triangle primitives of a glTF scene: their faces in the loaded mesh, their places, and their materials."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf import iterate_primitives, surface
from warpsample.mesh.files.gltf_data import Data
from warpsample.mesh.mesh import Mesh

_VARIANTS = "KHR_materials_variants"


@dataclass(frozen=True, eq=False)
class Primitive:
    """Triangle primitive of a glTF scene, with its faces in the mesh that `load_mesh` returns.

    Attributes:
        mesh: number of the glTF mesh.
        number: number of the primitive in the glTF mesh.
        part: JSON of the primitive.
        name: name of the glTF mesh, or its path in the file.
        faces: rows of the loaded mesh's faces, at the first place.
        vertices: rows of the loaded mesh's vertices, at the first place.
        triangles: (F, 3) vertices of the faces, counted within the primitive.
        mirrored: whether the place mirrors the primitive. If so, the corner order is the reverse of the file's.
        scale: scale of lengths at the place: the cube root of the scale of volumes.
        materials: numbers of the primitive's material and of its material variants.
        node: number of the node that places the primitive.
        others: the same primitive at its other places; `visible_primitives` leaves out places without an area.
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
    """Return the triangle primitives of the scene, each once, with all its places in `others`."""
    known = tree.parts("materials")
    faces, vertices = 0, 0
    found: dict[tuple[int, int], Primitive] = {}
    for one in iterate_primitives(tree):
        points, triangles = surface(one.primitive, data)
        rows = slice(faces, faces + len(triangles)), slice(vertices, vertices + len(points))
        faces, vertices = rows[0].stop, rows[1].stop
        volume = float(np.linalg.det(one.matrix[:3, :3]))
        mesh = tree.parts("meshes")[one.mesh]
        name = mesh.text("name") if "name" in mesh else mesh.path
        own = triangles[:, ::-1] if volume < 0.0 else triangles
        materials = [part.index("material", known) for part in list_material_references(one.primitive)]
        scale = 1.0 if "skin" in one.node else np.cbrt(abs(volume))  # joints place a skin, and its node does not
        size = {"mirrored": volume < 0.0, "scale": scale, "node": int(one.node.path[len("nodes[") : -1])}
        made = Primitive(one.mesh, one.number, one.primitive, name, *rows, own, materials=materials, **size)
        first = found.setdefault((one.mesh, one.number), made)
        if first is not made:
            first.others.append(made)
    return list(found.values())


def visible_primitives(primitives: list[Primitive], mesh: Mesh) -> list[Primitive]:
    """Remove places at which a primitive has no area (for example with a scale of 0), and return the primitives.

    The first place with an area becomes the first place. Primitives without such a place are unchanged.

    Args:
        primitives: primitives as `list_primitives` returns them.
        mesh: mesh as `load_mesh` reads it.
    """
    found = []
    for one in primitives:
        visible = [place for place in (one, *one.others) if not is_flat(mesh, [place])]
        found.append(replace(visible[0], others=visible[1:]) if visible else one)
    return found


def is_flat(mesh: Mesh, group: list[Primitive]) -> bool:
    """Return whether all faces of a group of primitives have zero area, at the first place of each primitive."""
    return not any(mesh.face_areas[one.faces].any() for one in group)


def group_by_material(primitives: list[Primitive]) -> Iterator[list[Primitive]]:
    """Yield groups of primitives that share materials; different groups have no material in common.

    All primitives without a material are one group.
    """
    group_of: dict[Any, list[Primitive]] = {}
    for one in primitives:
        known = [group_of[key] for key in one.materials or [None] if key in group_of]
        merged = [*dict.fromkeys(item for group in known for item in group), one]
        for key in {key for item in merged for key in (item.materials or [None])}:
            group_of[key] = merged
    yield from {id(group): group for group in group_of.values()}.values()


def list_material_references(primitive: Part) -> list[Part]:
    """Return the objects with a "material" member: the primitive itself and each of its material variants."""
    found = [primitive] if "material" in primitive else []
    if "extensions" in primitive and _VARIANTS in primitive.part("extensions"):
        found += primitive.part("extensions").part(_VARIANTS).parts("mappings")
    return found
