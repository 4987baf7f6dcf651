"""A validated triangle mesh, made from the meshes of other libraries, and a report of its flaws."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import TYPE_CHECKING, Any
from weakref import ref

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.arrays import Array, as_real
from warpsample.host.known import digest_of, find_or_make, remember
from warpsample.host.locks import once_property
from warpsample.host.neighbours import as_ndarray, kind_told
from warpsample.host.summary import Summary
from warpsample.mesh.foreign import KINDS, arrays_of
from warpsample.mesh.indexed import check_faces, check_vertices
from warpsample.mesh.optics import check_share, check_sum, optics_digest
from warpsample.mesh.parts import check_names, check_part
from warpsample.mesh.polydata import surface
from warpsample.mesh.report import MeshReport, report_of

if TYPE_CHECKING:
    from pyvista import PolyData

_SMALLEST = 1e-140  # size of a mesh whose areas have a float64
_LEAST_SQUARE = 1e-280  # square of a length that keeps its precision
_BLOCK = 1 << 18  # faces that are looked at together, so that what is between takes little memory
_SLIVER = 2.0**-48  # of abs(e1) abs(e2): below 16 roundings of the cross product the normal is noise


@dataclass(frozen=True, eq=False, repr=False)
class Mesh(Summary):
    """A triangle mesh.

    Attributes:
        vertices: (V, 3) float64, within ±1e36, in the user's coordinates and unit; a read-only copy.
        faces: (F, 3) int32 indices of vertices, counter-clockwise seen from outside; a read-only copy.
        part: (F,) int32, which of `parts` each face is of, -1 of none, or None; a read-only copy. No number at a point
            depends on it.
        parts: the names of the parts, of which several may be alike.
        transmittance: (F,) float32, the share of light that goes straight on behind each face, from either side and at any
            angle, at each crossing; read-only. None: all faces are opaque. One number is that of all faces.
        reflectance: (F,) float32, the share that either side of each face sends back, evenly in all directions, likewise.
            None: all faces are black. `irradiance`, `irradiation` and `ViewFactors.radiosity` follow what is sent back.

    Raises:
        TypeError: vertices or shares are not real numbers, faces or part not whole ones, or parts no texts.
        ValueError: wrong shapes, no faces, an index that no vertex has, a part that has no name, a coordinate that is not
            finite or beyond 1e36, a share outside 0 to 1, or a transmittance and a reflectance whose sum is above 1.

    Example:
        >>> mesh = ws.Mesh([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]], [[0, 1, 2]])
        >>> print(mesh.face_areas, mesh.face_normals, mesh.report.boundary_edges)
        [2.] [[0. 0. 1.]] 3
    """

    vertices: Array
    faces: Array
    part: Array | None = None
    parts: Sequence[str] = ()
    transmittance: Array | None = None
    reflectance: Array | None = None

    def __post_init__(self) -> None:
        """Validates, copies and freezes: what later calls read must stay what was checked here."""
        vertices = check_vertices(as_real(self.vertices, "vertices"))
        faces = check_faces(as_ndarray(self.faces, "faces", "whole numbers"), len(vertices))
        object.__setattr__(self, "vertices", vertices)
        object.__setattr__(self, "faces", faces)
        object.__setattr__(self, "parts", check_names(self.parts))
        if self.part is not None or self.parts:
            object.__setattr__(self, "part", check_part(self.part, len(faces), len(self.parts)))
        for name in ("transmittance", "reflectance"):
            object.__setattr__(self, name, check_share(getattr(self, name), name, len(faces)))
        check_sum(self.transmittance, self.reflectance)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled and copied as what it is made of, without its tree; a process that knows that content has it already."""
        remember(self._content, self)
        content = self.vertices, self.faces, self.part, self.parts, self.transmittance, self.reflectance
        return find_or_make, (self._content, Mesh, *content)

    def __dask_tokenize__(self) -> tuple[str, str]:
        """What Dask names tasks on it by."""
        return "warpsample.Mesh", self._content

    def __sizeof__(self) -> int:
        """Bytes of vertices, faces, parts and optical properties, as Dask asks for them."""
        names = 0 if self.part is None else self.part.nbytes + sum(map(len, self.parts))
        optics = sum(array.nbytes for array in (self.transmittance, self.reflectance) if array is not None)
        return object.__sizeof__(self) + self.vertices.nbytes + self.faces.nbytes + names + optics

    @once_property
    def digest(self) -> str:
        """SHA-256 of vertices, faces and optical properties, in hexadecimal digits: the same for meshes of the same numbers.

        So parts are not in it: a store of numbers is one of this mesh however its faces are named.
        """
        return optics_digest(digest_of(self.vertices, self.faces), self.transmittance, self.reflectance)

    @once_property
    def _content(self) -> str:
        """What a mesh is known by that arrives in another process: its digest, with its parts if it has any."""
        if self.part is None:
            return self.digest
        names = np.frombuffer("\0".join(self.parts).encode(), np.uint8)
        shape = digest_of(self.vertices, self.faces, self.part, names)
        return optics_digest(shape, self.transmittance, self.reflectance)

    def to_polydata(self) -> "PolyData":
        """The triangles as PyVista's PolyData.

        Returns:
            a copy of the vertices and the faces, in the same order.

        Raises:
            ModuleNotFoundError: PyVista is missing.

        Example:
            >>> made = ws.load_mesh("courtyard").to_polydata()
            >>> print(made.n_points, made.n_cells)
            1089 2080
        """
        return surface(self.vertices, self.faces)

    @once_property
    def transmits(self) -> bool:
        """Whether light goes through some face."""
        return self.transmittance is not None and bool(self.transmittance.any())

    @once_property
    def reflects(self) -> bool:
        """Whether some face sends light back."""
        return self.reflectance is not None and bool(self.reflectance.any())

    @property
    def like(self) -> "Mesh | None":
        """The mesh of this shape that `as_mesh` made this one of, by other shares of light, while that lives; or None."""
        known = vars(self).get("_like")
        return known and known()

    @once_property
    def used(self) -> np.ndarray:
        """(V,) bool: the vertices that faces use. The others mean nothing: they may be anywhere."""
        used = np.zeros(len(self.vertices), np.bool_)
        used[self.faces] = True
        return used

    @once_property
    def bounds(self) -> np.ndarray:
        """(2, 3) float64: smallest and largest coordinates of the vertices that faces use."""
        vertices = self.vertices if self.used.all() else self.vertices[self.used]
        return np.stack([vertices.min(axis=0), vertices.max(axis=0)])

    @once_property
    def diagonal(self) -> float:
        """The diagonal of the box `bounds`, in the unit of the coordinates."""
        return float(np.linalg.norm(self.bounds[1] - self.bounds[0]))

    @once_property
    def cross_products(self) -> np.ndarray:
        """(F, 3) float64: face normals times twice the area; exactly zero for degenerate faces.

        Raises:
            ValueError: the mesh is so small that areas have no float64.
        """
        if 0.0 < np.ptp(self.bounds, axis=0).max() < _SMALLEST:
            raise ValueError(
                f"mesh: got a mesh of size {np.ptp(self.bounds, axis=0).max():.3g}, want at least {_SMALLEST:g}"
            )
        crosses = np.empty((len(self.faces), 3))
        for start in range(0, len(self.faces), _BLOCK):
            rows = slice(start, start + _BLOCK)
            corner, first, second = (self.vertices[self.faces[rows, k]] for k in range(3))
            first -= corner
            second -= corner
            crosses[rows] = np.cross(first, second)
            crosses[rows][lengths(crosses[rows]) <= _SLIVER * lengths(first) * lengths(second)] = 0.0
        return crosses

    @once_property
    def face_areas(self) -> np.ndarray:
        """(F,) float64, square units; 0 for degenerate faces."""
        return 0.5 * lengths(self.cross_products)

    @once_property
    def area_sums(self) -> np.ndarray:
        """(F,) float64, square units: the areas of the faces up to each."""
        return np.cumsum(self.face_areas)

    @once_property
    def face_normals(self) -> np.ndarray:
        """(F, 3) float32, unit length; zero for degenerate faces."""
        return unit_or_zero(self.cross_products)

    @once_property
    def vertex_normals(self) -> np.ndarray:
        """(V, 3) float32, unit length: the normals of its faces weighted by area; zero where they cancel or none is."""
        corners = self.faces.ravel()
        crosses = np.repeat(self.cross_products, 3, axis=0)
        return unit_or_zero(np.stack([np.bincount(corners, axis, len(self.vertices)) for axis in crosses.T], axis=1))

    @once_property
    def report(self) -> MeshReport:
        """The report on this mesh; it takes a sort of all edges."""
        return report_of(self)


