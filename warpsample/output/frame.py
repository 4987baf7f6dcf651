"""Any result as a table, with what is known of its points: `to_frame`."""

from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from warpsample.host.arguments import check_first_point, told
from warpsample.host.neighbours import as_ndarray, kind_told
from warpsample.host.tables import frame_of
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints


def to_frame(found: Any, points: SurfacePoints, mesh: Any = None, *, first_point: int = 0) -> Any:
    """A result as a table with a row for each point: where it is, what it is on, and its numbers.

    Args:
        found: what a call over points gave: an Estimate, Irradiation, SkyMatrix, Hits, ...
        points: P of them, that it is of.
        mesh: what they are on, for the parts and the areas of their faces.
        first_point: the global id of row 0, as the call had it, where the points have no ids of their own.

    Returns:
        a pandas.DataFrame, or a dictionary of arrays where pandas is not installed. Its columns are id; with a mesh part, if
        it has named ones ("" where a point is on none), and area, of the point's face in square units, NaN without one;
        face, x, y, z, normal_x, normal_y, normal_z; and the result's arrays of one or more numbers for each point by their
        names, several as value_0, value_1 and so on. Arrays with more axes are left out.

    Raises:
        TypeError: no result, or no points.
        ValueError: a result of another number of points, faces that the mesh has not, an id of more than 64 bits.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> points = ws.face_centers(mesh)
        >>> table = ws.to_frame(ws.sky_view_factor(mesh, points, 64), points, mesh)
        >>> print(list(table)[:5], table["area"].sum().round())
        ['id', 'area', 'face', 'x', 'y'] 9360.0
    """
    if not isinstance(points, SurfacePoints):
        raise TypeError(f"points: got {kind_told(points)}, want SurfacePoints")
    if not is_dataclass(found) or isinstance(found, type):
        raise TypeError(f"found: got {told(found)}, want the result of a call over points")
    first = check_first_point(first_point, len(points), points.id)
    columns = {"id": np.uint64(first) + np.arange(len(points), dtype=np.uint64) if points.id is None else points.id}
    columns |= {} if mesh is None else _of_faces(points.face, as_mesh(mesh))
    columns["face"] = points.face
    for name, rows in (("", points.position), ("normal_", points.normal)):
        columns |= {f"{name}{axis}": rows[:, k] for k, axis in enumerate("xyz")}
    return frame_of(columns | _numbers(found, len(points)))


def _of_faces(face: np.ndarray | None, mesh: Mesh) -> dict[str, np.ndarray]:
    """The parts and areas of the faces of points."""
    assert face is not None
    if face.size and face.max() >= len(mesh.faces):
        raise ValueError(f"points: got the face {face.max()}, want faces of the mesh, which has {len(mesh.faces):,}")
    area = np.append(mesh.face_areas, np.nan)[face]  # the last is for -1
    if mesh.part is None:
        return {"area": area}
    names = np.array([*mesh.parts, ""], object)
    return {"part": names[np.append(mesh.part, -1)[face]], "area": area}


def _numbers(found: Any, count: int) -> dict[str, np.ndarray]:
    """The columns of a result: those of its arrays that have a row for each point."""
    arrays = {item.name: getattr(found, item.name) for item in fields(found)}
    arrays = {name: as_ndarray(array, name) for name, array in arrays.items() if hasattr(array, "shape")}
    of_points = {name: array for name, array in arrays.items() if array.shape[:1] == (count,)}
    if not of_points:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"found: got arrays of shape {shapes or 'none'}, want a row for each of the {count} points")
    columns = {name: array for name, array in of_points.items() if array.ndim == 1}
    for name, array in of_points.items():
        if array.ndim == 2:
            columns |= {f"{name}_{k}": column for k, column in enumerate(array.T)}
    return columns
