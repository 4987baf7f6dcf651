"""Second implementation of the distribution of directions towards a picture: sums, bisection and inverse sines."""

from typing import Any

import numpy as np

from warpsample.proof.twins.angles import TAU, frames, spherical

_ROUNDING = 3e-7  # angle in radians that draws keep from the edges of their pixel, and from a pole in columns
_OF_POLAR_ROW = 0.02


def steps_of(weights: np.ndarray, steps: int) -> np.ndarray:
    """Return cumulative whole steps of each weight: one for a weight above 0, and the rest of all steps by weight."""
    lit = np.cumsum(weights > 0.0)
    sums = np.cumsum(weights / max(weights.max(), 1e-300))
    ends = lit + np.rint(sums / max(sums[-1], 1e-300) * (steps - lit[-1])) * (lit[-1] > 0)
    return np.concatenate([[0.0], ends])


def shares_of(picture: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the cumulative shares of rows, (H + 1,), and of the pixels of each row, (H, W + 1)."""
    height, width = picture.shape
    light, theta = picture.astype(np.float64), np.pi * np.arange(height + 1) / height
    rows = steps_of(light.sum(axis=1) * (np.cos(theta[:-1]) - np.cos(theta[1:])) * TAU / width, 2**48)
    return rows / 2.0**48, np.array([steps_of(line, 2**32 - 1) for line in light]) / (2.0**32 - 1.0)


def _finalised(word: np.ndarray) -> np.ndarray:
    """Mix 32-bit words, stored as uint64, with the finaliser fmix32 of Appleby2016."""
    word = (word ^ (word >> 16)) * 0x85EBCA6B & 0xFFFFFFFF
    word = (word ^ (word >> 13)) * 0xC2B2AE35 & 0xFFFFFFFF
    return word ^ (word >> 16)


def _widened(u: np.ndarray) -> np.ndarray:
    """Return u with further bits from a hash of the upper 24 bits of both coordinates."""
    first, second = (np.floor(u[..., k] * 2.0**24).astype(np.uint64) for k in (0, 1))
    word = _finalised(first ^ _finalised(second + 0x9E3779B9 & 0xFFFFFFFF))
    return u + np.stack([word, _finalised(word + second & 0xFFFFFFFF)], axis=-1) * 2.0**-56


def _axes(d: Any) -> np.ndarray:
    """Return the axes of the picture's frame in rows."""
    up = np.array(d.up)
    if d.north is None:
        return frames(up[None])[0].T
    x = np.cross(d.north, up)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(up, x), up])


def directions_of_picture(d: Any, u: np.ndarray) -> np.ndarray:
    """Return directions towards the picture of an `EnvironmentMap` at u, in world coordinates."""
    rows, columns = shares_of(d.picture)
    (height, width), x = d.picture.shape, _widened(u)
    row = np.searchsorted(rows, x[..., 0], side="right") - 1
    step = x[..., 1] * (2.0**32 - 1.0)
    column = np.empty(row.shape, np.int64)
    for r in np.unique(row):
        here = row == r
        column[here] = np.searchsorted(np.rint(columns[r] * (2.0**32 - 1.0)), np.floor(step[here]), side="right") - 1
    edges = np.square(np.sin(0.5 * np.pi * np.arange(height + 1) / height))
    low, high, sine = edges[row], edges[row + 1], np.sin(np.pi * np.arange(height + 1) / height)
    margin = 0.5 * _ROUNDING * np.maximum(sine[row], sine[row + 1]) / (high - low)
    pole = np.sin(0.5 * min(_ROUNDING * width / np.pi, _OF_POLAR_ROW * np.pi / height)) ** 2 / edges[1]
    margin = np.minimum(np.where((row == 0) | (row == height - 1), np.maximum(margin, pole), margin), 0.5)
    down = np.clip((x[..., 0] - rows[row]) / (rows[row + 1] - rows[row]), margin, 1.0 - margin)
    start, end = columns[row, column] * (2.0**32 - 1.0), columns[row, column + 1] * (2.0**32 - 1.0)
    theta = 2.0 * np.arcsin(np.sqrt(low + (high - low) * down))
    margin = np.minimum(_ROUNDING * width / TAU / np.sin(theta), 0.5)
    across = np.clip((step - start) / (end - start), margin, 1.0 - margin)
    return spherical(theta, (column + across) / width) @ _axes(d)


def density_of_picture(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the density at world directions w: the share of the pixel there, divided by the pixel's solid angle."""
    rows, columns = shares_of(d.picture)
    (height, width), o = d.picture.shape, w @ _axes(d).T
    theta = np.arctan2(np.hypot(o[..., 0], o[..., 1]), o[..., 2])
    row = np.minimum((theta * (height / np.pi)).astype(np.int64), height - 1)
    turns = np.arctan2(o[..., 1], o[..., 0]) / TAU % 1.0
    column = np.minimum((turns * width).astype(np.int64), width - 1)
    edges = np.pi * np.arange(height + 1) / height
    angle = (np.cos(edges[row]) - np.cos(edges[row + 1])) * TAU / width
    return (rows[row + 1] - rows[row]) * (columns[row, column + 1] - columns[row, column]) / angle


TWINS: dict[str, tuple[Any, Any]] = {"environment_map": (directions_of_picture, density_of_picture)}
"""Functions (map, density) of each twin, keyed by the distribution's name."""
