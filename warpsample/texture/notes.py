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


def describe_materials(tree: Part, primitives: list[Primitive], picture: str | None = None) -> Iterator[str]:
    """Sentences on meshes with morph targets, and on materials: unlit, with two sides."""
    materials = tree.parts("materials")
    used = [materials[number] for number in sorted({number for one in primitives for number in one.materials})]
    morphed = join_names(one.name for one in primitives if _is_morphed(tree, one))
    if morphed:
        yield f"morph targets are left out, though the file gives them weights: {morphed}"
    unlit = join_names(_name(one) for one in used if _has(one, _UNLIT))
    if unlit and picture is not None:
        yield f"viewers show no {picture} on materials that are unlit: {unlit}"
    doubled = join_names(_name(one) for one in used if one.flag("doubleSided"))
    if doubled:
        yield f"of materials with two sides the numbers are those of the front: {doubled}"


def describe_light(tree: Part, primitives: list[Primitive], transmittance: np.ndarray | None) -> Iterator[str]:
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
    blocking = join_names(name for name in transparent if not any(part.max(initial=0.0) for part in shares[name]))
    if blocking:
        yield f"transparent materials that block all light, as --transmittance gives them no share: {blocking}"


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


def describe_missing_files(path: Path, tree: dict[str, Any], output: Path) -> Iterator[str]:
    """A sentence on the files that a tree names, as they lie beside `path` and not beside what is written."""
    files = join_names(uris_of(Part(tree)))
    if files and path.parent.resolve() != output.parent.resolve():
        yield f"{output.name} wants these files beside it: {files}"


def join_names(names: Iterable[str]) -> str:
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
