"""Points inside of something closed, as a floor has under a wall: their values would bleed into those beside them."""

import numpy as np

from warpsample.directions.sample import sample_directions
from warpsample.host.locks import imported, once_property
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for
from warpsample.texture.charts import charts_of
from warpsample.tracing.trace import trace

_RAYS, _FIRST = 16, 4
_SEED = seed_for("inside", 0)
_LEAST = 0.25  # of a chart's points: a floor that reaches 8 % of its width beyond what stands on it has as much outside


class Closed:
    """The closed bodies of a mesh, turned outward: at every edge their faces meet by two, one in either direction."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh

    @once_property
    def faces(self) -> np.ndarray:
        """(F,) bool: the faces of closed bodies. Vertices at the same place are one."""
        _, vertex = np.unique(self.mesh.vertices + 0.0, axis=0, return_inverse=True)  # + 0.0: -0 is 0
        faces = vertex.reshape(-1)[self.mesh.faces].astype(np.int64)
        flat = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
        start, end = faces[~flat].ravel(), np.roll(faces[~flat], -1, axis=1).ravel()
        count = int(faces.max()) + 1
        along, back = start * count + end, end * count + start
        known, uses = np.unique(along, return_counts=True)
        place = np.minimum(np.searchsorted(known, back), len(known) - 1)
        whole = (known[place] == back) & (uses[place] == 1) & (uses[np.searchsorted(known, along)] == 1)
        sparse = imported("scipy.sparse")
        links = sparse.coo_array((np.ones(len(start), np.bool_), (start, end)), (count, count))
        _, body = imported("scipy.sparse.csgraph").connected_components(links, directed=False)
        is_open = np.zeros(count, np.bool_)
        is_open[body[start[~whole]]] = True
        own = body[faces[:, 0]]
        return ~is_open[own] & ~flat & (self._volumes(own, count)[own] > 0.0)

    def _volumes(self, body: np.ndarray, count: int) -> np.ndarray:
        """Six times the volume of each body, below 0 for those that are inside out."""
        corner = self.mesh.vertices[self.mesh.faces[:, 0]] - self.mesh.bounds.mean(axis=0)
        return np.bincount(body, (corner * self.mesh.cross_products).sum(axis=1), count)

    def around(self, points: SurfacePoints, *, max_distance: float | None = None, workers: int | None = None) -> np.ndarray:
        """(P,) bool: the points more than half of whose rays first meet the back of a closed body, within a distance.

        Where none of the first rays does, the others are not cast.
        """
        inside = np.zeros(len(points), np.bool_)
        if self.faces.any():
            directions = sample_directions(points, _RAYS, seed=_SEED, sequence="sobol", workers=workers).vectors
            first = self._backs(points, directions[:, :_FIRST], max_distance, workers)
            rows = np.flatnonzero(first)
            if len(rows):
                rest = self._backs(points.take(rows), directions[rows, _FIRST:], max_distance, workers)
                inside[rows] = first[rows] + rest > _RAYS // 2
        return inside

    def _backs(
        self, points: SurfacePoints, directions: np.ndarray, max_distance: float | None, workers: int | None
    ) -> np.ndarray:
        """(P,) how many of the rays first meet the back of a closed body."""
        hits = trace(self.mesh, points, np.ascontiguousarray(directions), max_distance=max_distance, workers=workers)
        normals = self.mesh.face_normals[np.maximum(hits.face, 0)]
        behind = self.faces[hits.face] & (hits.face >= 0) & ((normals * directions).sum(axis=2) > 0.0)
        return np.count_nonzero(behind, axis=1)


def fillable(inside: np.ndarray, face: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(P,) bool: those of the points inside of something whose chart has enough others to fill them from.

    Where it has hardly any, it is no floor that something stands on, but in a room: its own numbers are what is wanted.

    Args:
        inside: (P,) bool.
        face: (P,) that the points are on.
        corners: (F, 3, 2) float64, the texture coordinates of all faces.
    """
    if not inside.any():
        return inside
    chart = charts_of(corners)[face]
    return inside & (np.bincount(chart, ~inside) >= _LEAST * np.bincount(chart))[chart]
