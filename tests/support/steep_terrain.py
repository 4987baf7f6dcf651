"""Steep rasters of heights, and what their cells see: float64 NumPy, all edges against all azimuths, all faces against rays.

The surface has one height at each place. So the horizon towards an azimuth is the steepest line of sight to the edges there.
"""

import numpy as np

SIDE = 9
AZIMUTHS = (np.arange(720) + 0.5) * (2.0 * np.pi / 720)
"""A cliff whose end falls between two of them moves a mean by up to 1/1440."""

_RISES = {85.0: 11.43, 89.0: 57.29, 89.99: 5729.6}
"""Tangents of slopes in degrees: rises from one cell to the next."""


def steep_heights(name):
    """Heights (9, 9) of cells of 1 m, rough by 0.3 m; `name` is "cliff", "canyon", "spikes" or "steps" and a slope."""
    kind, degrees = name.split()
    rng = np.random.default_rng(7)
    rough, rise = rng.uniform(0.0, 0.3, (SIDE, SIDE)), _RISES[float(degrees)]
    column = np.arange(SIDE)
    if kind == "cliff":
        return rough + rise * (column >= 4)
    if kind == "canyon":
        return rough - rise * ((column >= 3) & (column < 6))
    if kind == "spikes":
        return rough + rise * (rng.random((SIDE, SIDE)) < 0.2)
    return rough + rise * rng.integers(0, 4, (SIDE, SIDE))


def horizons(mesh, position, azimuth=AZIMUTHS):
    """(P, A) slopes of the horizon from (P, 3) points above a mesh towards (A,) azimuths, -inf where nothing is there."""
    corners = np.concatenate([mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]])
    ends = mesh.vertices[np.unique(np.sort(corners, axis=1), axis=0)]
    to = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
    slopes = np.full((len(position), len(azimuth)), -np.inf)
    for point, slope in zip(position, slopes, strict=True):
        start, end = ends[:, 0] - point, ends[:, 1] - point
        off_start, off_end = (to[:, :1] * e[:, 1] - to[:, 1:] * e[:, 0] for e in (start, end))  # (A, E) to the left
        crosses = off_start * off_end < 0.0
        share = off_start / np.where(crosses, off_start - off_end, 1.0)
        ahead = to @ start[:, :2].T + share * (to @ (end - start)[:, :2].T)
        up = start[:, 2] + share * (end - start)[:, 2]
        seen = crosses & (ahead > 1e-9)  # farther than the point is from its own edges' lines, by rounding
        slope[:] = np.where(seen, up / np.where(seen, ahead, 1.0), -np.inf).max(axis=1)
    return slopes


def sky_of(normal, slope):
    """(cosine sky view, visible sky, ambient occlusion), (P,) each, of normals (P, 3) by horizons to AZIMUTHS."""
    n = normal.astype(np.float64)
    along, up = n[:, :1] * np.cos(AZIMUTHS) + n[:, 1:2] * np.sin(AZIMUTHS), n[:, 2:]
    lowest = np.arctan(np.maximum(slope, -along / up))  # nor is anything seen below the receiver's own plane

    def cosines(h):  # 2 / pi times the integral of the receiver's cosine times cos(h), from a height h to the zenith
        return (along * (np.pi / 2 - h - np.sin(h) * np.cos(h)) + up * np.cos(h) ** 2).mean(axis=1)

    visible = 1.0 - np.sin(np.maximum(np.arctan(slope), 0.0)).mean(axis=1)
    return cosines(np.maximum(lowest, 0.0)), visible, cosines(lowest)


def blocked(mesh, position, directions):
    """(P, N) bool: whether rays from (P, 3) points along (N, 3) directions meet a face."""
    a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
    across = np.cross(directions[:, None], c - a)  # (N, F, 3)
    inverse = 1.0 / (across * (b - a)).sum(axis=2)
    met = np.empty((len(position), len(directions)), bool)
    for point, row in zip(position, met, strict=True):
        beside = np.cross(point - a, b - a)
        u = inverse * (across * (point - a)).sum(axis=2)
        v = inverse * (directions @ beside.T)
        t = inverse * (beside * (c - a)).sum(axis=1)
        row[:] = ((u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (t > 0.0)).any(axis=1)
    return met
