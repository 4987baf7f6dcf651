"""Occlusion as a texture of the materials of a .glb."""

import copy
from collections.abc import Iterator
from typing import Any

from warpsample.host.json_tree import Part
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import Primitive, naming


def add_occlusion(file: GlbFile, group: list[Primitive], png: bytes, *, texcoord: int, strength: float) -> Iterator[str]:
    """Gives all materials of a group of primitives a picture as their occlusion, and tells what it replaces.

    A material that others use as well, which the scene does not place, is copied first; a group without one gets a new one.
    The picture is read as it is, without a transform of another texture.
    """
    numbers = sorted({number for one in group for number in one.materials})
    name = name_of(file, group)
    texture: dict[str, Any] = {"index": file.add_picture(png, f"{name} occlusion")}
    texture |= {"texCoord": texcoord} if texcoord else {}
    texture |= {"strength": strength} if strength != 1.0 else {}
    if not numbers:
        made = file.add_material({"name": name})
        for one in group:
            _primitive(file, one)["material"] = made
        numbers = [made]
    else:
        for number in numbers:
            if _is_shared(file, group, number):
                _copy(file, group, number)
        numbers = sorted({part.content["material"] for one in group for part in naming(Part(_primitive(file, one)))})
    for number in numbers:
        material = file.tree["materials"][number]
        if "occlusionTexture" in material:
            yield f"the occlusion of material {material.get('name', number)!r} is replaced"
        material["occlusionTexture"] = dict(texture)


def name_of(file: GlbFile, group: list[Primitive]) -> str:
    """What a group is called: by its first material, or by its first mesh if it has none."""
    for one in group:
        for number in one.materials:
            return str(file.tree["materials"][number].get("name", f"material {number}"))
    return group[0].name


def _primitive(file: GlbFile, one: Primitive) -> dict[str, Any]:
    found: dict[str, Any] = file.tree["meshes"][one.mesh]["primitives"][one.number]
    return found


def _is_shared(file: GlbFile, group: list[Primitive], number: int) -> bool:
    """Whether a material is also of primitives that are not of the group that all placed ones with it are."""
    own = {(one.mesh, one.number) for one in group}
    for mesh, part in enumerate(file.part.parts("meshes")):
        for i, primitive in enumerate(part.parts("primitives")):
            if (mesh, i) not in own and any(named.content["material"] == number for named in naming(primitive)):
                return True
    return False


def _copy(file: GlbFile, group: list[Primitive], number: int) -> None:
    """Gives a group a copy of a material of its own."""
    made = file.add_material(copy.deepcopy(file.tree["materials"][number]))
    for one in group:
        for named in naming(Part(_primitive(file, one))):
            if named.content["material"] == number:
                named.content["material"] = made
