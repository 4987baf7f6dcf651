"""Result of `view_factors`: a sparse matrix between surfaces, and the radiation computed from the matrix."""

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
    """View factors between N surfaces: the faces of a mesh, or groups of faces.

    Without `reciprocal`, each row of the matrix adds up to 1 with `outside`, `behind` and `absorbed`, because every ray is
    counted. If the number of rays is a power of two, the sums are exact in float64, except with `absorbed`.

    Attributes:
        matrix: (N, N) scipy.sparse.csr_array of float64, share of the radiation from the front of surface i that first
            hits the front of surface j.
        standard_error: Standard error of each entry, with the pattern of `matrix`. A pair that no ray hits is not stored, so
            its factor and its error read as 0, although the factor may be small and above 0. With few rays this also
            happens with `reciprocal`, if no ray from either surface hits the other. Errors in a row are not independent:
            the sum of a row is known better than its entries.
        outside: (N,) float64, share that hits nothing.
        outside_error: (N,) float64, standard error of `outside`. Its square is unbiased, so it is 0 where all rays of a face
            hit nothing, although they may have missed a small share. Only faces with 0 `rays` are known to be open.
        behind: (N,) float64, share that hits the back of a face, or a face without area.
        behind_error: (N,) float64, standard error of `behind`.
        areas: (N,) float64, areas of the surfaces, in square units of the coordinates.
        rays: (N,) int64, number of rays cast; 0 for faces whose rays are known to hit nothing.
        status: (F,) uint8, a `PointStatus` of each face: OK, INACTIVE, or ZERO_NORMAL for a face without area.
        skipped: Counts of skipped work: faces that are not OK as `points`, faces with nothing above their plane as
            `open_points`, and the rays of the latter.
        sky: (N,) float64, the part of `outside` above the horizon; None without `up`.
        sky_error: (N,) float64, standard error of `sky`, 0 where `outside_error` is 0, or None.
        ground: (N,) float64, the part of `outside` below the horizon, or None.
        ground_error: (N,) float64, standard error of `ground`, 0 where `outside_error` is 0, or None.
        absorbed: (N,) float64, share that transmitting faces absorb on the way; None without such faces.
        absorbed_error: (N,) float64, standard error of `absorbed`, or None.
        reflectance: (N,) float64, reflectance of the faces, for a group the mean by area; None if all faces are black.
        names: Names of the N groups, if groups were given by name; else None.
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
        """Compute the radiosity of each surface, emitted plus reflected radiation: J = E + rho F J.

        The radiation is followed from surface to surface until 12 digits are stable. Radiation that goes outside, hits a
        back or is absorbed is lost. Radiation from outside must be part of `emission`, as reflectance * outside * sky.

        Args:
            emission: Emitted power per area in any unit: (N,), (N, k) for k wavelengths or times, or one number.
            reflectance: Diffuse reflectance, (N,) or one number, 0 to 1. Default: None, the reflectance of the mesh.

        Returns:
            the radiosity, float64, in the shape and unit of `emission`; (N,) for one number.

        Raises:
            TypeError, ValueError: numbers that are not finite, another shape, factors with inactive faces, a missing
                reflectance for a black mesh, or a reflectance with which nothing is ever absorbed.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> v = ws.view_factors(mesh, 256)
            >>> J = v.radiosity(emission=0.3 * v.outside, reflectance=0.3)  # under a uniform sky
            >>> print(J.shape, (J >= 0.3 * v.outside).all())
            (2080,) True
        """
        if reflectance is None and self.reflectance is None:
            raise ValueError(
                "reflectance: got None for view factors of a mesh without a reflectance, want numbers from 0 to 1"
            )
        self._check_rows()
        return radiosity_of(self.matrix, emission, self.reflectance if reflectance is None else reflectance)

    def net_radiation(self, temperature: Any, emissivity: Any, *, outside: Any = None) -> NetRadiation:
        """Compute the net heat loss of each surface by thermal radiation: emission minus absorbed radiation.

        Surfaces are grey, diffuse and opaque: they reflect a share of 1 - emissivity, in all orders. Radiation that hits a
        back is lost.

        Args:
            temperature: Temperatures in kelvin: (N,), (N, k) for k times, or one number. For named surfaces also a
                dictionary from each name to a number or to (k,).
            emissivity: Emissivities above 0 and up to 1: (N,), a dictionary from each name, or one number.
            outside: Temperature in kelvin of the black surroundings outside the mesh: one number, or (k,) if `temperature`
                is (N, k). Default: None, for a closed room.

        Returns:
            the net flux in W/m² and the power in W of each surface; positive where the surface cools.

        Raises:
            TypeError, ValueError: numbers that are not finite or out of range, another shape, unknown names, no `outside`
                although more than a thousandth of a row goes there, or factors with inactive faces.

        Source: Hottel1967, chapter 3.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 256)
            >>> night = v.net_radiation(temperature=285.0, emissivity=0.9, outside=265.0)
            >>> print(night.flux.shape, night.flux.max().round())  # W/m2, of faces under the whole sky
            (2080,) 85.0
        """
        if self.absorbed is not None:
            raise ValueError(
                "mesh: got view factors of a mesh with a transmittance, want opaque faces, because translucent faces "
                "would radiate, too"
            )
        self._check_rows()
        how = {"areas": self.areas, "names": self.names}
        return net_radiation_of(self.matrix, self.outside, temperature, emissivity, outside, **how)

    def to_frame(self) -> Any:
        """Return all numbers per surface as a table, for example the share that leaves the scene; the matrix is left out.

        Returns:
            a pandas.DataFrame with a row for each surface; without pandas a dictionary of arrays. Columns are the names if
            there are any, and all fields of shape (N,).

        Example:
            >>> factors = ws.view_factors(ws.load_mesh("courtyard"), 16, groups=np.repeat(["yard", "rest"], [848, 1232]))
            >>> print(list(factors.to_frame())[:4], list(factors.to_frame()["names"]))
            ['names', 'outside', 'outside_error', 'behind'] ['rest', 'yard']
        """
        names = {} if self.names is None else {"names": np.array(self.names, object)}
        kept = {item.name: getattr(self, item.name) for item in fields(self) if item.name != "status"}
        return frame_of(names | {name: array for name, array in kept.items() if isinstance(array, np.ndarray)})

    def save(self, path: str | Path) -> None:
        """Write the view factors to a file; the file is complete or absent, and replaces an old one only when complete.

        Args:
            path: Path of the file, whose name gives the format. A name in .npz holds all fields for `load`;
                scipy.sparse.load_npz reads the matrix from it. A name that begins with "vfsparse.inp" holds uDALES' list
                "i j F", numbered from 1, without factors below 5e-7; the rest of each row goes to "svf.inp" in the same
                folder. A name in .vf holds View3D's text, all N^2 numbers, with emittances of 1.

        Raises:
            TypeError, ValueError: another name, a path that cannot be written, or a text format for inactive faces.
            OSError: the file cannot be written.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 64)
            >>> folder = __import__("tempfile").mkdtemp()
            >>> v.save(f"{folder}/factors.npz")
            >>> print((ws.ViewFactors.load(f"{folder}/factors.npz").matrix != v.matrix).nnz)
            0
        """
        file = check_factors_file(path, "path")
        if file.suffix != ".npz":
            self._check_rows()
        save(vars(self), file)

    def row_sums(self) -> np.ndarray:
        """Compute the sum of all shares of each surface's radiation: factors, outside, behind and absorbed.

        Returns:
            the sums, (N,) float64: 1 if every ray is counted, 0 for surfaces without rays.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 64)
            >>> print(v.row_sums().min(), v.row_sums().max())
            1.0 1.0
        """
        return self.matrix.sum(axis=1) + self.outside + self.behind + (0.0 if self.absorbed is None else self.absorbed)

    def _check_rows(self) -> None:
        """Raise a ValueError if the view factors lack rows because `active` excluded surfaces.

        Raises:
            ValueError: a surface with area has an empty row.
        """
        if (left_out := (self.areas > 0.0) & (self.row_sums() == 0.0)).any():
            raise ValueError(
                f"active: got {np.count_nonzero(left_out)} rows without rays, want view factors of all faces; compute them "
                "without active="
            )

    @staticmethod
    def load(path: str | Path) -> "ViewFactors":
        """Read view factors from an .npz file written by `save`.

        Args:
            path: Path of the file.

        Returns:
            the view factors as they were saved.

        Raises:
            TypeError, ValueError, OSError: no such file, or a damaged one. Nothing in the file is executed.

        Example:
            >>> v = ws.view_factors(ws.load_mesh("courtyard"), 64, up=(0, 0, 1))
            >>> file = __import__("tempfile").mkdtemp() + "/factors.npz"
            >>> v.save(file)
            >>> print(np.array_equal(ws.ViewFactors.load(file).sky, v.sky))
            True
        """
        return ViewFactors(**load(path, "path"))
