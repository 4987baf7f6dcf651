"""Joins the meshes of a scene, each placed by its matrix, into one."""

from collections.abc import Iterable

import numpy as np


def joined(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of all parts; the winding of mirrored parts is reversed, so that their outside stays outside.

    Args:
        parts: points (V, 3), triangles (F, 3) and a matrix (4, 4) that multiplies from the right: (x, y, z, 1) @ matrix.

    Raises:
        ValueError: no parts.
    """
    vertices, faces, offset = [], [], 0
    for points, triangles, matrix in parts:
        placed = points @ matrix[:3, :3]
        placed += matrix[3, :3]
        is_mirrored = np.linalg.det(matrix[:3, :3]) < 0.0
        vertices.append(placed)
        faces.append((triangles[:, ::-1] if is_mirrored else triangles).astype(np.int32))
        faces[-1] += offset
        offset += len(points)
    if not faces:
        raise ValueError("it has no faces")
    return (vertices[0], faces[0]) if len(faces) == 1 else (np.concatenate(vertices), np.concatenate(faces))
