"""Points on the surface of a mesh."""

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.arrays import Array, as_real
from warpsample.host.neighbours import as_ndarray
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import as_mesh
from warpsample.mesh.polydata import cloud

if TYPE_CHECKING:
    from pyvista import PolyData


@dataclass(frozen=True, eq=False, repr=False)
class SurfacePoints(Summary):
    """Points with normals, one per row.

    Arrays of other libraries (Warp, PyTorch, JAX, CuPy) become NumPy's: without a copy where they are in the CPU's memory.
    So directions, hits and numbers of these points are NumPy's, too.

    Attributes:
        position: (P, 3) float64 or float32, in the user's coordinates; other real numbers become float64, here as below.
        normal: (P, 3) float32 or float64; need not be of unit length. A zero normal (degenerate face) is skipped and
            counted wherever directions are asked for.
        face: (P,) int32, the face a point lies on, -1 where it lies on none (the default).
        barycentric: (P, 3) float64 weights of the face's corners, or None.
        id: (P,) uint64, global ids, by which random numbers are drawn, so that points in another order, or some of them,
            have the same; or None: row i has the id first_point + i.
        raised: (P,) bool, whether the rays of a point start straight above it, or straight below it where its normal points
            down, along z, however steep the faces are that touch it. Only right at vertices of a mesh that has one height
            at each (x, y), as those of `rasters.surface` with model "tin". None: at no point.

    Raises:
        TypeError: not real numbers, faces or ids that are not whole ones, or `raised` that is not bool.
        ValueError: shapes that do not agree, faces below -1, or ids below 0.

    Example:
        >>> eyes = ws.SurfacePoints(position=[[36.0, 36.0, 1.7], [3.0, 3.0, 1.7]], normal=[[0, 0, 1], [0, 0, 1]])
        >>> sky = ws.sky_view_factor(ws.load_mesh("courtyard"), eyes, 256)  # in the yard, and outside
        >>> print(sky.value.round(1))
        [0.4 1. ]
    """

    position: Array
    normal: Array
    face: Array | None = None
    barycentric: Array | None = None
    id: Array | None = None
    raised: Array | None = None

    def __post_init__(self) -> None:
        """Checks types and shapes and fills in the faces."""
        position, normal = as_real(self.position, "position"), as_real(self.normal, "normal")
        if position.ndim != 2 or position.shape[1] != 3:
            raise ValueError(f"position: got shape {position.shape}, want (P, 3)")
        points = len(position)
        face = np.full(points, -1, np.int32) if self.face is None else _check_face(self.face)
        barycentric = None if self.barycentric is None else as_real(self.barycentric, "barycentric")
        id = None if self.id is None else _check_id(self.id)
        raised = None if self.raised is None else _check_raised(self.raised)
        arrays = {"position": position, "normal": normal, "face": face}
        arrays |= {"barycentric": barycentric, "id": id, "raised": raised}
        shapes = {"normal": (points, 3), "barycentric": (points, 3)} | dict.fromkeys(("face", "id", "raised"), (points,))
        for name, array in arrays.items():
            if array is not None and array.shape != shapes.get(name, array.shape):
                raise ValueError(f"{name}: got shape {array.shape}, want {shapes[name]}, a row for each position")
            object.__setattr__(self, name, array)

    def __len__(self) -> int:
        """How many points."""
        return len(self.position)

    def take(self, rows: Any) -> "SurfacePoints":
        """Some of the points, with what belongs to them; those that have no `id` are numbered anew.

        Args:
            rows: a slice, (N,) whole numbers from 0 to P - 1, or (P,) bool.

        Returns:
            a point for each of these rows.

        Raises:
            TypeError: neither whole numbers nor bool.
            ValueError: another shape, or a row that is not there.

        Example:
            >>> points = ws.face_centers(ws.load_mesh("courtyard"))
            >>> print(points.take(points.normal[:, 2] > 0.9).position.shape)
            (1152, 3)
        """
        rows = rows if isinstance(rows, slice) else _check_rows(rows, len(self))
        kept = {item.name: getattr(self, item.name) for item in fields(self)}
        return SurfacePoints(**{name: None if array is None else array[rows] for name, array in kept.items()})

    def to_polydata(self) -> "PolyData":
        """The points as PyVista's PolyData, row for row: "Normals", "face", and "barycentric" and "id" where kept.

        Returns:
            a point for each row, with these as arrays of point data.

        Raises:
            ModuleNotFoundError: PyVista is missing.

        Example:
            >>> made = ws.sample_surface(ws.load_mesh("courtyard"), 100).to_polydata()
            >>> print(made.n_points, sorted(made.point_data))
            100 ['Normals', 'face']
        """
        return cloud(self.position, self.normal, face=self.face, barycentric=self.barycentric, id=self.id)


