"""Mean distance to the first hit, for maps of thickness and openness."""

from dataclasses import dataclass, fields
from math import inf
from typing import Any, ClassVar

from typing_extensions import Unpack

from warpsample.estimate.estimating import estimate
from warpsample.estimate.plan import RaySum, plan_of, reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Estimate
from warpsample.estimate.weights import OPEN
from warpsample.host.arguments import check_number
from warpsample.host.options import RayKeywords, with_options
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.placed_points import PlacedPoints

_LEAST, _MOST = 1e-30, 1e30  # of a limit, so that float32 limits and errors are neither 0 nor infinite


@dataclass(frozen=True, eq=False, repr=False)
class MeanDistance(Estimate):
    """Mean distance from P points to the first hits of rays, in mesh units, as an `Estimate`.

    Attributes:
        max_distance: Distance that a ray without a hit counts as, in mesh units; no value exceeds this distance.
    """

    max_distance: float

    open_is_exact: ClassVar[bool] = True

    @property
    def possible(self) -> tuple[float, float]:  # type: ignore[override]
        """Least and greatest possible mean distance, 0 and `max_distance`."""
        return 0.0, self.max_distance


@with_options(RayKeywords)
def mean_distance(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    max_distance: float | None = None,
    **options: Unpack[RayKeywords],
) -> MeanDistance:
    """Compute the mean distance of cosine-weighted rays to their first hit, at most `max_distance` for each ray.

    With normals outward the mean shows how open a point is, with normals inward how thick the body is. It is
    `max_distance` times the ambient occlusion with a `falloff` of 1. At a face with a transmittance a part of the ray ends
    and the rest continues: the ray adds the mean over its parts.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        count: Number of rays per point, 2 to 2^24, rounded down as for `ambient_occlusion`. Default: 256.
        max_distance: Distance that farther hits and rays without a hit count as, a float above 0 in mesh units. Default:
            None, the diagonal of the mesh's box, which cuts no distance within a closed body.
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
    plan = plan_of(at, count, **options)
    limit = reach_of(max_distance)
    limit = at.mesh.diagonal if limit == inf else check_number(limit, "max_distance", _LEAST, _MOST)
    found = estimate(plan, RaySum(OPEN, reach=limit, unit=limit, falloff=1.0))
    return MeanDistance(**{item.name: getattr(found, item.name) for item in fields(found)}, max_distance=limit)


RECORD = Quantity(
    name="mean-distance",
    call=mean_distance,
    title="mean distance",
    value="mean distance to the first hit of each ray, at most `max_distance`",
    result=MeanDistance,
    shared=("skipped", "max_distance"),
    unit="mesh units",
    white=0.0,
)
