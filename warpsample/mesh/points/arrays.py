"""Arrays for distribution parameters: read from files by name, and interpolated from vertices or faces to points."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from warpsample.host.arguments import check_file, naming_file, quote
from warpsample.mesh.files.ply import read_elements
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.polydata import pyvista
from warpsample.mesh.surface import SurfacePoints

SUFFIXES = (".ply", ".vtp", ".npz")


class Rows(NamedTuple):
    """Array with a row for each vertex, face or point, and the place of the rows: None if the file does not state it."""

    array: np.ndarray
    at: Literal["vertices", "faces"] | None = None


def read_array(path: Any, name: str, argument: str) -> Rows:
    """Read the array with a given name from a .ply, .vtp or .npz file.

    In a .ply, the array is a property of the vertices, or else of the faces. A vector has three properties, such as view_x,
    view_y and view_z.

    Args:
        path: path of the file.
        name: name of the array.
        argument: name of the path's argument, for error messages.

    Raises:
        TypeError, FileNotFoundError: the path is no path of a file.
        ValueError: the file cannot be read, or has no array of the name; the message lists the names.
        ModuleNotFoundError: a .vtp file without PyVista.
    """
    path = check_file(path, argument, f"a file that ends in one of {' '.join(SUFFIXES)}")
    if path.suffix.lower() not in SUFFIXES:
        raise ValueError(
            f"{argument}: got {path.name!r}, want a file with arrays, which ends in one of {' '.join(SUFFIXES)}"
        )
    with naming_file(argument, path, "arrays"):
        names, found = {".ply": _ply, ".vtp": _vtp, ".npz": _npz}[path.suffix.lower()](path, name)
    if found is None:
        raise ValueError(
            f"distribution: got the array name @{name}, want an array of {path.name}: {quote(', '.join(sorted(names)))}"
        )
    return found


def _ply(path: Path, name: str) -> tuple[Iterable[str], Rows | None]:
    """Read a .ply file: return the names of its vertex and face properties, and the property `name`, or None."""
    found = read_elements(path)
    arrays = _columns(found.get("face", {}), "faces") | _columns(found.get("vertex", {}), "vertices")
    return arrays, arrays.get(name)


def _columns(element: dict[str, Any], at: Literal["vertices", "faces"]) -> dict[str, Rows]:
    """Return the numeric properties of a .ply element by name; three properties _x, _y and _z also make a vector."""
    columns = {name: np.asarray(column) for name, column in element.items() if not isinstance(column, tuple)}
    for name in [name.removesuffix("_x") for name in columns if name.endswith("_x")]:
        parts = [columns[f"{name}_{axis}"] for axis in "xyz" if f"{name}_{axis}" in columns]
        if len(parts) == 3:
            columns[name] = np.stack(parts, axis=1)
    return {name: Rows(column, at) for name, column in columns.items()}


def _vtp(path: Path, name: str) -> tuple[Iterable[str], Rows | None]:
    """Read a .vtp file: return the names of its point and cell arrays, and the array `name`, or None."""
    arrays = arrays_of(pyvista().read(path))
    return arrays, arrays.get(name)


def arrays_of(dataset: Any) -> dict[str, Rows]:
    """Return the point and cell arrays of a PolyData by name; a point array comes before a cell array of the same name."""
    cells = {name: Rows(np.asarray(dataset.cell_data[name]), "faces") for name in dataset.cell_data}
    return cells | {name: Rows(np.asarray(dataset.point_data[name]), "vertices") for name in dataset.point_data}


def _npz(path: Path, name: str) -> tuple[Iterable[str], Rows | None]:
    """Read an .npz file: return the names of its arrays, and the array `name`, or None; no other array is read."""
    with np.load(path, allow_pickle=False) as archive:
        return archive.files, Rows(archive[name]) if name in archive.files else None


def carry_to_points(
    array: np.ndarray, name: str, mesh: Mesh, points: SurfacePoints, at: Literal["vertices", "faces"] | None = None
) -> np.ndarray:
    """Convert an array with a row for each vertex, face or point to an array with a row for each point.

    The numbers of vertices are interpolated between the corners of a point's face. If `at` is None, an array that has as
    many rows as the mesh has vertices belongs to the vertices.

    Raises:
        ValueError: the array has another number of rows, or points without a face need one.
    """
    vertices, faces, on_faces = len(mesh.vertices), len(mesh.faces), bool((points.face >= 0).all())
    rows = len(array) if array.ndim else -1
    if rows == vertices and on_faces and at != "faces":
        return np.einsum("pk,pk...->p...", _corner_weights(mesh, points), array[mesh.faces[points.face]])
    if rows == faces and on_faces and at != "vertices":
        return array[points.face]
    if at == "faces":
        wants = "points inside faces" if rows == faces else f"{faces:,} rows, one for each triangle"
        raise ValueError(f"distribution: got @{name} with shape {array.shape} at faces, want {wants}")
    if rows != len(points):
        wants = f"{vertices:,} (vertices), {faces:,} (faces) or {len(points):,} (points)"
        raise ValueError(f"distribution: got @{name} with shape {array.shape}, want rows for {wants}")
    return array


def _corner_weights(mesh: Mesh, points: SurfacePoints) -> np.ndarray:
    """Return barycentric coordinates of points, (P, 3), at least 0; computed from positions for points without them."""
    if points.barycentric is not None:
        return points.barycentric
    a, b, c = (mesh.vertices[mesh.faces[points.face, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    square = np.maximum(np.square(normal).sum(axis=1), np.finfo(np.float64).tiny)
    second = (np.cross(points.position - a, c - a) * normal).sum(axis=1) / square
    third = (np.cross(b - a, points.position - a) * normal).sum(axis=1) / square
    weights = np.clip(np.stack([1.0 - second - third, second, third], axis=1), 0.0, None)
    return weights / weights.sum(axis=1, keepdims=True)
