"""What the tests of sky matrices share: the patches by a program of their own, and their integrals by quadrature."""

import numpy as np

ROWS = (30, 30, 24, 24, 18, 12, 6)


def edges(multiple):
    """(lower, upper altitude, first, last azimuth) of each patch in radians, by loops, as reinhart.cal has them."""
    step, found = np.pi / 2 / (7 * multiple + 0.5), []
    for row in range(7 * multiple):
        columns = multiple * ROWS[row // multiple]
        width = 2 * np.pi / columns
        found += [(row * step, (row + 1) * step, (c - 0.5) * width, (c + 0.5) * width) for c in range(columns)]
    return np.array([*found, (7 * multiple * step, np.pi / 2, -np.pi, np.pi)])


def local_directions(patch, across, up):
    """(up * across, 3) directions to the middles of cells of equal solid angle; +x is east, +y north, +z up."""
    low, high, first, last = patch
    azimuth = first + (last - first) * (np.arange(across) + 0.5) / across
    z = np.sin(low) + (np.sin(high) - np.sin(low)) * (np.arange(up) + 0.5) / up
    azimuth, z = (a.ravel() for a in np.meshgrid(azimuth, z))
    along = np.sqrt(1.0 - z**2)
    return np.column_stack([along * np.sin(azimuth), along * np.cos(azimuth), z])


def form_factors(normals, seen=None, multiple=1, cells=200):
    """(N, K) float64, the integrals of max(0, n.w) / pi where `seen` (directions -> bool) says so, by the midpoint rule."""
    normals = np.atleast_2d(np.asarray(normals, np.float64))
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    columns = []
    for patch in edges(multiple):
        wide = 8 if patch[3] - patch[2] > 6.0 else 1
        w = local_directions(patch, wide * cells, cells)
        solid = (patch[3] - patch[2]) * (np.sin(patch[1]) - np.sin(patch[0]))
        cosines = np.maximum(w @ normals.T, 0.0)
        if seen is not None:
            cosines = cosines * seen(w)[:, None]
        columns.append(cosines.mean(axis=0) * solid / np.pi)
    return np.array(columns).T
