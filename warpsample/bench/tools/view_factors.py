"""Tools that compute all view factors of a mesh.

A tool has three methods. `run(count)` estimates the factors with `count` rays per face. `rows(faces)` returns the rows
(R, F) float64 of some faces. `due` returns the expected mean square error of these rows, None for a tool without random
numbers.
"""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.numpy_rays import compute_cosine_directions, lift_off_surface, map_parts
from warpsample.bench.tools.tracers import build_embree_scene
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.view_factors import view_factors
from warpsample.tracing.trace import trace


class OurFactors:
    """Benchmark tool that computes the view-factor matrix of a mesh with warpsample; each run has a new seed."""

    def __init__(self, mesh: Mesh, workers: int, reciprocal: bool = False) -> None:
        self.call = partial(view_factors, mesh, reciprocal=reciprocal, workers=workers)
        self.seeds, self.last = count_from(), None

    def run(self, count: int) -> None:
        """Compute the view-factor matrix with a new seed."""
        self.last: Any = self.call(count, seed=next(self.seeds))

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Return the given rows of the view-factor matrix."""
        return self.last.matrix[faces].toarray()

    def due(self, right: np.ndarray, faces: np.ndarray, rays: int) -> float:
        """Return the expected mean square error: the mean square of the rows' standard errors."""
        return float(np.mean(self.last.standard_error[faces].toarray() ** 2))


class EmbreeFactors:
    """View factors of a mesh by independent rays: NumPy generates the rays, embreex finds the nearest hits."""

    def __init__(self, mesh: Mesh, workers: int) -> None:
        self.scene, self.workers, self.seeds = build_embree_scene(mesh), workers, count_from()
        self.mesh, self.size, self.normals = mesh, len(mesh.faces), compute_normals(mesh, np.arange(len(mesh.faces)))
        self.parts: list[Any] = []
        self.count = 0

    def run(self, count: int) -> None:
        """Trace the rays of parts of the faces in threads; embreex releases the interpreter's lock."""

        def counts(part: slice, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
            faces = np.arange(part.start, part.stop)
            origins, directions = sample_rays(self.mesh, faces, count, rng)
            hit = np.asarray(self.scene.run(origins, directions, query="INTERSECT"))
            hits = np.flatnonzero(hit >= 0)
            hits = hits[
                np.einsum("rk,rk->r", directions[hits], self.normals[hit[hits]]) < 0.0
            ]  # keep hits of the front of a face
            counts_of_pairs = np.bincount((hits // count) * self.size + hit[hits], minlength=len(faces) * self.size)
            entries = np.flatnonzero(counts_of_pairs)
            return entries + part.start * self.size, counts_of_pairs[entries]

        self.parts, self.count = map_parts(self.size, count, self.workers, next(self.seeds), counts), count

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Return the given rows of the view-factor matrix: the fraction of each face's rays that hits each face."""
        from scipy.sparse import csr_array

        entries, counts = (np.concatenate(arrays) for arrays in zip(*self.parts, strict=True))
        shares = csr_array((counts / self.count, np.divmod(entries, self.size)), shape=(self.size, self.size))
        return shares[faces].toarray()

    def due(self, right: np.ndarray, faces: np.ndarray, rays: int) -> float:
        """Return the expected mean square error: the variance of independent rays, averaged over the rows."""
        return float(np.mean(right * (1.0 - right))) / rays


class PyViewFactor:
    """View factors of a mesh by pyViewFactor: an integral per pair of faces, and one ray between the centroids."""

    def __init__(self, mesh: Mesh, workers: int) -> None:
        import numba
        import pyviewfactor
        from pyvista import PolyData

        numba.set_num_threads(min(workers, numba.config.NUMBA_NUM_THREADS))
        self.matrix_of = pyviewfactor.compute_viewfactor_matrix
        self.mesh, self.last = PolyData.from_regular_faces(mesh.vertices, mesh.faces), np.zeros((0, 0))

    def run(self, count: int) -> None:
        """Compute the view-factor matrix; `count` is ignored, because pyViewFactor casts no random rays."""
        self.last = self.matrix_of(self.mesh)

    def rows(self, faces: np.ndarray) -> np.ndarray:
        """Return the given rows of the view-factor matrix, which are columns of pyViewFactor's matrix."""
        return self.last[:, faces].T

    def due(self, right: np.ndarray, faces: np.ndarray, rays: int) -> None:
        """Return None in place of an expected error: the method has no random numbers."""


def build_trace_alone(mesh: Mesh, workers: int, faces: np.ndarray, count: int) -> Callable[[], object]:
    """Build a function that only traces `count` rays per face by `ws.trace`, generated beforehand."""
    return partial(trace, mesh, *sample_rays(mesh, faces, count, np.random.default_rng(0)), workers=workers)


def compute_normals(mesh: Mesh, faces: np.ndarray) -> np.ndarray:
    """Compute the unit normals (R, 3) float32 of some faces of a mesh."""
    a, b, c = (mesh.vertices[mesh.faces[faces, i]] for i in range(3))
    n = np.cross(b - a, c - a)
    return (n / np.linalg.norm(n, axis=1, keepdims=True)).astype(np.float32)


def sample_rays(mesh: Mesh, faces: np.ndarray, count: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Sample independent origins and cosine-weighted directions (R x count, 3) float32 on faces of a mesh.

    The rays of a face are consecutive.
    """
    a, b, c = (mesh.vertices[mesh.faces[faces, i]] for i in range(3))
    n = compute_normals(mesh, faces)
    start, first, second = (x[:, None].astype(np.float32) for x in (lift_off_surface(mesh, a, n), b - a, c - a))
    u = rng.random((4, len(faces), count, 1), np.float32)
    root = np.sqrt(u[0])
    origins = start + (1.0 - root) * first + (root * u[1]) * second
    return origins.reshape(-1, 3), compute_cosine_directions(u[2:], n).reshape(-1, 3)


OURS, EMBREE, TRACE, PAIRS = "warpsample", "embreex", "ws.trace alone", "pyViewFactor"
FACTOR_TOOLS = {
    OURS: Tool("warpsample", OurFactors),
    f"{OURS}, reciprocal": Tool("warpsample", partial(OurFactors, reciprocal=True)),
    EMBREE: Tool("embreex", EmbreeFactors),
    PAIRS: Tool("pyviewfactor", PyViewFactor),
}
"""Tools by name, with `make(mesh, threads)`."""
