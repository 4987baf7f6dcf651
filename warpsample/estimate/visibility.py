"""Ambient occlusion, sky view factor and bent normals at surface points."""

from dataclasses import dataclass, fields
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray
from typing_extensions import Unpack

from warpsample.estimate.estimating import estimate
from warpsample.estimate.plan import RaySum, plan_of, reach_of
from warpsample.estimate.result import Estimate, OpenShare, Share
from warpsample.estimate.weights import DIRECTION, OPEN, build_sky_integrand
from warpsample.host.arguments import check_number
from warpsample.host.arrays import as_unit
from warpsample.host.locks import multiply
from warpsample.host.options import RayKeywords, with_options
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.placed_points import PlacedPoints


@with_options(RayKeywords)
def ambient_occlusion(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    max_distance: float | None = None,
    falloff: float | None = None,
    **options: Unpack[RayKeywords],
) -> Estimate:
    """Compute ambient occlusion: the share of cosine-weighted rays that hit nothing, 1 where a point is open.

    Behind a face with a transmittance (see `Mesh`) a ray continues with that share of its weight. The bits depend on (mesh,
    point, first_point + row, seed, count, sequence) alone; a CUDA device has other roundings. Memory is proportional to the
    points. The first call compiles for about 8 s.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts. A Mesh keeps its tree from call to call.
        points: P SurfacePoints. The lobe is about the normal, of any length. Rays start a millionth of the mesh's size above
            the face, on the normal's side; rays into the face are blocked. A point on an edge or a corner sees the same as
            its face just beside it: at the foot of a wall half of the sky, in a closed room none. Without `face`, that is
            the face at the point that fits the normal best. A point of a floor at a wall's foot is in front of the wall.
        count: Number of rays per point, 2 to 2^24. Rounded down, so that all strata have the same number: to a multiple of
            2, from 32 on of 8, from 256 of 16, from 448 of 64, from 4,096 of 128, from 16,384 of 256. Default: 256.
        max_distance: Distance from which on hits are ignored, a float in mesh units. Default: None, no limit.
        falloff: Exponent of ambient obscurance (Zhukov1998), a float: a hit at distance t occludes by
            (1 - t / max_distance)^falloff of the light that it stops. Default: None, every hit occludes fully.
        sequence: Sequence of the rays, a name in `warpsample.sequences.names()`. Default: "fibonacci".
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        active: (P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.
        tolerance: Root mean square of the standard errors to reach, in the result's unit. Default: None, all `count` rays. A
            trial at one in twelve points or fewer finds the number of rays for all points, so other points give other last
            digits. A warning reports a tolerance that `count` rays do not reach.

    Returns:
        value (P,) from 0 to 1, its standard error, and for each point the rays cast and a status.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Warns:
        UserWarning: parts of the mesh are so far apart that its coordinates are too coarse for most of its faces.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> open_share = ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 100), 64)
        >>> print(open_share.value.shape, f"{open_share.value.mean():.1f}")
        (100,) 0.7
    """
    plan = plan_of(PlacedPoints.of(mesh, points), count, **options)
    reach = reach_of(max_distance)
    if falloff is not None:
        falloff = check_number(falloff, "falloff", 0.0, 1000.0)
        if not 0.0 < reach < inf:
            raise ValueError(
                f"max_distance: got {max_distance}, want a finite distance above 0, because falloff is relative to "
                "max_distance"
            )
    return estimate(plan, RaySum(OPEN, reach=reach, falloff=falloff, result=OpenShare))


@dataclass(frozen=True, eq=False, repr=False)
class SkyView(Share):
    """Estimate of the sky view factor at P points, with the share of each point's view that is below the horizon.

    Attributes:
        below_horizon: (P,) float32, the share of the lobe that points below the sky's horizon, exactly: (1 - n.up) / 2.
    """

    below_horizon: NDArray[np.float32]

    @property
    def largest_error(self) -> NDArray[np.float32]:
        """Largest error of each value whose rays all agree, (P,); infinite at points with rays.

        Without rays, the value is then 1 or 0, and the true value is the share of the lobe above the horizon.
        """
        below = self.below_horizon
        return np.where(self.rays == 0, np.minimum(below, np.float32(1.0) - below), np.float32(np.inf))


@with_options(RayKeywords)
def sky_view_factor(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    up: Any = (0.0, 0.0, 1.0),
    max_distance: float | None = None,
    **options: Unpack[RayKeywords],
) -> SkyView:
    """Compute the cosine-weighted share of the sky: the irradiance under a uniform sky, relative to open ground.

    An upright wall that sees nothing but the sky has 1/2: the other half of its lobe points below the horizon.

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
        value (P,) from 0 to 1, its standard error, the share of the lobe below the horizon, and for each point the rays
        cast and a status.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> sky = ws.sky_view_factor(mesh, ws.face_centers(mesh), 64, up=(0, 0, 1))
        >>> print(sky.value.shape, f"{sky.value.max():.2f}", f"{sky.below_horizon.max():.2f}")  # a roof; an upright wall
        (2080,) 1.00 0.50
    """
    plan = plan_of(PlacedPoints.of(mesh, points), count, **options)
    reach = reach_of(max_distance)
    axis = as_unit(up, "up")
    found = estimate(plan, RaySum(build_sky_integrand(axis), reach=reach, result=Share))
    normal = np.asarray(points.normal, np.float64)
    with np.errstate(invalid="ignore"):
        cosine = multiply(normal, axis) / np.linalg.norm(normal, axis=1)
    below = np.where(found.status == 0, 0.5 - 0.5 * cosine, 0.0).astype(np.float32)
    return SkyView(**{item.name: getattr(found, item.name) for item in fields(found)}, below_horizon=below)


@with_options(RayKeywords)
def bent_normals(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    max_distance: float | None = None,
    **options: Unpack[RayKeywords],
) -> Estimate:
    """Compute the cosine-weighted mean of the unoccluded directions: 2/3 of the normal at an open point.

    Divided by its length, the mean is the bent normal (Landis2002). Its product with the normal is the mean cosine.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        count: Number of rays per point, 2 to 2^24, rounded down as for `ambient_occlusion`. Default: 256.
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
        value (P, 3), vectors in world coordinates, of length 0 where all is closed to about 2/3 where all is open; the
        standard error of each component, and for each point the rays cast and a status.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> bent = ws.bent_normals(mesh, ws.sample_surface(mesh, 100), 64)
        >>> print(bent.value.shape, f"{np.linalg.norm(bent.value, axis=1).max():.1f}")
        (100, 3) 0.7
    """
    plan = plan_of(PlacedPoints.of(mesh, points), count, **options)
    return estimate(plan, RaySum(DIRECTION, reach=reach_of(max_distance)))
