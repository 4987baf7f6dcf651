"""The mean distance to the nearest hit: what maps of thickness and of openness are made of."""

from dataclasses import dataclass, fields
from math import inf
from typing import Any

from warpsample.estimate.estimating import estimate
from warpsample.estimate.plan import Plan, RaySum, reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Estimate
from warpsample.estimate.weights import OPEN
from warpsample.host.arguments import check_number
from warpsample.host.options import explained_by
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

_LEAST, _MOST = 1e-30, 1e30  # of a limit: its float32 and those of the errors are neither 0 nor infinite


@dataclass(frozen=True, eq=False, repr=False)
class MeanDistance(Estimate):
    """An `Estimate` of the mean distance to the nearest hit.

    Attributes:
        max_distance: what a ray that meets nothing within it counts as; no value is above it.
    """

    max_distance: float

    @property
    def possible(self) -> tuple[float, float]:  # type: ignore[override]
        """The least and the greatest mean that there can be."""
        return 0.0, self.max_distance


@explained_by(RayOptions)
def mean_distance(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
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
) -> MeanDistance:
    """The mean distance of cosine-weighted rays to what they meet first, of each at most `max_distance`.

    With normals outward it says how open a place is, with normals turned inward how thick a body is there. It is
    `max_distance` times the ambient occlusion with a `falloff` of 1, whose kernel it shares: a ray that meets something at
    a distance t, or nothing, adds min(t, max_distance). At faces with a transmittance a part of the ray ends, and the rest
    goes on: what is added is the mean over its parts.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: P of them; as for `ambient_occlusion`.
        count: rays of each point.
        max_distance: what farther hits and rays that meet nothing count as, in units of the coordinates, above 0. By
            default, and if it is infinite, the diagonal of the mesh's box: from a point of the mesh nothing of it is
            farther, so that within a closed body no distance is cut. Each ray adds a float32 share of it, and so errs by up
            to 6e-8 of it.
        tolerance: the standard error to reach, in units of the coordinates, as the root mean square over the points, by at
            most `count` rays; as for `ambient_occlusion`.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

    Returns:
        value (P,) from 0 to `max_distance`, in units of the coordinates, its standard error, and for each point the rays
        cast and a status.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")  # of 72 x 72 x 24
        >>> yard = ws.SurfacePoints(position=[[36.0, 36.0, 0.0]], normal=[[0.0, 0.0, 1.0]])
        >>> free = ws.mean_distance(mesh, yard, max_distance=20.0)
        >>> print(f"{free.value[0]:.0f} of {free.max_distance:.0f}")
        16 of 20
    """
    at = PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, ids=at.id, active=active).by(
        skip=skip, tracer=tracer, device=device, workers=workers, progress=progress
    )
    plan = Plan.of(at, count, options, tolerance=tolerance)
    limit = reach_of(max_distance)
    limit = at.mesh.diagonal if limit == inf else check_number(limit, "max_distance", _LEAST, _MOST)
    found = estimate(plan, RaySum(OPEN, reach=limit, unit=limit, falloff=1.0))
    return MeanDistance(**{item.name: getattr(found, item.name) for item in fields(found)}, max_distance=limit)


RECORD = Quantity(
    name="mean-distance",
    call=mean_distance,
    title="mean distance",
    value="the mean distance to what its rays meet first, at most `max_distance`",
    result=MeanDistance,
    shared=("skipped", "max_distance"),
    unit="mesh units",
    white=0.0,
)
