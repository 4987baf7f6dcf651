"""What is to be said of baking into a scene, where a number at a texel stands for less than one might think."""

from collections.abc import Iterable, Iterator

from warpsample.host.json_tree import Part
from warpsample.texture.primitives import Primitive

_TRANSMITS = "KHR_materials_transmission"


def notes_on(tree: Part, primitives: list[Primitive]) -> Iterator[str]:
    """Sentences on meshes in several places, on materials that let light through, and on those of two sides."""
    several = named(one.name for one in primitives if one.places > 1)
    if several:
        yield f"of {several}, in several places, the first one counts"
    materials = tree.parts("materials")
    used = [materials[number] for number in sorted({number for one in primitives for number in one.materials})]
    through = named(_name(one) for one in used if _lets_through(one))
    if through:
        yield f"transparent materials block light as all others do: {through}"
    doubled = named(_name(one) for one in used if one.flag("doubleSided"))
    if doubled:
        yield f"of materials with two sides the numbers are those of the front: {doubled}"


def named(names: Iterable[str]) -> str:
    """Names in a sentence, each once; "" for none."""
    return ", ".join(dict.fromkeys(map(repr, names)))


def _name(material: Part) -> str:
    return material.text("name") if "name" in material else material.path


def _lets_through(material: Part) -> bool:
    opaque = "alphaMode" not in material or material.text("alphaMode") == "OPAQUE"
    return not opaque or ("extensions" in material and _TRANSMITS in material.part("extensions"))
