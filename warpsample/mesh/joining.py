"""Joining of the meshes of a scene into one mesh, each transformed by its matrix."""

from collections.abc import Iterable, Iterator

import numpy as np

from warpsample.host.engine import check_memory
from warpsample.host.locks import multiply
from warpsample.mesh.parts import Named, named_parts

_MOST = 2**31 - 1  # vertices, because faces are int32


def joined(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray | None]]) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices and faces of all parts as one mesh.

    The winding of mirrored parts is reversed, so that their outside stays outside.

    Args:
        parts: Points (V, 3), triangles (F, 3) and a matrix (4, 4) of each part. The matrix applies to row vectors,
            (x, y, z, 1) @ matrix; None leaves the points unchanged.

    Raises:
        ValueError: No parts, or more vertices than int32 can count.
        MemoryError: A scene that does not fit into the free memory; a small file can place a mesh very often.
    """
    vertices, faces, offset, size, known = [], [], 0, 0, 0
    for part in parts:
        points, triangles = _transform_part(*part)
        vertices.append(points)
        triangles = triangles.astype(np.int32, copy=False)
        faces.append(triangles + np.int32(offset) if offset else triangles)
        offset += len(points)
        size += points.nbytes + faces[-1].nbytes
        if offset > _MOST:
            raise ValueError(f"the scene has more than {_MOST:,} vertices")
        if size > known:  # checked again when the size doubles, because joining makes a copy
            known = 2 * size
            check_memory(size, f"scenes of {offset:,} vertices and more", "leave out some of it")
    if not faces:
        raise ValueError("the file has no visible faces")
    return (vertices[0], faces[0]) if len(faces) == 1 else (np.concatenate(vertices), np.concatenate(faces))


def joined_parts(parts: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray | None, str]]) -> Named:
    """Join named parts like `joined`, and return the part of each face and the parts' names, too.

    The last item of each part is its name.
    """
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
    """Return the (F, 3, k) float64 values at the corners of all faces, in the face order of `joined`.

    Args:
        parts: Values (V, k), triangles (F, 3) of indices of values, and the part's matrix or None; the matrix determines
            only the winding.
    """
    found, size = [np.empty((0, 3, 2))], 0
    for values, triangles, matrix in parts:
        size += 24 * triangles.size
        check_memory(size, "what the corners of a scene have", "leave out some of it")
        found.append(values[outward(triangles, matrix)].astype(np.float64))
    return np.concatenate(found[1:] or found)


def _transform_part(points: np.ndarray, triangles: np.ndarray, matrix: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """Transform one part by its matrix; return points, and triangles whose outside stays outside if the matrix mirrors."""
    if matrix is None:
        return points, triangles
    with np.errstate(all="ignore"):  # `Mesh` refuses coordinates that are not finite
        placed = multiply(points, matrix[:3, :3])
        placed += matrix[3, :3]
    return placed, outward(triangles, matrix)


def outward(triangles: np.ndarray, matrix: np.ndarray | None) -> np.ndarray:
    """Reverse the winding of triangles if a matrix mirrors, so that the outside stays outside."""
    is_mirrored = matrix is not None and np.linalg.det(matrix[:3, :3]) < 0.0
    return triangles[:, ::-1] if is_mirrored else triangles
