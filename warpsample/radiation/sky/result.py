"""The result of a sky matrix: numbers for each point and patch, their errors, and what was skipped."""

from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.result import PointResult
from warpsample.host.arguments import told
from warpsample.host.files import check_output, complete_or_absent, write_arrays
from warpsample.radiation.exchange.matrix_files import write_matrix
from warpsample.radiation.sky.patches import SkyPatches

_FORMATS = (".npz", ".mtx")


@dataclass(frozen=True)
class SkySkipped:
    """How much work a sky matrix was spared, without a change to the result.

    Attributes:
        points: without numbers: inactive, without a normal, nowhere.
        open_points: that no ray was cast from.
        open_patches: of all points together, above the horizon and met by nothing: their share is known.
        closed_patches: filled by one triangle: 0.
        patches_below: of the point's own horizon: 0.
    """

    points: int = 0
    open_points: int = 0
    open_patches: int = 0
    closed_patches: int = 0
    patches_below: int = 0


@dataclass(frozen=True, eq=False, repr=False)
class SkyMatrix(PointResult):
    """The share of its lobe that each of K patches lights at each of P points; or sums over the patches.

    Attributes:
        value: (P, K) float32, the integral of visibility times max(0, n.w) over the patch, over pi: pi times this times the
            patch's radiance is its irradiance, and the sum over the patches the sky view factor. With `fold` (P,) or (P, T).
            0 where the status is not 0.
        standard_error: of the same shape, from two independent randomisations of each patch's rays; 0 where all agree. It is
            right on average, not at each patch.
        rays: (P,) int32, rays cast.
        status: (P,) uint8, a `PointStatus`.
        skipped: what was not done.
        patches: the sky.
        folded: whether the values are sums over the patches.
    """

    value: NDArray[np.float32]
    standard_error: NDArray[np.float32]
    rays: NDArray[np.int32]
    status: NDArray[np.uint8]
    skipped: SkySkipped
    patches: SkyPatches
    folded: bool = False

    _axes: ClassVar[tuple[str, ...]] = ("patch",)

    def save(self, path: Any) -> None:
        r"""Writes a file, complete or not at all.

        Args:
            path: .npz, the arrays by name with the patches' directions and solid_angles; or .mtx, a matrix of Radiance's
                that `dctimestep` and `rmtxop` read: a row for each point, the ground's column of zeros first, then pi
                times the values, as of `rcontrib`.

        Raises:
            TypeError, ValueError: no such path, or a folded matrix as .mtx.
            OSError: it cannot be written.

        Example:
            >>> import pathlib, tempfile
            >>> mesh, path = ws.load_mesh("courtyard"), pathlib.Path(tempfile.mkdtemp(), "sky.mtx")
            >>> ws.sky_matrix(mesh, ws.sample_surface(mesh, 9), 64).save(path)
            >>> print(path.read_bytes()[:28])
            b'#?RADIANCE\nNROWS=9\nNCOLS=146'
        """
        wants = f"the path of a file of {' or '.join(_FORMATS)}"
        if not isinstance(path, str | Path):
            raise TypeError(f"path: got {told(path)}, want {wants}")
        target = Path(path)
        if target.suffix not in _FORMATS:
            raise ValueError(f"path: got {str(path)!r}, want {wants}")
        if target.suffix == ".mtx" and self.folded:
            raise ValueError(f"path: got {str(path)!r} for sums of shape {self.value.shape}, want .npz, or no fold")
        check_output(target, "path")
        with complete_or_absent(target) as stream:
            if target.suffix == ".mtx":
                write_matrix(stream, self.value, pi)
                return
            arrays = {name: getattr(self, name) for name in ("value", "standard_error", "rays", "status")}
            arrays |= {name: getattr(self.patches, name) for name in ("directions", "solid_angles")}
            write_arrays(stream, arrays)
