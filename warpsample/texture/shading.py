"""Shading normals at texels, and positions on the smooth surface that the normals suggest."""

import numpy as np

from warpsample.host.arrays import as_real
from warpsample.mesh.mesh import Mesh, unit_or_zero

NORMALS = ("face", "smooth", "lifted")
"""Normals of the face, interpolated corner normals, or interpolated normals at points lifted to the smooth surface."""

_LIFTED = 1e-9  # of the distance to the corners: shorter lifts are rounding errors


def compute_corner_normals(mesh: Mesh, given: object, faces: np.ndarray | None = None) -> np.ndarray:
    """Return the (R, 3, 3) float64 unit normals of the corners of some faces.

    Args:
        mesh: a mesh with F faces.
        given: (R, 3, 3) normals of any length; None for the mesh's vertex normals. Where a normal is 0 or not finite, the
            normal of the face is used.
        faces: (R,) numbers of the faces. Default: None, all.

    Raises:
        TypeError, ValueError: `given` is no array of R x 3 x 3 real numbers.
    """
    corners, flat_normals = (rows if faces is None else rows[faces] for rows in (mesh.faces, mesh.face_normals))
    if given is None:
        normals = mesh.vertex_normals[corners].astype(np.float64)
    else:
        wants = f"({len(corners)}, 3, 3) real numbers, a normal for each corner of a face"
        normals = as_real(given, "corner_normals", wants)
        if normals.shape != (len(corners), 3, 3):
            raise ValueError(f"corner_normals: got shape {normals.shape}, want {wants}")
    flat = normals.reshape(-1, 3)
    flat = unit_or_zero(np.where(np.isfinite(flat).all(axis=1, keepdims=True), flat, 0.0).astype(np.float64))
    none = ~flat.any(axis=1)
    flat[none] = np.repeat(flat_normals, 3, axis=0)[none]
    return flat.reshape(-1, 3, 3).astype(np.float64)


def shade_points(
    mesh: Mesh, turned: np.ndarray | None, face: np.ndarray, weights: np.ndarray, normals: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return positions (P, 3) float64, normals (P, 3) float32 and faces (P,) of points with given corner weights.

    With "lifted", points are moved onto the tangent planes of the corners, averaged with the same weights (Hanika2021). A
    moved point has the face -1.

    Args:
        mesh: mesh of the points.
        turned: (P, 3, 3) unit normals at the corners of each point's face; None for normals of faces.
        face: (P,) faces of the points.
        weights: (P, 3) weights of the corners.
        normals: normals of the points, one of NORMALS.
    """
    corners = [mesh.vertices.take(mesh.faces[face, k], axis=0) for k in range(3)]  # faster than indices in brackets
    position = corners[0] + weights[:, 1:2] * (corners[1] - corners[0]) + weights[:, 2:] * (corners[2] - corners[0])
    if turned is None:
        return position, mesh.face_normals.take(face, axis=0), face
    normal = unit_or_zero(sum(weights[:, k : k + 1] * turned[:, k] for k in range(3)))
    none = ~normal.any(axis=1)
    normal[none] = mesh.face_normals[face[none]]
    if normals == "lifted":
        below = [np.minimum(((position - corners[k]) * turned[:, k]).sum(axis=1, keepdims=True), 0.0) for k in range(3)]
        lift = -sum(weights[:, k : k + 1] * below[k] * turned[:, k] for k in range(3))
        reach = np.max([np.abs(position - corner).max(axis=1) for corner in corners], axis=0)
        rounding = 4.0 * np.spacing(np.abs(position).max(axis=1))
        moved = np.abs(lift).max(axis=1) > np.maximum(_LIFTED * reach, rounding)
        position = np.where(moved[:, None], position + lift, position)
        face = np.where(moved, -1, face).astype(np.int32)
    return position, normal, face