def face_centers(mesh: Any) -> SurfacePoints:
    """The centroid of every face, row i for face i; degenerate faces keep their row, with a zero normal.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.

    Returns:
        position (F, 3) float64, normal (F, 3) float32 of unit length or zero, face, barycentric.

    Raises:
        TypeError, ValueError: not a triangle mesh; names it.

    Example:
        >>> points = ws.face_centers(ws.load_mesh("courtyard"))
        >>> print(points.position.shape, points.face[:3])
        (2080, 3) [0 1 2]
    """
    mesh = as_mesh(mesh)
    position = mesh.vertices[mesh.faces].mean(axis=1)
    thirds = np.full((len(position), 3), 1.0 / 3.0)
    return SurfacePoints(position, mesh.face_normals.copy(), np.arange(len(position), dtype=np.int32), thirds)


def vertex_points(mesh: Any) -> SurfacePoints:
    """Every vertex with its area-weighted unit normal, row i for vertex i; zero where no face gives one.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.

    Returns:
        position (V, 3) float64, normal (V, 3) float32 of unit length or zero; the face is -1.

    Raises:
        TypeError, ValueError: not a triangle mesh; names it.

    Example:
        >>> points = ws.vertex_points(ws.load_mesh("courtyard"))
        >>> print(points.position.shape, np.linalg.norm(points.normal, axis=1).round(3).min())
        (1089, 3) 1.0
    """
    mesh = as_mesh(mesh)
    return SurfacePoints(mesh.vertices.copy(), mesh.vertex_normals.copy())


def _check_face(value: Any) -> np.ndarray:
    face = as_ndarray(value, "face")
    if face.dtype.kind not in "iu" and face.size:
        raise TypeError(f"face: got {f'dtype {face.dtype}' if face.ndim else told(value)}, want whole numbers")
    if face.size and not (face.min() >= -1 and face.max() < 2**31):
        raise ValueError(f"face: got numbers from {face.min()} to {face.max()}, want -1 (none) or the number of a face")
    return face.astype(np.int32, copy=False)


def _check_rows(value: Any, points: int) -> np.ndarray:
    rows = as_ndarray(value, "rows")
    if rows.shape == (0,):
        return np.zeros(0, np.int64)  # an empty list is of float64 to NumPy
    if rows.dtype.kind not in "biu":
        raise TypeError(f"rows: got {f'dtype {rows.dtype}' if rows.ndim else told(value)}, want whole numbers or bool")
    if rows.ndim != 1 or (rows.dtype == bool and len(rows) != points):
        raise ValueError(f"rows: got shape {rows.shape}, want (N,) whole numbers, or ({points},) bool")
    if rows.dtype != bool and rows.size and not (rows.min() >= 0 and rows.max() < points):
        raise ValueError(f"rows: got numbers from {rows.min()} to {rows.max()}, want those of {points} points, from 0 on")
    return rows


def _check_id(value: Any) -> np.ndarray:
    id = as_ndarray(value, "id")
    if id.dtype.kind not in "iu" and id.size:
        raise TypeError(
            f"id: got {f'dtype {id.dtype}' if id.ndim else told(value)}, want whole numbers of 64 bits, as "
            "numpy.array(id, numpy.uint64) holds them"
        )
    if id.size and id.min() < 0:
        raise ValueError(f"id: got {id.min()}, want whole numbers from 0 on")
    return np.ascontiguousarray(id, np.uint64)


def _check_raised(value: Any) -> np.ndarray:
    raised = as_ndarray(value, "raised")
    if raised.dtype != bool:
        raise TypeError(f"raised: got {f'dtype {raised.dtype}' if raised.ndim else told(value)}, want bool")
    return np.ascontiguousarray(raised)
