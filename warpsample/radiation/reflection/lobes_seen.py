"""What the rays of points meet: shares of their lobes, patch by patch, as rows of a sparse matrix."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from warpsample.directions.sample import sample_directions
from warpsample.host.making import imported
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.reflection.patches import Patches
from warpsample.tracing.trace import trace
from warpsample.tracing.trace_all import trace_all

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_BLOCK = 1 << 20  # rays that stand at a time


@dataclass(frozen=True, eq=False)
class Targets:
    """What light comes from: N patches, and what is beyond the mesh.

    Attributes:
        patches: the N patches.
        beyond: (M, 3) directions that meet nothing -> (M,) int64, in which of `columns` each counts, -1 for none.
        columns: how many there are of these.
    """

    patches: Patches
    beyond: Callable[[np.ndarray], np.ndarray] | None = None
    columns: int = 0

    def met_beyond(self, directions: np.ndarray) -> np.ndarray:
        """(M,) int64, the columns of directions that meet nothing, counted on from the patches."""
        if self.beyond is None:
            return np.full(len(directions), -1)
        found = self.beyond(directions)
        return np.where(found < 0, -1, len(self.patches) + found)


@dataclass(frozen=True, eq=False)
class LobeRays:
    """n rays from each of P points, about their normals.

    Attributes:
        points: the points.
        directions: (P, n, 3) float32, zero where a point has none.
    """

    points: SurfacePoints
    directions: np.ndarray

    @property
    def way(self) -> np.ndarray:
        """(P n, 3), the directions ray by ray."""
        return self.directions.reshape(-1, 3)

    @cached_property
    def start(self) -> np.ndarray:
        """(P n, 3), where they start."""
        return np.repeat(self.points.position, self.directions.shape[1], axis=0)

    def leaving(self, normals: np.ndarray) -> np.ndarray:
        """(P n,) bool: not those that leave a point behind its own face, as they may about the smooth normal of a texel."""
        own = np.where((self.points.face >= 0)[:, None], normals[self.points.face], self.points.normal)
        with np.errstate(invalid="ignore"):
            side = np.einsum("pk,pk->p", own, self.points.normal)
            return (np.einsum("pk,pnk->pn", own, self.directions) * side[:, None] > 0.0).ravel()


@dataclass(frozen=True, eq=False)
class Met:
    """What some rays meet, ray by ray.

    Attributes:
        ray: (M,) int64, ascending.
        column: (M,) int64, of the targets; -1 for what sends nothing.
        share: (M,) float32, of the light from there that arrives.
    """

    ray: np.ndarray
    column: np.ndarray
    share: np.ndarray


def shares_seen(targets: Targets, rays: LobeRays, together: int, workers: int | None) -> "csr_array":
    """(P / together, N + columns) float64, the shares of lobes that come from each target, in the mean of so many points.

    A ray has an entry of its own.
    """
    mesh = targets.patches.mesh
    reflects_and_transmits = mesh.transmits and bool((mesh.transmittance[targets.patches.face] > 0.0).any())
    met = (_met_along if reflects_and_transmits else _met_first)(targets, rays, workers)
    kept = (met.column >= 0) & rays.leaving(mesh.face_normals)[met.ray]
    total, size = len(rays.way), together * rays.directions.shape[1]
    ends = np.searchsorted(met.ray[kept], np.arange(0, total + 1, size))
    content = met.share[kept] / float(size), met.column[kept].astype(np.int32), ends.astype(np.int32)
    shape = total // size, len(targets.patches) + targets.columns
    return imported("scipy.sparse").csr_array(content, shape=shape)


def _met_first(targets: Targets, rays: LobeRays, workers: int | None) -> Met:
    """What the rays meet first that is opaque."""
    hits = trace(targets.patches.mesh, rays.points, rays.directions, workers=workers)
    face, distance = hits.face.ravel(), hits.distance.ravel()
    column = targets.patches.met(face, rays.way, distance, rays.start)
    missed = np.flatnonzero(np.isinf(distance))
    column[missed] = targets.met_beyond(rays.way[missed])
    share = np.ones(len(face), np.float32) if hits.transmitted is None else hits.transmitted.ravel()
    return Met(np.arange(len(face)), column, share)


def _met_along(targets: Targets, rays: LobeRays, workers: int | None) -> Met:
    """All that the rays meet, up to where nothing is left: what a face sends goes through those before it."""
    hits = trace_all(targets.patches.mesh, rays.points, rays.directions, workers=workers)
    number = np.diff(hits.first)
    ray = np.repeat(np.arange(len(number)), number)
    share, left = np.empty(len(ray), np.float32), np.ones(len(number), np.float32)
    for depth in range(number.max(initial=0)):
        at = hits.first[np.flatnonzero(number > depth)] + depth
        share[at] = left[ray[at]]
        left[ray[at]] *= targets.patches.mesh.transmittance[hits.face[at]]
    column = targets.patches.met(hits.face, rays.way[ray], hits.distance, rays.start[ray])
    last = np.where(rays.way.any(axis=1), targets.met_beyond(rays.way), -1)
    after = hits.first[1:]  # where what is behind all faces of a ray is put in
    return Met(np.insert(ray, after, np.arange(len(number))), np.insert(column, after, last), np.insert(share, after, left))


def lobes_seen(
    targets: Targets,
    points: SurfacePoints,
    count: int,
    *,
    seed: int,
    first_point: int = 0,
    active: np.ndarray | None = None,
    together: int = 1,
    workers: int | None = None,
) -> Iterator[tuple[slice, "csr_array"]]:
    """(points, their rows) block by block: what `count` rays of each see, in the mean of `together` points."""
    step = max(1, _BLOCK // (count * together)) * together
    for first in range(0, len(points), step):
        rows = slice(first, min(first + step, len(points)))
        some = points.take(rows)
        drawn = {"seed": seed, "first_point": first_point + first if points.id is None else 0, "workers": workers}
        if active is not None:
            drawn["active"] = active[rows].view(np.bool_)
        rays = LobeRays(some, sample_directions(some, count, sequence="fibonacci", **drawn).vectors)
        yield rows, shares_seen(targets, rays, together, workers)
