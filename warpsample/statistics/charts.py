"""Polar coordinates of the three measures, so that one law serves the sphere, the disk and the plane."""

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np


class Sampler(Protocol):
    """What a law needs of a sampler, correct or not; `warpsample.distributions.record` describes each member."""

    measure: str
    symmetric: bool
    largest_angle: float
    thinnest_tail: float

    def sample(self, u: Any) -> np.ndarray:
        """Directions of points of the square."""

    def pdf(self, w: Any) -> np.ndarray:
        """Density at directions."""

    def cdf(self, theta: Any) -> np.ndarray:
        """Distribution function of the chart's coordinate a."""


@dataclass(frozen=True)
class Chart:
    """Coordinates (a, phi) of w: angle to the normal and azimuth, radius and azimuth, or only a signed angle.

    Attributes:
        low: least value of a.
        high: greatest value of a that the laws consider, inside or outside the support.
        azimuths: 2 pi, or 1 where there is no azimuth.
    """

    low: float
    high: float
    azimuths: float

    def polar(self, w: np.ndarray) -> np.ndarray:
        """The coordinate a, float64; NaN for a NaN."""
        w = w.astype(np.float64)
        if self.azimuths == 1.0:
            return np.arctan2(w[..., 0], w[..., 1])
        radius = np.hypot(w[..., 0], w[..., 1])
        return np.arctan2(radius, w[..., 2]) if w.shape[-1] == 3 else radius

    def azimuth(self, w: np.ndarray) -> np.ndarray:
        """The coordinate phi as a share of `azimuths`, in [0, 1], float64."""
        if self.azimuths == 1.0:
            return np.full(w.shape[:-1], 0.5)
        w = w.astype(np.float64)
        return (np.arctan2(w[..., 1], w[..., 0]) / (2.0 * np.pi)) % 1.0

    def point(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """w at coordinates that are broadcast, float64."""
        a, turns = np.broadcast_arrays(a, turns)
        if self.azimuths == 1.0:
            return np.stack([np.sin(a), np.cos(a)], axis=-1)
        x, y = np.cos(2.0 * np.pi * turns), np.sin(2.0 * np.pi * turns)
        if self is DISK:
            return np.stack([a * x, a * y], axis=-1)
        return np.stack([np.sin(a) * x, np.sin(a) * y, np.cos(a)], axis=-1)

    def element(self, a: np.ndarray) -> np.ndarray:
        """The density of the measure with respect to da dphi, at a."""
        return np.ones_like(a) if self.azimuths == 1.0 else a if self is DISK else np.sin(a)


SPHERE = Chart(0.0, np.pi, 2.0 * np.pi)
DISK = Chart(0.0, 2.0, 2.0 * np.pi)
PLANE = Chart(-np.pi, np.pi, 1.0)
_CHARTS = {"per steradian": SPHERE, "per unit area": DISK, "per radian": PLANE}


def chart_of(sampler: Sampler) -> Chart:
    """The chart for the measure of a sampler's density."""
    return _CHARTS[sampler.measure]


def support_of(sampler: Sampler) -> tuple[float, float]:
    """Least and greatest coordinate a of the support."""
    low = -sampler.largest_angle if chart_of(sampler) is PLANE else 0.0
    return low, sampler.largest_angle
