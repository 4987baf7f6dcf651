"""Tangent frames of viewers, by MikkTSpace, and components of vectors in the frames."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.host.arguments import naming_file
from warpsample.host.locks import once_property
from warpsample.mesh.files.gltf import find_faces_with, opened, read_corners
from warpsample.mesh.files.normals import read_normals
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.tangents import compute_tangents
from warpsample.texture.primitives import Primitive, list_primitives
from warpsample.texture.shading import compute_corner_normals

_LEAST = 1e-3  # least sine of the angle between a normal and a usable tangent


class FrameReader:
    """Reader of the tangent frames at the corners of a mesh file's faces: tangents of the file, else by MikkTSpace."""

    def __init__(self, path: Path, mesh: Mesh) -> None:
        """Store the path of the file, and its mesh as `load_mesh` reads it; normals and tangents are read at first use."""
        self._path, self._mesh = path, mesh
        self._is_scene = path.suffix.lower() in (".glb", ".gltf")

    def frames(self, uv: np.ndarray, faces: np.ndarray | None = None, group: Sequence[Primitive] = ()) -> "Frames":
        """Return the tangent frames of some faces.

        As in viewers, MikkTSpace computes tangents in the space of a glTF mesh, before its node or its joints place it.

        Args:
            uv: (R, 3, 2) texture coordinates of the picture in any scale, v downward; NaN for faces outside the picture.
            faces: (R,) ascending numbers of the faces. Default: None, all.
            group: glTF primitives that show the picture, treated separately by MikkTSpace. Empty for all faces of the file.
        """
        faces, mesh = np.arange(len(uv)) if faces is None else faces, self._mesh
        normals, tangents = self._normals[faces], np.full((len(uv), 3, 4), np.nan)
        places = group or self._places
        distorted = dict.fromkeys(one for one in places if one.is_distorted)  # other tangents are equal in the scene
        for some in [one.faces for one in group if one not in distorted] if group else [slice(0, len(mesh.faces))]:
            row = _find_rows_with_uv(faces, uv, some)
            tangents[row] = compute_tangents(mesh.vertices[mesh.faces[faces[row]]], normals[row], uv[row])
        for one in distorted:
            row = _find_rows_with_uv(faces, uv, one.faces)
            tangents[row] = _compute_mesh_tangents(one, faces[row], normals[row], uv[row])
        if self._tangents is not None:
            given = self._tangents[faces]
            tangents = np.where(np.isfinite(given).all(axis=2, keepdims=True), given, tangents)
        return Frames(normals, tangents)

    @once_property
    def _normals(self) -> np.ndarray:
        """Read the unit normals at face corners, (F, 3, 3) float64."""
        with naming_file("mesh", self._path, "a mesh with normals"):
            return compute_corner_normals(self._mesh, read_normals(self._path))

    @once_property
    def _tangents(self) -> np.ndarray | None:
        """Read the file's tangents at face corners, (F, 3, 4), NaN for faces without; None if no face has a tangent."""
        if not self._is_scene:
            return None
        given = read_corners(self._path, "TANGENT")
        if not np.isfinite(given).all(axis=2).any():
            return None
        given[~find_faces_with(self._path, "NORMAL")] = np.nan  # viewers ignore tangents without normals (glTF, 3.7.2.1)
        return given

    @once_property
    def _places(self) -> list[Primitive]:
        """List the triangle primitives of a glTF file, once for each place."""
        if not self._is_scene:
            return []
        with opened(self._path) as (tree, data):
            return [place for one in list_primitives(tree, data) for place in (one, *one.others)]


@dataclass(frozen=True, eq=False)
class Frames:
    """Tangent frames at face corners: the axes that normal maps refer to.

    Attributes:
        normals: (R, 3, 3) float64, unit normals.
        tangents: (R, 3, 4) float64, tangents as in glTF: a unit vector and the sign of the bitangent.
    """

    normals: np.ndarray
    tangents: np.ndarray

    def to_components(self, vectors: np.ndarray, row: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """Return the components of vectors along tangent, bitangent and normal, (P, 3), at points on faces.

        The three axes are interpolated between the corners and normalized, as in viewers. Where there is no tangent, an
        arbitrary direction perpendicular to the normal is used.

        Args:
            vectors: (P, 3) vectors in world coordinates.
            row: (P,) row of each point's face.
            weights: (P, 3) barycentric weights of each point.
        """
        normal = unit_or_zero(np.einsum("pk,pkc->pc", weights, self.normals[row])).astype(np.float64)
        turned = np.nan_to_num(self.tangents[row])
        tangent = unit_or_zero(np.einsum("pk,pkc->pc", weights, turned[..., :3])).astype(np.float64)
        lost = np.linalg.norm(np.cross(normal, tangent), axis=1) < _LEAST
        tangent[lost] = unit_or_zero(np.cross(np.eye(3)[np.abs(normal[lost]).argmin(axis=1)], normal[lost]))
        sign = np.where(turned[:, 0, 3] < 0.0, -1.0, 1.0)[:, None]
        frame = np.stack([tangent, sign * unit_or_zero(np.cross(normal, tangent)), normal], axis=2)
        frame[~normal.any(axis=1)] = np.eye(3)
        return np.linalg.solve(frame, vectors[..., None].astype(np.float64))[..., 0]


def _find_rows_with_uv(faces: np.ndarray, uv: np.ndarray, some: slice) -> np.ndarray:
    """Return the rows of `faces`, ascending numbers, that are in a range and have finite texture coordinates."""
    first, last = np.searchsorted(faces, [some.start, some.stop])
    return first + np.flatnonzero(np.isfinite(uv[first:last]).all(axis=(1, 2)))


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
