"""Sun hours of points: the call `sun_hours`, and the quantity of the command line."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.quantities.record import Numbers, Quantity
from warpsample.estimate.result import ExactResult, status_of
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.quantities.irradiation import WEATHER
from warpsample.radiation.sky.patches import sky_patches
from warpsample.radiation.sun.direct_sun import SunCall
from warpsample.radiation.weather.light import sun_directions
from warpsample.radiation.weather.weather import read_weather
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

_UNSEEN = np.float32(0.5)  # hours: half a ray, as for estimates whose rays disagree


@dataclass(frozen=True, eq=False, repr=False)
class SunHours(ExactResult):
    """Hours of sun at each of P points, with the same fields as an `Estimate`.

    These are `value` (P,), zeros (P,) as `standard_error` and `rays`, and `status` (P,). An hour counts if in its middle the
    sun's centre is above the horizon, in front of the point and not hidden by the mesh.

    Attributes:
        unseen_error: (P,) float32, least error of a point in a mean over a surface, because shadows may fall between points:
            half an hour, or 0 where no hour needs a ray.
    """

    unseen_error: NDArray[np.float32] | None = None


def sun_hours(
    mesh: Any,
    points: SurfacePoints,
    weather: Any,
    *,
    period: Sequence[str] | None = None,
    up: Any = (0.0, 0.0, 1.0),
    north: Any = (0.0, 1.0, 0.0),
    seed: int = 0,
    first_point: int = 0,
    workers: int | None = None,
) -> SunHours:
    """Count the hours of a period during which each point sees the sun; the sun is placed at mid-hour.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        weather: Path of an EPW file, for its place and hours, or "athens", an example.
        period: First and last day, both included, as for `irradiation`. Default: None, the year.
        up: (3,) vector of any length towards the zenith. Default: (0.0, 0.0, 1.0).
        north: (3,) vector of any length, not along `up`. Default: (0.0, 1.0, 0.0).
        seed: Random seed, an integer of 64 bits. Default: 0. Has no effect: nothing is random.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0. Has no effect: nothing is random.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        value (P,), the number of hours, and a status for each point.

    Raises:
        TypeError, ValueError, FileNotFoundError: as for `irradiation`.
        ModuleNotFoundError: pvlib is not installed.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> june = ws.sun_hours(mesh, ws.face_centers(mesh), "athens", period=("06-21", "06-21"))
        >>> print(june.value.shape, f"{june.value.max():.0f} hours")
        (2080,) 15 hours
    """
    mesh = as_mesh(mesh)
    total = len(PlacedPoints.of(mesh, points))  # checks the points even if the sun never rises
    options = {"weather": weather, "period": period, "up": up, "north": north, "seed": seed, "workers": workers}
    return _prepare(mesh, total, **options)(points, first_point)


def _prepare(
    mesh: Mesh, _total: int, *, weather: Any, period: Any, up: Any, north: Any, seed: int, workers: int | None
) -> Numbers:
    """Read the weather file, and return a function that counts the sun hours of surface points."""
    found = read_weather(weather, period)
    suns = sun_directions(found.chosen(found.sun_altitude > 0.0), sky_patches(up=up, north=north).frame)

    def numbers(points: SurfacePoints, first: int) -> SunHours:
        hours = none = np.zeros(len(points), np.float32)
        tally = np.zeros((len(points), 3), np.int32)
        if len(suns):
            at = PlacedPoints.of(mesh, points)
            options = RayOptions.of(len(at), ids=at.id, tracer="wide", seed=seed, first_point=first, workers=workers)
            hours = SunCall(at, suns, np.ones(len(suns)), options).answer(tally)
        unseen = np.where(tally[:, 1:].any(axis=1), _UNSEEN, np.float32(0.0))  # rays blocked and cast
        return SunHours(hours.astype(np.float32), none, none.astype(np.int32), status_of(points), unseen)

    return numbers


_ON_RASTERS = (
    "number of hours of the period at whose middle the sun is visible: its centre is above the horizon, in front of the "
    "receiver, and not hidden from the centre of the cell; the normal of the receiver is {normal}"
)

RECORD = Quantity(
    name="sun-hours",
    call=sun_hours,
    title="sun hours",
    value="number of hours of a year, or of a period, in which the sun is visible",
    result=SunHours,
    shared=(),
    unit="h",
    files=WEATHER,
    prepare=_prepare,
    in_stores=False,
    on_rasters={"surface": _ON_RASTERS, "horizontal": _ON_RASTERS},
)
