"""The call `sky_matrix`: the cosine-weighted share of each sky patch in the view of each point."""

from math import prod
from typing import Any

import numpy as np
from typing_extensions import Unpack

from warpsample.estimate.plan import Plan, plan_of
from warpsample.estimate.result import PointStatus, has_status
from warpsample.host.arrays import as_real, cpu
from warpsample.host.engine import check_memory, run
from warpsample.host.options import CastPointKeywords, with_options
from warpsample.host.progress import bar
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.folding import fold_rows
from warpsample.radiation.sky.kernel import sky_kernel
from warpsample.radiation.sky.patch_rays import SkyRowsArgs
from warpsample.radiation.sky.patches import SkyPatches, sky_patches
from warpsample.radiation.sky.prepared import prepare_sky
from warpsample.radiation.sky.result import SkyMatrix, SkySkipped
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.rays import RAY_WORK

_LARGEST = 1e37  # of a number of a sky: results are float32
_BLOCK_BYTES = 1 << 25  # of the rows in memory at a time while the matrix is folded
_BYTES_OF_NUMBER = 8  # per value and error


@with_options(CastPointKeywords)
def sky_matrix(
    mesh: Any,
    points: SurfacePoints,
    count: int = 1024,
    *,
    patches: str = "tregenza",
    up: Any = (0.0, 0.0, 1.0),
    north: Any = (0.0, 1.0, 0.0),
    fold: Any = None,
    **options: Unpack[CastPointKeywords],
) -> SkyMatrix:
    """Compute how much each point sees of each sky patch, weighted by the cosine: daylight coefficients divided by pi.

    An empty patch has its exact share and costs no ray, as does a patch that a single triangle fills, with 0. Each other
    patch gets its share of `count` rays, but at least 2; fewer where less than a quarter of the lobe is sky. Rays of a patch
    do not depend on other patches, and are distributed as the cosine.

    The bits depend on (mesh, point, first_point + row, seed, count, patches, up, north) alone. The call runs on the CPU.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        count: Number of rays per point, 2 to 2^24, if no patch is known without rays. Default: 1024.
        patches: Patches of the sky, "tregenza" (145), "reinhart2" (577) or "reinhart4" (2,305). Default: "tregenza".
        up: (3,) vector of any length towards the zenith. Default: (0.0, 0.0, 1.0).
        north: (3,) vector of any length, not along `up`; its part across `up` counts. Default: (0.0, 1.0, 0.0).
        fold: (K,) or (K, T) skies to multiply the matrix with, in float64 and part by part. Default: None, the matrix.
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        active: (P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        value (P, K), or with `fold` (P,) or (P, T), the standard error, the patches, and for each point the number of rays
        cast and a status.

    Raises:
        TypeError, ValueError: an argument has a wrong type, shape or value.
        MemoryError: the result needs more memory than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> points = ws.sample_surface(mesh, 100)
        >>> seen = ws.sky_matrix(mesh, points, 256)
        >>> view = ws.sky_view_factor(mesh, points, 256)
        >>> print(seen.value.shape, f"{seen.value.sum(axis=1).mean():.1f} {view.value.mean():.1f}")
        (100, 145) 0.6 0.6
    """
    plan = plan_of(PlacedPoints.of(mesh, points), count, tracer="wide", **options)
    sky = sky_patches(patches, up=up, north=north)
    return compute_sky_matrix(plan, sky, None if fold is None else _check_fold(fold, len(sky)))


def compute_sky_matrix(plan: Plan, sky: SkyPatches, fold: np.ndarray | None) -> SkyMatrix:
    """Compute the sky matrix for checked arguments, or its product with `fold`.

    Args:
        plan: Points and options.
        sky: Patches.
        fold: (K,) or (K, T) finite numbers. None for the matrix.
    """
    columns = len(sky) if fold is None else prod(fold.shape[1:])
    check_memory(
        _BYTES_OF_NUMBER * len(plan.at) * columns,
        f"{len(plan.at):,} rows of {columns:,} numbers and their errors",
        "pass fewer points at a time" if fold is not None else "pass fewer points at a time, or pass fold",
    )
    with bar(plan.options.progress, "casting rays", len(plan.at)):
        rows = _Rows(plan, sky)
        out = rows.whole() if fold is None else rows.folded(fold)
    return SkyMatrix(*out, rows.tally[:, 0].copy(), rows.status, rows.skipped(), sky, fold is not None)


