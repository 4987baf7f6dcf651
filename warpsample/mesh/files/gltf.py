"""Reader of .glb and .gltf files.

trimesh is not used: for a damaged .gltf trimesh reads the file `model.gltf` in the same folder instead.
"""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

import numpy as np

from warpsample.host.arguments import is_file, naming_file, quote
from warpsample.host.json_tree import Part, parsed
from warpsample.host.locks import multiply
from warpsample.mesh.files.gltf_data import Data, binary
from warpsample.mesh.files.gltf_scene import VISIBILITY, count_invisible, iterate_nodes
from warpsample.mesh.files.skins import Skin, posed
from warpsample.mesh.joining import joined, joined_corners, joined_parts, outward
from warpsample.mesh.parts import Named
from warpsample.mesh.polygons import triangles

_TRIANGLES, _STRIP, _FAN = 4, 5, 6
# Unsupported extensions that change the faces.
_EXTENSIONS = {
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    "EXT_mesh_gpu_instancing",
}
# Extensions that a file may require: they change neither the faces nor their places, or this reader follows them.
_READ = (
    *("KHR_mesh_quantization", "KHR_materials_*", "KHR_texture_*", "KHR_lights_*", "KHR_animation_pointer"),
    *(VISIBILITY, "KHR_xmp*", "KHR_techniques_webgl", "KHR_audio*", "KHR_interactivity", "KHR_node_hoverability"),
    *("KHR_node_selectability", "KHR_implicit_shapes", "KHR_physics_*", "EXT_materials_*", "EXT_texture_*", "EXT_lights_*"),
    *("EXT_mesh_features", "EXT_mesh_manifold", "EXT_instance_features", "EXT_feature_metadata", "EXT_structural_metadata"),
    *("ADOBE_materials_*", "AGI_*", "CESIUM_primitive_outline", "FB_*", "GODOT_single_root", "MOZ_lightmap", "MSFT_lod"),
    *("MSFT_packing_*", "MSFT_texture_*", "NV_materials_*", "OMI_*", "VRM", "VRMC_*"),
)
# Versions that are read. A file of version 2.1 can be read as 2.0, unless its `minVersion` is higher.
_VERSIONS = {"version": r"2\.[0-9]+", "minVersion": r"2\.0"}
_WIDTHS = {"NORMAL": 3, "TANGENT": 4}  # components of attributes; others have 2


def read(path: Path) -> Named:
    """Read vertices, faces, and parts of a glTF file's scene, as posed by joints; ignore morph targets, lines and points.

    Nodes that KHR_node_visibility hides are left out, with all nodes below them.

    A part is a node that places a mesh. Its name is the node's name, or else the mesh's name.

    Raises:
        ValueError: A file that is shorter or longer than declared, violates the glTF specification, or is compressed, sparse
            or instanced by an extension, or requires an unknown extension.
    """
    with opened(path) as (tree, data):
        return joined_parts(_surfaces(tree, data))


def read_corners(path: Path, name: str) -> np.ndarray:
    """Read a vertex attribute of a glTF file, for example "NORMAL", at all face corners, (F, 3, k) float64.

    "NORMAL" and "TANGENT" are transformed with their nodes to unit vectors; the fourth number of a tangent changes its sign
    where a node mirrors. Other attributes, such as "TEXCOORD_0", are unchanged. Primitives without the attribute have NaN.
    """
    with opened(path) as (tree, data):
        return joined_corners(_attributes(placed, data, name) for placed in iterate_primitives(tree))


def find_faces_with(path: Path, name: str) -> np.ndarray:
    """Return the (F,) bool mask of the faces whose primitive has a vertex attribute, whatever its values."""
    with opened(path) as (tree, data):
        primitives = [one.primitive for one in iterate_primitives(tree)]
        has_name = [name in primitive.part("attributes") for primitive in primitives]
        return np.repeat(np.array(has_name, bool), [len(surface(primitive, data)[1]) for primitive in primitives])


