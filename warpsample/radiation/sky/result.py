"""Result of a sky matrix: values and errors for each point and patch, and counts of the skipped work."""

from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.result import PointResult
from warpsample.host.arguments import quote
from warpsample.host.files import check_output, complete_or_absent, write_arrays
from warpsample.radiation.exchange.matrix_files import write_matrix
from warpsample.radiation.sky.patches import SkyPatches

_FORMATS = (".npz", ".mtx")


@dataclass(frozen=True)
class SkySkipped:
    """Counts of the points and sky patches whose rays `sky_matrix` left out because the result was already known.

    Attributes:
        points: Number of points without a result: inactive, without a normal, or without a finite position.
        open_points: Number of points that cast no ray and have an open patch.
        open_patches: Number of patches above the horizon that nothing blocks, over all points; the share is exact.
        closed_patches: Number of patches that one triangle fills, over all points; the share is 0.
        patches_below: Number of patches below the point's own horizon, over all points; the share is 0.
    """

    points: int = 0
    open_points: int = 0
    open_patches: int = 0
    closed_patches: int = 0
    patches_below: int = 0


@dataclass(frozen=True, eq=False, repr=False)
class SkyMatrix(PointResult):
    """Sky matrix: how much each point sees of each sky patch, weighted by the cosine; or weighted sums over the patches.

    Attributes:
        value: (P, K) float32, integral of visibility times max(0, n.w) over the patch, divided by pi. A value times pi and
            the patch's radiance is an irradiance. The sum over the patches is the sky view factor. With `fold`, (P,) or
            (P, T). 0 where the status is not 0.
        standard_error: Standard error in the shape of `value`, from two independent randomisations of each patch's rays. If
            all rays of a patch agree, it is 0.32 of the weight of a ray. It is 0 only for values known without rays.
        rays: (P,) int32, number of rays cast.
        status: (P,) uint8, a `PointStatus`.
        skipped: Counts of the skipped work.
        patches: Patches of the sky.
        folded: Whether the values are sums over the patches.
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
        r"""Write the result to a file; the file is complete or absent.

        Args:
            path: Path of the file. A name in .npz holds the arrays by name, with the patches' directions and solid_angles.
                A name in .mtx holds a Radiance matrix for `dctimestep` and `rmtxop`: a row for each point, the ground's
                column of zeros first, then pi times the values, as `rcontrib` writes.

        Raises:
            TypeError, ValueError: another file name, or a folded matrix as .mtx.
            OSError: the file cannot be written.

        Example:
            >>> import pathlib, tempfile
            >>> mesh, path = ws.load_mesh("courtyard"), pathlib.Path(tempfile.mkdtemp(), "sky.mtx")
            >>> ws.sky_matrix(mesh, ws.sample_surface(mesh, 9), 64).save(path)
            >>> print(path.read_bytes()[:28])
            b'#?RADIANCE\nNROWS=9\nNCOLS=146'
        """
        wants = f"the path of a file of {' or '.join(_FORMATS)}"
        if not isinstance(path, str | Path):
            raise TypeError(f"path: got {quote(path)}, want {wants}")
        target = Path(path)
        if target.suffix not in _FORMATS:
            raise ValueError(f"path: got {str(path)!r}, want {wants}")
        if target.suffix == ".mtx" and self.folded:
            raise ValueError(
                f"path: got {str(path)!r} for a result of sky_matrix with fold=, want .npz, or a result without fold"
            )
        check_output(target, "path")
        with complete_or_absent(target) as stream:
            if target.suffix == ".mtx":
                write_matrix(stream, self.value, pi)
                return
            arrays = {name: getattr(self, name) for name in ("value", "standard_error", "rays", "status")}
            arrays |= {name: getattr(self.patches, name) for name in ("directions", "solid_angles")}
            write_arrays(stream, arrays)
