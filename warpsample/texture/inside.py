"""Points inside of something closed, as a floor has under a wall: their values would bleed into those beside them."""

import numpy as np

from warpsample.directions.sample import sample_directions
from warpsample.host.locks import once_property
from warpsample.host.making import imported
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.trace import trace

_RAYS = 16
_SEED = seed_for("inside", 0)


class Closed:
    """The closed bodies of a mesh: their faces hang together at every edge by two, one in either direction."""

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
        return ~is_open[body[faces[:, 0]]] & ~flat

    def around(self, points: SurfacePoints, workers: int | None = None) -> np.ndarray:
        """(P,) bool: the points more than half of whose rays first meet the back of a closed body."""
        if not self.faces.any():
            return np.zeros(len(points), np.bool_)
        directions = sample_directions(points, _RAYS, seed=_SEED, workers=workers).vectors
        hits = trace(self.mesh, points, directions, workers=workers)
        met = hits.face >= 0
        normals = self.mesh.face_normals[np.where(met, hits.face, 0)]
        behind = met & self.faces[hits.face] & (np.einsum("prk,prk->pr", normals, directions) > 0.0)
        return np.count_nonzero(behind, axis=1) > _RAYS // 2
