"""The call `integrate`: the mean of a user-defined function over directions about each normal."""

from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import Unpack

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.estimate.estimating import estimate
from warpsample.estimate.integrand import integrand_of
from warpsample.estimate.plan import Plan, RaySum, plan_of, reach_of
from warpsample.estimate.result import Estimate, PointStatus, has_status, has_value
from warpsample.estimate.source.definitions import naming_function
from warpsample.host.arguments import quote
from warpsample.host.options import RayKeywords, with_options
from warpsample.host.vectors import as_directions
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.triples import Triples

_FEW_POINTS, _FEW_RAYS = 64, 64


@with_options(RayKeywords)
def integrate(
    points: Any,
    integrand: Any,
    count: int = 256,
    *,
    data: Any = None,
    distribution: Distribution | str = CosineHemisphere(),
    mesh: Any = None,
    max_distance: float | None = None,
    **options: Unpack[RayKeywords],
) -> Estimate:
    """Compute the mean of a function over random directions about each normal, without storing the directions.

    The mean is the expectation under the distribution's density, not divided by it: over the cosine lobe, pi times the mean
    of a radiance is the irradiance. The first call with a function compiles for about 8 s with a mesh, 4 s without.

    Args:
        points: SurfacePoints; without a mesh also normals, (P, 3) of any length.
        integrand: a wp.func (w: wp.vec3, lobe: funcs.Lobe, data: the type of `data`) -> float or wp.vec3, annotated; the
            last arguments may be left out; what it names counts as it is now. `w` is a unit direction in world coordinates,
            `lobe` has the unit normal, the row in this call and the global id of the point, and the density `pdf` of the
            direction: the mean of a function divided by `lobe.pdf` is the function's integral over the lobe's support.
        count: Number of directions per point, 2 to 2^24, rounded down as for `ambient_occlusion`. Default: 256.
        data: Instance of a wp.struct, with arrays on the CPU or the device, or the id of a wp.Mesh there. Default: None.
        distribution: Distribution of the directions, or its name; its parameters may be arrays with one row for each point.
            Default: CosineHemisphere(method="polar").
        mesh: Mesh, or anything that `as_mesh` accepts, that blocks directions. Default: None, nothing is blocked.
        max_distance: Distance from which on hits are ignored, a float in mesh units. Default: None, no limit.
        sequence: Sequence of the rays, a name in `warpsample.sequences.names()`. Default: "fibonacci".
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        active: (P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active.
        tolerance: Root mean square of the standard errors to reach, in the result's unit. Default: None, all `count` rays.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        value (P,), or (P, 3) for a function that gives a vec3, its standard error, and for each point the rays cast
        (without a mesh: the directions) and a status: NONFINITE_VALUE where the function gave NaN or infinity. Tangents of
        the points orient the lobes; a point whose tangent cannot be used has a value and the status INVALID_TANGENT.

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
    plan = plan_of(at, count, distribution=distribution, tangents=True, **options)
    summed = RaySum(integrand_of(integrand, data, device=plan.options.memory.device), reach=reach_of(max_distance))
    if mesh is None and max_distance is not None:
        raise ValueError(f"max_distance: got {quote(max_distance)} without a mesh, want a mesh, too, or no max_distance")
    first = _first_of(plan)
    with naming_function("integrand"):
        found = estimate(first, summed)
    _check_finite(found)
    return found if first is plan else estimate(plan, summed)


def _without_mesh(points: Any) -> PlacedPoints:
    """Convert SurfacePoints, or a (P, 3) array of normals, to the points of a call without a mesh."""
    if not isinstance(points, SurfacePoints):
        given = Triples.of(points, "points", "(P, 3)")
        if len(given.shape) != 1:
            raise ValueError(f"points: got shape {(*given.shape, 3)}, want (P, 3), one row for each of P points")
        normals = as_directions(given.owner)
        points = SurfacePoints(np.zeros(normals.shape, np.float32), normals)
    return PlacedPoints(points, None)


def _first_of(plan: Plan) -> Plan:
    """Return the arguments of a trial run: the first 64 points with at most 64 rays each.

    The short run reports functions that do not compile or are not finite before the long run starts.
    """
    if len(plan.at) <= _FEW_POINTS:
        return plan
    few, active = slice(_FEW_POINTS), plan.options.active
    at = PlacedPoints(plan.at.points.take(few), plan.at.mesh)
    options = replace(plan.options, ids=at.id, active=None if active is None else active[few])
    lobe = plan.distribution.take(few)
    return replace(plan, at=at, options=options, count=min(plan.count, _FEW_RAYS), tolerance=None, distribution=lobe)


def _check_finite(found: Estimate) -> None:
    """Raise ValueError if the estimate is NaN or infinite at every point with a valid normal."""
    broken = np.count_nonzero(has_status(found.status, PointStatus.NONFINITE_VALUE))
    if broken and not has_value(found.status).any():
        raise ValueError(f"integrand: got NaN or infinity at each of the first {broken} points, want finite numbers")
