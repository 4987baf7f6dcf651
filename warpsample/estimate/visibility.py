"""How much of its lobe a point sees: ambient occlusion, sky view, bent normals."""

from dataclasses import dataclass, fields
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.estimating import estimate
from warpsample.estimate.plan import Plan, RaySum, reach_of
from warpsample.estimate.result import Estimate, Share
from warpsample.estimate.weights import DIRECTION, OPEN, above_plane
from warpsample.host.arguments import check_number
from warpsample.host.arrays import as_unit
from warpsample.host.options import explained_by
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints


@explained_by(RayOptions)
def ambient_occlusion(
    mesh: Any,
    points: SurfacePoints,
    count: int = 256,
    *,
    max_distance: float | None = None,
    falloff: float | None = None,
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
    """The share of cosine-weighted rays that get away: 1 where a point is open, 0 where it is closed in.

    Behind a face with a transmittance (see `Mesh`) a ray goes on with that share of its weight.
    The bits depend on (mesh, point, first_point + row, seed, count, sequence) alone: not on threads, on which points are
    together or active, nor on `skip`; a CUDA device has other roundings. Memory is that of the points. The first call ever
    compiles for about 8 s. Without `skip` it takes up to 1.5 times as long (`warpsample bench visibility`).

    Args:
        mesh: a Mesh or whatever `as_mesh` takes; pass a Mesh to keep its tree from call to call.
        points: P of them. The lobe is about the normal, of any length; rays leave from a millionth of the mesh's size above
            the face, on the normal's side, and what goes into the face is blocked by it. A point on an edge or a corner sees
            what points of its own face just beside it see: at the foot of a wall half of the sky, in a closed room none. If
            no face is given, that is the one of those at the point that faces the normal best. On a wall's foot in the
            middle of a floor, off its edges, a point is in front of the wall.
        count: rays of each point, 2 to 2^24. Rounded down, so that all strata have as many: to a multiple of 2, from 32 on
            of 8, from 256 of 16, from 448 of 64, from 4,096 of 128, from 16,384 of 256.
        max_distance: hits at or beyond this distance are ignored, in units of the coordinates; by default there is no limit.
        falloff: a hit at a distance t occludes by (1 - t / max_distance)^falloff, so that there is no edge at
            max_distance: ambient obscurance (Zhukov1998). 1 is a straight line. A face with a transmittance occludes so by
            the share that it stops of the light that gets to it.
        tolerance: the standard error to reach, of each component in the result's unit and in the root mean square over the
            points: by how many of `count` rays from each, a trial of one in twelve points or fewer says. Its rays are
            forgotten, which keeps the result unbiased. A warning tells where `count` does not reach it. The count
            depends on all points of the call, so another choice of points or parts gives other last digits.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

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
    at = PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, ids=at.id, active=active).by(
        skip=skip, tracer=tracer, device=device, workers=workers, progress=progress
    )
    plan = Plan.of(at, count, options, tolerance=tolerance)
    reach = reach_of(max_distance)
    if falloff is not None:
        falloff = check_number(falloff, "falloff", 0.0, 1000.0)
        if not 0.0 < reach < inf:
            raise ValueError(f"max_distance: got {max_distance}, want a finite one above 0, to which falloff is relative")
    return estimate(plan, RaySum(OPEN, reach=reach, falloff=falloff, result=Share))


@dataclass(frozen=True, eq=False, repr=False)
class SkyView(Share):
    """An `Estimate` of the sky view factor.

    Attributes:
        below_horizon: (P,) float32, the share of the lobe that points below the sky's horizon, exactly: (1 - n.up) / 2.
    """

    below_horizon: NDArray[np.float32]


@explained_by(RayOptions, ambient_occlusion)
def sky_view_factor(
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
) -> SkyView:
    """The cosine-weighted share of rays that escape upward: the irradiance under a uniform sky, over that of open ground.

    An upright wall that sees nothing but the sky has 1/2: the other half of its lobe points below the horizon.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: P of them; as for `ambient_occlusion`.
        count: rays of each point.
        up: (3,), of any length; rays below the plane across it do not see the sky, whatever they meet, and are not cast.
        max_distance, tolerance: see `ambient_occlusion`.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

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
    at = PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, ids=at.id, active=active).by(
        skip=skip, tracer=tracer, device=device, workers=workers, progress=progress
    )
    plan = Plan.of(at, count, options, tolerance=tolerance)
    reach = reach_of(max_distance)
    axis = as_unit(up, "up")
    found = estimate(plan, RaySum(above_plane(axis), reach=reach, result=Share))
    normal = np.asarray(points.normal, np.float64)
    with np.errstate(invalid="ignore"):
        cosine = normal @ axis / np.linalg.norm(normal, axis=1)
    below = np.where(found.status == 0, 0.5 - 0.5 * cosine, 0.0).astype(np.float32)
    return SkyView(**{item.name: getattr(found, item.name) for item in fields(found)}, below_horizon=below)


@explained_by(RayOptions, ambient_occlusion)
def bent_normals(
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
) -> Estimate:
    """The mean of the directions that get away, cosine-weighted, (P, 3): of length 2/3 along the normal where it is open.

    Divided by its length it is the bent normal (Landis2002). Its product with the normal is the mean cosine of those rays.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: P of them; as for `ambient_occlusion`.
        count: rays of each point.
        max_distance, tolerance: see `ambient_occlusion`.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

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
    at = PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, ids=at.id, active=active).by(
        skip=skip, tracer=tracer, device=device, workers=workers, progress=progress
    )
    plan = Plan.of(at, count, options, tolerance=tolerance)
    return estimate(plan, RaySum(DIRECTION, reach=reach_of(max_distance)))
