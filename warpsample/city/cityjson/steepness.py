"""Test whether a city's coordinates are degrees: its buildings or its terrain are then much steeper than any in metres."""

import numpy as np

from warpsample.host.locks import imported
from warpsample.mesh.holes import Outlines

_LARGEST = (180.0, 90.0)  # longitude and latitude
_STEEP = 500.0  # height over the diagonal of the plan: 300 for a single guyed mast, 50,000 for a house in degrees
_LEAST = (1.0, 0.01)  # least heights of bodies and of faces to check; buildings and sloping faces have more
_ROUND = 0.05  # least area of a face's plan over its squared diagonal: plans of walls are lines, or slivers due to rounding


def looks_like_degrees(points: np.ndarray, outlines: Outlines) -> bool:
    """Return True if coordinates can be longitudes and latitudes, and most of the city is too steep for lengths.

    Most connected bodies are, such as buildings, or most sloping faces, such as roofs and terrain. Neither depends on the
    width of the city, and masts and finely divided towers do not decide.

    Args:
        points: (V, 3) vertices.
        outlines: outlines of the faces.
    """
    corners = points[outlines.corners]
    if not len(corners) or (np.abs(corners[:, :2]).max(axis=0) > _LARGEST).any():
        return False
    bodies = _bodies(corners, outlines)
    order = np.argsort(bodies, kind="stable")
    whole = _extents(corners[order], np.bincount(bodies))
    ring = _extents(corners, outlines.sizes[outlines.sizes > 0])
    sloping = ring[_plan_areas(corners, outlines.sizes[outlines.sizes > 0]) > _ROUND * (ring[:, :2] ** 2).sum(axis=1)]
    return any(_mostly_steep(*pair) for pair in zip((whole, sloping), _LEAST, strict=True))


def _mostly_steep(extents: np.ndarray, least: float) -> bool:
    """Return True if most boxes with the extents (N, 3) are steeper than buildings are; only boxes above `least` count."""
    high = extents[extents[:, 2] > least]
    return bool(len(high)) and bool(np.median(high[:, 2] - _STEEP * np.hypot(high[:, 0], high[:, 1])) > 0.0)


def _extents(corners: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return the extents (N, 3) of consecutive groups of corners; no group is empty."""
    starts = np.cumsum(sizes) - sizes
    return np.maximum.reduceat(corners, starts) - np.minimum.reduceat(corners, starts)


def _bodies(corners: np.ndarray, outlines: Outlines) -> np.ndarray:
    """Return the number of the connected body that contains each corner, (C,); faces with a common corner are connected."""
    face = np.repeat(np.repeat(np.arange(len(outlines.rings)), outlines.rings), outlines.sizes)
    place = np.unique(corners, axis=0, return_inverse=True)[1].ravel()
    count = len(outlines.rings) + place.max() + 1
    sparse, graph = imported("scipy.sparse"), imported("scipy.sparse.csgraph")
    links = sparse.coo_array((np.ones(len(face), bool), (face, len(outlines.rings) + place)), shape=(count, count))
    return np.unique(graph.connected_components(links, directed=False)[1][face], return_inverse=True)[1].ravel()


def _plan_areas(corners: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return the areas of rings of corners as seen from above, (N,)."""
    starts = np.cumsum(sizes) - sizes
    following = np.arange(1, len(corners) + 1)
    following[starts + sizes - 1] = starts
    x, y = (corners[:, :2] - np.repeat(corners[starts, :2], sizes, axis=0)).T
    return 0.5 * np.abs(np.add.reduceat(x * y[following] - y * x[following], starts))