def as_mesh(mesh: Any, *, transmittance: Any = None, reflectance: Any = None) -> Mesh:
    """What other libraries hold, as a Mesh.

    Args:
        mesh: a Mesh, which is given back as it is; a tuple (vertices, faces); a pyvista.PolyData or MultiBlock, a
            trimesh.Trimesh or Scene, a meshio.Mesh, or a TriangleMesh of Open3D, of either kind. Polygons are cut into
            triangles. What scenes and blocks hold is placed, joined, and told apart as `parts`.
        transmittance: a number from 0 to 1, or (F,) of them: see `Mesh`. By default as the mesh has it. While a Mesh that
            is given lives, one with other shares takes over its tree.
        reflectance: likewise; with the transmittance at most 1.

    Returns:
        the checked mesh; what it was made of may change later, it does not.

    Raises:
        TypeError: something else.
        ValueError: what it holds is not a valid triangle mesh, or shares that no surface has.

    Example:
        >>> mesh = ws.as_mesh((np.eye(3), np.array([[0, 1, 2]])))  # or ws.as_mesh(pyvista.Sphere())
        >>> print(len(mesh.faces), mesh.face_areas.round(3))
        1 [0.866]
    """
    made = mesh_of(mesh, "mesh", "a warpsample.Mesh")
    given = {"transmittance": transmittance, "reflectance": reflectance}
    given = {name: share for name, share in given.items() if share is not None}
    if not given:
        return made
    changed = replace(made, **given)
    object.__setattr__(changed, "_like", ref(made.like or made))
    return changed


