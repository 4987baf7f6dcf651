"""Light reflected any number of times between faces: radiosity of patches, and reflected irradiance at points.

The radiosity J of patches solves J = rho (E + F J) (Goral1984). The irradiance E and the view factors F come from rays of
the patches, which hit distant light or other patches. A point's reflected irradiance is the mean of J over the patches that
its rays hit: pi times the mean of the radiance J / pi.

All steps are repeated with independent random numbers. The mean is the result. The differences give the standard error,
which contains the error of the patches, common to all points, and the error of the point's own rays.
"""

from collections.abc import Callable, Hashable
from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING, Protocol

import numpy as np

from warpsample.host.engine import check_memory
from warpsample.host.locks import imported, making
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.exchange.radiosity import followed
from warpsample.radiation.reflection.lobe_shares import Targets, trace_lobes
from warpsample.radiation.reflection.patches import Patches
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

if TYPE_CHECKING:
    from scipy.sparse import csr_array

REPLICATES = 8
"""Number of independent runs."""

_FEWER = 16
"""Ratio between the rays of a point and of a patch; a point's rays hit many patches, which averages their errors."""

_FEWEST_RAYS, _FEWEST_PLACES = 1 << 17, 1 << 12  # per run, over all patches
_LEAST_RAYS, _MOST_PLACES = 8, 32  # per patch and run
_TOGETHER = 256  # columns of light that are computed at a time
_MANY = 4  # least number of columns for which summing the rays to the same patch saves time
_BYTES_OF_RAY = 40  # per ray of a patch
_BYTES_OF_POINT = 24  # per column: mean, squares and error; the runs need more
_COLOURS = 3  # most columns for which the numbers of each run are returned


