"""The class `Mesh`, a checked triangle mesh, and `as_mesh`, which converts the meshes of other libraries."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import TYPE_CHECKING, Any
from weakref import ref

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.arrays import Array, as_real
from warpsample.host.locks import once_property
from warpsample.host.neighbours import as_ndarray, describe_type
from warpsample.host.shared_values import digest_of, find_or_make, remember
from warpsample.host.summary import Summary
from warpsample.mesh.foreign import KINDS, arrays_of
from warpsample.mesh.indexed import check_faces, check_vertices
from warpsample.mesh.optics import check_share, check_sum, optics_digest
from warpsample.mesh.parts import check_names, check_part
from warpsample.mesh.polydata import surface
from warpsample.mesh.report import MeshReport, report_of

if TYPE_CHECKING:
    from pyvista import PolyData

_SMALLEST = 1e-140  # size of the smallest mesh with areas that float64 can represent
_LEAST_SQUARE = 1e-280  # smallest squared length with full precision
_BLOCK = 1 << 18  # faces per step, so that temporary arrays stay small
_SLIVER = 2.0**-48  # of abs(e1) abs(e2): below 16 roundings of the cross product the normal is noise


@dataclass(frozen=True, eq=False, repr=False)
class Mesh(Summary):
    """Triangle mesh: checked vertices and faces, with optional named parts and optical properties of faces.

    Attributes:
        vertices: (V, 3) float64 coordinates from -1e36 to 1e36, in the user's system and unit; a read-only copy.
        faces: (F, 3) int32 indices of vertices, counter-clockwise seen from outside; a read-only copy.
        part: (F,) int32 index into `parts` of each face, -1 for a face without a part; a read-only copy. None: the mesh has
            no parts. Results at points do not depend on `part`.
        parts: Names of the parts. Several parts may have the same name.
        transmittance: (F,) float32 fraction of light, 0 to 1, that continues straight through each face, the same for both
            sides and all angles; read-only. One number applies to all faces. None: all faces are opaque.
        reflectance: (F,) float32 fraction of light, 0 to 1, that each side of a face reflects diffusely; read-only. One
            number applies to all faces. None: all faces are black. `irradiance`, `irradiation` and `ViewFactors.radiosity`
            use it.

    Raises:
        TypeError: Vertices or optical properties are not real numbers, `faces` or `part` not integers, or `parts` not
            strings.
        ValueError: Wrong shapes, no faces, an index outside `vertices` or `parts`, a coordinate that is not finite or
            exceeds 1e36 in absolute value, an optical property outside 0 to 1, or a transmittance and reflectance with a sum
            above 1.

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
        """Validate, copy and freeze the arrays, so that later calls read the checked values."""
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
        """Return the arguments for pickling, without the ray-tracing tree.

        A process that already holds an equal mesh reuses that mesh and its tree.
        """
        remember(self._content, self)
        content = self.vertices, self.faces, self.part, self.parts, self.transmittance, self.reflectance
        return find_or_make, (self._content, Mesh, *content)

    def __dask_tokenize__(self) -> tuple[str, str]:
        """Return the token that Dask computes task names from; equal meshes have equal tokens."""
        return "warpsample.Mesh", self._content

    def __sizeof__(self) -> int:
        """Return the bytes of vertices, faces, parts and optical properties; Dask asks for this number."""
        names = 0 if self.part is None else self.part.nbytes + sum(map(len, self.parts))
        optics = sum(array.nbytes for array in (self.transmittance, self.reflectance) if array is not None)
        return object.__sizeof__(self) + self.vertices.nbytes + self.faces.nbytes + names + optics

    @once_property
    def digest(self) -> str:
        """SHA-256 of vertices, faces and optical properties, in hexadecimal digits; equal for meshes with equal numbers.

        Names and numbers of parts are not included, so a store of results stays valid when parts are renamed.
        """
        return optics_digest(digest_of(self.vertices, self.faces), self.transmittance, self.reflectance)

    @once_property
    def _content(self) -> str:
        """SHA-256 of the mesh including its parts, the key under which processes share equal meshes."""
        if self.part is None:
            return self.digest
        names = np.frombuffer("\0".join(self.parts).encode(), np.uint8)
        shape = digest_of(self.vertices, self.faces, self.part, names)
        return optics_digest(shape, self.transmittance, self.reflectance)

    def to_polydata(self) -> "PolyData":
        """Return the triangles as a PyVista PolyData.

        Returns:
            A PolyData with copies of the vertices and the faces, in the same order.

        Raises:
            ModuleNotFoundError: PyVista is not installed.

        Example:
            >>> made = ws.load_mesh("courtyard").to_polydata()
            >>> print(made.n_points, made.n_cells)
            1089 2080
        """
        return surface(self.vertices, self.faces)

    @once_property
    def transmits(self) -> bool:
        """Boolean, True if at least one face has a transmittance above 0."""
        return self.transmittance is not None and bool(self.transmittance.any())

    @once_property
    def reflects(self) -> bool:
        """Boolean, True if at least one face has a reflectance above 0."""
        return self.reflectance is not None and bool(self.reflectance.any())

    @property
    def like(self) -> "Mesh | None":
        """Mesh with the same vertices and faces from which this mesh was copied with other optical properties, or None.

        None, too, after that mesh is deleted.
        """
        known = vars(self).get("_like")
        return known and known()

    @once_property
    def used(self) -> np.ndarray:
        """Mask of the vertices that faces use, (V,) bool; unused vertices may have any coordinates."""
        used = np.zeros(len(self.vertices), np.bool_)
        used[self.faces] = True
        return used

    @once_property
    def bounds(self) -> np.ndarray:
        """Smallest and largest coordinates of the vertices that faces use, (2, 3) float64."""
        vertices = self.vertices if self.used.all() else self.vertices[self.used]
        axes = vertices.T  # min(axis=0) of vertices takes 6 times as long
        return np.array([[axis.min() for axis in axes], [axis.max() for axis in axes]])

    @once_property
    def diagonal(self) -> float:
        """Length of the diagonal of the bounding box, in the unit of the coordinates."""
        return float(np.linalg.norm(self.bounds[1] - self.bounds[0]))

    @once_property
    def cross_products(self) -> np.ndarray:
        """Cross products of two edges of each face, (F, 3) float64: normals with a length of twice the face's area.

        Exactly zero for degenerate faces.

        Raises:
            ValueError: The mesh is too small for its areas to be represented in float64.
        """
        if 0.0 < np.ptp(self.bounds, axis=0).max() < _SMALLEST:
            raise ValueError(
                f"mesh: got a mesh of size {np.ptp(self.bounds, axis=0).max():.3g}, want at least {_SMALLEST:g}; "
                "scale the mesh up"
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
        """Face areas, (F,) float64, in square units of the coordinates; 0 for degenerate faces."""
        return 0.5 * lengths(self.cross_products)

    @once_property
    def area_sums(self) -> np.ndarray:
        """Cumulative sum of the face areas, (F,) float64, in square units of the coordinates."""
        return np.cumsum(self.face_areas)

    @once_property
    def face_normals(self) -> np.ndarray:
        """Face normals of unit length, (F, 3) float32; zero for degenerate faces."""
        return unit_or_zero(self.cross_products)

    @once_property
    def vertex_normals(self) -> np.ndarray:
        """Vertex normals of unit length, (V, 3) float32: the area-weighted mean over adjacent faces.

        Zero for vertices without a face and where the normals of the adjacent faces cancel.
        """
        corners = self.faces.ravel()
        crosses = np.repeat(self.cross_products, 3, axis=0)
        return unit_or_zero(np.stack([np.bincount(corners, axis, len(self.vertices)) for axis in crosses.T], axis=1))

    @once_property
    def report(self) -> MeshReport:
        """Report with the numbers of faces, vertices and defects of the mesh; the first access sorts all edges."""
        return report_of(self.faces, self.face_areas, self.used, self.bounds)


def as_mesh(mesh: Any, *, transmittance: Any = None, reflectance: Any = None) -> Mesh:
    """Convert a mesh of another library to a `Mesh`.

    Args:
        mesh: One of: a Mesh, which is returned unchanged; a tuple (vertices, faces); a pyvista.PolyData or MultiBlock; a
            trimesh.Trimesh or Scene; a meshio.Mesh; an Open3D TriangleMesh of either kind. Polygons are cut into triangles,
            those of PyVista by `PolyData.triangulate`, which leaves out polygons that touch themselves, as at a bridge to a
            hole. The members of scenes and blocks are placed and joined, and become the `parts` of the mesh.
        transmittance: A number from 0 to 1, or (F,) of them, one per face; see `Mesh`. Default: None, unchanged. A changed
            copy of a Mesh reuses the ray-tracing tree of the original while the original exists.
        reflectance: A number from 0 to 1, or (F,) of them, one per face; see `Mesh`. The sum with the transmittance is at
            most 1. Default: None, unchanged.

    Returns:
        The checked mesh. Later changes of the argument do not change the mesh.

    Raises:
        TypeError: An object of another type.
        ValueError: An invalid triangle mesh, or optical properties outside 0 to 1 or with a sum above 1.

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
    """Convert the value of an argument to a `Mesh` like `as_mesh`, with the argument's name in error messages."""
    if isinstance(value, Mesh):
        return value
    if isinstance(value, tuple) and len(value) == 2:
        return Mesh(*value)
    found = arrays_of(value, argument)
    if found is not None:
        return Mesh(*found)
    if isinstance(value, str | PurePath):
        raise TypeError(f"{argument}: got {quote(value)}, want a mesh; warpsample.load_mesh reads files")
    raise TypeError(f"{argument}: got {describe_type(value)}, want {wants}, {KINDS}")


def unit_or_zero(vectors: np.ndarray) -> np.ndarray:
    """Return (N, 3) float64 vectors scaled to unit length, as float32; zero vectors stay zero."""
    norms = lengths(vectors)[:, None]
    return np.divide(vectors, norms, out=np.zeros_like(vectors), where=norms > 0.0).astype(np.float32)


def lengths(vectors: np.ndarray) -> np.ndarray:
    """Return the (N,) lengths of (N, 3) float64 vectors, also where the squared length under- or overflows."""
    with np.errstate(over="ignore", under="ignore"):
        squares = np.einsum("ij,ij->i", vectors, vectors)
    found = np.sqrt(squares)
    far = np.flatnonzero(~((squares > _LEAST_SQUARE) & (squares < 1.0 / _LEAST_SQUARE)))
    largest = np.abs(vectors[far]).max(axis=1, initial=0.0, keepdims=True)
    scaled = np.divide(vectors[far], largest, out=np.zeros_like(vectors[far]), where=largest > 0.0)
    found[far] = largest[:, 0] * np.linalg.norm(scaled, axis=1)
    return found
