"""Second implementations of the distributions whose density depends only on the angle to the normal."""

from typing import Any

import numpy as np

from warpsample.proof.twins.angles import BLUR, TAU, by_theta, constant, parameter, polar_angle, spherical


def _cosine(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample cosine-distributed directions of the hemisphere from points u of the unit square."""
    if d.method == "concentric":
        r, turns = _concentric(u)
        return spherical(np.arctan2(r, np.sqrt((1.0 - r) * (1.0 + r))), turns)
    return spherical(np.arctan2(np.sqrt(u[..., 0]), np.sqrt(1.0 - u[..., 0])), u[..., 1])


def _concentric(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (radius, azimuth / 2 pi) of the concentric map of the square to the disk (Shirley1997).

    u is moved to the centre of its cell.
    """
    a = 2.0 * u[..., 0] - 1.0 + 2.0**-24
    b = 2.0 * u[..., 1] - 1.0 + 2.0**-24
    with np.errstate(divide="ignore", invalid="ignore"):
        right, top = (a > -b) & (a > b), (a > -b) & (a <= b)
        left = (a <= -b) & (a < b)
        r = np.select([right, top, left], [a, b, -a], -b)
        turns = np.select([right, top, left], [b / a, 2.0 - a / b, 4.0 + b / a], 6.0 - a / b) / 8.0
    return r, turns


def _disk(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample uniformly distributed points of the unit disk from points u of the unit square."""
    r, turns = _concentric(u) if d.method == "concentric" else (np.sqrt(u[..., 0]), u[..., 1])
    return r[..., None] * np.stack([np.cos(TAU * turns), np.sin(TAU * turns)], axis=-1)


def _cone(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to +z, in radians, of uniform directions in a cone, sampled from u[0]."""
    return 2.0 * np.arcsin(np.sqrt(0.5 * u * parameter(d, "one_minus_cos")))


def _offset_circle(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample directions of the distribution OffsetCircle from points u of the unit square."""
    theta = (u[..., 0] - 0.5) * np.pi
    return np.stack([np.sin(theta), np.cos(theta)], axis=-1)


def _offset_disk(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample directions of the distribution OffsetDisk from points u of the unit square."""
    sine = np.sqrt(u[..., 0]) * np.cos(TAU * u[..., 1])
    return np.stack([sine, np.sqrt((1.0 - sine) * (1.0 + sine))], axis=-1)


def _offset_sphere(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to +z, in radians, of directions of the distribution OffsetSphere, sampled from u[0]."""
    rho, half = parameter(d, "rho"), np.arctan2(np.sqrt(u), np.sqrt(1.0 - u))
    return np.arctan2(rho * np.sin(2.0 * half), (1.0 - rho) + 2.0 * rho * np.cos(half) ** 2)


def _offset_sphere_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the exact density of the distribution OffsetSphere at directions w, per steradian.

    There is one formula for a surface point outside the sphere, and one for a surface point inside.
    """
    rho, theta = parameter(d, "rho"), polar_angle(w)
    if rho < 1.0:
        root = np.sqrt(np.maximum(rho**2 - np.sin(theta) ** 2, BLUR * rho**2))
        return (np.cos(theta) ** 2 + root**2) / (TAU * rho * root)
    root = np.sqrt(rho**2 - np.sin(theta) ** 2)
    return (np.cos(theta) + root) ** 2 / (2.0 * TAU * rho * root)


def _power(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to +z, in radians, of directions of the power cosine lobe, sampled from u[0]."""
    return 2.0 * np.arcsin(np.sqrt(-0.5 * np.expm1(np.log1p(-u) / (parameter(d, "exponent") + 1.0))))


def _power_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the density of the power-cosine lobe, per steradian."""
    n = parameter(d, "exponent")
    return (n + 1.0) / TAU * np.exp(n * np.log1p(-2.0 * np.sin(0.5 * polar_angle(w)) ** 2))


def _von_mises_fisher(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to +z, in radians, of directions of the von Mises-Fisher distribution, sampled from u[0]."""
    kappa = parameter(d, "kappa")
    return 2.0 * np.arcsin(np.sqrt(np.minimum(-np.log1p(u * np.expm1(-2.0 * kappa)) / (2.0 * kappa), 1.0)))


def _von_mises_fisher_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the density of the von Mises-Fisher lobe, per steradian."""
    kappa = parameter(d, "kappa")
    return kappa / (TAU * -np.expm1(-2.0 * kappa)) * np.exp(-2.0 * kappa * np.sin(0.5 * polar_angle(w)) ** 2)


def _henyey_greenstein(d: Any, u: np.ndarray) -> np.ndarray:
    """Return the angle to +z, in radians, of directions of Henyey and Greenstein's phase function, sampled from u[0]."""
    g = parameter(d, "g")
    near, far = (1.0 - g) ** 2 * u * (1.0 + g * (1.0 - u)), (1.0 + g) ** 2 * (1.0 - u) * (1.0 - g * u)
    return 2.0 * np.arctan2(np.sqrt(near), np.sqrt(far))


def _henyey_greenstein_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return Henyey and Greenstein's phase function, per steradian, by the half angle."""
    g, half = parameter(d, "g"), 0.5 * polar_angle(w)
    distance = np.hypot((1.0 - g) * np.cos(half), (1.0 + g) * np.sin(half))
    return (1.0 - g) * (1.0 + g) / (2.0 * TAU * np.float_power(distance, 3))


def _matrix(d: Any) -> np.ndarray:
    """Return the matrix of a linearly transformed cosine, rounded to float32 as in the kernels."""
    return np.array(d.matrix, np.float32).astype(np.float64)


def _linearly_transformed_cosine(d: Any, u: np.ndarray) -> np.ndarray:
    """Sample directions of a linearly transformed cosine from points u of the unit square."""
    theta = np.arctan2(np.sqrt(u[..., 0]), np.sqrt(1.0 - u[..., 0]))
    moved = spherical(theta, u[..., 1]) @ _matrix(d).T
    return moved / np.sqrt(np.square(moved).sum(axis=-1, keepdims=True))


def _linearly_transformed_cosine_density(d: Any, w: np.ndarray) -> np.ndarray:
    """Return the density of a linearly transformed cosine, per steradian (Heitz2016, equation 1)."""
    inverse = np.linalg.inv(_matrix(d))
    back = w @ inverse.T
    length = np.sqrt(np.square(back).sum(axis=-1))
    above = np.maximum(back[..., 2], BLUR / 4.0 * (np.abs(w) @ np.abs(inverse[2])))
    return above / length / np.pi * abs(np.linalg.det(inverse)) / np.float_power(length, 3)


TWINS: dict[str, tuple[Any, Any]] = {
    "cosine_hemisphere": (_cosine, lambda d, w: w[..., 2] / np.pi),
    "henyey_greenstein": (by_theta(_henyey_greenstein), _henyey_greenstein_density),
    "linearly_transformed_cosine": (_linearly_transformed_cosine, _linearly_transformed_cosine_density),
    "offset_ball": (
        by_theta(lambda d, u: np.arccos(np.sqrt(np.sqrt(1.0 - u)))),
        lambda d, w: 2.0 / np.pi * w[..., 2] ** 2 * w[..., 2],
    ),
    "offset_circle": (_offset_circle, constant(1.0 / np.pi)),
    "offset_disk": (_offset_disk, lambda d, w: 2.0 / np.pi * w[..., 1] ** 2),
    "offset_sphere": (by_theta(_offset_sphere), _offset_sphere_density),
    "power_cosine": (by_theta(_power), _power_density),
    "uniform_cone": (by_theta(_cone), lambda d, w: np.full(w.shape[:-1], 1.0 / (TAU * parameter(d, "one_minus_cos")))),
    "uniform_disk": (_disk, constant(1.0 / np.pi)),
    # By the half angle: sin^2(theta / 2) = u / 2 and u.
    "uniform_hemisphere": (by_theta(lambda d, u: 2.0 * np.arcsin(np.sqrt(u / 2.0))), constant(1.0 / TAU)),
    "uniform_sphere": (by_theta(lambda d, u: 2.0 * np.arctan2(np.sqrt(u), np.sqrt(1.0 - u))), constant(0.5 / TAU)),
    "von_mises_fisher": (by_theta(_von_mises_fisher), _von_mises_fisher_density),
}
"""Functions (map, density) of each twin, keyed by the distribution's name."""
