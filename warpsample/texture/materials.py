"""Pictures as textures of the materials of a .glb."""

import copy
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from warpsample.host.json_tree import Part
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import Primitive, naming


@dataclass(frozen=True)
class Slot:
    """What a picture is to a material.

    Attributes:
        name: in words.
        key: of the member that names it.
        within: the member that this is in; "" for the material itself.
    """

    name: str
    key: str
    within: str = ""

    def known(self, material: Part) -> Part | None:
        """What a material says of such a picture; None if it has none."""
        if self.within:
            if self.within not in material:
                return None
            material = material.part(self.within)
        return material.part(self.key) if self.key in material else None


OCCLUSION = Slot("occlusion", "occlusionTexture")
BENT_NORMALS = Slot("map of bent normals", "bentNormalTexture", "extras")
"""The standard has no place for it, but for what is of a file's own."""


def add_texture(file: GlbFile, group: list[Primitive], png: bytes, slot: Slot, info: dict[str, Any]) -> Iterator[str]:
    """Gives all materials of a group of primitives a picture, of which `info` is said, and tells what it replaces.

    A material that others use as well, which the scene does not place, is copied first; a group without one gets a new one.
    The picture is read as it is, without a transform of another texture.
    """
    numbers = sorted({number for one in group for number in one.materials})
    name = name_of(file, group)
    texture = {"index": file.add_picture(png, f"{name} {slot.name}"), **info}
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
        if slot.known(Part(material)) is not None:
            yield f"the {slot.name} of material {material.get('name', number)!r} is replaced"
        (material.setdefault(slot.within, {}) if slot.within else material)[slot.key] = dict(texture)


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
