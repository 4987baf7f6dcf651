"""What view factors are: a sparse matrix between surfaces, what is beyond them, and what follows of it."""

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.result import Skipped
from warpsample.host.summary import Summary
from warpsample.host.tables import frame_of
from warpsample.radiation.exchange.files import check_factors_file, load, save
from warpsample.radiation.exchange.net_radiation import NetRadiation, net_radiation_of
from warpsample.radiation.exchange.radiosity import radiosity_of

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@dataclass(frozen=True, eq=False, repr=False)
class ViewFactors(Summary):
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

    _counted: ClassVar[str] = "faces"

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

    def net_radiation(self, temperature: Any, emissivity: Any, *, outside: Any = None) -> NetRadiation:
        """The heat that each surface loses by thermal radiation: what it emits, less what it absorbs of the others'.

        Surfaces are grey and diffuse, and opaque: they reflect 1 - emissivity, again and again. What meets a back is lost.

        Args:
            temperature: (N,) or (N, k), for k times; or one number. In kelvin. Where surfaces have names, also a dictionary
                from each name to a number, or to (k,).
            emissivity: (N,), a dictionary from each name, or one number, above 0 to 1.
            outside: what is seen beyond the mesh is black at this temperature in kelvin: one number, or (k,). A closed
                room needs none.

        Returns:
            the net flux in W/m² and power in W of each surface; above 0 where it cools.

        Raises:
            TypeError, ValueError: no finite numbers, another shape, temperatures below 0, no such emissivity, names that
                are not those of the surfaces, none `outside` where more than a thousandth of a row goes there, or rows that
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
