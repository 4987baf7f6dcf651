"""Checks of the two arrays of a mesh: vertices, and faces as indices of vertices."""

import numpy as np

from warpsample.host.locks import read_only

LARGEST = 1e36
"""Largest absolute coordinate of a vertex, so that distances in float32 stay finite."""


def check_vertices(vertices: np.ndarray) -> np.ndarray:
    """Check the vertices of a mesh, (V, 3), and return a read-only float64 copy.

    Raises:
        ValueError: A wrong shape, or coordinates that are not finite or exceed `LARGEST` in absolute value.
    """
    if vertices.ndim != 2 or vertices.shape[1] != 3 or len(vertices) == 0:
        raise ValueError(f"vertices: got shape {vertices.shape}, want (V, 3) with V of at least 3")
    vertices = read_only(vertices.astype(np.float64, copy=False))  # copied first: the checked values are kept
    if not (vertices.min() >= -LARGEST and vertices.max() <= LARGEST):
        broken = ~(np.abs(vertices) <= LARGEST).all(axis=1)
        first = int(np.argmax(broken))
        flaw = "not finite" if not np.isfinite(vertices[broken]).all() else f"beyond {LARGEST:g}"
        raise ValueError(
            f"vertices: got coordinates that are {flaw}, the first in row {first}, {vertices[first]}, "
            f"want coordinates from {-LARGEST:g} to {LARGEST:g}"
        )
    return vertices


def check_faces(faces: np.ndarray, vertices: int) -> np.ndarray:
    """Check the faces of a mesh, (F, 3) indices of vertices, and return a read-only int32 copy.

    Raises:
        TypeError: Faces that are not integers.
        ValueError: A wrong shape, or an index outside 0 to `vertices` - 1.
    """
    if faces.ndim != 2 or faces.shape[1] != 3 or len(faces) == 0:
        raise ValueError(f"faces: got shape {faces.shape}, want (F, 3) with F of at least 1")
    if faces.dtype.kind not in "iu":
        raise TypeError(f"faces: got dtype {faces.dtype}, want whole numbers")
    faces = read_only(faces)
    outside = (faces < 0) | (faces >= vertices)
    if outside.any():
        first = int(np.argmax(outside.any(axis=1)))
        raise ValueError(
            f"faces: got indices from {faces.min()} to {faces.max()}, the first wrong one in face {first}, {faces[first]}, "
            f"want 0 to {vertices - 1}"
        )
    return faces if faces.dtype == np.int32 else read_only(faces.astype(np.int32))
