"""Second, slow implementations in float64, written differently from the kernels: the judges."""

import numpy as np

import warpsample as ws

TAU = 2.0 * np.pi


def spherical(theta, turns):
    """Unit vectors from the angle to +z in radians and the azimuth in turns."""
    return np.stack([np.sin(theta) * np.cos(TAU * turns), np.sin(theta) * np.sin(TAU * turns), np.cos(theta)], axis=-1)


def cosine_polar(u):
    """theta is the angle whose sine is sqrt(u0); near the horizon from its cosine."""
    return spherical(np.arctan2(np.sqrt(u[..., 0]), np.sqrt(1.0 - u[..., 0])), u[..., 1])


def cosine_concentric(u):
    """Shirley and Chiu 1997, by the four triangles of the square, cells centred as in the kernel."""
    a = 2.0 * u[..., 0] - 1.0 + 2.0**-24
    b = 2.0 * u[..., 1] - 1.0 + 2.0**-24
    with np.errstate(divide="ignore", invalid="ignore"):
        right, top = (a > -b) & (a > b), (a > -b) & (a <= b)
        left = (a <= -b) & (a < b)
        r = np.select([right, top, left], [a, b, -a], -b)
        turns = np.select([right, top, left], [b / a, 2.0 - a / b, 4.0 + b / a], 6.0 - a / b) / 8.0
    return spherical(np.arctan2(r, np.sqrt((1.0 - r) * (1.0 + r))), turns)


def uniform_sphere(u):
    """Half angle: sin^2(theta / 2) = u0."""
    return spherical(2.0 * np.arctan2(np.sqrt(u[..., 0]), np.sqrt(1.0 - u[..., 0])), u[..., 1])


def uniform_hemisphere(u):
    """Half angle: sin^2(theta / 2) = u0 / 2."""
    half = u[..., 0] / 2.0
    return spherical(2.0 * np.arctan2(np.sqrt(half), np.sqrt(1.0 - half)), u[..., 1])


def cosine_pdf(w):
    return np.maximum(w[..., 2], 0.0) / np.pi


TWINS = {
    ws.UniformSphere(): (uniform_sphere, lambda w: np.full(w.shape[:-1], 1.0 / (4.0 * np.pi))),
    ws.UniformHemisphere(): (uniform_hemisphere, lambda w: np.full(w.shape[:-1], 1.0 / TAU)),
    ws.CosineHemisphere("polar"): (cosine_polar, cosine_pdf),
    ws.CosineHemisphere("concentric"): (cosine_concentric, cosine_pdf),
    ws.CosineHemisphere("inversion"): (cosine_polar, cosine_pdf),
    ws.CosineHemisphere("offset"): (cosine_polar, cosine_pdf),
}


def pcg4d(x, y, z, w):
    """Jarzynski and Olano 2020, listing 13, on uint32 arrays."""
    v = [np.asarray(a, np.uint32) * np.uint32(1664525) + np.uint32(1013904223) for a in (x, y, z, w)]
    for turn in range(2):
        for k, (i, j) in enumerate([(1, 3), (2, 0), (0, 1), (1, 2)]):
            v[k] = v[k] + v[i] * v[j]
        if turn == 0:
            v = [a ^ (a >> np.uint32(16)) for a in v]
    return v


def frames(n):
    """(N, 3, 3) float64, columns tangent, bitangent, n: Duff et al. 2017."""
    x, y, z = n.T
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    return np.stack(
        [
            np.stack([1.0 + sign * x * x * a, b, x], axis=1),
            np.stack([sign * b, sign + y * y * a, y], axis=1),
            np.stack([-sign * x, -y, z], axis=1),
        ],
        axis=1,
    )
