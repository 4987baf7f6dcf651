"""Points that see the whole sky above them, and a day."""

import numpy as np

import warpsample as ws

BEHIND = ws.as_mesh((np.array([[-1.0, -1, -1], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]])))
"""A triangle at the origin: it is behind points that look away from there."""
PARTS = ("direct", "diffuse", "ground")
DAY = ("06-21", "06-21")


def points(normals, distance=5.0):
    """Points that look away from the origin."""
    normals = np.float64(normals)
    return ws.SurfacePoints(distance * np.where(np.isfinite(normals), normals, 0.0), normals)
