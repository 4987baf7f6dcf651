"""Second implementations of the distributions of microfacet normals, all or only those visible from a view."""

from typing import Any

import numpy as np

from warpsample.proof.twins.angles import BLUR, TAU, parameter, polar_angle


def _roughnesses(d: Any) -> tuple[float, float]:
    """Return the roughnesses along x and y, rounded to float32 as in the kernels."""
    alpha = parameter(d, "alpha")
    return alpha, alpha if getattr(d, "alpha_y", None) is None else parameter(d, "alpha_y")


def _tilted(d: Any, turns: np.ndarray, sine: np.ndarray, cosine: np.ndarray) -> np.ndarray:
    """Return microfacet normals from sine and cosine of their angle, before stretching by the roughnesses, and azimuth."""
    x, y = _roughnesses(d)
    azimuth = TAU * turns
    return _normalize(np.stack([x * sine * np.cos(azimuth), y * sine * np.sin(azimuth), cosine], axis=-1))


def _steepness(d: Any, w: np.ndarray) -> np.ndarray:
    """Return cos^2 phi / alpha_x^2 + sin^2 phi / alpha_y^2 for directions with azimuth phi, a factor of densities."""
    (x, y), azimuth = _roughnesses(d), np.arctan2(w[..., 1], w[..., 0])
    return (np.cos(azimuth) / x) ** 2 + (np.sin(azimuth) / y) ** 2


def _beckmann(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample Beckmann microfacet normals from points u of the unit square."""
    r = np.sqrt(-np.log1p(-u[..., 0]))
    return _tilted(d, u[..., 1], r, np.ones_like(r))


def _beckmann_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the density of Beckmann normals: D(m) cos theta, with D of Walter2007, equation 25, as printed."""
    theta, area = polar_angle(w), np.pi * np.prod(_roughnesses(d))
    return np.exp(-(np.tan(theta) ** 2) * _steepness(d, w)) / (area * np.square(np.cos(theta)) ** 2) * np.cos(theta)


def _ggx(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample GGX microfacet normals from points u of the unit square."""
    return _tilted(d, u[..., 1], np.sqrt(u[..., 0]), np.sqrt(1.0 - u[..., 0]))


def _ggx_normals(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the GGX distribution D(m) of Walter2007, equation 33, with the azimuth of an anisotropic lobe."""
    theta, area = polar_angle(w), np.pi * np.prod(_roughnesses(d))
    return 1.0 / (area * np.square(np.cos(theta)) ** 2 * (1.0 + np.tan(theta) ** 2 * _steepness(d, w)) ** 2)


def _view_of(d: Any) -> np.ndarray:
    """Return the view direction of a distribution, rounded to float32 as in the kernels."""
    return np.array(d.view, np.float32).astype(np.float64)


def _cosine_to_view(d: Any, m: np.ndarray) -> np.ndarray:
    """Return the cosine between normals m and the view direction, clamped from below as in the kernels."""
    return np.maximum(m @ _view_of(d), BLUR * (np.abs(m) @ np.abs(_view_of(d))))


def _rotate_to_view(d: Any, w: np.ndarray) -> np.ndarray:
    """Rotate vectors about the z axis so that the x axis turns to the azimuth of the stretched view direction."""
    (x, y, _), (alpha, alpha_y) = _view_of(d), _roughnesses(d)
    x, y = x * alpha, y * alpha_y
    turn = np.exp(1j * np.arctan2(y, x)) * (w[..., 0] + 1j * w[..., 1])
    return np.stack([turn.real, turn.imag, w[..., 2]], axis=-1)


def _normalize(w: np.ndarray) -> np.ndarray:
    """Return vectors scaled to unit length."""
    return w / np.sqrt(np.einsum("...i,...i", w, w))[..., None]


def _visible_ggx(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample visible GGX normals at u, by Dupuy2023, listing 3, as printed, except that the azimuth starts at the view."""
    (x, y, z), (alpha, alpha_y) = _view_of(d), _roughnesses(d)
    view = _normalize(np.array([np.hypot(alpha * x, alpha_y * y), 0.0, z]))
    cap_z = (1.0 - u[..., 0]) * (1.0 + view[2]) - view[2]
    sine = np.sqrt(np.maximum(1.0 - cap_z**2, 0.0))
    cap = np.stack([sine * np.cos(TAU * u[..., 1]), sine * np.sin(TAU * u[..., 1]), cap_z], axis=-1)
    return _normalize(_rotate_to_view(d, cap + view) * (alpha, alpha_y, 1.0))


def _visible_ggx_density(d: Any, m: np.ndarray) -> np.ndarray:
    """Return the density of visible GGX normals: G1 D (v.m) / v.z (Heitz2014, equation 3).

    G1 / v.z has a form that stays finite for grazing views.
    """
    (x, y, z), (alpha, alpha_y) = _view_of(d), _roughnesses(d)
    seen = 2.0 / (z + np.hypot(z, np.hypot(alpha * x, alpha_y * y)))
    return seen * _cosine_to_view(d, m) * _ggx_normals(d, m)


def _visible_slope_limit(d: Any) -> tuple[float, float]:
    """Return (a, alpha sin v): microfacets with a slope beyond a, in units of alpha, face away from the view.

    alpha sin v is the length of (alpha_x v_x, alpha_y v_y). The sine of the view's angle v to +z is at least 1e-12.
    """
    (x, y, z), (alpha, alpha_y) = _view_of(d), _roughnesses(d)
    across = max(np.hypot(alpha * x, alpha_y * y), 1e-12 * np.sqrt(alpha * alpha_y))
    return z / across, across


def _visible_beckmann(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample visible Beckmann microfacet normals from points u of the unit square.

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
    return _normalize(_rotate_to_view(d, np.stack([low, aside, np.ones_like(low)], axis=-1)) * (*_roughnesses(d), 1.0))


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
    "beckmann": (_beckmann, _beckmann_density),
    "ggx": (_ggx, lambda d, w: _ggx_normals(d, w) * np.cos(polar_angle(w))),
    "visible_beckmann": (_visible_beckmann, _visible_beckmann_density),
    "visible_ggx": (_visible_ggx, _visible_ggx_density),
}
"""Functions (map, density) of each twin, keyed by the distribution's name."""
