"""Sky view above a field of heights, from the horizon in each azimuth.

Above a field of heights, a ray that is steeper than a free ray of the same azimuth is free, too. So each azimuth has one
horizon. Rays find it by bisection: each goes to the middle of the interval of possible sines. A last ray at a random sine in
the final interval makes the mean unbiased: the ray is free with the probability that equals the seen fraction of that
interval. The azimuths are a lattice of Keinert2014, rotated at random. The standard error is computed from differences of
neighbouring horizons; see README.md.
"""

from typing import Any

import numpy as np

from warpsample.city.rasters.horizon_kernel import HorizonRowsArgs, horizon_kernel
from warpsample.city.rasters.narrow_objects import bound_depths
from warpsample.city.rasters.scenery import Seen
from warpsample.estimate.intervals import half_width_of_normal
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

_MOST_RAYS, _MOST_OF_MANY, _MANY = 4, 5, 512  # rays per azimuth, at most; the second number for _MANY rays and more
_ARRAYS = {"value": np.float32, "standard_error": np.float32, "rays": np.int32, "status": np.uint8}
_OPTIONS = ("count", "max_distance", "seed", "skip", "workers", "progress")


def finds_horizons(quantity: Quantity, options: dict[str, Any]) -> bool:
    """Return whether a quantity can be computed by a search for the horizon in each azimuth, with the given options.

    The quantity must be a sky view, and all options must be those that the search knows.
    """
    given = {name for name, value in options.items() if isinstance(value, np.ndarray) or value != quantity.parameters[name]}
    return quantity.call in (sky_view_factor, visible_sky) and given <= set(_OPTIONS)


def sky_by_horizons(quantity: Quantity, mesh: Mesh, points: SurfacePoints, options: dict[str, Any]) -> Seen:
    """Compute the visible fraction of the sky at points of a raster's surface from the horizon in each azimuth.

    Args:
        quantity: `sky_view_factor` or `visible_sky`.
        mesh: Mesh of the field of heights.
        points: Points with normals above the horizon.
        options: Options of the quantity's call. Options that `finds_horizons` does not accept are ignored.

    Raises:
        TypeError, ValueError: An option that cannot be used; the message names the option.
        MemoryError: The computation does not fit into the free memory.
    """
    own = {name: options.get(name, quantity.parameters[name]) for name in _OPTIONS}
    at = PlacedPoints.of(mesh, points)
    cast = RayOptions.of(len(at), seed=own["seed"], ids=at.id)
    cast = cast.replace(skip=own["skip"], tracer="wide", workers=own["workers"], progress=own["progress"])
    return _search_horizons(Plan.of(at, own["count"], cast), reach_of(own["max_distance"]), quantity.call is sky_view_factor)


def _search_horizons(plan: Plan, reach: float, cosine: bool) -> Seen:
    """Compute the visible sky of all points by searching for horizons; return value, errors, ray counts and status."""
    points, options = len(plan.at), plan.options
    found = {name: np.zeros(points, kind) for name, kind in _ARRAYS.items()}
    if not points:
        return _collect_results(found)
    placement = plan.at.facing(options, reach)
    order = plan.at.order(placement, plan.count, options.workers)
    placement.order = 0 if order is None else order.ctypes.data
    azimuths, rays = azimuths_and_rays(plan.count)
    depths = bound_depths(plan.at, azimuths, cosine, reach)
    rows = HorizonRowsArgs(
        placement=placement,
        seed=seed_for("horizons", options.seed),
        azimuths=azimuths,
        per_azimuth=rays,
        cosine=cosine,
        skip=options.skip,
        depths=depths.ctypes.data,
        **{name: array.ctypes.data for name, array in ({"normals": plan.at.normal} | found).items()},
    )
    accelerator = options.tracer.accelerator(plan.at.scene, cpu(), options.workers)
    with bar(options.progress, "casting rays", points):
        work = RAY_WORK * points * plan.count
        run(horizon_kernel(), points, [rows, accelerator], cpu(), workers=options.workers, work=work)
    return _collect_results(found)


def _collect_results(found: dict[str, np.ndarray]) -> Seen:
    """Build the result from the kernel's arrays, with half widths of 95 % confidence intervals."""
    return Seen(half_width=half_width_of_normal(found["standard_error"]), **found)


def azimuths_and_rays(count: int) -> tuple[int, int]:
    """Divide `count` rays of a point among azimuths; return the number of azimuths and the rays per azimuth.

    The product may be slightly less than `count`.

    More than two azimuths are odd in number. With an even number, opposite walls and corners would have equal errors.
    """
    rays = min(_MOST_RAYS if count < _MANY else _MOST_OF_MANY, max(1, count.bit_length() - 3))
    azimuths = count // rays
    return (azimuths - 1 if azimuths > 2 and azimuths % 2 == 0 else azimuths), rays
