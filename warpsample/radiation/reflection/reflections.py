"""All orders of diffuse reflection between faces: what each patch sends back, and what of it points receive.

What a patch sends back is found from what its own rays meet, light from afar and other patches: that makes an equation
each, J = rho (E + F J) (Goral1984). What a point receives by reflection is the mean of J over what its rays meet: pi times
the mean of the radiance J / pi.

All of this is done several times, by other random numbers: the mean is the result, and the differences tell its error, that
of the patches, which all points share, and that of a point's own rays alike.
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
from warpsample.radiation.reflection.lobes_seen import Targets, lobes_seen
from warpsample.radiation.reflection.patches import Patches
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

if TYPE_CHECKING:
    from scipy.sparse import csr_array

REPLICATES = 8
"""Independent runs of all."""

_FEWER = 16
"""By so much fewer are the rays of a patch than those of a point, whose rays meet many patches, and average their errors."""

_FEWEST_RAYS, _FEWEST_PLACES = 1 << 17, 1 << 12  # of all patches of a replicate together
_LEAST_RAYS, _MOST_PLACES = 8, 32  # of a patch and a replicate
_TOGETHER = 256  # columns of light that are followed at a time
_MANY = 4  # columns, from which on it takes less time to add up the rays that meet the same patch first
_BYTES_OF_RAY = 40  # of a patch


@dataclass(frozen=True, eq=False)
class Probes:
    """What finds the light on N patches.

    Attributes:
        at: P places, P / N on each patch, patch by patch.
        beyond: (N, columns), the means of the light beyond the mesh over the patches' lobes.
        options: of further rays.
    """

    at: PlacedPoints
    beyond: "csr_array"
    options: RayOptions

    def means(self, values: np.ndarray, columns: int) -> np.ndarray:
        """(N, columns) float64, the means over patches of (P, columns) numbers of the places."""
        return values.reshape(self.beyond.shape[0], -1, columns).mean(axis=1, dtype=np.float64)


class Afar(Protocol):
    """Light from afar, T columns of it: colours, or hours.

    Attributes:
        size: T.
    """

    size: int

    def targets(self, patches: Patches, workers: int) -> Targets:
        """What rays of patches are sorted by, with so many threads."""

    def falling(self, probes: Probes, columns: slice) -> np.ndarray:
        """(N, some of T) float64, the irradiance of N patches by some columns of the light."""


@dataclass(frozen=True, eq=False)
class Reflected:
    """What P points receive by reflection.

    Attributes:
        value: (P, T) float64, irradiance.
        error: (P, T) float64, its standard error.
        rays: of each point.
    """

    value: np.ndarray
    error: np.ndarray
    rays: int


@dataclass(frozen=True, eq=False)
class Reflections:
    """The light that patches send back, found several times.

    Attributes:
        patches: N of them.
        leaving: of each replicate (N, T) float32, radiosity.
    """

    patches: Patches
    leaving: tuple[np.ndarray, ...]

    def at(self, points: SurfacePoints, count: int, options: RayOptions) -> Reflected:
        """What points receive of it, by `count` rays of each, or a few less."""
        count = max(1, count // REPLICATES)
        shape = len(points), self.leaving[0].shape[1]
        mean, squares = np.zeros(shape), np.zeros(shape)
        drawn = {name: getattr(options, name) for name in ("first_point", "active", "workers")}
        for number, leaving in enumerate(self.leaving):
            seed = _seed("lobes", number, options.seed)
            for rows, seen in lobes_seen(Targets(self.patches), points, count, seed=seed, **drawn):
                apart = _together(seen.patches, shape[1]) @ leaving - mean[rows]
                mean[rows] += apart / (number + 1)
                squares[rows] += np.square(apart) * (number / (number + 1))
        error = np.sqrt(squares) / sqrt(REPLICATES * (REPLICATES - 1))
        return Reflected(mean, error, REPLICATES * count)


def kept_on(mesh: Mesh, key: Hashable, find: Callable[[], Reflections]) -> Reflections:
    """What was found last of a mesh, if it is of that key; else it is found: for calls over many parts of the points.

    Threads that want it at once wait for the first.
    """
    with making:
        known, found = vars(mesh).get("_reflections", (None, None))
        if found is None or known != key:
            found = find()
            object.__setattr__(mesh, "_reflections", (key, found))
        return found


def reflections_of(patches: Patches, afar: Afar, count: int, options: RayOptions) -> Reflections:
    """What patches send back of light from afar, in a call by `count` rays of a point, by the seed and workers of options.

    Raises:
        ValueError: faces that reflect all, and lose nothing.
        MemoryError: more patches and columns than there is memory for.
    """
    size = len(patches) * (4 * REPLICATES * afar.size + _BYTES_OF_RAY * (count // (_FEWER * REPLICATES)))
    what = f"the light of {len(patches):,} sides or parts of faces in {afar.size:,} columns, by {count:,} rays"
    check_memory(size, what, "take a shorter period, fewer rays, or a larger refine=")
    runs = []
    for number in range(REPLICATES):
        own = RayOptions.of(0, seed=_seed("reflections", number, options.seed), workers=options.workers)
        runs.append(_leaving(patches, afar, count, own))
    return Reflections(patches, tuple(runs))


def _seed(purpose: str, number: int, seed: int) -> int:
    return seed_for(f"{purpose} {number}", seed)


def _together(seen: "csr_array", columns: int) -> "csr_array":
    """Shares of which those of the same patch are added up, where that saves time for so many columns of light."""
    if columns >= _MANY:
        seen.sum_duplicates()
    return seen


def _leaving(patches: Patches, afar: Afar, count: int, options: RayOptions) -> np.ndarray:
    """(N, T) float32, what each patch sends back, by one set of random numbers."""
    number = len(patches)
    if number == 0:
        return np.zeros((0, afar.size), np.float32)
    places = min(-(-_FEWEST_PLACES // number), _MOST_PLACES)
    rays = -(-max(count // (_FEWER * REPLICATES), _FEWEST_RAYS // number, _LEAST_RAYS) // places)
    points, share = patches.places(places, options.seed), patches.reflectance
    how = {"seed": options.seed, "together": places, "workers": options.workers}
    found = [seen for _, seen in lobes_seen(afar.targets(patches, options.workers), points, rays, **how)]
    stacked = imported("scipy.sparse").vstack
    between = _together(stacked([seen.patches for seen in found], format="csr"), afar.size)
    beyond = stacked([seen.beyond for seen in found], format="csr")
    probes = Probes(PlacedPoints.of(patches.mesh, points), beyond, options)
    leaving = np.empty((number, afar.size), np.float32)
    for first in range(0, afar.size, _TOGETHER):
        columns = slice(first, min(first + _TOGETHER, afar.size))
        leaving[:, columns] = followed(between, share[:, None] * afar.falling(probes, columns), share)
    return leaving
