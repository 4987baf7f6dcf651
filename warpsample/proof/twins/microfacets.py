"""Twins of the normals of rough surfaces: all of them about the normal, and those that a view sees."""

from typing import Any

import numpy as np

from warpsample.proof.twins.angles import BLUR, TAU, by_theta, parameter, polar_angle


def _beckmann(d: Any, u: np.ndarray) -> np.ndarray:
    return np.arctan(parameter(d, "alpha") * np.sqrt(-np.log1p(-u)))


def _beckmann_density(d: Any, w: np.ndarray) -> np.ndarray:
    """D(m) cos theta with D as Walter2007, equation 25, prints it."""
    theta, alpha = polar_angle(w), parameter(d, "alpha")
    return np.exp(-((np.tan(theta) / alpha) ** 2)) / (np.pi * alpha**2 * np.square(np.cos(theta)) ** 2) * np.cos(theta)


def _ggx(d: Any, u: np.ndarray) -> np.ndarray:
    return np.arctan2(parameter(d, "alpha") * np.sqrt(u), np.sqrt(1.0 - u))


def _ggx_normals(alpha: float, w: np.ndarray) -> np.ndarray:
    """D(m) as Walter2007, equation 33, prints it."""
    theta = polar_angle(w)
    return alpha**2 / (np.pi * np.square(np.cos(theta)) ** 2 * (alpha**2 + np.tan(theta) ** 2) ** 2)


def _view(d: Any) -> np.ndarray:
    return np.array(d.view, np.float32).astype(np.float64)


def _facing(d: Any, m: np.ndarray) -> np.ndarray:
    return np.maximum(m @ _view(d), BLUR * (np.abs(m) @ np.abs(_view(d))))


def _turned_to_view(d: Any, w: np.ndarray) -> np.ndarray:
    """From a frame whose x axis lies below the view to the local frame."""
    x, y, _ = _view(d)
    turn = np.exp(1j * np.arctan2(y, x)) * (w[..., 0] + 1j * w[..., 1])
    return np.stack([turn.real, turn.imag, w[..., 2]], axis=-1)


def _unit(w: np.ndarray) -> np.ndarray:
    return w / np.sqrt(np.einsum("...i,...i", w, w))[..., None]


def _visible_ggx(d: Any, u: np.ndarray) -> np.ndarray:
    """Dupuy2023, listing 3, as printed, except that the azimuth starts at the view."""
    x, y, z = _view(d)
    alpha = parameter(d, "alpha")
    view = _unit(np.array([alpha * np.hypot(x, y), 0.0, z]))
    cap_z = (1.0 - u[..., 0]) * (1.0 + view[2]) - view[2]
    sine = np.sqrt(np.maximum(1.0 - cap_z**2, 0.0))
    cap = np.stack([sine * np.cos(TAU * u[..., 1]), sine * np.sin(TAU * u[..., 1]), cap_z], axis=-1)
    return _turned_to_view(d, _unit((cap + view) * (alpha, alpha, 1.0)))


def _visible_ggx_density(d: Any, m: np.ndarray) -> np.ndarray:
    """G1 D (v.m) / v.z of Heitz2014, equation 3, with G1 / v.z in the form that a grazing view keeps finite."""
    x, y, z = _view(d)
    alpha = parameter(d, "alpha")
    seen = 2.0 / (z + np.hypot(z, alpha * np.hypot(x, y)))
    return seen * _facing(d, m) * _ggx_normals(alpha, m)


def _slopes_seen(d: Any) -> tuple[float, float]:
    """(a, alpha sin v): in units of alpha, the slope at which normals face away; the sine is at least 1e-12."""
    x, y, z = _view(d)
    across = parameter(d, "alpha") * max(np.hypot(x, y), 1e-12)
    return z / across, across


def _visible_beckmann(d: Any, u: np.ndarray) -> np.ndarray:
    """Slope along the view by bisection of its distribution function, across it by SciPy's inverse of the normal one."""
    from scipy.special import erfc, ndtri

    a, _ = _slopes_seen(d)

    def share_above(x: np.ndarray) -> np.ndarray:
        """What the view sees of slopes above x."""
        return a / 2.0 * erfc(x) + np.exp(-x * x) / np.sqrt(4.0 * np.pi)

    low, high = np.full(u.shape[:-1], -min(a, 6.0)), np.full(u.shape[:-1], 6.0)
    target = (1.0 - u[..., 0] - 2.0**-25) * share_above(low)
    for _ in range(36):  # 12 / 2^36 = 2e-10
        middle = 0.5 * (low + high)
        above = share_above(middle) > target
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    aside = ndtri(u[..., 1] + 2.0**-25) / np.sqrt(2.0)
    alpha = parameter(d, "alpha")
    return _turned_to_view(d, _unit(np.stack([alpha * low, alpha * aside, np.ones_like(low)], axis=-1)))


def _visible_beckmann_density(d: Any, m: np.ndarray) -> np.ndarray:
    """The density of normals times their visible share, over the visible area: Heitz2014, equations 2 and 3."""
    from scipy.special import erf

    a, across = _slopes_seen(d)
    area = across * (a * (1.0 + erf(a)) / 2.0 + np.exp(-a * a) / np.sqrt(4.0 * np.pi))
    facing = _facing(d, m)
    return _beckmann_density(d, m) / np.cos(polar_angle(m)) * facing / area


TWINS: dict[str, tuple[Any, Any]] = {
    "beckmann": (by_theta(_beckmann), _beckmann_density),
    "ggx": (by_theta(_ggx), lambda d, w: _ggx_normals(parameter(d, "alpha"), w) * np.cos(polar_angle(w))),
    "visible_beckmann": (_visible_beckmann, _visible_beckmann_density),
    "visible_ggx": (_visible_ggx, _visible_ggx_density),
}
"""(map, density) by the name of the distribution."""