@dataclass(frozen=True, eq=False)
class Probes:
    """Sample positions on the N reflecting patches, and the light from outside the mesh that their rays see.

    Attributes:
        at: P sample positions, P / N on each patch, patch by patch.
        light_outside: (N, columns) means of the light outside the mesh over the patches' lobes.
        options: Options of further rays.
    """

    at: PlacedPoints
    light_outside: "csr_array"
    options: RayOptions

    def means(self, values: np.ndarray, columns: int) -> np.ndarray:
        """Average (P, columns) numbers over the sample positions of each patch; return (N, columns) float64."""
        patches = self.light_outside.shape[0]
        return values.reshape(patches, len(values) // patches, columns).mean(axis=1, dtype=np.float64)


class DistantLight(Protocol):
    """Interface of a distant light source (sky, sun or picture) with T columns: colours or hours.

    Attributes:
        size: Number of columns T.
    """

    size: int

    def targets(self, patches: Patches, workers: int) -> Targets:
        """Return the light sources that rays of the patches may reach: the patches, and this light."""

    def irradiance_of(self, probes: Probes, columns: slice) -> np.ndarray:
        """Return the irradiance of each patch by this light alone, float64, for some of the columns."""


@dataclass(frozen=True, eq=False)
class Reflected:
    """Irradiance at P points by light that the faces of the mesh reflect.

    Attributes:
        value: (P, T) float64, irradiance.
        error: (P, T) float64, standard error of `value`.
        rays: Number of rays per point.
        runs: (P, T, REPLICATES) float32, `value` of each run, for the errors of means over points, which share the light of
            the patches. None for more than three columns.
    """

    value: np.ndarray
    error: np.ndarray
    rays: int
    runs: np.ndarray | None = None


@dataclass(frozen=True, eq=False)
class Reflections:
    """Radiosity of reflecting patches, from several independent runs.

    Attributes:
        patches: N patches.
        leaving: For each run, (N, T) float32, radiosity.
    """

    patches: Patches
    leaving: tuple[np.ndarray, ...]

    def at(self, points: SurfacePoints, count: int, options: RayOptions) -> Reflected:
        """Compute the irradiance at points by the light that the patches reflect.

        Each point casts `count` rays, rounded down to a multiple of the runs. If no ray of a point hits a lit patch, the
        error is the light of one ray from the brightest patch, for patches between the rays.

        Raises:
            MemoryError: the results need more memory than is free.
        """
        count = max(1, count // REPLICATES)
        shape = len(points), self.leaving[0].shape[1]
        has_runs = shape[1] <= _COLOURS
        size = shape[0] * shape[1] * (_BYTES_OF_POINT + (4 * REPLICATES if has_runs else 0))
        check_memory(size, f"the numbers of reflected light at {len(points):,} points", "pass fewer points at a time")
        mean, squares = np.zeros(shape), np.zeros(shape)
        runs = np.zeros((*shape, REPLICATES), np.float32) if has_runs else None
        drawn = {name: getattr(options, name) for name in ("first_point", "active", "workers")}
        for number, leaving in enumerate(self.leaving):
            seed = _derive_seed("lobes", number, options.seed)
            for rows, seen in trace_lobes(Targets(self.patches), points, count, seed=seed, **drawn):
                found = _merge_entries(seen.patches, shape[1]) @ leaving
                if runs is not None:
                    runs[rows, :, number] = found
                apart = found - mean[rows]
                mean[rows] += apart / (number + 1)
                squares[rows] += np.square(apart) * (number / (number + 1))
        error = np.sqrt(squares) / sqrt(REPLICATES * (REPLICATES - 1))
        brightest = np.mean([np.abs(leaving).max(axis=0, initial=0.0) for leaving in self.leaving], axis=0)
        error = np.where((mean == 0.0) & (error == 0.0), brightest / (REPLICATES * count), error)
        return Reflected(mean, error, REPLICATES * count, runs)


def cached_reflections(mesh: Mesh, key: Hashable, find: Callable[[], Reflections]) -> Reflections:
    """Return the reflected light of a mesh from the mesh's cache, or compute it by `find` and cache it under `key`.

    For calls over many parts of the points. Threads with the same mesh wait for the first computation.
    """
    with making:
        known, found = vars(mesh).get("_reflections", (None, None))
        if found is None or known != key:
            found = find()
            object.__setattr__(mesh, "_reflections", (key, found))
        return found


def reflections_of(patches: Patches, distant: DistantLight, count: int, options: RayOptions) -> Reflections:
    """Compute the radiosity of all reflecting patches in distant light, after any number of reflections.

    Raises:
        ValueError: faces that reflect all light and lose none.
        MemoryError: patches and columns need more memory than is free.
    """
    size = len(patches) * (4 * REPLICATES * distant.size + _BYTES_OF_RAY * (count // (_FEWER * REPLICATES)))
    what = f"the light of {len(patches):,} sides or parts of faces in {distant.size:,} columns, by {count:,} rays"
    check_memory(size, what, "pass a shorter period, a smaller count, or a larger refine=")
    runs = []
    for number in range(REPLICATES):
        own = RayOptions.of(0, seed=_derive_seed("reflections", number, options.seed), workers=options.workers)
        runs.append(_compute_radiosity(patches, distant, count, own))
    return Reflections(patches, tuple(runs))


def _derive_seed(purpose: str, number: int, seed: int) -> int:
    """Return a random seed for run number `number` of several independent runs."""
    return seed_for(f"{purpose} {number}", seed)


def _merge_entries(seen: "csr_array", columns: int) -> "csr_array":
    """Merge entries of the same row and column of a sparse matrix if that saves time; return the matrix.

    It saves time if the light has many columns.
    """
    if columns >= _MANY:
        seen.sum_duplicates()
    return seen


def _compute_radiosity(patches: Patches, distant: DistantLight, count: int, options: RayOptions) -> np.ndarray:
    """Compute the radiosity of each reflecting patch, (N, T) float32, from one independent set of rays."""
    number = len(patches)
    if number == 0:
        return np.zeros((0, distant.size), np.float32)
    places = min(-(-_FEWEST_PLACES // number), _MOST_PLACES)
    rays = -(-max(count // (_FEWER * REPLICATES), _FEWEST_RAYS // number, _LEAST_RAYS) // places)
    points, share = patches.places(places, options.seed), patches.reflectance
    how = {"seed": options.seed, "together": places, "workers": options.workers}
    found = [seen for _, seen in trace_lobes(distant.targets(patches, options.workers), points, rays, **how)]
    stacked = imported("scipy.sparse").vstack
    between = _merge_entries(stacked([seen.patches for seen in found], format="csr"), distant.size)
    light_outside = stacked([seen.light_outside for seen in found], format="csr")
    probes = Probes(PlacedPoints.of(patches.mesh, points), light_outside, options)
    leaving = np.empty((number, distant.size), np.float32)
    for first in range(0, distant.size, _TOGETHER):
        columns = slice(first, min(first + _TOGETHER, distant.size))
        leaving[:, columns] = followed(between, share[:, None] * distant.irradiance_of(probes, columns), share)
    return leaving
