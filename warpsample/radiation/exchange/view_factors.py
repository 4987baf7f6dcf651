"""View factors between the faces of a mesh, what is in the way included: a sparse matrix that closes, with error bars."""

from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.result import PointStatus, Skipped, has_status
from warpsample.host.arguments import check_flag, check_integer
from warpsample.host.arrays import as_unit
from warpsample.host.options import explained_by
from warpsample.host.progress import bar
from warpsample.host.tables import frame_of
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.radiation.exchange.casting import Casting
from warpsample.radiation.exchange.files import check_factors_file, load, save
from warpsample.radiation.exchange.net_radiation import NetRadiation, net_radiation_of
from warpsample.radiation.exchange.radiosity import radiosity_of
from warpsample.radiation.exchange.reciprocity import reciprocal_factors
from warpsample.radiation.exchange.row_factors import RowFactors, factors_of, matrices_of
from warpsample.radiation.exchange.surfaces import Surfaces, check_groups, surfaces_of
from warpsample.tracing.options import RayOptions
from warpsample.tracing.scene import check_opaque

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_MOST_RAYS = 2**24  # of a face: a replicate is one task
_MOST_REPLICATES = 64


@dataclass(frozen=True, eq=False)
class ViewFactors:
    """View factors between N surfaces: the faces of a mesh, or groups of them.

    Raw, each row of the matrix adds up to 1 with `outside`, `behind` and `absorbed`: its rays are counted, none is lost.
    Where the number of rays is a power of two the sums of these float64 are exact, too; with `absorbed` they are rounded.

    Attributes:
        matrix: (N, N) scipy.sparse.csr_array of float64: the share of what leaves the front of surface i that first meets
            the front of surface j.
        standard_error: of the same pattern; of each entry. Entries of a row are not independent: their sum is known better.
        outside: (N,) float64, what meets nothing.
        outside_error: (N,) float64, its standard error.
        behind: (N,) float64, what meets the back of a face, or a face without area.
        behind_error: (N,) float64.
        areas: (N,) float64, of the surfaces, in square units of the coordinates.
        rays: (N,) int64, rays cast; 0 where it is known that they meet nothing.
        status: (F,) uint8, a `PointStatus` of each face: OK, INACTIVE, or ZERO_NORMAL where it has no area.
        skipped: faces that are not OK as `points`, faces that nothing stands above as `open_points`, their rays.
        sky: (N,) float64, the part of `outside` that is above the horizon; None without `up`.
        sky_error: (N,) float64 or None.
        ground: (N,) float64, the other part, or None.
        ground_error: (N,) float64 or None.
        absorbed: (N,) float64, what faces swallow that let a part of the light through, on the way to where it ends; None
            without such faces.
        absorbed_error: (N,) float64 or None.
        reflectance: (N,) float64, of the mesh's faces, of a group their mean by area; None if they are black.
        names: of the N groups, where they were given by name; else None.
    """

    matrix: "csr_array"
    standard_error: "csr_array"
    outside: NDArray[np.float64]
    outside_error: NDArray[np.float64]
    behind: NDArray[np.float64]
    behind_error: NDArray[np.float64]
    areas: NDArray[np.float64]
    rays: NDArray[np.int64]
    status: NDArray[np.uint8]
    skipped: Skipped
    sky: NDArray[np.float64] | None = None
    sky_error: NDArray[np.float64] | None = None
    ground: NDArray[np.float64] | None = None
    ground_error: NDArray[np.float64] | None = None
    absorbed: NDArray[np.float64] | None = None
    absorbed_error: NDArray[np.float64] | None = None
    reflectance: NDArray[np.float32] | None = None
    names: tuple[str, ...] | None = None

    def radiosity(self, emission: Any, reflectance: Any = None) -> np.ndarray:
        """What leaves each surface, emitted or reflected: J = E + rho F J.

        Solved by following the radiation from surface to surface, to 12 digits. What goes outside, meets a back or is
        absorbed is lost; what comes from there is part of `emission`, as reflectance * outside * sky.

        Args:
            emission: (N,) or (N, k), for k wavelengths or times; or one number. In any unit of power per area.
            reflectance: (N,) or one number, 0 to 1, diffuse; by default that of the mesh.

        Returns:
            of the shape of the emission, float64, in its unit.

        Raises:
            TypeError, ValueError: no finite numbers, another shape, rows that `active` left out, no reflectance of a black
                mesh, or one by which nothing is ever absorbed.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> v = ws.view_factors(mesh, 256)
            >>> J = v.radiosity(emission=0.3 * v.outside, reflectance=0.3)  # under a uniform sky
            >>> print(J.shape, (J >= 0.3 * v.outside).all())
            (2080,) True
        """
        if reflectance is None and self.reflectance is None:
            raise ValueError("reflectance: got None for factors of a black mesh, want numbers from 0 to 1")
        return radiosity_of(self, emission, self.reflectance if reflectance is None else reflectance)

    def net_radiation(self, temperature: Any, emissivity: Any, *, outside: Any = 0.0) -> NetRadiation:
        """The heat that each surface loses by thermal radiation: what it emits, less what it absorbs of the others'.

        Surfaces are grey and diffuse, and opaque: they reflect 1 - emissivity, again and again. What meets a back is lost.

        Args:
            temperature: (N,) or (N, k), for k times; or one number. In kelvin.
            emissivity: (N,) or one number, above 0 to 1.
            outside: what is seen beyond the mesh is black at this temperature in kelvin: one number, or (k,).

        Returns:
            the net flux in W/m² and power in W of each surface; above 0 where it cools.

        Raises:
            TypeError, ValueError: no finite numbers, another shape, temperatures below 0, no such emissivity, or rows that
                `active` left out.

        Source: Hottel1967, chapter 3.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 256)
            >>> night = v.net_radiation(temperature=285.0, emissivity=0.9, outside=265.0)
            >>> print(night.flux.shape, night.flux.max().round())  # W/m2, of what sees the whole sky
            (2080,) 85.0
        """
        return net_radiation_of(self, temperature, emissivity, outside)

    def to_frame(self) -> Any:
        """What is known of each surface as a table, without the matrix.

        Returns:
            a pandas.DataFrame of a row for each surface, or a dictionary of arrays where pandas is not installed: the names,
            where there are any, and all that is of shape (N,), by its name.

        Example:
            >>> factors = ws.view_factors(ws.load_mesh("courtyard"), 16, groups=np.repeat(["yard", "rest"], [848, 1232]))
            >>> print(list(factors.to_frame())[:4], list(factors.to_frame()["names"]))
            ['names', 'outside', 'outside_error', 'behind'] ['rest', 'yard']
        """
        names = {} if self.names is None else {"names": np.array(self.names, object)}
        kept = {item.name: getattr(self, item.name) for item in fields(self) if item.name != "status"}
        return frame_of(names | {name: array for name, array in kept.items() if isinstance(array, np.ndarray)})

    def save(self, path: str | Path) -> None:
        """Writes a file, complete or not at all; what it replaces stays until then.

        Args:
            path: .npz: all fields; scipy.sparse.load_npz reads the matrix from it, `load` all. A name that begins with
                "vfsparse.inp": uDALES' list "i j F" from 1 on, what is below 5e-7 left out, and beside it its "svf.inp", the
                rest of each row. .vf: View3D's text, all N^2 numbers, with emittances of 1.

        Raises:
            TypeError, ValueError: another name, no file that can be written, or a text for rows that `active` left out.
            OSError: it could not be written.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 64)
            >>> folder = __import__("tempfile").mkdtemp()
            >>> v.save(f"{folder}/factors.npz")
            >>> print((ws.ViewFactors.load(f"{folder}/factors.npz").matrix != v.matrix).nnz)
            0
        """
        save(self, check_factors_file(path, "path"))

    @staticmethod
    def load(path: str | Path) -> "ViewFactors":
        """Reads an .npz file of `save`.

        Args:
            path: the file.

        Returns:
            what was saved.

        Raises:
            TypeError, ValueError, OSError: no such file, or a damaged one; nothing in it is executed.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 64, up=(0, 0, 1))
            >>> file = __import__("tempfile").mkdtemp() + "/factors.npz"
            >>> v.save(file)
            >>> print(np.array_equal(ws.ViewFactors.load(file).sky, v.sky))
            True
        """
        return ViewFactors(**load(path, "path"))


