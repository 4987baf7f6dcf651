"""What is to be said of baking into a scene, where a number at a texel stands for less than one might think."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from warpsample.host.json_tree import Part
from warpsample.mesh.files.beside import uris_of
from warpsample.texture.primitives import Primitive

_TRANSMITS, _UNLIT = "KHR_materials_transmission", "KHR_materials_unlit"


def notes_on(tree: Part, primitives: list[Primitive]) -> Iterator[str]:
    """Sentences on meshes in several places or with morph targets, and on materials: unlit, transparent, with two sides."""
    several = named(one.name for one in primitives if one.places > 1)
    if several:
        yield f"of {several}, in several places, the first one counts"
    materials = tree.parts("materials")
    used = [materials[number] for number in sorted({number for one in primitives for number in one.materials})]
    morphed = named(one.name for one in primitives if _is_morphed(tree, one))
    if morphed:
        yield f"morph targets are left out, though the file gives them weights: {morphed}"
    unlit = named(_name(one) for one in used if _has(one, _UNLIT))
    if unlit:
        yield f"viewers show no occlusion on materials that are unlit: {unlit}"
    through = named(_name(one) for one in used if _lets_through(one))
    if through:
        yield f"transparent materials block light as all others do: {through}"
    doubled = named(_name(one) for one in used if one.flag("doubleSided"))
    if doubled:
        yield f"of materials with two sides the numbers are those of the front: {doubled}"


def left_behind(path: Path, tree: dict[str, Any], output: Path) -> Iterator[str]:
    """A sentence on the files that a tree names, as they lie beside `path` and not beside what is written."""
    files = named(uris_of(Part(tree)))
    if files and path.parent.resolve() != output.parent.resolve():
        yield f"{output.name} wants these files beside it: {files}"


def named(names: Iterable[str]) -> str:
    """Names in a sentence, each once; "" for none."""
    return ", ".join(dict.fromkeys(map(repr, names)))


def _name(material: Part) -> str:
    return material.text("name") if "name" in material else material.path


def _is_morphed(tree: Part, one: Primitive) -> bool:
    """Whether a primitive has morph targets to which its mesh, or a node that places that, gives weights."""
    nodes = (node for node in tree.parts("nodes") if node.content.get("mesh") == one.mesh)
    holders = [tree.parts("meshes")[one.mesh], *nodes]
    return bool(one.part.parts("targets")) and any(any(holder.values("weights")) for holder in holders)


def _lets_through(material: Part) -> bool:
    opaque = "alphaMode" not in material or material.text("alphaMode") == "OPAQUE"
    return not opaque or _has(material, _TRANSMITS)


def _has(material: Part, extension: str) -> bool:
    return "extensions" in material and extension in material.part("extensions")
