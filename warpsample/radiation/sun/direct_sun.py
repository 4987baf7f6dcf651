"""The call `direct_sun`: which sun positions each point sees, or a weighted sum over these positions."""

from dataclasses import dataclass
from math import radians, sin
from typing import Any

import numpy as np
import warp as wp
from typing_extensions import Unpack

from warpsample.host.arguments import check_flag, check_number
from warpsample.host.arrays import as_real, cpu
from warpsample.host.engine import check_memory, run
from warpsample.host.locks import once
from warpsample.host.options import CastPointKeywords, with_options
from warpsample.host.progress import bar
from warpsample.maths.memory import set_vec3
from warpsample.maths.numerics import scaled_to_unit
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sun.kernel import sun_kernel
from warpsample.radiation.sun.rays import DISC_RAYS
from warpsample.radiation.sun.suns import SunTree
from warpsample.radiation.sun.view import SunsArgs
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.placement import MOST_DISTANCE, PlacementArgs, unit_in_double, vector_in_double
from warpsample.tracing.rays import RAY_WORK

_MOST_DISC = 45.0  # degrees: the pyramid of directions around the disc is still narrow
_MOST_SUNS = 2**24
_FEW_RAYS = 16  # per point: opening the tree around a point takes as long as tracing these rays
_BYTES_PER_POINT = 64  # besides the result


@dataclass(frozen=True, eq=False)
class SunCall:
    """Checked arguments of the call `direct_sun`."""

    at: PlacedPoints
    directions: np.ndarray
    weights: np.ndarray | None
    options: RayOptions
    disc: float = 0.0
    cosine: bool = False

    def answer(self, tally: np.ndarray | None = None) -> np.ndarray:
        """Compute the result of `direct_sun`: a flag, share or weighted sum for each point.

        If `tally` (P, 3) int32 is given, write for each point the number of suns proven lit, of rays blocked by a remembered
        triangle, and of rays cast.
        """
        points, suns = len(self.at), len(self.directions)
        columns = suns if self.weights is None else self.weights[0].size
        shares = self.disc > 0.0 or self._transmits
        kind: Any = np.float64 if self.weights is not None else np.float32 if shares else np.uint8
        needed = points * (columns * np.dtype(kind).itemsize + _BYTES_PER_POINT)
        what = "suns" if self.weights is None else "sums"
        check_memory(needed, f"{columns:,} {what} of {points:,} points", "pass fewer points at a time")
        answer = np.zeros((points, columns), kind)
        if points:
            with bar(self.options.progress, "casting rays to the sun"):
                self._run(answer, tally)
        if self.weights is not None:
            return answer.reshape(points, *self.weights.shape[1:])
        return answer if shares else answer.view(np.bool_)

    @property
    def _transmits(self) -> bool:
        return self.at.mesh.transmits

    def _run(self, answer: np.ndarray, tally: np.ndarray | None) -> None:
        """Run the kernel that tests which suns each point sees, and fill the arrays `answer` and `tally`."""
        at, workers, suns = self.at, self.options.workers, len(self.directions)
        placement = at.two_sided(self.options, MOST_DISTANCE)
        order = at.order(placement, suns, workers)
        placement.order = 0 if order is None else order.ctypes.data
        tree = SunTree.of(_unit(self.directions), self.disc)
        args = self._build_argument(tree, placement)
        args.vertices, args.faces = at.scene.vertices.ctypes.data, at.scene.faces.ctypes.data
        args.normals, args.answer = at.normal.ctypes.data, answer.ctypes.data
        args.tally = 0 if tally is None else tally.ctypes.data
        if self._transmits:
            args.glass = at.scene.glass(workers)
        inputs = [args, self.options.tracer.accelerator(at.scene, cpu(), workers)]
        work = RAY_WORK * len(answer) * suns // 4
        run(sun_kernel(self.disc > 0.0, self._transmits), len(answer), inputs, cpu(), workers=workers, work=work)

    def _build_argument(self, tree: SunTree, placement: PlacementArgs) -> SunsArgs:
        """Return the kernel argument that describes suns, points and weights.

        The addresses of the mesh and of the results are not set yet.
        """
        options, radius = self.options, radians(0.5 * self.disc)
        return SunsArgs(
            placement=placement,
            seed=seed_for("sun", options.seed),
            first_point=options.first_point,
            active=0 if options.active is None else options.active.ctypes.data,
            skip=options.skip and len(self.directions) * (DISC_RAYS if self.disc else 1) > _FEW_RAYS,
            count=len(self.directions),
            nodes=len(tree.spans),
            directions=self.directions.ctypes.data,
            double_directions=self.directions.dtype == np.float64,
            **{name: array.ctypes.data for name, array in vars(tree).items()},
            sine=sin(radius),
            one_minus_cos=2.0 * sin(0.5 * radius) ** 2,
            weights=0 if self.weights is None else self.weights.ctypes.data,
            channels=0 if self.weights is None else self.weights[0].size,
            cosine=self.cosine,
        )


