"""What stands around a city: a plane of ground, or a mesh beside it."""

from typing import Any

import numpy as np

from warpsample.mesh.mesh import mesh_of

GROUND_PLANE = "ground"

_REACH = 20.0  # of the plane beyond the city, in its diagonals; scenes keep their digits for what is not so far


def with_context(points: np.ndarray, faces: np.ndarray, context: Any) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a city with those of a context after them; None is none."""
    if context is None:
        return points, faces
    if isinstance(context, str) and context == GROUND_PLANE:
        corners, squares = _plane(points[np.unique(faces)])
    else:
        mesh = mesh_of(context, "context", f"{GROUND_PLANE!r}, a warpsample.Mesh")
        corners, squares = mesh.vertices, mesh.faces
    return np.concatenate([points, corners]), np.concatenate([faces, squares + len(points)])


def _plane(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A level square through the lowest point, so large that a wall sees hardly anything but it below the horizon."""
    low, high = points.min(axis=0), points.max(axis=0)
    reach = _REACH * np.linalg.norm(high - low)
    ends = np.stack([low - reach, high + reach])
    corners = [(ends[x, 0], ends[y, 1], low[2]) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])
