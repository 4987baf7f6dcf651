"""All view factors of a mesh by each tool.

A tool has `run` with so many rays of each face; then `rows` (R, F) float64 of the last run, from some faces to all, and the
mean square error that is `due` where these rows should be `right`, None without chance.
"""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.numpy_rays import cosine_directions, in_parts, off_the_surface
from warpsample.bench.tools.tracers import embree_scene
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.view_factors import view_factors
from warpsample.tracing.trace import trace


class OurFactors:
    """Our own `view_factors`, with one matrix for each run."""

    def __init__(self, mesh: Mesh, workers: int, reciprocal: bool = False) -> None:
        self.call = partial(view_factors, mesh, reciprocal=reciprocal, workers=workers)
        self.seeds, self.last = count_from(), None

    def run(self, count: int) -> None:
        """Makes another estimate at each call."""
        self.last: Any = self.call(count, seed=next(self.seeds))

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Rows of the matrix."""
        return self.last.matrix[faces].toarray()

    def due(self, right: np.ndarray, faces: np.ndarray, rays: int) -> float:
        """The mean square of the standard errors of these rows."""
        return float(np.mean(self.last.standard_error[faces].toarray() ** 2))


class EmbreeFactors:
    """Independent positions and cosine directions by NumPy, the nearest hit by embreex, counts by `np.bincount`."""

    def __init__(self, mesh: Mesh, workers: int) -> None:
        self.scene, self.workers, self.seeds = embree_scene(mesh), workers, count_from()
        self.mesh, self.size, self.normals = mesh, len(mesh.faces), normals_of(mesh, np.arange(len(mesh.faces)))
        self.parts: list[Any] = []
        self.count = 0

    def run(self, count: int) -> None:
        """Parts of the faces in threads: embreex releases the interpreter's lock."""

        def counts(part: slice, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
            faces = np.arange(part.start, part.stop)
            origins, directions = rays_of(self.mesh, faces, count, rng)
            hit = np.asarray(self.scene.run(origins, directions, query="INTERSECT"))
            met = np.flatnonzero(hit >= 0)
            met = met[np.einsum("rk,rk->r", directions[met], self.normals[hit[met]]) < 0.0]  # the front of a face
            found = np.bincount((met // count) * self.size + hit[met], minlength=len(faces) * self.size)
            entries = np.flatnonzero(found)
            return entries + part.start * self.size, found[entries]

        self.parts, self.count = in_parts(self.size, count, self.workers, next(self.seeds), counts), count

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Shares of the rays."""
        from scipy.sparse import csr_array

        entries, counts = (np.concatenate(arrays) for arrays in zip(*self.parts, strict=True))
        shares = csr_array((counts / self.count, np.divmod(entries, self.size)), shape=(self.size, self.size))
        return shares[faces].toarray()

    def due(self, right: np.ndarray, faces: np.ndarray, rays: int) -> float:
        """The variance of independent rays."""
        return float(np.mean(right * (1.0 - right))) / rays


class PyViewFactor:
    """Its matrix by its defaults: each pair of faces by an integral, seen or not by one ray between centroids."""

    def __init__(self, mesh: Mesh, workers: int) -> None:
        import numba
        import pyviewfactor
        from pyvista import PolyData

        numba.set_num_threads(min(workers, numba.config.NUMBA_NUM_THREADS))
        self.matrix_of = pyviewfactor.compute_viewfactor_matrix
        self.mesh, self.last = PolyData.from_regular_faces(mesh.vertices, mesh.faces), np.zeros((0, 0))

    def run(self, count: int) -> None:
        """Computes the matrix; it knows no rays."""
        self.last = self.matrix_of(self.mesh)

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Columns of the matrix, whose columns are where the radiation comes from."""
        return self.last[:, faces].T

    def due(self, right: np.ndarray, faces: np.ndarray, rays: int) -> None:
        """Nothing: there is no chance in it."""


def trace_alone(mesh: Mesh, workers: int, faces: np.ndarray, count: int) -> Callable[[], object]:
    """`ws.trace` alone, of as many rays from some of the faces, which are made before."""
    return partial(trace, mesh, *rays_of(mesh, faces, count, np.random.default_rng(0)), workers=workers)


def normals_of(mesh: Mesh, faces: np.ndarray) -> np.ndarray:
    """The normals (R, 3) float32 of faces of a mesh."""
    a, b, c = (mesh.vertices[mesh.faces[faces, i]] for i in range(3))
    n = np.cross(b - a, c - a)
    return (n / np.linalg.norm(n, axis=1, keepdims=True)).astype(np.float32)


def rays_of(mesh: Mesh, faces: np.ndarray, count: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Origins and cosine directions (R x count, 3) float32 of some faces, independent, those of a face in a row."""
    a, b, c = (mesh.vertices[mesh.faces[faces, i]] for i in range(3))
    n = normals_of(mesh, faces)
    start, first, second = (x[:, None].astype(np.float32) for x in (off_the_surface(mesh, a, n), b - a, c - a))
    u = rng.random((4, len(faces), count, 1), np.float32)
    root = np.sqrt(u[0])
    origins = start + (1.0 - root) * first + (root * u[1]) * second
    return origins.reshape(-1, 3), cosine_directions(u[2:], n).reshape(-1, 3)


OURS, EMBREE, TRACE, PAIRS = "warpsample", "embreex", "ws.trace alone", "pyViewFactor"
FACTOR_TOOLS = {
    OURS: Tool("warpsample", OurFactors),
    f"{OURS}, reciprocal": Tool("warpsample", partial(OurFactors, reciprocal=True)),
    EMBREE: Tool("embreex", EmbreeFactors),
    PAIRS: Tool("pyviewfactor", PyViewFactor),
}
"""By name; each makes a tool of (mesh, threads)."""