@with_options(CastPointKeywords)
def direct_sun(
    mesh: Any,
    points: SurfacePoints,
    directions: Any,
    *,
    weights: Any = None,
    disc: float = 0.0,
    cosine: bool = False,
    **options: Unpack[CastPointKeywords],
) -> np.ndarray:
    """Compute which sun positions are visible from each point, or a weighted sum over them such as sun hours.

    A point sees a sun in front of it, n.s > 0, if the ray of `trace` towards the sun hits nothing. Most pairs need no
    ray: a sun behind, up to 16 suns whose shaft is empty or covered by one triangle, a triangle that blocked another sun.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts. A Mesh keeps its tree from call to call.
        points: P SurfacePoints, as for `ambient_occlusion`.
        directions: (T, 3) towards the sun, at least one, of any length above 0.
        weights: (T,) or (T, M) finite numbers to sum over the suns in float64, times the lit share, such as 1 for hours or
            the direct normal irradiance in W/m2. Default: None, the array (P, T).
        disc: Angular diameter of the sun in degrees, a float from 0 to 45; 0.533 is the real one. A disc that is neither
            proven lit nor proven dark takes 16 rays: an error of 0.05 (RMS) where an edge passes through the disc, at about
            one of a hundred suns. The part below the point's horizon is dark; a centre below it gives 0. Default: 0.0.
        cosine: Whether to multiply the weights by n.s, for the irradiance on the surface. Default: False.
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        active: (P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        (P, T) bool, whether each point sees each sun. With `disc`, (P, T) float32, the visible fraction of the disc. For a
        mesh with a transmittance, (P, T) float32, the transmitted fraction. With weights, (P,) or (P, M) float64. Points
        without a normal or a finite position get 0.

    Raises:
        TypeError, ValueError: an argument has a wrong type, shape or value.
        MemoryError: the result needs more memory than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> yard = ws.SurfacePoints(position=[[36.0, 36.0, 0.0]], normal=[[0.0, 0.0, 1.0]])
        >>> print(ws.direct_sun(mesh, yard, np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.1], [0.0, 0.0, -1.0]])))
        [[ True False False]]
    """
    at = PlacedPoints.of(mesh, points)
    checked = RayOptions.of(len(at), ids=at.id, tracer="wide", **options)
    towards = _check_directions(directions)
    weights = None if weights is None else _check_weights(weights, len(towards))
    cosine = check_flag(cosine, "cosine")
    if cosine and weights is None:
        raise ValueError("cosine: got True without weights, want weights for the cosine to multiply; or pass cosine=False")
    return SunCall(at, towards, weights, checked, check_number(disc, "disc", 0.0, _MOST_DISC), cosine).answer()


def _check_directions(value: Any) -> np.ndarray:
    """Return `directions` as a contiguous (T, 3) array of float32 or float64.

    Raises:
        TypeError, ValueError: not numbers, another shape, a zero vector, or a number that is not finite.
    """
    array = as_real(value, "directions")
    if array.ndim != 2 or array.shape[1] != 3 or not 1 <= len(array) <= _MOST_SUNS:
        raise ValueError(f"directions: got shape {array.shape}, want (T, 3), T from 1 to {_MOST_SUNS}")
    largest = np.abs(array).max(axis=1)
    wrong = np.flatnonzero(~((largest > 0.0) & np.isfinite(largest)))
    if len(wrong):
        row = wrong[0]
        raise ValueError(f"directions: got {array[row].tolist()} in row {row}, want finite numbers, not all 0")
    return np.ascontiguousarray(array)


def _check_weights(value: Any, suns: int) -> np.ndarray:
    """Return `weights` as a contiguous (T,) or (T, M) float64 array.

    Raises:
        TypeError, ValueError: not numbers, another shape, or a number that is not finite.
    """
    array = as_real(value, "weights")
    if array.ndim not in (1, 2) or len(array) != suns or array.size == 0:
        raise ValueError(f"weights: got shape {array.shape}, want ({suns},) or ({suns}, M), a row for each direction")
    if not np.isfinite(array).all():
        raise ValueError("weights: got NaN or infinity, want finite numbers")
    return np.ascontiguousarray(array, np.float64)


def _unit(directions: np.ndarray) -> np.ndarray:
    """Return directions as (T, 3) float32 unit vectors, with the same rounding as in `trace`."""
    unit = np.empty(directions.shape, np.float32)
    inputs = [directions.ctypes.data, directions.dtype == np.float64, unit.ctypes.data]
    run(_unit_kernel(), len(unit), inputs, cpu(), workers=1, work=len(unit))
    return unit


@once
def _unit_kernel() -> wp.Kernel:
    """Build the kernel that normalises directions, one direction per task."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def to_unit(directions: wp.uint64, doubles: wp.int32, unit: wp.uint64, first_task: wp.int64):
        i = first_task + wp.int64(wp.tid())
        d = wp.vec3(vector_in_double(directions, doubles, i))
        if doubles != 0:
            d = wp.vec3(unit_in_double(vector_in_double(directions, 1, i), 1))
        u = scaled_to_unit(d)
        set_vec3(unit, i, wp.vec3(u[0], u[1], u[2]))

    return to_unit
