"""Terrain around a city: a level plane, a mesh or a raster of heights."""

from typing import Any
from warnings import warn

import numpy as np

from warpsample.city.cityjson.units import Units
from warpsample.host.arguments import quote
from warpsample.host.locks import imported
from warpsample.mesh.mesh import mesh_of

GROUND_PLANE = "ground"
"""Value of `context` for a level plane."""

_FARTHEST = 30_000.0  # metres from the city to terrain; rays start 2e-6 of the whole extent off a wall, 0.06 m for this
_REACH = 20.0  # margin of the plane in city diagonals; a larger one would reduce float32 precision


def append_context(points: np.ndarray, faces: np.ndarray, context: Any, units: Units) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices and faces, in metres, of a city together with the ground or terrain around the city."""
    if context is None:
        return points, faces
    if isinstance(context, str) and context == GROUND_PLANE:
        corners, squares = _make_plane(points[np.unique(faces)])
    elif hasattr(context, "grid") and hasattr(context, "mesh"):  # a RasterSurface; tested without importing its class
        _check_map(context.grid, units)
        if context.canopy_mesh is not None:
            raise ValueError(
                "context: got a surface with tree crowns, which would be opaque or missing around a city; pass "
                "its `canopy_mesh`, with opaque crowns, or its `mesh`, without crowns, both in the unit of the city"
            )
        corners, squares = context.mesh.vertices * context.grid.metres, context.mesh.faces
    else:
        mesh = mesh_of(context, "context", f"{GROUND_PLANE!r}, a RasterSurface, a warpsample.Mesh")
        corners, squares = mesh.vertices * units.metres, mesh.faces
    _check_gap(points[np.unique(faces)], corners)
    return np.concatenate([points, corners]), np.concatenate([faces, squares + len(points)])


def _check_gap(city: np.ndarray, context: np.ndarray) -> None:
    """Raise a ValueError if the surrounding terrain and the city are far apart, as after a mix-up of units or maps."""
    gaps = context.min(axis=0) - city.max(axis=0), city.min(axis=0) - context.max(axis=0)
    distance = float(np.hypot(*np.maximum.reduce([*gaps, np.zeros(3)])[:2]))
    if distance > _FARTHEST:
        raise ValueError(
            f"context: got terrain that is {distance / 1000.0:,.0f} km away from the city, want terrain around it; "
            "check that both have the same reference system and unit"
        )


def _check_map(grid: Any, units: Units) -> None:
    """Raise a ValueError for a raster on another map, or for a raster without a CRS unless the city is in metres."""
    if grid.crs is None:
        if (units.metres != 1.0).any():
            raise ValueError(
                f"context: got a raster without a CRS for a city in {quote(units.name)}, want a raster with a CRS"
            )
    elif units.crs is None:
        message = f"context: got a raster in {grid.crs.name} for a city without a known reference system"
        warn(f"{message}; the city is taken to be in metres on the same map", stacklevel=6)
    else:
        rows, columns = grid.height.shape
        middle = grid.transform @ (columns / 2.0, rows / 2.0)
        if not imported("warpsample.city.rasters.sources.reference").is_same_map(grid.crs, units.crs, *middle):
            raise ValueError(
                f"context: got a raster in {grid.crs.name}, want {units.crs.name}, the map of the city, in any unit; "
                "reproject the raster first, for example with gdalwarp"
            )


def _make_plane(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Build a level square through the city's lowest point, which covers nearly all directions below the horizon."""
    low, high = points.min(axis=0), points.max(axis=0)
    reach = _REACH * np.linalg.norm(high - low)
    ends = np.stack([low - reach, high + reach])
    corners = [(ends[x, 0], ends[y, 1], low[2]) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])
