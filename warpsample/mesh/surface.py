"""Points on the surface of a mesh."""

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.arrays import Array, as_real
from warpsample.host.neighbours import as_ndarray
from warpsample.host.summary import Summary
from warpsample.mesh.frames import as_tangents, turn_vectors
from warpsample.mesh.mesh import as_mesh
from warpsample.mesh.polydata import cloud
from warpsample.mesh.tangents import vertex_tangents

if TYPE_CHECKING:
    from pyvista import PolyData


@dataclass(frozen=True, eq=False, repr=False)
class SurfacePoints(Summary):
    """Points on a surface with normals, where directions are sampled and quantities are computed.

    Arrays of other libraries (Warp, PyTorch, JAX, CuPy) are converted to NumPy, without a copy if they are in the CPU's
    memory. Directions, hits and results at the points are NumPy arrays, too.

    Attributes:
        position: (P, 3) float64 or float32 coordinates in the user's system and unit. Other real numbers are converted to
            float64, here and in `normal`.
        normal: (P, 3) float32 or float64, of any length. Points with a zero normal (of a degenerate face) are skipped and
            counted by calls that sample directions.
        face: (P,) int32 index of the face that contains the point, -1 for no face. Default: -1 everywhere.
        barycentric: (P, 3) float64 barycentric coordinates in the face. Default: None.
        id: (P,) uint64 global ids that determine the random numbers of each point, so that reordered or selected points keep
            their random numbers. Default: None, row i has the id first_point + i.
        raised: (P,) bool mask of points whose rays start vertically above the point (below for a normal that points down),
            however steep the adjacent faces are. Valid only at vertices whose faces have one height at each (x, y), such as
            the centres of cells of `rasters.surface`. Default: None, no point.
        tangent: (P, 4) float32: vectors whose part along the surface is the x axis of the frame of each point, and 1, or -1
            for a left-handed frame (glTF's TANGENT). (P, 3) vectors get 1. Default: None, the frame depends on the normal
            alone. `with_tangents` sets it.

    Raises:
        TypeError: Arrays that are not real numbers, faces or ids that are not integers, or `raised` that is not bool.
        ValueError: Shapes that do not agree, faces below -1, or ids below 0.

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
    tangent: Array | None = None

    def __post_init__(self) -> None:
        """Check the types and shapes of the arrays, and set missing faces to -1."""
        position, normal = as_real(self.position, "position"), as_real(self.normal, "normal")
        if position.ndim != 2 or position.shape[1] != 3:
            raise ValueError(f"position: got shape {position.shape}, want (P, 3), one row for each of P points")
        points = len(position)
        face = np.full(points, -1, np.int32) if self.face is None else _check_face(self.face)
        barycentric = None if self.barycentric is None else as_real(self.barycentric, "barycentric")
        id = None if self.id is None else _check_id(self.id)
        raised = None if self.raised is None else _check_raised(self.raised)
        arrays = {"position": position, "normal": normal, "face": face}
        tangent = None if self.tangent is None else as_tangents(self.tangent, points)
        arrays |= {"barycentric": barycentric, "id": id, "raised": raised, "tangent": tangent}
        shapes = {"normal": (points, 3), "barycentric": (points, 3)} | dict.fromkeys(("face", "id", "raised"), (points,))
        for name, array in arrays.items():
            if array is not None and array.shape != shapes.get(name, array.shape):
                raise ValueError(f"{name}: got shape {array.shape}, want {shapes[name]}, one row for each position")
            object.__setattr__(self, name, array)

    def __len__(self) -> int:
        """Return the number of surface points."""
        return len(self.position)

    def take(self, rows: Any) -> "SurfacePoints":
        """Return the points of the given rows, with all their attributes; points without `id` get new row numbers as ids.

        Args:
            rows: A slice, (N,) integers from 0 to P - 1, or a (P,) bool mask.

        Returns:
            SurfacePoints with one point for each selected row.

        Raises:
            TypeError: Rows that are neither integers nor bool.
            ValueError: A wrong shape, or a row number outside 0 to P - 1.

        Example:
            >>> points = ws.face_centers(ws.load_mesh("courtyard"))
            >>> print(points.take(points.normal[:, 2] > 0.9).position.shape)
            (1152, 3)
        """
        rows = rows if isinstance(rows, slice) else _check_rows(rows, len(self))
        kept = {item.name: getattr(self, item.name) for item in fields(self)}
        return SurfacePoints(**{name: None if array is None else array[rows] for name, array in kept.items()})

    def with_tangents(self, tangent: Any) -> "SurfacePoints":
        """Return the points with tangents, which set the x axis of each point's frame.

        x is the part of the tangent perpendicular to the normal n. y is n cross x, times the sign of the fourth number, as
        in glTF. A tangent that is zero, NaN or parallel to the normal (a sine below 1e-3) gives the frame without tangents;
        `sample_directions` counts such points with the status INVALID_TANGENT.

        Args:
            tangent: (P, 3) or (P, 4) real numbers of any length above 0, with the sign of the bitangent last; or (3,) for
                all points.

        Returns:
            SurfacePoints with the same arrays and `tangent`.

        Raises:
            TypeError: The tangents are not real numbers.
            ValueError: The shape is another one.

        Example:
            >>> points = ws.face_centers(ws.load_mesh("courtyard")).with_tangents([1.0, 0.0, 0.0])
            >>> print(points.to_world([1.0, 0.0, 0.0])[:1])
            [[1. 0. 0.]]
        """
        kept = {item.name: getattr(self, item.name) for item in fields(self)}
        return SurfacePoints(**kept | {"tangent": as_tangents(tangent, len(self), "tangent", one_for_all=True)})

    def to_local(self, vectors: Any) -> np.ndarray:
        """Convert world vectors to the frames of the points, which `sample_directions` uses too; +z is the normal.

        Args:
            vectors: (3,), (P, 3) or (P, n, 3) real numbers, of any length. Differences of large coordinates keep their
                digits if they are computed in float64 before this call.

        Returns:
            (P, 3) or (P, n, 3) float32; zero vectors at points without a normal.

        Raises:
            TypeError: The vectors are not real numbers.
            ValueError: The shape is another one.

        Example:
            >>> points = ws.face_centers(ws.load_mesh("courtyard"))
            >>> view = points.to_local([0.0, 0.0, 100.0] - points.position)
            >>> print(view.shape, view.dtype)
            (2080, 3) float32
        """
        return turn_vectors(self.normal, self.tangent, vectors, to_world=False)

    def to_world(self, vectors: Any) -> np.ndarray:
        """Convert vectors in the frames of the points to world coordinates, as `sample_directions` does.

        Args:
            vectors: (3,), (P, 3) or (P, n, 3) real numbers, of any length; +z is the normal.

        Returns:
            (P, 3) or (P, n, 3) float32; zero vectors at points without a normal.

        Raises:
            TypeError: The vectors are not real numbers.
            ValueError: The shape is another one.

        Example:
            >>> points = ws.face_centers(ws.load_mesh("courtyard"))
            >>> up = points.to_world([0.0, 0.0, 1.0])
            >>> print(abs(up - points.normal).max() < 1e-6)
            True
        """
        return turn_vectors(self.normal, self.tangent, vectors, to_world=True)

    def to_polydata(self) -> "PolyData":
        """Return the points as a PyVista PolyData, in the same order.

        Returns:
            A PolyData with the point arrays "Normals" and "face", and "barycentric" and "id" where these are not None.

        Raises:
            ModuleNotFoundError: PyVista is not installed.

        Example:
            >>> made = ws.sample_surface(ws.load_mesh("courtyard"), 100).to_polydata()
            >>> print(made.n_points, sorted(made.point_data))
            100 ['Normals', 'face']
        """
        return cloud(self.position, self.normal, face=self.face, barycentric=self.barycentric, id=self.id)


def face_centers(mesh: Any) -> SurfacePoints:
    """Return the centroid of every face, row i for face i; degenerate faces have a zero normal.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.

    Returns:
        SurfacePoints with position (F, 3) float64, normal (F, 3) float32 of unit length or zero, face, and barycentric.

    Raises:
        TypeError, ValueError: The argument is not a triangle mesh; the message names the argument.

    Example:
        >>> points = ws.face_centers(ws.load_mesh("courtyard"))
        >>> print(points.position.shape, points.face[:3])
        (2080, 3) [0 1 2]
    """
    mesh = as_mesh(mesh)
    position = mesh.vertices[mesh.faces].mean(axis=1)
    thirds = np.full((len(position), 3), 1.0 / 3.0)
    return SurfacePoints(position, mesh.face_normals.copy(), np.arange(len(position), dtype=np.int32), thirds)


def vertex_points(mesh: Any, *, uv: Any = None) -> SurfacePoints:
    """Return every vertex with its area-weighted unit normal, row i for vertex i.

    The normal is zero for vertices without a face and where normals cancel.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        uv: (F, 3, 2) texture coordinates of face corners, as from `load_uv`, which give tangents by MikkTSpace. A vertex has
            the sign of the first of its faces, and the mean tangent of its faces with that sign. Default: None, no tangents.

    Returns:
        SurfacePoints with position (V, 3) float64, normal (V, 3) float32 of unit length or zero, and face -1; with `uv` also
        with a tangent, which is zero for vertices whose faces have no coordinates.

    Raises:
        TypeError, ValueError: An argument is invalid; the message names the argument.

    Source: Mikkelsen2008 for tangents.

    Example:
        >>> points = ws.vertex_points(ws.load_mesh("courtyard"))
        >>> print(points.position.shape, np.linalg.norm(points.normal, axis=1).round(3).min())
        (1089, 3) 1.0
    """
    mesh = as_mesh(mesh)
    tangent = None if uv is None else vertex_tangents(mesh, check_uv(uv, len(mesh.faces)))
    return SurfacePoints(mesh.vertices.copy(), mesh.vertex_normals.copy(), tangent=tangent)


def check_uv(uv: Any, faces: int) -> np.ndarray:
    """Return checked texture coordinates of face corners as (F, 3, 2) float64.

    Raises:
        TypeError, ValueError: the coordinates are no array of F x 3 x 2 real numbers.
    """
    wants = f"({faces}, 3, 2) real numbers, u and v of each corner of a face"
    found = as_real(uv, "uv", wants)
    if found.shape != (faces, 3, 2):
        raise ValueError(f"uv: got shape {found.shape}, want {wants}")
    return found.astype(np.float64)


def _check_face(value: Any) -> np.ndarray:
    face = as_ndarray(value, "face")
    if face.dtype.kind not in "iu" and face.size:
        raise TypeError(f"face: got {f'dtype {face.dtype}' if face.ndim else quote(value)}, want whole numbers")
    if face.size and not (face.min() >= -1 and face.max() < 2**31):
        raise ValueError(f"face: got numbers from {face.min()} to {face.max()}, want -1 (none) or the number of a face")
    return face.astype(np.int32, copy=False)


def _check_rows(value: Any, points: int) -> np.ndarray:
    rows = as_ndarray(value, "rows")
    if rows.shape == (0,):
        return np.zeros(0, np.int64)  # an empty list is of float64 to NumPy
    if rows.dtype.kind not in "biu":
        raise TypeError(f"rows: got {f'dtype {rows.dtype}' if rows.ndim else quote(value)}, want whole numbers or bool")
    if rows.ndim != 1 or (rows.dtype == bool and len(rows) != points):
        raise ValueError(f"rows: got shape {rows.shape}, want (N,) whole numbers, or ({points},) bool")
    if rows.dtype != bool and rows.size and not (rows.min() >= 0 and rows.max() < points):
        raise ValueError(f"rows: got numbers from {rows.min()} to {rows.max()}, want row numbers from 0 to {points - 1}")
    return rows


def _check_id(value: Any) -> np.ndarray:
    id = as_ndarray(value, "id")
    if id.dtype.kind not in "iu" and id.size:
        raise TypeError(
            f"id: got {f'dtype {id.dtype}' if id.ndim else quote(value)}, want 64-bit whole numbers, such as "
            "numpy.array(id, numpy.uint64)"
        )
    if id.size and id.min() < 0:
        raise ValueError(f"id: got {id.min()}, want whole numbers of at least 0")
    return np.ascontiguousarray(id, np.uint64)


def _check_raised(value: Any) -> np.ndarray:
    raised = as_ndarray(value, "raised")
    if raised.dtype != bool:
        raise TypeError(f"raised: got {f'dtype {raised.dtype}' if raised.ndim else quote(value)}, want bool")
    return np.ascontiguousarray(raised)