def _check_fold(fold: Any, patches: int) -> np.ndarray:
    """Check the argument `fold`, and return it as a (K,) or (K, T) array of float32 or float64.

    Raises:
        TypeError, ValueError: not numbers, another shape, NaN, or a number beyond 1e37.
    """
    wants = f"numbers from -1e37 to 1e37 of shape ({patches},) or ({patches}, T), one for each patch"
    array = as_real(fold, "fold", wants)
    if array.ndim not in (1, 2) or array.shape[0] != patches or array.size == 0:
        raise ValueError(f"fold: got shape {array.shape}, want {wants}")
    if not (np.abs(array) <= _LARGEST).all():
        raise ValueError(f"fold: got NaN or a number beyond {_LARGEST:g}, want {wants}")
    return array


class _Rows:
    """Computation of a sky matrix at prepared points, in one piece or in blocks of rows."""

    def __init__(self, plan: Plan, sky: SkyPatches) -> None:
        """Prepare the points to cast rays, and allocate the counters of skipped work."""
        self.plan, self.sky, points = plan, sky, len(plan.at)
        self.tally = np.zeros((points, 4), np.int32)
        self.status = np.zeros(points, np.uint8)
        self.placement = plan.at.facing(plan.options) if points else None

    def whole(self) -> list[np.ndarray]:
        """Compute the whole sky matrix and its standard errors, (P, K) each."""
        out = [np.zeros((len(self.status), len(self.sky)), np.float32) for _ in range(2)]
        self._run(*out, self._order(), False)
        return out

    def folded(self, fold: np.ndarray) -> list[np.ndarray]:
        """Compute the sky matrix times `fold`, (K,) or (K, T), and the standard errors, one block of points at a time."""
        weights = np.array(fold.reshape(len(fold), -1), np.float64, order="C")
        out = [np.zeros((len(self.status), weights.shape[1]), np.float32) for _ in range(2)]
        order = self._order()
        order = np.arange(len(self.status)) if order is None else order
        block = max(1, _BLOCK_BYTES // (_BYTES_OF_NUMBER * len(self.sky)))
        rows = [np.empty((min(block, len(order)), len(self.sky)), np.float32) for _ in range(2)]
        for first in range(0, len(order), block):
            chosen = order[first : first + block]
            self._run(*rows, chosen, True)
            good = has_status(self.status[chosen], PointStatus.OK)
            for array in rows:
                array[: len(chosen)][~good] = 0.0
            fold_rows(*rows, chosen, weights=weights, out=out, workers=self.plan.options.workers)
        return [array.reshape(len(array), *fold.shape[1:]) for array in out]

    def skipped(self) -> SkySkipped:
        """Return the numbers of points and patches that cast no rays."""
        uncast = (self.tally[:, 0] == 0) & has_status(self.status, PointStatus.OK)
        _cast, open_, closed, below = self.tally.sum(axis=0, dtype=np.int64).tolist()
        return SkySkipped(
            points=int(np.count_nonzero(self.status)),
            open_points=int(np.count_nonzero(uncast & (self.tally[:, 1] > 0))),
            open_patches=open_,
            closed_patches=closed,
            patches_below=below,
        )

    def _order(self) -> np.ndarray | None:
        """Return the order of processing the points, (P,) int64; None for the order of the rows."""
        if not len(self.status):
            return None
        return self.plan.at.order(self.placement, self.plan.count, self.plan.options.workers)

    def _run(self, value: np.ndarray, error: np.ndarray, order: np.ndarray | None, by_task: bool) -> None:
        """Compute the rows of the sky matrix for the points in `order`, and write values and errors to the given arrays.

        With `by_task` the i-th point writes row i.
        """
        plan, options, points = self.plan, self.plan.options, len(self.status) if order is None else len(order)
        if not points:
            return
        self.placement.order = 0 if order is None else order.ctypes.data
        sky = prepare_sky(self.sky)
        own = {"normals": plan.at.normal, "value": value, "error": error, "tally": self.tally, "status": self.status}
        rows = SkyRowsArgs(
            placement=self.placement,
            seed=seed_for("sky", options.seed),
            first_point=options.first_point,
            active=0 if options.active is None else options.active.ctypes.data,
            count=plan.count,
            patches=len(self.sky),
            groups=len(sky.begins) - 1,
            skip=options.skip,
            by_task=by_task,
            **{name: array.ctypes.data for name, array in (own | vars(sky)).items()},
        )
        scene = plan.at.scene
        accelerator = options.tracer.accelerator(scene, cpu(), options.workers)
        if scene.has_glass:
            rows.glass = scene.glass(options.workers)
        work = prod((RAY_WORK, points, plan.count + len(self.sky)))
        run(sky_kernel(scene.has_glass), points, [rows, accelerator], cpu(), workers=options.workers, work=work)
