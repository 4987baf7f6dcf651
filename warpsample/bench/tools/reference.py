"""The right ambient occlusion that all tools are held against, and what Embree says of it."""

from dataclasses import dataclass

import numpy as np

from warpsample.bench.rows import column
from warpsample.bench.scenes import some_of
from warpsample.bench.tools.occlusion import by_embree
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints

_RAYS = 1 << 16  # of each point
_REFERENCE_SEED = 1 << 40  # far from those of the estimates
_BY_CHANCE = 5.0  # standard errors: of 768 points, by chance once in 2,000 runs


@dataclass(frozen=True)
class Confirmation:
    """The reference at some points of a scene, held against independent cosine rays that embreex traces."""

    scene: str = column("scene")
    points: int = column("points")
    embree_rays: int = column("of Embree")
    mean_difference: float = column("mean difference", "of the reference less Embree's share of open rays", show=".1e")
    mean_error: float = column("its standard error", show=".1e")
    rms: float = column("RMS", "of the differences, each in its standard error; about 1 where both are right")
    worst: float = column("worst", "the greatest of these differences", show=".1f")
    agrees: bool = column("agrees", "whether it and the mean difference are below 5 standard errors")


def reference_of(mesh: Mesh, at: SurfacePoints, workers: int, rays: int = _RAYS) -> Estimate:
    """The right values by `ambient_occlusion` and its defaults: Fibonacci points, our own tracer."""
    return ambient_occlusion(mesh, at, rays, seed=_REFERENCE_SEED, workers=workers)


def confirm(
    scene: str, mesh: Mesh, at: SurfacePoints, reference: Estimate, *, workers: int, points: int = 256, rays: int = 1 << 14
) -> Confirmation:
    """Holds a reference at `at` against Embree, at some points that are spread over all, by so many rays of each.

    Raises:
        ModuleNotFoundError: embreex is not installed.
    """
    chosen = np.linspace(0, len(at) - 1, min(points, len(at))).astype(int)
    share = by_embree(mesh, some_of(at, chosen), workers)(rays).astype(np.float64)
    values, errors = (array[chosen].astype(np.float64) for array in (reference.value, reference.standard_error))
    # By Laplace's rule, so that a share of all or nothing has a variance too; of both, since they should agree.
    likely = [(rays * p + 1.0) / (rays + 2.0) for p in (values, share)]
    variance = sum(p * (1.0 - p) for p in likely) / (2.0 * rays) + errors**2
    off = (values - share) / np.sqrt(variance)
    difference, error = float(np.mean(values - share)), float(np.sqrt(np.sum(variance)) / len(off))
    worst = float(np.abs(off).max())
    return Confirmation(
        scene=scene,
        points=len(off),
        embree_rays=rays,
        mean_difference=difference,
        mean_error=error,
        rms=float(np.sqrt(np.mean(off**2))),
        worst=worst,
        agrees=max(worst, abs(difference) / error) <= _BY_CHANCE,
    )