def describe_invisible(path: Path) -> list[str]:
    """Describe the invisible meshes that `read` leaves out: one sentence in a list, or an empty list without any.

    The list is empty for files of other formats.
    """
    if path.suffix.lower() not in (".glb", ".gltf") or not is_file(path):
        return []
    with naming_file("mesh", path, "a mesh"):
        tree = binary(path, with_data=False)[0] if path.suffix.lower() == ".glb" else parsed(path.read_bytes())
        count = count_invisible(tree)
    what = "one invisible mesh is" if count == 1 else f"{count:,} invisible meshes are"
    return [f"{what} left out ({VISIBILITY})"] if count else []


@contextmanager
def opened(path: Path) -> Iterator[tuple[Part, Data]]:
    """Open a glTF file within a `with` statement, and return its JSON and its arrays."""
    tree, chunk = binary(path) if path.suffix.lower() == ".glb" else (parsed(path.read_bytes()), memoryview(b""))
    try:
        check_supported(tree)
        with np.errstate(all="ignore"):  # `Mesh` refuses coordinates that are not finite
            yield tree, Data.of(tree, path, chunk)
    except (TypeError, FileNotFoundError) as error:  # of the check of one member
        raise ValueError(str(error)) from None


def check_supported(tree: Part) -> None:
    """Raise a ValueError if a glTF file has a version or uses extensions that this reader does not support."""
    asset = tree.part("asset") if "asset" in tree else Part({})
    key = "minVersion" if "minVersion" in asset else "version"
    if key in asset and not re.fullmatch(_VERSIONS[key], asset.text(key)):
        raise ValueError(f"{asset.at(key)}: got {quote(asset.text(key))}, want glTF 2.0; export the file as glTF 2.0")
    at_nodes = {name for node in tree.parts("nodes") if "extensions" in node for name in node.part("extensions").content}
    needed = _EXTENSIONS & (at_nodes | set(tree.texts("extensionsUsed")))
    if needed:
        raise ValueError(f"the file uses {', '.join(sorted(needed))}, want a file without these extensions; export it again")
    unknown = [name for name in tree.texts("extensionsRequired") if not any(fnmatchcase(name, known) for known in _READ)]
    if unknown:
        raise ValueError(f"the file requires {', '.join(unknown)}, want a file that requires none but {', '.join(_READ)}")


@dataclass(frozen=True)
class PlacedPrimitive:
    """Triangle primitive of a glTF file at one place in the scene.

    Attributes:
        node: Node that places the primitive.
        mesh: Index of the primitive's mesh.
        number: Index of the primitive within that mesh.
        primitive: JSON of the primitive.
        matrix: (4, 4) matrix of the node for row vectors, vector @ matrix.
        skin: Joints that pose the primitive, or None. With a skin, the matrix determines only the winding.
    """

    node: Part
    mesh: int
    number: int
    primitive: Part
    matrix: np.ndarray
    skin: Skin | None


def iterate_primitives(tree: Part) -> Iterator[PlacedPrimitive]:
    """Yield the triangle primitives in the scene, once for each placement."""
    meshes = tree.parts("meshes")
    for node, matrix, skin in iterate_nodes(tree):
        if "mesh" in node:
            number = node.index("mesh", meshes)
            yield from (PlacedPrimitive(node, number, i, p, matrix, skin) for i, p in _faced(meshes[number]))


def _faced(mesh: Part) -> list[tuple[int, Part]]:
    """Return the primitives of a glTF mesh that consist of triangles, each with its index."""
    primitives = enumerate(mesh.parts("primitives"))
    return [(i, p) for i, p in primitives if p.whole("mode", _TRIANGLES, _FAN) >= _TRIANGLES]


