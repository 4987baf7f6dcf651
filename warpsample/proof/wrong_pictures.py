"""Wrong samplers of pictures, each with one defect that samplers of environment maps have had."""

import numpy as np

from warpsample.distributions.lights.environment_map import EnvironmentMap
from warpsample.proof.wrong import WrongSampler

_RIGHT = EnvironmentMap.cases()[1]
_HEIGHT, _WIDTH = _RIGHT.picture.shape
_F = np.float32


def _angle_of_pixels() -> np.ndarray:
    """Return the solid angle of a pixel of each row, (H, 1)."""
    theta = np.pi * np.arange(_HEIGHT + 1) / _HEIGHT
    return (np.cos(theta[:-1]) - np.cos(theta[1:]))[:, None] * 2.0 * np.pi / _WIDTH


_BY_PIXEL = EnvironmentMap(_RIGHT.picture / _angle_of_pixels())


def _even_in_angle(u: np.ndarray) -> np.ndarray:
    """Sample wrong directions: within a row, uniform in the angle to +z in place of the solid angle."""
    w = _RIGHT.sample(u).astype(np.float64)
    theta = np.arctan2(np.hypot(w[..., 0], w[..., 1]), w[..., 2])
    row = np.minimum(np.floor(theta * _HEIGHT / np.pi), _HEIGHT - 1)
    edges = np.cos(np.pi * np.arange(_HEIGHT + 1) / _HEIGHT)
    low, high = edges[row.astype(int)], edges[row.astype(int) + 1]
    even = (row + (low - np.cos(theta)) / (low - high)) * np.pi / _HEIGHT
    across = np.sin(even) / np.maximum(np.sin(theta), 1e-12)
    return np.stack([w[..., 0] * across, w[..., 1] * across, np.cos(even)], axis=-1).astype(_F)


def _half_a_pixel_on(u: np.ndarray) -> np.ndarray:
    """Sample wrong directions: the azimuth is off by half a pixel."""
    w, half = _RIGHT.sample(u).astype(np.float64), np.pi / _WIDTH
    turn = np.array([[np.cos(half), -np.sin(half), 0.0], [np.sin(half), np.cos(half), 0.0], [0.0, 0.0, 1.0]])
    return (w @ turn.T).astype(_F)


def _clockwise(u: np.ndarray) -> np.ndarray:
    """Sample wrong directions: columns of the picture advance clockwise in place of counter-clockwise."""
    return _RIGHT.sample(u) * _F([1.0, -1.0, 1.0])


def _shuffled(u: np.ndarray) -> np.ndarray:
    """Sample directions of the right density with shuffled strata, as alias tables do: 16 strips of u[1] change places."""
    moved = u.astype(np.float64)
    moved[..., 1] = (np.floor(moved[..., 1] * 16.0) * 7.0 % 16.0) / 16.0 + moved[..., 1] % (1.0 / 16.0)
    return _RIGHT.sample(moved.astype(_F))


WRONG_PICTURES: dict[str, WrongSampler] = {
    "picture without solid angles": WrongSampler(_RIGHT, sample=_BY_PIXEL.sample, pdf=_BY_PIXEL.pdf),
    "picture even in the angle": WrongSampler(_RIGHT, sample=_even_in_angle),
    "picture half a pixel away": WrongSampler(_RIGHT, sample=_half_a_pixel_on),
    "picture read clockwise": WrongSampler(_RIGHT, sample=_clockwise),
    "picture with shuffled strata": WrongSampler(_RIGHT, sample=_shuffled),
}
"""Wrong samplers, keyed by name."""
