"""Conversion of meshes of other libraries to arrays; types are recognized by their attributes, so no library is imported."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.neighbours import describe_type
from warpsample.mesh.joining import joined_parts
from warpsample.mesh.parts import Named
from warpsample.mesh.polygons import faces_of_cells

Placed = tuple[np.ndarray, np.ndarray, np.ndarray | None, str]
"""Vertices, faces, (4, 4) matrix for row vectors (vector @ matrix) or None, and the part's name."""

KINDS = (
    "a tuple (vertices, faces), a pyvista.PolyData or MultiBlock, a trimesh.Trimesh or Scene, a meshio.Mesh, or a "
    "TriangleMesh of Open3D"
)
"""Supported types, for error messages."""


def arrays_of(value: Any, argument: str) -> Named | None:
    """Return (vertices, faces, parts, part names) of a mesh of another library, or None for an unknown type.

    Raises:
        ValueError: A scene without faces.
    """
    if hasattr(value, "geometry") and hasattr(value, "graph"):
        return _scene(_nodes(value), value, argument)
    if hasattr(value, "keys") and hasattr(value, "n_blocks"):
        return _scene(_blocks(value), value, argument)
    found = _surface(value, argument)
    return found and (*found, None, ())


def _surface(value: Any, argument: str) -> tuple[Any, Any] | None:
    """Return the vertices and faces of a single surface, or None for an unknown type."""
    if hasattr(value, "vertices") and hasattr(value, "faces"):
        return value.vertices, value.faces
    if hasattr(value, "is_all_triangles") and hasattr(value, "triangulate"):
        made = value if value.is_all_triangles and not value.n_strips else value.triangulate()
        return made.points, made.regular_faces
    if hasattr(value, "vertices") and hasattr(value, "triangles"):  # legacy Open3D mesh
        return np.asarray(value.vertices), np.asarray(value.triangles)
    if hasattr(value, "vertex") and hasattr(value, "triangle"):  # Open3D tensor mesh, possibly on a GPU
        return value.vertex.positions.cpu().numpy(), value.triangle.indices.cpu().numpy()
    if hasattr(value, "points") and isinstance(getattr(value, "cells", None), list):
        return value.points, faces_of_cells(value, argument)
    return None


def _scene(parts: Iterator[Placed], value: Any, argument: str) -> Named:
    """Join all parts of a scene into one mesh; raise a ValueError if no part has a face."""
    held = [part for part in parts if len(part[1])]
    if not held:
        raise ValueError(f"{argument}: got {describe_type(value)} without a face: {quote(value)}, want a mesh with faces")
    return joined_parts(held)


def _nodes(scene: Any) -> Iterator[Placed]:
    """Yield the placed meshes of a trimesh.Scene; point clouds and paths are left out."""
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        mesh = scene.geometry[name]
        if hasattr(mesh, "faces"):
            yield np.asarray(mesh.vertices, np.float64), np.asarray(mesh.faces), np.asarray(matrix).T, str(node)


def _blocks(blocks: Any, path: str = "") -> Iterator[Placed]:
    """Yield the surfaces of all blocks of a pyvista.MultiBlock, nested blocks and the surfaces of volumes included."""
    for place in range(blocks.n_blocks):  # by number, as names can be missing or the same
        block, name = blocks[place], f"{path}{blocks.get_block_name(place) or place}"
        if block is None or not (hasattr(block, "n_blocks") or block.n_cells):
            continue
        if hasattr(block, "n_blocks"):
            yield from _blocks(block, f"{name}/")
            continue
        surface = block if hasattr(block, "is_all_triangles") else block.extract_surface(algorithm="dataset_surface")
        points, faces = _surface(surface, name) or (np.empty((0, 3)), np.empty((0, 3), int))
        yield np.asarray(points, np.float64), np.asarray(faces), None, name