def _attributes(placed: PlacedPrimitive, data: Data, name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Read a vertex attribute of a primitive; return (values, triangles, matrix), with NaN for a missing attribute."""
    points, triangles = surface(placed.primitive, data)
    attributes, width = placed.primitive.part("attributes"), _WIDTHS.get(name, 2)
    if name not in attributes:
        return np.full((len(points), width), np.nan), triangles, placed.matrix
    values = data.vectors(attributes, name, width).astype(np.float64)
    if len(values) != len(points):
        raise ValueError(
            f"{attributes.at(name)}: got {len(values):,} values, want one for each of {len(points):,} positions"
        )
    turned = {"NORMAL": turn_normals, "TANGENT": _turned_tangents}.get(name)
    if turned is not None:
        poses = placed.skin and placed.skin.poses(placed.primitive, data)
        values = turned(values, placed.matrix if poses is None else poses)
    return values, triangles, placed.matrix


def _turned_tangents(tangents: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """Transform tangents, (V, 4), by one matrix, or by one matrix per vertex, and normalise the vectors."""
    rows = matrix[..., :3, :3]
    along = _times(tangents[:, :3], rows)
    sign = tangents[:, 3:] * np.sign(np.linalg.det(rows)).reshape(-1, 1)
    return np.concatenate([along / np.linalg.norm(along, axis=1, keepdims=True), sign], axis=1)


def turn_normals(normals: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """Transform unit normals, (V, 3), by one matrix, or by one per vertex; return unit vectors.

    The result is NaN where the matrix is singular.
    """
    rows = matrix[..., :3, :3]
    inverse = np.cross(rows[..., [1, 2, 0], :], rows[..., [2, 0, 1], :])  # columns of the inverse, times the determinant
    turned = _times(normals, inverse * np.sign(np.linalg.det(rows))[..., None, None])
    return turned / np.linalg.norm(turned, axis=1, keepdims=True)


def _times(vectors: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Multiply vectors (V, 3) by one (3, 3) matrix, or by one matrix per vector."""
    return multiply(vectors, rows) if rows.ndim == 2 else np.einsum("vi,vij->vj", vectors, rows)


def _surfaces(tree: Part, data: Data) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray | None, str]]:
    """Yield (points, triangles, matrix, name) of each mesh in the scene, once for each of its places."""
    meshes = tree.parts("meshes")
    found: dict[int, tuple[np.ndarray, np.ndarray] | None] = {}
    for node, matrix, skin in iterate_nodes(tree):
        if "mesh" not in node:
            continue
        number = node.index("mesh", meshes)
        faced = _faced(meshes[number])
        if skin is None and number not in found:
            found[number] = joined((*surface(p, data), None) for _, p in faced) if faced else None
        known = found[number] if skin is None else _skinned(faced, data, skin, matrix)
        if known is not None:
            names = [part.text("name") for part in (node, meshes[number]) if "name" in part]
            yield (*known, matrix if skin is None else None, next(filter(None, names), ""))


def _skinned(
    faced: list[tuple[int, Part]], data: Data, skin: Skin, matrix: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return points and triangles of a glTF mesh that is deformed by the joints of a skin."""

    def pose_primitive(primitive: Part) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
        """Return (points, triangles, matrix) of a primitive, deformed by its joints if it has any."""
        points, triangles = surface(primitive, data)
        poses = skin.poses(primitive, data)
        return (points, triangles, matrix) if poses is None else (posed(points, poses), outward(triangles, matrix), None)

    return joined(pose_primitive(primitive) for _, primitive in faced) if faced else None


def surface(primitive: Part, data: Data) -> tuple[np.ndarray, np.ndarray]:
    """Return the points (V, 3) and triangles (F, 3) of a primitive, before its node's matrix is applied."""
    points = data.vectors(primitive.part("attributes"), "POSITION")
    corners = data.indices(primitive, "indices") if "indices" in primitive else np.arange(len(points), dtype=np.int32)
    mode = primitive.whole("mode", _TRIANGLES)
    if mode != _TRIANGLES:
        first = np.arange(max(len(corners) - 2, 0))
        odd = first % 2
        rows = (first, first + 1 + odd, first + 2 - odd) if mode == _STRIP else (first + 1, first + 2, 0 * first)
        corners = corners[np.stack(rows, axis=1).ravel()]
    return points, triangles(points, np.broadcast_to(3, len(corners) // 3), corners)
