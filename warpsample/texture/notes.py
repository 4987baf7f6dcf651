"""Sentences for the user about what a baked glTF scene cannot show, for example morph targets."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.linked_files import uris_of
from warpsample.mesh.mesh import Mesh
from warpsample.texture.primitives import Primitive
from warpsample.texture.texture_points import TexturePoints, find_rows
from warpsample.tracing.placement import resolutions_at
from warpsample.tracing.scene import scene_of

_ROUNDED = 1e-3  # of a texel: float32 spacing of positions above which the report warns
_COARSE = 0.25  # of a texel; at a ray resolution of 0.6 texels, single texels beside a crate were wrong by 0.8

_FEW = 0.01  # of the points: faces of nearly zero area in space always have small texels
_TRANSMITS, _UNLIT = "KHR_materials_transmission", "KHR_materials_unlit"


def describe_materials(tree: Part, primitives: list[Primitive], picture: str | None = None) -> Iterator[str]:
    """Yield sentences on morph targets, unlit materials and two-sided materials.

    Args:
        tree: JSON of the file.
        primitives: primitives of the scene.
        picture: name of the picture added to the materials; None if no picture is added.
    """
    materials = tree.parts("materials")
    used = [materials[number] for number in sorted({number for one in primitives for number in one.materials})]
    weighted = [number for number, mesh in enumerate(tree.parts("meshes")) if any(mesh.values("weights"))]
    weighted += [node.content.get("mesh") for node in tree.parts("nodes") if any(node.values("weights"))]
    morphed = join_names(one.name for one in primitives if one.mesh in weighted and one.part.parts("targets"))
    if morphed:
        yield f"morph targets are left out, though the file sets their weights: {morphed}"
    unlit = join_names(_name(one) for one in used if _has(one, _UNLIT))
    if unlit and picture is not None:
        yield f"viewers show no {picture} on unlit materials: {unlit}"
    doubled = join_names(_name(one) for one in used if one.flag("doubleSided"))
    if doubled:
        yield f"two-sided materials show the numbers of the front on both sides: {doubled}"


def describe_light(tree: Part, primitives: list[Primitive], mesh: Mesh) -> Iterator[str]:
    """Yield sentences on the light that passes through materials, and on transparent materials that block all light.

    Args:
        tree: JSON of the file.
        primitives: primitives of the scene.
        mesh: mesh as `load_mesh` reads it, with the transmittance of its faces.
    """
    materials = tree.parts("materials")
    shares: dict[str, list[np.ndarray]] = {}
    transparent: dict[str, list[Primitive]] = {}
    for one in primitives:
        if "material" not in one.part:
            continue
        material = materials[one.part.index("material", materials)]
        places = [one, *one.others]
        for place in places if mesh.transmittance is not None else []:
            shares.setdefault(_name(material), []).append(np.unique(mesh.transmittance[place.faces]))
        if _is_transparent(material):
            transparent.setdefault(_name(material), []).extend(places)
    for name, found in shares.items():
        low, high = min(part.min(initial=1.0) for part in found), max(part.max(initial=0.0) for part in found)
        if high > 0.0:
            yield f"faces of {name!r} pass {_percent(low, high)} of the light"
    blocking = {name: row for name, row in transparent.items() if not any(part.any() for part in shares.get(name, []))}
    if blocking:
        parts = _join_parts(mesh, [one for row in blocking.values() for one in row])
        way = f"does not name their parts {parts}" if parts else "gives them no share"
        yield f"transparent materials block all light, since --transmittance {way}: {join_names(blocking)}"


def _join_parts(mesh: Mesh, primitives: list[Primitive]) -> str:
    """Return the names of the parts of primitives, quoted and joined by commas; "" if a part has no name."""
    numbers = [] if mesh.part is None else np.unique(np.concatenate([mesh.part[one.faces] for one in primitives]))
    names = [mesh.parts[number] if number >= 0 else "" for number in numbers]
    return join_names(names) if all(names) else ""


def describe_coarse_texels(points: TexturePoints, traced: Mesh, group: Sequence[Primitive] = ()) -> str | None:
    """Return a warning about texels that are too small for float32 rays, or None without tiny texels.

    Rays are float32 relative to the centre of most of the mesh. A few distant faces lower the resolution of all rays.
    The float64 positions are coarse, too, if the mesh is about 10^15 texels from the origin.

    Args:
        points: texels as points, at the first place.
        traced: mesh that the rays are traced against.
        group: primitives with the points; their other places are looked at, too. Empty for all faces of a file.
    """
    scene, mesh = scene_of(traced, through=True), points.mesh
    faces, count = np.unique(points.face, return_counts=True)
    texels = _image_areas(points, faces)
    for number, (rows, placed) in enumerate(_list_places(faces, group)):
        reach = np.abs(mesh.vertices[mesh.faces[placed]] - scene.centre).max(axis=(1, 2))
        resolution = np.maximum(resolutions_at(scene, reach), np.spacing(np.abs(scene.centre).max() + reach))
        size = np.sqrt(mesh.face_areas[placed] / texels[rows])
        coarse = count[rows] * ((resolution > _COARSE * size) & (size > 0.0))
        if coarse.sum() > _FEW * count[rows].sum():
            face = int(np.argmax(coarse))
            return (
                f"rays resolve lengths above {resolution[face]:.2g}{f' at place {number + 1}' if number else ''}, and "
                f"{coarse.sum():,} points have texels less than 4 times that wide, such as {size[face]:.2g}: leave out "
                "distant faces, and place the mesh near the origin"
            )
    return None


def _list_places(faces: np.ndarray, group: Sequence[Primitive]) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield (rows of faces, the numbers of these faces) for each place of primitives, at first for the given faces."""
    yield np.arange(len(faces)), faces
    for number in range(max((len(one.others) for one in group), default=0)):
        rows, placed = [], []
        for one in (one for one in group if number < len(one.others)):
            own = np.arange(*np.searchsorted(faces, [one.faces.start, one.faces.stop]))
            rows.append(own)
            placed.append(faces[own] - one.faces.start + one.others[number].faces.start)
        yield np.concatenate(rows), np.concatenate(placed)


