"""Pictures as textures of the materials of a .glb."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from warpsample.host.json_tree import Part
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import Primitive, list_material_references


@dataclass(frozen=True)
class Slot:
    """What a picture is to a material.

    Attributes:
        name: in words.
        key: of the member that names it.
        within: the members that this is in, from the outer one; none for the material itself.
        optional: whether a material gets these where it has none; others are left alone.
        directed: whether it shows directions, in the frame of tangent, bitangent and normal.
    """

    name: str
    key: str
    within: tuple[str, ...] = ()
    optional: bool = True
    directed: bool = False

    def find_holder(self, material: Part) -> Part | None:
        """What of a material holds such a picture; None if it is not there."""
        for key in self.within:
            if key not in material:
                return None
            material = material.part(key)
        return material

    def find_info(self, material: Part) -> Part | None:
        """What a material says of such a picture; None if it has none."""
        holder = self.find_holder(material)
        return holder.part(self.key) if holder is not None and self.key in holder else None

    def set_info(self, material: dict[str, Any], info: dict[str, Any], more: dict[str, Any]) -> None:
        """Says of a material that it has such a picture, and more beside it."""
        for key in self.within:
            material = material.setdefault(key, {})
        material |= {self.key: info, **more}


OCCLUSION = Slot("occlusion", "occlusionTexture")
_BENT_NORMALS = Slot("map of bent normals", "bentNormalTexture", ("extras",), directed=True)
"""The standard has no place for it, but for what is of a file's own."""
THICKNESS = Slot("thickness", "thicknessTexture", ("extensions", "KHR_materials_volume"), optional=False)
_NORMALS = Slot("normal map", "normalTexture", directed=True)
_SLOTS_BY_QUANTITY = {"bent-normals": _BENT_NORMALS, "thickness": THICKNESS, "normals": _NORMALS}


def slot_for_quantity(quantity: str) -> Slot:
    """What a picture of a quantity is to a material: of all others it is its occlusion."""
    return _SLOTS_BY_QUANTITY.get(quantity, OCCLUSION)


def add_texture(
    file: GlbFile, group: list[Primitive], png: bytes, slot: Slot, *, info: dict[str, Any], more: dict[str, Any]
) -> Iterator[str]:
    """Gives all materials of a group of primitives a picture, and tells what it replaces.

    `info` is said of the picture, and `more` of the material beside it.

    A material that others use as well, which the scene does not place, is copied first; a group without one gets a new one.
    The picture is read as it is, without a transform of another texture.
    """
    numbers = sorted({number for one in group for number in one.materials})
    name = name_group(file, group)
    texture = {"index": file.add_picture(png, f"{name} {slot.name}"), **info}
    if not numbers:
        made = file.add_material({"name": name})
        for one in group:
            _primitive_json(file, one)["material"] = made
        numbers = [made]
    else:
        for number in numbers:
            if _is_used_elsewhere(file, group, number):
                _copy_material(file, group, number)
        numbers = sorted(
            {
                part.content["material"]
                for one in group
                for part in list_material_references(Part(_primitive_json(file, one)))
            }
        )
    for number in numbers:
        material = file.tree["materials"][number]
        if not slot.optional and slot.find_holder(Part(material)) is None:
            continue
        if slot.find_info(Part(material)) is not None:
            yield f"the {slot.name} of material {material.get('name', number)!r} is replaced"
        slot.set_info(material, dict(texture), more)


def name_group(file: GlbFile, group: list[Primitive]) -> str:
    """What a group is called: by its first material, or by its first mesh if it has none."""
    for one in group:
        for number in one.materials:
            return str(file.tree["materials"][number].get("name", f"material {number}"))
    return group[0].name


def _primitive_json(file: GlbFile, one: Primitive) -> dict[str, Any]:
    found: dict[str, Any] = file.tree["meshes"][one.mesh]["primitives"][one.number]
    return found


def _is_used_elsewhere(file: GlbFile, group: list[Primitive], number: int) -> bool:
    """Whether a material is also of primitives that are not of the group that all placed ones with it are."""
    own = {(one.mesh, one.number) for one in group}
    for mesh, part in enumerate(file.part.parts("meshes")):
        for i, primitive in enumerate(part.parts("primitives")):
            if (mesh, i) not in own and any(
                named.content["material"] == number for named in list_material_references(primitive)
            ):
                return True
    return False


def _copy_material(file: GlbFile, group: list[Primitive], number: int) -> None:
    """Gives a group a copy of a material of its own."""
    made = file.add_material(json.loads(json.dumps(file.tree["materials"][number])))
    for one in group:
        for named in list_material_references(Part(_primitive_json(file, one))):
            if named.content["material"] == number:
                named.content["material"] = made
