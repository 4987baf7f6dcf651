"""Meshes of a scene, each where the scene places it, as one."""

from collections.abc import Iterable

import numpy as np


def joined(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of all parts; what a matrix mirrors is wound the other way, so that its outside stays outside.

    Args:
        parts: (V, 3) points, (F, 3) triangles of theirs and a matrix (4, 4) from the right, as in (x, y, z, 1) @ matrix.

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
