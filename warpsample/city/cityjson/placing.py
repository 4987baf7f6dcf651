"""Random points on the triangles of a city, with enough points per triangle for error bars of means over surfaces."""

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.host.arguments import check_integer
from warpsample.host.engine import check_memory
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import BYTES_PER_POINT
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for

_LEAST = 2  # least number of points per triangle, so that the spread of values is known
_EACH = 4  # default number of points per triangle, on average
_TOTAL = 2048  # default number of points of a mesh with few triangles; fewer miss shadows, and errors are too small


def spread_points(mesh: Mesh, areas: np.ndarray, count: int | None, seed: int) -> SurfacePoints:
    """Sample random points on the triangles of a mesh, in proportion to `areas`, with at least two points on each.

    Args:
        mesh: mesh with F triangles.
        areas: (F,) areas in m2; a triangle with the area 0 gets no points.
        count: approximate total number of points. Default: four times the number of triangles with an area. Fewer
            than 683 triangles get more points: about 2,048 by area, and at least 2,048 / triangles on each.
        seed: seed of the random numbers.

    Raises:
        TypeError, ValueError: `count` is invalid, or all areas are 0.
        MemoryError: the points need more memory than is free.
    """
    placed = find_receiving_faces(areas)
    least = _LEAST
    if count is None:
        faces = np.count_nonzero(placed)
        count, least = max(_EACH * faces, _TOTAL), max(_LEAST, _TOTAL // faces)
    count = check_integer(count, "count", 1, 2**31 - 1)
    each = np.where(placed, np.maximum(np.rint(count * (areas / areas.sum())), least), 0.0).astype(np.int64)
    total = int(each.sum())
    check_memory(3 * BYTES_PER_POINT * total, f"{total:,} surface points", "take fewer")
    face = np.repeat(np.arange(len(each), dtype=np.int32), each)
    u = sample_square("independent", points=total, count=1, seed=seed_for("city", seed))[:, 0].astype(np.float64)
    root = np.sqrt(u[:, :1])
    weights = np.hstack([1.0 - root, root * (1.0 - u[:, 1:]), root * u[:, 1:]])
    corner = mesh.vertices[mesh.faces[face]]
    edges = corner[:, 1:] - corner[:, :1]  # weights apply to edges, not corners, for precision far from the origin
    position = corner[:, 0] + np.einsum("pk,pkj->pj", weights[:, 1:], edges)
    return SurfacePoints(position, mesh.face_normals[face], face)


def find_receiving_faces(areas: np.ndarray) -> np.ndarray:
    """Return which faces have an area above 0, (F,) bool.

    Raises:
        ValueError: all areas, (F,), are 0.
    """
    placed = areas > 0.0
    if not placed.any():
        raise ValueError("mesh: got a city of GroundSurfaces alone, which get no points, want at least one other surface")
    return placed