@explained_by(RayOptions)
def view_factors(
    mesh: Any,
    count: int = 4096,
    *,
    groups: Any = None,
    reciprocal: bool = False,
    replicates: int = 4,
    seed: int = 0,
    up: Any = None,
    first_face: int = 0,
    active: Any = None,
    skip: bool = True,
    workers: int | None = None,
    progress: bool = False,
) -> ViewFactors:
    """The share of the diffuse radiation of each face's front that first meets each other's front, by rays.

    Places and directions of a face's rays come from one lattice in four dimensions: 4,096 are as good as 10,000 to 15,000
    independent ones. The bits of a row depend on (mesh, seed, first_face + face, count, replicates) alone: not on threads,
    nor on which other faces are active, nor on `skip`. Those of errors depend on other rows, too: how much less than that
    of independent rays the hits of a number vary is told by the replicates of all numbers of as many hits. Memory: 40 bytes
    of each entry and 8 of each of its replicates.

    Where faces have a transmittance (see `Mesh`), what leaves a front ends at the first opaque face: the factor is the share
    of it that gets there, and `absorbed` what is lost on the way, so that rows add up to 1. A face that light goes through
    has a row, and is no column.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes. The front of a face is the side from which its corners run
            counter-clockwise. Where two faces coincide back to back, rays meet the one that is turned to them; of
            two that are turned the same way, one. Rays start two millionths of the mesh's extent in front of their face, at
            its edges four times that inside: a gap between faces at less than 14 degrees may leak as much.
        count: rays of each face, from `replicates` to 2^24; rounded down to a multiple of it.
        groups: (F,) whole numbers from 0 on, the surface that each face is part of: rows and columns are then surfaces, up
            to the largest number, a row the mean of those of its faces, by area. Errors are those of the sums. Or (F,)
            names, or "part" for the named parts of the mesh ("" for faces without one): `names` then says what rows are.
        reciprocal: whether to pool both directions of each pair and adjust them, so that areas[i] matrix[i, j] equals
            areas[j] matrix[j, i] and all rows close to 1e-7. More precise, too; but not where faces lie on one another, nor
            of a mesh that light goes through, where pairs have one direction.
        replicates: independent parts of each face's rays, by whose differences errors are told, 1 to 64; with more of them
            the errors are told better, and are larger. One has none to differ from: errors are then told too large, by how
            much at least such a lattice is better than independent rays.
        up: (3,), of any length, parts `outside` into `sky` and `ground`.
        first_face: the global id of face 0.
        active: (F,) bool; other faces are met, but their own rows stay empty. Not with `reciprocal`.
        skip: whether to cast no rays of faces that nothing stands above; changes no bit but of `rays` and `skipped`.
        seed, workers, progress: see `RayOptions`.

    Returns:
        the matrix, its errors, what meets nothing, and what was done.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Warns:
        UserWarning: parts of the mesh are so far apart that its coordinates are too coarse for most of its faces; or, with
            reciprocal, there are so few rays that no scaling closes all rows.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> v = ws.view_factors(mesh, 256, up=(0, 0, 1))
        >>> closure = v.matrix.sum(axis=1) + v.outside + v.behind
        >>> print(v.matrix.shape, closure.min(), closure.max(), f"{v.sky.mean():.2f}")
        (2080, 2080) 1.0 1.0 0.62
    """
    mesh = as_mesh(mesh)
    faces = len(mesh.faces)
    replicates = check_integer(replicates, "replicates", 1, _MOST_REPLICATES)
    wants = f"a whole number from {replicates}, the number of replicates, to {_MOST_RAYS}"
    rays = check_integer(count, "count", replicates, _MOST_RAYS, wants) // replicates
    groups, names = check_groups(groups, mesh)
    reciprocal = check_flag(reciprocal, "reciprocal")
    options = RayOptions.of(faces, seed=seed, active=active).by(skip=skip, workers=workers, progress=progress)
    casting = Casting(
        mesh,
        rays,
        replicates,
        options.seed,
        None if up is None else as_unit(up, "up"),
        check_integer(first_face, "first_face", 0, 2**64 // replicates - faces),
        options.skip,
        options.workers,
    )
    status = _status(mesh, options.active)
    is_good = has_status(status, PointStatus.OK)
    if active is not None and reciprocal:
        raise ValueError("active: got a mask with reciprocal=True, want None: that takes the rays of both faces of a pair")
    if reciprocal:
        check_opaque(mesh, "reciprocal")
    with bar(options.progress, "casting rays"):
        counts, cast = casting.counts(np.flatnonzero(is_good).astype(np.int32), groups)
    surfaces = surfaces_of(mesh.face_areas, is_good, groups)
    factors = factors_of(counts, casting.rays, casting.upward(), surfaces)
    del counts  # twice as many bytes as the factors
    if reciprocal:
        factors = reciprocal_factors(factors, surfaces)
    found = _result(factors, surfaces, status, casting.rays * cast.astype(np.int64), casting.rays)
    return replace(found, reflectance=surfaces.means(mesh.reflectance) if mesh.reflects else None, names=names)


def _status(mesh: Mesh, active: np.ndarray | None) -> np.ndarray:
    """(F,) uint8, of each face."""
    status = np.where(mesh.face_areas > 0.0, int(PointStatus.OK), int(PointStatus.ZERO_NORMAL)).astype(np.uint8)
    if active is not None:
        status[active == 0] = int(PointStatus.INACTIVE)
    return status


def _result(factors: RowFactors, surfaces: Surfaces, status: np.ndarray, cast: np.ndarray, rays: int) -> ViewFactors:
    """The result of what was counted; `cast`: (F,) rays cast of the `rays` of each face."""
    open_faces = int(np.count_nonzero(has_status(status, PointStatus.OK) & (cast == 0)))
    matrix, standard_error = matrices_of(factors.value, np.sqrt(factors.variance), factors.indices, factors.indptr)
    others = {}
    for name, (value, variance) in factors.others.items():
        others |= {name: value, f"{name}_error": np.sqrt(variance)}
    return ViewFactors(
        matrix=matrix,
        standard_error=standard_error,
        areas=surfaces.areas,
        rays=surfaces.summed(cast),
        status=status,
        skipped=Skipped(int(np.count_nonzero(status)), open_faces, open_faces * rays),
        **others,
    )
