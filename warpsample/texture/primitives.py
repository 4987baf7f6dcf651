"""Triangle primitives of a glTF scene: their faces in the loaded mesh, their places, and their materials."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf import iterate_primitives, surface
from warpsample.mesh.files.gltf_data import Data
from warpsample.mesh.mesh import Mesh

_VARIANTS = "KHR_materials_variants"
_ROUNDING = 1e-6
"""Largest relative difference between scales that counts as rounding of float32 normals and matrices."""
_FLAT = 1e-9  # of the volume for equal scales: a matrix with less has rounding errors in place of one direction
_LEAST = 1e-30  # least share of the area
_MARGIN = 0.7  # of mean logarithms: a crate flattened to less than a tenth of its height
_UNEVEN = 1e-5  # largest relative difference of squared scales that turns tangents by less than a picture's rounding


@dataclass(frozen=True, eq=False)
class Primitive:
    """Triangle primitive of a glTF scene, with its faces in the mesh that `load_mesh` returns.

    Attributes:
        mesh: number of the glTF mesh.
        number: number of the primitive in the glTF mesh.
        part: JSON of the primitive.
        name: name of the glTF mesh, or its path in the file.
        faces: rows of the loaded mesh's faces, at the first place.
        vertices: rows of the loaded mesh's vertices, at the first place.
        triangles: (F, 3) vertices of the faces, counted within the primitive.
        mirrored: whether the place mirrors the primitive. If so, the corner order is the reverse of the file's.
        scale: scale of lengths at the place: the cube root of the scale of volumes; 1 with a skin.
        matrix: matrix from vectors in the mesh to those in the scene, vector @ matrix; (3, 3), or (V, 3, 3) with a skin.
        materials: numbers of the primitive's material and of its material variants.
        node: number of the node that places the primitive.
        points: (V, 3) positions of the vertices in the mesh, before the node or the joints place them.
        others: the same primitive at its other places; `visible_primitives` leaves out places without an area.
    """

    mesh: int
    number: int
    part: Part
    name: str
    faces: slice
    vertices: slice
    triangles: np.ndarray
    mirrored: bool
    scale: float
    matrix: np.ndarray
    materials: list[int]
    node: int
    points: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))
    others: list["Primitive"] = field(default_factory=list)

    @cached_property
    def inverse(self) -> np.ndarray:
        """Inverse of `matrix`; a direction that the matrix flattens to 0 stays 0."""
        return np.linalg.pinv(self.matrix)

    @property
    def is_distorted(self) -> bool:
        """Whether the place changes angles, but flattens nothing: by scales that differ by axis, or by several joints."""
        rows = self.matrix.reshape(-1, 3, 3)
        squares = rows @ rows.transpose(0, 2, 1)
        size = np.trace(squares, axis1=1, axis2=2) / 3.0
        if (np.abs(np.linalg.det(rows)) <= _FLAT * size * np.sqrt(size)).any():
            return False
        is_uniform = np.abs(squares - size[:, None, None] * np.eye(3)).max(axis=(1, 2)) <= _UNEVEN * size
        return not is_uniform.all() or float(np.abs(rows - rows[:1]).max(initial=0.0)) > 0.0

    def convert_lengths(
        self, lengths: np.ndarray, directions: np.ndarray, face: np.ndarray, weights: np.ndarray
    ) -> np.ndarray:
        """Return lengths along directions in the scene as lengths in the mesh's own space, (P,) float64.

        A length along a direction that the place flattens to 0 becomes NaN.

        KHR_materials_volume defines thickness in the coordinate space of the mesh, so the whole matrix counts. Shaders of
        glTF-Sample-Viewer and three.js multiply by the lengths of the matrix' columns along the axes of the scene instead.
        The rules agree for scales along the axes of a node that is not rotated, if the direction is one of these axes.

        Args:
            lengths: (P,) lengths in the scene.
            directions: (P, 3) directions in the scene, of any length.
            face: (P,) face of each point in the loaded mesh.
            weights: (P, 3) barycentric weights of each point.
        """
        at = self.triangles[face - self.faces.start]

        def transform(matrix: np.ndarray) -> np.ndarray:
            """Return the directions, multiplied by a matrix or by the mean of the matrices of each vertex."""
            mean = np.einsum("pk,pkij->pij", weights, matrix[at]) if matrix.ndim == 3 else matrix
            return (directions[:, None].astype(np.float64) @ mean)[:, 0]

        length = np.linalg.norm(directions, axis=1)
        kept = np.linalg.norm(transform(self.inverse @ self.matrix), axis=1) > 0.5 * length
        with np.errstate(divide="ignore", invalid="ignore"):  # directions of length 0 are of points without a value
            stretch = np.where(kept, np.linalg.norm(transform(self.inverse), axis=1) / length, np.nan)
            is_uniform = np.abs(stretch * self.scale - 1.0) < _ROUNDING
            return lengths / np.where(is_uniform, self.scale, 1.0 / stretch)


def list_primitives(tree: Part, data: Data) -> list[Primitive]:
    """List each triangle primitive of the scene once; its attribute `others` holds the other nodes that show it."""
    known, meshes = tree.parts("materials"), tree.parts("meshes")
    faces, vertices = 0, 0
    found: dict[tuple[int, int], Primitive] = {}
    for one in iterate_primitives(tree):
        points, triangles = surface(one.primitive, data)
        rows = slice(faces, faces + len(triangles)), slice(vertices, vertices + len(points))
        faces, vertices = rows[0].stop, rows[1].stop
        volume = float(np.linalg.det(one.matrix[:3, :3]))
        mesh = meshes[one.mesh]
        name = mesh.text("name") if "name" in mesh else mesh.path
        own = triangles[:, ::-1] if volume < 0.0 else triangles
        materials = [part.index("material", known) for part in list_material_references(one.primitive)]
        poses = one.skin and one.skin.poses(one.primitive, data)  # joints place a skin, and its node does not
        scale, moves = (np.cbrt(abs(volume)), one.matrix) if poses is None else (1.0, poses)
        place = {"mirrored": volume < 0.0, "scale": scale, "matrix": moves[..., :3, :3].copy(), "points": points}
        node = int(one.node.path[len("nodes[") : -1])
        made = Primitive(one.mesh, one.number, one.primitive, name, *rows, own, materials=materials, node=node, **place)
        first = found.setdefault((one.mesh, one.number), made)
        if first is not made:
            first.others.append(made)
    return list(found.values())


def visible_primitives(primitives: list[Primitive], mesh: Mesh) -> list[Primitive]:
    """Remove places at which a primitive has no area (for example with a scale of 0), and return the primitives.

    The first place with an area becomes the first place, or the least distorted one if that place flattens the mesh: the
    first place decides about texture coordinates. Primitives without a place with an area are unchanged.

    Args:
        primitives: primitives as `list_primitives` returns them.
        mesh: mesh as `load_mesh` reads it.
    """
    meshes: dict[int, list[Primitive]] = {}
    for one in primitives:
        meshes.setdefault(one.mesh, []).append(one)
    first = {number: _find_first_place(own, mesh) for number, own in meshes.items()}
    found = []
    for one in primitives:
        places = [one, *one.others]
        places.insert(0, places.pop(first[one.mesh]))
        visible = [place for place in places if not is_flat(mesh, [place])]
        found.append(replace(visible[0], others=visible[1:]) if visible else one)
    return found


def _find_first_place(primitives: list[Primitive], mesh: Mesh) -> int:
    """Return the number of the place of a mesh that decides about texture coordinates, by the primitives of the mesh.

    That is the first place with an area, or the place at which the areas of faces are most even, if the mean logarithm of
    their shares is larger there by `_MARGIN`. Scales that are equal along all axes change no shares.
    """
    evenness = []
    for places in zip(*([one, *one.others] for one in primitives), strict=True):
        areas = np.concatenate([mesh.face_areas[place.faces] for place in places])
        total = areas.sum()
        evenness.append(np.log(np.maximum(areas / total, _LEAST)).mean() if total > 0.0 else -np.inf)
    first = next((number for number, even in enumerate(evenness) if even > -np.inf), 0)
    best = int(np.argmax(evenness))
    return best if evenness[best] > evenness[first] + _MARGIN else first


def is_flat(mesh: Mesh, group: list[Primitive]) -> bool:
    """Return whether all faces of a group of primitives have zero area, at the first place of each primitive."""
    return not any(mesh.face_areas[one.faces].any() for one in group)


def group_by_material(primitives: list[Primitive]) -> Iterator[list[Primitive]]:
    """Yield groups of primitives that share materials; different groups have no material in common.

    All primitives without a material are one group.
    """
    group_of: dict[Any, list[Primitive]] = {}
    for one in primitives:
        keys = one.materials or [None]
        known = list({id(group): group for group in (group_of[key] for key in keys if key in group_of)}.values())
        merged, joined = (known[0], known[1:]) if known else ([], [])
        merged += [*(item for group in joined for item in group), one]
        moved = [*keys, *(key for group in joined for item in group for key in (item.materials or [None]))]
        group_of.update(dict.fromkeys(moved, merged))
    yield from {id(group): group for group in group_of.values()}.values()


def list_material_references(primitive: Part) -> list[Part]:
    """Return the objects with a "material" member: the primitive itself and each of its material variants."""
    found = [primitive] if "material" in primitive else []
    if "extensions" in primitive and _VARIANTS in primitive.part("extensions"):
        found += primitive.part("extensions").part(_VARIANTS).parts("mappings")
    return found
