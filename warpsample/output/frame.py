"""Conversion of results to tables: `to_frame`."""

from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from warpsample.host.arguments import check_first_point, quote
from warpsample.host.neighbours import as_ndarray, describe_type
from warpsample.host.tables import frame_of
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints


def to_frame(found: Any, points: SurfacePoints, mesh: Any = None, *, first_point: int = 0) -> Any:
    """Return a result as a table with a row for each point: position, normal, face, part and values.

    Args:
        found: result of a call over points: an Estimate, Irradiation, SkyMatrix, Hits, ...
        points: P points of the call.
        mesh: mesh of the points, for the parts and the areas of faces. Default: None, without these columns.
        first_point: global id of row 0 in the call; points with an `id` keep that. Default: 0.

    Returns:
        a pandas.DataFrame, or a dictionary of arrays if pandas is not installed. The columns are id; with a mesh also part,
        if the mesh has named parts ("" for a point on no part), and area, the area of the point's face in square units (NaN
        without a face); face, x, y, z, normal_x, normal_y, normal_z; and the arrays of the result by name. An array with
        several values per point becomes value_0, value_1 and so on. Arrays with more axes are left out.

    Raises:
        TypeError: `found` is no result, or `points` are no SurfacePoints.
        ValueError: the result has another number of points, a face is not in the mesh, or an id has more than 64 bits.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> points = ws.face_centers(mesh)
        >>> table = ws.to_frame(ws.sky_view_factor(mesh, points, 64), points, mesh)
        >>> print(list(table)[:5], table["area"].sum().round())
        ['id', 'area', 'face', 'x', 'y'] 9360.0
    """
    if not isinstance(points, SurfacePoints):
        raise TypeError(f"points: got {describe_type(points)}, want SurfacePoints")
    if not is_dataclass(found) or isinstance(found, type):
        raise TypeError(f"found: got {quote(found)}, want the result of a call at points, such as sky_view_factor")
    first = check_first_point(first_point, len(points), points.id)
    columns = {"id": np.uint64(first) + np.arange(len(points), dtype=np.uint64) if points.id is None else points.id}
    columns |= {} if mesh is None else _of_faces(points.face, as_mesh(mesh))
    columns["face"] = points.face
    for name, rows in (("", points.position), ("normal_", points.normal)):
        columns |= {f"{name}{axis}": rows[:, k] for k, axis in enumerate("xyz")}
    return frame_of(columns | _numbers(found, len(points)))


def _of_faces(face: np.ndarray | None, mesh: Mesh) -> dict[str, np.ndarray]:
    """Return two table columns: the name of the part, and the area, of the face that each point lies on."""
    assert face is not None
    if face.size and face.max() >= len(mesh.faces):
        raise ValueError(f"points: got the face {face.max()}, want faces of the mesh, which has {len(mesh.faces):,}")
    area = np.append(mesh.face_areas, np.nan)[face]  # the last is for -1
    if mesh.part is None:
        return {"area": area}
    names = np.array([*mesh.parts, ""], object)
    return {"part": names[np.append(mesh.part, -1)[face]], "area": area}


def _numbers(found: Any, count: int) -> dict[str, np.ndarray]:
    """Return the arrays of a result that have a row for each point, as table columns keyed by name."""
    arrays = {item.name: getattr(found, item.name) for item in fields(found)}
    arrays = {name: as_ndarray(array, name) for name, array in arrays.items() if hasattr(array, "shape")}
    of_points = {name: array for name, array in arrays.items() if array.shape[:1] == (count,)}
    if not of_points:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"found: got arrays of shape {shapes or 'none'}, want one row for each of the {count} points")
    columns = {name: array for name, array in of_points.items() if array.ndim == 1}
    for name, array in of_points.items():
        if array.ndim == 2:
            columns |= {f"{name}_{k}": column for k, column in enumerate(array.T)}
    return columns
