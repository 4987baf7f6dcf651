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
from warpsample.city.rasters.scenery import Seen
from warpsample.estimate.intervals import half_width_of_normal
from warpsample.estimate.plan import Plan, reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.quantities.visible_sky import visible_sky
from warpsample.estimate.visibility import sky_view_factor
from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.locks import imported
from warpsample.host.progress import bar
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.rays import RAY_WORK

_MOST_RAYS, _MOST_OF_MANY, _MANY = 4, 5, 512  # rays per azimuth, at most; the second number for _MANY rays and more
_ARRAYS = {"value": np.float32, "standard_error": np.float32, "rays": np.int32, "status": np.uint8}
_MOST_TOPS = 2048  # cells of the grid of highest vertices along a side
_SHORTEST = 1e-30  # length of a normal, so that 0 / 0 gives 0
_OPTIONS = ("count", "max_distance", "seed", "skip", "workers", "progress")


def finds_horizons(quantity: Quantity, options: dict[str, Any]) -> bool:
    """Return whether a quantity can be computed by a search for the horizon in each azimuth, with the given options.

    The quantity must be a sky view, and all options must be those that the search knows.
    """
    given = {name for name, value in options.items() if value != quantity.parameters[name]}
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
    depths = _bound_depths(plan.at, azimuths, cosine, reach)
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


def _bound_depths(at: PlacedPoints, azimuths: int, cosine: bool, reach: float) -> np.ndarray:
    """Bound how much of the sky of one azimuth an object hides that no azimuth has hit, (P,) float32.

    Objects are at least as wide as a cell. So an azimuth hits all objects that are closer than the distance at which a cell
    spans the angle between two azimuths. For rings beyond it, each twice as wide as the one before, the elevation of the
    highest object is at most that of the highest vertex within the ring's outer radius, at its inner radius. In a large
    scene the rings begin farther away, at 1/512 of its extent.
    """
    assert at.mesh is not None
    vertices, points = at.mesh.vertices, np.asarray(at.points.position, np.float64)
    low, size = vertices[:, :2].min(axis=0), np.ptp(vertices[:, :2], axis=0)
    nearest = _cell_width(at.mesh) * azimuths / (2.0 * np.pi)
    cell = max(nearest / 4.0, size.max() / _MOST_TOPS)
    where = [np.nan_to_num((each[:, :2] - low) / cell).clip(0, size / cell).astype(np.int64) for each in (vertices, points)]
    tops = np.full(np.int64(size / cell) + 1, -np.inf)
    np.maximum.at(tops, tuple(where[0].T), vertices[:, 2])
    find_highest = imported("scipy.ndimage").maximum_filter
    slope, radius, level = np.zeros(len(points)), 4.0 * cell, 0
    while radius < min(np.hypot(*size), reach):
        highest = find_highest(tops, 17, mode="constant", cval=-np.inf)  # within 8 cells of the grid: the outer radius
        slope = np.fmax(slope, (highest[tuple(where[1].T >> level)] - points[:, 2]) / radius)
        tops = np.pad(tops, [(0, length % 2) for length in tops.shape], constant_values=-np.inf)
        tops = tops.reshape(len(tops) // 2, 2, -1, 2).max(axis=(1, 3))
        radius, level = 2.0 * radius, level + 1
    if not cosine:
        return (slope / np.hypot(1.0, slope)).astype(np.float32)
    # What is as steep as a tilted receiver is hidden by its plane, or is terrain that its azimuths hit.
    up = (at.normal[:, 2] / np.maximum(np.linalg.norm(at.normal, axis=1), _SHORTEST)).clip(_SHORTEST, 1.0)
    tilt = np.sqrt(1.0 - up**2)
    slope = np.maximum(slope - 2.0 * tilt / up, 0.0)
    sine = slope / np.hypot(1.0, slope)
    return (up * sine**2 + tilt * sine).astype(np.float32)


def _cell_width(mesh: Mesh) -> float:
    """Return the width of the cells of a field of heights: the shortest side of its first triangle, seen from above."""
    corners = mesh.vertices[mesh.faces[0], :2]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1)
    return float(min(sides[sides > 0.0], default=np.inf))


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
