"""Functions that the second implementations share: angles, unit vectors, frames, and parameters rounded to float32."""

from collections.abc import Callable
from typing import Any

import numpy as np

TAU = 2.0 * np.pi
BLUR = 2.0**-21
"""Relative width in which the kernels clamp an edge or blur a horizon."""


def spherical(theta: np.ndarray, turns: np.ndarray) -> np.ndarray:
    """Convert angles to +z, in radians, and azimuths, as fractions of 2 pi, to unit vectors."""
    sine, azimuth = np.sin(theta), TAU * turns
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), np.cos(theta)], axis=-1)


def polar_angle(w: np.ndarray) -> np.ndarray:
    """Return the angle between vectors w and +z, in radians."""
    return np.arctan2(np.sqrt(w[..., 0] ** 2 + w[..., 1] ** 2), w[..., 2])


def frames(n: np.ndarray) -> np.ndarray:
    """Build the frames about unit normals, (N, 3, 3) float64 with columns tangent, bitangent, normal (Duff2017)."""
    x, y, z = n.T
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    return np.stack(
        [
            np.stack([1.0 + sign * x * x * a, b, x], axis=1),
            np.stack([sign * b, sign + y * y * a, y], axis=1),
            np.stack([-sign * x, -y, z], axis=1),
        ],
        axis=1,
    )


def parameter(distribution: Any, name: str) -> float:
    """Return a parameter of a distribution rounded to float32, as the kernels use it."""
    return float(np.float32(getattr(distribution, name)))


def by_theta(theta: Callable[[Any, np.ndarray], np.ndarray]) -> Callable[[Any, np.ndarray], np.ndarray]:
    """Build a map to directions from a function (distribution, u[0]) that returns the angle to +z in radians.

    The azimuth is 2 pi u[1].
    """
    return lambda d, u: spherical(theta(d, u[..., 0]), u[..., 1])


def constant(value: float) -> Callable[[Any, np.ndarray], np.ndarray]:
    """Return a density function that has the same value in all directions."""
    return lambda d, w: np.full(w.shape[:-1], value)
