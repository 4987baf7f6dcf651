"""The right values that all tools are held against, and what Embree says of them."""

from dataclasses import dataclass

import numpy as np

from warpsample.bench.record import SEED
from warpsample.bench.scenes import SCENES
from warpsample.bench.visibility.tools import by_embree
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.registry import look_up
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints, sample_surface

_RAYS = 1 << 16  # of each point
_REFERENCE_SEED = 1 << 40  # far from those of the estimates
_BY_CHANCE = 5.0  # standard errors: of 768 points, by chance once in 2,000 runs


@dataclass(frozen=True)
class Reference:
    """Right values.

    Attributes:
        values: (P,) float32.
        errors: (P,) float32, their standard errors.
        rays: of each point, asked for.
    """

    values: np.ndarray
    errors: np.ndarray
    rays: int


@dataclass(frozen=True)
class Confirmation:
    """The reference at some points of a scene, held against rays that embreex traces.

    Attributes:
        scene: its name.
        points: compared.
        reference_rays: of each, asked for, by our estimator.
        embree_rays: of each, independent and cosine-weighted.
        mean_difference: of the reference less Embree's share of rays that get away.
        mean_error: its standard error.
        rms: of the differences, each in its standard error; about 1 where both are right.
        worst: of the same, the greatest.
        agrees: whether `worst` and the mean difference are below 5 standard errors.
    """

    scene: str
    points: int
    reference_rays: int
    embree_rays: int
    mean_difference: float
    mean_error: float
    rms: float
    worst: float
    agrees: bool


def points_of(scene: str, points: int) -> tuple[Mesh, SurfacePoints]:
    """A scene of the benchmark and points uniform on it by area, in the order of the faces; seed 0."""
    mesh = look_up(SCENES, scene, "scene")()
    found = sample_surface(mesh, points, seed=SEED)
    order = np.argsort(found.face, kind="stable")
    return mesh, SurfacePoints(found.position[order], found.normal[order], found.face[order])


def reference_of(mesh: Mesh, at: SurfacePoints, workers: int, rays: int = _RAYS) -> Reference:
    """By `ambient_occlusion` and its defaults: Fibonacci points, our own tracer."""
    found = ambient_occlusion(mesh, at, rays, seed=_REFERENCE_SEED, workers=workers)
    return Reference(found.value, found.standard_error, rays)


def confirm(
    scene: str,
    mesh: Mesh,
    at: SurfacePoints,
    reference: Reference,
    workers: int,
    points: int = 256,
    rays: int = 1 << 14,
) -> Confirmation:
    """Holds a reference against Embree.

    Args:
        scene: its name.
        mesh: the scene.
        at: where the reference is known.
        reference: its values there.
        workers: threads.
        points: of `at`, spread over all, that are compared.
        rays: of each by Embree.

    Raises:
        ModuleNotFoundError: embreex is not installed.
    """
    chosen = np.linspace(0, len(at) - 1, min(points, len(at))).astype(int)
    some = SurfacePoints(at.position[chosen], at.normal[chosen], at.face[chosen])
    share = by_embree(mesh, some, workers)(rays).astype(np.float64)
    values, errors = (array[chosen].astype(np.float64) for array in (reference.values, reference.errors))
    # By Laplace's rule, so that a share of all or nothing has a variance too; of both, since they should agree.
    likely = [(rays * p + 1.0) / (rays + 2.0) for p in (values, share)]
    variance = sum(p * (1.0 - p) for p in likely) / (2.0 * rays) + errors**2
    off = (values - share) / np.sqrt(variance)
    difference, error = float(np.mean(values - share)), float(np.sqrt(np.sum(variance)) / len(off))
    worst = float(np.abs(off).max())
    return Confirmation(
        scene=scene,
        points=len(off),
        reference_rays=reference.rays,
        embree_rays=rays,
        mean_difference=difference,
        mean_error=error,
        rms=float(np.sqrt(np.mean(off**2))),
        worst=worst,
        agrees=max(worst, abs(difference) / error) <= _BY_CHANCE,
    )
