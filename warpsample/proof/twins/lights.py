"""Twins of the distributions of directions towards lights."""

from typing import Any

import numpy as np


def _normalize(v: np.ndarray) -> np.ndarray:
    """Scale vectors to unit length."""
    return v / np.sqrt(np.square(v).sum(axis=-1, keepdims=True))


def _across(v: np.ndarray, n: np.ndarray) -> np.ndarray:
    """Return the unit vectors along the components of v perpendicular to the unit vector n."""
    return _normalize(v - (v * n).sum(axis=-1, keepdims=True) * n)


def _values_of(d: Any, name: str) -> np.ndarray:
    """Return a parameter of a distribution in float64, rounded to float32 as in the kernels."""
    return np.array(getattr(d, name), np.float32).astype(np.float64)


def _angles(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the inner angles of a spherical triangle at unit vectors a, b and c, in radians."""
    pairs = [(_across(q, p), _across(r, p)) for p, q, r in ((a, b, c), (b, c, a), (c, a, b))]
    return np.array([np.arctan2(np.sqrt(np.square(np.cross(q, r)).sum()), q @ r) for q, r in pairs])


def _turned(a: np.ndarray, b: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Return the unit vectors at angles (..., 1), in radians, from a unit vector a towards b."""
    return np.cos(angle) * a + np.sin(angle) * _across(b, a)


def _angle_between(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the angles (..., 1) between unit vectors a and b, in radians."""
    return 2.0 * np.arctan2(*(np.sqrt(np.square(v).sum(axis=-1, keepdims=True)) for v in (a - b, a + b)))


def _spherical_triangle(d: Any, u: np.ndarray) -> np.ndarray:
    """Return directions to a triangle at u, by the steps of Arvo1995, with half angles.

    A side b of a spherical triangle of area A follows from the side c and the angle alpha between the two sides:
    tan(b / 2) = sin(A / 2) / (tan(c / 2) sin(alpha - A / 2)).
    """
    a, b, c = _normalize(_values_of(d, "corners"))
    angles = _angles(a, b, c)
    half = 0.5 * u[..., :1] * (angles.sum() - np.pi)
    side = 2.0 * np.arctan2(np.sin(half), np.tan(0.5 * _angle_between(a, b)) * np.sin(angles[0] - half))
    end = _turned(a, c, side)
    return _turned(b, end, 2.0 * np.arcsin(np.sqrt(u[..., 1:]) * np.sin(0.5 * _angle_between(b, end))))


def _spherical_triangle_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return 1 / A with A the excess of the angles of a spherical triangle (Girard)."""
    return np.full(w.shape[:-1], 1.0 / (_angles(*_normalize(_values_of(d, "corners"))).sum() - np.pi))


TWINS: dict[str, tuple[Any, Any]] = {
    "spherical_triangle": (_spherical_triangle, _spherical_triangle_density),
}
"""Functions (map, density) of each twin, keyed by the distribution's name."""
