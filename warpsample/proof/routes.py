"""Other methods from the literature to sample the package's distributions, in float64 NumPy, to compare with.

Chizhov2019 samples each offset set in two ways: a uniform point of the set plus the normal, normalised; and by inversion or
rejection. These methods are compared with the package's maps, and with each other.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.microfacets.beckmann import Beckmann
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.microfacets.visible_beckmann import VisibleBeckmann
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.distributions.offset_ball import OffsetBall
from warpsample.distributions.offset_circle import OffsetCircle
from warpsample.distributions.offset_disk import OffsetDisk
from warpsample.distributions.offset_sphere import OffsetSphere
from warpsample.distributions.power_cosine import PowerCosine
from warpsample.distributions.record import Distribution
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein
from warpsample.distributions.uniform_cone import UniformCone
from warpsample.distributions.uniform_disk import UniformDisk
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.proof import laws
from warpsample.proof.evidence import Evidence, Subject
from warpsample.proof.twins import polar_angle, spherical
from warpsample.proof.verify import Verdict
from warpsample.statistics.charts import chart_of

_DRAWS = 1 << 18
_TURN = 2.0 * np.pi


def circle(turns: np.ndarray) -> np.ndarray:
    """Sample points of the unit circle from one random number each (Chizhov2019, section 3.4).

    The source prints two different variates in sine and cosine.
    """
    return np.stack([np.sin(_TURN * turns), np.cos(_TURN * turns)], axis=-1)


def disk(u: np.ndarray) -> np.ndarray:
    """Sample points of the unit disk by inversion (Chizhov2019, section 3.2)."""
    return np.sqrt(u[..., 1:2]) * circle(u[..., 0])


def sphere(u: np.ndarray) -> np.ndarray:
    """Sample points of the unit sphere by inversion."""
    z = 1.0 - 2.0 * u[..., 0:1]
    return np.concatenate([np.sqrt(1.0 - z * z) * circle(u[..., 1]), z], axis=-1)


def ball(u: np.ndarray) -> np.ndarray:
    """Sample points of the unit ball by inversion of the radius' distribution function r^3; u has three coordinates."""
    return np.cbrt(u[..., 2:3]) * sphere(u[..., :2])


def points_in_ball(u: np.ndarray) -> np.ndarray:
    """Sample points of the unit ball, or disk, by rejection: scale u to [-1, 1]^k and keep the points inside."""
    points = 2.0 * u - 1.0
    return points[(points * points).sum(axis=-1) < 1.0]


def normalize(v: np.ndarray) -> np.ndarray:
    """Return vectors scaled to unit length."""
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def mirrored_sphere(u: np.ndarray) -> np.ndarray:
    """Sample points of the unit hemisphere by mirroring the lower half of the sphere."""
    points = sphere(u)
    points[..., 2] = np.abs(points[..., 2])
    return points


def add_normal(points: np.ndarray) -> np.ndarray:
    """Add the normal (the unit vector of the last axis) to points, and normalise the sums to directions."""
    return normalize(points + np.eye(points.shape[-1])[-1])


def disk_by_inverted_distribution(u: np.ndarray) -> np.ndarray:
    """Sample directions of the offset disk by numerical inversion of (theta + sin theta cos theta) / pi + 1/2 = u[0].

    Source: Chizhov2019, section 3.2.
    """
    low, high = np.full(u.shape[:-1], -np.pi / 2.0), np.full(u.shape[:-1], np.pi / 2.0)
    for _ in range(52):
        middle = 0.5 * (low + high)
        below = (middle + np.sin(middle) * np.cos(middle)) / np.pi + 0.5 < u[..., 0]
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return np.stack([np.sin(low), np.cos(low)], axis=-1)


