"""Points on the surface of a mesh."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.host.arguments import check_first_point, check_flag, check_integer, check_seed, told
from warpsample.host.arrays import as_ndarray, as_real, cpu
from warpsample.host.engine import check_memory, check_workers, run
from warpsample.mesh.mesh import as_mesh
from warpsample.mesh.placing import place_points
from warpsample.mesh.polydata import cloud

if TYPE_CHECKING:
    from pyvista import PolyData

_BYTES_PER_POINT = 24 + 12 + 4


@dataclass(frozen=True, eq=False)
class SurfacePoints:
    """Points with normals, one per row.

    Attributes:
        position: (P, 3) float64 or float32, in the user's coordinates; other real numbers become float64, here as below.
        normal: (P, 3) float32 or float64; need not be of unit length. A zero normal (degenerate face) is skipped and
            counted wherever directions are asked for.
        face: (P,) int32, the face a point lies on, -1 where it lies on none (the default).
        barycentric: (P, 3) float64 weights of the face's corners, or None.

    Raises:
        TypeError: not real numbers, or faces that are not whole ones.
        ValueError: shapes that do not agree, or faces below -1.
    """

    position: np.ndarray
    normal: np.ndarray
    face: np.ndarray | None = None
    barycentric: np.ndarray | None = None

    def __post_init__(self) -> None:
        """Checks types and shapes and fills in the faces."""
        position, normal = as_real(self.position, "position"), as_real(self.normal, "normal")
        if position.ndim != 2 or position.shape[1] != 3:
            raise ValueError(f"position: got shape {position.shape}, want (P, 3)")
        points = len(position)
        face = np.full(points, -1, np.int32) if self.face is None else _check_face(self.face)
        barycentric = None if self.barycentric is None else as_real(self.barycentric, "barycentric")
        fields = {"position": position, "normal": normal, "face": face, "barycentric": barycentric}
        shapes = {"normal": (points, 3), "face": (points,), "barycentric": (points, 3)}
        for name, array in fields.items():
            if array is not None and array.shape != shapes.get(name, array.shape):
                raise ValueError(f"{name}: got shape {array.shape}, want {shapes[name]} like position")
            object.__setattr__(self, name, array)

    def __len__(self) -> int:
        """How many points."""
        return len(self.position)

    def to_polydata(self) -> "PolyData":
        """The points as PyVista's PolyData, row for row: "Normals", "face", and "barycentric" where kept.

        Raises:
            ModuleNotFoundError: PyVista is missing.
        """
        return cloud(self.position, self.normal, face=self.face, barycentric=self.barycentric)


def sample_surface(
    mesh: Any,
    count: int,
    seed: int = 0,
    first_point: int = 0,
    barycentric: bool = False,
    workers: int | None = None,
) -> SurfacePoints:
    """Points uniform by area: a face by its share of the area, then a uniform point of that triangle.

    Row i is a pure function of (mesh, seed, first_point + i), so a run can be split anywhere. The areas are summed in
    float64 and drawn from with 64 bits: 10^7 faces keep their shares, where float32 gives 1.7 % of all points to the last.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes. Degenerate faces get no points.
        count: how many, 1 to 2^31 - 1.
        seed: of 64 bits.
        first_point: the global id of row 0.
        barycentric: whether to keep the weights of the corners.
        workers: threads, all cores by default.

    Returns:
        position float64, normal float32 (of the face), face; barycentric if asked for.

    Raises:
        TypeError, ValueError: an argument that cannot be used, or a mesh without area; names it.
        MemoryError: more than is free.

    Source: Turk1990, method 2.
    """
    mesh, barycentric = as_mesh(mesh), check_flag(barycentric, "barycentric")
    count = check_integer(count, "count", 1, 2**31 - 1)
    seed, first_point, workers = check_seed(seed), check_first_point(first_point, count), check_workers(workers)
    if not mesh.face_areas.any():
        raise ValueError(f"mesh: got {len(mesh.faces)} faces without any area, want at least one triangle that has some")
    size = count * (_BYTES_PER_POINT + (24 if barycentric else 0))
    check_memory(size, f"{count:,} surface points", "take them in parts with first_point")
    position, face, weights = (
        np.empty((count, 3)),
        np.empty(count, np.int32),
        np.empty((count if barycentric else 0, 3)),
    )
    cumulative = np.cumsum(mesh.face_areas)
    last = int(np.flatnonzero(mesh.face_areas)[-1])
    addresses = [a.ctypes.data for a in (mesh.vertices, mesh.faces, cumulative, position, face)]
    inputs = [seed, first_point, count, len(mesh.vertices), last, *addresses, weights.ctypes.data if barycentric else 0]
    run(place_points(), count, inputs, cpu(), workers, 8 * count)
    return SurfacePoints(position, mesh.face_normals[face], face, weights if barycentric else None)


def face_centers(mesh: Any) -> SurfacePoints:
    """The centroid of every face, row i for face i; degenerate faces keep their row, with a zero normal.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
    """
    mesh = as_mesh(mesh)
    position = mesh.vertices[mesh.faces].mean(axis=1)
    thirds = np.full((len(position), 3), 1.0 / 3.0)
    return SurfacePoints(position, mesh.face_normals.copy(), np.arange(len(position), dtype=np.int32), thirds)


def vertex_points(mesh: Any) -> SurfacePoints:
    """Every vertex with its area-weighted unit normal, row i for vertex i; zero where no face gives one.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
    """
    mesh = as_mesh(mesh)
    return SurfacePoints(mesh.vertices.copy(), mesh.vertex_normals.copy())


def _check_face(value: Any) -> np.ndarray:
    face = as_ndarray(value, "face")
    if face.dtype.kind not in "iu" and face.size:
        raise TypeError(f"face: got {f'dtype {face.dtype}' if face.ndim else told(value)}, want whole numbers")
    if face.size and not (face.min() >= -1 and face.max() < 2**31):
        raise ValueError(f"face: got numbers from {face.min()} to {face.max()}, want -1 (none) to the last of the mesh")
    return face.astype(np.int32, copy=False)
