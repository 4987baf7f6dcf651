"""The mean distance to the nearest hit: what maps of thickness and of openness are made of."""

from dataclasses import dataclass, fields
from math import inf
from typing import Any

from warpsample.estimate.plan import Plan, reach_of
from warpsample.estimate.plan import Quantity as Summand
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Estimate
from warpsample.estimate.weights import OPEN
from warpsample.host.arguments import check_number
from warpsample.mesh.surface import SurfacePoints

_LEAST, _MOST = 1e-30, 1e30  # of a limit: its float32 and those of the errors are neither 0 nor infinite


@dataclass(frozen=True, eq=False)
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
    a distance t, or nothing, adds min(t, max_distance).

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: P of them; as for `ambient_occlusion`.
        count: rays of each point.
        max_distance: what farther hits and rays that meet nothing count as, in units of the coordinates, above 0. By
            default, and if it is infinite, the diagonal of the mesh's box: from a point of the mesh nothing of it is
            farther, so that within a closed body no distance is cut. Each ray adds a float32 share of it, and so errs by up
            to 6e-8 of it.
        sequence: of the rays, a name of `warpsample.sequences.names()`.
        seed: of 64 bits.
        first_point: the global id of row 0.
        active: (P,) bool; other points get 0 and a status.
        tolerance: the standard error to reach, in units of the coordinates, as the root mean square over the points, by at
            most `count` rays; as for `ambient_occlusion`.
        skip: whether to look for rays that meet nothing and leave them out; changes no bit.
        tracer: "wide", "warp" (wp.Mesh, without skipping) or "auto".
        device: where to compute, the CPU by default; on a CUDA device by wp.Mesh, in parts that come back as NumPy's arrays.
        workers: threads on the CPU, all cores by default.
        progress: whether to show a bar, on a terminal or in a notebook; changes no bit.

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
        >>> print(f"{free.value[0]:.1f} of {free.max_distance}")
        15.8 of 20.0
    """
    plan = Plan.of(
        mesh, points, count, sequence, seed, first_point, active, tolerance, skip, tracer, workers, progress, device=device
    )
    limit = reach_of(max_distance)
    limit = plan.mesh.diagonal if limit == inf else check_number(limit, "max_distance", _LEAST, _MOST)
    found = plan.estimate(Summand(OPEN, reach=limit, unit=limit, falloff=1.0))
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
