"""Visible share of the sky's solid angle, which is also called sky view factor in terrain analysis and archaeology."""

from typing import Any

from typing_extensions import Unpack

from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.estimate.estimating import estimate
from warpsample.estimate.plan import RaySum, plan_of, reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Share
from warpsample.estimate.weights import build_sky_integrand
from warpsample.host.arrays import as_unit
from warpsample.host.options import RayKeywords, with_options
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.placed_points import PlacedPoints


@with_options(RayKeywords)
def visible_sky(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    up: Any = (0.0, 0.0, 1.0),
    max_distance: float | None = None,
    **options: Unpack[RayKeywords],
) -> Share:
    """Compute the share of the sky's solid angle that a point sees: all directions above the horizon have equal weight.

    GIS calls this share sky view factor, but `sky_view_factor` weights directions by the cosine. With one horizon h per
    azimuth, the share is 1 - mean of sin(h). A point does not see the sky behind its own face.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        count: Number of rays per point, 2 to 2^24, rounded down as for `ambient_occlusion`. Default: 256.
        up: (3,) vector of any length towards the zenith. Rays below its plane are not cast. Default: (0.0, 0.0, 1.0).
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
    plan = plan_of(PlacedPoints.of(mesh, points), count, distribution=UniformHemisphere(), **options)
    reach = reach_of(max_distance)
    return estimate(plan, RaySum(build_sky_integrand(as_unit(up, "up")), reach=reach, result=Share))  # type: ignore[return-value]


_ON_RASTERS = (
    "share of the sky's solid angle that is visible from the centre of each cell: 1/(2 pi) times the solid angle of "
    "the directions above the horizon in which a ray hits nothing; if each azimuth has one horizon h, 1 - mean of sin(h)"
)

RECORD = Quantity(
    name="visible-sky",
    call=visible_sky,
    title="visible sky",
    value="share of the sky's solid angle that is visible",
    result=Share,
    on_rasters={"horizontal": _ON_RASTERS},
)