def describe_rounding(points: TexturePoints, image: np.ndarray) -> Iterator[str]:
    """Yield a sentence if the float32 of an .exr rounds an image of positions by more than a thousandth of a texel.

    Args:
        points: texels as points.
        image: (H, W, 3) float64 positions.
    """
    spacing, size = np.spacing(np.float32(np.abs(image).max())), _texel_sizes(points, np.unique(points.face))
    finest = float(size[size > 0.0].min(initial=np.inf))
    if spacing > _ROUNDED * finest:
        yield (
            f"positions are rounded to multiples of {spacing:.2g}, because an .exr holds float32, and the smallest texels "
            f"are {finest:.2g} wide: an .npz holds float64"
        )


def _texel_sizes(points: TexturePoints, faces: np.ndarray) -> np.ndarray:
    """Return the side of a texel on each of some faces, (n,), in mesh units."""
    return np.sqrt(points.mesh.face_areas[faces] / _image_areas(points, faces))


def _image_areas(points: TexturePoints, faces: np.ndarray) -> np.ndarray:
    """Return the area of some faces in the image, (n,), in texels, above 0."""
    corners = points.corners[find_rows(points, faces)]
    first, second = (corners[:, corner] - corners[:, 0] for corner in (1, 2))
    return np.maximum(0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]), 1e-300)


def describe_missing_files(path: Path, tree: dict[str, Any], output: Path) -> Iterator[str]:
    """Yield a sentence on external files of the input that are not in the folder of the output."""
    files = join_names(uris_of(Part(tree)))
    if files and path.parent.resolve() != output.parent.resolve():
        yield f"{output.name} needs these files in its folder: {files}"


def join_names(names: Iterable[str]) -> str:
    """Return distinct names, quoted and joined by commas; "" without names."""
    return ", ".join(dict.fromkeys(map(repr, names)))


def _percent(low: float, high: float) -> str:
    return f"{100.0 * low:.3g} %" if low == high else f"{100.0 * low:.3g} to {100.0 * high:.3g} %"


def _name(material: Part) -> str:
    return material.text("name") if "name" in material else material.path


def _is_transparent(material: Part) -> bool:
    opaque = "alphaMode" not in material or material.text("alphaMode") == "OPAQUE"
    return not opaque or _has(material, _TRANSMITS)


def _has(material: Part, extension: str) -> bool:
    return "extensions" in material and extension in material.part("extensions")