def mesh_of(value: Any, argument: str, wants: str) -> Mesh:
    """The mesh that an argument of any name stands for, as `as_mesh` takes it."""
    if isinstance(value, Mesh):
        return value
    if isinstance(value, tuple) and len(value) == 2:
        return Mesh(*value)
    found = arrays_of(value, argument)
    if found is not None:
        return Mesh(*found)
    if isinstance(value, str | PurePath):
        raise TypeError(f"{argument}: got {told(value)}, want a mesh; warpsample.load_mesh reads files")
    raise TypeError(f"{argument}: got {kind_told(value)}, want {wants}, {KINDS}")


def unit_or_zero(vectors: np.ndarray) -> np.ndarray:
    """(N, 3) float64 vectors as float32 unit ones; zero vectors stay zero."""
    norms = lengths(vectors)[:, None]
    return np.divide(vectors, norms, out=np.zeros_like(vectors), where=norms > 0.0).astype(np.float32)


def lengths(vectors: np.ndarray) -> np.ndarray:
    """(N,) of (N, 3) float64 vectors, those whose squares under- or overflow too."""
    with np.errstate(over="ignore", under="ignore"):
        squares = np.einsum("ij,ij->i", vectors, vectors)
    found = np.sqrt(squares)
    far = np.flatnonzero(~((squares > _LEAST_SQUARE) & (squares < 1.0 / _LEAST_SQUARE)))
    largest = np.abs(vectors[far]).max(axis=1, initial=0.0, keepdims=True)
    scaled = np.divide(vectors[far], largest, out=np.zeros_like(vectors[far]), where=largest > 0.0)
    found[far] = largest[:, 0] * np.linalg.norm(scaled, axis=1)
    return found
