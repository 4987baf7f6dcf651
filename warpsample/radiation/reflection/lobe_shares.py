"""Cosine-weighted rays from points, and the share of them that hits each reflecting patch, as sparse matrices."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.directions.sample import sample_directions
from warpsample.host.locks import imported
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.reflection.patches import Patches
from warpsample.tracing.trace import trace
from warpsample.tracing.trace_all import trace_all

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_BLOCK = 1 << 20  # rays in memory at a time
_NOTHING, _DISTANT = -1, -2  # codes instead of a patch: no light, and light outside the mesh


@dataclass(frozen=True, eq=False)
class Targets:
    """Light sources that rays may reach: N reflecting patches of the mesh, and the light outside the mesh.

    Attributes:
        patches: N patches of faces.
        light_outside: Function from (M, 3) directions of rays that hit nothing to the (M, columns) sparse light from
            outside the mesh; None if this light is not needed.
    """

    patches: Patches
    light_outside: "Callable[[np.ndarray], csr_array] | None" = None


@dataclass(frozen=True, eq=False)
class Shares:
    """Cosine-weighted shares of each light source in the view of each point, as rows of sparse matrices.

    Attributes:
        patches: (P, N) shares of the lobes that patches fill; each ray has a separate entry.
        light_outside: (P, columns) means of the light outside the mesh over the lobes; None if not needed.
    """

    patches: "csr_array"
    light_outside: "csr_array | None"


@dataclass(frozen=True, eq=False)
class LobeRays:
    """Cosine-weighted rays from P points about the points' normals, n from each point.

    Attributes:
        points: The P points.
        directions: (P, n, 3) float32, zero for points without a normal.
    """

    points: SurfacePoints
    directions: np.ndarray

    @property
    def way(self) -> np.ndarray:
        """Directions of all rays as one array, (P n, 3), point by point."""
        return self.directions.reshape(-1, 3)

    def start(self, rays: np.ndarray) -> np.ndarray:
        """Return the (K, 3) start positions of the rays with the given indices."""
        return self.points.position[rays // self.directions.shape[1]]

    def leaving(self, normals: np.ndarray) -> np.ndarray:
        """Return the (P n,) bool mask of the rays that leave the surface.

        The smooth normal of a texel may direct rays behind the face.
        """
        own = np.where((self.points.face >= 0)[:, None], normals[self.points.face], self.points.normal)
        with np.errstate(invalid="ignore"):
            side = np.einsum("pk,pk->p", own, self.points.normal)
            return (np.einsum("pk,pnk->pn", own, self.directions) * side[:, None] > 0.0).ravel()


@dataclass(frozen=True, eq=False)
class RayHits:
    """Table of rays that reach a light source (a patch of the mesh, or the light outside), with the share that arrives.

    Attributes:
        ray: (M,) int64, index of the ray, ascending.
        column: (M,) int32, number of the patch, or _NOTHING or _DISTANT.
        share: (M,) float32, share of the light from there that arrives.
    """

    ray: np.ndarray
    column: np.ndarray
    share: np.ndarray


def trace_shares(targets: Targets, rays: LobeRays, together: int, workers: int | None) -> Shares:
    """Trace cosine-weighted rays and return the share of rays that reaches each light source.

    Shares are means over each `together` consecutive points.
    """
    mesh, csr_array = targets.patches.mesh, imported("scipy.sparse").csr_array
    reflects_and_transmits = mesh.transmits and bool((mesh.transmittance[targets.patches.face] > 0.0).any())
    hits = (_find_hits_along if reflects_and_transmits else _find_first_hits)(targets.patches, rays, workers)
    column = np.where(rays.leaving(mesh.face_normals)[hits.ray], hits.column, _NOTHING)
    size = together * rays.directions.shape[1]
    first = np.arange(0, len(rays.way) + 1, size)

    def rows(chosen: np.ndarray, columns: np.ndarray, width: int) -> "csr_array":
        ends = np.searchsorted(hits.ray[chosen], first)
        content = hits.share[chosen] / float(size), columns, ends.astype(np.int32)
        return csr_array(content, shape=(len(first) - 1, width))

    found = np.flatnonzero(column >= 0)
    between = rows(found, column[found], len(targets.patches))
    if targets.light_outside is None:
        return Shares(between, None)
    away = np.flatnonzero(column == _DISTANT)
    distant = rows(away, np.arange(len(away), dtype=np.int32), len(away))
    return Shares(between, distant @ targets.light_outside(rays.way[hits.ray[away]]))


def _find_first_hits(patches: Patches, rays: LobeRays, workers: int | None) -> RayHits:
    """Trace rays, and return for each the patch of its first opaque hit and the transmitted share of light."""
    hits = trace(patches.mesh, rays.points, rays.directions, workers=workers)
    face, distance = hits.face.ravel(), hits.distance.ravel()
    column = patches.find_hit(face, rays.way, distance, rays.start)
    column[np.isinf(distance)] = _DISTANT
    share = np.ones(len(face), np.float32) if hits.transmitted is None else hits.transmitted.ravel()
    return RayHits(np.arange(len(face)), column, share)


def _find_hits_along(patches: Patches, rays: LobeRays, workers: int | None) -> RayHits:
    """Trace rays through translucent faces, and return all patches along each ray with the share of light left.

    Transmitting faces attenuate the light of faces behind them.
    """
    hits = trace_all(patches.mesh, rays.points, rays.directions, workers=workers)
    number = np.diff(hits.first)
    ray = np.repeat(np.arange(len(number)), number)
    share, left = np.empty(len(ray), np.float32), np.ones(len(number), np.float32)
    for depth in range(number.max(initial=0)):
        at = hits.first[np.flatnonzero(number > depth)] + depth
        share[at] = left[ray[at]]
        left[ray[at]] *= patches.mesh.transmittance[hits.face[at]]
    column = patches.find_hit(hits.face, rays.way[ray], hits.distance, lambda rows: rays.start(ray[rows]))
    last = np.where(rays.way.any(axis=1), _DISTANT, _NOTHING)
    after = hits.first[1:]  # positions for the entries of light behind all faces of a ray
    return RayHits(
        np.insert(ray, after, np.arange(len(number))), np.insert(column, after, last), np.insert(share, after, left)
    )


def trace_lobes(
    targets: Targets,
    points: SurfacePoints,
    count: int,
    *,
    seed: int,
    first_point: int = 0,
    active: np.ndarray | None = None,
    together: int = 1,
    workers: int | None = None,
) -> Iterator[tuple[slice, Shares]]:
    """Cast cosine-weighted rays from points, and yield blocks: (slice of points, share of rays that reaches each source).

    Each point has `count` rays; shares are means over each `together` consecutive points.
    """
    step = max(1, _BLOCK // (count * together)) * together
    for first in range(0, len(points), step):
        rows = slice(first, min(first + step, len(points)))
        some = points.take(rows)
        drawn = {"seed": seed, "first_point": first_point + first if points.id is None else 0, "workers": workers}
        if active is not None:
            drawn["active"] = active[rows].view(np.bool_)
        rays = LobeRays(some, sample_directions(some, count, sequence="fibonacci", **drawn).vectors)
        yield rows, trace_shares(targets, rays, together, workers)
