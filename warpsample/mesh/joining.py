"""Joins the meshes of a scene, each placed by its matrix, into one."""

from collections.abc import Iterable, Iterator

import numpy as np

from warpsample.host.engine import check_memory
from warpsample.mesh.parts import Named, named_parts

_MOST = 2**31 - 1  # vertices: faces are int32


def joined(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray | None]]) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of all parts; the winding of mirrored parts is reversed, so that their outside stays outside.

    A part is points (V, 3), triangles (F, 3) and a matrix (4, 4) that multiplies from the right, (x, y, z, 1) @ matrix, or
    None for points that stay where they are. No parts, or more vertices than int32 counts, are a ValueError; a few bytes
    that place a mesh so often that the free memory does not hold it a MemoryError.
    """
    vertices, faces, offset, size, known = [], [], 0, 0, 0
    for part in parts:
        points, triangles = _placed(*part)
        vertices.append(points)
        triangles = triangles.astype(np.int32, copy=False)
        faces.append(triangles + np.int32(offset) if offset else triangles)
        offset += len(points)
        size += points.nbytes + faces[-1].nbytes
        if offset > _MOST:
            raise ValueError(f"its scene has more than {_MOST:,} vertices")
        if size > known:  # and again before it doubles; what is joined is a copy
            known = 2 * size
            check_memory(size, f"a scene of {offset:,} vertices and more", "leave out some of it")
    if not faces:
        raise ValueError("it has no faces")
    return (vertices[0], faces[0]) if len(faces) == 1 else (np.concatenate(vertices), np.concatenate(faces))


def joined_parts(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray | None, str]]) -> Named:
    """Vertices and faces of all parts as by `joined`, and the parts, by the name that each has as its last item."""
    names: list[str] = []
    counts: list[int] = []

    def noted() -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray | None]]:
        for *placed, name in parts:
            names.append(name)
            counts.append(len(placed[1]))
            yield tuple(placed)

    vertices, faces = joined(noted())
    return vertices, faces, *named_parts(counts, names)


def joined_corners(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray | None]]) -> np.ndarray:
    """(F, 3, k) float64: what the corners of the faces have, in the order in which `joined` has these.

    A part is values (V, k), triangles (F, 3), indices of them, and the matrix that places it, or None.
    """
    found, size = [np.empty((0, 3, 2))], 0
    for values, triangles, matrix in parts:
        size += 24 * triangles.size
        check_memory(size, "what the corners of a scene have", "leave out some of it")
        found.append(values[outward(triangles, matrix)].astype(np.float64))
    return np.concatenate(found[1:] or found)


def _placed(points: np.ndarray, triangles: np.ndarray, matrix: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    if matrix is None:
        return points, triangles
    with np.errstate(all="ignore"):  # what is not finite is refused by the mesh
        placed = points @ matrix[:3, :3]
        placed += matrix[3, :3]
    return placed, outward(triangles, matrix)


def outward(triangles: np.ndarray, matrix: np.ndarray | None) -> np.ndarray:
    """Triangles whose outside stays outside: their winding is reversed where the matrix mirrors them."""
    is_mirrored = matrix is not None and np.linalg.det(matrix[:3, :3]) < 0.0
    return triangles[:, ::-1] if is_mirrored else triangles
