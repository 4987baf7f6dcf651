"""Tangent frames of viewers, by MikkTSpace, and components of vectors in the frames."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.host.arguments import naming_file
from warpsample.mesh.files.gltf import find_faces_with, opened, read_corners
from warpsample.mesh.files.normals import read_normals
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.tangents import compute_tangents
from warpsample.texture.primitives import Primitive, list_primitives
from warpsample.texture.shading import compute_corner_normals

_LEAST = 1e-3  # least sine of the angle between a normal and a usable tangent


@dataclass(frozen=True, eq=False)
class Frames:
    """Tangent frames at face corners: the axes that normal maps refer to.

    Attributes:
        normals: (F, 3, 3) float64, unit normals.
        tangents: (F, 3, 4) float64, tangents as in glTF: a unit vector and the sign of the bitangent.
    """

    normals: np.ndarray
    tangents: np.ndarray

    @classmethod
    def of(cls, path: Path, mesh: Mesh, uv: np.ndarray, group: Sequence[Primitive] = ()) -> "Frames":
        """Read the tangent frames at the corners of a mesh file's faces: tangents of the file, else computed by MikkTSpace.

        As in viewers, MikkTSpace computes tangents in the space of a glTF mesh, before its node or its joints place it.

        Args:
            path: path of the file, with the normals that `read_normals` reads. Only .glb and .gltf files have tangents.
            mesh: mesh as `load_mesh` reads it.
            uv: (F, 3, 2) texture coordinates of the picture in any scale, v downward; NaN for faces outside the picture.
            group: glTF primitives that show the picture, treated separately by MikkTSpace. Empty for all faces of the file.
        """
        is_scene = path.suffix.lower() in (".glb", ".gltf")
        with naming_file("mesh", path, "a mesh with normals"):
            normals = compute_corner_normals(mesh, read_normals(path))
        tangents = np.full((len(uv), 3, 4), np.nan)
        places = group or (_list_places(path) if is_scene else ())
        distorted = dict.fromkeys(one for one in places if one.is_distorted)  # other tangents are equal in the scene
        for some in [one.faces for one in group if one not in distorted] if group else [slice(0, len(uv))]:
            face = _find_faces_with_uv(uv, some)
            tangents[face] = compute_tangents(mesh.vertices[mesh.faces[face]], normals[face], uv[face])
        for one in distorted:
            face = _find_faces_with_uv(uv, one.faces)
            tangents[face] = _compute_mesh_tangents(one, face, normals[face], uv[face])
        if is_scene:
            given = read_corners(path, "TANGENT")
            usable = np.isfinite(given).all(axis=2, keepdims=True)
            if usable.any():  # viewers ignore tangents without normals (glTF 2.0, 3.7.2.1)
                usable &= find_faces_with(path, "NORMAL")[:, None, None]
            tangents = np.where(usable, given, tangents)
        return cls(normals, tangents)

    def to_components(self, vectors: np.ndarray, face: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """Return the components of vectors along tangent, bitangent and normal, (P, 3), at points on faces.

        The three axes are interpolated between the corners and normalized, as in viewers. Where there is no tangent, an
        arbitrary direction perpendicular to the normal is used.

        Args:
            vectors: (P, 3) vectors in world coordinates.
            face: (P,) face of each point.
            weights: (P, 3) barycentric weights of each point.
        """
        normal = unit_or_zero(np.einsum("pk,pkc->pc", weights, self.normals[face])).astype(np.float64)
        turned = np.nan_to_num(self.tangents[face])
        tangent = unit_or_zero(np.einsum("pk,pkc->pc", weights, turned[..., :3])).astype(np.float64)
        lost = np.linalg.norm(np.cross(normal, tangent), axis=1) < _LEAST
        tangent[lost] = unit_or_zero(np.cross(np.eye(3)[np.abs(normal[lost]).argmin(axis=1)], normal[lost]))
        sign = np.where(turned[:, 0, 3] < 0.0, -1.0, 1.0)[:, None]
        frame = np.stack([tangent, sign * unit_or_zero(np.cross(normal, tangent)), normal], axis=2)
        frame[~normal.any(axis=1)] = np.eye(3)
        return np.linalg.solve(frame, vectors[..., None].astype(np.float64))[..., 0]


def _list_places(path: Path) -> list[Primitive]:
    """Return the triangle primitives of a glTF file, once for each place."""
    with opened(path) as (tree, data):
        return [place for one in list_primitives(tree, data) for place in (one, *one.others)]


def _find_faces_with_uv(uv: np.ndarray, rows: slice) -> np.ndarray:
    """Return the numbers of the faces in a range that have finite texture coordinates."""
    return rows.start + np.flatnonzero(np.isfinite(uv[rows]).all(axis=(1, 2)))


def _compute_mesh_tangents(one: Primitive, face: np.ndarray, normals: np.ndarray, uv: np.ndarray) -> np.ndarray:
    """Return tangents (n, 3, 4) in the scene, computed by MikkTSpace in the space of the primitive's mesh.

    Args:
        one: Primitive at one place, which distorts it.
        face: (n,) numbers of faces of the primitive.
        normals: (n, 3, 3) unit normals of their corners in the scene.
        uv: (n, 3, 2) texture coordinates of their corners.
    """
    corners = one.triangles[face - one.faces.start]
    matrix = one.matrix if one.matrix.ndim == 2 else one.matrix[corners]
    own = unit_or_zero((matrix @ normals[..., None]).reshape(-1, 3)).reshape(normals.shape)  # float32: equal stay equal
    found = compute_tangents(one.points[corners].astype(np.float64), own.astype(np.float64), uv)
    turned = (found[..., None, :3] @ matrix).reshape(-1, 3)
    found[..., :3] = unit_or_zero(turned).reshape(normals.shape)
    return found