def variates(dimensions: int) -> np.ndarray:
    """Return (N, dimensions) independent uniform random numbers, float64, at centres of cells of width 2^-24."""
    u = sample_square("independent", _DRAWS // 16, 16 * ((dimensions + 1) // 2), seed=7)
    return u.reshape(-1, 2 * ((dimensions + 1) // 2))[:, :dimensions].astype(np.float64) + 2.0**-25


@dataclass(frozen=True)
class Route:
    """Method from the literature to sample one of the package's distributions in another way.

    Attributes:
        name: name in tables.
        to: distribution.
        draw: function from independent variates to directions.
        dimensions: number of variates per direction.
    """

    name: str
    to: Distribution
    draw: Callable[[np.ndarray], np.ndarray]
    dimensions: int = 2


ROUTES = (
    Route("circle inverted, + normal", OffsetCircle(), lambda u: add_normal(circle(u[:, 0]))),
    Route("disk rejected, normalised, + normal", OffsetCircle(), lambda u: add_normal(normalize(points_in_ball(u)))),
    Route("disk inverted, + normal", OffsetDisk(), lambda u: add_normal(disk(u))),
    Route("disk rejected, + normal", OffsetDisk(), lambda u: add_normal(points_in_ball(u))),
    Route("numerically inverted distribution", OffsetDisk(), disk_by_inverted_distribution),
    Route("ball inverted, + normal", OffsetBall(), lambda u: add_normal(ball(u)), 3),
    Route("ball rejected, + normal", OffsetBall(), lambda u: add_normal(points_in_ball(u)), 3),
    Route("sphere inverted, + normal", CosineHemisphere(), lambda u: add_normal(sphere(u))),
    Route("ball rejected, normalised, + normal", CosineHemisphere(), lambda u: add_normal(normalize(points_in_ball(u))), 3),
    Route("sphere of radius 1/2 + normal", OffsetSphere(0.5), lambda u: add_normal(0.5 * sphere(u))),
    Route("sphere of radius 2 + normal", OffsetSphere(2.0), lambda u: add_normal(2.0 * sphere(u))),
    Route("rejection", UniformDisk(), points_in_ball),
    Route("the sphere's lower half mirrored", UniformHemisphere(), mirrored_sphere),
)


def _malley(u: np.ndarray) -> np.ndarray:
    """Sample the cosine lobe by lifting points of the disk to the hemisphere (Malley; Cranberry2020, after equation 8)."""
    x, y = np.sqrt(u[..., 0]) * np.stack([np.cos(_TURN * u[..., 1]), np.sin(_TURN * u[..., 1])])
    return np.stack([x, y, np.sqrt(1.0 - x * x - y * y)], axis=-1)


def _half_acos(u: np.ndarray) -> np.ndarray:
    """Sample the cosine lobe by the half angle theta = acos(1 - 2u) / 2 (Cranberry2020, equation 7)."""
    return spherical(np.arccos(1.0 - 2.0 * u[..., 0]) / 2.0, u[..., 1])


def _keinert(count: int) -> np.ndarray:
    """Return the points of the unit square that a map turns into the spherical Fibonacci sets of Keinert2014."""
    i = np.arange(count)
    return np.stack([(i + 0.5) / count, i * 0.6180339887498949 % 1.0], axis=1).astype(np.float32)


def _compare_maps() -> dict[str, float]:
    """Compare pairs of formulas for the same map; return the greatest distance of their points, keyed by the pair's name."""
    u = sample_square("sobol", 16, 4096, seed=8).reshape(-1, 2)
    wide, set_ = u.astype(np.float64), _keinert(4096)
    shirley = add_normal(UniformSphere().sample(u).astype(np.float64))
    polar = CosineHemisphere().sample
    whole, half = (polar_angle(d.sample(u).astype(np.float64)) for d in (UniformSphere(), CosineHemisphere("offset")))
    fibonacci = add_normal(UniformSphere().sample(set_).astype(np.float64))
    return {
        "Malley's projection of the disk": laws.worst(_malley(wide) - polar(u)),
        "θ = acos(1 − 2u)/2": laws.worst(_half_acos(wide) - CosineHemisphere("inversion").sample(u)),
        "sphere + normal is the cosine lobe": laws.worst(shirley - polar(u)),
        "half angle θ = 2θ' of ShirleyTrick, equation 3": laws.worst(whole - 2.0 * half),
        "Fibonacci sphere + normal is the Fibonacci cosine set": laws.worst(fibonacci - polar(set_)),
        "OffsetSphere(1) is the cosine lobe": laws.worst(OffsetSphere(1.0).sample(u) - polar(u)),
        "PowerCosine(1) is the cosine lobe": laws.worst(PowerCosine(1.0).sample(u) - polar(u)),
        "PowerCosine(3) is the offset ball": laws.worst(PowerCosine(3.0).sample(u) - OffsetBall().sample(u)),
        "PowerCosine(0) is the hemisphere": laws.worst(PowerCosine(0.0).sample(u) - UniformHemisphere().sample(u)),
        "UniformCone of all angles is the sphere": laws.worst(UniformCone(-1.0).sample(u) - UniformSphere().sample(u)),
        "HenyeyGreenstein(0) is the sphere": laws.worst(HenyeyGreenstein(0.0).sample(u) - UniformSphere().sample(u)),
        "GGX(1) is the cosine lobe": laws.worst(GGX(1.0).sample(u) - polar(u)),
    }


def _compare_densities() -> dict[str, float]:
    """Compare pairs of formulas for the same density; return the greatest relative difference, keyed by the pair's name."""
    u = sample_square("sobol", 16, 4096, seed=9).reshape(-1, 2)

    def difference(one: Any, other: Any) -> float:
        """Return the greatest relative difference of two densities at directions that `other` samples."""
        w = other.sample(u)
        return laws.density_error(one.pdf(w), other.pdf(w).astype(np.float64))

    return {
        "VisibleGGX from above is GGX": difference(VisibleGGX(0.2), GGX(0.2)),
        "VisibleBeckmann from above is Beckmann": difference(VisibleBeckmann(0.2), Beckmann(0.2)),
        "OffsetSphere(1) is the cosine lobe": difference(OffsetSphere(1.0), CosineHemisphere()),
        "PowerCosine(3) is the offset ball": difference(PowerCosine(3.0), OffsetBall()),
        "PowerCosine(0) is the hemisphere": difference(PowerCosine(0.0), UniformHemisphere()),
        "HenyeyGreenstein(0) is the sphere": difference(HenyeyGreenstein(0.0), UniformSphere()),
        "GGX(1) is the cosine lobe": difference(GGX(1.0), CosineHemisphere()),
    }


def judge_routes() -> list[Verdict]:
    """Test that methods from the literature sample the same distributions as the package; return the results."""
    verdicts = []
    for route in ROUTES:
        w, name = route.draw(variates(route.dimensions)), f"{type(route.to).__name__} by {route.name}"
        edges = Evidence(Subject(name, route.to, route.to)).edges
        p_values = {
            "route, cells": laws.cells_p_value(route.to, w, edges),
            "route, angle": laws.angles_p_value(route.to, chart_of(route.to).polar(w)),
            **({"route, azimuth": laws.azimuth_p_value(w)} if route.to.measure != "per radian" else {}),
        }
        verdicts += [Verdict.from_p_value(law, name, p_value) for law, p_value in p_values.items()]
    # Both maps are accurate to 2e-7, and the rounding of u moves a float64 formula by 6e-8 of a turn.
    verdicts += [Verdict.from_error("one map, two routes", n, value, limit=5e-7) for n, value in _compare_maps().items()]
    return verdicts + [
        Verdict.from_error("one density, two routes", n, v, limit=2e-6) for n, v in _compare_densities().items()
    ]
