"""Tests whether a whole sky patch is visible or blocked, by pyramids of directions around the patch ("shafts")."""

import numpy as np
import warp as wp

from warpsample.host.locks import once
from warpsample.radiation.sky.patches import SkyPatches
from warpsample.tracing.queries import Accelerator, Glass
from warpsample.tracing.sight.cover import covering_triangles
from warpsample.tracing.sight.point import ShadingPoint
from warpsample.tracing.sight.search import EMPTY, OCCUPIED, search_shaft
from warpsample.tracing.sight.shafts import aim_at, shaft_vectors

OPEN, CLOSED, UNKNOWN = 1, 2, 3
"""States of a shaft: empty, filled by one triangle, or neither of the two."""

_INSIDE = wp.constant(wp.float32(2.0**-17))  # margin by which a triangle must cover a shaft: directions are rounded by 2^-20

_SECTORS = {"tregenza": 6, "reinhart2": 12, "reinhart4": 12}
"""Number of sectors of azimuth per row; the number of patches in a row is a multiple of it, except in the last rows."""


def groups_of(patches: SkyPatches) -> np.ndarray:
    """Divide the sky patches into groups of neighbours; return the number of each group's first patch, (G + 1,) int32.

    A group is the patches of one row in one sector of azimuths, so that one shaft contains the group.
    """
    sectors = np.floor((patches.azimuths.mean(axis=1) + 1e-6) * _SECTORS[patches.name] / 360.0)
    changes = (np.diff(patches.rows) != 0) | (np.diff(sectors) != 0)
    return np.array([0, *(np.flatnonzero(changes) + 1), len(patches)], np.int32)


def shafts_of(patches: SkyPatches, starts: np.ndarray) -> np.ndarray:
    """Return the shafts (pyramids of directions) around groups of sky patches, (G, 3, 16) float32.

    The layout is that of `shaft_vectors`. `starts` is as `groups_of` returns. Two planes are at the azimuths, one goes
    through the upper corners, and one touches the lower edge in its middle. The shaft of the cap, the last, is a square
    pyramid.
    """
    low, high = np.radians(patches.altitudes[starts[:-1]]).T
    first, last = np.radians(patches.azimuths[starts[:-1], 0]), np.radians(patches.azimuths[starts[1:] - 1, 1])
    middle, half = 0.5 * (first + last), np.cos(0.5 * (last - first))
    normals, corners = np.zeros((2, len(low), 4, 3))
    normals[:, 0] = np.stack([np.cos(first), -np.sin(first), 0.0 * first], axis=1)
    normals[:, 1] = np.stack([-np.cos(last), np.sin(last), 0.0 * last], axis=1)
    normals[:, 2] = _towards(middle, np.sin(high), -np.cos(high) * half)
    normals[:, 3] = _towards(middle, -np.sin(low), np.cos(low))
    for i, azimuth in enumerate((first, last)):
        corners[:, 2 * i] = _towards(azimuth, np.cos(high), np.sin(high))
        corners[:, 2 * i + 1] = _towards(azimuth, np.cos(low), np.sin(low) * half)
    quarters = 0.5 * np.pi * np.arange(4)
    normals[-1] = _towards(quarters, -np.sin(low[-1]), np.cos(low[-1]))
    aside = np.sqrt(2.0) * np.cos(low[-1])
    corners[-1] = _towards(quarters + 0.25 * np.pi, aside, np.sin(low[-1]))
    return shaft_vectors(normals @ patches.frame, corners @ patches.frame)


def _towards(azimuth: np.ndarray, along: np.ndarray, up: np.ndarray) -> np.ndarray:
    """Return the (K, 3) unit vectors along vectors with a horizontal part `along` at an azimuth and a vertical part `up`."""
    vectors = np.stack(np.broadcast_arrays(along * np.sin(azimuth), along * np.cos(azimuth), up), axis=1)
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


@once
def looker(glass: bool) -> wp.Function:
    """Build the Warp function that decides whether a shaft (pyramid of directions) is empty, blocked or undecided.

    `glass` is for meshes with transmitting faces.
    """

    @wp.func
    def look(tree: Accelerator, among: Glass, point: ShadingPoint, local: wp.int32, vectors: wp.uint64, filled: wp.uint64):
        """Classify a pyramid of directions from a point as OPEN (empty), CLOSED (blocked by one triangle) or UNKNOWN.

        The second value is the address of the leaf with the blocking triangle if it is new, else `filled`: 0, or the address
        of a leaf that blocked another pyramid and is tested, too.
        """
        aim_at(vectors, point)
        found = search_shaft(tree, point, local)
        known = wp.where(found.state == EMPTY, OPEN, UNKNOWN)
        if found.state == OCCUPIED:
            if (covering_triangles(found.leaf, point.shaft, point.o, _INSIDE) & found.triangles) != 0:
                known = CLOSED
                filled = found.leaf
            elif filled != wp.uint64(0) and covering_triangles(filled, point.shaft, point.o, _INSIDE) != 0:
                known = CLOSED
        if wp.static(glass) and known == OPEN:
            known = wp.where(search_shaft(among.tree, point, 0).state == EMPTY, OPEN, UNKNOWN)
        return known, filled

    return look
