"""Random points on the triangles of a city, so many on each that a mean over any surface has an error bar."""

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.host.arguments import check_integer
from warpsample.host.engine import check_memory
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import BYTES_PER_POINT
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for

_LEAST = 2  # points of a triangle: from two on their values tell how they vary
_EACH = 4  # points of a triangle, on average, if no number is given


def spread_points(mesh: Mesh, areas: np.ndarray, count: int | None, seed: int) -> SurfacePoints:
    """Points on the triangles that have an area, (F,): about `count` shared out by it, but at least two on each.

    Raises:
        TypeError, ValueError: a count that is none; no triangle has an area.
        MemoryError: more than is free.
    """
    placed = areas > 0.0
    if not placed.any():
        raise ValueError("mesh: got a city whose surfaces have no area, want at least one that has")
    count = _EACH * np.count_nonzero(placed) if count is None else check_integer(count, "count", 1, 2**31 - 1)
    each = np.where(placed, np.maximum(np.rint(count * (areas / areas.sum())), _LEAST), 0.0).astype(np.int64)
    total = int(each.sum())
    check_memory(3 * BYTES_PER_POINT * total, f"{total:,} surface points", "take fewer")
    face = np.repeat(np.arange(len(each), dtype=np.int32), each)
    u = sample_square("independent", points=total, count=1, seed=seed_for("city", seed))[:, 0].astype(np.float64)
    root = np.sqrt(u[:, :1])
    weights = np.hstack([1.0 - root, root * (1.0 - u[:, 1:]), root * u[:, 1:]])
    corner = mesh.vertices[mesh.faces[face]]
    edges = corner[:, 1:] - corner[:, :1]  # far from the origin only they are weighted
    position = corner[:, 0] + np.einsum("pk,pkj->pj", weights[:, 1:], edges)
    return SurfacePoints(position, mesh.face_normals[face], face)
