"""What is to be said of baking into a scene, where a number at a texel stands for less than one might think."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.beside import uris_of
from warpsample.texture.primitives import Primitive

_TRANSMITS, _UNLIT = "KHR_materials_transmission", "KHR_materials_unlit"


def notes_on(tree: Part, primitives: list[Primitive], picture: str | None = None) -> Iterator[str]:
    """Sentences on meshes in several places or with morph targets, and on materials: unlit, with two sides."""
    several = named(one.name for one in primitives if one.places > 1)
    if several:
        yield f"of {several}, in several places, the first one counts"
    materials = tree.parts("materials")
    used = [materials[number] for number in sorted({number for one in primitives for number in one.materials})]
    morphed = named(one.name for one in primitives if _is_morphed(tree, one))
    if morphed:
        yield f"morph targets are left out, though the file gives them weights: {morphed}"
    unlit = named(_name(one) for one in used if _has(one, _UNLIT))
    if unlit and picture is not None:
        yield f"viewers show no {picture} on materials that are unlit: {unlit}"
    doubled = named(_name(one) for one in used if one.flag("doubleSided"))
    if doubled:
        yield f"of materials with two sides the numbers are those of the front: {doubled}"


def notes_on_light(tree: Part, primitives: list[Primitive], transmittance: np.ndarray | None) -> Iterator[str]:
    """Return sentences on how much light passes through the faces of materials: transparent ones, and those with a share.

    Args:
        tree: the JSON of the file.
        primitives: those that the scene places.
        transmittance: (F,) the shares of all faces that the rays of the run meet; None if all of them block light.
    """
    materials = tree.parts("materials")
    shares: dict[str, list[np.ndarray]] = {}
    transparent: dict[str, None] = {}
    for one in primitives:
        if "material" not in one.part:
            continue
        material = materials[one.part.index("material", materials)]
        passing = np.zeros(1) if transmittance is None else np.unique(transmittance[one.faces])
        shares.setdefault(_name(material), []).append(passing)
        if _is_transparent(material):
            transparent[_name(material)] = None
    for name, found in shares.items():
        low, high = min(part.min(initial=1.0) for part in found), max(part.max(initial=0.0) for part in found)
        if high > 0.0:
            yield f"faces of {name!r} pass {_percent(low, high)} of the light"
    blocking = named(name for name in transparent if not any(part.max(initial=0.0) for part in shares[name]))
    if blocking:
        yield f"transparent materials that block all light, as --transmittance gives them no share: {blocking}"


def left_behind(path: Path, tree: dict[str, Any], output: Path) -> Iterator[str]:
    """A sentence on the files that a tree names, as they lie beside `path` and not beside what is written."""
    files = named(uris_of(Part(tree)))
    if files and path.parent.resolve() != output.parent.resolve():
        yield f"{output.name} wants these files beside it: {files}"


def named(names: Iterable[str]) -> str:
    """Names in a sentence, each once; "" for none."""
    return ", ".join(dict.fromkeys(map(repr, names)))


def _percent(low: float, high: float) -> str:
    return f"{100.0 * low:.3g} %" if low == high else f"{100.0 * low:.3g} to {100.0 * high:.3g} %"


def _name(material: Part) -> str:
    return material.text("name") if "name" in material else material.path


def _is_morphed(tree: Part, one: Primitive) -> bool:
    """Whether a primitive has morph targets to which its mesh, or a node that places that, gives weights."""
    nodes = (node for node in tree.parts("nodes") if node.content.get("mesh") == one.mesh)
    holders = [tree.parts("meshes")[one.mesh], *nodes]
    return bool(one.part.parts("targets")) and any(any(holder.values("weights")) for holder in holders)


def _is_transparent(material: Part) -> bool:
    opaque = "alphaMode" not in material or material.text("alphaMode") == "OPAQUE"
    return not opaque or _has(material, _TRANSMITS)


def _has(material: Part, extension: str) -> bool:
    return "extensions" in material and extension in material.part("extensions")
