"""What is to be said of baking into a scene, where a number at a texel stands for less than one might think."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.beside import uris_of
from warpsample.mesh.mesh import Mesh
from warpsample.texture.primitives import Primitive
from warpsample.texture.texture_points import TexturePoints
from warpsample.tracing.placement import OFFSET
from warpsample.tracing.scene import scene_of

_COARSE = 0.25  # of a texel: geometry that near counts as touching; 0.6 of one moved single texels beside a crate by 0.8

_FEW = 0.01  # of the points: a face that is all but flat in space has small texels anywhere
_TRANSMITS, _UNLIT = "KHR_materials_transmission", "KHR_materials_unlit"


def notes_on(tree: Part, primitives: list[Primitive]) -> Iterator[str]:
    """Sentences on meshes with morph targets, and on materials: unlit, transparent, with two sides."""
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


def describe_coarse_texels(points: TexturePoints, traced: Mesh) -> str | None:
    """Return a sentence on texels smaller than 4 times the resolution of their rays, or None without such texels.

    Rays are float32 relative to the centre of most of the mesh, so that a few faces at a great distance make all coarse.

    Args:
        points: the texels.
        traced: the mesh whose faces the rays meet.
    """
    scene = scene_of(traced, through=True)
    corners, mesh = points.corners, points.mesh
    faces = np.unique(points.face)
    reach = np.abs(mesh.vertices[mesh.faces[faces]] - scene.centre).max(axis=(1, 2))
    resolution = OFFSET * np.maximum(reach, scene.spread.max() / scene.scale)
    first, second = (corners[faces, corner] - corners[faces, 0] for corner in (1, 2))
    texels = 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    size = np.sqrt(mesh.face_areas[faces] / np.maximum(texels, 1e-300))
    coarse = (resolution > _COARSE * size) & (size > 0.0)
    count = np.bincount(np.searchsorted(faces, points.face), minlength=len(faces)) * coarse
    if count.sum() <= _FEW * len(points):
        return None
    face = int(np.argmax(count))
    return (
        f"rays resolve lengths from {resolution[face]:.2g} on, and {count.sum():,} points have texels less than 4 times as "
        f"wide, such as {size[face]:.2g}: leave out faces at a great distance"
    )


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
