"""Adding computed pictures to the materials of a .glb as textures."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from warpsample.host.json_tree import Part
from warpsample.texture.animations import drop_channels
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.primitives import Primitive, list_material_references


@dataclass(frozen=True)
class Slot:
    """Texture slot of a glTF material, for example the occlusion or the base colour texture.

    Attributes:
        name: name of the picture in messages.
        key: key of the texture info.
        containers: keys of the objects that contain the texture info, outermost first; empty for the material itself.
        optional: whether the containing objects are added to a material that lacks them. If False, such a material gets no
            picture.
        directed: whether the picture shows directions in the frame of tangent, bitangent and normal.
    """

    name: str
    key: str
    containers: tuple[str, ...] = ()
    optional: bool = True
    directed: bool = False

    def find_holder(self, material: Part) -> Part | None:
        """Return the JSON object of a material that holds this slot's texture info, or None if there is none."""
        for key in self.containers:
            if key not in material:
                return None
            material = material.part(key)
        return material

    def find_info(self, material: Part) -> Part | None:
        """Return this slot's texture info (number of the texture and coordinates) in a material, or None."""
        holder = self.find_holder(material)
        return holder.part(self.key) if holder is not None and self.key in holder else None

    def set_info(self, material: dict[str, Any], info: dict[str, Any], more: dict[str, Any]) -> None:
        """Set this slot's texture info in a material, and the members `more` of the object that holds the info.

        The new texture info keeps the `extras` of the replaced one.
        """
        for key in self.containers:
            material = material.setdefault(key, {})
        replaced = material.get(self.key)
        kept = {"extras": replaced["extras"]} if isinstance(replaced, dict) and "extras" in replaced else {}
        material |= {self.key: info | kept, **more}


OCCLUSION = Slot("occlusion", "occlusionTexture")
_BENT_NORMALS = Slot("map of bent normals", "bentNormalTexture", ("extras",), directed=True)
"""Bent normals are in `extras`, since glTF has no texture for them."""
THICKNESS = Slot("thickness", "thicknessTexture", ("extensions", "KHR_materials_volume"), optional=False)
_NORMALS = Slot("normal map", "normalTexture", directed=True)
_SLOTS_BY_QUANTITY = {"bent-normals": _BENT_NORMALS, "thickness": THICKNESS, "normals": _NORMALS}


def slot_for_quantity(quantity: str) -> Slot:
    """Return the kind of material texture that shows a quantity, by default the occlusion texture."""
    return _SLOTS_BY_QUANTITY.get(quantity, OCCLUSION)


Users = dict[int, list[tuple[tuple[int, int], dict[str, Any]]]]
"""Users of each material: number of the mesh, number of the primitive in the mesh, and the JSON that names the material."""


def find_users(file: GlbFile) -> Users:
    """Return the users of all materials of a file, also in copied meshes and in meshes outside the scene."""
    users: Users = {}
    for mesh, part in enumerate(Part(file.tree).parts("meshes")):
        for number, primitive in enumerate(part.parts("primitives")):
            for content in (named.content for named in list_material_references(primitive)):
                if isinstance(content.get("material"), int):
                    users.setdefault(content["material"], []).append(((mesh, number), content))
    return users


def add_texture(
    file: GlbFile,
    users: Users,
    group: list[Primitive],
    png: bytes,
    slot: Slot,
    *,
    is_first: bool,
    info: dict[str, Any],
    more: dict[str, Any],
) -> Iterator[str]:
    """Add a picture to the materials of a group of primitives, and yield sentences on each picture it replaces.

    The first picture of a material goes to the material itself. Primitives outside the group get an unchanged copy. Any
    other picture goes to a copy, so add the first picture last. Primitives without a material get a new one. Animations of
    replaced values are left out: those of a picture's transform, strength or scale, and those of `more`.

    Args:
        file: file to edit.
        users: users of the materials, as `find_users` returns them; kept up to date.
        group: primitives that share materials.
        png: content of the picture.
        slot: place of the picture in the materials.
        is_first: whether the picture is the first of those for the materials.
        info: further members of the texture info.
        more: further members of the object that contains the texture info.
    """
    numbers = sorted({number for one in group for number in one.materials})
    name = name_group(file, group)
    texture = {"index": file.add_picture(png, f"{name} {slot.name}"), **info}
    own = {(one.mesh, one.number) for one in group}
    for number in numbers:
        _copy_material(file, users, number, own, is_first)
    parts = [_primitive_json(file, one) for one in group]
    bare = [part for part in parts if "material" not in part]  # variants may have materials all the same
    if bare and slot.optional:
        made = file.add_material({"name": name})
        for part in bare:
            part["material"] = made
    numbers = sorted({named.content["material"] for part in parts for named in list_material_references(Part(part))})
    for number in numbers:
        material = file.tree["materials"][number]
        held = slot.find_holder(Part(material))
        if held is None and not slot.optional:
            continue
        named = f"the {slot.name} of material {material.get('name', number)!r}"
        if held is not None and any(held.content.get(key) for key in (slot.key, *more)):
            yield f"{named} is replaced"
        holder = "/".join(("/materials", str(number), *slot.containers))
        if drop_channels(file.tree, [f"{holder}/{key}" for key in (slot.key, *more)]):
            yield f"the animation of {named} is left out"
        slot.set_info(material, texture, more)


def name_group(file: GlbFile, group: list[Primitive]) -> str:
    """Return the name of a group's first material, or of the group's first mesh if it has no material."""
    for one in group:
        for number in one.materials:
            return str(file.tree["materials"][number].get("name", f"material {number}"))
    return group[0].name


def _primitive_json(file: GlbFile, one: Primitive) -> dict[str, Any]:
    found: dict[str, Any] = file.tree["meshes"][one.mesh]["primitives"][one.number]
    return found


def _copy_material(file: GlbFile, users: Users, number: int, own: set[tuple[int, int]], is_first: bool) -> None:
    """Copy a material for its users in `own`, or if `is_first`, for all others; without such users do nothing."""
    kept, moved = list[Any](), list[Any]()
    for user in users[number]:
        (kept if (user[0] in own) == is_first else moved).append(user)
    if moved:
        made = file.copy_item("materials", number)
        for _, content in moved:
            content["material"] = made
        users[number], users[made] = kept, moved
