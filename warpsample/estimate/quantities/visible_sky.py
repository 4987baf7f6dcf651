"""The visible share of the sky's solid angle, which terrain and archaeology people call sky view factor as well."""

from typing import Any

from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.estimate.estimating import estimate
from warpsample.estimate.plan import Plan, RaySum, reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Share
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.estimate.weights import above_plane
from warpsample.host.arrays import as_unit
from warpsample.host.options import explained_by
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints


@explained_by(RayOptions, ambient_occlusion)
def visible_sky(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    up: Any = (0.0, 0.0, 1.0),
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
) -> Share:
    """The share of the sky's solid angle that a point sees: each direction above the horizon counts the same.

    Relief visualisation and GIS call it sky view factor, as `sky_view_factor` is called where radiation is computed: that
    one weighs directions by the cosine. With one horizon h to each azimuth this is 1 - mean of sin(h). In the middle of an
    endless street as wide as it is high it is 0.295, and the other 0.447. Rays go all around the point's normal, evenly:
    what is behind its face is not seen.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: P of them; as for `ambient_occlusion`.
        count: rays of each point.
        up: (3,), of any length; rays below the plane across it do not see the sky, whatever they meet, and are not cast.
        max_distance, tolerance: see `ambient_occlusion`.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

    Returns:
        value (P,) from 0 to 1, its standard error, and for each point the rays cast and a status.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> yard = ws.SurfacePoints(position=[[36.0, 36.0, 0.0]], normal=[[0.0, 0.0, 1.0]])
        >>> print(f"{ws.visible_sky(mesh, yard, 4096).value[0]:.2f}, {ws.sky_view_factor(mesh, yard, 4096).value[0]:.2f}")
        0.23, 0.36
    """
    at = PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, active=active, ids=at.id)
    options = options.by(skip=skip, tracer=tracer, device=device, workers=workers, progress=progress)
    plan = Plan.of(at, count, options, tolerance=tolerance, distribution=UniformHemisphere())
    reach = reach_of(max_distance)
    return estimate(plan, RaySum(above_plane(as_unit(up, "up")), reach=reach, result=Share))  # type: ignore[return-value]


RECORD = Quantity(
    name="visible-sky",
    call=visible_sky,
    title="visible sky",
    value="the share of the sky's solid angle that it sees, every direction alike",
    result=Share,
)
