"""All view factors of a mesh by each tool."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import count as count_from
from typing import Any, Protocol

import numpy as np

from warpsample.bench.tracers import embree_scene
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.view_factors import view_factors
from warpsample.tracing.trace import trace

_OFF = 1e-5  # of the mesh's size, by which peers move points off their face
_RAYS_PER_PART = 1 << 18


class Tool(Protocol):
    """What computes view factors: `run` with so many rays of each face, then what came of it."""

    def run(self, count: int) -> None:
        """All of them."""

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """(R, F) float64 of the last run: from each of the faces to all."""

    def entries(self) -> int:
        """That are not 0."""


class Ours:
    """`view_factors`."""

    def __init__(self, mesh: Mesh, workers: int, reciprocal: bool = False) -> None:
        """Of a mesh."""
        self.mesh, self.workers, self.reciprocal, self.seeds = mesh, workers, reciprocal, count_from()
        self.last: Any = None

    def run(self, count: int) -> None:
        """Another estimate at each call."""
        self.last = view_factors(self.mesh, count, reciprocal=self.reciprocal, seed=next(self.seeds), workers=self.workers)

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Of the matrix."""
        return self.last.matrix[faces].toarray()

    def told(self, faces: np.ndarray) -> float:
        """The mean square of the standard errors of these rows."""
        return float(np.mean(self.last.standard_error[faces].toarray() ** 2))

    def entries(self) -> int:
        """Of the matrix."""
        return self.last.matrix.nnz


class Embree:
    """Independent places and cosine directions by NumPy, the nearest hit by embreex, counts by `np.bincount`."""

    def __init__(self, mesh: Mesh, workers: int) -> None:
        """Of a mesh."""
        self.scene, self.workers, self.seeds = embree_scene(mesh), workers, count_from()
        self.size, self.normals = len(mesh.faces), rays_of(mesh, np.arange(len(mesh.faces)), 1)[2]
        self.mesh, self.parts, self.count = mesh, [], 0

    def run(self, count: int) -> None:
        """Parts of the faces in threads: embreex releases the interpreter's lock."""
        seeds = np.random.SeedSequence(next(self.seeds))
        step = max(1, _RAYS_PER_PART // count)
        faces = [np.arange(s, min(s + step, self.size)) for s in range(0, self.size, step)]
        with ThreadPoolExecutor(self.workers) as pool:
            self.parts = list(pool.map(lambda f, s: self._counts(f, count, s), faces, seeds.spawn(len(faces))))
        self.count = count

    def _counts(self, faces: np.ndarray, count: int, seed: np.random.SeedSequence) -> tuple[np.ndarray, np.ndarray]:
        origins, directions, _ = rays_of(self.mesh, faces, count, np.random.default_rng(seed))
        hit = np.asarray(self.scene.run(origins, directions, query="INTERSECT"))
        met = np.flatnonzero(hit >= 0)
        met = met[np.einsum("rk,rk->r", directions[met], self.normals[hit[met]]) < 0.0]  # the front of a face
        counts = np.bincount((met // count) * self.size + hit[met], minlength=len(faces) * self.size)
        cells = np.flatnonzero(counts)
        return cells + faces[0] * self.size, counts[cells]

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Of the counts."""
        cells, counts = (np.concatenate(arrays) for arrays in zip(*self.parts, strict=True))
        found = np.zeros((len(faces), self.size))
        row, column = np.divmod(cells, self.size)
        place = np.searchsorted(faces, row).clip(max=len(faces) - 1)
        asked = faces[place] == row
        found[place[asked], column[asked]] = counts[asked] / self.count
        return found

    def entries(self) -> int:
        """Of the counts."""
        return sum(len(cells) for cells, _ in self.parts)


class PyViewFactor:
    """Its matrix by its defaults: each pair of faces by an integral, seen or not by one ray between centroids."""

    def __init__(self, mesh: Mesh, workers: int) -> None:
        """Of a mesh."""
        import numba  # noqa: PLC0415
        import pyviewfactor  # noqa: PLC0415
        from pyvista import PolyData  # noqa: PLC0415

        numba.set_num_threads(min(workers, numba.config.NUMBA_NUM_THREADS))
        self.matrix_of = pyviewfactor.compute_viewfactor_matrix
        self.mesh, self.last = PolyData.from_regular_faces(mesh.vertices, mesh.faces), np.zeros((0, 0))

    def run(self, count: int) -> None:  # noqa: ARG002
        """It knows no rays."""
        self.last = self.matrix_of(self.mesh)

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Of the matrix, whose columns are where the radiation comes from."""
        return self.last[:, faces].T

    def entries(self) -> int:
        """Of the matrix."""
        return int(np.count_nonzero(self.last))


class Trace:
    """`ws.trace` alone, of as many rays from some of the faces, which are made before."""

    def __init__(self, mesh: Mesh, workers: int, faces: np.ndarray, count: int) -> None:
        """Of a mesh, and faces of it."""
        self.mesh, self.workers = mesh, workers
        self.rays = rays_of(mesh, faces, count, np.random.default_rng(0))[:2]

    def run(self, count: int) -> None:  # noqa: ARG002
        """The rays that there are."""
        trace(self.mesh, *self.rays, workers=self.workers)


def rays_of(mesh: Mesh, faces: np.ndarray, count: int, rng: Any = None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Origins and cosine directions (R x count, 3) float32, independent, those of a face together; and normals (R, 3).

    Args:
        mesh: whose faces.
        faces: (R,), which.
        count: rays of each.
        rng: random numbers; without them origins and directions are empty.
    """
    a, b, c = (mesh.vertices[mesh.faces[faces, i]] for i in range(3))
    n = np.cross(b - a, c - a)
    n = (n / np.linalg.norm(n, axis=1, keepdims=True)).astype(np.float32)
    if rng is None:
        return np.zeros((0, 3), np.float32), np.zeros((0, 3), np.float32), n
    lift = _OFF * np.ptp(mesh.vertices, axis=0).max()
    start, first, second = ((array)[:, None].astype(np.float32) for array in (a + lift * n, b - a, c - a))
    tangent = ((b - a) / np.linalg.norm(b - a, axis=1, keepdims=True)).astype(np.float32)
    u, v, r, s = rng.random((4, len(faces), count, 1), np.float32)
    root = np.sqrt(u)
    origins = start + (1.0 - root) * first + (root * v) * second
    radius, angle = np.sqrt(r), np.float32(2.0 * np.pi) * s
    across = (radius * np.cos(angle)) * tangent[:, None] + (radius * np.sin(angle)) * np.cross(n, tangent)[:, None]
    directions = across + np.sqrt(1.0 - r) * n[:, None]
    return origins.reshape(-1, 3), directions.reshape(-1, 3), n


OURS, TRACE, PAIRS = "warpsample", "ws.trace alone", "pyViewFactor"
TOOLS: dict[str, tuple[str, Callable[[Mesh, int], Tool]]] = {
    OURS: ("warpsample", Ours),
    f"{OURS}, reciprocal": ("warpsample", lambda mesh, workers: Ours(mesh, workers, reciprocal=True)),
    "embreex": ("embreex", Embree),
    PAIRS: ("pyviewfactor", PyViewFactor),
}
"""By name: whose version is said, and what makes it of a mesh and threads."""
