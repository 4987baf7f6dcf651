"""Twins of the distributions of microfacet normals: all normals about the mean normal, and normals visible from a view."""

from typing import Any

import numpy as np

from warpsample.proof.twins.angles import BLUR, TAU, by_theta, parameter, polar_angle


def _beckmann(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to the mean normal at u for the Beckmann distribution."""
    return np.arctan(parameter(d, "alpha") * np.sqrt(-np.log1p(-u)))


def _beckmann_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the density of Beckmann normals: D(m) cos theta, with D of Walter2007, equation 25, as printed."""
    theta, alpha = polar_angle(w), parameter(d, "alpha")
    return np.exp(-((np.tan(theta) / alpha) ** 2)) / (np.pi * alpha**2 * np.square(np.cos(theta)) ** 2) * np.cos(theta)


def _ggx(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to the mean normal at u for the GGX distribution."""
    return np.arctan2(parameter(d, "alpha") * np.sqrt(u), np.sqrt(1.0 - u))


def _ggx_normals(alpha: float, w: np.ndarray) -> np.ndarray:
    """Return the GGX distribution D(m) of Walter2007, equation 33, as printed."""
    theta = polar_angle(w)
    return alpha**2 / (np.pi * np.square(np.cos(theta)) ** 2 * (alpha**2 + np.tan(theta) ** 2) ** 2)


def _view_of(d: Any) -> np.ndarray:
    """Return the view direction of a distribution, rounded to float32 as in the kernels."""
    return np.array(d.view, np.float32).astype(np.float64)


def _cosine_to_view(d: Any, m: np.ndarray) -> np.ndarray:
    """Return the cosine between normals m and the view direction, clamped from below as in the kernels."""
    return np.maximum(m @ _view_of(d), BLUR * (np.abs(m) @ np.abs(_view_of(d))))


def _rotate_to_view(d: Any, w: np.ndarray) -> np.ndarray:
    """Rotate vectors about z from a frame whose x axis lies below the view to the local frame."""
    x, y, _ = _view_of(d)
    turn = np.exp(1j * np.arctan2(y, x)) * (w[..., 0] + 1j * w[..., 1])
    return np.stack([turn.real, turn.imag, w[..., 2]], axis=-1)


def _normalize(w: np.ndarray) -> np.ndarray:
    """Scale vectors to unit length."""
    return w / np.sqrt(np.einsum("...i,...i", w, w))[..., None]


def _visible_ggx(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample visible GGX normals by Dupuy2023, listing 3, as printed, except that the azimuth starts at the view."""
    x, y, z = _view_of(d)
    alpha = parameter(d, "alpha")
    view = _normalize(np.array([alpha * np.hypot(x, y), 0.0, z]))
    cap_z = (1.0 - u[..., 0]) * (1.0 + view[2]) - view[2]
    sine = np.sqrt(np.maximum(1.0 - cap_z**2, 0.0))
    cap = np.stack([sine * np.cos(TAU * u[..., 1]), sine * np.sin(TAU * u[..., 1]), cap_z], axis=-1)
    return _rotate_to_view(d, _normalize((cap + view) * (alpha, alpha, 1.0)))


def _visible_ggx_density(d: Any, m: np.ndarray) -> np.ndarray:
    """Return the density of visible GGX normals: G1 D (v.m) / v.z (Heitz2014, equation 3).

    G1 / v.z has a form that stays finite for grazing views.
    """
    x, y, z = _view_of(d)
    alpha = parameter(d, "alpha")
    seen = 2.0 / (z + np.hypot(z, alpha * np.hypot(x, y)))
    return seen * _cosine_to_view(d, m) * _ggx_normals(alpha, m)


def _visible_slope_limit(d: Any) -> tuple[float, float]:
    """Return (a, alpha sin v), where a is the slope in units of alpha at which normals face away from the view.

    The sine of the view's angle v to +z is at least 1e-12.
    """
    x, y, z = _view_of(d)
    across = parameter(d, "alpha") * max(np.hypot(x, y), 1e-12)
    return z / across, across


def _visible_beckmann(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample visible Beckmann normals at u.

    The slope along the view comes from bisection of its distribution function, the slope across it from SciPy's `ndtri`.
    """
    from scipy.special import erfc, ndtri

    a, _ = _visible_slope_limit(d)

    def share_above(x: np.ndarray) -> np.ndarray:
        """Return the visible fraction of slopes above x, up to a constant factor."""
        return a / 2.0 * erfc(x) + np.exp(-x * x) / np.sqrt(4.0 * np.pi)

    low, high = np.full(u.shape[:-1], -min(a, 6.0)), np.full(u.shape[:-1], 6.0)
    target = (1.0 - u[..., 0] - 2.0**-25) * share_above(low)
    for _ in range(36):  # 12 / 2^36 = 2e-10
        middle = 0.5 * (low + high)
        above = share_above(middle) > target
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    aside = ndtri(u[..., 1] + 2.0**-25) / np.sqrt(2.0)
    alpha = parameter(d, "alpha")
    return _rotate_to_view(d, _normalize(np.stack([alpha * low, alpha * aside, np.ones_like(low)], axis=-1)))


def _visible_beckmann_density(d: Any, m: np.ndarray) -> np.ndarray:
    """Return the density of visible Beckmann normals (Heitz2014, equations 2 and 3).

    It is the density of all normals times their visible fraction, divided by the visible area.
    """
    from scipy.special import erf

    a, across = _visible_slope_limit(d)
    area = across * (a * (1.0 + erf(a)) / 2.0 + np.exp(-a * a) / np.sqrt(4.0 * np.pi))
    facing = _cosine_to_view(d, m)
    return _beckmann_density(d, m) / np.cos(polar_angle(m)) * facing / area


TWINS: dict[str, tuple[Any, Any]] = {
    "beckmann": (by_theta(_beckmann), _beckmann_density),
    "ggx": (by_theta(_ggx), lambda d, w: _ggx_normals(parameter(d, "alpha"), w) * np.cos(polar_angle(w))),
    "visible_beckmann": (_visible_beckmann, _visible_beckmann_density),
    "visible_ggx": (_visible_ggx, _visible_ggx_density),
}
"""Functions (map, density) of each twin, keyed by the distribution's name."""
