"""The sky above a field of heights, by the horizon to each azimuth.

Where a ray above such a field is free, a steeper one of the same azimuth is: each azimuth has one horizon. Halving finds it,
by a ray to the middle of what its sine may be, and again. A last ray, at random in what is left, makes the mean exact: it is
free as often as what is seen is a share of that interval. Azimuths are the points of one lattice of Keinert2014, moved at
random. The standard error follows from the horizons of neighbouring azimuths: see README.md.
"""

from typing import Any

import numpy as np

from warpsample.city.rasters.horizon_kernel import HorizonRowsArgs, horizon_kernel
from warpsample.city.rasters.intervals import half_width_of_normal
from warpsample.city.rasters.scenery import Seen
from warpsample.estimate.plan import Plan, reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.quantities.visible_sky import visible_sky
from warpsample.estimate.visibility import sky_view_factor
from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.progress import bar
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.rays import RAY_WORK

_MOST_RAYS, _MOST_OF_MANY, _MANY = 4, 5, 512  # of an azimuth, and where a point has so many: more azimuths are worth more
_ARRAYS = {"value": np.float32, "standard_error": np.float32, "rays": np.int32, "status": np.uint8}
_OPTIONS = ("count", "max_distance", "seed", "skip", "workers", "progress")


def finds_horizons(quantity: Quantity, options: dict[str, Any]) -> bool:
    """Whether a quantity is what is seen of the sky, and no option is given that is of rays all over it."""
    given = {name for name, value in options.items() if value != quantity.parameters[name]}
    return quantity.call in (sky_view_factor, visible_sky) and given <= set(_OPTIONS)


def sky_by_horizons(quantity: Quantity, mesh: Mesh, points: SurfacePoints, options: dict[str, Any]) -> Seen:
    """The share of the sky above +z that points see on a mesh that is the graph of heights above the plane.

    Args:
        quantity: `sky_view_factor` or `visible_sky`.
        mesh: what they see.
        points: with normals above the horizon.
        options: of its call; others than those of `finds_horizons` are left out.

    Raises:
        TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.
    """
    own = {name: options.get(name, quantity.parameters[name]) for name in _OPTIONS}
    at = PlacedPoints.of(mesh, points)
    cast = RayOptions.of(len(at), seed=own["seed"], ids=at.id)
    cast = cast.by(skip=own["skip"], tracer="wide", workers=own["workers"], progress=own["progress"])
    return _look(Plan.of(at, own["count"], cast), reach_of(own["max_distance"]), quantity.call is sky_view_factor)


def _look(plan: Plan, reach: float, cosine: bool) -> Seen:
    points, options = len(plan.at), plan.options
    found = {name: np.zeros(points, kind) for name, kind in _ARRAYS.items()}
    if not points:
        return _seen(found)
    placement = plan.at.facing(options, reach)
    order = plan.at.order(placement, plan.count, options.workers)
    placement.order = 0 if order is None else order.ctypes.data
    azimuths, rays = azimuths_and_rays(plan.count)
    rows = HorizonRowsArgs(
        placement=placement,
        seed=seed_for("horizons", options.seed),
        azimuths=azimuths,
        per_azimuth=rays,
        cosine=cosine,
        skip=options.skip,
        **{name: array.ctypes.data for name, array in ({"normals": plan.at.normal} | found).items()},
    )
    accelerator = options.tracer.accelerator(plan.at.scene, cpu(), options.workers)
    with bar(options.progress, "casting rays", points):
        work = RAY_WORK * points * plan.count
        run(horizon_kernel(), points, [rows, accelerator], cpu(), workers=options.workers, work=work)
    return _seen(found)


def _seen(found: dict[str, np.ndarray]) -> Seen:
    return Seen(half_width=half_width_of_normal(found["standard_error"]), **found)


def azimuths_and_rays(count: int) -> tuple[int, int]:
    """Return the number of azimuths, and of rays of each, for `count` rays or a few less.

    Azimuths are odd in number, where there are more than two: else opposite walls and corners, at an even distance of one
    another, would be off by the same.
    """
    rays = min(_MOST_RAYS if count < _MANY else _MOST_OF_MANY, max(1, count.bit_length() - 3))
    azimuths = count // rays
    return (azimuths - 1 if azimuths > 2 and azimuths % 2 == 0 else azimuths), rays
