"""Second implementations of the distributions of directions towards lights."""

from typing import Any

import numpy as np


def _normalize(v: np.ndarray) -> np.ndarray:
    """Return vectors scaled to unit length."""
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


def _rectangle(d: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return axes of a rectangle as rows, and its two opposite corners in this frame, with its plane at a negative z."""
    corner, edge_x, edge_y = (_values_of(d, name) for name in ("corner", "edge_x", "edge_y"))
    x, y = _normalize(edge_x), _across(edge_y, _normalize(edge_x))
    z = np.cross(x, y)
    axes = np.stack([x, y, -z if corner @ z > 0.0 else z])
    low = axes @ corner
    return axes, low, low + np.array([edge_x @ x, edge_y @ y, 0.0])


def _normals(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return n_z of the planes through the origin and a rectangle's edges, and the angles between planes (Urena2013)."""
    (x0, y0, z0), (x1, y1, _) = low, high
    normals = _normalize(np.array([[0.0, z0, -y0], [-z0, 0.0, x1], [0.0, -z0, y1], [z0, 0.0, -x0]]))
    return normals[:, 2], np.arccos(-(normals * np.roll(normals, -1, axis=0)).sum(axis=1))


def _spherical_rectangle(d: Any, u: np.ndarray) -> np.ndarray:
    """Return directions to a rectangle at u, as printed in Urena2013."""
    axes, low, high = _rectangle(d)
    (x0, y0, z0), (x1, y1, _) = low, high
    (b0, _, b1, _), angles = _normals(low, high)
    turned = u[..., 0] * (angles.sum() - 2.0 * np.pi) + 2.0 * np.pi - angles[2] - angles[3]
    f = (np.cos(turned) * b0 - b1) / np.sin(turned)
    c = np.copysign(1.0, f) / np.sqrt(f**2 + b0**2)
    x = np.clip(-c * z0 / np.sqrt(1.0 - c**2), x0, x1)
    distance = np.hypot(x, z0)
    first, last = y0 / np.hypot(distance, y0), y1 / np.hypot(distance, y1)
    height = first + u[..., 1] * (last - first)
    y = height * distance / np.sqrt(1.0 - height**2)
    return _normalize(np.stack([x, y, np.full_like(x, z0)], axis=-1) @ axes)


def _spherical_rectangle_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return 1 / A with A the excess of the angles of a spherical rectangle (Urena2013)."""
    _, low, high = _rectangle(d)
    return np.full(w.shape[:-1], 1.0 / (_normals(low, high)[1].sum() - 2.0 * np.pi))


TWINS: dict[str, tuple[Any, Any]] = {
    "spherical_rectangle": (_spherical_rectangle, _spherical_rectangle_density),
    "spherical_triangle": (_spherical_triangle, _spherical_triangle_density),
}
"""Functions (map, density) of each twin, keyed by the distribution's name."""
