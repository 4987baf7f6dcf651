"""The general estimate: the mean over a lobe of a function of the user's."""

from dataclasses import replace
from typing import Any

import numpy as np

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.estimate.definitions import naming_function
from warpsample.estimate.integrand import integrand_of
from warpsample.estimate.plan import Plan, Quantity, reach_of
from warpsample.estimate.result import Estimate, PointStatus
from warpsample.host.arguments import told
from warpsample.mesh.surface import SurfacePoints

_FEW_POINTS, _FEW_RAYS = 64, 64


def integrate(
    points: Any,
    integrand: Any,
    count: int = 256,
    *,
    data: Any = None,
    distribution: Distribution | str = CosineHemisphere(),  # noqa: B008  (frozen)
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
        max_distance: hits at or beyond this distance are ignored, in units of the coordinates; by default there is no limit.
        sequence: of the directions, a name of `warpsample.sequences.names()`.
        seed: of 64 bits.
        first_point: the global id of row 0.
        active: (P,) bool; other points get 0 and a status.
        tolerance: the standard error to reach in each component, as the root mean square over the points, by at most
            `count` directions; as for `ambient_occlusion`.
        skip: whether to look for rays that meet nothing and leave them out; changes no bit.
        tracer: "wide", "warp" (wp.Mesh, without skipping) or "auto".
        device: where to compute, the CPU by default; on a CUDA device by wp.Mesh, in parts that come back as NumPy's arrays.
        workers: threads on the CPU, all cores by default.
        progress: whether to show a bar, on a terminal or in a notebook; changes no bit.

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
    plan = Plan.of(
        mesh,
        points,
        count,
        sequence,
        seed,
        first_point,
        active,
        tolerance,
        skip,
        tracer,
        workers,
        progress,
        distribution=distribution,
        meshless=mesh is None,
        device=device,
    )
    quantity = Quantity(integrand_of(integrand, data, device=plan.memory.device), reach=reach_of(max_distance))
    if mesh is None and max_distance is not None:
        raise ValueError(f"max_distance: got {told(max_distance)} without a mesh, want it with one")
    first = _first_of(plan)
    with naming_function("integrand"):
        found = first.estimate(quantity)
    _check_finite(found)
    return found if first is plan else plan.estimate(quantity)


def _first_of(plan: Plan) -> Plan:
    """The first points with few rays; of a call with no more points than that, the plan itself."""
    if len(plan.points) <= _FEW_POINTS:
        return plan
    few = slice(_FEW_POINTS)
    points = SurfacePoints(plan.points.position[few], plan.points.normal[few], plan.points.face[few])
    active = None if plan.active is None else plan.active[few]
    return replace(plan, points=points, active=active, count=min(plan.count, _FEW_RAYS), tolerance=None)


def _check_finite(found: Estimate) -> None:
    """Refuses a function that is finite at no point.

    Raises:
        ValueError: it is NaN or infinite at all points that have a normal.
    """
    broken = np.count_nonzero(found.status == PointStatus.NONFINITE_VALUE)
    if broken and broken == np.count_nonzero(np.isin(found.status, (PointStatus.OK, PointStatus.NONFINITE_VALUE))):
        raise ValueError(f"integrand: got NaN or infinity at each of the first {broken} points, want finite numbers")
