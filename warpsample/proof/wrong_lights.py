"""Wrong samplers of directions towards lights, each with one defect that real samplers have had."""

from functools import partial

import numpy as np

from warpsample.distributions.lights.spherical_rectangle import SphericalRectangle
from warpsample.distributions.lights.spherical_triangle import SphericalTriangle
from warpsample.proof.wrong import WrongSampler

_F = np.float32
_TRIANGLE, _SMALL = SphericalTriangle.cases()[1:3]
_TINY = SphericalTriangle(((0.3, 0.0, 1.0), (0.31, 0.02, 1.03), (0.33, -0.01, 1.01)))  # 2.3e-4 sr, seen from the side

_WINDOW, _PANE = SphericalRectangle.cases()[1:3]
_SLIT = SphericalRectangle((0.3, 0.0, 1.0), (0.03, 0.0, 0.03), (0.0, 0.03, 0.0))  # 5e-4 sr, seen from the side


def _normalize(v: np.ndarray) -> np.ndarray:
    """Scale vectors to unit length."""
    return v / np.sqrt(np.square(v).sum(axis=-1, keepdims=True))


def _even_in_area(lobe: SphericalTriangle, u: np.ndarray) -> np.ndarray:
    """Return wrong directions to a triangle: to points that are uniform by area instead of by solid angle."""
    a, b, c = np.array(lobe.corners)
    x, y = u.astype(np.float64).T[..., None]
    side = np.sqrt(y)
    return _normalize((1.0 - side) * b + side * ((1.0 - x) * a + x * c)).astype(_F)


def _angle_of(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the angle at corner a of a spherical triangle, in radians, by the dot product of two normals in float32."""
    cosine = -(_normalize(np.cross(a, b)) @ _normalize(np.cross(c, a)))
    return _F(np.arccos(np.float64(cosine)))


def _by_girard(lobe: SphericalTriangle, w: np.ndarray) -> np.ndarray:
    """Return the density of directions to a triangle with float32 rounding errors, by Girard's formula for its area."""
    a, b, c = _normalize(np.array(lobe.corners, _F))
    area = _angle_of(a, b, c) + _angle_of(b, c, a) + _angle_of(c, a, b) - _F(np.pi)
    return np.where(lobe.pdf(w) > 0.0, 1.0 / area, 0.0).astype(_F)


def _along_arcs(corners: np.ndarray, end: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Return directions on arcs from corner 1 to unit vectors `end`, even in the angle."""
    angle = np.arccos(np.clip(end @ corners[1], -1.0, 1.0))[..., None]
    x = np.sqrt(u[..., 1:])
    return (np.sin((1.0 - x) * angle) * corners[1] + np.sin(x * angle) * end) / np.sin(angle)


def _even_in_angle(lobe: SphericalTriangle, u: np.ndarray) -> np.ndarray:
    """Return directions on the arcs of the right map, at the root of u[1] of each arc, as in a plane."""
    far = np.stack([u[..., 0], np.full_like(u[..., 0], 1.0 - 2.0**-24)], axis=-1)
    end = _normalize(lobe.sample(far).astype(np.float64))
    return _along_arcs(_normalize(np.array(lobe.corners)), end, u.astype(np.float64)).astype(_F)


def _corners_not_unit(lobe: SphericalTriangle, u: np.ndarray) -> np.ndarray:
    """Return directions by Peters' map of corners that were not normalised."""
    a, b, c = np.array(lobe.corners)
    x, y = u.astype(np.float64).T
    volume, along, across = abs(a @ np.cross(b, c)), a @ c + b @ c, 1.0 + a @ b
    half = (x * np.arctan2(volume, along + across))[..., None]
    mirror = (volume * np.cos(half) - along * np.sin(half)) * a + across * np.sin(half) * c
    end = 2.0 * (mirror @ a / np.square(mirror).sum(axis=-1))[..., None] * mirror - a
    z = 1.0 - y * (1.0 - _normalize(end) @ _normalize(b))
    side = _normalize(end - (end @ _normalize(b))[..., None] * _normalize(b))
    return (z[..., None] * _normalize(b) + np.sqrt(1.0 - z * z)[..., None] * side).astype(_F)


def _points_of(lobe: SphericalRectangle, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return directions to points of a rectangle, given as shares of its edges, in float32."""
    corner, edge_x, edge_y = map(np.array, lobe.kernel_values())
    return _normalize(corner + x[..., None] * edge_x + y[..., None] * edge_y).astype(_F)


def _linear_along_y(lobe: SphericalRectangle, u: np.ndarray) -> np.ndarray:
    """Return directions with the right share of edge_x, and an even share of edge_y in place of the sine of an elevation."""
    matrix = np.stack(list(map(np.array, lobe.kernel_values())), axis=1)
    there = lobe.sample(u).astype(np.float64) @ np.linalg.inv(matrix).T
    return _points_of(lobe, there[..., 1] / there[..., 0], u[..., 1].astype(np.float64))


def _by_four_angles(lobe: SphericalRectangle, w: np.ndarray) -> np.ndarray:
    """Return the density of a rectangle with the solid angle as the sum of four angles minus 2 pi, in float32."""
    corner, edge_x, edge_y = (np.array(v, _F) for v in lobe.kernel_values())
    corners = _normalize(np.stack([corner, corner + edge_x, corner + edge_x + edge_y, corner + edge_y]))
    turned = [np.roll(corners, -k, axis=0) for k in (-1, 1)]
    area = sum(_angle_of(a, b, c) for a, b, c in zip(corners, turned[1], turned[0], strict=True)) - _F(2.0 * np.pi)
    return np.where(lobe.pdf(w) > 0.0, 1.0 / area, 0.0).astype(_F)


def _mirrored(lobe: SphericalRectangle, u: np.ndarray) -> np.ndarray:
    """Return directions mirrored at the plane through the eye that is parallel to a rectangle."""
    _, edge_x, edge_y = map(np.array, lobe.kernel_values())
    normal, w = _normalize(np.cross(edge_x, edge_y)), lobe.sample(u).astype(np.float64)
    return (w - 2.0 * (w @ normal)[..., None] * normal).astype(_F)


WRONG_LIGHTS: dict[str, WrongSampler] = {
    "triangle sampled by area": WrongSampler(_TRIANGLE, sample=partial(_even_in_area, _TRIANGLE)),
    "triangle below 3e-4 sr sampled by area": WrongSampler(_TINY, sample=partial(_even_in_area, _TINY)),
    "solid angle of a triangle by Girard": WrongSampler(_SMALL, pdf=partial(_by_girard, _SMALL)),
    "triangle with corners not of unit length": WrongSampler(_TRIANGLE, sample=partial(_corners_not_unit, _TRIANGLE)),
    "rectangle below 1e-3 sr sampled by area": WrongSampler(
        _SLIT, sample=lambda u: _points_of(_SLIT, *u.astype(np.float64).T)
    ),
    "rectangle even along y": WrongSampler(_WINDOW, sample=partial(_linear_along_y, _WINDOW)),
    "solid angle of a rectangle by four angles": WrongSampler(_PANE, pdf=partial(_by_four_angles, _PANE)),
    "rectangle behind the eye": WrongSampler(_WINDOW, sample=partial(_mirrored, _WINDOW)),
    "rectangle with swapped edges": WrongSampler(
        _WINDOW, sample=SphericalRectangle(_WINDOW.corner, _WINDOW.edge_y, _WINDOW.edge_x).sample
    ),
    "triangle even in the angle of its arcs": WrongSampler(_TRIANGLE, sample=partial(_even_in_angle, _TRIANGLE)),
}
"""Wrong samplers, keyed by name."""
