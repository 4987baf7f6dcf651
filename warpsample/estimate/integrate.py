"""The general estimate: the mean over a lobe of a function of the user's."""

from dataclasses import replace
from typing import Any

import numpy as np

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.estimate.estimating import estimate
from warpsample.estimate.integrand import integrand_of
from warpsample.estimate.plan import Plan, RaySum, reach_of
from warpsample.estimate.result import Estimate, PointStatus, has_status
from warpsample.estimate.source.definitions import naming_function
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.arguments import told
from warpsample.host.options import explained_by
from warpsample.host.vectors import as_directions
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.triples import Triples

_FEW_POINTS, _FEW_RAYS = 64, 64


@explained_by(RayOptions, ambient_occlusion)
def integrate(
    points: Any,
    integrand: Any,
    count: int = 256,
    *,
    data: Any = None,
    distribution: Distribution | str = CosineHemisphere(),
    mesh: Any = None,
    max_distance: float | None = None,
    sequence: str = "fibonacci",
    seed: int = 0,
    first_point: int = 0,
    active: Any = None,
    tolerance: float | None = None,
    skip: bool = True,
    tracer: str = "auto",
    device: Any = None,
    workers: int | None = None,
    progress: bool = False,
) -> Estimate:
    """The mean of a function over the directions of a lobe about each normal; no direction reaches memory.

    It is the expectation under the distribution's density, not divided by it: over the cosine lobe, pi times the mean of a
    radiance is the irradiance. The first call with a function compiles for about 8 s with a mesh, 4 s without.

    Args:
        points: SurfacePoints; without a mesh also normals, (P, 3) of any length.
        integrand: a wp.func (w: wp.vec3, lobe: funcs.Lobe, data: the type of `data`) -> float or wp.vec3, annotated; the
            last arguments may be left out; what it names counts as it is now. `w` is a unit direction in world coordinates,
            `lobe` has the unit normal, the row in this call and the global id of the point.
        count: directions of each point, 2 to 2^24; rounded down as for `ambient_occlusion`.
        data: an instance of a wp.struct, which may hold arrays on the CPU or the device; a wp.Mesh's id only of one there.
        distribution: of the directions, an instance or a name for one with its defaults.
        mesh: if given, a direction counts 0 where a ray along it meets the mesh; rays where the function is 0 are not cast.
        max_distance, tolerance: see `ambient_occlusion`.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

    Returns:
        value (P,), or (P, 3) for a function that gives a vec3, its standard error, and for each point the rays cast
        (without a mesh: the directions) and a status: NONFINITE_VALUE where the function gave NaN or infinity.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants. A function that is
            not finite at the first points is found before the others are run.
        MemoryError: more than is free.

    Example:
        >>> @wp.func
        ... def height(w: wp.vec3) -> float:
        ...     return w[2]
        >>> up = ws.integrate([[0.0, 0.0, 1.0]], height, 1024)
        >>> print(f"{up.value[0]:.2f}")
        0.67
    """
    at = _without_mesh(points) if mesh is None else PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, ids=at.id, active=active).by(
        skip=skip, tracer=tracer, device=device, workers=workers, progress=progress
    )
    plan = Plan.of(at, count, options, tolerance=tolerance, distribution=distribution)
    summed = RaySum(integrand_of(integrand, data, device=options.memory.device), reach=reach_of(max_distance))
    if mesh is None and max_distance is not None:
        raise ValueError(f"max_distance: got {told(max_distance)} without a mesh, want it with one")
    first = _first_of(plan)
    with naming_function("integrand"):
        found = estimate(first, summed)
    _check_finite(found)
    return found if first is plan else estimate(plan, summed)


def _without_mesh(points: Any) -> PlacedPoints:
    """Points, or normals alone, (P, 3), whose rays meet nothing."""
    if not isinstance(points, SurfacePoints):
        given = Triples.of(points, "points", "(P, 3)")
        if len(given.shape) != 1:
            raise ValueError(f"points: got shape {(*given.shape, 3)}, want (P, 3)")
        normals = as_directions(given.owner)
        points = SurfacePoints(np.zeros(normals.shape, np.float32), normals)
    return PlacedPoints(points, None)


def _first_of(plan: Plan) -> Plan:
    """The first points with few rays; of a call with no more points than that, the plan itself."""
    if len(plan.at) <= _FEW_POINTS:
        return plan
    few, active = slice(_FEW_POINTS), plan.options.active
    at = PlacedPoints(plan.at.points.take(few), plan.at.mesh)
    options = replace(plan.options, ids=at.id, active=None if active is None else active[few])
    return replace(plan, at=at, options=options, count=min(plan.count, _FEW_RAYS), tolerance=None)


def _check_finite(found: Estimate) -> None:
    """Refuses a function that is NaN or infinite at all points that have a normal."""
    broken = np.count_nonzero(has_status(found.status, PointStatus.NONFINITE_VALUE))
    if broken and not has_status(found.status, PointStatus.OK).any():
        raise ValueError(f"integrand: got NaN or infinity at each of the first {broken} points, want finite numbers")
