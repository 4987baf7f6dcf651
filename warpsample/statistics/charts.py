"""Polar coordinates of directions on the sphere, points of the disk, and directions in the plane, for tests of samplers."""

from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np


class Sampler(Protocol):
    """Interface of a sampler of directions under test, which may be wrong on purpose.

    `distributions.record.Distribution` describes each member.
    """

    measure: str
    symmetric: bool
    support: str
    stretch: tuple[tuple[float, ...], ...] | None
    mirror: tuple[float, ...] | None
    largest_angle: float
    thinnest_tail: float
    jumps: tuple[float, ...]

    def sample(self, u: Any) -> np.ndarray:
        """Return the sampled directions of points of the unit square."""

    def pdf(self, w: Any) -> np.ndarray:
        """Return the sampler's probability density at directions."""

    def cdf(self, theta: Any) -> np.ndarray:
        """Return the cumulative distribution function of the angle to the normal."""


@dataclass(frozen=True)
class Chart:
    """Polar coordinates (a, phi) for directions on the sphere, points of the disk, or directions in the plane.

    They are the angle to the normal and the azimuth, the radius and the azimuth, or a signed angle alone.

    Attributes:
        low: smallest value of a.
        high: largest value of a that the laws consider, inside or outside the support.
        azimuths: range of phi: 2 pi, or 1 where there is no azimuth.
        cornered: whether densities may jump or bend where phi is a multiple of an eighth of a turn.
    """

    low: float
    high: float
    azimuths: float
    cornered: bool = field(default=False, kw_only=True)

    def polar(self, w: np.ndarray) -> np.ndarray:
        """Return the polar coordinate a of directions (angle to the normal, or radius), float64; NaN for a NaN."""
        w = w.astype(np.float64)
        if self.azimuths == 1.0:
            return np.arctan2(w[..., 0], w[..., 1])
        radius = np.hypot(w[..., 0], w[..., 1])
        return np.arctan2(radius, w[..., 2]) if w.shape[-1] == 3 else radius

    def azimuth(self, w: np.ndarray) -> np.ndarray:
        """Return the azimuth phi of directions as a fraction of `azimuths`, in [0, 1], float64."""
        if self.azimuths == 1.0:
            return np.full(w.shape[:-1], 0.5)
        w = w.astype(np.float64)
        return (np.arctan2(w[..., 1], w[..., 0]) / (2.0 * np.pi)) % 1.0

    def point(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the directions, float64, at polar coordinates a and azimuths given as a fraction of 2 pi.

        Both arguments are broadcast.
        """
        a, turns = np.broadcast_arrays(a, turns)
        if self.azimuths == 1.0:
            return np.stack([np.sin(a), np.cos(a)], axis=-1)
        x, y = np.cos(2.0 * np.pi * turns), np.sin(2.0 * np.pi * turns)
        if self is DISK:
            return np.stack([a * x, a * y], axis=-1)
        return np.stack([np.sin(a) * x, np.sin(a) * y, np.cos(a)], axis=-1)

    def element(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the solid angle (or area) per da dphi at polar coordinates (a, phi); phi is in units of 2 pi."""
        a, _ = np.broadcast_arrays(a, turns)
        return np.ones_like(a) if self.azimuths == 1.0 else a if self is DISK else np.sin(a)


@dataclass(frozen=True)
class StretchedSphere(Chart):
    """Polar coordinates for distributions that are stretched by a matrix M: angles of o, for directions w along M o.

    Attributes:
        matrix: matrix M, with a determinant other than 0.
    """

    matrix: tuple[tuple[float, ...], ...]

    def polar(self, w: np.ndarray) -> np.ndarray:
        """Return the coordinate a of directions, float64; NaN for a NaN."""
        return super().polar(self._unstretched(w))

    def azimuth(self, w: np.ndarray) -> np.ndarray:
        """Return the coordinate phi of directions as a fraction of 2 pi, in [0, 1], float64."""
        return super().azimuth(self._unstretched(w))

    def point(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the directions, float64, at polar coordinates a and phi, with phi in units of 2 pi."""
        stretched = self._stretched(a, turns)
        return stretched / np.sqrt(np.square(stretched).sum(axis=-1, keepdims=True))

    def element(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the solid angle per da dphi at polar coordinates (a, phi), with phi in units of 2 pi.

        It is that of the sphere, times the stretch of M, abs(det M) / abs(M o)^3.
        """
        length = np.sqrt(np.square(self._stretched(a, turns)).sum(axis=-1))
        return np.sin(a) * abs(float(np.linalg.det(np.array(self.matrix)))) / (length * np.square(length))

    def _stretched(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the stretched vectors M o at polar coordinates a and phi."""
        return super().point(a, turns) @ np.array(self.matrix).T

    def _unstretched(self, w: np.ndarray) -> np.ndarray:
        """Return vectors along o, before stretching by M, for directions w."""
        return w.astype(np.float64) @ np.linalg.inv(np.array(self.matrix)).T


@dataclass(frozen=True)
class Mirror(Chart):
    """Coordinates of the normal m, with z above 0 in its own chart, for the direction w = 2 (v.m) m - v.

    Attributes:
        normals: chart of the normals.
        view: unit vector v.
    """

    normals: Chart
    view: tuple[float, ...]

    def polar(self, w: np.ndarray) -> np.ndarray:
        """Return the coordinate a of the normals of directions, float64; NaN for a NaN."""
        a = self.normals.polar(self._half(w))
        return np.where(a > np.pi / 2.0, np.pi - a, a)

    def azimuth(self, w: np.ndarray) -> np.ndarray:
        """Return the coordinate phi of the normals of directions as a fraction of 2 pi, in [0, 1], float64."""
        half = self._half(w)
        turned = self.normals.polar(half) > np.pi / 2.0
        return self.normals.azimuth(np.where(turned[..., None], -half, half))

    def point(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the directions, float64, for coordinates of normals, phi as a fraction of 2 pi; both are broadcast."""
        m = self.normals.point(a, turns)
        return 2.0 * (m @ np.array(self.view))[..., None] * m - self.view

    def element(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the solid angle of directions per da dphi: that of the normals times 4 abs(v.m)."""
        cosine = self.normals.point(a, turns) @ np.array(self.view)
        return self.normals.element(a, turns) * 4.0 * np.abs(cosine)

    def _half(self, w: np.ndarray) -> np.ndarray:
        """Return vectors along the normals, v + w."""
        return w.astype(np.float64) + self.view


class StretchedSquare(StretchedSphere):
    """Coordinates (a, phi) for directions to a parallelogram: o = (sin a b.x, sin a b.y, cos a), with b on a square's rim.

    The directions are M o / abs(M o).

    The square has the corners (±1, ±1), and b goes round the rim evenly in phi. Up to a = pi/4 lie the directions to the
    parallelogram of the points M (x, y, 1) with x and y from -1 to 1.
    """

    def polar(self, w: np.ndarray) -> np.ndarray:
        """Return the coordinate a of directions, float64; NaN for a NaN."""
        o = self._unstretched(w)
        return np.arctan2(np.abs(o[..., :2]).max(axis=-1), o[..., 2])

    def azimuth(self, w: np.ndarray) -> np.ndarray:
        """Return the coordinate phi of directions as a fraction of 2 pi, in [0, 1], float64."""
        x, y = np.moveaxis(self._unstretched(w)[..., :2], -1, 0)
        upright = np.abs(x) >= np.abs(y)
        longer = np.where(upright, x, y)
        along = np.where(upright, y, -x) / np.where(longer == 0.0, 1.0, longer)
        return (np.where(upright, np.where(x < 0.0, 0.5, 0.0), np.where(y < 0.0, 0.75, 0.25)) + along / 8.0) % 1.0

    def element(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the solid angle per da dphi: sin a, times the rim's length over 2 pi, times abs(det M) / abs(M o)^3."""
        return super().element(a, turns) * 4.0 / np.pi

    def _stretched(self, a: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Return the stretched vectors M o at coordinates (a, phi) on a square's rim."""
        a, turns = np.broadcast_arrays(a, turns)
        rim = [1.0 - np.clip(8.0 * np.abs((turns - start) % 1.0 - 0.5) - 1.0, 0.0, 2.0) for start in (0.5, 0.75)]
        return np.stack([*(np.sin(a) * b for b in rim), np.cos(a)], axis=-1) @ np.array(self.matrix).T


SPHERE = Chart(0.0, np.pi, 2.0 * np.pi)
DISK = Chart(0.0, 2.0, 2.0 * np.pi)
PLANE = Chart(-np.pi, np.pi, 1.0)
_CHARTS = {"per steradian": SPHERE, "per unit area": DISK, "per radian": PLANE}


def chart_of(sampler: Sampler) -> Chart:
    """Return the polar coordinates to test a sampler with: for sphere, disk or plane, stretched or mirrored if necessary."""
    chart = _CHARTS[sampler.measure]
    if sampler.stretch is not None:
        kind = StretchedSquare if sampler.support == "rectangle" else StretchedSphere
        cornered = sampler.support in ("rectangle", "triangle")
        chart = kind(0.0, np.pi, 2.0 * np.pi, sampler.stretch, cornered=cornered)
    return chart if sampler.mirror is None else Mirror(0.0, np.pi / 2.0, 2.0 * np.pi, normals=chart, view=sampler.mirror)


def support_of(sampler: Sampler) -> tuple[float, float]:
    """Return the smallest and the largest polar coordinate a at which a sampler's density can be above 0."""
    low = -sampler.largest_angle if chart_of(sampler) is PLANE else 0.0
    return low, sampler.largest_angle
