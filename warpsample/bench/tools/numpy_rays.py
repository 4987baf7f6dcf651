"""The rays that other tools trace: independent and cosine-weighted, made by NumPy in float32, off the surface."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints

_RAYS_PER_PART = 1 << 18  # 6 MB of directions and origins
_OFF = 1e-5  # of the mesh's size, by which peers move points off their face


def size_of(mesh: Mesh) -> float:
    """The longest side of a mesh's box."""
    return float(np.ptp(mesh.vertices, axis=0).max())


def off_the_surface(mesh: Mesh, position: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """Where peers start their rays, (P, 3) float32."""
    return (position + _OFF * size_of(mesh) * normal).astype(np.float32)


def cosine_directions(u: np.ndarray, n: np.ndarray) -> np.ndarray:
    """Directions (P, count, 3) float32 about normals (P, 3), of points (2, P, count, 1) of the square."""
    across = np.where(np.abs(n[:, :1]) > 0.5, np.float32([[0, 1, 0]]), np.float32([[1, 0, 0]]))
    tangent = np.cross(n, across)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    r, angle = np.sqrt(u[0]), np.float32(2.0 * np.pi) * u[1]
    flat = (r * np.cos(angle)) * tangent[:, None] + (r * np.sin(angle)) * np.cross(n, tangent)[:, None]
    return flat + np.sqrt(1.0 - u[0]) * n[:, None]


def in_parts(size: int, count: int, threads: int, seed: int, work: Callable[[slice, Any], Any]) -> list[Any]:
    """What `work` makes of each part of many points and random numbers of its own, in threads.

    Args:
        size: points.
        count: rays of each; a part has about 2^18 rays.
        threads: at most.
        seed: of all random numbers.
        work: (part, random numbers) -> anything.
    """
    step = max(1, _RAYS_PER_PART // count)
    parts = [slice(start, min(start + step, size)) for start in range(0, size, step)]
    seeds = np.random.SeedSequence(seed).spawn(len(parts))
    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(lambda part, own: work(part, np.random.default_rng(own)), parts, seeds))


def open_share(
    mesh: Mesh, points: SurfacePoints, threads: int, met: Callable[[np.ndarray, np.ndarray], np.ndarray]
) -> Callable[[int], np.ndarray]:
    """What says, of so many rays of each point, other ones at each call, which share (P,) of them meets nothing.

    Args:
        mesh: what the points are on.
        points: where the rays start.
        threads: that make the rays and that trace them.
        met: which of the rays of (R, 3) origins and directions meet something.
    """
    origin, seeds = off_the_surface(mesh, points.position, points.normal), count_from()

    def share(count: int) -> np.ndarray:
        def work(part: slice, rng: np.random.Generator) -> np.ndarray:
            n = points.normal[part]
            directions = cosine_directions(rng.random((2, len(n), count, 1), np.float32), n)
            hit = met(np.repeat(origin[part], count, axis=0), directions.reshape(-1, 3))
            return 1.0 - hit.reshape(len(n), count).mean(axis=1)

        return np.concatenate(in_parts(len(origin), count, threads, next(seeds), work))

    return share
